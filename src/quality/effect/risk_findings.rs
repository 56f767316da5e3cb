//! Findings about what even right normals will show.

use crate::num::{angle_between, three_digits};
use crate::quality::catalogue::Kind;
use crate::quality::counts::{Gauge, Remark, Spot, Tallies, scan};
use crate::quality::effect::lost_light::slope_jump;
use crate::quality::facts::{Facts, Significance};
use crate::quality::geometry::angle_limit::Limit;
use crate::quality::thresholds::Thresholds;
use glam::DVec3;

/// Turns of normals, as tangents, up to which the two bounds below hold.
const SMALL_TURN: f64 = 0.3;

/// More than the steps of 8 bits that the grey under a key light changes by for a radian: 255 · 1.055/2.4 · 2^0.29 · √½ = 97.
const SLOPE: f64 = 100.0;

/// More than half the second derivative of that within [`SMALL_TURN`], and than what a tangent is more than its angle.
const CURVATURE: f64 = 200.0;

/// Normals at the two sides of an edge are one as far as shading goes where their cosine is above this: 1.1° apart.
const SMOOTH: f64 = 0.9998;

/// Risks of shading with the normals that a viewer has: the stored ones, or the computed ones where there are none.
pub(in crate::quality) fn find(facts: &Facts<'_>, thresholds: &Thresholds, found: &mut Tallies) {
    let terminator = Limit::new(thresholds.terminator.0);
    let risks = scan(facts.mesh.face_count(), thresholds.places, |faces, found| {
        for face in faces.filter(|&face| facts.worth[face] == Significance::Sound) {
            corners(facts, face, terminator, found);
            for half_edge in facts.mesh.faces().range(face) {
                edge(facts, face, half_edge as u32, thresholds, found);
            }
        }
    });
    found.merge(risks);
    remark(found, Kind::MachBands, |steps| {
        format!("the slope of brightness jumps by up to {steps} steps a pixel")
    });
    remark(found, Kind::CoarseOutline, |pixels| {
        format!("by up to {pixels} pixels where the mesh is {} wide", three_digits(thresholds.size))
    });
}

/// Says how bad the worst place is, where that is no angle.
fn remark(found: &mut Tallies, kind: Kind, say: impl Fn(String) -> String) {
    let tally = found.tally(kind);
    let worst = tally.worst.first().map(|worst| worst.weight);
    tally.remark = worst.map(|weight| Remark { weight, text: say(three_digits(weight)) });
}

/// Corners whose normal is far from the face, and faces whose corners are further apart than a highlight is wide.
fn corners(facts: &Facts<'_>, face: usize, terminator: Limit, found: &mut Tallies) {
    let range = facts.mesh.faces().range(face);
    let area = facts.area[face] / range.len() as f64;
    // A highlight between two corners is half as far from the nearer one.
    let width = facts.gloss.width(facts.mesh, face);
    let mut widest: f64 = 0.0;
    for corner in range {
        let normal = facts.shaded(corner);
        if let Some(leaning) = terminator.exceeded(normal, facts.face_normal(face)).filter(|&it| it < 90.0) {
            found.add(Kind::Terminator, Spot::corner(face, corner, leaning), area);
        }
        let next = facts.shaded(facts.topology.next(corner as u32) as usize);
        widest = widest.max(width.exceeded(normal, next).unwrap_or(0.0));
    }
    if widest > 0.0 {
        found.add(Kind::LostHighlight, Spot::face(face, 0.0).by(widest), facts.area[face]);
    }
}

/// Smooth edges that bend so much that it shows along them, or at the outline.
fn edge(facts: &Facts<'_>, face: usize, half_edge: u32, thresholds: &Thresholds, found: &mut Tallies) {
    let topology = &facts.topology;
    let Some(across) = topology.across(half_edge).filter(|&across| half_edge < across) else { return };
    let other = topology.face_of(across) as usize;
    if facts.worth[other] != Significance::Sound {
        return;
    }
    let ends = [half_edge, topology.next(half_edge)];
    let normals = ends.map(|corner| facts.shaded(corner as usize));
    let beyond = [topology.next(across), across].map(|corner| facts.shaded(corner as usize));
    if normals[0].dot(beyond[0]) <= SMOOTH || normals[1].dot(beyond[1]) <= SMOOTH {
        return;
    }
    let spot = |amount: f64| Spot::corner(face, half_edge as usize, 0.0).of(Gauge::Amount, amount);
    let along = facts.place(ends[1] as usize) - facts.place(ends[0] as usize);
    let length = along.length();
    let pixels = thresholds.size / facts.size;
    let heights = [face, other].map(|face| {
        // From the edge to the far corner of a triangle, to the far edge of a polygon.
        let share = if facts.mesh.faces().range(face).len() == 3 { 2.0 } else { 1.0 };
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
    // An arc that turns by the bend over the height of the faces lies this far outside of its chord.
    let sagitta = 0.5 * height * libm::tan(angle_between(normals[0], normals[1]).0 / 4.0);
    if sagitta > thresholds.outline {
        found.add(Kind::CoarseOutline, spot(sagitta), 0.0);
    }
}

/// The direction of the normals at the corners next to an edge on the face of its half-edge: of a triangle it is one corner.
fn beyond_edge(facts: &Facts<'_>, half_edge: u32) -> DVec3 {
    let before = facts.topology.previous(half_edge);
    let after = facts.topology.next(facts.topology.next(half_edge));
    let normal = facts.shaded(before as usize);
    if before == after { normal } else { normal + facts.shaded(after as usize) }
}

/// How much the slope of brightness changes at an edge with this normal and direction, in steps a pixel; 0 where that is
/// `least` at most for certain. What is beyond it is told by normals of any length and by heights.
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
