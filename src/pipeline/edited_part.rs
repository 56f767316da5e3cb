//! A part with faces reversed and dropped, and the way back to the numbers of the mesh as it was read.

use super::outcome::{FaultPlace, MOST_PLACES, Spot};
use super::task::Task;
use crate::io::{Part, PartEdit};
use crate::mesh::{Column, ColumnIndex, FaceEdit, Mesh, NONE, Orientation};
use crate::normals::{Broken, Fault, Faults, LENGTH_TOLERANCE, Selection};
use crate::num::{UnitVec3, parallel};
use glam::DVec3;
use std::borrow::Cow;

/// A part with the faces of the output.
pub(super) struct EditedPart<'a> {
    /// The mesh that normals are computed on.
    pub(super) mesh: Cow<'a, Mesh>,
    /// What orientation found, without the list of faces; `None` if it was not asked for.
    pub(super) orientation: Option<Orientation>,
    /// Whether the mesh has shared vertices in place of separate triangles.
    pub(super) has_shared_vertices: bool,
    faces: FaceEdit,
    /// The mesh as it was read.
    read: &'a Mesh,
}

impl<'a> EditedPart<'a> {
    pub(super) fn new(part: &'a Part, mut orientation: Option<Orientation>, task: &Task) -> Self {
        let read = &part.mesh;
        let mut faces = FaceEdit { dropped: part.non_finite_faces.clone(), reversed: Vec::new() };
        if let Some(found) = &mut orientation {
            let reversed = std::mem::take(&mut found.reversed);
            found.reversed_open.clear();
            found.room_faces.clear();
            faces.reversed = as_read(&faces.dropped, reversed);
        }
        if task.flip {
            let kept =
                (0..read.face_count() as u32).filter(|&face| faces.keeps(face) && !faces.reverses(face));
            faces.reversed = kept.collect();
        }
        let mut mesh = applied(read, &faces);
        if let Some(stored) = mesh.columns().normals.as_ref().filter(|_| task.flip) {
            let reversed = opposite(stored, &mesh);
            mesh = Cow::Owned(mesh.into_owned().with_normals(Some(reversed)));
        }
        Self { mesh, orientation, has_shared_vertices: false, faces, read }
    }

    /// Gives separate triangles the vertices that they have in common by position, unless one then has fewer than three. Their
    /// corners stay the same, and so do the normals, which each position then has once.
    pub(super) fn share_vertices(&mut self) {
        if !self.mesh.is_soup() || self.mesh.has_vertex_attributes() {
            return;
        }
        let shared = self.mesh.as_ref().clone().with_shared_vertices();
        let (triangles, _) = shared.faces().corners().as_chunks();
        let is_collapsed = |&[a, b, c]: &[u32; 3]| a == b || b == c || c == a;
        if parallel::position(triangles, is_collapsed).is_none() {
            self.has_shared_vertices = true;
            self.mesh = Cow::Owned(shared);
        }
    }

    /// Normals of the edited mesh's faces, one for each face as it was read: +z for dropped ones.
    pub(super) fn faces_as_read(&self, normals: Vec<DVec3>) -> Vec<DVec3> {
        if self.faces.dropped.is_empty() {
            return normals;
        }
        let mut all = vec![DVec3::Z; self.read.face_count()];
        for (face, normal) in as_read(&self.faces.dropped, 0..normals.len() as u32).into_iter().zip(normals) {
            all[face as usize] = normal;
        }
        all
    }

    /// Drops more faces, given as ascending faces of the edited mesh.
    pub(super) fn drop_faces(&mut self, dropped: Vec<u32>) {
        let numbers = as_read(&self.faces.dropped, dropped.iter().copied());
        let faces = &mut self.faces;
        faces.dropped.extend(numbers);
        faces.dropped.sort_unstable();
        faces.reversed.retain(|face| faces.dropped.binary_search(face).is_err());
        self.mesh = Cow::Owned(self.mesh.with_faces(&FaceEdit { dropped, reversed: Vec::new() }));
    }

    /// The change of the part.
    pub(super) fn edit(self, selection: Selection, task: &Task) -> PartEdit {
        let is_as_stored = selection.is_as_stored(task.when) && !task.flip;
        let Selection { mut normals, kept, mut morph_normals, .. } = selection;
        if self.has_shared_vertices {
            sort_by_corner(&mut normals);
        }
        if self.faces.is_empty() {
            store_per_vertex(&mut normals, self.read);
        }
        // Reversed values are no longer those of the file.
        let kept = if task.flip { 0 } else { kept };
        let mut normals = (!is_as_stored).then(|| self.corners_as_read(normals));
        if let Some(normals) = normals.as_mut().filter(|_| !self.faces.dropped.is_empty()) {
            remove_unused(normals, &mut morph_normals, kept);
        }
        PartEdit { faces: self.faces, normals, kept, face_normals: None, morph_normals }
    }

