//! Bytes to an OBJ document and its mesh.

use super::cursor::Cursor;
use super::document::ObjDocument;
use super::merge::merge;
use super::piece::Content;
use super::statements::{Keyword, pieces, statements};
use super::{mtl, piece};
use crate::io::mesh_checks::check_size;
use crate::io::text::{line_and_column, line_place, shown};
use crate::io::{Document, Format, Loaded, Part, Place, Problem, ReadError, ReadOptions};
use crate::num::parallel;
use std::ops::Range;
use std::path::Path;
use std::sync::OnceLock;

/// Pieces that are parsed before they are appended.
const BATCH: usize = 8;

/// Reads an OBJ file. `base` is the folder that is searched for material libraries. The mesh is one part, with every `vn` of the
/// file in file order, and positions in `f32` if the digits show that they were printed from it.
///
/// # Errors
/// With the line: words that are not numbers, vertex indices out of range, positions that are not finite (unless
/// [`ReadOptions::non_finite`] allows them). Without: UTF-16 and UTF-32, and bytes that are not OBJ.
pub fn read(bytes: Vec<u8>, base: Option<&Path>, options: &ReadOptions) -> Result<Loaded, ReadError> {
    check_size(bytes.len() as u64, &options.limits)?;
    check_encoding(&bytes)?;
    let place = |error: ReadError| {
        let Place::Byte(offset) = error.place else { return error };
        let (line, column) = line_and_column(&bytes, offset as usize);
        let found = match error.problem {
            Problem::Syntax => format!("column {column}: {}", error.found),
            _ => error.found,
        };
        ReadError { found, place: Place::Line(line), ..error }
    };
    let content = parse(&bytes).map_err(place)?;
    if !content.has_statements {
        check_is_blank(&bytes)?;
    }
    let (insertion, surface_normals) = (content.insertion(), content.surface_normals);
    let merged = merge(content, &bytes, options.non_finite).map_err(place)?;
    let (mut notes, mesh) = (merged.notes, merged.mesh);
    let mut libraries = match base.or(options.root.as_deref()) {
        Some(base) => {
            let used = mesh.columns().materials.as_ref().map_or(&[][..], |labels| &labels.names);
            mtl::find(&merged.libraries, used, base, options)
        }
        None => mtl::out_of_reach(&merged.libraries),
    };
    notes.append(&mut libraries.notes);
    let name = match &mesh.columns().objects {
        Some(objects) if objects.names.len() == 1 => objects.names[0].clone(),
        _ => String::new(),
    };
    let part = Part { name, mesh, non_finite_faces: merged.non_finite_faces };
    let (text, lines) = (Some(bytes), OnceLock::new());
    let document = ObjDocument { text, lines, insertion, surface_normals, libraries };
    let document = Document::Obj(Box::new(document));
    Ok(Loaded { format: Format::Obj, parts: vec![part], nodes: Vec::new(), notes, document })
}

/// Parses a batch of pieces on all threads while those parsed before are appended, so that memory holds little more than the mesh.
fn parse(text: &[u8]) -> Result<Content, ReadError> {
    let parse_all = |pieces: &[Range<usize>]| -> Vec<Result<Content, ReadError>> {
        parallel::map_each(pieces, |piece| piece::parse(text, piece.clone()))
    };
    let mut content = Content::default();
    let mut parsed = Vec::new();
    for pieces in pieces(text).chunks(BATCH) {
        // The first fault in file order counts, whichever was met first.
        let append = || parsed.into_iter().try_for_each(|piece| content.append(piece?));
        let (appended, next) = rayon::join(append, || parse_all(pieces));
        appended?;
        parsed = next;
    }
    parsed.into_iter().try_for_each(|piece| content.append(piece?))?;
    Ok(content)
}

fn check_encoding(bytes: &[u8]) -> Result<(), ReadError> {
    let name = match bytes {
        [0xff, 0xfe, 0, 0, ..] | [0, 0, 0xfe, 0xff, ..] => "UTF-32",
        [0xff, 0xfe, ..] | [0xfe, 0xff, ..] => "UTF-16",
        // Without a mark: ASCII in UTF-16 has a zero in every other byte.
        [0, 1..=255, 0, 1..=255, ..] | [1..=255, 0, 1..=255, 0, ..] => "UTF-16",
        _ => return Ok(()),
    };
    let found = format!("the file is {name} text");
    Err(ReadError::new(Problem::Unsupported, Place::File, found, "save it as UTF-8 or ASCII"))
}

/// Refuses a file that has statements, but none of OBJ.
fn check_is_blank(text: &[u8]) -> Result<(), ReadError> {
    let unknown = statements(text).find(|statement| statement.keyword == Keyword::Unknown);
    let Some(unknown) = unknown else { return Ok(()) };
    let mut cursor = Cursor::new(text, unknown.start);
    cursor.skip_blanks();
    let found = format!("not an OBJ file; it starts with `{}`", shown(cursor.token()));
    let (place, advice) = (line_place(text, unknown.start), "name the format with --format");
    Err(ReadError::new(Problem::Syntax, place, found, advice))
}
