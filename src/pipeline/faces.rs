//! Faces turned and left out, and the way back to the numbers of the mesh as it was read.

use super::Task;
use crate::io::{Part, PartEdit};
use crate::mesh::{Column, ColumnIndex, FaceEdit, Mesh, NONE, Orientation};
use crate::normals::{LENGTH_TOLERANCE, Selection};
use crate::num::UnitVec3;
use glam::DVec3;
use std::borrow::Cow;

/// A part with its faces as they will stand in the output.
pub(super) struct Turned<'a> {
    /// The mesh that normals are computed on.
    pub(super) mesh: Cow<'a, Mesh>,
    /// What orientation found, without the list of faces; `None` if it was not asked for.
    pub(super) orientation: Option<Orientation>,
    faces: FaceEdit,
    /// Faces of the mesh as it was read.
    count: usize,
}

impl<'a> Turned<'a> {
    pub(super) fn new(part: &'a Part, mut orientation: Option<Orientation>, task: &Task) -> Self {
        let count = part.mesh.face_count();
        let mut faces = FaceEdit { dropped: part.non_finite_faces.clone(), reversed: Vec::new() };
        if let Some(found) = &mut orientation {
            let numbers = as_read(&faces, count);
            let reversed = std::mem::take(&mut found.reversed);
            found.reversed_open.clear();
            found.room_faces.clear();
            faces.reversed = reversed.into_iter().map(|face| numbers[face as usize]).collect();
        }
        if task.flip {
            faces.reversed =
                as_read(&faces, count).into_iter().filter(|&face| !faces.reverses(face)).collect();
        }
        let mut mesh = applied(&part.mesh, &faces);
        if let Some(stored) = mesh.columns().normals.as_ref().filter(|_| task.flip) {
            let turned = opposite(stored, &mesh);
            mesh = Cow::Owned(mesh.into_owned().with_normals(Some(turned)));
        }
        Self { mesh, orientation, faces, count }
    }

    /// The numbers that some faces of the turned mesh, ascending, had when they were read.
    pub(super) fn as_read(&self, faces: impl Iterator<Item = u32>) -> Vec<u32> {
        let mut dropped = self.faces.dropped.iter().peekable();
        let mut before = 0;
        let number = |face: u32| {
            while dropped.next_if(|&&dropped| dropped <= face + before).is_some() {
                before += 1;
            }
            face + before
        };
        faces.map(number).collect()
    }

    /// Whether a face, in the numbers of the mesh as it was read, is turned round.
    pub(super) fn reverses(&self, face: u32) -> bool {
        self.faces.reverses(face)
    }

    /// Values of the turned mesh's faces, one for each face as it was read. What is left out gets +z.
    pub(super) fn faces_as_read(&self, normals: Vec<DVec3>) -> Vec<DVec3> {
        if self.faces.dropped.is_empty() {
            return normals;
        }
        let mut all = vec![DVec3::Z; self.count];
        for (face, normal) in as_read(&self.faces, self.count).into_iter().zip(normals) {
            all[face as usize] = normal;
        }
        all
    }

    /// Leaves faces of the turned mesh out as well, given in ascending order.
    pub(super) fn leave_out(&mut self, dropped: Vec<u32>) {
        let numbers = as_read(&self.faces, self.count);
        let faces = &mut self.faces;
        faces.dropped.extend(dropped.iter().map(|&face| numbers[face as usize]));
        faces.dropped.sort_unstable();
        faces.reversed.retain(|face| faces.dropped.binary_search(face).is_err());
        self.mesh = Cow::Owned(self.mesh.with_faces(&FaceEdit { dropped, reversed: Vec::new() }));
    }

    /// The change of the part.
    pub(super) fn edit(self, part: &Part, selection: Selection, task: &Task) -> PartEdit {
        let is_as_stored = selection.is_as_stored(task.when) && !task.flip;
        let Selection { normals, kept, mut morph_normals, .. } = selection;
        // Turned values are no longer those of the file.
        let kept = if task.flip { 0 } else { kept };
        let mut normals = (!is_as_stored).then(|| self.corners_as_read(part, normals));
        let faces = self.faces;
        if let Some(normals) = normals.as_mut().filter(|_| !faces.dropped.is_empty()) {
            forget_dropped(normals, &mut morph_normals, kept, &faces, &part.mesh);
        }
        PartEdit { faces, normals, kept, face_normals: None, morph_normals }
    }

    /// A column of the turned mesh with the corners of the mesh as it was read.
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

/// The mesh with some of its faces left out or turned.
pub(super) fn applied<'a>(mesh: &'a Mesh, faces: &FaceEdit) -> Cow<'a, Mesh> {
    if faces.is_empty() { Cow::Borrowed(mesh) } else { Cow::Owned(mesh.with_faces(faces)) }
}

/// Stored normals turned round. They become new values of the file, so lengths that are wrong are divided by, and what has
/// no direction is left out, and counts as missing.
fn opposite(stored: &Column<DVec3>, mesh: &Mesh) -> Column<DVec3> {
    let turn = |normal: &DVec3| match (normal.length() - 1.0).abs() <= LENGTH_TOLERANCE {
        true => Some(-*normal),
        false => UnitVec3::new(-*normal).map(UnitVec3::get),
    };
    let turned: Vec<Option<DVec3>> = stored.values.iter().map(turn).collect();
    let mut index = stored.corner_index(mesh.faces().corners());
    for slot in index.iter_mut().filter(|slot| **slot != NONE) {
        if turned[*slot as usize].is_none() {
            *slot = NONE;
        }
    }
    Column::per_corner(turned.into_iter().map(|normal| normal.unwrap_or(DVec3::Z)).collect(), index)
}

/// The number that each remaining face had.
fn as_read(faces: &FaceEdit, count: usize) -> Vec<u32> {
    let mut dropped = faces.dropped.iter().peekable();
    (0..count as u32).filter(|face| dropped.next_if_eq(&face).is_none()).collect()
}

/// Leaves out the new values that only dropped faces used, so that no writer stores them.
fn forget_dropped(
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
    let mut used = vec![false; normals.values.len()];
    used[..kept].fill(true);
    for &slot in index.iter().filter(|&&slot| slot != NONE) {
        used[slot as usize] = true;
    }
    let mut next = 0;
    let places: Vec<u32> = used
        .iter()
        .map(|&used| {
            let place = next;
            next += u32::from(used);
            place
        })
        .collect();
    for slot in index.iter_mut().filter(|slot| **slot != NONE) {
        *slot = places[*slot as usize];
    }
    for values in morph_normals.iter_mut().chain([&mut normals.values]) {
        let mut used = used.iter();
        values.retain(|_| *used.next().expect("one mark a value"));
    }
}
