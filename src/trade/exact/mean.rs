//! Vertex normals by their formula, in 256 bits.

use super::vector::{Vector, add, cross, difference, dot, length, unit};
use super::{Big, big};
use crate::normals::Weight;
use glam::DVec3;
use rayon::prelude::*;

/// Faces that are summed in one task; fixed, so that the sum does not depend on the number of threads.
const CHUNK: usize = 4096;

/// The unit vector along Σ w n̂ over triangles (centre, a, b); `None` where it is zero. Triangles without area add nothing.
///
/// # Panics
/// For [`Weight::Quadric`], which is no weight.
pub(crate) fn vertex_normal(centre: DVec3, fan: &[[DVec3; 2]], weight: Weight) -> Option<Vector> {
    let chunks: Vec<Option<Vector>> = fan
        .par_chunks(CHUNK)
        .map(|chunk| chunk.iter().filter_map(|&[a, b]| term(centre, a, b, weight)).reduce(add))
        .collect();
    unit(&chunks.into_iter().flatten().reduce(add)?)
}

/// w n̂ of one triangle: e1×e2 times a factor.
fn term(centre: DVec3, a: DVec3, b: DVec3, weight: Weight) -> Option<Vector> {
    let (e1, e2) = (difference(a, centre), difference(b, centre));
    let normal = cross(&e1, &e2);
    let area = length(&normal);
    if area == Big::ZERO {
        return None;
    }
    let angle = || area.atan2(&dot(&e1, &e2));
    let squares = || dot(&e1, &e1) * dot(&e2, &e2);
    let times = |factor: Big| -> Vector { std::array::from_fn(|axis| &normal[axis] * &factor) };
    let inverse = |x: Big| big(1.0) / x;
    Some(match weight {
        Weight::Uniform => times(inverse(area)),
        Weight::Area => normal,
        Weight::Angle => times(angle() / &area),
        Weight::AngleArea => times(angle()),
        Weight::Max => times(inverse(squares())),
        Weight::Edge => times(inverse(area * squares().sqrt())),
        Weight::Quadric => unreachable!("a fit, not a weight"),
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::trade::exact::vector::angle_to;

    /// The corner of a box of 1 × 2 × 4, of which each weight has its own closed form.
    #[test]
    fn the_corner_of_a_box_by_every_weight() {
        let [a, b, c] = [DVec3::X, DVec3::Y * 2.0, DVec3::Z * 4.0];
        let fan = [[a, b], [b, c], [c, a]];
        for (weight, expected) in [
            (Weight::Uniform, DVec3::ONE),
            (Weight::Area, DVec3::new(8.0, 4.0, 2.0)),
            (Weight::Angle, DVec3::ONE),
            (Weight::AngleArea, DVec3::new(8.0, 4.0, 2.0)),
            // 1/(|e1| |e2|), and the sine is 1.
            (Weight::Max, DVec3::new(1.0 / 8.0, 1.0 / 4.0, 1.0 / 2.0)),
            (Weight::Edge, DVec3::new(1.0 / 8.0, 1.0 / 4.0, 1.0 / 2.0)),
        ] {
            let normal = vertex_normal(DVec3::ZERO, &fan, weight).unwrap();
            assert!(angle_to(expected, &normal) < 1e-15, "{weight:?}");
        }
    }

    #[test]
    fn what_cancels_has_no_direction() {
        let fan = [[DVec3::X, DVec3::Y], [DVec3::Y, DVec3::X]];
        assert!(vertex_normal(DVec3::ZERO, &fan, Weight::Uniform).is_none());
        assert!(vertex_normal(DVec3::ZERO, &[[DVec3::X, DVec3::X]], Weight::Area).is_none());
    }
}
