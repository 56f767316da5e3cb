//! Polygons of four corners and more: whether they are plane, convex and simple.

use crate::num::{Degrees, angle_between};
use crate::quality::catalogue::Kind;
use crate::quality::counts::{Spot, Tallies};
use crate::quality::estimate::other_programs;
use crate::quality::facts::Facts;
use crate::quality::thresholds::Thresholds;
use glam::{DVec2, DVec3};

/// The longest polygon whose edges are compared all with all.
const LONGEST: usize = 64;

/// The sine of a bend inwards from which on a corner is concave: flat corners are neither.
const BEND: f64 = 1e-6;

/// Findings about one face.
pub(in crate::quality) fn look_at(
    facts: &Facts<'_>,
    face: usize,
    thresholds: &Thresholds,
    found: &mut Tallies,
) {
    let range = facts.mesh.faces().range(face);
    if range.len() < 4 {
        return;
    }
    if facts.area[face] == 0.0 {
        if is_balanced(facts, face) {
            found.add(Kind::Crossed, Spot::face(face, 0.0).by(180.0), 0.0);
        }
        return;
    }
    let places = places(facts, face);
    let normal = facts.face_normal(face);
    let area = facts.area[face];
    let twist = twist(&places, normal);
    let flat = flattened(&places, normal);
    let bends = bends(&flat);
    if crosses_itself(&flat) {
        found.add(Kind::Crossed, Spot::face(face, 0.0).by(180.0), area);
        return;
    }
    if twist > thresholds.planarity.0 {
        found.add(Kind::NonPlanar, Spot::face(face, 0.0).by(twist), area);
    }
    if bends.iter().any(|&bend| bend < -BEND) {
        found.add(Kind::Concave, Spot::face(face, 0.0).by(other_programs::fan(&places, normal)), area);
    }
}

/// The largest angle in degrees between a face and its plane; 0 for triangles.
pub(in crate::quality) fn bow(facts: &Facts<'_>, face: usize) -> f64 {
    match facts.mesh.faces().range(face).len() {
        0..=3 => 0.0,
        _ => twist(&places(facts, face), facts.face_normal(face)),
    }
}

/// Whether a polygon without area crosses itself, so that what faces up is as large as what faces down.
pub(in crate::quality) fn is_balanced(facts: &Facts<'_>, face: usize) -> bool {
    let places = places(facts, face);
    // The plane of the largest triangle of the fan: the polygon as a whole has no direction.
    let spokes = places[1..].windows(2).map(|pair| pair[0].cross(pair[1]));
    let largest =
        spokes.fold(DVec3::ZERO, |a, b| if b.length_squared() > a.length_squared() { b } else { a });
    let normal = largest.try_normalize();
    places.len() > 3 && normal.is_some_and(|normal| crosses_itself(&flattened(&places, normal)))
}

/// The corners of a face from its first one.
pub(in crate::quality) fn places(facts: &Facts<'_>, face: usize) -> Vec<DVec3> {
    let range = facts.mesh.faces().range(face);
    let first = facts.place(range.start);
    range.map(|corner| facts.place(corner) - first).collect()
}

/// Places as seen along a normal.
fn flattened(places: &[DVec3], normal: DVec3) -> Vec<DVec2> {
    let (x, y) = normal.any_orthonormal_pair();
    places.iter().map(|place| DVec2::new(place.dot(x), place.dot(y))).collect()
}

/// The largest angle in degrees between the polygon's normal and that of the triangle at a corner, whichever way it faces.
fn twist(places: &[DVec3], normal: DVec3) -> f64 {
    let count = places.len();
    let at = |i: usize| {
        let (before, here, after) = (places[(i + count - 1) % count], places[i], places[(i + 1) % count]);
        let cross = (here - before).cross(after - here);
        // A corner that is nearly straight has no plane of its own.
        let straight = cross.length() <= 1e-3 * (here - before).length() * (after - here).length();
        if straight {
            0.0
        } else {
            Degrees::from(angle_between(normal, if cross.dot(normal) < 0.0 { -cross } else { cross })).0
        }
    };
    (0..count).map(at).fold(0.0, f64::max)
}

/// The sine of the turn at each corner, positive to the left.
fn bends(flat: &[DVec2]) -> Vec<f64> {
    let count = flat.len();
    let at = |i: usize| {
        let (before, here, after) = (flat[(i + count - 1) % count], flat[i], flat[(i + 1) % count]);
        let (a, b) = (here - before, after - here);
        let lengths = a.length() * b.length();
        if lengths > 0.0 { a.perp_dot(b) / lengths } else { 0.0 }
    };
    (0..count).map(at).collect()
}

/// Whether two edges that share no corner cross properly.
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
        assert!(bends(&square).iter().all(|&bend| bend == 1.0));
        assert_eq!(bends(&arrow).iter().filter(|&&bend| bend < -BEND).count(), 1);
        assert_eq!([square, arrow, bow].map(|points| crosses_itself(&points)), [false, false, true]);
    }

    #[test]
    fn twist_is_an_angle() {
        let place = |height: f64| [DVec3::ZERO, DVec3::X, DVec3::new(1.0, 1.0, height), DVec3::Y];
        assert!(twist(&place(0.0), DVec3::Z) < 1e-9);
        // The triangle at the raised corner leans by atan(√2 · h).
        let expected = libm::atan(2f64.sqrt() * 0.5).to_degrees();
        assert!((twist(&place(0.5), DVec3::Z) - expected).abs() < 1e-9);
    }
}
