//! Components that face inwards: closed ones by their volume, those with a rim by what is visible of them.

use crate::quality::catalogue::Kind;
use crate::quality::counts::Found;
use crate::quality::element::Severity;
use crate::quality::facts::Facts;
use crate::quality::input::winding::InsideOut;
use crate::quality::spot::Spot;

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
pub(crate) fn search(facts: &Facts<'_>, found: &mut Found) {
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
