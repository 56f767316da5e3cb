//! Vertices where several fans touch, poles of many faces, and fans whose normals cancel.

use crate::mesh::Link;
use crate::normals::{FaultReason, Weight};
use crate::quality::effect::key_light_lost;
use crate::quality::estimate::means::term;
use crate::quality::findings::prelude::*;
use glam::DVec3;

pub(crate) fn search(facts: &Facts<'_>, found: &mut Found) {
    found.merge(scan(facts.mesh.vertex_count(), facts.thresholds.places, |vertices, found| {
        for vertex in vertices {
            let valence = facts.topology.corners_at(vertex as u32).len();
            if valence as u64 > u64::from(facts.thresholds.valence) {
                found.add(Kind::HighValence, Spot::vertex(vertex).of(Measure::Amount, valence as f64), 0.0);
            }
            if is_pinched(facts, vertex as u32) {
                let spot = Spot::vertex(vertex).by(index_mean_error(facts, vertex as u32));
                found.add(Kind::PinchedVertices, spot, 0.0);
            }
        }
    }));
}

pub(crate) fn search_cancelling(facts: &Facts<'_>, found: &mut Found) {
    let faults = facts.field.faults.corners.iter();
    for fault in faults.filter(|fault| fault.reason == FaultReason::CancellingFan) {
        let face = facts.topology.face_of(fault.index) as usize;
        let spot = Spot::corner(face, fault.index as usize, 0.0).of(Measure::Steps, key_light_lost());
        found.add(Kind::Cancelling, spot, facts.corner_area(face));
    }
}

/// Whether several fans touch at a vertex. At a seam the fan continues at other vertices; non-manifold edges are a finding of
/// their own.
fn is_pinched(facts: &Facts<'_>, vertex: u32) -> bool {
    let topology = &facts.topology;
    let ring = topology.corners_at(vertex);
    let is_plain = |half_edge: u32| matches!(topology.link(half_edge), Link::Boundary | Link::Twin(_));
    let are_plain = ring.iter().all(|&corner| is_plain(corner) && is_plain(topology.previous(corner)));
    if ring.is_empty() || topology.is_welded(vertex) || !are_plain {
        return false;
    }
    let rims = ring.iter().filter(|&&corner| topology.link(corner) == Link::Boundary).count();
    rims > 1 || !is_one_fan(facts, ring[0], ring.len(), rims)
}

/// Whether a walk from a corner reaches all corners of its vertex, over edges by index.
fn is_one_fan(facts: &Facts<'_>, start: u32, corners: usize, rims: usize) -> bool {
    let twin = |half_edge: u32| match facts.topology.link(half_edge) {
        Link::Twin(across) => Some(across),
        _ => None,
    };
    let (mut corner, mut reached) = (start, 1);
    while let Some(across) = twin(corner) {
        corner = facts.topology.next(across);
        if corner == start {
            return reached == corners && rims == 0;
        }
        reached += 1;
    }
    corner = start;
    while let Some(across) = twin(facts.topology.previous(corner)) {
        corner = across;
        reached += 1;
    }
    reached == corners
}

/// The mean of all faces at a vertex by its index, weighted by their angles, as many programs compute it.
pub(crate) fn index_mean(facts: &Facts<'_>, vertex: u32) -> DVec3 {
    facts.topology.corners_at(vertex).iter().map(|&corner| term(facts, corner, Weight::Angle)).sum()
}

/// The largest angle in degrees between that mean and the normal of a corner there.
pub(crate) fn index_mean_error(facts: &Facts<'_>, vertex: u32) -> f64 {
    let mean = index_mean(facts, vertex);
    if mean == DVec3::ZERO {
        return 0.0;
    }
    let corners = facts.topology.corners_at(vertex).iter();
    corners.map(|&corner| degrees_between(mean, facts.expected(corner as usize))).fold(0.0, f64::max)
}

/// The largest angle in degrees between a face at a vertex and the normal of its corner there.
pub(crate) fn largest_leaning(facts: &Facts<'_>, vertex: u32) -> f64 {
    let corners = facts.topology.corners_at(vertex).iter().map(|&corner| corner as usize);
    let leaning =
        |corner: usize| degrees_between(facts.face_normal(facts.face_of(corner)), facts.expected(corner));
    corners.map(leaning).fold(0.0, f64::max)
}
