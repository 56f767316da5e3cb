//! The typed records of a glTF document that geometry needs, with their places in the JSON.

use super::fields::{Fields, checked_index};
use super::json::{Json, Value};
use crate::io::{Note, Place, Problem, ReadError};
use std::collections::BTreeMap;
use std::ops::Range;

pub use gltf::json::accessor::ComponentType as Component;

pub const MESHOPT: [&str; 2] = ["EXT_meshopt_compression", "KHR_meshopt_compression"];

#[derive(Clone, Copy, Debug)]
pub struct View {
    pub object: Value,
    pub buffer: usize,
    pub offset: u64,
    pub length: u64,
    pub stride: Option<u64>,
    /// The name of the meshopt extension under which a compressed copy of the view is stored.
    pub meshopt: Option<&'static str>,
    pub extended: bool,
}

#[derive(Clone, Copy, Debug)]
pub struct Accessor {
    pub object: Value,
    pub view: Option<usize>,
    pub offset: u64,
    pub count: u64,
    /// How elements are stored; `None` for types that only an extension can mean.
    pub format: Option<Format>,
    pub sparse: Option<Sparse>,
}

/// Where the exceptions of a sparse accessor are.
#[derive(Clone, Copy, Debug)]
pub struct Sparse {
    pub count: u64,
    /// View and offset of the indices.
    pub indices: (usize, u64),
    pub component: Component,
    /// View and offset of the values.
    pub values: (usize, u64),
}

fn component(code: u64) -> Option<Component> {
    use Component::{F32, I8, I16, U8, U16, U32};
    [I8, U8, I16, U16, U32, F32].into_iter().find(|component| u64::from(component.as_gl_enum()) == code)
}

/// The types of elements: name, components of a column, columns.
pub const SHAPES: [(&str, usize, usize); 7] = [
    ("SCALAR", 1, 1),
    ("VEC2", 2, 1),
    ("VEC3", 3, 1),
    ("VEC4", 4, 1),
    ("MAT2", 2, 2),
    ("MAT3", 3, 3),
    ("MAT4", 4, 4),
];

/// How one element of an accessor is stored.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Format {
    pub component: Component,
    pub normalized: bool,
    /// Components of a vector, or of a column of a matrix.
    pub width: usize,
    /// Columns of a matrix; 1 for scalars and vectors.
    pub columns: usize,
}

impl Format {
    pub fn vector(component: Component, normalized: bool, width: usize) -> Format {
        Format { component, normalized, width, columns: 1 }
    }

    /// Bytes of an element. Each column of a matrix begins at a multiple of four.
    pub fn size(self) -> usize {
        let column = self.width * self.component.size();
        if self.columns == 1 { column } else { column.next_multiple_of(4) * self.columns }
    }
}

#[derive(Clone, Debug)]
pub struct Primitive {
    pub object: Value,
    pub number: (usize, usize),
    pub vertices: VertexAccessors,
    /// The JSON objects that list the vertex accessors, one a set.
    pub sites: Vec<Value>,
    pub indices: Option<usize>,
    pub mode: u64,
    pub material: Option<usize>,
}

impl Primitive {
    pub fn place(&self) -> Place {
        let (mesh, number) = self.number;
        Place::Json(format!("/meshes/{mesh}/primitives/{number}"))
    }
}

/// The vertex accessors of a primitive, which shares its vertices with those that have equal ones. Set 0 are the attributes,
/// set n + 1 those of morph target n: pairs of semantic and accessor, sorted by semantic. A list of one pair takes a tenth of the
/// memory of a map, and a hostile file may have many.
#[derive(Clone, Debug, PartialEq, Eq, Hash)]
pub struct VertexAccessors {
    pub sets: Vec<Vec<(String, usize)>>,
}

impl VertexAccessors {
    pub fn get(&self, semantic: &str) -> Option<usize> {
        self.of_set(0, semantic)
    }

    pub fn of_set(&self, set: usize, semantic: &str) -> Option<usize> {
        self.sets.get(set)?.iter().find(|(name, _)| name == semantic).map(|&(_, accessor)| accessor)
    }

    /// The accessor of positions, which all primitives have whose vertices are read.
    pub fn position(&self) -> usize {
        self.get("POSITION").unwrap_or_default()
    }

    pub fn target_sets(&self) -> Range<usize> {
        1..self.sets.len()
    }

    /// Whether other attributes need normals: tangents, and normals of morph targets.
    pub fn need_normals(&self) -> bool {
        let mut all =
            self.sets.iter().enumerate().flat_map(|(set, list)| list.iter().map(move |it| (set, &*it.0)));
        all.any(|(set, semantic)| semantic == "TANGENT" || semantic == "NORMAL" && set > 0)
    }
}

