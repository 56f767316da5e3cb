//! Which of the stored and the computed normals go into the output.

use super::{ReplacedCounts, Task};
use crate::mesh::{Column, Mesh};
use crate::normals::{FaultReason, NormalField, Replacement, When, replace};
use glam::DVec3;

/// Normals of the turned mesh.
pub(super) struct Selected {
    /// One index a corner; `None` if the stored ones stay.
    pub(super) normals: Option<Column<DVec3>>,
    /// How many values, from the front, are the file's own.
    pub(super) kept: usize,
    /// For each morph target, one normal a value.
    pub(super) morph_normals: Vec<Vec<DVec3>>,
    /// One normal a face.
    pub(super) face_normals: Vec<DVec3>,
    /// Faces whose area is exactly zero.
    pub(super) zero_area: Vec<u32>,
    /// Corners that keep their stored normal.
    pub(super) kept_corners: usize,
    /// Corners that do not, and why.
    pub(super) replaced: ReplacedCounts,
}

pub(super) fn select(mesh: &Mesh, field: NormalField, task: &Task) -> Selected {
    let zero_area = field.faults.faces.iter().filter(|fault| fault.reason == FaultReason::ZeroArea);
    let zero_area = zero_area.map(|fault| fault.index).collect();
    if task.when == When::Always {
        let NormalField { normals, morph_normals, face_normals, .. } = field;
        let (kept_corners, replaced) = (0, ReplacedCounts::default());
        let normals = Some(normals);
        return Selected { normals, kept: 0, morph_normals, face_normals, zero_area, kept_corners, replaced };
    }
    let replacement = replace(mesh, &field, task.when);
    let replaced = ReplacedCounts::of(&replacement);
    let morph_normals = morph_normals(mesh, &field, &replacement);
    let face_normals = face_normals(mesh, &field, &replacement);
    let unchanged = replacement.is_empty() && !task.flip;
    Selected {
        kept_corners: mesh.faces().corner_count() - replaced.total(),
        // Turned values are no longer those of the file.
        kept: if task.flip { 0 } else { replacement.kept },
        normals: (!unchanged).then_some(replacement.normals),
        morph_normals,
        face_normals,
        zero_area,
        replaced,
    }
}

/// The normals of morphed shapes for every value: that of its entry, or, for a stored value, of the entry of the
/// first corner that uses it.
fn morph_normals(mesh: &Mesh, field: &NormalField, replacement: &Replacement) -> Vec<Vec<DVec3>> {
    if field.morph_normals.is_empty() {
        return Vec::new();
    }
    let mut entry_of_value = vec![0; replacement.kept];
    entry_of_value.extend_from_slice(&replacement.entries);
    for (corner, &vertex) in mesh.faces().corners().iter().enumerate().rev() {
        let value =
            replacement.normals.slot(corner, vertex).filter(|&value| (value as usize) < replacement.kept);
        if let (Some(value), Some(entry)) = (value, field.normals.slot(corner, vertex)) {
            entry_of_value[value as usize] = entry;
        }
    }
    let pick = |shape: &Vec<DVec3>| entry_of_value.iter().map(|&entry| shape[entry as usize]).collect();
    field.morph_normals.iter().map(pick).collect()
}

/// Facet normals: the stored one where all corners of a face share it and keep it, as those of an STL file do,
/// else the computed one.
fn face_normals(mesh: &Mesh, field: &NormalField, replacement: &Replacement) -> Vec<DVec3> {
    let corners = mesh.faces().corners();
    let stored = |range: std::ops::Range<usize>| {
        let mut slots = range.map(|corner| replacement.normals.slot(corner, corners[corner]));
        let first = slots.next()?.filter(|&slot| (slot as usize) < replacement.kept)?;
        slots.all(|slot| slot == Some(first)).then(|| replacement.normals.values[first as usize])
    };
    let ranges = mesh.faces().ranges().zip(&field.face_normals);
    ranges.map(|(range, &computed)| stored(range).unwrap_or(computed)).collect()
}
