//! The two precisions of generic formulas.

use std::fmt::{Debug, Display};
use std::ops::{Add, AddAssign, Div, Mul, Neg, Sub};

mod sealed {
    pub trait Sealed {}
    impl Sealed for f32 {}
    impl Sealed for f64 {}
}

/// `f32` for pictures, `f64` for probes: a formula that is generic over this is written once and rounded twice.
///
/// Only operations that IEEE 754 rounds correctly, so that the bits are the same on any CPU.
pub trait Real:
    sealed::Sealed
    + bytemuck::Pod
    + Debug
    + Display
    + Default
    + PartialOrd
    + Add<Output = Self>
    + Sub<Output = Self>
    + Mul<Output = Self>
    + Div<Output = Self>
    + Neg<Output = Self>
    + AddAssign
    + Send
    + Sync
{
    /// 0.
    const ZERO: Self;
    /// 1.
    const ONE: Self;
    /// The distance from 1 to the next number.
    const EPSILON: Self;
    /// The smallest normal number.
    const MIN_POSITIVE: Self;
    /// −∞: below every finite number.
    const NEG_INFINITY: Self;
    /// The largest finite number.
    const MAX: Self;
    /// Not a number.
    const NAN: Self;
    /// Terms of the series that [`Power`](super::Power) needs to be right to the last bits: of log2 and of exp2.
    #[doc(hidden)]
    const SERIES: (usize, usize);
    /// The exponents of the smallest and the largest normal power of two.
    #[doc(hidden)]
    const EXPONENTS: (f64, f64);

    /// The nearest number of this precision.
    fn of(x: f64) -> Self;

    /// The same number in double precision.
    fn to_f64(self) -> f64;

    /// √x, correctly rounded.
    fn sqrt(self) -> Self;

    /// |x|.
    fn abs(self) -> Self;

    /// Neither infinite nor NaN.
    fn is_finite(self) -> bool;

    /// `(m, e)` with x = m·2^e and √½ ≤ m < √2, for positive normal numbers.
    #[doc(hidden)]
    fn split_exponent(self) -> (Self, Self);

    /// The nearest whole number, ties to even, for magnitudes of up to 2^21.
    #[doc(hidden)]
    fn nearest(self) -> Self;

    /// 2^x for a whole x within [`EXPONENTS`](Self::EXPONENTS).
    #[doc(hidden)]
    fn power_of_two(self) -> Self;
}

/// All that differs between the two: widths of the fields of a number.
macro_rules! real {
    ($real:ty, $signed:ty, $mantissa:literal, $bias:literal, $series:expr) => {
        impl Real for $real {
            const ZERO: Self = 0.0;
            const ONE: Self = 1.0;
            const EPSILON: Self = <$real>::EPSILON;
            const MIN_POSITIVE: Self = <$real>::MIN_POSITIVE;
            const NEG_INFINITY: Self = <$real>::NEG_INFINITY;
            const MAX: Self = <$real>::MAX;
            const NAN: Self = <$real>::NAN;
            const SERIES: (usize, usize) = $series;
            const EXPONENTS: (f64, f64) = (1.0 - $bias, $bias);

            #[inline(always)]
            fn of(x: f64) -> Self {
                x as $real
            }

            #[inline(always)]
            fn to_f64(self) -> f64 {
                f64::from(self)
            }

            #[inline(always)]
            fn sqrt(self) -> Self {
                self.sqrt()
            }

            #[inline(always)]
            fn abs(self) -> Self {
                self.abs()
            }

            #[inline(always)]
            fn is_finite(self) -> bool {
                self.is_finite()
            }

            #[inline(always)]
            fn split_exponent(self) -> (Self, Self) {
                const SQRT_HALF: $signed = (std::f64::consts::FRAC_1_SQRT_2 as $real).to_bits() as $signed;
                let bits = self.to_bits() as $signed;
                let exponent = bits.wrapping_sub(SQRT_HALF) >> $mantissa;
                let significand = <$real>::from_bits(bits.wrapping_sub(exponent << $mantissa) as _);
                (significand, exponent as $real)
            }

            #[inline(always)]
            fn nearest(self) -> Self {
                (self + ROUND) - ROUND
            }

            #[inline(always)]
            fn power_of_two(self) -> Self {
                // The sum's lowest bits are the biased exponent, ready to be moved to where exponents are.
                <$real>::from_bits((self + (ROUND + $bias)).to_bits() << $mantissa)
            }
        }
    };
}

mod single {
    use super::Real;
    /// 1.5·2^23: a sum with this has no fraction bits.
    const ROUND: f32 = 12_582_912.0;
    real!(f32, i32, 23, 127.0, (5, 8));
}

mod double {
    use super::Real;
    /// 1.5·2^52.
    const ROUND: f64 = 6_755_399_441_055_744.0;
    real!(f64, i64, 52, 1023.0, (10, 14));
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::num::test_numbers::Numbers;

    fn splits_and_powers<R: Real>() {
        let mut numbers = Numbers::new(31);
        let (low, high) = R::EXPONENTS;
        for _ in 0..20_000 {
            let x = R::of(numbers.spread(-low as i32).abs());
            let (m, e) = x.split_exponent();
            let m64 = m.to_f64();
            assert!((0.5..2.0).contains(&(m64 * m64 * (1.0 + 1e-7))), "{x}: {m}");
            assert_eq!(m64 * libm::ldexp(1.0, e.to_f64() as i32), x.to_f64());
        }
        for exponent in low as i32..=high as i32 {
            assert_eq!(R::of(f64::from(exponent)).power_of_two().to_f64(), libm::ldexp(1.0, exponent));
        }
        for (x, whole) in [(0.5, 0.0), (1.5, 2.0), (-2.5, -2.0), (-1077.75, -1078.0), (130.49, 130.0)] {
            assert_eq!(R::of(x).nearest(), R::of(whole));
        }
    }

    #[test]
    fn exponents_and_whole_numbers_in_both_precisions() {
        splits_and_powers::<f32>();
        splits_and_powers::<f64>();
    }
}
