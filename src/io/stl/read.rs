//! An STL file as it was read, and bytes to its meshes; binary STL: an 80-byte header, the number of facets, 50 bytes a facet.

use super::ascii;
use crate::io::mesh_checks::{build_part, check_size, non_finite_note};
use crate::io::text::{Words, counted};
use crate::io::{Document, Format, Loaded, Note, Part, Place, Problem, ReadError, ReadOptions};
use crate::mesh::{Column, Columns, Faces, MeshBuilder, MeshError, Storage};
use glam::DVec3;
use std::path::Path;

/// An STL file as it was read.
#[derive(Clone, Debug)]
pub struct StlDocument {
    pub(in crate::io) bytes: Vec<u8>,
    pub(super) layout: Layout,
}

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Layout {
    Ascii,
    Binary { facets: usize },
}

/// Bytes of a binary header, behind which the number of facets is.
pub(super) const HEADER: usize = 80;
pub(super) const FIRST: usize = 84;
pub(super) const FACET: usize = 50;

impl StlDocument {
    /// The attribute bytes behind facets, in which some programs keep colours.
    pub(in crate::io) fn outside_meshes(&self) -> Vec<String> {
        let Layout::Binary { facets } = self.layout else { return Vec::new() };
        let (facets, _) = self.bytes[FIRST..FIRST + facets * FACET].as_chunks::<FACET>();
        match facets.iter().filter(|facet| facet[FACET - 2..] != [0, 0]).count() {
            0 => Vec::new(),
            count => vec![format!("the attribute bytes of {}", counted(count, "facet", "facets"))],
        }
    }
}

pub(super) fn declared_facets(bytes: &[u8]) -> Option<u32> {
    Some(u32::from_le_bytes(bytes.get(HEADER..FIRST)?.try_into().ok()?))
}

/// Whether a file is exactly as long as its number of facets demands.
pub(super) fn has_exact_length(bytes: &[u8]) -> bool {
    declared_facets(bytes)
        .is_some_and(|count| bytes.len() as u64 == FIRST as u64 + u64::from(count) * FACET as u64)
}

/// Whether bytes are certainly an STL: a binary one of the right length, or text with facets at the beginning.
pub(in crate::io) fn is_certain(bytes: &[u8]) -> bool {
    let text = &bytes[..bytes.len().min(HEAD)];
    has_exact_length(bytes) || is_ascii(bytes) && (mentions(text, b"facet") || mentions(text, b"endsolid"))
}

/// As much of a file as is inspected to distinguish text from binary.
const HEAD: usize = 1024;

fn mentions(text: &[u8], word: &[u8]) -> bool {
    text.windows(word.len()).any(|window| window.eq_ignore_ascii_case(word))
}

/// Whether a file starts like an ascii STL and has no control characters where a binary one has numbers.
pub(super) fn is_ascii(bytes: &[u8]) -> bool {
    let text = &bytes[..bytes.len().min(HEAD)];
    let word = Words::new(bytes).next().map_or(&[][..], |word| &bytes[word]);
    let starts_like_ascii = word.eq_ignore_ascii_case(b"solid") || word.eq_ignore_ascii_case(b"facet");
    let is_control = |byte: &u8| *byte < b' ' && !matches!(byte, b'\t'..=b'\r' | 0x1a);
    starts_like_ascii && !text.iter().any(is_control)
}

pub(super) const VECTOR: usize = 12;

pub(super) fn facet_count(bytes: &[u8]) -> Result<usize, ReadError> {
    let declared = declared_facets(bytes).unwrap_or(0);
    let rest = bytes.len().saturating_sub(FIRST);
    let present = rest / FACET;
    if declared as usize > present {
        let found =
            format!("the header has {}, but there is data for only {present}", facets_of(declared as usize));
        let advice = "the file is cut off, or not an STL; copy or export it again";
        return Err(ReadError::new(Problem::Truncated, Place::Byte(bytes.len() as u64), found, advice));
    }
    // Writers that stream leave the count at 0.
    let uncounted = declared == 0 && rest.is_multiple_of(FACET);
    Ok(if uncounted { present } else { declared as usize })
}

