//! Long and thin faces.

use crate::num::{Degrees, Radians};
use crate::quality::catalogue::Kind;
use crate::quality::counts::{Gauge, Spot, Tallies};
use crate::quality::facts::Facts;
use crate::quality::geometry::polygons::places;
use crate::quality::thresholds::Thresholds;
use glam::DVec3;

/// The finding about one face.
pub(in crate::quality) fn look_at(
    facts: &Facts<'_>,
    face: usize,
    thresholds: &Thresholds,
    found: &mut Tallies,
) {
    if facts.area[face] == 0.0 {
        return;
    }
    let [length, width] = extents(facts, face);
    let shape = width / length;
    if shape < thresholds.needle {
        found.add(Kind::Needles, Spot::face(face, 0.0).of(Gauge::Amount, -shape), facts.area[face]);
    }
}

/// By how many degrees a face turns at most as single precision rounds its corners: the two ends of its width by half a unit in
/// the last place each.
pub(in crate::quality) fn by_rounding(facts: &Facts<'_>, face: usize) -> f64 {
    let corners = facts.mesh.faces().range(face).map(|corner| facts.place(corner));
    let farthest = corners.map(|corner| corner.abs().max_element()).fold(0.0, f64::max);
    let rounding = farthest * f64::from(f32::EPSILON) / 2.0;
    let [_, width] = extents(facts, face);
    Degrees::from(Radians(libm::atan2(2.0 * rounding, width))).0
}

/// Length and width: the longest edge of a triangle and the height above it; of a polygon, how far it reaches along the line
/// through two corners far apart, and how far across that or across its longest edge, whichever is less.
fn extents(facts: &Facts<'_>, face: usize) -> [f64; 2] {
    let range = facts.mesh.faces().range(face);
    let longest = |edges: &mut dyn Iterator<Item = DVec3>| {
        edges.fold(DVec3::ZERO, |a, b| if b.length_squared() > a.length_squared() { b } else { a })
    };
    if range.len() == 3 {
        let [a, b, c] = [0, 1, 2].map(|i| facts.place(range.start + i));
        let length = longest(&mut [b - a, c - b, a - c].into_iter()).length();
        return [length, 2.0 * facts.area[face] / length];
    }
    let places = places(facts, face);
    let farthest = |from: DVec3| from + longest(&mut places.iter().map(|&place| place - from));
    let end = farthest(DVec3::ZERO);
    let diagonal = (farthest(end) - end).normalize_or_zero();
    let next = places.iter().cycle().skip(1);
    let edge = longest(&mut places.iter().zip(next).map(|(a, b)| b - a)).normalize_or_zero();
    let reach = |places: &[DVec3], axis: DVec3| {
        let all = places.iter().map(|place| place.dot(axis));
        all.clone().fold(f64::NEG_INFINITY, f64::max) - all.fold(f64::INFINITY, f64::min)
    };
    let across = |along: DVec3| {
        let aside = |place: &DVec3| (place - end) - (place - end).dot(along) * along;
        let aside: Vec<DVec3> = places.iter().map(aside).collect();
        reach(&aside, longest(&mut aside.iter().copied()).normalize_or_zero())
    };
    [reach(&places, diagonal), across(diagonal).min(across(edge))]
}
