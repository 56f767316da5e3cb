//! Which module reads and writes which format.

use super::{Document, Format, Loaded, Part, PartEdit, ReadError, ReadOptions};
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
    match format {
        Format::Obj => obj::read(bytes, base, options),
        Format::Gltf | Format::Glb => gltf::read(bytes, base, options),
        Format::Stl => stl::read(bytes, base, options),
        Format::Ply => ply::read(bytes, base, options),
    }
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
        Document::None => {
            Err(WriteError::Unsupported("no document was kept to edit; write a new file".to_owned()))
        }
    }
}

/// Writes a new file.
pub(super) fn write(format: Format, parts: &[Part], options: &WriteOptions) -> Result<Written, WriteError> {
    match format {
        Format::Obj => obj::write(parts, options),
        Format::Gltf | Format::Glb => gltf::write(parts, format, options),
        Format::Stl => stl::write(parts, options),
        Format::Ply => ply::write(parts, options),
    }
}
