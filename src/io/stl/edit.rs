//! Writing an STL back into its own bytes.

use super::ascii::{FacetText, solids};
use super::document::{FACET, FIRST, HEADER, Layout, StlDocument};
use super::new_file::{stored, vertex_normals_note};
use super::read::VECTOR;
use crate::io::text::{Copier, line_end_length, push_f32, push_row};
use crate::io::{Loaded, PartEdit, WriteError, WriteOptions, Written};
use crate::mesh::{Column, Mesh, Storage};
use glam::DVec3;
use std::ops::Range;

/// The document with the edit applied. Facets whose corners all keep the normal of the file keep it; all else keeps its bytes.
pub(in crate::io) fn edit(
    document: &StlDocument,
    loaded: &Loaded,
    edits: &[PartEdit],
    options: &WriteOptions,
) -> Result<Written, WriteError> {
    let meshes = || loaded.parts.iter().map(|part| &part.mesh).zip(edits);
    let bytes = match document.layout {
        Layout::Ascii => edit_ascii(&document.bytes, meshes()),
        Layout::Binary { .. } => {
            let (mesh, edit) = meshes().next().ok_or_else(WriteError::no_document)?;
            edit_binary(&document.bytes, mesh, edit)
        }
    };
    let kept: usize = meshes().map(|(mesh, edit)| mesh.face_count() - edit.faces.dropped.len()).sum();
    let has_normals = meshes().any(|(_, edit)| edit.normals.is_some() || edit.face_normals.is_some());
    let notes = vertex_normals_note(options).filter(|_| has_normals).into_iter().collect();
    Ok(Written { bytes, notes, vertices: 3 * kept as u64, ..Written::default() })
}

/// The file with its facets edited; the bytes before and after them stay.
fn edit_binary(bytes: &[u8], mesh: &Mesh, edit: &PartEdit) -> Vec<u8> {
    let mut out = Vec::with_capacity(bytes.len());
    out.extend_from_slice(&bytes[..FIRST]);
    let end = FIRST + mesh.face_count() * FACET;
    for (face, record) in bytes[FIRST..end].chunks_exact(FACET).enumerate() {
        if !edit.faces.keeps(face as u32) {
            continue;
        }
        let start = out.len();
        out.extend_from_slice(record);
        if let Some(normal) = new_normal(mesh, edit, face) {
            out[start..start + VECTOR].copy_from_slice(normal.map(f32::to_le_bytes).as_flattened());
        }
        if edit.faces.reverses(face as u32) {
            // The first corner stays the first.
            let (second, third) = out[start + 2 * VECTOR..start + 4 * VECTOR].split_at_mut(VECTOR);
            second.swap_with_slice(third);
        }
    }
    out.extend_from_slice(&bytes[end..]);
    let dropped = edit.faces.dropped.len();
    if dropped > 0 {
        let count = (mesh.face_count() - dropped) as u32;
        out[HEADER..FIRST].copy_from_slice(&count.to_le_bytes());
    }
    out
}

/// The text with its facets edited. Dropped facets are removed with the lines that nothing else is on.
fn edit_ascii<'a>(text: &[u8], edits: impl Iterator<Item = (&'a Mesh, &'a PartEdit)>) -> Vec<u8> {
    let mut copy = Copier::new(text, 8);
    for (solid, (mesh, edit)) in solids(text).iter().zip(edits) {
        for (face, facet) in solid.facets.iter().enumerate() {
            if !edit.faces.keeps(face as u32) {
                copy.skip(facet_lines(&copy, facet));
                continue;
            }
            if let Some([x, y, z]) = new_normal(mesh, edit, face) {
                copy.skip(facet.normal.clone());
                copy.out.extend_from_slice(facet.lead.as_bytes());
                push_f32(&mut copy.out, x);
                push_row(&mut copy.out, "", Storage::F32, &[y.into(), z.into()]);
            }
            if edit.faces.reverses(face as u32) {
                // The first corner stays the first.
                let spans = &solid.vertices[facet.vertices.clone()];
                for (here, there) in spans[1..].iter().zip(spans[1..].iter().rev()) {
                    copy.skip(here.clone());
                    copy.out.extend_from_slice(&copy.text[there.clone()]);
                }
            }
        }
    }
    copy.copy_to(text.len());
    copy.out
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

/// The new normal of a facet; `None` if the stored one stays: all corners keep it, or the number is equal.
fn new_normal(mesh: &Mesh, edit: &PartEdit, face: usize) -> Option<[f32; 3]> {
    let normal = stored(*edit.face_normals.as_ref()?.get(face)?);
    let range = mesh.faces().range(face);
    let corners = || range.clone().zip(&mesh.faces().corners()[range.clone()]);
    let keeps = |normals: &Column<DVec3>| {
        corners().all(|(corner, &vertex)| {
            normals.slot(corner, vertex).is_some_and(|slot| (slot as usize) < edit.kept)
        })
    };
    let (corner, &vertex) = corners().next()?;
    let current = mesh.columns().normals.as_ref().and_then(|normals| normals.get(corner, vertex));
    let is_equal = current.copied().map(stored) == Some(normal);
    (!is_equal && !edit.normals.as_ref().is_some_and(keeps)).then_some(normal)
}
