//! xⁿ by arithmetic alone: no call in the loop, the same bits on every machine, many at once.

use super::Real;
use std::f64::consts::{LN_2, LOG2_E};

/// Whole exponents up to this are done by repeated squaring, whose error grows with n; beyond, by logarithms,
/// whose error grows with log2 of the result.
const LARGEST_SQUARED: f64 = 128.0;

/// How many powers are computed side by side.
const LANES: usize = 16;

/// log2 m = Σ c_k s^(2k+1) with s = (m−1)/(m+1), |s| ≤ 0.1716: c_k = 2/((2k+1) ln 2).
/// The first omitted term is below 2^-28 of the sum with 5 terms (`f32`) and below 2^-55 with 10 (`f64`).
const LOG2: [f64; 10] = {
    let mut c = [0.0; 10];
    let mut k = 0;
    while k < c.len() {
        c[k] = 2.0 * LOG2_E / (2 * k + 1) as f64;
        k += 1;
    }
    c
};

/// 2^r = Σ c_k r^k with |r| ≤ ½: c_k = (ln 2)^k / k!.
/// The first omitted term is below 2^-27 with 8 terms (`f32`) and below 2^-57 with 14 (`f64`).
const EXP2: [f64; 14] = {
    let mut c = [1.0; 14];
    let mut k = 1;
    while k < c.len() {
        c[k] = c[k - 1] * LN_2 / k as f64;
        k += 1;
    }
    c
};

/// log2 x for a positive normal number. Relative error: at most 4 u, u = 2^-24 or 2^-53, also close to x = 1.
#[inline(always)]
pub fn log2<R: Real>(x: R) -> R {
    let (m, e) = x.split_exponent();
    let s = (m - R::ONE) / (m + R::ONE);
    e + s * polynomial::<R>(&LOG2, R::SERIES.0, s * s)
}

/// 2^y for any finite y; ∞ above the range, gradually 0 below it. Relative error: at most 2 u where the result is a
/// normal number.
#[inline(always)]
pub fn exp2<R: Real>(y: R) -> R {
    let (low, high) = (R::of(2.0 * R::EXPONENTS.0), R::of(2.0 * R::EXPONENTS.1));
    let y = if y < low { low } else { y };
    let y = if y > high { high } else { y };
    let whole = y.nearest();
    // Two factors, for 2^whole itself may be no number that a result of this size needs.
    let half = (whole * R::of(0.5)).nearest();
    let fraction = polynomial::<R>(&EXP2, R::SERIES.1, y - whole);
    (fraction * half.power_of_two()) * (whole - half).power_of_two()
}

/// Σ c_k x^k of the first `terms` coefficients, by Horner's rule.
#[inline(always)]
fn polynomial<R: Real>(coefficients: &[f64], terms: usize, x: R) -> R {
    let mut sum = R::of(coefficients[terms - 1]);
    for k in (0..terms - 1).rev() {
        sum = sum * x + R::of(coefficients[k]);
    }
    sum
}

/// What becomes of powers that are too small for a normal number.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Underflow {
    /// They are 0. No subnormal number, which some CPUs are slow with, is ever met on the way.
    #[default]
    Zero,
    /// They lose digits gradually, as IEEE 754 has it.
    Gradual,
}

/// A power function x ↦ xⁿ with a fixed exponent n ≥ 0, as highlights need it:
///
/// - x ≤ 0 gives 0, also for n = 0 (a highlight has no side turned away); NaN stays NaN;
/// - whole n up to 128 by repeated squaring, relative error at most n·u, u = 2^-24 for `f32` and 2^-53 for `f64`;
/// - other n by exp2(n·log2 x) with the module's own polynomials, relative error at most (3 + 4·|log2 xⁿ|)·u. For
///   0 ≤ x ≤ 1 that is an absolute error of at most 4 u;
/// - subnormal x count as 0, and so do results below the normal range unless [`Underflow::Gradual`] is asked for.
///
/// ```
/// use crease::num::{Power, Underflow};
///
/// let square = Power::<f64>::new(2.0, Underflow::Zero);
/// assert_eq!(square.of(0.75), 0.5625);
/// assert_eq!(square.of(-0.75), 0.0);
/// assert_eq!(Power::<f32>::new(1000.0, Underflow::Zero).of(0.9), 0.0); // 0.9^1000 = 2^-152
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Power<R> {
    exponent: Exponent<R>,
    /// What is not above this gives 0.
    floor: R,
}

#[derive(Clone, Copy, Debug, PartialEq)]
enum Exponent<R> {
    Whole(u32),
    Real(R),
}

