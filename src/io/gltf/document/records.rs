//! The parts of a glTF document that geometry needs, as typed records beside their places in the JSON.

use crate::io::gltf::json::fields::{At, Fields, dangling};
use crate::io::gltf::json::tree::{Json, Value};
use crate::io::{Note, Place, Problem, ReadError};

/// A `bufferView`.
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

/// An `accessor`.
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
    pub index_view: usize,
    pub index_offset: u64,
    pub index_component: Component,
    pub value_view: usize,
    pub value_offset: u64,
}

/// The type of a number in a buffer, by its glTF code.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Component {
    I8 = 5120,
    U8 = 5121,
    I16 = 5122,
    U16 = 5123,
    U32 = 5125,
    F32 = 5126,
}

impl Component {
    pub fn from_code(code: u64) -> Option<Component> {
        use Component::{F32, I8, I16, U8, U16, U32};
        [I8, U8, I16, U16, U32, F32].into_iter().find(|component| *component as u64 == code)
    }

    pub fn size(self) -> usize {
        match self {
            Component::I8 | Component::U8 => 1,
            Component::I16 | Component::U16 => 2,
            Component::U32 | Component::F32 => 4,
        }
    }
}

/// How one element of an accessor is stored.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
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

/// A drawn piece of a mesh.
#[derive(Clone, Debug)]
pub struct Primitive {
    pub object: Value,
    pub at: At,
    pub attributes: Attributes,
    pub targets: Vec<Attributes>,
    pub indices: Option<usize>,
    pub mode: u64,
    pub material: Option<usize>,
}

/// Accessors by semantic, and the JSON object that lists them.
#[derive(Clone, Debug)]
pub struct Attributes {
    pub object: Value,
    pub list: Vec<(String, usize)>,
}

impl Attributes {
    pub fn get(&self, semantic: &str) -> Option<usize> {
        self.list.iter().find(|(name, _)| name == semantic).map(|&(_, accessor)| accessor)
    }
}

/// A mesh and the JSON object that it is.
#[derive(Clone, Debug)]
pub struct MeshRecord {
    pub object: Value,
    pub name: String,
    pub primitives: Vec<Primitive>,
}

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
        let root = Fields::new(&json, json.root(), At::default())?;
        check_version(&root, notes)?;
        let objects = |name: &'static str| list(&root, name);
        let (buffers, materials) = (objects("buffers")?, objects("materials")?);
        let views = records(&root, "bufferViews", |fields| view(fields, buffers.len()))?;
        let accessors = records(&root, "accessors", |fields| accessor(fields, views.len()))?;
        let meshes = records(&root, "meshes", |fields| mesh(fields, accessors.len(), materials.len()))?;
        Ok(Records { buffers, views, accessors, meshes, materials, json })
    }
}

/// All objects of a top-level list, by number.
pub fn list(root: &Fields<'_>, name: &'static str) -> Result<Vec<Value>, ReadError> {
    let array = root.array(name)?;
    let values: Vec<Value> = array.into_iter().flat_map(|array| root.json.elements(array)).collect();
    for (number, &value) in values.iter().enumerate() {
        Fields::new(root.json, value, At::new(name, number))?;
    }
    Ok(values)
}

