//! Stereolithography, ascii and binary (3D Systems 1988, and what real files make of it).
//!
//! A binary file is told by its length, 84 bytes and 50 a facet, before anything else: its header may well begin
//! with `solid`. Facets do not share vertices; each corner of the mesh has one of its own, and corners of one facet
//! share the stored normal. Every solid of an ascii file is a part.

mod ascii;
mod ascii_edit;
mod binary;
mod facets;
mod fresh;
mod words;

use super::tally::check_size;
use super::text::counted;
use super::{Document, Emit, Format, Loaded, Note, PartEdit, Place, Problem, ReadError, ReadOptions};
use super::{WriteError, WriteOptions, Written};
pub(super) use fresh::write;
use std::path::Path;

/// An STL file as it was read.
#[derive(Clone, Debug)]
pub struct StlDocument {
    bytes: Vec<u8>,
    layout: Layout,
}

impl StlDocument {
    /// The file as it was read.
    pub(super) fn source(&self) -> &[u8] {
        &self.bytes
    }

    /// The attribute bytes behind facets, in which some programs keep colours.
    pub(super) fn outside_meshes(&self) -> Vec<String> {
        let Layout::Binary { facets } = self.layout else { return Vec::new() };
        let count = binary::attributes(&self.bytes, facets);
        if count == 0 {
            Vec::new()
        } else {
            vec![format!("the attribute bytes of {}", counted(count, "facet", "facets"))]
        }
    }
}

/// The two kinds of STL.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Layout {
    Ascii,
    Binary { facets: usize },
}

/// Reads an STL file. It has no companions, so the folder is of no use.
///
/// # Errors
/// With the line or the byte: a file that ends too early, facets without three vertices, numbers that are none,
/// positions that are not finite (unless [`ReadOptions::non_finite`] lets them pass), and bytes that are no STL.
pub fn read(bytes: Vec<u8>, _base: Option<&Path>, options: &ReadOptions) -> Result<Loaded, ReadError> {
    check_size(&bytes, options)?;
    let (layout, (parts, notes)) = if is_binary(&bytes) {
        let facets = binary::count(&bytes)?;
        (Layout::Binary { facets }, binary::read(&bytes, facets, options)?)
    } else if is_ascii(&bytes) {
        (Layout::Ascii, ascii::read(&bytes, options)?)
    } else {
        let found = match bytes.len() {
            0 => "the file is empty".to_owned(),
            length => {
                let bytes = counted(length, "byte", "bytes");
                format!("{bytes} of neither ascii nor binary STL")
            }
        };
        let advice = "check that the file is complete and an STL, or name its format";
        return Err(ReadError::new(Problem::Syntax, Place::File, found, advice));
    };
    let document = Document::Stl(Box::new(StlDocument { bytes, layout }));
    Ok(Loaded { format: Format::Stl, parts, nodes: Vec::new(), notes, document })
}

/// Whether bytes are an STL for sure: a binary one of the right length, or text that has facets in the beginning.
pub(super) fn is_certain(bytes: &[u8]) -> bool {
    let text = &bytes[..bytes.len().min(HEAD)];
    binary::has_exact_length(bytes)
        || is_ascii(bytes) && (mentions(text, b"facet") || mentions(text, b"endsolid"))
}

/// As much of a file as is looked at to tell text from binary.
const HEAD: usize = 1024;

fn mentions(text: &[u8], word: &[u8]) -> bool {
    text.windows(word.len()).any(|window| window.eq_ignore_ascii_case(word))
}

fn is_binary(bytes: &[u8]) -> bool {
    binary::has_exact_length(bytes) || !is_ascii(bytes) && bytes.len() >= binary::FIRST
}

/// Whether a file starts like an ascii STL and has no control characters where a binary one has numbers.
fn is_ascii(bytes: &[u8]) -> bool {
    let text = &bytes[..bytes.len().min(HEAD)];
    let is_control = |byte: &u8| *byte < b' ' && !matches!(byte, b'\t'..=b'\r' | 0x1a);
    ascii::starts_like_one(bytes) && !text.iter().any(is_control)
}

/// The document with the edit applied: facet normals, facets dropped and turned round. All else keeps its bytes.
///
/// A facet's normal is [`PartEdit::face_normals`]; where [`PartEdit::normals`] say that its corners keep what the file
/// has, that is kept.
pub(super) fn edit(
    document: &StlDocument,
    loaded: &Loaded,
    edits: &[PartEdit],
    options: &WriteOptions,
) -> Result<Written, WriteError> {
    let facets = facets::edited(loaded, edits);
    let kept = facets.iter().flatten().filter(|facet| !facet.dropped).count();
    let bytes = match document.layout {
        Layout::Binary { .. } => binary::edit(&document.bytes, facets.first().map_or(&[], Vec::as_slice)),
        Layout::Ascii => ascii_edit::edit(&document.bytes, &facets),
    };
    let mut notes = Vec::new();
    if edits.iter().any(|edit| edit.normals.is_some() || edit.face_normals.is_some()) {
        notes.extend(vertex_normals_note(options));
    }
    Ok(Written { bytes, notes, vertices: 3 * kept as u64, ..Written::default() })
}

/// What is said unless the caller asked for no more than STL has.
fn vertex_normals_note(options: &WriteOptions) -> Option<Note> {
    let text = "STL cannot carry vertex normals: one normal a facet was written";
    (options.emit != Emit::Face).then(|| Note::warning(Place::File, text))
}

#[cfg(test)]
mod tests;
