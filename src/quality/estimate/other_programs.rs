//! What other programs' shorter ways make of a shape: means by vertex index, faces that count twice, fans of triangles.

use crate::mesh::place_key;
use crate::normals::Weight;
use crate::num::{Degrees, angle_between};
use crate::quality::catalogue::Kind;
use crate::quality::counts::Spot;
use crate::quality::estimate::means::pull;
use crate::quality::facts::Facts;
use crate::quality::geometry::slenderness;
use glam::DVec3;
use rayon::prelude::*;

fn degrees(a: DVec3, b: DVec3) -> f64 {
    if a == DVec3::ZERO || b == DVec3::ZERO { 0.0 } else { Degrees::from(angle_between(a, b)).0 }
}

/// The mean of all faces at a vertex by its index, weighted by their angles, whatever they have to do with each other.
fn mean(facts: &Facts<'_>, vertex: u32) -> DVec3 {
    facts.topology.corners_at(vertex).iter().map(|&corner| pull(facts, corner, Weight::Angle)).sum()
}

/// By how many degrees the one normal of a vertex by its index is off that of a corner there, at most.
pub(in crate::quality) fn by_index(facts: &Facts<'_>, vertex: u32) -> f64 {
    let mean = mean(facts, vertex);
    let corners = facts.topology.corners_at(vertex).iter();
    corners.map(|&corner| degrees(mean, facts.expected(corner as usize))).fold(0.0, f64::max)
}

/// By how many degrees the mean at a corner of a face turns as the face counts once more, at most.
pub(in crate::quality) fn once_more(facts: &Facts<'_>, face: usize) -> f64 {
    let vertices = facts.mesh.faces().corners();
    let off = |corner: usize| {
        let with = mean(facts, vertices[corner]);
        degrees(with, with - pull(facts, corner as u32, Weight::Angle))
    };
    facts.mesh.faces().range(face).map(off).fold(0.0, f64::max)
}

/// By how many degrees a triangle of the fan from the first corner of a polygon, by its places, is off the polygon, at most.
pub(in crate::quality) fn fan(places: &[DVec3], normal: DVec3) -> f64 {
    let triangles = places[1..].windows(2).map(|pair| (pair[0] - places[0]).cross(pair[1] - places[0]));
    triangles.map(|triangle| degrees(triangle, normal)).fold(0.0, f64::max)
}

/// The angle at a place of a kind that goes by another measure, in degrees; `None` for all other kinds.
pub(in crate::quality) fn next_to(facts: &Facts<'_>, kind: Kind, spot: &Spot) -> Option<f64> {
    match kind {
        Kind::Needles => Some(slenderness::by_rounding(facts, spot.face as usize)),
        Kind::NonManifold => Some(largest_bend(facts, spot.corner)),
        Kind::HighValence => Some(from_pole(facts, spot.vertex)),
        _ => None,
    }
}

/// The largest bend from one face into another at an edge that several have, whichever way they run.
fn largest_bend(facts: &Facts<'_>, half_edge: u32) -> f64 {
    let (faces, vertices) = (facts.mesh.faces(), facts.mesh.faces().corners());
    let ends = |half_edge: u32| {
        let (tail, head) = facts.topology.ends(vertices, half_edge);
        [tail, head].map(|vertex| place_key(facts.mesh.positions()[vertex as usize]))
    };
    let [tail, head] = ends(half_edge);
    let normals: Vec<DVec3> = (0..faces.corner_count() as u32)
        .into_par_iter()
        .filter_map(|other| {
            let normal = || facts.face_normal(facts.topology.face_of(other) as usize);
            match ends(other) {
                same if same == [tail, head] => Some(normal()),
                back if back == [head, tail] => Some(-normal()),
                _ => None,
            }
        })
        .collect();
    // From one face into another the two run the edge opposite ways.
    let pairs = normals.iter().enumerate().flat_map(|(i, a)| normals[i + 1..].iter().map(move |b| (*a, -*b)));
    pairs.map(|(a, b)| degrees(a, b)).fold(0.0, f64::max)
}

/// How far a face at a vertex looks from the normal of its corner there, at most.
fn from_pole(facts: &Facts<'_>, vertex: u32) -> f64 {
    let corners = facts.topology.corners_at(vertex).iter();
    let off = |&corner: &u32| {
        degrees(facts.face_normal(facts.topology.face_of(corner) as usize), facts.expected(corner as usize))
    };
    corners.map(off).fold(0.0, f64::max)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_fan_from_next_to_the_hollow_of_an_arrow_turns_one_triangle_over() {
        let arrow = [[0.0, 0.0], [1.0, 0.0], [0.2, 0.2], [0.0, 1.0]].map(|[x, y]| DVec3::new(x, y, 0.0));
        let from = |first: usize| {
            let mut places = arrow;
            places.rotate_left(first);
            fan(&places, DVec3::Z)
        };
        assert_eq!([0, 1, 2, 3].map(from), [0.0, 180.0, 0.0, 180.0]);
    }
}
