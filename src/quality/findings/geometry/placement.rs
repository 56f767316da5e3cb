//! Where a mesh is: so far from the origin that rounding turns its normals, or mirrored or flattened by its nodes.

use crate::io::FileNode;
use crate::mesh::normal_matrix;
use crate::num::{Degrees, Radians};
use crate::quality::effect::key_light_lost;
use crate::quality::findings::prelude::*;
use glam::{DMat3, DVec3};

/// The most faces that are sampled.
const SAMPLE: usize = 10_000;

/// Measures what rounding does to the normal of a usual face.
pub(crate) fn search_distance(facts: &Facts<'_>, found: &mut Found) {
    let Some((low, high)) = facts.mesh.bounds() else { return };
    let farthest = low.abs().max(high.abs()).max_element() * facts.scale;
    // A dense mesh around the origin has small faces too; far is outside of its own size.
    if farthest < 4.0 * facts.size {
        return;
    }
    let last_place = |x: f64| f64::from((x as f32).next_up()) - f64::from(x as f32);
    let units = DVec3::from(low.abs().max(high.abs()).to_array().map(last_place)) * facts.scale;
    let stride = facts.mesh.face_count().div_ceil(SAMPLE).max(1);
    let sampled = (0..facts.mesh.face_count()).step_by(stride).filter(|&face| facts.area[face] > 0.0);
    let (mut heights, tilts): (Vec<f64>, Vec<f64>) =
        sampled.map(|face| (height(facts, face), expected_tilt(facts, face, units))).unzip();
    if heights.is_empty() {
        return;
    }
    heights.sort_unstable_by(f64::total_cmp);
    let height = heights[heights.len() / 2];
    let tilt = tilts.iter().sum::<f64>() / tilts.len() as f64;
    // Half a unit in the last place of 24 bits at both ends of the height.
    let rounding = farthest * f64::from(f32::EPSILON) / 2.0;
    let error = Degrees::from(Radians(libm::atan2(2.0 * rounding, height))).0;
    if error > facts.thresholds.rounding.0 {
        found.add(Kind::FarFromOrigin, Spot::mesh().by(error), facts.total_area);
        let bits = libm::floor(libm::log2(height / rounding)).max(0.0);
        let expected = Degrees::from(Radians(libm::atan(tilt))).0;
        let [largest, mean] = [error, expected].map(|degrees| Value::digits(&format!("{degrees:.2}")));
        let values = [("bits", bits.to_string().into()), ("largest", largest), ("mean", mean)];
        let text = REMARKS.with("far-from-origin", &values);
        found.tally(Kind::FarFromOrigin).remark = Some(Remark { weight: error, text });
    }
}

/// The height of a triangle above its longest edge; of a polygon, that of a triangle of its area.
fn height(facts: &Facts<'_>, face: usize) -> f64 {
    let edges = facts.corners_of(face).map(|corner| facts.edge(corner).length_squared());
    let slenderness = 2.0 * facts.area[face] / edges.fold(0.0, f64::max);
    (2.0 * facts.area[face] * slenderness).sqrt()
}

/// The mean tangent of the angle by which a face's normal turns if each coordinate of its corners is rounded to multiples of a
/// unit in the last place: errors eᵢ along the normal n, of variance Σ (n units)²/12, turn the area vector ½ Σ pᵢ × pᵢ₊₁ by
/// ½ Σ eᵢ n × (pᵢ₊₁ − pᵢ₋₁), and the mean length of such a plane vector is √(π/4) of its root mean square.
fn expected_tilt(facts: &Facts<'_>, face: usize, units: DVec3) -> f64 {
    let position = |corner: u32| facts.position(corner as usize);
    let chord =
        |corner: u32| position(facts.topology.next(corner)) - position(facts.topology.previous(corner));
    let squares = facts.corners_of(face).map(|corner| chord(corner as u32).length_squared());
    let inverse_heights = squares.sum::<f64>().sqrt() / (2.0 * facts.area[face]);
    let along = (facts.face_normal(face) * units).length() / 12f64.sqrt();
    (std::f64::consts::PI / 4.0).sqrt() * along * inverse_heights
}

/// Checks the matrices that place a part in the world.
pub(crate) fn search_nodes(nodes: &[&FileNode], found: &mut Found) {
    for (number, node) in nodes.iter().enumerate() {
        match normal_matrix(DMat3::from_mat4(node.world_from_part)) {
            None => {
                let spot = Spot::node(number).of(Measure::Steps, key_light_lost());
                found.add(Kind::SingularNode, spot, 0.0);
            }
            // Half a turn in a viewer that does not reverse the winding.
            Some(matrix) if matrix.mirrored() => {
                found.add(Kind::MirroredNode, Spot::node(number).by(180.0), 0.0)
            }
            Some(_) => {}
        }
    }
}
