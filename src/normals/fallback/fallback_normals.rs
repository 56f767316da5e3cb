//! Fallback normals where sums have no direction: always a finite unit vector, by one documented chain, and always counted.
//!
//! A corner without a normal of its own takes the first of these that exists:
//! 1. the unit sum of the face normals of its fan, across creases and marked edges (for a corner that no edge
//!    joins to others: of all faces at its vertex);
//! 2. the unit sum of the normals of the faces across the edges of its group's faces;
//! 3. of the face normals that cancelled, the first by lexicographic value, so that the choice does not depend on
//!    how faces are numbered;
//! 4. +Z.
//!
//! A face without a normal takes the unit sum of its edge neighbours, else +Z.

use crate::mesh::{FacesRef, Link, Mesh, Topology};
use crate::normals::faces::face_normals::{FaceNormals, face_normals};
use crate::normals::faces::shape::FaceState;
use crate::normals::fallback::neighbours::{LAST_RESORT, lexicographic};
use crate::normals::fault::{Fault, FaultReason};
use crate::normals::recipe::Slivers;
use crate::normals::slices::vertex_normals::fault_reason;
use crate::normals::sums::corner_mean::uniform_mean;
use crate::normals::sums::request::SlotState;
use crate::num::parallel;
use glam::DVec3;
use rustc_hash::FxHashMap;

/// Computes fallback normals. Each fan is summed once.
pub(crate) struct FallbackNormals<'a> {
    faces: FacesRef<'a>,
    topology: &'a Topology,
    normals: &'a FaceNormals,
    /// Number of the fan of each corner met so far.
    fan_of: FxHashMap<u32, usize>,
    fans: Vec<FanSum>,
}

#[derive(Clone, Copy)]
struct FanSum {
    unit: Option<DVec3>,
    first: Option<DVec3>,
}

impl<'a> FallbackNormals<'a> {
    pub(crate) fn new(faces: FacesRef<'a>, topology: &'a Topology, normals: &'a FaceNormals) -> Self {
        Self { faces, topology, normals, fan_of: FxHashMap::default(), fans: Vec::new() }
    }

    /// Computes the normals of all slots whose sum has no direction; `target` is the slot of each corner. Returns the slots,
    /// ascending, with the reason.
    pub(crate) fn for_slots(
        &mut self,
        target: &[u32],
        state: &[SlotState],
        mut set: impl FnMut(usize, DVec3),
    ) -> Vec<(u32, FaultReason)> {
        if parallel::all(state, |state| state.has_normal()) {
            return Vec::new();
        }
        let corners = target.iter().enumerate();
        let mut undefined: Vec<(u32, u32)> = corners
            .filter(|&(_, &slot)| !state[slot as usize].has_normal())
            .map(|(corner, &slot)| (slot, corner as u32))
            .collect();
        undefined.sort_unstable();
        let mut fallbacks = Vec::new();
        for slot in undefined.chunk_by(|a, b| a.0 == b.0) {
            let corners: Vec<u32> = slot.iter().map(|&(_, corner)| corner).collect();
            let number = slot[0].0;
            let reason = match state[number as usize] {
                SlotState::Cancelling => FaultReason::CancellingFan,
                _ => self.reason(corners[0]),
            };
            set(number as usize, self.for_corners(&corners));
            fallbacks.push((number, reason));
        }
        fallbacks
    }

    /// The normal of a group of corners.
    fn for_corners(&mut self, corners: &[u32]) -> DVec3 {
        let mut first: Option<DVec3> = None;
        for &corner in corners {
            let fan = self.fan(corner);
            if let Some(unit) = fan.unit {
                return unit;
            }
            first = [first, fan.first].into_iter().flatten().min_by(lexicographic);
        }
        let mut faces: Vec<u32> = corners.iter().map(|&corner| self.topology.face_of(corner)).collect();
        faces.sort_unstable();
        faces.dedup();
        self.across_edges(&faces).or(first).unwrap_or(LAST_RESORT)
    }

    /// The normal for a face without direction.
    pub(crate) fn for_face(&self, face: u32) -> DVec3 {
        self.across_edges(&[face]).unwrap_or(LAST_RESORT)
    }

    /// What is wrong with a group that no face gives a direction.
    fn reason(&self, corner: u32) -> FaultReason {
        let state = self.normals.state[self.topology.face_of(corner) as usize];
        fault_reason(state).unwrap_or(FaultReason::ZeroArea)
    }

    fn fan(&mut self, corner: u32) -> FanSum {
        if let Some(&known) = self.fan_of.get(&corner) {
            return self.fans[known];
        }
        let mut members = self.fan_corners(corner);
        let mut sum = self.sum(&members);
        if sum.first.is_none() {
            members = self.topology.corners_at(self.faces.corners()[corner as usize]).to_vec();
            sum = self.sum(&members);
        }
        members.push(corner);
        for member in members {
            self.fan_of.entry(member).or_insert(self.fans.len());
        }
        self.fans.push(sum);
        sum
    }

