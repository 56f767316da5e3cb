//! Exact products, with and without a fused multiply-add.

use crate::num::real::Real;
use glam::DVec3;

/// A way to multiply two numbers without losing anything.
///
/// Both ways give the same bits, so a kernel compiled twice, once for each, gives the same bits on any CPU.
/// They hold as long as the product is below 2^996 and neither it nor its last bit falls under the subnormal
/// range: |ab| ≥ 2^-968, or ab = 0.
pub(crate) trait Product<R = f64>: Copy + Send + Sync + 'static {
    /// `(p, e)` with p = fl(ab) and p + e = ab exactly.
    fn two_product(a: R, b: R) -> (R, R);

    /// The results of all lanes.
    #[inline(always)]
    fn each<T, const N: usize>(lane: impl Fn(usize) -> T) -> [T; N] {
        std::array::from_fn(lane)
    }
}

/// By fused multiply-add. Only for code that is compiled with the instruction: without it, `mul_add` is a call
/// of a library function that is slow, though right.
#[derive(Clone, Copy)]
#[cfg_attr(not(any(target_arch = "x86_64", target_arch = "aarch64")), allow(dead_code))]
pub(crate) struct Fused;

impl Product for Fused {
    #[inline(always)]
    fn two_product(a: f64, b: f64) -> (f64, f64) {
        let p = a * b;
        (p, a.mul_add(b, -p))
    }
}

/// By splitting each factor in two halves whose products are exact (Veltkamp 1968, Dekker 1971).
#[derive(Clone, Copy)]
pub(crate) struct Split;

impl Product for Split {
    #[inline(always)]
    fn two_product(a: f64, b: f64) -> (f64, f64) {
        let p = a * b;
        let ((ah, al), (bh, bl)) = (split(a), split(b));
        (p, al * bl - (((p - ah * bh) - al * bh) - ah * bl))
    }

    /// A call for each step: written out, kernels without vector instructions took half of the time that the crate
    /// takes to compile.
    #[inline(never)]
    fn each<T, const N: usize>(lane: impl Fn(usize) -> T) -> [T; N] {
        std::array::from_fn(lane)
    }
}

/// Without the error, for single precision that is meant to be fast.
#[derive(Clone, Copy)]
pub(crate) struct Uncorrected;

impl<R: Real> Product<R> for Uncorrected {
    #[inline(always)]
    fn two_product(a: R, b: R) -> (R, R) {
        (a * b, R::ZERO)
    }

    #[inline]
    fn each<T, const N: usize>(lane: impl Fn(usize) -> T) -> [T; N] {
        std::array::from_fn(lane)
    }
}

/// The upper 26 bits of a significand and the rest.
#[inline(always)]
fn split(a: f64) -> (f64, f64) {
    const FACTOR: f64 = 134_217_729.0; // 2^27 + 1
    let c = FACTOR * a;
    let high = c - (c - a);
    (high, a - high)
}

/// ab − cd with a relative error of at most 2u, u = 2^-53 (Cornea, Harrison & Tang 2002; bound: Jeannerod 2015).
/// Zero exactly when ab = cd.
#[inline(always)]
pub(crate) fn difference_of_products<P: Product>(a: f64, b: f64, c: f64, d: f64) -> f64 {
    let ((p, ep), (q, eq)) = (P::two_product(a, b), P::two_product(c, d));
    (p - q) + (ep - eq)
}

/// u × v, each component within 2u of its own value (u = 2^-53), however much its products cancel.
#[inline(always)]
pub(crate) fn cross<P: Product>(u: DVec3, v: DVec3) -> DVec3 {
    DVec3::new(
        difference_of_products::<P>(u.y, v.z, u.z, v.y),
        difference_of_products::<P>(u.z, v.x, u.x, v.z),
        difference_of_products::<P>(u.x, v.y, u.y, v.x),
    )
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::num::test_numbers::Numbers;
    use dashu_ratio::RBig;

    fn exact(x: f64) -> RBig {
        RBig::try_from(x).unwrap()
    }

    #[test]
    fn both_ways_give_the_same_bits() {
        let mut numbers = Numbers::new(1);
        for _ in 0..2_000_000 {
            let (a, b) = (numbers.spread(400), numbers.spread(400));
            let (fused, split) = (Fused::two_product(a, b), Split::two_product(a, b));
            assert_eq!(
                (fused.0.to_bits(), fused.1.to_bits()),
                (split.0.to_bits(), split.1.to_bits()),
                "{a:e} {b:e}"
            );
        }
    }

    #[test]
    fn nothing_is_lost() {
        let mut numbers = Numbers::new(2);
        for _ in 0..20_000 {
            let (a, b) = (numbers.spread(400), numbers.spread(400));
            let (p, e) = Split::two_product(a, b);
            assert_eq!(exact(p) + exact(e), exact(a) * exact(b), "{a:e} {b:e}");
        }
    }

    #[test]
    fn difference_keeps_a_relative_error_of_two_units() {
        // Pharr's case (2019) in spirit: nearly equal products, where the plain formula has no right digit.
        let mut numbers = Numbers::new(3);
        let bound = RBig::try_from(f64::EPSILON).unwrap();
        let (mut worst_plain, mut zero) = (0.0, 0);
        for _ in 0..20_000 {
            let (a, b, c) = (numbers.spread(20), numbers.spread(20), numbers.spread(20));
            let d = a * b / c;
            let truth = exact(a) * exact(b) - exact(c) * exact(d);
            let got = difference_of_products::<Split>(a, b, c, d);
            if truth == RBig::ZERO {
                assert_eq!(got, 0.0);
                zero += 1;
                continue;
            }
            let error = (exact(got) - &truth) / &truth;
            assert!(error.clone() * error.clone().signum() <= bound, "{a:e} {b:e} {c:e} {d:e}");
            worst_plain = f64::max(worst_plain, ((a * b - c * d) / truth.to_f64().value() - 1.0).abs());
        }
        assert!(worst_plain > 0.5 && zero < 2000, "the inputs are too easy: {worst_plain} {zero}");
    }
}
