//! Reading a glTF file.

use super::accessor::Source;
use super::buffers::{check_images, load};
use super::compressed::decompress;
use super::document::GltfDocument;
use super::fields::Fields;
use super::glb::{Glb, is_glb};
use super::json::Json;
use super::mesh::Assembler;
use super::records::Records;
use super::{extensions, nodes};
use crate::io::mesh_checks::check_size;
use crate::io::{Document, Format, Loaded, Note, Place, Problem, ReadError, ReadOptions};
use std::cell::{Cell, RefCell};
use std::path::Path;

/// Primitives in a file of any size, and bytes of the file for each one more: a primitive takes kilobytes of memory.
const PRIMITIVES_OF_ANY_SIZE: u64 = 1 << 16;
const SMALLEST_PRIMITIVE: u64 = 256;

/// Reads a glTF document in either spelling. `base` is the folder of the file, where its buffers are searched for.
///
/// # Errors
/// With a JSON pointer or a byte offset: damaged or compressed data, unknown required extensions, missing buffers.
pub fn read(bytes: Vec<u8>, base: Option<&Path>, options: &ReadOptions) -> Result<Loaded, ReadError> {
    check_size(bytes.len() as u64, &options.limits)?;
    let mut notes = Vec::new();
    let (glb, json, file) = if is_glb(&bytes) {
        let glb = Glb::parse(&bytes, &mut notes)?;
        let span = glb.json();
        let json = Json::parse(bytes[span.clone()].to_vec(), span.start as u64, options.limits.json_depth)?;
        (Some(glb), json, bytes)
    } else {
        if bytes.starts_with(b"\xEF\xBB\xBF") {
            let text = "glTF does not allow this byte order mark; it is kept";
            notes.push(Note::warning(Place::Byte(0), text));
        }
        (None, Json::parse(bytes, 0, options.limits.json_depth)?, Vec::new())
    };
    let input = file.len().max(json.text().len()) as u64;
    let records = Records::new(json, &mut notes)?;
    extensions::check(&Fields::root(&records.json), &options.allowed_extensions, &mut notes)?;
    let bin = glb.as_ref().and_then(Glb::bin);
    let buffers = load(&records.json, &records.buffers, file, bin, base, options)?;
    let (records, buffers, glb, compression) = decompress(records, buffers, glb, options)?;
    let json = &records.json;
    let images = check_images(json, base, options, &mut notes)?;
    let bytes = input + buffers.total();
    let count: u64 = records.meshes.iter().map(|mesh| mesh.primitives.len().max(1) as u64).sum();
    let limit = PRIMITIVES_OF_ANY_SIZE.max(bytes / SMALLEST_PRIMITIVE);
    if count > limit {
        let place = Place::Json("/meshes".into());
        let found = format!("{count} primitives in {bytes} bytes (limit {limit})");
        return Err(ReadError::new(Problem::Limit, place, found, "merge primitives, or split the file"));
    }
    let nodes = nodes::read(json, records.meshes.len(), &mut notes)?;

    // A value takes at most six times its stored bytes when decoded; twelve times allows for shared ones.
    let implied_limit = options.limits.implied_elements;
    let memory = Cell::new(12 * bytes + 24 * implied_limit);
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
    let document = GltfDocument { records, buffers, glb, sources, layouts, materials, images, compression };
    Ok(Loaded { format, parts, nodes, notes, document: Document::Gltf(Box::new(document)) })
}
