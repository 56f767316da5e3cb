//! The angle of a corner, without the platform's arc tangent.

use super::lanes::{Arithmetic, OneLane, Scalars};
use std::f64::consts::{FRAC_PI_2, FRAC_PI_4, PI};

/// tan(π/8) and tan(3π/8): between them the angle is measured from π/4, beyond from 0 or π/2.
const TAN_PI_8: f64 = 0.414_213_562_373_095_05;
const TAN_3PI_8: f64 = 2.414_213_562_373_095;
/// What the nearest double below π leaves of it.
const PI_LOW: f64 = 1.224_646_799_147_353_2e-16;

/// Minimax coefficients of (atan z / z − 1) / z² in z², for |z| ≤ tan(π/8): relative error of atan z below 2^-54.5.
const ATAN: [f64; 10] = [
    -0.333_333_333_333_301_56,
    0.199_999_999_990_899_6,
    -0.142_857_141_953_379_45,
    0.111_111_066_564_506_45,
    -0.090_907_824_730_678_32,
    0.076_900_690_745_726_63,
    -0.066_411_272_662_439_49,
    0.056_925_676_238_617_544,
    -0.043_591_695_825_672_83,
    0.021_260_660_905_408_825,
];

/// atan2(y, x) for y ≥ 0, in [0, π]: the angle with the sine y and the cosine x, up to a common factor.
///
/// The error is at most 2 ulp wherever y/x neither overflows nor underflows. There is one division and no fused operation,
/// so it gives the same bits on every CPU.
/// Both arguments zero give NaN: there is no angle.
#[inline(always)]
pub(crate) fn corner_angle(y: f64, x: f64) -> f64 {
    let ax = x.abs();
    let (below, above) = (y < TAN_PI_8 * ax, y > TAN_3PI_8 * ax);
    let select = |low: f64, middle: f64, high: f64| {
        let upper = if above { high } else { middle };
        if below { low } else { upper }
    };
    let z = select(y, y - ax, -ax) / select(ax, y + ax, y);
    // Each base angle is a sum of two doubles; the lower one goes into the small part.
    let (base, base_low) = (select(0.0, FRAC_PI_4, FRAC_PI_2), select(0.0, 0.25 * PI_LOW, 0.5 * PI_LOW));
    let rest = atan_rest(Scalars::new(OneLane::new(), [z])).value[0];
    let small = z + (rest + base_low);
    if x < 0.0 { (PI - base) - (z + ((rest + base_low) - PI_LOW)) } else { base + small }
}

/// The three angles of a triangle, from twice its area and the dot product of the two edges at each corner.
///
/// The largest angle, which is the one with the smallest dot product, is what the others leave of π; those are acute, and
/// share one division. The error is at most 4 ulp. Neither branches nor fused operations, as above.
#[inline(always)]
pub(crate) fn triangle_angles<A: Arithmetic>(
    double_area: Scalars<A>,
    dots: [Scalars<A>; 3],
) -> [Scalars<A>; 3] {
    let second = dots[1].less(dots[0]);
    let third = dots[2].less(second.select(dots[1], dots[0]));
    // The dot products at the other two corners, in order.
    let a = third.select(dots[0], second.select(dots[0], dots[1]));
    let b = third.select(dots[1], dots[2]);
    let (a, b) = (Reduced::new(double_area, a), Reduced::new(double_area, b));
    let common = Scalars::splat(double_area.arch, 1.0) / (a.denominator * b.denominator);
    let (a, b) = (a.angle(b.denominator * common), b.angle(a.denominator * common));
    let c = (Scalars::splat(double_area.arch, PI) - a) - b;
    [third.select(a, second.select(a, c)), third.select(b, second.select(c, a)), third.select(c, b)]
}

/// An acute angle as base + atan(numerator / denominator), the quotient within ±tan(π/8).
struct Reduced<A: Arithmetic> {
    numerator: Scalars<A>,
    denominator: Scalars<A>,
    base: Scalars<A>,
}

