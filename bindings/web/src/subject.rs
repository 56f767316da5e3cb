//! The mesh that is examined, with its normals: computed once for each recipe.

use crate::laboratory::Result;
use crate::shapes::{self, Made};
use crate::view::View;
use crease::io::{Format, Limits, Loaded, ReadError, ReadOptions, Severity, read_bytes};
use crease::mesh::{Mesh, Topology, Weld};
use crease::normals::{NormalField, NormalRecipe, Weight, When, compute_on};
use crease::pipeline::{Task, revise};
use crease::surface::Primitive;
use glam::{DMat4, DVec3};
use serde_json::{Value, json};
use std::path::Path;

/// A file, and what is computed from it.
pub(crate) struct Subject {
    pub name: String,
    pub loaded: Loaded,
    /// The analytic surface of a built-in mesh.
    pub surface: Option<Primitive>,
    /// The command that makes a built-in mesh.
    pub command: Option<String>,
    /// The name and segments of a built-in mesh.
    built_in: Option<(String, u32)>,
    topologies: Vec<Topology>,
    /// The normals of each part by the recipe.
    pub fields: Vec<NormalField>,
    recipe: Option<NormalRecipe>,
    /// Normals that these are compared with, by what they were asked as.
    others: Option<((NormalRecipe, String), Vec<NormalField>)>,
    /// A ball around all of it.
    pub centre: DVec3,
    pub radius: f64,
}

/// Largest file: the memory of a page ends at 4 GB.
const LARGEST: u64 = 256 << 20;

/// An error without advice that names an option of the program.
fn complaint(name: &str, mut error: ReadError) -> String {
    if error.advice.contains("--") {
        error.advice.clear();
    }
    format!("{name}: {error}")
}

impl Subject {
    pub(crate) fn of_file(name: &str, bytes: Vec<u8>) -> Result<Self> {
        let limits = Limits { bytes: LARGEST, ..Limits::default() };
        if bytes.len() as u64 > LARGEST {
            return Err(format!("{name}: the file has more than {} MB; use the program", LARGEST >> 20));
        }
        let options = ReadOptions { limits, ..ReadOptions::default() };
        let format = crease::io::detect(&bytes, Some(Path::new(name)));
        let loaded = read_bytes(bytes, format, None, &options).map_err(|error| complaint(name, error))?;
        Self::new(name.to_owned(), loaded)
    }

    pub(crate) fn built_in(id: &str, segments: u32) -> Result<Self> {
        let Made { name, bytes, surface, command } = shapes::make(id, segments)?;
        let subject = Self::of_file(&name, bytes)?;
        Ok(Self { surface, command, built_in: Some((id.to_owned(), segments)), ..subject })
    }

    fn new(name: String, loaded: Loaded) -> Result<Self> {
        let topologies = loaded.parts.iter().map(|part| Topology::build(&part.mesh, Weld::Exact)).collect();
        let mut subject = Self {
            name,
            loaded,
            surface: None,
            command: None,
            built_in: None,
            topologies,
            fields: Vec::new(),
            recipe: None,
            others: None,
            centre: DVec3::ZERO,
            radius: 1.0,
        };
        let points = || {
            subject.places().into_iter().flat_map(|(part, place)| {
                let mesh = &subject.loaded.parts[part].mesh;
                let corners = mesh.faces().corners().iter();
                corners.map(move |&vertex| place.transform_point3(mesh.positions().at(vertex)))
            })
        };
        let bounds = points().fold(None, |bounds: Option<(DVec3, DVec3)>, point| {
            let (low, high) = bounds.unwrap_or((point, point));
            Some((low.min(point), high.max(point)))
        });
        let Some((low, high)) = bounds else {
            return Err(format!("{}: there are no faces to draw", subject.name));
        };
        let centre = low * 0.5 + high * 0.5;
        let radius = points().map(|point| point.distance(centre)).fold(0.0, f64::max);
        if !radius.is_finite() {
            return Err(format!("{}: the mesh is too large to draw; scale it", subject.name));
        }
        subject.centre = centre;
        subject.radius = if radius > 0.0 { radius } else { 1.0 };
        Ok(subject)
    }

    /// Each part where it is drawn, with its transform.
    pub(crate) fn places(&self) -> Vec<(usize, DMat4)> {
        if self.loaded.nodes.is_empty() {
            return (0..self.loaded.parts.len()).map(|part| (part, DMat4::IDENTITY)).collect();
        }
        self.loaded.nodes.iter().map(|node| (node.part, node.world_from_part)).collect()
    }