fn records<T>(
    root: &Fields<'_>,
    name: &'static str,
    record: impl Fn(Fields<'_>) -> Result<T, ReadError>,
) -> Result<Vec<T>, ReadError> {
    let values = list(root, name)?.into_iter().enumerate();
    values
        .map(|(number, object)| record(Fields { json: root.json, object, at: At::new(name, number) }))
        .collect()
}

fn check_version(root: &Fields<'_>, notes: &mut Vec<Note>) -> Result<(), ReadError> {
    let asset = root.object("asset")?.ok_or_else(|| root.missing("asset"))?;
    let asset = Fields { object: asset, ..*root };
    let place = |name: &str| Place::Json(format!("/asset/{name}"));
    let version = asset.string("version")?.ok_or_else(|| asset.missing("version"))?;
    let parse = |text: &str| {
        let (major, minor) = text.split_once('.')?;
        Some((major.parse::<u32>().ok()?, minor.parse::<u32>().ok()?))
    };
    let unsupported = |name, text: &str| {
        let found = format!("glTF version {text:?}");
        let advice = "only glTF 2.0 is read; convert the file, for example with glTF-Transform";
        Err(ReadError::new(Problem::Unsupported, place(name), found, advice))
    };
    match parse(&version) {
        Some((2, 0)) => {}
        Some((2, _)) => {
            let text = format!("version {version} is read as 2.0; what is newer in it is not understood");
            notes.push(Note::warning(place("version"), text));
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
    let buffer = usize::try_from(fields.required("buffer")?).unwrap_or(usize::MAX);
    if buffer >= buffers {
        return Err(dangling(fields.at.member("buffer"), "buffer", buffer, buffers));
    }
    let meshopt = ["EXT_meshopt_compression", "KHR_meshopt_compression"];
    Ok(View {
        object: fields.object,
        buffer,
        offset: fields.integer("byteOffset")?.unwrap_or(0),
        length: fields.required("byteLength")?,
        stride: fields.integer("byteStride")?,
        meshopt: meshopt.into_iter().find(|name| fields.extension(name).is_some()),
        extended: fields.object("extensions")?.is_some(),
    })
}

fn accessor(fields: Fields<'_>, views: usize) -> Result<Accessor, ReadError> {
    let code = fields.required("componentType")?;
    let shape = fields.string("type")?.ok_or_else(|| fields.missing("type"))?;
    let shape = match shape.as_ref() {
        "SCALAR" => Some((1, 1)),
        "VEC2" => Some((2, 1)),
        "VEC3" => Some((3, 1)),
        "VEC4" => Some((4, 1)),
        "MAT2" => Some((2, 2)),
        "MAT3" => Some((3, 3)),
        "MAT4" => Some((4, 4)),
        _ => None,
    };
    let normalized = fields.boolean("normalized")?.unwrap_or(false);
    let format = Component::from_code(code).zip(shape).map(|(component, (width, columns))| Format {
        component,
        normalized,
        width,
        columns,
    });
    let view = fields.index("bufferView")?;
    if let Some(view) = view.filter(|&view| view >= views) {
        return Err(dangling(fields.at.member("bufferView"), "buffer view", view, views));
    }
    Ok(Accessor {
        object: fields.object,
        view,
        offset: fields.integer("byteOffset")?.unwrap_or(0),
        count: fields.required("count")?,
        format,
        sparse: sparse(&fields, views)?,
    })
}

fn sparse(accessor: &Fields<'_>, views: usize) -> Result<Option<Sparse>, ReadError> {
    let Some(object) = accessor.object("sparse")? else { return Ok(None) };
    let sparse = Fields { object, ..*accessor };
    let part = |name: &str| {
        let object = sparse.object(name)?.ok_or_else(|| sparse.missing(name))?;
        let part = Fields { object, ..sparse };
        let view = usize::try_from(part.required("bufferView")?).unwrap_or(usize::MAX);
        if view >= views {
            return Err(dangling(part.at.member("sparse"), "buffer view", view, views));
        }
        Ok((part, view, part.integer("byteOffset")?.unwrap_or(0)))
    };
    let (indices, index_view, index_offset) = part("indices")?;
    let (_, value_view, value_offset) = part("values")?;
    let code = indices.required("componentType")?;
    let unsigned = [Component::U8, Component::U16, Component::U32];
    let index_component = Component::from_code(code).filter(|component| unsigned.contains(component));
    let index_component = index_component.ok_or_else(|| {
        let found = format!("component type {code} for sparse indices");
        ReadError::new(
            Problem::Range,
            accessor.at.member("sparse"),
            found,
            "5121, 5123 and 5125 can be indices",
        )
    })?;
    let count = sparse.required("count")?;
    Ok(Some(Sparse { count, index_view, index_offset, index_component, value_view, value_offset }))
}

fn mesh(fields: Fields<'_>, accessors: usize, materials: usize) -> Result<MeshRecord, ReadError> {
    let name = fields.string("name")?.unwrap_or_default().into_owned();
    let array = fields.array("primitives")?;
    let objects = array.into_iter().flat_map(|array| fields.json.elements(array));
    let primitive = |(number, object)| {
        let at = fields.at.then("primitives", number);
        primitive(Fields::new(fields.json, object, at)?, accessors, materials)
    };
    let primitives = objects.enumerate().map(primitive).collect::<Result<_, _>>()?;
    Ok(MeshRecord { object: fields.object, name, primitives })
}

fn primitive(fields: Fields<'_>, accessors: usize, materials: usize) -> Result<Primitive, ReadError> {
    let object = fields.object("attributes")?.ok_or_else(|| fields.missing("attributes"))?;
    let attributes = attributes(&fields, object, "attributes", accessors)?;
    let targets = fields.array("targets")?;
    let targets = targets.into_iter().flat_map(|targets| fields.json.elements(targets));
    let targets = targets
        .map(|object| {
            Fields::new(fields.json, object, fields.at)?;
            self::attributes(&fields, object, "targets", accessors)
        })
        .collect::<Result<_, _>>()?;
    let indices = fields.index("indices")?;
    if let Some(indices) = indices.filter(|&indices| indices >= accessors) {
        return Err(dangling(fields.at.member("indices"), "accessor", indices, accessors));
    }
    let material = fields.index("material")?;
    if let Some(material) = material.filter(|&material| material >= materials) {
        return Err(dangling(fields.at.member("material"), "material", material, materials));
    }
    let mode = fields.integer("mode")?.unwrap_or(4);
    Ok(Primitive { object: fields.object, at: fields.at, attributes, targets, indices, mode, material })
}

fn attributes(
    owner: &Fields<'_>,
    object: Value,
    member: &str,
    accessors: usize,
) -> Result<Attributes, ReadError> {
    let mut list: Vec<(String, usize)> = Vec::new();
    for (key, value) in owner.json.members(object) {
        let index = owner.json.integer(value).and_then(|index| usize::try_from(index).ok());
        let index = index.unwrap_or(usize::MAX);
        if index >= accessors {
            return Err(dangling(owner.at.member(member), "accessor", index, accessors));
        }
        list.push((owner.json.string(key).unwrap_or_default().into_owned(), index));
    }
    // Sorted, equal sets of attributes are equal lists. Of duplicates the last counts, as everywhere.
    list.sort_by(|a, b| a.0.cmp(&b.0));
    list.dedup_by(|later, earlier| {
        let same = later.0 == earlier.0;
        if same {
            earlier.1 = later.1;
        }
        same
    });
    Ok(Attributes { object, list })
}