impl<A: Arithmetic> Reduced<A> {
    /// For y > 0, and x > 0 but for rounding.
    #[inline(always)]
    fn new(y: Scalars<A>, x: Scalars<A>) -> Self {
        let below = y.less(Scalars::splat(y.arch, TAN_PI_8) * x);
        let above = (Scalars::splat(y.arch, TAN_3PI_8) * x).less(y);
        let zero = Scalars::splat(y.arch, 0.0);
        let (quarter, half) = (Scalars::splat(y.arch, FRAC_PI_4), Scalars::splat(y.arch, FRAC_PI_2));
        Self {
            numerator: below.select(y, above.select(zero - x, y - x)),
            denominator: below.select(x, above.select(y, y + x)),
            base: below.select(zero, above.select(half, quarter)),
        }
    }

    #[inline(always)]
    fn angle(&self, reciprocal: Scalars<A>) -> Scalars<A> {
        let z = self.numerator * reciprocal;
        self.base + (z + atan_rest(z))
    }
}

/// atan z − z for |z| ≤ tan(π/8).
#[inline(always)]
fn atan_rest<A: Arithmetic>(z: Scalars<A>) -> Scalars<A> {
    let s = z * z;
    let s2 = s * s;
    let s4 = s2 * s2;
    // Estrin's scheme: short chains, so that the pipeline is kept busy.
    let low = atan_pair(s, 0) + s2 * atan_pair(s, 2);
    let middle = atan_pair(s, 4) + s2 * atan_pair(s, 6);
    z * s * (low + s4 * (middle + s4 * atan_pair(s, 8)))
}

/// Two terms of the polynomial.
#[inline(always)]
fn atan_pair<A: Arithmetic>(s: Scalars<A>, first: usize) -> Scalars<A> {
    Scalars::splat(s.arch, ATAN[first]) + s * Scalars::splat(s.arch, ATAN[first + 1])
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::num::test_numbers::Numbers;

    fn ulps(got: f64, truth: f64) -> u64 {
        (got.to_bits() as i64).abs_diff(truth.to_bits() as i64)
    }

    #[test]
    fn is_within_two_ulps_of_libm() {
        let mut numbers = Numbers::new(5);
        let mut worst = 0;
        for round in 0..3_000_000 {
            let spread = [1, 2, 8, 100][round % 4];
            let (y, x) = (numbers.spread(spread).abs(), numbers.spread(spread));
            // libm's own error is below one ulp, so three here are two of ours.
            let distance = ulps(corner_angle(y, x), libm::atan2(y, x));
            worst = worst.max(distance);
            assert!(distance <= 3, "{y:e} {x:e}: {distance} ulps");
        }
        assert!(worst >= 1, "bit equality would be news");
    }

    #[test]
    fn angles_of_triangles_are_within_four_ulps_of_libm() {
        let mut numbers = Numbers::new(9);
        let mut worst = 0;
        for round in 0..500_000 {
            // A triangle in the plane, down to needles: corners (0, 0), (1, 0) and (x, y).
            let spread = [1, 3, 30, 100][round % 4];
            let (x, y) = (numbers.spread(spread.min(3)), numbers.spread(spread).abs());
            let dots = [x, 1.0 - x, x * (x - 1.0) + y * y];
            let one = |x: f64| Scalars::new(OneLane::new(), [x]);
            let angles = triangle_angles(one(y), dots.map(one)).map(|angle| angle.value[0]);
            let largest = (0..3).min_by(|&i, &j| dots[i].total_cmp(&dots[j])).unwrap();
            for corner in (0..3).filter(|&corner| corner != largest) {
                // libm's own error is below one ulp.
                let distance = ulps(angles[corner], libm::atan2(y, dots[corner]));
                worst = worst.max(distance);
                assert!(distance <= 5, "{x:e} {y:e}: {distance} ulps");
            }
            let sum: f64 = angles.iter().sum();
            assert!((sum - PI).abs() <= 4.0 * f64::EPSILON, "{x:e} {y:e}: {angles:?}");
        }
        assert!(worst >= 2, "the bound is needed: {worst}");
    }

    #[test]
    fn exact_angles() {
        assert_eq!(corner_angle(0.0, 1.0), 0.0);
        assert_eq!(corner_angle(0.0, -1.0), PI);
        assert_eq!(corner_angle(1.0, 0.0), FRAC_PI_2);
        assert_eq!(corner_angle(1.0, 1.0), FRAC_PI_4);
        assert_eq!(corner_angle(1.0, -1.0), 3.0 * FRAC_PI_4);
        assert_eq!(corner_angle(1e-300, 1.0), 1e-300);
        assert!(corner_angle(0.0, 0.0).is_nan());
    }
}