    /// The corners that the surface joins to one around its vertex, in both directions.
    fn fan_corners(&self, start: u32) -> Vec<u32> {
        let mut corners = vec![start];
        let mut corner = start;
        while let Some(across) = self.topology.across(corner) {
            corner = self.topology.next(across);
            if corner == start {
                return corners;
            }
            corners.push(corner);
        }
        corner = start;
        while let Some(across) = self.topology.across(self.topology.previous(corner)) {
            corner = across;
            corners.push(corner);
        }
        corners
    }

    fn sum(&self, corners: &[u32]) -> FanSum {
        let mut faces: Vec<u32> = corners.iter().map(|&corner| self.topology.face_of(corner)).collect();
        faces.sort_unstable();
        faces.dedup();
        let directions: Vec<DVec3> = faces.iter().filter_map(|&face| self.direction(face)).collect();
        FanSum { unit: unit_sum(&directions), first: directions.into_iter().min_by(lexicographic) }
    }

    fn across_edges(&self, faces: &[u32]) -> Option<DVec3> {
        let mut neighbours = Vec::new();
        for &face in faces {
            for half_edge in self.faces.range(face as usize) {
                if let Link::Twin(other) | Link::Welded(other) = self.topology.link(half_edge as u32) {
                    neighbours.push(self.topology.face_of(other));
                }
            }
        }
        neighbours.sort_unstable();
        let directions: Vec<DVec3> = neighbours.iter().filter_map(|&face| self.direction(face)).collect();
        unit_sum(&directions)
    }

    fn direction(&self, face: u32) -> Option<DVec3> {
        self.normals.state[face as usize].has_direction().then(|| self.normals.unit[face as usize])
    }
}

/// The unit sum of unit vectors, unless they cancel.
fn unit_sum(directions: &[DVec3]) -> Option<DVec3> {
    let (sum, state) = uniform_mean(directions.iter().copied());
    (state == SlotState::Good).then_some(sum)
}

/// The faults of faces: those that add nothing to sums.
pub(crate) fn face_faults(normals: &FaceNormals, slivers: Slivers) -> Vec<Fault> {
    let kept = |state: FaceState| state == FaceState::Sliver && slivers == Slivers::Keep;
    let faults = normals.state.iter().enumerate().filter(|&(_, &state)| !kept(state));
    faults
        .filter_map(|(i, &state)| fault_reason(state).map(|reason| Fault { index: i as u32, reason }))
        .collect()
}

/// The corners of groups with a fallback normal, which are given ascending, with the reason.
pub(crate) fn corner_faults(corner_group: &[u32], fallbacks: &[(u32, FaultReason)]) -> Vec<Fault> {
    let corners = corner_group.iter().enumerate().filter(|_| !fallbacks.is_empty());
    let fault = |(corner, group): (usize, &u32)| {
        let found = fallbacks.binary_search_by_key(group, |&(group, _)| group).ok()?;
        Some(Fault { index: corner as u32, reason: fallbacks[found].1 })
    };
    corners.filter_map(fault).collect()
}

/// The normals of the faces of a mesh, as [`compute_on`](crate::normals::compute_on) gives them.
#[derive(Clone, Debug, Default)]
pub(crate) struct FaceField(FaceNormals);

impl FaceField {
    /// Of a mesh unchanged, faithful.
    pub(crate) fn new(mesh: &Mesh, topology: &Topology) -> Self {
        Self::with_fallbacks(mesh, topology, face_normals(mesh.faces().view(), mesh.positions()))
    }

    /// Adds fallback normals for faces without a direction.
    pub(in crate::normals) fn with_fallbacks(
        mesh: &Mesh,
        topology: &Topology,
        mut faces: FaceNormals,
    ) -> Self {
        let fallbacks = FallbackNormals::new(mesh.faces().view(), topology, &faces);
        let undefined = (0..faces.unit.len() as u32).filter(|&face| fallbacks.direction(face).is_none());
        let normals: Vec<(u32, DVec3)> = undefined.map(|face| (face, fallbacks.for_face(face))).collect();
        normals.into_iter().for_each(|(face, normal)| faces.unit[face as usize] = normal);
        Self(faces)
    }

    /// The unit normal of every face.
    pub(crate) fn units(&self) -> &[DVec3] {
        &self.0.unit
    }

    /// The unit normal of every face, without the rest.
    pub(in crate::normals) fn into_units(self) -> Vec<DVec3> {
        self.0.unit
    }

    /// What is wrong with faces.
    pub(crate) fn faults(&self) -> Vec<Fault> {
        face_faults(&self.0, Slivers::default())
    }

    /// The zero vector where there is no direction.
    pub(in crate::normals) fn into_computed(mut self) -> FaceNormals {
        for (unit, _) in self.0.unit.iter_mut().zip(&self.0.state).filter(|(_, state)| !state.has_direction())
        {
            *unit = DVec3::ZERO;
        }
        self.0
    }
}
