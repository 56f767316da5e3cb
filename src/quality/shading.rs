//! Findings about what even right normals will show.

use super::Thresholds;
use super::catalogue::Kind;
use super::facts::{Facts, Worth};
use super::tally::{Spot, Tallies, scan};
use crate::num::{Degrees, angle_between};

/// Risks of shading with the normals that a viewer has: the stored ones, or the computed ones where there are none.
pub(super) fn find(facts: &Facts<'_>, thresholds: &Thresholds, found: &mut Tallies) {
    let highlight = half_width(thresholds.exponent);
    let risks = scan(facts.mesh.face_count(), thresholds.places, |faces, found| {
        for face in faces.filter(|&face| facts.worth[face] == Worth::Sound) {
            corners(facts, face, highlight, thresholds, found);
            for half_edge in facts.mesh.faces().range(face) {
                edge(facts, face, half_edge as u32, thresholds, found);
            }
        }
    });
    found.merge(risks);
}

/// The angle in degrees from the middle of a highlight cosⁿ to where it has half its height.
fn half_width(exponent: f64) -> f64 {
    libm::acos(libm::exp2(-1.0 / exponent)).to_degrees()
}

/// Corners whose normal is far from the face, and faces whose corners are further apart than a highlight is wide.
fn corners(facts: &Facts<'_>, face: usize, highlight: f64, thresholds: &Thresholds, found: &mut Tallies) {
    let range = facts.mesh.faces().range(face);
    let area = facts.area[face] / range.len() as f64;
    let mut widest: f64 = 0.0;
    for corner in range.clone() {
        let leaning = facts.leaning(corner);
        if leaning > thresholds.terminator.0 && leaning < 90.0 {
            found.add(Kind::Terminator, Spot::corner(face, corner, leaning), area);
        }
        let next = facts.topology.next(corner as u32) as usize;
        widest = widest.max(Degrees::from(angle_between(facts.shaded(corner), facts.shaded(next))).0);
    }
    // A highlight between two corners is half as far from the nearer one.
    if widest > 2.0 * highlight {
        found.add(Kind::LostHighlight, Spot::face(face, 0.0).by(widest), facts.area[face]);
    }
}

/// Smooth edges that bend so much that it shows along them, or at the outline.
fn edge(facts: &Facts<'_>, face: usize, half_edge: u32, thresholds: &Thresholds, found: &mut Tallies) {
    let Some(across) = facts.topology.across(half_edge).filter(|&across| half_edge < across) else { return };
    let other = facts.topology.face_of(across) as usize;
    if facts.worth[other] != Worth::Sound {
        return;
    }
    let pairs = [(half_edge, facts.topology.next(across)), (facts.topology.next(half_edge), across)];
    let is_smooth = |&(a, b): &(u32, u32)| facts.shaded(a as usize).dot(facts.shaded(b as usize)) > 0.9998;
    if !pairs.iter().all(is_smooth) {
        return;
    }
    let bend = Degrees::from(angle_between(facts.face_normal(face), facts.face_normal(other))).0;
    let spot = Spot::corner(face, half_edge as usize, bend);
    if bend > thresholds.band.0 {
        found.add(Kind::MachBands, spot, 0.0);
    }
    // An arc that turns by the bend over the height of the faces lies this far outside of its chord.
    let length =
        (facts.place(facts.topology.next(half_edge) as usize) - facts.place(half_edge as usize)).length();
    let height = facts.area[face].min(facts.area[other]) * 2.0 / length;
    let sagitta = 0.5 * height * libm::tan(bend.to_radians() / 4.0);
    if sagitta * thresholds.size > thresholds.outline * facts.size {
        let pixels = sagitta / facts.size * thresholds.size;
        found.add(Kind::CoarseOutline, Spot { weight: pixels, is_angle: false, ..spot }, 0.0);
    }
}
