//! glTF 2.0, as `.gltf` and `.glb`: read, edited without loss, written new.
//!
//! Reading gives one [`Part`](super::Part) a glTF mesh, with all its primitives in it. Editing changes the
//! document's own text and bytes in the few places that must change: JSON is spliced by byte span, binary data
//! are patched in place or appended, and all else stays as it was, extensions and extras and the spelling of
//! numbers included.
//!
//! Standard: Khronos, *glTF 2.0 Specification*, 2021, with `KHR_mesh_quantization`.

// Known extensions.
mod extensions;
// JSON: a document with the position of every value.
mod json;
// Container: GLB chunks, buffers and their addresses.
mod container;
// Document: the typed records of a file.
mod document;
// Edit: changes to a document.
mod edit;
// Writer: new files from meshes.
mod writer;

pub(super) use document::appearance::appearance;
pub(crate) use document::nodes::NodeTree;
pub use edit::edit;
pub use writer::new_file::write;
pub(super) use writer::new_file::write_with_materials;

use super::tally::check_size;
use super::text::counted;
use super::{Document, Format, Loaded, Note, Place, Problem, ReadError, ReadOptions};
use container::buffers::Buffers;
use container::glb::Glb;
use document::accessor::Source;
use document::mesh::{Assembler, Layout};
use document::records::{Records, VertexAccessors};
use json::fields::Fields;
use json::tree::Json;
use std::borrow::Cow;
use std::cell::{Cell, RefCell};
use std::collections::BTreeMap;
use std::path::{Path, PathBuf};

/// A glTF document, kept for editing.
#[derive(Clone, Debug)]
pub struct GltfDocument {
    records: Records,
    buffers: Buffers,
    /// The chunks of the file, if it is a GLB.
    glb: Option<Glb>,
    /// The primitives, by mesh and number, whose vertices no primitive before them has.
    sources: Vec<(usize, usize)>,
    /// How each part is made of primitives, one a mesh.
    layouts: Vec<Layout>,
    /// The materials in use, by their name among the labels of faces.
    materials: BTreeMap<String, usize>,
    /// Image files that the document refers to and that are there: relative name and path.
    images: Vec<(String, PathBuf)>,
}

impl GltfDocument {
    /// The file as it was read.
    pub(in crate::io) fn source(&self) -> &[u8] {
        match self.glb {
            Some(_) => &self.buffers.file,
            None => self.records.json.text().as_bytes(),
        }
    }

    /// Bytes of the document and its buffers.
    pub(in crate::io) fn bytes(&self) -> u64 {
        self.records.json.text().len() as u64 + self.buffers.total()
    }

    /// The vertex accessors of a source.
    fn vertex_accessors(&self, source: usize) -> &VertexAccessors {
        let (mesh, primitive) = self.sources[source];
        &self.records.meshes[mesh].primitives[primitive].vertices
    }

    /// The strings of a top-level list.
    fn strings(&self, list: &str) -> impl Iterator<Item = Cow<'_, str>> {
        let json = &self.records.json;
        json.items(json.root(), list).filter_map(|value| json.string(value))
    }

    /// Whether a top-level list of strings contains a certain one.
    fn lists(&self, list: &str, name: &str) -> bool {
        self.strings(list).any(|string| string == name)
    }
}

/// So many primitives are fine in a file of any size; more only where each has as many bytes as the smallest of real ones. A
/// primitive takes kilobytes in memory, so that very many of a few bytes would cost far more than their file.
const PRIMITIVES_OF_ANY_SIZE: u64 = 1 << 16;
const SMALLEST_PRIMITIVE: u64 = 256;

fn check_primitive_count(records: &Records, bytes: u64) -> Result<(), ReadError> {
    let count: u64 = records.meshes.iter().map(|mesh| mesh.primitives.len().max(1) as u64).sum();
    let limit = PRIMITIVES_OF_ANY_SIZE.max(bytes / SMALLEST_PRIMITIVE);
    if count <= limit {
        return Ok(());
    }
    let place = Place::Json("/meshes".into());
    let primitives = counted(count, "primitive", "primitives");
    let found = format!("{primitives} in {bytes} bytes; the limit for that size is {limit}");
    Err(ReadError::new(Problem::Limit, place, found, "merge primitives, or divide the file"))
}

/// Reads a glTF document in either spelling. `base` is the folder of the file, where its buffers are looked for;
/// images are not opened.
///
/// # Errors
/// A [`ReadError`] with a JSON pointer or a byte offset for what is broken, out of range, compressed without a
/// plain copy, requires an unknown extension, or cannot be found.
pub fn read(bytes: Vec<u8>, base: Option<&Path>, options: &ReadOptions) -> Result<Loaded, ReadError> {
    let mut notes = Vec::new();
    check_size(&bytes, options)?;
    let (glb, json, file) = if container::glb::is_glb(&bytes) {
        let glb = Glb::parse(&bytes, &mut notes)?;
        let span = glb.json();
        let json = Json::parse(bytes[span.clone()].to_vec(), span.start as u64, options.limits.json_depth)?;
        (Some(glb), json, bytes)
    } else {
        if bytes.starts_with(b"\xEF\xBB\xBF") {
            let text = "a byte order mark, which glTF does not allow; it is kept";
            notes.push(Note::warning(Place::Byte(0), text));
        }
        (None, Json::parse(bytes, 0, options.limits.json_depth)?, Vec::new())
    };
    let input = file.len().max(json.text().len()) as u64;
    let records = Records::new(json, &mut notes)?;
    let json = &records.json;
    extensions::check(&Fields::root(json), &mut notes)?;
    let bin = glb.as_ref().and_then(Glb::bin);
    let buffers = container::buffers::load(json, &records.buffers, file, bin, base, options)?;
    let images = container::buffers::check_images(json, base, options, &mut notes)?;
    check_primitive_count(&records, input + buffers.total())?;
    let nodes = document::nodes::read(json, records.meshes.len(), &mut notes)?;

    // A value takes at most six times its stored bytes when decoded; twelve times allows for shared ones.
    let implied_limit = options.limits.implied_elements;
    let memory = Cell::new(12 * (input + buffers.total()) + 24 * implied_limit);
    let notes = RefCell::new(notes);
    let source = Source { records: &records, buffers: &buffers, implied_limit, memory, notes };
    let mut assembler = Assembler::new(source, options.non_finite);
    let (mut parts, mut layouts) = (Vec::new(), Vec::new());
    for mesh in 0..records.meshes.len() {
        let (part, layout) = assembler.part(mesh)?;
        parts.push(part);
        layouts.push(layout);
    }
    let Assembler { source, sources, materials, .. } = assembler;
    let notes = source.notes.into_inner();
    let format = if glb.is_some() { Format::Glb } else { Format::Gltf };
    let document = GltfDocument { records, buffers, glb, sources, layouts, materials, images };
    Ok(Loaded { format, parts, nodes, notes, document: Document::Gltf(Box::new(document)) })
}