#[derive(Clone, Debug)]
pub struct MeshRecord {
    pub object: Value,
    pub name: String,
    pub primitives: Vec<Primitive>,
}

/// A member of an object that refers to an accessor.
pub type Reference = (Value, String, usize);

/// A document without its buffers' bytes.
#[derive(Clone, Debug)]
pub struct Records {
    pub json: Json,
    pub buffers: Vec<Value>,
    pub views: Vec<View>,
    pub accessors: Vec<Accessor>,
    pub meshes: Vec<MeshRecord>,
    pub materials: Vec<Value>,
}

impl Records {
    /// Reads the records and checks that every number between them leads somewhere.
    pub fn new(json: Json, notes: &mut Vec<Note>) -> Result<Records, ReadError> {
        let root = Fields::new(&json, json.root())?;
        check_version(&root, notes)?;
        let (buffers, materials) = (root.list("buffers")?, root.list("materials")?);
        let views = records(&root, "bufferViews", |_, fields| view(fields, buffers.len()))?;
        let accessors = records(&root, "accessors", |_, fields| accessor(fields, views.len()))?;
        let counts = (accessors.len(), materials.len());
        let meshes = records(&root, "meshes", |number, fields| mesh(number, fields, counts))?;
        Ok(Records { buffers, views, accessors, meshes, materials, json })
    }

    pub fn fields(&self, object: Value) -> Fields<'_> {
        Fields { json: &self.json, object }
    }

    pub fn primitives(&self) -> impl Iterator<Item = &Primitive> {
        self.meshes.iter().flat_map(|mesh| &mesh.primitives)
    }

    /// The views that hold indices and values of sparse accessors.
    pub fn sparse_views(&self) -> impl Iterator<Item = usize> {
        let sparse = self.accessors.iter().filter_map(|accessor| accessor.sparse);
        sparse.flat_map(|sparse| [sparse.indices.0, sparse.values.0])
    }

    /// Images, and the views that they are in.
    pub fn images(&self) -> impl Iterator<Item = (Value, usize)> {
        let images = self.json.items(self.json.root(), "images");
        let view = |image| usize::try_from(self.json.integer_member(image, "bufferView")?).ok();
        let images = images.filter_map(move |image| Some((image, view(image)?)));
        images.filter(|(_, view)| *view < self.views.len())
    }

    /// The members that refer to accessors, each an object and a name: of primitives, animations and skins. Extensions may have
    /// more.
    pub fn references(&self) -> Vec<Reference> {
        let json = &self.json;
        let mut references = Vec::new();
        for primitive in self.primitives() {
            for (&site, set) in primitive.sites.iter().zip(&primitive.vertices.sets) {
                references.extend(set.iter().map(|(semantic, accessor)| (site, semantic.clone(), *accessor)));
            }
            let indices =
                primitive.indices.map(|accessor| (primitive.object, "indices".to_owned(), accessor));
            references.extend(indices);
        }
        let mut add = |object: Value, name: &str| {
            let number = json.integer_member(object, name).and_then(|number| usize::try_from(number).ok());
            let number = number.filter(|&number| number < self.accessors.len());
            references.extend(number.map(|number| (object, name.to_owned(), number)));
        };
        for sampler in json.items(json.root(), "animations").flat_map(|it| json.items(it, "samplers")) {
            add(sampler, "input");
            add(sampler, "output");
        }
        json.items(json.root(), "skins").for_each(|skin| add(skin, "inverseBindMatrices"));
        references
    }
}