fn facets_of(count: usize) -> String {
    counted(count, "facet", "facets")
}

fn vectors(facet: &[u8]) -> [DVec3; 4] {
    let (values, _) = facet.as_chunks::<4>();
    let number = |k: usize| f64::from(f32::from_le_bytes(values[k]));
    [0, 3, 6, 9].map(|k| DVec3::new(number(k), number(k + 1), number(k + 2)))
}

/// Reads so many facets, of which there are at least as many bytes.
fn read_binary(
    bytes: &[u8],
    count: usize,
    options: &ReadOptions,
) -> Result<(Vec<Part>, Vec<Note>), ReadError> {
    let end = FIRST + count * FACET;
    let (facets, _) = bytes[FIRST..end].as_chunks::<FACET>();
    let mut positions = Vec::with_capacity(3 * count);
    let mut normals = Vec::with_capacity(count);
    for facet in facets {
        let [normal, a, b, c] = vectors(facet);
        normals.push(normal);
        positions.extend([a, b, c]);
    }
    let corners = 3 * count as u32;
    let mut notes: Vec<Note> = non_finite_note(&positions, options.non_finite).into_iter().collect();
    let builder = MeshBuilder {
        positions,
        storage: Storage::F32,
        faces: Faces::triangles((0..corners).collect()),
        columns: Columns {
            normals: (count > 0).then(|| Column::per_corner(normals, (0..corners).map(|k| k / 3).collect())),
            ..Columns::default()
        },
    };
    let place = |error: &MeshError| match error {
        MeshError::NonFinite { vertex, .. } => {
            Place::Byte((FIRST + vertex / 3 * FACET + (vertex % 3 + 1) * VECTOR) as u64)
        }
        _ => Place::File,
    };
    let part = build_part(String::new(), builder, options, place)?;
    let declared = declared_facets(bytes).unwrap_or(0) as usize;
    if declared != count {
        let text = format!("the header has {}; all {count} in the file were read", facets_of(declared));
        notes.push(Note::warning(Place::Byte(HEADER as u64), text));
    }
    match bytes.len() - end {
        0 => {}
        rest if rest < FACET => {
            let rest = counted(rest, "byte", "bytes");
            notes.push(Note::remark(format!("{rest} after the last facet ignored")));
        }
        rest => {
            let text = format!(
                "the header has {}; {rest} bytes after them, enough for {} more, were ignored",
                facets_of(count),
                rest / FACET
            );
            notes.push(Note::warning(Place::Byte(end as u64), text));
        }
    }
    Ok((vec![part], notes))
}

/// Reads an STL file, which has no companion files.
///
/// # Errors
/// With the line or the byte: a file that ends too early, facets without three vertices, words that are not numbers, positions
/// that are not finite (unless [`ReadOptions::non_finite`] allows them), and bytes that are not STL.
pub fn read(bytes: Vec<u8>, _base: Option<&Path>, options: &ReadOptions) -> Result<Loaded, ReadError> {
    check_size(bytes.len() as u64, &options.limits)?;
    let is_ascii = is_ascii(&bytes);
    let (layout, (parts, notes)) = if has_exact_length(&bytes) || !is_ascii && bytes.len() >= FIRST {
        let facets = facet_count(&bytes)?;
        (Layout::Binary { facets }, read_binary(&bytes, facets, options)?)
    } else if is_ascii {
        (Layout::Ascii, ascii::read(&bytes, options)?)
    } else {
        let found = match bytes.len() {
            0 => "the file is empty".to_owned(),
            length => format!("not an STL file ({})", counted(length, "byte", "bytes")),
        };
        let advice = "check that the file is complete, or name the format with --format";
        return Err(ReadError::new(Problem::Syntax, Place::File, found, advice));
    };
    let document = Document::Stl(Box::new(StlDocument { bytes, layout }));
    Ok(Loaded { format: Format::Stl, parts, nodes: Vec::new(), notes, document })
}
