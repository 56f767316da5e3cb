//! What interpolation shows of the faces, even with correct normals: broken shadows, lost highlights, Mach bands, outlines.

use crate::num::{angle_between, three_digits};
use crate::quality::effect::Highlights;
use crate::quality::effect::slope_jump;
use crate::quality::findings::prelude::*;
use glam::DVec3;

/// The tangents of the turns of normals up to which the two bounds below hold.
const SMALL_TURN: f64 = 0.3;

/// More than the steps of 8 bits that the grey under a key light changes by for a radian: 255 · 1.055/2.4 · 2^0.29 · √½ = 97.
const SLOPE: f64 = 100.0;

/// More than half the second derivative of that within [`SMALL_TURN`], and than the difference of a tangent from its angle.
const CURVATURE: f64 = 200.0;

/// Normals at the two sides of an edge are the same for shading if their cosine is above this: 1.1°.
const SMOOTH: f64 = 0.9998;

/// Checks all faces with the normals that a viewer has: the stored ones, or computed ones where there are none.
pub(crate) fn search(facts: &Facts<'_>, found: &mut Found) {
    let terminator = Limit::new(facts.thresholds.terminator.0);
    let highlights = Highlights::new(facts);
    found.merge(facts.scan_faces(|face, found| {
        if facts.is_sound(face) {
            check_corners(facts, face, terminator, highlights.width(facts.mesh, face), found);
            for half_edge in facts.corners_of(face) {
                check_edge(facts, face, half_edge as u32, found);
            }
        }
    }));
    remark(found, Kind::MachBands, |steps| REMARKS.with("slope", &[("steps", steps)]));
    let size = Value::digits(&three_digits(facts.thresholds.size));
    remark(found, Kind::CoarseOutline, |pixels| {
        REMARKS.with("outline", &[("pixels", pixels), ("size", size.clone())])
    });
}

/// Reports the amount at the worst position.
fn remark(found: &mut Found, finding: Kind, say: impl Fn(Value) -> Text) {
    let tally = found.tally(finding);
    let worst = tally.worst.first().map(|worst| worst.weight);
    tally.remark = worst.map(|weight| Remark { weight, text: say(Value::digits(&three_digits(weight))) });
}

/// Finds corners whose normal is far from the face, and faces whose normals differ by more than the width of a highlight.
fn check_corners(facts: &Facts<'_>, face: usize, terminator: Limit, highlight: Limit, found: &mut Found) {
    let mut widest: f64 = 0.0;
    for corner in facts.corners_of(face) {
        let normal = facts.shaded(corner);
        if let Some(leaning) = terminator.exceeded(normal, facts.face_normal(face)).filter(|&it| it < 90.0) {
            found.add(Kind::Terminator, Spot::corner(face, corner, leaning), facts.corner_area(face));
        }
        // A highlight between two corners is half as far from the nearer one.
        let next = facts.shaded(facts.topology.next(corner as u32) as usize);
        widest = widest.max(highlight.exceeded(normal, next).unwrap_or(0.0));
    }
    if widest > 0.0 {
        found.add(Kind::LostHighlight, Spot::face(face).by(widest), facts.area[face]);
    }
}

/// Finds smooth edges whose dihedral angle shows along them, or at the outline.
fn check_edge(facts: &Facts<'_>, face: usize, half_edge: u32, found: &mut Found) {
    let (topology, thresholds) = (&facts.topology, facts.thresholds);
    let Some(across) = facts.across_once(half_edge) else { return };
    let other = topology.face_of(across) as usize;
    if !facts.is_sound(other) {
        return;
    }
    let shaded = |corner: u32| facts.shaded(corner as usize);
    let normals = [half_edge, topology.next(half_edge)].map(shaded);
    let beyond = [topology.next(across), across].map(shaded);
    if normals[0].dot(beyond[0]) <= SMOOTH || normals[1].dot(beyond[1]) <= SMOOTH {
        return;
    }
    let spot = |amount: f64| Spot::corner(face, half_edge as usize, 0.0).of(Measure::Amount, amount);
    let along = facts.edge(half_edge as usize);
    let length = along.length();
    let pixels = thresholds.size / facts.size;
    let heights = [face, other].map(|face| {
        // From the edge to the far corner of a triangle, to the far edge of a polygon.
        let share = if facts.corners_of(face).len() == 3 { 2.0 } else { 1.0 };
        share * facts.area[face] / length * pixels
    });
    let far = [half_edge, across].map(|half_edge| beyond_edge(facts, half_edge));
    let jump = band(normals[0] + normals[1], along, far, heights, thresholds.band);
    if jump > thresholds.band {
        found.add(Kind::MachBands, spot(jump), 0.0);
    }
    let height = heights[0].min(heights[1]);
    let normals = [face, other].map(|face| facts.face_normal(face));
    // A cheap bound first: tan(b/4) is at most half of the chord 2 sin(b/2), at b = 180°.
    let chord = (normals[0] - normals[1]).length();
    if 0.5 * height * 0.5 * chord <= thresholds.outline {
        return;
    }
    // An arc that turns by the dihedral angle over the height of the faces lies this far outside of its chord.
    let sagitta = 0.5 * height * libm::tan(angle_between(normals[0], normals[1]).0 / 4.0);
    if sagitta > thresholds.outline {
        found.add(Kind::CoarseOutline, spot(sagitta), 0.0);
    }
}

/// The direction of the normals at the corners of a face opposite to an edge: of a triangle it is one corner.
fn beyond_edge(facts: &Facts<'_>, half_edge: u32) -> DVec3 {
    let before = facts.topology.previous(half_edge);
    let after = facts.topology.next(facts.topology.next(half_edge));
    let normal = facts.shaded(before as usize);
    if before == after { normal } else { normal + facts.shaded(after as usize) }
}

/// The change of the slope of brightness at an edge with this normal and direction, in steps a pixel; 0 if it is certainly no more
/// than `least`. `far` are normals of any length beyond the edge, `heights` their distances in pixels.
fn band(normal: DVec3, along: DVec3, far: [DVec3; 2], heights: [f64; 2], least: f64) -> f64 {
    // Towards the first face.
    let aside = normal.cross(along).normalize_or_zero();
    let up = normal.normalize_or_zero();
    let turned = far.map(|normal| [normal.dot(up), normal.dot(aside)]);
    // Tangents of the angles between the normals beyond the edge and that of the edge.
    let turns = turned.map(|[up, aside]| aside / up.max(0.0));
    if turns.iter().all(|turn| turn.abs() < SMALL_TURN) {
        let pixels = heights.map(|height| height.max(1.0));
        let first = SLOPE * (turns[0] / pixels[0] + turns[1] / pixels[1]).abs();
        let second = CURVATURE * (turns[0] * turns[0] / pixels[0] + turns[1] * turns[1] / pixels[1]);
        if first + second <= least {
            return 0.0;
        }
    }
    slope_jump(turned, heights)
}
