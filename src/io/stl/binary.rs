//! Binary STL: an 80-byte header, the number of facets, 50 bytes a facet (normal, three vertices, two attribute
//! bytes), all little-endian.

use super::facets::FacetEdit;
use crate::io::tally::{build_part, non_finite_note};
use crate::io::text::counted;
use crate::io::{Note, Part, Place, Problem, ReadError, ReadOptions};
use crate::mesh::{Column, Columns, Faces, MeshBuilder, MeshError, Storage};
use glam::DVec3;

/// Bytes of the header, where the number of facets is.
pub(super) const HEADER: usize = 80;
/// Where the first facet starts.
pub(super) const FIRST: usize = 84;
/// Bytes of a facet.
pub(super) const FACET: usize = 50;
/// Bytes of a normal or a vertex.
const VECTOR: usize = 12;

/// What the header says.
fn declared(bytes: &[u8]) -> Option<u32> {
    Some(u32::from_le_bytes(bytes.get(HEADER..FIRST)?.try_into().ok()?))
}

/// Whether a file is exactly as long as its number of facets demands.
pub(super) fn has_exact_length(bytes: &[u8]) -> bool {
    declared(bytes).is_some_and(|count| bytes.len() as u64 == FIRST as u64 + u64::from(count) * FACET as u64)
}

/// The number of facets to read.
pub(super) fn count(bytes: &[u8]) -> Result<usize, ReadError> {
    let declared = declared(bytes).unwrap_or(0);
    let rest = bytes.len().saturating_sub(FIRST);
    let present = rest / FACET;
    if declared as usize > present {
        let found =
            format!("the header counts {}, but there are bytes for {present}", facets_of(declared as usize));
        let advice = "the file was cut off, or it is no STL";
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

/// How many facets have attribute bytes that are not 0.
pub(super) fn attributes(bytes: &[u8], count: usize) -> usize {
    let (facets, _) = bytes[FIRST..FIRST + count * FACET].as_chunks::<FACET>();
    facets.iter().filter(|facet| facet[FACET - 2..] != [0, 0]).count()
}

/// Reads so many facets, of which there are at least as many bytes.
pub(super) fn read(
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
    let declared = declared(bytes).unwrap_or(0) as usize;
    if declared != count {
        let text = format!("the header counts {}; all {count} that are there were read", facets_of(declared));
        notes.push(Note::warning(Place::Byte(HEADER as u64), text));
    }
    match bytes.len() - end {
        0 => {}
        rest if rest < FACET => {
            let left = counted(rest, "byte", "bytes");
            notes.push(Note::remark(format!("not read, because it is behind the last facet: {left}")));
        }
        rest => {
            let text = format!(
                "the header counts {}; {rest} bytes behind that, room for {} more, were not read",
                facets_of(count),
                rest / FACET
            );
            notes.push(Note::warning(Place::Byte(end as u64), text));
        }
    }
    Ok((vec![part], notes))
}

/// The file with its facets edited; what is before and behind them stays.
pub(super) fn edit(bytes: &[u8], facets: &[FacetEdit]) -> Vec<u8> {
    let mut out = Vec::with_capacity(bytes.len());
    out.extend_from_slice(&bytes[..FIRST]);
    let end = FIRST + facets.len() * FACET;
    for (edit, record) in facets.iter().zip(bytes[FIRST..end].chunks_exact(FACET)) {
        if edit.dropped {
            continue;
        }
        let start = out.len();
        out.extend_from_slice(record);
        if let Some(normal) = edit.normal {
            out[start..start + VECTOR].copy_from_slice(&vector_bytes(normal));
        }
        if edit.reversed {
            // The first corner stays the first.
            let (second, third) = out[start + 2 * VECTOR..start + 4 * VECTOR].split_at_mut(VECTOR);
            second.swap_with_slice(third);
        }
    }
    out.extend_from_slice(&bytes[end..]);
    let dropped = facets.iter().filter(|facet| facet.dropped).count();
    if dropped > 0 {
        let count = (facets.len() - dropped) as u32;
        out[HEADER..FIRST].copy_from_slice(&count.to_le_bytes());
    }
    out
}

/// The twelve bytes of a vector.
pub(super) fn vector_bytes(vector: [f32; 3]) -> [u8; VECTOR] {
    let mut bytes = [0; VECTOR];
    for (chunk, value) in bytes.chunks_exact_mut(4).zip(vector) {
        chunk.copy_from_slice(&value.to_le_bytes());
    }
    bytes
}
