//! Which module reads and writes which format.

use super::remarks::remarks;
use super::{Document, FileMaterial, Format, Loaded, Part, PartEdit, ReadError, ReadOptions};
use super::{WriteError, WriteOptions, Written};
use super::{gltf, obj, ply, stl};
use std::path::Path;

/// Reads a file of a known format. `base` is its folder, where companion files are looked for; `None` for a stream.
pub(super) fn read(
    format: Format,
    bytes: Vec<u8>,
    base: Option<&Path>,
    options: &ReadOptions,
) -> Result<Loaded, ReadError> {
    let mut loaded = match format {
        Format::Obj => obj::read(bytes, base, options),
        Format::Gltf | Format::Glb => gltf::read(bytes, base, options),
        Format::Stl => stl::read(bytes, base, options),
        Format::Ply => ply::read(bytes, base, options),
    }?;
    loaded.notes.extend(remarks(&loaded.parts));
    Ok(loaded)
}

/// Writes a file again in its own format with changes; all else survives byte for byte. glTF may change its container.
pub(super) fn edit(
    loaded: &Loaded,
    edits: &[PartEdit],
    to: Format,
    options: &WriteOptions,
) -> Result<Written, WriteError> {
    match &loaded.document {
        Document::Obj(document) => obj::edit(document, loaded, edits, options),
        Document::Gltf(document) => gltf::edit(document, loaded, edits, to, options),
        Document::Ply(document) => ply::edit(document, loaded, edits, options),
        Document::Stl(document) => stl::edit(document, loaded, edits, options),
        Document::None => Err(WriteError::no_document()),
    }
}

impl Document {
    /// Whether these bytes are those that the document was read from.
    pub fn is_unchanged(&self, bytes: &[u8]) -> bool {
        match self {
            Document::None => false,
            Document::Obj(document) => document.source() == Some(bytes),
            Document::Gltf(document) => document.source() == bytes,
            Document::Ply(document) => document.source() == bytes,
            Document::Stl(document) => document.source() == bytes,
        }
    }
}

/// What the material library of a file says of its materials.
pub(super) fn materials(document: &Document) -> &[FileMaterial] {
    match document {
        Document::Obj(document) => document.materials(),
        _ => &[],
    }
}

/// What a document holds beside the meshes that a new file is made of, and so does not reach it, in words.
pub(super) fn outside_meshes(document: &Document) -> Vec<String> {
    match document {
        Document::None | Document::Obj(_) => Vec::new(),
        Document::Gltf(document) => document.outside_meshes(),
        Document::Ply(document) => document.outside_meshes(),
        Document::Stl(document) => document.outside_meshes(),
    }
}

/// Writes a new file.
pub(super) fn write(
    format: Format,
    parts: &[Part],
    materials: &[FileMaterial],
    options: &WriteOptions,
) -> Result<Written, WriteError> {
    match format {
        Format::Obj => obj::write(parts, options),
        Format::Gltf | Format::Glb => gltf::write_with_materials(parts, materials, format, options),
        Format::Stl => stl::write(parts, options),
        Format::Ply => ply::write(parts, options),
    }
}
