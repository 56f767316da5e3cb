//! Long and thin faces, and faces whose direction is rounding noise.

use crate::normals::FaultReason;
use crate::num::{Degrees, Radians};
use crate::quality::findings::geometry::polygons::{is_balanced, positions};
use crate::quality::findings::prelude::*;
use glam::DVec3;

pub(crate) fn check(facts: &Facts<'_>, face: usize, found: &mut Found) {
    if facts.area[face] == 0.0 {
        return;
    }
    let [length, width] = extents(facts, face);
    let shape = width / length;
    if shape < facts.thresholds.needle {
        found.add(Kind::Needles, Spot::face(face).of(Measure::Amount, -shape), facts.area[face]);
    }
}

/// Finds faces without a direction.
pub(crate) fn search(facts: &Facts<'_>, found: &mut Found) {
    for fault in &facts.field.faults.faces {
        let face = fault.index as usize;
        let (finding, degrees) = match fault.reason {
            FaultReason::ZeroArea if is_balanced(facts, face) => continue,
            FaultReason::ZeroArea => (Kind::ZeroArea, None),
            FaultReason::BelowStorage => (Kind::BelowStorage, Some(90.0)),
            _ => continue,
        };
        let spot = Spot::face(face);
        found.add(finding, degrees.map_or(spot, |degrees| spot.by(degrees)), facts.area[face]);
    }
}

/// The largest angle in degrees by which single precision turns a face: half a unit in the last place at both ends of its
/// width.
pub(crate) fn rounding_angle(facts: &Facts<'_>, face: usize) -> f64 {
    let corners = facts.corners_of(face).map(|corner| facts.position(corner));
    let farthest = corners.map(|corner| corner.abs().max_element()).fold(0.0, f64::max);
    let rounding = farthest * f64::from(f32::EPSILON) / 2.0;
    let [_, width] = extents(facts, face);
    Degrees::from(Radians(libm::atan2(2.0 * rounding, width))).0
}

/// Length and width of a face. Of a triangle, the longest edge and the height above it. Of a polygon, the extent along the line
/// through two corners far from each other, and the extent across that or across its longest edge, whichever is less.
fn extents(facts: &Facts<'_>, face: usize) -> [f64; 2] {
    let longest = |vectors: &mut dyn Iterator<Item = DVec3>| {
        vectors.fold(DVec3::ZERO, |a, b| if b.length_squared() > a.length_squared() { b } else { a })
    };
    let range = facts.corners_of(face);
    if range.len() == 3 {
        let length = longest(&mut range.map(|corner| facts.edge(corner))).length();
        return [length, 2.0 * facts.area[face] / length];
    }
    let positions = positions(facts, face);
    let farthest = |from: DVec3| from + longest(&mut positions.iter().map(|&position| position - from));
    let end = farthest(DVec3::ZERO);
    let diagonal = (farthest(end) - end).normalize_or_zero();
    let next = positions.iter().cycle().skip(1);
    let edge = longest(&mut positions.iter().zip(next).map(|(a, b)| b - a)).normalize_or_zero();
    let reach = |positions: &[DVec3], axis: DVec3| {
        let all = positions.iter().map(|position| position.dot(axis));
        all.clone().fold(f64::NEG_INFINITY, f64::max) - all.fold(f64::INFINITY, f64::min)
    };
    let across = |along: DVec3| {
        let aside = |position: &DVec3| (position - end) - (position - end).dot(along) * along;
        let aside: Vec<DVec3> = positions.iter().map(aside).collect();
        reach(&aside, longest(&mut aside.iter().copied()).normalize_or_zero())
    };
    [reach(&positions, diagonal), across(diagonal).min(across(edge))]
}
