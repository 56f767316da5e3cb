//! Bytes to an STL document and its meshes; binary STL: an 80-byte header, the number of facets, 50 bytes a facet.

use super::ascii;
use super::document::{
    FACET, FIRST, HEADER, Layout, StlDocument, declared_facets, has_exact_length, is_ascii,
};
use crate::io::mesh_checks::check_size;
use crate::io::mesh_checks::{build_part, non_finite_note};
use crate::io::text::counted;
use crate::io::{Document, Format, Loaded, Note, Part, Place, Problem, ReadError, ReadOptions};
use crate::mesh::{Column, Columns, Faces, MeshBuilder, MeshError, PositionsRef};
use glam::DVec3;
use std::path::Path;

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

fn vectors(facet: &[u8; FACET]) -> [[f32; 3]; 4] {
    let (values, _) = facet.as_chunks::<4>();
    let number = |k: usize| f32::from_le_bytes(values[k]);
    [0, 3, 6, 9].map(|k| [number(k), number(k + 1), number(k + 2)])
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
        normals.push(DVec3::from(normal.map(f64::from)));
        positions.extend([a, b, c]);
    }
    let corners = 3 * count as u32;
    let mut notes: Vec<Note> =
        non_finite_note(PositionsRef::F32(&positions), options.non_finite).into_iter().collect();
    let builder = MeshBuilder {
        positions: positions.into(),
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
            notes.push(Note::remark(format!("ignored after the last facet: {rest}")));
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