impl<R: Real> Power<R> {
    /// The power with this exponent, which must be finite and not negative.
    ///
    /// # Panics
    /// If it is not.
    pub fn new(exponent: f64, underflow: Underflow) -> Self {
        assert!(exponent >= 0.0 && exponent.is_finite(), "an exponent of {exponent}");
        let whole = exponent <= LARGEST_SQUARED && exponent == libm::floor(exponent);
        let floor = match underflow {
            // The margin is wider than the errors of results: what is above the floor gives a normal number.
            Underflow::Zero if exponent > 1.0 => {
                libm::exp2((R::EXPONENTS.0 + 1e-4) / exponent) * (1.0 + R::EPSILON.to_f64())
            }
            Underflow::Gradual if whole => 0.0,
            _ => R::MIN_POSITIVE.to_f64(),
        };
        Self {
            exponent: if whole { Exponent::Whole(exponent as u32) } else { Exponent::Real(R::of(exponent)) },
            floor: R::of(floor),
        }
    }

    /// xⁿ.
    #[inline(always)]
    pub fn of(&self, x: R) -> R {
        let [power] = self.side_by_side([x]);
        power
    }

    /// Replaces every x of a row by xⁿ: the same bits as [`of`](Self::of), many at once.
    #[inline(always)]
    pub fn of_row(&self, row: &mut [R]) {
        let (chunks, rest) = row.as_chunks_mut::<LANES>();
        for chunk in chunks {
            *chunk = self.side_by_side(*chunk);
        }
        for x in rest {
            *x = self.of(*x);
        }
    }

