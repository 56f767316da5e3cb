//! What other programs' shorter ways make of a shape: means by vertex index, faces that count twice, fans of triangles.

use super::facts::Facts;
use super::means::pull;
use crate::normals::Weight;
use crate::num::{Degrees, angle_between};
use glam::DVec3;

fn degrees(a: DVec3, b: DVec3) -> f64 {
    if a == DVec3::ZERO || b == DVec3::ZERO { 0.0 } else { Degrees::from(angle_between(a, b)).0 }
}

/// The mean of all faces at a vertex by its index, weighted by their angles, whatever they have to do with each other.
fn mean(facts: &Facts<'_>, vertex: u32) -> DVec3 {
    facts.topology.corners_at(vertex).iter().map(|&corner| pull(facts, corner, Weight::Angle)).sum()
}

/// By how many degrees the one normal of a vertex by its index is off that of a corner there, at most.
pub(super) fn by_index(facts: &Facts<'_>, vertex: u32) -> f64 {
    let mean = mean(facts, vertex);
    let corners = facts.topology.corners_at(vertex).iter();
    corners.map(|&corner| degrees(mean, facts.expected(corner as usize))).fold(0.0, f64::max)
}

/// By how many degrees the mean at a corner of a face turns as the face counts once more, at most.
pub(super) fn once_more(facts: &Facts<'_>, face: usize) -> f64 {
    let vertices = facts.mesh.faces().corners();
    let off = |corner: usize| {
        let with = mean(facts, vertices[corner]);
        degrees(with, with - pull(facts, corner as u32, Weight::Angle))
    };
    facts.mesh.faces().range(face).map(off).fold(0.0, f64::max)
}

/// By how many degrees a triangle of the fan from the first corner of a polygon, by its places, is off the polygon, at most.
pub(super) fn fan(places: &[DVec3], normal: DVec3) -> f64 {
    let triangles = places[1..].windows(2).map(|pair| (pair[0] - places[0]).cross(pair[1] - places[0]));
    triangles.map(|triangle| degrees(triangle, normal)).fold(0.0, f64::max)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_fan_from_beside_the_hollow_of_an_arrow_turns_one_triangle_over() {
        let arrow = [[0.0, 0.0], [1.0, 0.0], [0.2, 0.2], [0.0, 1.0]].map(|[x, y]| DVec3::new(x, y, 0.0));
        let from = |first: usize| {
            let mut places = arrow;
            places.rotate_left(first);
            fan(&places, DVec3::Z)
        };
        assert_eq!([0, 1, 2, 3].map(from), [0.0, 180.0, 0.0, 180.0]);
    }
}
