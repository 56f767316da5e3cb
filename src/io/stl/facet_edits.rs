//! The edit of each facet.

use crate::io::{Loaded, PartEdit};
use crate::mesh::Mesh;
use glam::DVec3;

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
