//! All model parts of a package, and where its build places their meshes.

use super::model::{Model, Object, Use};
use super::package::{Package, error};
use crate::io::mesh_checks::{build_part, check_size, non_finite_note};
use crate::io::text::{shown, storage_of_text};
use crate::io::{Document, FileNode, Format, Loaded, Note, Part, Place, Problem, ReadError, ReadOptions};
use crate::mesh::{Columns, Faces, MeshBuilder, Positions, PositionsRef};
use glam::{DMat4, DVec3};
use std::collections::BTreeMap;
use std::path::Path;

/// The most objects that a build may place, components counted.
const MOST_PLACES: usize = 1 << 16;

/// The deepest nesting of components.
const DEEPEST: usize = 64;

const ADVICE: &str = "export it again";

/// A model part by number, and an object of it by its id.
type Key = (usize, u32);

/// Reads a 3MF. Each object with a mesh becomes a part, each time that the build places it a node. Materials and colours are omitted
/// with a note.
///
/// # Errors
/// For damaged archives, missing model parts, XML and numbers with errors, indices that are out of range, components that contain
/// themselves, required extensions that may hold geometry, and packages that unpack to more than the limits allow.
pub fn read(bytes: Vec<u8>, _base: Option<&Path>, options: &ReadOptions) -> Result<Loaded, ReadError> {
    check_size(bytes.len() as u64, &options.limits)?;
    let mut package = Package::new(&bytes, &options.limits)?;
    let mut paths = vec![package.root()?];
    let mut numbers = BTreeMap::from([(paths[0].clone(), 0)]);
    let (mut models, mut uses) = (Vec::new(), 0);
    while let Some(path) = paths.get(models.len()) {
        let model = Model::read(&mut package, path, &mut uses)?;
        let components = model.objects.iter().flat_map(|object| &object.components);
        for part in components.chain(&model.items).filter_map(|used| used.part.as_ref()) {
            if !numbers.contains_key(part) {
                numbers.insert(part.clone(), paths.len());
                paths.push(part.clone());
            }
        }
        models.push(model);
    }
    drop(package);
    drop(bytes);
    loaded(models, &paths, &numbers, options)
}

fn loaded(
    mut models: Vec<Model>,
    paths: &[String],
    numbers: &BTreeMap<String, usize>,
    options: &ReadOptions,
) -> Result<Loaded, ReadError> {
    let mut notes = notes(&models);
    let mut parts = Vec::new();
    let all = models.iter().flat_map(|model| &model.objects).map(|object| &object.positions[..]);
    let all: Vec<&[DVec3]> = all.filter(|positions| !positions.is_empty()).collect();
    let storage = storage_of_text(&all);
    notes.extend(
        all.iter().filter_map(|positions| non_finite_note(PositionsRef::F64(positions), options.non_finite)),
    );
    let mut part_of = BTreeMap::new();
    for (number, model) in models.iter_mut().enumerate() {
        for object in &mut model.objects {
            if object.positions.is_empty() {
                continue;
            }
            let builder = MeshBuilder {
                positions: Positions::rounded(std::mem::take(&mut object.positions), storage),
                faces: Faces::triangles(std::mem::take(&mut object.corners)),
                columns: Columns::default(),
            };
            let part = build_part(object.name.clone(), builder, options, |_| Place::File)?;
            part_of.insert((number, object.id), parts.len());
            parts.push(part);
        }
    }
    let (objects, nodes) = (BTreeMap::new(), Vec::new());
    let mut build = Build { paths, numbers, objects, part_of, parts: &parts, nodes, visits: 0 };
    for (number, model) in models.iter().enumerate() {
        build.objects.extend(model.objects.iter().map(|object| ((number, object.id), object)));
    }
    for item in &models[0].items {
        build.place(0, item, DMat4::IDENTITY, &mut Vec::new())?;
    }
    let nodes = build.nodes;
    Ok(Loaded { format: Format::ThreeMf, parts, nodes, notes, document: Document::None })
}

/// The unit, and what is omitted.
fn notes(models: &[Model]) -> Vec<Note> {
    let unit = match &*models[0].unit {
        "micron" => "micrometres (--scale 1e-6)",
        "centimeter" => "centimetres (--scale cm)",
        "inch" => "inches (--scale in)",
        "foot" => "feet (--scale 0.3048)",
        "meter" => "metres",
        "millimeter" => "millimetres (--scale mm)",
        _ => "an unknown unit",
    };
    let mut notes = vec![Note::remark(format!("positions are in {unit}, with z up (--up z)"))];
    if models.iter().any(|model| model.has_properties) {
        notes.push(Note::warning(Place::File, "materials and colours are omitted"));
    }
    let skipped = models.iter().flat_map(|model| &model.skipped).map(|name| format!("`{name}`"));
    let skipped: Vec<String> = skipped.take(10).collect();
    if !skipped.is_empty() {
        notes.push(Note::warning(Place::File, format!("omitted from meshes: {}", skipped.join(", "))));
    }
    notes
}

/// The objects that the items of the build place.
struct Build<'a> {
    paths: &'a [String],
    /// The number of each of these model parts.
    numbers: &'a BTreeMap<String, usize>,
    objects: BTreeMap<Key, &'a Object>,
    part_of: BTreeMap<Key, usize>,
    parts: &'a [Part],
    nodes: Vec<FileNode>,
    visits: usize,
}

impl Build<'_> {
    /// Places an object and its components. `number` is the model part of the reference, `open` the objects around it.
    fn place(
        &mut self,
        number: usize,
        used: &Use,
        world_from_parent: DMat4,
        open: &mut Vec<Key>,
    ) -> Result<(), ReadError> {
        let named = used.part.as_ref().and_then(|part| self.numbers.get(part));
        let key = (named.copied().unwrap_or(number), used.object);
        let fail = |problem, found| Err(error(problem, found, ADVICE));
        let Some(&object) = self.objects.get(&key) else {
            let path = shown(self.paths[key.0].as_bytes());
            return fail(Problem::Range, format!("object {} is used, but `{path}` has none", key.1));
        };
        if open.contains(&key) {
            return fail(Problem::Range, format!("object {} is a component of itself", key.1));
        }
        self.visits += 1;
        if self.visits > MOST_PLACES || open.len() >= DEEPEST {
            let found = format!(
                "the build places more than {MOST_PLACES} objects, or components are nested more than {DEEPEST} deep"
            );
            return fail(Problem::Limit, found);
        }
        let world_from_part = world_from_parent * used.matrix;
        if let Some(&part) = self.part_of.get(&key) {
            let node = self.nodes.len();
            let name = match &*self.parts[part].name {
                "" => format!("object {}", key.1),
                name => name.to_owned(),
            };
            self.nodes.push(FileNode { number: node, name, part, world_from_part });
        }
        open.push(key);
        for component in &object.components {
            self.place(key.0, component, world_from_part, open)?;
        }
        open.pop();
        Ok(())
    }
}