    #[inline(always)]
    fn side_by_side<const N: usize>(&self, mut x: [R; N]) -> [R; N] {
        for x in &mut x {
            *x = if *x <= self.floor { R::ZERO } else { *x };
        }
        let mut power = x;
        match self.exponent {
            Exponent::Whole(0) => {
                for power in &mut power {
                    *power = if *power > R::ZERO { R::ONE } else { *power };
                }
            }
            Exponent::Whole(exponent) => {
                // From the highest bit of the exponent down: square, and multiply where the bit is set.
                for bit in (0..exponent.ilog2()).rev() {
                    for power in &mut power {
                        *power = *power * *power;
                    }
                    if exponent >> bit & 1 == 1 {
                        for (power, x) in power.iter_mut().zip(&x) {
                            *power = *power * *x;
                        }
                    }
                }
            }
            Exponent::Real(exponent) => {
                for (power, x) in power.iter_mut().zip(&x) {
                    let value = exp2(exponent * log2(*x));
                    *power = if *x > R::ZERO { value } else { *x };
                }
            }
        }
        power
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::num::test_numbers::Numbers;

    /// The largest error of a function in units of u, relative to the truth in double precision; libm's own error
    /// of one ulp, 2 u of `f64`, is let pass.
    fn worst<R: Real>(cases: impl Iterator<Item = (R, f64)>) -> f64 {
        let u = R::EPSILON.to_f64() / 2.0;
        cases.map(|(got, truth)| ((got.to_f64() - truth) / truth).abs() / u).fold(0.0, f64::max)
    }

    fn errors_of<R: Real>(libms: f64) {
        let mut numbers = Numbers::new(32);
        let (low, high) = R::EXPONENTS;
        let logarithm = worst(
            (0..400_000)
                .map(|round| {
                    let x = match round % 3 {
                        0 => numbers.spread(high as i32 - 1).abs(),
                        1 => 1.0 + numbers.spread(20).abs() * 1e-7,
                        _ => numbers.unit() + 1e-9,
                    };
                    let x = R::of(x);
                    (log2(x), libm::log2(x.to_f64()))
                })
                .filter(|(_, truth)| *truth != 0.0),
        );
        assert!((0.5..=4.0 + libms).contains(&logarithm), "log2 is {logarithm} u off");

        let exponential = worst((0..400_000).map(|_| {
            let y = R::of(low + (high - low) * numbers.unit());
            (exp2(y), libm::exp2(y.to_f64()))
        }));
        assert!((0.5..=2.0 + libms).contains(&exponential), "exp2 is {exponential} u off");
    }

    #[test]
    fn logarithms_and_exponentials_are_within_their_bounds() {
        errors_of::<f32>(0.0);
        errors_of::<f64>(2.0);
    }

    /// Errors in units of the bound that the documentation states.
    fn power_errors<R: Real>(exponent: f64) -> f64 {
        let u = R::EPSILON.to_f64() / 2.0;
        let power = Power::<R>::new(exponent, Underflow::Zero);
        let mut numbers = Numbers::new(33);
        let mut worst = 0.0;
        for _ in 0..40_000 {
            // Uniform in the logarithm of the result, over the whole range of results.
            let x = R::of(libm::exp2(R::EXPONENTS.0 * numbers.unit() / exponent.max(1.0)));
            let (got, truth) = (power.of(x).to_f64(), libm::pow(x.to_f64(), exponent));
            if got == 0.0 {
                // The floor is a rounded number: n roundings of x from the root of the smallest normal number.
                let edge = libm::exp2(1e-4) * libm::exp(exponent * 4.0 * u);
                assert!(truth < R::MIN_POSITIVE.to_f64() * edge, "{x}^{exponent}");
                continue;
            }
            let bound = match power.exponent {
                Exponent::Whole(n) => f64::from(n).max(1.0),
                Exponent::Real(_) => 3.0 + 4.0 * libm::log2(truth).abs(),
            };
            let libms = 2.0 * f64::EPSILON / 2.0;
            worst = f64::max(worst, ((got - truth) / truth).abs() / (bound * u + libms));
        }
        worst
    }

    #[test]
    fn powers_are_within_their_bounds() {
        for exponent in [0.0, 0.3, 1.0, 2.0, 2.5, 3.0, 31.0, 32.5, 100.0, 128.0, 129.0, 1e3, 12_345.6, 1e6] {
            let worst = [power_errors::<f32>(exponent), power_errors::<f64>(exponent)];
            assert!(worst.iter().all(|&worst| worst <= 1.0), "n = {exponent}: {worst:?} of the bound");
        }
        // Not because nothing is computed: the bounds are felt.
        assert!(power_errors::<f32>(12_345.6) > 0.2 && power_errors::<f32>(31.0) > 0.1);
    }

    #[test]
    fn highlights_are_right_to_a_few_units_of_one() {
        let mut numbers = Numbers::new(34);
        for exponent in [0.5, 7.5, 200.0, 1e4] {
            let power = Power::<f32>::new(exponent, Underflow::Zero);
            for _ in 0..40_000 {
                let x = (1.0 - numbers.unit() * numbers.unit()) as f32;
                let error = (f64::from(power.of(x)) - libm::pow(f64::from(x), exponent)).abs();
                assert!(error <= 4.0 * f64::from(f32::EPSILON) / 2.0, "{x}^{exponent}: {error:e}");
            }
        }
    }

    #[test]
    fn a_row_has_the_bits_of_its_numbers() {
        let mut numbers = Numbers::new(35);
        for exponent in [0.0, 1.0, 5.0, 7.25, 64.0, 500.0] {
            for underflow in [Underflow::Zero, Underflow::Gradual] {
                let power = Power::<f32>::new(exponent, underflow);
                let mut row: Vec<f32> = (0..1000).map(|_| numbers.unit() as f32 * 1.2 - 0.1).collect();
                row.extend([0.0, -0.0, 1.0, f32::NAN, 1e-40, -1.0]);
                let single: Vec<u32> = row.iter().map(|&x| power.of(x).to_bits()).collect();
                power.of_row(&mut row);
                assert_eq!(row.iter().map(|x| x.to_bits()).collect::<Vec<_>>(), single);
            }
        }
    }

    #[test]
    fn what_is_not_positive_gives_nothing_and_what_is_undefined_stays_so() {
        for exponent in [0.0, 0.5, 1.0, 2.0, 200.5] {
            let power = Power::<f32>::new(exponent, Underflow::Gradual);
            assert_eq!((power.of(0.0), power.of(-0.5), power.of(1.0)), (0.0, 0.0, 1.0), "n = {exponent}");
            assert!(power.of(f32::NAN).is_nan(), "n = {exponent}");
        }
    }

    #[test]
    fn subnormal_results_are_zero_or_gradual_as_asked() {
        // 0.5^149 is the smallest subnormal number; 0.5^126 the smallest normal one.
        for exponent in [127.0, 127.5] {
            let [zero, gradual] =
                [Underflow::Zero, Underflow::Gradual].map(|u| Power::<f32>::new(exponent, u).of(0.5));
            assert_eq!(zero, 0.0);
            let truth = libm::pow(0.5, exponent);
            assert!((f64::from(gradual) / truth - 1.0).abs() < 1e-5, "{gradual:e} for {truth:e}");
        }
        assert!(Power::<f32>::new(125.0, Underflow::Zero).of(0.5) == libm::exp2f(-125.0));
    }

    #[test]
    #[should_panic(expected = "an exponent of -1")]
    fn negative_exponents_are_refused() {
        Power::<f64>::new(-1.0, Underflow::Zero);
    }
}
