//! The analysis of one part that all findings use: how its stored normals were made, and which normals it should have.

use crate::mesh::{Column, Mesh};
use crate::normals::{FaultReason, Groups, NormalField, NormalRecipe, compute_from};
use crate::quality::angles::degrees_between;
use crate::quality::counts::{Tallies, scan};
use crate::quality::estimate::fit::estimate;
use crate::quality::estimate::recipe::Estimate;
use crate::quality::input::file::FileContext;
use crate::quality::input::part::Part;
use glam::{DMat3, DVec3};
use std::ops::Deref;

/// A part, the recipe of its stored normals, and the normals that this recipe gives.
pub(crate) struct Facts<'a> {
    part: Part<'a>,
    /// How the stored normals were made; `None` if there are none with a direction.
    pub(crate) estimate: Option<Estimate>,
    /// The rotation or reflection of all stored normals, if the estimate is of them rotated back.
    pub(crate) rotation: Option<DMat3>,
    /// The normals by the estimated recipe, or by the default one.
    pub(crate) field: NormalField,
    /// The corners whose faces cancel, ascending: the normal that they should have is unknown.
    cancelling: Vec<u32>,
    /// The stored normals of the file, if [`Part::stored`] has them transformed to the space of the mesh.
    pub(crate) written: Option<&'a Column<DVec3>>,
}

impl<'a> Deref for Facts<'a> {
    type Target = Part<'a>;

    fn deref(&self) -> &Part<'a> {
        &self.part
    }
}

impl<'a> Facts<'a> {
    pub(crate) fn new(file: &'a FileContext<'a>, number: usize) -> Self {
        Self::of(Part::new(file, number, &file.loaded.parts[number].mesh))
    }

    /// The facts about a part with a mesh whose stored normals were transformed from those of the file.
    pub(crate) fn of_transformed(written: &Facts<'a>, mesh: &'a Mesh) -> Self {
        let mut facts = Self::of(Part::new(written.file, written.number, mesh));
        facts.written = written.stored;
        facts.estimate.iter_mut().for_each(|estimate| estimate.turned = true);
        facts
    }

    fn of(mut part: Part<'a>) -> Self {
        let (estimate, rotation) =
            estimate(&part).map_or((None, None), |(estimate, rotation)| (Some(estimate), rotation));
        let has_groups = part.mesh.columns().smoothing.is_some();
        let recipe = match (estimate, part.stored) {
            (Some(estimate), _) if has_groups || !estimate.is_default() => estimate.recipe(),
            (None, Some(_)) => NormalRecipe { groups: Groups::Ignore, ..NormalRecipe::default() },
            _ => NormalRecipe::default(),
        };
        let face_field = std::mem::take(&mut part.face_field);
        let mut field = compute_from(part.mesh, &part.topology, &recipe, face_field);
        part.face_normals = std::mem::take(&mut field.face_normals);
        let faults = field.faults.corners.iter();
        let cancelling = faults.filter(|fault| fault.reason == FaultReason::CancellingFan);
        let mut cancelling: Vec<u32> = cancelling.map(|fault| fault.index).collect();
        cancelling.sort_unstable();
        Self { part, estimate, rotation, field, cancelling, written: None }
    }

    /// Whether the faces at the vertex of a corner agree, so that their mean has a meaning.
    pub(crate) fn is_judged(&self, corner: usize) -> bool {
        !self.has_reversed(corner) && !self.is_cancelling(corner)
    }

    /// Whether faces with a direction disagree at the vertex of a corner, its own face among them, without cancelling.
    pub(crate) fn is_disputed(&self, corner: usize) -> bool {
        self.has_reversed(corner) && self.has_direction(self.face_of(corner)) && !self.is_cancelling(corner)
    }

    fn has_reversed(&self, corner: usize) -> bool {
        // Facets have the normals of their own faces, whatever is next to them.
        let are_facets = !self.file.shares_vertices() && self.estimate.is_some_and(|it| it.crease.0 == 0.0);
        !are_facets && self.is_near_reversed(corner)
    }

    fn is_cancelling(&self, corner: usize) -> bool {
        !self.cancelling.is_empty() && self.cancelling.binary_search(&(corner as u32)).is_ok()
    }

    pub(crate) fn expected(&self, corner: usize) -> DVec3 {
        *self.field.normals.get(corner, self.vertex(corner)).expect("a field has a normal for every corner")
    }

    /// The normal that a corner should have, or that of its face if the faces at its vertex disagree.
    pub(crate) fn expected_or_face(&self, face: usize, corner: usize) -> DVec3 {
        if self.is_judged(corner) { self.expected(corner) } else { self.face_normal(face) }
    }

    /// The stored normal of a corner and the expected one, rotated as all stored ones are.
    pub(crate) fn stored_and_expected(&self, corner: usize) -> Option<(DVec3, DVec3)> {
        Some((self.stored_unit(corner)?, self.rotation.unwrap_or_default() * self.expected(corner)))
    }

    /// The angle between the stored normal of a corner and the expected one, in degrees.
    pub(crate) fn deviation(&self, corner: usize) -> Option<f64> {
        Some(degrees_between(self.stored_unit(corner)?, self.expected(corner)))
    }

    /// The normal that a corner is shaded with: the stored one, or the computed one.
    pub(crate) fn shaded(&self, corner: usize) -> DVec3 {
        self.stored_unit(corner).unwrap_or_else(|| self.expected(corner))
    }

    /// The angle between the normal that a corner is shaded with and its face, in degrees.
    pub(crate) fn leaning(&self, corner: usize) -> f64 {
        degrees_between(self.shaded(corner), self.face_normal(self.face_of(corner)))
    }

    /// The area that belongs to one corner of a face.
    pub(crate) fn corner_area(&self, face: usize) -> f64 {
        self.area[face] / self.corners_of(face).len() as f64
    }

    pub(crate) fn scan_faces<K: Copy + PartialEq + Send>(
        &self,
        search: impl Fn(usize, &mut Tallies<K>) + Sync,
    ) -> Tallies<K> {
        scan(self.mesh.face_count(), self.thresholds.places, |faces, found| {
            faces.for_each(|face| search(face, found));
        })
    }

    pub(crate) fn scan_corners<K: Copy + PartialEq + Send>(
        &self,
        search: impl Fn(usize, usize, &mut Tallies<K>) + Sync,
    ) -> Tallies<K> {
        self.scan_faces(|face, found| {
            self.corners_of(face).for_each(|corner| search(face, corner, found));
        })
    }
}
