//! The shape of faces: long and thin ones, ones without a direction, and polygons that are not plane, convex or simple.

use crate::normals::FaultReason;
use crate::num::{Degrees, Radians};
use crate::quality::findings::prelude::*;
use glam::{DVec2, DVec3};

pub(crate) fn check_width(facts: &Facts<'_>, face: usize, found: &mut Found) {
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
pub(crate) fn search_without_direction(facts: &Facts<'_>, found: &mut Found) {
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

/// The longest polygon of which all pairs of edges are compared.
const LONGEST: usize = 64;

/// The sine of an inward turn from which a corner is concave: straight corners are neither.
const INWARD: f64 = 1e-6;

pub(crate) fn check_polygon(facts: &Facts<'_>, face: usize, found: &mut Found) {
    if facts.corners_of(face).len() < 4 {
        return;
    }
    let area = facts.area[face];
    if area == 0.0 {
        if is_balanced(facts, face) {
            found.add(Kind::Crossed, Spot::face(face).by(180.0), 0.0);
        }
        return;
    }
    let positions = positions(facts, face);
    let normal = facts.face_normal(face);
    let flat = flattened(&positions, normal);
    if crosses_itself(&flat) {
        found.add(Kind::Crossed, Spot::face(face).by(180.0), area);
        return;
    }
    let twist = twist(&positions, normal);
    if twist > facts.thresholds.planarity.0 {
        found.add(Kind::NonPlanar, Spot::face(face).by(twist), area);
    }
    if turns(&flat).iter().any(|&turn| turn < -INWARD) {
        found.add(Kind::Concave, Spot::face(face).by(fan_error(&positions, normal)), area);
    }
}

/// The largest angle in degrees between a face and the planes at its corners; 0 for triangles.
pub(crate) fn bow(facts: &Facts<'_>, face: usize) -> f64 {
    match facts.corners_of(face).len() {
        0..=3 => 0.0,
        _ => twist(&positions(facts, face), facts.face_normal(face)),
    }
}

/// Whether a polygon without area crosses itself, so that as much of it faces up as down.
pub(crate) fn is_balanced(facts: &Facts<'_>, face: usize) -> bool {
    let positions = positions(facts, face);
    // The plane of the largest triangle of the fan: the polygon as a whole has no direction.
    let spokes = positions[1..].windows(2).map(|pair| pair[0].cross(pair[1]));
    let largest =
        spokes.fold(DVec3::ZERO, |a, b| if b.length_squared() > a.length_squared() { b } else { a });
    let normal = largest.try_normalize();
    positions.len() > 3 && normal.is_some_and(|normal| crosses_itself(&flattened(&positions, normal)))
}

/// The corners of a face relative to its first one.
pub(crate) fn positions(facts: &Facts<'_>, face: usize) -> Vec<DVec3> {
    let range = facts.corners_of(face);
    let first = facts.position(range.start);
    range.map(|corner| facts.position(corner) - first).collect()
}

/// The largest angle in degrees between a polygon and a triangle of the fan from its first corner.
fn fan_error(positions: &[DVec3], normal: DVec3) -> f64 {
    let spokes = positions[1..].windows(2).map(|pair| [pair[0] - positions[0], pair[1] - positions[0]]);
    let triangles = spokes.map(|[a, b]| a.cross(b)).filter(|&triangle| triangle != DVec3::ZERO);
    triangles.map(|triangle| degrees_between(triangle, normal)).fold(0.0, f64::max)
}

/// Positions in the plane across a normal.
fn flattened(positions: &[DVec3], normal: DVec3) -> Vec<DVec2> {
    let (x, y) = normal.any_orthonormal_pair();
    positions.iter().map(|position| DVec2::new(position.dot(x), position.dot(y))).collect()
}

/// The largest angle in degrees between the polygon's normal and the line of that of the triangle at a corner.
fn twist(positions: &[DVec3], normal: DVec3) -> f64 {
    let count = positions.len();
    let at = |i: usize| {
        let (before, here, after) =
            (positions[(i + count - 1) % count], positions[i], positions[(i + 1) % count]);
        let cross = (here - before).cross(after - here);
        // A corner that is nearly straight has no plane of its own.
        let straight = cross.length() <= 1e-3 * (here - before).length() * (after - here).length();
        if straight {
            0.0
        } else {
            degrees_between(normal, if cross.dot(normal) < 0.0 { -cross } else { cross })
        }
    };
    (0..count).map(at).fold(0.0, f64::max)
}

/// The sine of the turn at each corner, positive to the left.
fn turns(flat: &[DVec2]) -> Vec<f64> {
    let count = flat.len();
    let at = |i: usize| {
        let (before, here, after) = (flat[(i + count - 1) % count], flat[i], flat[(i + 1) % count]);
        let (a, b) = (here - before, after - here);
        let lengths = a.length() * b.length();
        if lengths > 0.0 { a.perp_dot(b) / lengths } else { 0.0 }
    };
    (0..count).map(at).collect()
}

fn crosses_itself(flat: &[DVec2]) -> bool {
    let count = flat.len();
    if count > LONGEST {
        return false;
    }
    let edge = |i: usize| (flat[i], flat[(i + 1) % count]);
    let side = |(a, b): (DVec2, DVec2), p: DVec2| (b - a).perp_dot(p - a);
    let cross = |i: usize, j: usize| {
        let (first, second) = (edge(i), edge(j));
        side(first, second.0) * side(first, second.1) < 0.0
            && side(second, first.0) * side(second, first.1) < 0.0
    };
    (0..count).any(|i| (i + 2..count).any(|j| (j + 1) % count != i && cross(i, j)))
}

#[cfg(test)]
mod tests {
    use super::*;

    fn flat(points: &[[f64; 2]]) -> Vec<DVec2> {
        points.iter().map(|&p| DVec2::from(p)).collect()
    }

    #[test]
    fn shapes_of_polygons() {
        let square = flat(&[[0.0, 0.0], [1.0, 0.0], [1.0, 1.0], [0.0, 1.0]]);
        let arrow = flat(&[[0.0, 0.0], [1.0, 0.0], [0.2, 0.2], [0.0, 1.0]]);
        let bow = flat(&[[0.0, 0.0], [1.0, 1.0], [1.0, 0.0], [0.0, 0.9]]);
        assert!(turns(&square).iter().all(|&turn| turn == 1.0));
        assert_eq!(turns(&arrow).iter().filter(|&&turn| turn < -INWARD).count(), 1);
        assert_eq!([square, arrow, bow].map(|points| crosses_itself(&points)), [false, false, true]);
    }

    #[test]
    fn twist_is_an_angle() {
        let corners = |height: f64| [DVec3::ZERO, DVec3::X, DVec3::new(1.0, 1.0, height), DVec3::Y];
        assert!(twist(&corners(0.0), DVec3::Z) < 1e-9);
        // The triangle at the raised corner leans by atan(√2 · h).
        let expected = libm::atan(2f64.sqrt() * 0.5).to_degrees();
        assert!((twist(&corners(0.5), DVec3::Z) - expected).abs() < 1e-9);
    }

    #[test]
    fn a_fan_from_next_to_the_hollow_of_an_arrow_turns_one_triangle_over() {
        let arrow = [[0.0, 0.0], [1.0, 0.0], [0.2, 0.2], [0.0, 1.0]].map(|[x, y]| DVec3::new(x, y, 0.0));
        let from = |first: usize| {
            let mut positions = arrow;
            positions.rotate_left(first);
            fan_error(&positions, DVec3::Z)
        };
        assert_eq!([0, 1, 2, 3].map(from), [0.0, 180.0, 0.0, 180.0]);
    }
}
