//! The polygon file format (Turk 1994, and what real files make of it), ascii and binary.
//!
//! A header names elements, the columns of each and the number of their rows. Only the elements `vertex`, `face`
//! (or else `tristrips`) and `edge` are understood, and of these only some columns; all others are carried along.
//!
//! Ascii rows have a line each in nearly all files, so what is left on a line behind a row is skipped with a warning;
//! if the file then ends too early, it is read again as one stream of words.

mod changes;
mod edit;
mod fresh;
mod header;
mod lists;
mod mesh;
mod normals;
mod roles;
mod rows;
mod scalar;

use super::tally::check_size;
use super::{Document, Format, Loaded, PartEdit, ReadError, ReadOptions, WriteError, WriteOptions, Written};
use crate::mesh::{Column, ColumnIndex, Mesh};
pub(super) use fresh::write;
use glam::DVec3;
use header::Header;
use roles::Roles;
use std::path::Path;

/// A PLY file as it was read.
#[derive(Clone, Debug)]
pub struct PlyDocument {
    bytes: Vec<u8>,
    header: Header,
    roles: Roles,
    /// Whether ascii rows share lines.
    shared_lines: bool,
    packed: Packed,
}

/// Whether stored normals are whole numbers that stand for −1..1.
#[derive(Clone, Copy, Debug, Default)]
struct Packed {
    vertices: bool,
    faces: bool,
}

impl PlyDocument {
    /// The file as it was read.
    pub(super) fn source(&self) -> &[u8] {
        &self.bytes
    }

    /// The elements and properties that have no part in the mesh.
    pub(super) fn outside_meshes(&self) -> Vec<String> {
        let mut left = Vec::new();
        for (number, element) in self.header.elements.iter().enumerate() {
            match self.roles.used(number) {
                None if element.count > 0 => left.push(format!("the element `{}`", element.name)),
                None => {}
                Some(used) => {
                    let names = element.properties.iter().enumerate().filter(|(at, _)| !used.contains(at));
                    let names: Vec<String> =
                        names.map(|(_, property)| format!("`{}`", property.name)).collect();
                    if !names.is_empty() && element.count > 0 {
                        left.push(format!("{} of the element `{}`", names.join(", "), element.name));
                    }
                }
            }
        }
        left
    }

    /// The normals of faces as stored; not there where vertices have some.
    fn face_normals<'a>(&self, mesh: &'a Mesh) -> Option<&'a [DVec3]> {
        match &mesh.columns().normals {
            Some(Column { values, index: ColumnIndex::PerCorner(_) }) => Some(values),
            _ => None,
        }
    }
}

/// Reads a PLY file. It has no companions that matter, so the folder is of no use.
///
/// Normals that are stored as whole numbers count as parts of the type's largest, if one of them is over 1. Colours
/// are brought to 0..=1. Vertices without faces or edges are points.
///
/// # Errors
/// With the line (header, ascii) or the byte: a header that is none, a body that ends too early, words that are no
/// numbers, faces that refer to vertices that are not there, positions that are not finite (unless
/// [`ReadOptions::non_finite`] lets them pass).
pub fn read(bytes: Vec<u8>, _base: Option<&Path>, options: &ReadOptions) -> Result<Loaded, ReadError> {
    check_size(&bytes, options)?;
    let header = header::parse(&bytes)?;
    let roles = Roles::of(&header)?;
    let body = mesh::read(&bytes, &header, &roles, options)?;
    let mesh::Body { part, notes, shared_lines, packed } = body;
    let document = Document::Ply(Box::new(PlyDocument { bytes, header, roles, shared_lines, packed }));
    Ok(Loaded { format: Format::Ply, parts: vec![part], nodes: Vec::new(), notes, document })
}

/// The document with the edit applied. Header lines, properties and elements that have no part in it stay byte for
/// byte, unknown ones included.
///
/// Normals are patched where the file has them, in its own type, or put in behind `z`, as doubles if positions are.
/// Types that cannot hold unit normals well (8-bit integers, integers that are not parts of 1) become floats.
/// With [`Emit::Face`](super::Emit::Face) the faces get [`PartEdit::face_normals`] instead of the vertices. Vertices
/// that are split off come behind the others, with all of their properties.
///
/// # Errors
/// [`WriteError::Unsupported`] if only some of `nx`, `ny`, `nz` are there.
pub(super) fn edit(
    document: &PlyDocument,
    loaded: &Loaded,
    edits: &[PartEdit],
    options: &WriteOptions,
) -> Result<Written, WriteError> {
    let unchanged = PartEdit::default();
    let (Some(part), edit) = (loaded.parts.first(), edits.first().unwrap_or(&unchanged)) else {
        return Err(WriteError::Unsupported("a PLY file has one part".to_owned()));
    };
    edit::edit(document, &part.mesh, edit, options)
}

#[cfg(test)]
mod tests;