    /// A column of the edited mesh with the corners of the mesh as it was read; those of dropped faces have no value.
    fn corners_as_read(&self, column: Column<DVec3>) -> Column<DVec3> {
        let ColumnIndex::PerCorner(index) = &column.index else { return column };
        if self.faces.is_empty() {
            return column;
        }
        let (_, order) = self.faces.corner_order(self.read.faces());
        let mut all = vec![NONE; self.read.faces().corner_count()];
        for (&corner, &slot) in order.iter().zip(index) {
            all[corner as usize] = slot;
        }
        Column::per_corner(column.values, all)
    }

    /// The places of the first faults of each kind of element: faces, corners, vertices, [`MOST_PLACES`] of each.
    pub(super) fn fault_places(&self, faults: &Faults) -> Vec<FaultPlace> {
        let first = |list: &[Fault]| list[..list.len().min(MOST_PLACES)].to_vec();
        let indices = |list: &[Fault]| list.iter().map(|fault| fault.index).collect::<Vec<_>>();
        let (faces, corners, vertices) =
            (first(&faults.faces), first(&faults.corners), first(&faults.vertices));
        let spots = as_read(&self.faces.dropped, indices(&faces)).into_iter().map(Spot::Face);
        let spots = spots.chain(self.corner_spots(indices(&corners)));
        let spots = spots.chain(indices(&vertices).into_iter().map(Spot::Vertex));
        let all = [faces, corners, vertices].concat();
        spots.zip(&all).map(|(spot, fault)| FaultPlace { spot, reason: fault.reason.name() }).collect()
    }

    /// The places of the first corners whose stored normals are broken.
    pub(super) fn broken_places(&self, broken: &[(u32, Broken)]) -> Vec<FaultPlace> {
        let first = &broken[..broken.len().min(MOST_PLACES)];
        let spots = self.corner_spots(first.iter().map(|&(corner, _)| corner));
        let place = |(spot, (_, cause)): (Spot, &(u32, Broken))| FaultPlace { spot, reason: cause.name() };
        spots.into_iter().zip(first).map(place).collect()
    }

    /// The places of ascending corners of the edited mesh.
    fn corner_spots(&self, corners: impl IntoIterator<Item = u32>) -> Vec<Spot> {
        let mut ranges = (0..).zip(self.mesh.faces().ranges()).peekable();
        let within = corners.into_iter().filter_map(|corner| {
            while ranges.next_if(|(_, range)| range.end <= corner as usize).is_some() {}
            ranges.peek().map(|(face, range)| (*face, corner - range.start as u32))
        });
        let (faces, places): (Vec<u32>, Vec<u32>) = within.unzip();
        let spot = |(face, place): (u32, u32)| {
            let vertices = self.read.faces().face(face as usize);
            let corner = match place {
                // The first corner of a reversed face stays the first.
                1.. if self.faces.reverses(face) => vertices.len() as u32 - place,
                place => place,
            };
            Spot::Corner { face, corner, vertex: vertices[corner as usize] }
        };
        as_read(&self.faces.dropped, faces).into_iter().zip(places).map(spot).collect()
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

/// Frees the indices of values that have the numbers of their vertices.
fn store_per_vertex(column: &mut Column<DVec3>, mesh: &Mesh) {
    let corners = mesh.faces().corners();
    let is_numbered_so =
        |index: &ColumnIndex| matches!(index, ColumnIndex::PerCorner(index) if index == corners);
    if column.values.len() == mesh.vertex_count() && is_numbered_so(&column.index) {
        column.index = ColumnIndex::PerVertex;
    }
}

/// Sorts values by the first corner that has each, the order in which separate triangles have theirs.
fn sort_by_corner(column: &mut Column<DVec3>) {
    let ColumnIndex::PerCorner(index) = &mut column.index else { return };
    let mut number = vec![NONE; column.values.len()];
    let mut values = Vec::with_capacity(column.values.len());
    for slot in index.iter_mut().filter(|slot| **slot != NONE) {
        let number = &mut number[*slot as usize];
        if *number == NONE {
            *number = values.len() as u32;
            values.push(column.values[*slot as usize]);
        }
        *slot = *number;
    }
    column.values = values;
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
fn remove_unused(normals: &mut Column<DVec3>, morph_normals: &mut [Vec<DVec3>], kept: usize) {
    let ColumnIndex::PerCorner(index) = &mut normals.index else { return };
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
