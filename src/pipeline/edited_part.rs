//! A part with faces reversed and dropped, and the way back to the numbers of the mesh as it was read.

use super::task::Task;
use crate::io::{Part, PartEdit};
use crate::mesh::{Column, ColumnIndex, FaceEdit, Mesh, NONE, Orientation};
use crate::normals::{LENGTH_TOLERANCE, Selection};
use crate::num::UnitVec3;
use glam::DVec3;
use std::borrow::Cow;

/// A part with the faces of the output.
pub(super) struct EditedPart<'a> {
    /// The mesh that normals are computed on.
    pub(super) mesh: Cow<'a, Mesh>,
    /// What orientation found, without the list of faces; `None` if it was not asked for.
    pub(super) orientation: Option<Orientation>,
    faces: FaceEdit,
    /// Faces of the mesh as it was read.
    count: usize,
}

impl<'a> EditedPart<'a> {
    pub(super) fn new(part: &'a Part, mut orientation: Option<Orientation>, task: &Task) -> Self {
        let count = part.mesh.face_count();
        let mut faces = FaceEdit { dropped: part.non_finite_faces.clone(), reversed: Vec::new() };
        if let Some(found) = &mut orientation {
            let reversed = std::mem::take(&mut found.reversed);
            found.reversed_open.clear();
            found.room_faces.clear();
            faces.reversed = as_read(&faces.dropped, reversed);
        }
        if task.flip {
            let kept = (0..count as u32).filter(|&face| faces.keeps(face) && !faces.reverses(face));
            faces.reversed = kept.collect();
        }
        let mut mesh = applied(&part.mesh, &faces);
        if let Some(stored) = mesh.columns().normals.as_ref().filter(|_| task.flip) {
            let reversed = opposite(stored, &mesh);
            mesh = Cow::Owned(mesh.into_owned().with_normals(Some(reversed)));
        }
        Self { mesh, orientation, faces, count }
    }

    /// The numbers that ascending faces of the edited mesh had when they were read.
    pub(super) fn as_read(&self, faces: impl IntoIterator<Item = u32>) -> Vec<u32> {
        as_read(&self.faces.dropped, faces)
    }

    /// Whether a face, in the numbers of the mesh as it was read, is reversed.
    pub(super) fn reverses(&self, face: u32) -> bool {
        self.faces.reverses(face)
    }

    /// Normals of the edited mesh's faces, one for each face as it was read: +z for dropped ones.
    pub(super) fn faces_as_read(&self, normals: Vec<DVec3>) -> Vec<DVec3> {
        if self.faces.dropped.is_empty() {
            return normals;
        }
        let mut all = vec![DVec3::Z; self.count];
        for (face, normal) in self.as_read(0..normals.len() as u32).into_iter().zip(normals) {
            all[face as usize] = normal;
        }
        all
    }

    /// Drops more faces, given as ascending faces of the edited mesh.
    pub(super) fn drop_faces(&mut self, dropped: Vec<u32>) {
        let numbers = self.as_read(dropped.iter().copied());
        let faces = &mut self.faces;
        faces.dropped.extend(numbers);
        faces.dropped.sort_unstable();
        faces.reversed.retain(|face| faces.dropped.binary_search(face).is_err());
        self.mesh = Cow::Owned(self.mesh.with_faces(&FaceEdit { dropped, reversed: Vec::new() }));
    }

    /// The change of the part.
    pub(super) fn edit(self, part: &Part, selection: Selection, task: &Task) -> PartEdit {
        let is_as_stored = selection.is_as_stored(task.when) && !task.flip;
        let Selection { normals, kept, mut morph_normals, .. } = selection;
        // EditedPart values are no longer those of the file.
        let kept = if task.flip { 0 } else { kept };
        let mut normals = (!is_as_stored).then(|| self.corners_as_read(part, normals));
        let faces = self.faces;
        if let Some(normals) = normals.as_mut().filter(|_| !faces.dropped.is_empty()) {
            remove_unused(normals, &mut morph_normals, kept, &faces, &part.mesh);
        }
        PartEdit { faces, normals, kept, face_normals: None, morph_normals }
    }

    /// A column of the edited mesh with the corners of the mesh as it was read.
    fn corners_as_read(&self, part: &Part, column: Column<DVec3>) -> Column<DVec3> {
        let ColumnIndex::PerCorner(index) = &column.index else { return column };
        if self.faces.is_empty() {
            return column;
        }
        let (_, order) = self.faces.corner_order(part.mesh.faces());
        let mut all = vec![NONE; part.mesh.faces().corner_count()];
        for (&corner, &slot) in order.iter().zip(index) {
            all[corner as usize] = slot;
        }
        Column::per_corner(column.values, all)
    }
}

/// The mesh with some of its faces dropped or reversed.
pub(super) fn applied<'a>(mesh: &'a Mesh, faces: &FaceEdit) -> Cow<'a, Mesh> {
    if faces.is_empty() { Cow::Borrowed(mesh) } else { Cow::Owned(mesh.with_faces(faces)) }
}

/// The stored normals reversed. They become new values of the file, so wrong lengths are normalised, and those without a
/// direction become missing.
fn opposite(stored: &Column<DVec3>, mesh: &Mesh) -> Column<DVec3> {
    let reverse = |normal: &DVec3| match (normal.length() - 1.0).abs() <= LENGTH_TOLERANCE {
        true => Some(-*normal),
        false => UnitVec3::new(-*normal).map(UnitVec3::get),
    };
    let reversed: Vec<Option<DVec3>> = stored.values.iter().map(reverse).collect();
    let mut index = stored.corner_index(mesh.faces().corners());
    for slot in index.iter_mut().filter(|slot| **slot != NONE) {
        if reversed[*slot as usize].is_none() {
            *slot = NONE;
        }
    }
    Column::per_corner(reversed.into_iter().map(|normal| normal.unwrap_or(DVec3::Z)).collect(), index)
}

/// The numbers that ascending faces had before others were dropped.
fn as_read(dropped: &[u32], faces: impl IntoIterator<Item = u32>) -> Vec<u32> {
    let mut dropped = dropped.iter().peekable();
    let mut before = 0;
    let number = |face: u32| {
        while dropped.next_if(|&&dropped| dropped <= face + before).is_some() {
            before += 1;
        }
        face + before
    };
    faces.into_iter().map(number).collect()
}

/// Removes the new values that only dropped faces used, so that no writer stores them.
fn remove_unused(
    normals: &mut Column<DVec3>,
    morph_normals: &mut [Vec<DVec3>],
    kept: usize,
    faces: &FaceEdit,
    mesh: &Mesh,
) {
    let ColumnIndex::PerCorner(index) = &mut normals.index else { return };
    for &face in &faces.dropped {
        index[mesh.faces().range(face as usize)].fill(NONE);
    }
    // The new number of each value; NONE if it is unused.
    let mut numbers = vec![NONE; normals.values.len()];
    numbers[..kept].fill(0);
    for &slot in index.iter().filter(|&&slot| slot != NONE) {
        numbers[slot as usize] = 0;
    }
    for (next, number) in (0..).zip(numbers.iter_mut().filter(|number| **number != NONE)) {
        *number = next;
    }
    for slot in index.iter_mut().filter(|slot| **slot != NONE) {
        *slot = numbers[*slot as usize];
    }
    for values in morph_normals.iter_mut().chain([&mut normals.values]) {
        let mut numbers = numbers.iter();
        values.retain(|_| numbers.next() != Some(&NONE));
    }
}