fn records<T>(
    root: &Fields<'_>,
    name: &str,
    record: impl Fn(usize, Fields<'_>) -> Result<T, ReadError>,
) -> Result<Vec<T>, ReadError> {
    let values = root.list(name)?.into_iter().enumerate();
    values.map(|(number, object)| record(number, Fields { object, ..*root })).collect()
}

fn check_version(root: &Fields<'_>, notes: &mut Vec<Note>) -> Result<(), ReadError> {
    let asset = root.required_child("asset")?;
    let version = asset.required_string("version")?;
    let parse = |text: &str| {
        let (major, minor) = text.split_once('.')?;
        Some((major.parse::<u32>().ok()?, minor.parse::<u32>().ok()?))
    };
    let unsupported = |name, text: &str| {
        let found = format!("unsupported glTF version {text:?}");
        let advice = "convert the file to glTF 2.0, for example with glTF-Transform";
        Err(ReadError::new(Problem::Unsupported, asset.member(name), found, advice))
    };
    match parse(&version) {
        Some((2, 0)) => {}
        Some((2, _)) => {
            let text = format!("glTF version {version} is read as 2.0; newer features are ignored");
            notes.push(Note::warning(asset.member("version"), text));
        }
        _ => return unsupported("version", &version),
    }
    match asset.string("minVersion")? {
        Some(needed) if parse(&needed).is_none_or(|needed| needed > (2, 0)) => {
            unsupported("minVersion", &needed)
        }
        _ => Ok(()),
    }
}

fn view(fields: Fields<'_>, buffers: usize) -> Result<View, ReadError> {
    Ok(View {
        object: fields.object,
        buffer: fields.required_reference("buffer", "buffer", buffers)?,
        offset: fields.integer("byteOffset")?.unwrap_or(0),
        length: fields.required("byteLength")?,
        stride: fields.integer("byteStride")?,
        meshopt: MESHOPT.into_iter().find(|name| fields.extension(name).is_some()),
        extended: fields.child("extensions")?.is_some(),
    })
}

fn accessor(fields: Fields<'_>, views: usize) -> Result<Accessor, ReadError> {
    let component = component(fields.required("componentType")?);
    let name = fields.required_string("type")?;
    let shape = SHAPES.into_iter().find(|shape| shape.0 == name);
    let normalized = fields.boolean("normalized")?.unwrap_or(false);
    let format = |(component, (_, width, columns))| Format { component, normalized, width, columns };
    Ok(Accessor {
        object: fields.object,
        view: fields.reference("bufferView", "buffer view", views)?,
        offset: fields.integer("byteOffset")?.unwrap_or(0),
        count: fields.required("count")?,
        format: component.zip(shape).map(format),
        sparse: sparse(&fields, views)?,
    })
}

fn sparse(accessor: &Fields<'_>, views: usize) -> Result<Option<Sparse>, ReadError> {
    let Some(sparse) = accessor.child("sparse")? else { return Ok(None) };
    let part = |name| {
        let part = sparse.required_child(name)?;
        let view = part.required_reference("bufferView", "buffer view", views)?;
        Ok((part, (view, part.integer("byteOffset")?.unwrap_or(0))))
    };
    let ((fields, indices), (_, values)) = (part("indices")?, part("values")?);
    let code = fields.required("componentType")?;
    let unsigned = [Component::U8, Component::U16, Component::U32];
    let component = component(code).filter(|component| unsigned.contains(component));
    let component = component.ok_or_else(|| {
        let found = format!("component type {code} cannot be sparse indices");
        ReadError::new(Problem::Range, sparse.place(), found, "use 5121, 5123 or 5125")
    })?;
    let count = sparse.required("count")?;
    Ok(Some(Sparse { count, indices, component, values }))
}

/// A mesh; `counts` are those of the accessors and materials that primitives refer to.
fn mesh(mesh: usize, fields: Fields<'_>, counts: (usize, usize)) -> Result<MeshRecord, ReadError> {
    let primitive = |(number, object)| primitive((mesh, number), Fields::new(fields.json, object)?, counts);
    let primitives = fields.items("primitives")?.enumerate().map(primitive).collect::<Result<_, _>>()?;
    Ok(MeshRecord { object: fields.object, name: fields.name()?, primitives })
}

fn primitive(
    number: (usize, usize),
    fields: Fields<'_>,
    (accessors, materials): (usize, usize),
) -> Result<Primitive, ReadError> {
    let mut sites = vec![fields.required_child("attributes")?.object];
    sites.extend(fields.list("targets")?);
    let sets = sites.iter().map(|&site| vertex_set(Fields { object: site, ..fields }, accessors));
    Ok(Primitive {
        object: fields.object,
        number,
        vertices: VertexAccessors { sets: sets.collect::<Result<_, _>>()? },
        sites,
        indices: fields.reference("indices", "accessor", accessors)?,
        mode: fields.integer("mode")?.unwrap_or(4),
        material: fields.reference("material", "material", materials)?,
    })
}

/// The attributes of a primitive or of a morph target. Of duplicate members the last one counts.
fn vertex_set(fields: Fields<'_>, accessors: usize) -> Result<Vec<(String, usize)>, ReadError> {
    let json = fields.json;
    let member = |(key, value)| {
        let index = json.integer(value).unwrap_or(u64::MAX);
        let index = checked_index(index, accessors, "accessor", || fields.place())?;
        Ok((json.string(key).unwrap_or_default().into_owned(), index))
    };
    let set: BTreeMap<String, usize> = json.members(fields.object).map(member).collect::<Result<_, _>>()?;
    Ok(set.into_iter().collect())
}