    pub(crate) fn is_of(&self, view: &View) -> bool {
        match &self.built_in {
            Some((id, segments)) => *id == view.subject && *segments == view.segments,
            None => view.subject == "file",
        }
    }

    /// Makes sure that the normals are those of a view.
    pub(crate) fn compute(&mut self, view: &View) {
        let recipe = view.recipe();
        if self.recipe != Some(recipe) {
            self.fields = self.fields_of(&recipe);
            self.recipe = Some(recipe);
        }
    }

    fn fields_of(&self, recipe: &NormalRecipe) -> Vec<NormalField> {
        let parts = self.loaded.parts.iter().zip(&self.topologies);
        parts.map(|(part, topology)| compute_on(&part.mesh, topology, recipe)).collect()
    }

    /// The normals that those of a view are compared with: the stored ones, or those of another weight. `None` if the file
    /// stores none, or for a name that is no weight.
    pub(crate) fn others(&mut self, view: &View) -> Option<&[NormalField]> {
        let recipe = view.recipe();
        let key = (recipe, view.against.clone());
        if self.others.as_ref().is_none_or(|(of, _)| *of != key) {
            let others = match Weight::ALL.into_iter().find(|weight| weight.name() == view.against) {
                Some(weight) => self.fields_of(&NormalRecipe { weight, ..recipe }),
                None if !matches!(&*view.against, "exact" | "stored") || !self.has_stored() => return None,
                None => {
                    let parts = self.loaded.parts.iter().zip(&self.fields);
                    parts.map(|(part, field)| field.clone().selected(&part.mesh, When::Broken)).collect()
                }
            };
            self.others = Some((key, others));
        }
        self.others.as_ref().map(|(_, fields)| &**fields)
    }

    fn has_stored(&self) -> bool {
        self.loaded.parts.iter().any(|part| part.mesh.columns().normals.is_some())
    }

    /// Whether the stored normals are those of an analytic surface.
    pub(crate) fn has_truth(&self) -> bool {
        self.command.is_some()
    }

    pub(crate) fn facts(&self) -> Value {
        let parts = &self.loaded.parts;
        let sum = |of: fn(&crease::io::Part) -> usize| parts.iter().map(of).sum::<usize>();
        let notes = self.loaded.notes.iter().filter(|note| note.severity == Severity::Warning);
        json!({
            "name": self.name,
            "format": self.loaded.format.extension(),
            "parts": parts.len(),
            "vertices": sum(|part| part.mesh.vertex_count()),
            "faces": sum(|part| part.mesh.face_count()),
            "has_normals": self.has_stored(),
            "has_groups": parts.iter().any(|part| part.mesh.columns().smoothing.is_some()),
            "notes": notes.map(ToString::to_string).collect::<Vec<_>>(),
        })
    }

    /// The facts of the file, and the counts of its normals.
    pub(crate) fn counts(&self, view: &View) -> Value {
        let sum = |of: fn(&NormalField) -> usize| self.fields.iter().map(of).sum::<usize>();
        let (mut used, mut splits) =
            (sum(|field| field.summary.referenced_vertices), sum(|field| field.summary.splits));
        // Separate triangles are drawn as they are, but saved with shared vertices.
        let is_soup = |mesh: &Mesh| mesh.vertex_count() == mesh.faces().corner_count();
        if self.loaded.parts.iter().any(|part| is_soup(&part.mesh)) {
            let task = Task { recipe: view.recipe(), ..Task::default() };
            let parts = revise(&self.loaded, &task, Some(Format::Glb), &|_| {}).parts;
            used = parts.iter().map(|part| part.referenced_vertices).sum();
            splits = parts.iter().map(|part| part.splits).sum();
        }
        json!({
            "facts": self.facts(),
            "exact": self.surface.is_some(),
            "truth": self.has_truth(),
            "weight": view.weight.name(),
            "referenced": used,
            "after": used + splits,
            "splits": splits,
            "smooth": sum(|field| field.summary.edges.smooth),
            "hard": sum(|field| field.summary.edges.crease),
            "marked": sum(|field| field.summary.edges.marked),
            "boundary": sum(|field| field.summary.edges.boundary),
            "faults": sum(|field| field.faults.corners.len()),
        })
    }

    pub(crate) fn format(&self, name: &str) -> Result<Format> {
        let known = Format::ALL.into_iter().find(|format| format.extension() == name);
        known.ok_or_else(|| format!("no format has the name {name:?}"))
    }
}
