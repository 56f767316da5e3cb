//! Vectors of length 1.

use glam::DVec3;

/// A vector of length 1, within 2^-51.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct UnitVec3(DVec3);

impl UnitVec3 {
    /// The direction of a vector of any length: no epsilon, no overflow. `None` for zero, and for vectors with
    /// an infinite or undefined component.
    ///
    /// ```
    /// use crease::num::UnitVec3;
    /// use glam::DVec3;
    ///
    /// assert_eq!(UnitVec3::new(DVec3::new(0.0, 3e-320, 0.0)).map(UnitVec3::get), Some(DVec3::Y));
    /// assert_eq!(UnitVec3::new(DVec3::ZERO), None);
    /// ```
    #[inline(always)]
    pub fn new(v: DVec3) -> Option<Self> {
        // Neither zero nor what is not finite has such a square.
        let squared = squared_length(v);
        if is_plain(squared) { Some(Self(v * (1.0 / squared.sqrt()))) } else { Self::of_any_size(v) }
    }

    #[cold]
    fn of_any_size(v: DVec3) -> Option<Self> {
        let largest = v.abs().max_element();
        if largest == 0.0 || !v.is_finite() {
            return None;
        }
        Some(Self(direction(v).0))
    }

    /// The vector.
    #[inline]
    pub fn get(self) -> DVec3 {
        self.0
    }
}

/// Between these, squared lengths and what they are sums of keep all their bits.
pub(crate) const PLAIN_SQUARES: (f64, f64) = (1e-240, 1e240);

/// Direction and length of a finite vector other than zero, the same bits at any scale: a power of two brings
/// it into range first where it must.
#[inline(always)]
pub(crate) fn direction(v: DVec3) -> (DVec3, f64) {
    let squared = squared_length(v);
    if is_plain(squared) {
        let length = squared.sqrt();
        return (v * (1.0 / length), length);
    }
    let exponent = exponent(v.abs().max_element());
    let scaled = scale(v, -exponent);
    let length = squared_length(scaled).sqrt();
    (scaled * (1.0 / length), libm::ldexp(length, exponent))
}

/// Whether a squared length has lost nothing: `direction` then takes its plain way, which is every time in practice.
#[inline(always)]
fn is_plain(squared: f64) -> bool {
    (PLAIN_SQUARES.0..=PLAIN_SQUARES.1).contains(&squared)
}

/// x² + y² + z², added in this order everywhere.
#[inline(always)]
pub(crate) fn squared_length(v: DVec3) -> f64 {
    (v.x * v.x + v.y * v.y) + v.z * v.z
}

/// The binary exponent of a finite number: 2^e ≤ |x| < 2^(e+1). For 0 that of the smallest number.
#[inline]
pub(crate) fn exponent(x: f64) -> i32 {
    let biased = (x.to_bits() >> 52 & 0x7ff) as i32;
    if biased != 0 {
        return biased - 1023;
    }
    let fraction = x.to_bits() & ((1 << 52) - 1);
    -1011 - fraction.leading_zeros().min(63) as i32
}

/// v · 2^k, also where 2^k itself is out of range.
#[inline]
pub(crate) fn scale(v: DVec3, k: i32) -> DVec3 {
    if (-1022..=1023).contains(&k) {
        v * power_of_two(k)
    } else {
        DVec3::new(libm::ldexp(v.x, k), libm::ldexp(v.y, k), libm::ldexp(v.z, k))
    }
}

/// 2^k for −1022 ≤ k ≤ 1023.
#[inline]
pub(crate) fn power_of_two(k: i32) -> f64 {
    debug_assert!((-1022..=1023).contains(&k));
    f64::from_bits(((k + 1023) as u64) << 52)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::num::test_numbers::Numbers;

    #[test]
    fn scaling_by_a_power_of_two_keeps_the_bits() {
        let mut numbers = Numbers::new(6);
        for _ in 0..2000 {
            let v = DVec3::new(numbers.spread(20), numbers.spread(20), numbers.spread(20));
            let unit = UnitVec3::new(v).unwrap();
            assert!((unit.get().length() - 1.0).abs() < 1e-15);
            for k in [-990, -500, -131, 1, 200, 1000] {
                assert_eq!(UnitVec3::new(scale(v, k)), Some(unit), "{v} · 2^{k}");
            }
        }
    }

    #[test]
    fn what_has_no_direction_gives_none() {
        for v in [DVec3::ZERO, DVec3::NAN, DVec3::new(f64::INFINITY, 0.0, 0.0), DVec3::new(0.0, -0.0, 0.0)] {
            assert_eq!(UnitVec3::new(v), None);
        }
    }

    #[test]
    fn exponents_of_all_kinds_of_numbers() {
        for (x, e) in [(1.0, 0), (-3.5, 1), (0.99, -1), (5e-324, -1074), (f64::MIN_POSITIVE, -1022)] {
            assert_eq!(exponent(x), e, "{x:e}");
        }
        assert_eq!(exponent(f64::MIN_POSITIVE / 2.0), -1023);
        assert_eq!(exponent(0.0), -1074);
    }
}
