//! Winding: faces with opposite winding to their neighbours, surfaces on which all faces cannot agree, and components that face inwards.

use crate::mesh::Link;
use crate::quality::findings::prelude::*;
use crate::quality::input::part::InsideOut;

/// Finds faces with opposite winding to their neighbours. A duplicate face and one without a direction are findings of their own.
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

/// The severity of a component that is inside out: lower if no stored normals contradict its faces.
fn severity(component: &InsideOut) -> Severity {
    match (component.is_open, component.is_opposed == Some(true)) {
        (false, true) => Severity::Error,
        (true, true) => Severity::Warning,
        (false, false) => Severity::Warning,
        (true, false) => Severity::Note,
    }
}

/// Finds components that are inside out, and rooms. Only those of the highest severity are counted.
pub(crate) fn search_components(facts: &Facts<'_>, found: &mut Found) {
    let winding = &facts.winding;
    for (finding, is_open) in [(Kind::InsideOut, false), (Kind::OpenInsideOut, true)] {
        let alike = || winding.inside_out.iter().filter(|component| component.is_open == is_open);
        let Some(highest) = alike().map(severity).max() else { continue };
        for component in alike() {
            // The back of faces that are there as well is a finding of its own.
            if is_open && component.faces.iter().all(|&face| facts.duplicates.is_back(face)) {
                continue;
            }
            if severity(component) < highest {
                found.tally(finding).milder.add(1, component.faces.len() as u64);
                continue;
            }
            for face in component.faces.iter().map(|&face| face as usize) {
                found.add(finding, Spot::face(face).by(180.0), facts.area[face]);
            }
            let tally = found.tally(finding);
            tally.sum += 1;
            tally.confidence = Some(if is_open { winding.outward.confidence } else { 1.0 });
            tally.severity = Some(highest);
        }
    }
    for face in winding.outward.room_faces.iter().map(|&face| face as usize) {
        found.add(Kind::Room, Spot::face(face), facts.area[face]);
    }
    if winding.outward.rooms > 0 {
        found.tally(Kind::Room).sum = winding.outward.rooms as u64;
    }
}
