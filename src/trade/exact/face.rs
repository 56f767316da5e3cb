//! Faces in exact integers.

use super::vector::{Vector, unit};
use super::{BITS, Big};
use dashu::integer::IBig;
use glam::DVec3;

/// Twice the area vector, in units of 2⁻²¹⁴⁸: Σ Pi × Pi+1, which is exact here wherever the origin is. That it is the
/// same as the formulas of the kernels is the first thing that a comparison with it tests.
fn area_vector(points: &[DVec3]) -> [IBig; 3] {
    let points: Vec<[IBig; 3]> = points.iter().map(|point| point.to_array().map(whole)).collect();
    let mut sum = [IBig::ZERO, IBig::ZERO, IBig::ZERO];
    for (i, p) in points.iter().enumerate() {
        let q = &points[(i + 1) % points.len()];
        for (axis, sum) in sum.iter_mut().enumerate() {
            let (j, k) = ((axis + 1) % 3, (axis + 2) % 3);
            *sum += &p[j] * &q[k] - &p[k] * &q[j];
        }
    }
    sum
}

/// The unit normal to 256 bits; `None` for zero area.
pub(crate) fn face_normal(points: &[DVec3]) -> Option<Vector> {
    unit(&area_vector(points).map(|x| Big::from_parts(x, 0).with_precision(BITS).value()))
}

/// Whether the area is exactly zero.
pub(crate) fn degenerate(points: &[DVec3]) -> bool {
    area_vector(points).iter().all(|component| *component == IBig::ZERO)
}

/// A double as a multiple of 2⁻¹⁰⁷⁴.
fn whole(x: f64) -> IBig {
    let bits = x.to_bits();
    let (exponent, fraction) = ((bits >> 52 & 0x7ff) as usize, bits & ((1 << 52) - 1));
    let magnitude =
        if exponent == 0 { IBig::from(fraction) } else { IBig::from(fraction | 1 << 52) << (exponent - 1) };
    if x < 0.0 { -magnitude } else { magnitude }
}
