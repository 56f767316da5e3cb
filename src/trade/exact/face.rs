//! Faces and vertices: exact areas of faces; normals of faces, dihedral angles, rotations and vertex normals in 256 bits.

use super::vector::{Vector, add, angle, cross, difference, dot, length, unit};
use super::{BITS, Big, big, exact};
use crate::normals::Weight;
use crate::num::parallel;
use glam::DVec3;

/// Twice the area vector: Σ Pi × Pi+1, which is exact here wherever the origin is. The formulas of the kernels are others, so that a
/// comparison tests them.
fn area_vector(points: &[DVec3]) -> Vector {
    let points: Vec<Vector> = points.iter().map(|point| point.to_array().map(exact)).collect();
    let next = points.iter().cycle().skip(1);
    points.iter().zip(next).map(|(p, q)| cross(p, q)).reduce(add).expect("a face has corners")
}

/// The unit normal to 256 bits; `None` for zero area.
pub(crate) fn face_normal(points: &[DVec3]) -> Option<Vector> {
    unit(&area_vector(points).map(|x| x.with_precision(BITS).value()))
}

/// Whether the area is exactly zero.
pub(crate) fn degenerate(points: &[DVec3]) -> bool {
    area_vector(points).iter().all(|component| *component == Big::ZERO)
}

/// The angle between the normals of two faces, in radians; `None` if one has no area.
pub(crate) fn dihedral(a: &[DVec3], b: &[DVec3]) -> Option<Big> {
    Some(angle(&face_normal(a)?, &face_normal(b)?))
}

/// An angle in radians.
pub(crate) fn radians(degrees: f64) -> Big {
    // π/4 is the angle of (1, 1).
    big(degrees) * big(1.0).atan2(&big(1.0)) / big(45.0)
}

/// Most by which the normal of a face turns if no corner moves by more than δ: the arc sine of
/// δ (Σ|Pᵢ₊₁ − Pᵢ₋₁| + nδ) / |Σ Pᵢ × Pᵢ₊₁|, or half a turn where that is none.
pub(crate) fn turn(points: &[DVec3], moved: &Big) -> Big {
    let at = |corner: usize| points[corner % points.len()];
    let corners = || 0..points.len();
    let from_first = |corner: usize| difference(at(corner), points[0]);
    let terms = corners().map(|corner| cross(&from_first(corner), &from_first(corner + 1)));
    let area = terms.reduce(add).map_or(Big::ZERO, |sum| length(&sum));
    let diagonals = corners().map(|corner| length(&difference(at(corner + 2), at(corner))));
    let reach = diagonals.fold(moved * big(points.len() as f64), |sum, diagonal| sum + diagonal) * moved;
    if reach >= area {
        return radians(180.0);
    }
    reach.atan2(&(&area * &area - &reach * &reach).sqrt())
}

/// Faces that are summed in one task; fixed, so that the sum does not depend on the number of threads.
const CHUNK: usize = 4096;

/// The unit vector along Σ w n̂ over triangles (centre, a, b); `None` where it is zero. Triangles without area add nothing.
///
/// # Panics
/// For a [fit](Weight::is_fit).
pub(crate) fn vertex_normal(centre: DVec3, fan: &[[DVec3; 2]], weight: Weight) -> Option<Vector> {
    let chunks = parallel::blocks(fan.len(), CHUNK, |chunk| {
        fan[chunk].iter().filter_map(|&[a, b]| term(centre, a, b, weight)).reduce(add)
    });
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
        Weight::Quadric | Weight::Jet | Weight::Best => unreachable!("a fit, not a sum"),
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::trade::exact::small;
    use crate::trade::exact::vector::angle_to;
    use std::f64::consts::{FRAC_PI_2, PI};

    const SQUARE: [DVec3; 4] = [DVec3::ZERO, DVec3::X, DVec3::new(1.0, 1.0, 0.0), DVec3::Y];

    #[test]
    fn a_wall_stands_square_on_the_floor() {
        let wall = [DVec3::Y, DVec3::new(1.0, 1.0, 0.0), DVec3::new(1.0, 1.0, 2.0)];
        assert_eq!(small(&dihedral(&SQUARE, &wall).unwrap()), FRAC_PI_2);
        assert_eq!([small(&radians(180.0)), small(&radians(40.0))], [PI, 40_f64.to_radians()]);
        assert!(dihedral(&SQUARE, &[DVec3::X; 3]).is_none());
    }

    /// Four corners, four diagonals of √2 (two, each way), twice the area 2.
    #[test]
    fn a_square_turns_by_its_formula() {
        let moved = 1e-3;
        let expected = libm::asin(moved * (4.0 * 2.0_f64.sqrt() + 4.0 * moved) / 2.0);
        assert!((small(&turn(&SQUARE, &big(moved))) - expected).abs() < 1e-17);
        assert_eq!(small(&turn(&SQUARE, &big(1.0))), PI);
    }

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
