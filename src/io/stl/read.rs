//! Bytes to an STL document and its meshes.

use super::document::{Layout, StlDocument, is_ascii, is_binary};
use super::{ascii, binary};
use crate::io::mesh_checks::check_size;
use crate::io::text::counted;
use crate::io::{Document, Format, Loaded, Place, Problem, ReadError, ReadOptions};
use std::path::Path;

/// Reads an STL file. It has no companion files, so the folder is not used.
///
/// # Errors
/// With the line or the byte: a file that ends too early, facets without three vertices, words that are not numbers,
/// positions that are not finite (unless [`ReadOptions::non_finite`] allows them), and bytes that are not STL.
pub fn read(bytes: Vec<u8>, _base: Option<&Path>, options: &ReadOptions) -> Result<Loaded, ReadError> {
    check_size(&bytes, options)?;
    let (layout, (parts, notes)) = if is_binary(&bytes) {
        let facets = binary::facet_count(&bytes)?;
        (Layout::Binary { facets }, binary::read(&bytes, facets, options)?)
    } else if is_ascii(&bytes) {
        (Layout::Ascii, ascii::read(&bytes, options)?)
    } else {
        let found = match bytes.len() {
            0 => "the file is empty".to_owned(),
            length => format!("{} of neither ascii nor binary STL", counted(length, "byte", "bytes")),
        };
        let advice = "check that the file is complete and an STL, or name its format";
        return Err(ReadError::new(Problem::Syntax, Place::File, found, advice));
    };
    let document = Document::Stl(Box::new(StlDocument { bytes, layout }));
    Ok(Loaded { format: Format::Stl, parts, nodes: Vec::new(), notes, document })
}
