//! Writing an STL back into its own bytes.

use super::ascii::{FacetText, SolidText, solids};
use super::new_file::vertex_normals_note;
use super::read::{FACET, FIRST, HEADER, Layout, StlDocument, VECTOR};
use crate::io::text::{Copier, line_end_length, push_f32};
use crate::io::{Loaded, PartEdit, WriteError, WriteOptions, Written};
use crate::mesh::Mesh;
use glam::DVec3;
use std::ops::Range;

/// The document with the edit applied: facet normals, facets dropped and reversed. Everything else keeps its bytes.
///
/// A facet's normal is [`PartEdit::face_normals`]; if the corners keep the normal of the file in [`PartEdit::normals`], the
/// facet keeps its own.
pub(in crate::io) fn edit(
    document: &StlDocument,
    loaded: &Loaded,
    edits: &[PartEdit],
    options: &WriteOptions,
) -> Result<Written, WriteError> {
    let facets = facet_edits(loaded, edits);
    let kept = facets.iter().flatten().filter(|facet| !facet.dropped).count();
    let bytes = match document.layout {
        Layout::Binary { .. } => edit_binary(&document.bytes, facets.first().map_or(&[], Vec::as_slice)),
        Layout::Ascii => edit_ascii(&document.bytes, &facets),
    };
    let mut notes = Vec::new();
    if edits.iter().any(|edit| edit.normals.is_some() || edit.face_normals.is_some()) {
        notes.extend(vertex_normals_note(options));
    }
    Ok(Written { bytes, notes, vertices: 3 * kept as u64, ..Written::default() })
}

/// The file with its facets edited; the bytes before and behind them stay.
fn edit_binary(bytes: &[u8], facets: &[FacetEdit]) -> Vec<u8> {
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
            out[start..start + VECTOR].copy_from_slice(normal.map(f32::to_le_bytes).as_flattened());
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

/// The text with its facets edited, one list a solid. Only numbers change, and dropped facets are removed with the
/// lines that nothing else is on.
fn edit_ascii(text: &[u8], edits: &[Vec<FacetEdit>]) -> Vec<u8> {
    let mut copy = Copier::new(text, 8);
    for (solid, edits) in solids(text).iter().zip(edits) {
        for (facet, edit) in solid.facets.iter().zip(edits) {
            edit_facet(&mut copy, solid, facet, edit);
        }
    }
    copy.copy_to(text.len());
    copy.out
}

fn edit_facet(copy: &mut Copier<'_>, solid: &SolidText, facet: &FacetText, edit: &FacetEdit) {
    if edit.dropped {
        return copy.skip(facet_lines(copy, facet));
    }
    if let Some(normal) = edit.normal {
        copy.skip(facet.normal.clone());
        copy.out.extend_from_slice(facet.lead.as_bytes());
        for (k, value) in normal.into_iter().enumerate() {
            if k > 0 {
                copy.out.push(b' ');
            }
            push_f32(&mut copy.out, value);
        }
    }
    if edit.reversed {
        // The first corner stays the first.
        let spans = &solid.vertices[facet.vertices.clone()];
        for (here, there) in spans[1..].iter().zip(spans[1..].iter().rev()) {
            copy.skip(here.clone());
            copy.out.extend_from_slice(&copy.text[there.clone()]);
        }
    }
}

/// The bytes to remove with a facet: its lines, if nothing else is on them.
fn facet_lines(copy: &Copier<'_>, facet: &FacetText) -> Range<usize> {
    let is_not_space = |byte: &u8| !matches!(byte, b' ' | b'\t');
    let before = &copy.text[copy.at..facet.span.start];
    let start = copy.at + before.iter().rposition(is_not_space).map_or(0, |last| last + 1);
    let behind = &copy.text[facet.span.end..];
    let blanks = behind.iter().position(is_not_space).unwrap_or(behind.len());
    let line_end = line_end_length(&behind[blanks..]);
    let starts_line = start == 0 || matches!(copy.text[start - 1], b'\n' | b'\r');
    if starts_line && line_end > 0 { start..facet.span.end + blanks + line_end } else { facet.span.clone() }
}

/// The edit of one facet of the document.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(super) struct FacetEdit {
    pub dropped: bool,
    pub reversed: bool,
    /// Its new normal; `None` keeps the stored bytes.
    pub normal: Option<[f32; 3]>,
}

/// One entry a facet, part by part.
pub(super) fn facet_edits(loaded: &Loaded, edits: &[PartEdit]) -> Vec<Vec<FacetEdit>> {
    let unchanged = PartEdit::default();
    let edits = edits.iter().chain(std::iter::repeat(&unchanged));
    loaded.parts.iter().zip(edits).map(|(part, edit)| part_edits(&part.mesh, edit)).collect()
}

fn part_edits(mesh: &Mesh, edit: &PartEdit) -> Vec<FacetEdit> {
    let mut facets = vec![FacetEdit::default(); mesh.face_count()];
    if let Some(normals) = &edit.face_normals {
        for ((face, facet), &normal) in facets.iter_mut().enumerate().zip(normals) {
            let normal = stored(normal);
            // An equal number keeps its spelling.
            facet.normal =
                (!keeps(mesh, edit, face) && current(mesh, face) != Some(normal)).then_some(normal);
        }
    }
    for &face in &edit.faces.dropped {
        facets[face as usize].dropped = true;
    }
    for &face in &edit.faces.reversed {
        facets[face as usize].reversed = true;
    }
    facets
}

/// A normal as STL stores it.
pub(super) fn stored(normal: DVec3) -> [f32; 3] {
    normal.as_vec3().to_array()
}

/// Whether the edit keeps the file's own normal at the corners of a facet.
fn keeps(mesh: &Mesh, edit: &PartEdit, face: usize) -> bool {
    let corner = mesh.faces().range(face).start;
    let slot = edit.normals.as_ref().and_then(|normals| normals.slot(corner, mesh.faces().corners()[corner]));
    slot.is_some_and(|slot| (slot as usize) < edit.kept)
}

/// The facet's normal in the file, rounded as [`stored`] does.
fn current(mesh: &Mesh, face: usize) -> Option<[f32; 3]> {
    let corner = mesh.faces().range(face).start;
    mesh.columns().normals.as_ref()?.get(corner, mesh.faces().corners()[corner]).copied().map(stored)
}
