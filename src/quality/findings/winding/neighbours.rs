//! Faces that run against their neighbours, and surfaces on which all faces cannot agree.

use crate::mesh::Link;
use crate::quality::catalogue::Kind;
use crate::quality::counts::Found;
use crate::quality::element::Severity;
use crate::quality::facts::Facts;
use crate::quality::spot::Spot;

/// Finds faces that run against their neighbours. A duplicate face and one without a direction are findings of their own.
pub(crate) fn search(facts: &Facts<'_>, found: &mut Found) {
    let topology = &facts.topology;
    // Components that only touch may run as they like: only edges by index are certain.
    let is_by_index = |half_edge: usize| match topology.link(half_edge as u32) {
        Link::Inconsistent(other) => {
            let ends = |half_edge| topology.ends(facts.mesh.faces().corners(), half_edge);
            ends(half_edge as u32) == ends(other)
        }
        _ => false,
    };
    let mut is_certain = !facts.file.shares_vertices();
    for &face in &facts.winding.minority {
        let number = face as usize;
        if !facts.duplicates.is_doubled(face) && facts.has_direction(number) {
            is_certain |= facts.corners_of(number).any(is_by_index);
            found.add(Kind::InconsistentWinding, Spot::face(number).by(180.0), facts.area[number]);
        }
    }
    if !is_certain {
        found.tally(Kind::InconsistentWinding).severity = Some(Severity::Warning);
    }
    if facts.winding.outward.non_orientable > 0 {
        for half_edge in 0..facts.mesh.faces().corner_count() as u32 {
            let face = topology.face_of(half_edge);
            if matches!(topology.link(half_edge), Link::Inconsistent(other) if half_edge < other)
                && facts.winding.minority.binary_search(&face).is_err()
            {
                let spot = Spot::face(face as usize).by(180.0);
                found.add(Kind::NonOrientable, spot, facts.area[face as usize]);
            }
        }
    }
}
