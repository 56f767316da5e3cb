//! Boxes, cut in every way: whether a weight depends on how flat faces are triangulated.

use super::angles::angle_between;
use super::vertex::recipe;
use crate::mesh::{Faces, Mesh};
use crate::normals::{Weight, compute};
use crate::num::Degrees;
use glam::DVec3;
use serde::Serialize;

/// How far the normals at the corners of a box are from its space diagonals, over all 64 ways to cut its six sides in two
/// triangles each.
///
/// A weight that gives one value whatever the cut is *invariant*; one that gives 0 is also *right* for a cube. Those are two
/// things: Max's weights on a long box are invariant at 46.7°.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct BoxRow {
    /// The lengths of the sides.
    pub sides: [f64; 3],
    /// The weight.
    pub weight: Weight,
    /// The deviations that occur, in degrees, ascending; those closer than 10⁻⁹ once.
    pub deviations: Vec<f64>,
}

impl BoxRow {
    /// Whether the cut makes no difference.
    pub fn is_invariant(&self) -> bool {
        self.deviations.len() == 1
    }
}

/// The rows of the cube and of the box 1 × 1 × 10, for every weight that sums faces.
pub fn box_rows() -> Vec<BoxRow> {
    let boxes = [[1.0, 1.0, 1.0], [1.0, 1.0, 10.0]];
    let weights = || Weight::SUMS.into_iter();
    boxes.into_iter().flat_map(|sides| weights().map(move |weight| row(sides, weight))).collect()
}

fn row(sides: [f64; 3], weight: Weight) -> BoxRow {
    let mut deviations: Vec<f64> = (0..64).flat_map(|cut| of_cut(sides, weight, cut)).collect();
    deviations.sort_by(f64::total_cmp);
    deviations.dedup_by(|next, kept| (*next - *kept).abs() < 1e-9);
    BoxRow { sides, weight, deviations }
}

/// The deviations at the eight corners, the bits of `cut` telling which diagonal each side has.
fn of_cut(sides: [f64; 3], weight: Weight, cut: u32) -> Vec<f64> {
    // Bit k of a corner's number: whether it is at the far end along axis k.
    let far = |corner: u32, axis: u32| corner >> axis & 1 == 1;
    let position = |corner: u32| {
        DVec3::from_array(std::array::from_fn(
            |axis| if far(corner, axis as u32) { sides[axis] } else { 0.0 },
        ))
    };
    let mut triangles = Vec::with_capacity(36);
    for side in 0..6_u32 {
        let (axis, end) = (side / 2, side % 2);
        let (u, v) = (1 << ((axis + 1) % 3), 1 << ((axis + 2) % 3));
        let base = end << axis;
        // Counter-clockwise from outside, for a side at the far end.
        let mut quad = [base, base + u, base + u + v, base + v];
        if end == 0 {
            quad.reverse();
        }
        quad.rotate_left((cut >> side & 1) as usize);
        let [a, b, c, d] = quad;
        triangles.extend([a, b, c, a, c, d]);
    }
    let positions: Vec<DVec3> = (0..8).map(position).collect();
    let mesh = Mesh::new(positions, Faces::triangles(triangles)).expect("a box is a sound mesh");
    let field = compute(&mesh, &recipe(weight));
    let deviation = |(&normal, &vertex): (&DVec3, &u32)| {
        let diagonal =
            DVec3::from_array(std::array::from_fn(|axis| if far(vertex, axis as u32) { 1.0 } else { -1.0 }));
        Degrees::from(angle_between(normal, diagonal)).0
    };
    field.normals.values.iter().zip(&field.entry_vertex).map(deviation).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    fn deviations(long: bool, weight: Weight) -> Vec<f64> {
        let rows = box_rows().into_iter();
        let mut of = rows.filter(|row| (row.sides[2] > 1.0) == long && row.weight == weight);
        of.next().unwrap().deviations
    }

    fn assert_printed(found: &[f64], printed: &[f64], unit: f64) {
        let same = found.len() == printed.len()
            && found.iter().zip(printed).all(|(found, printed)| (found - printed).abs() <= 0.500_001 * unit);
        assert!(same, "{found:?} is not {printed:?}");
    }

    /// All 64 triangulations; figures computed outside this program.
    #[test]
    fn cubes_and_boxes_deviate_as_published() {
        for weight in [Weight::Angle, Weight::Max] {
            assert_printed(&deviations(false, weight), &[0.0], 1e-12);
        }
        for weight in [Weight::Uniform, Weight::Area] {
            assert_printed(&deviations(false, weight), &[0.0, 15.7932, 19.4712], 1e-4);
        }
        assert_printed(&deviations(false, Weight::Edge), &[0.0, 8.699, 9.736], 1e-3);
        assert_printed(&deviations(true, Weight::Angle), &[0.0], 1e-12);
        assert_printed(&deviations(true, Weight::Uniform), &[0.0, 15.793, 19.471], 1e-3);
        assert_printed(&deviations(true, Weight::Max), &[46.686], 1e-3);
        let area = deviations(true, Weight::Area);
        assert_printed(&[area[0], area[area.len() - 1]], &[27.2, 36.9], 0.1);
    }
}
