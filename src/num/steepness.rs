//! How much a highlight amplifies a small error of an angle.

use super::Radians;

/// The largest slope of cosⁿ α over α, for n ≥ 1: M(n) = √n ((n−1)/n)^((n−1)/2), at tan α = 1/√(n−1). It nears √(n/e).
///
/// A normal that is off by δ changes a diffuse term by at most δ, Blinn's highlight by at most M(n) δ and Phong's, whose
/// mirrored ray turns twice as far, by at most 2 M(n) δ.
///
/// ```
/// use crease::num::steepest_slope;
///
/// assert_eq!(steepest_slope(1.0), 1.0);
/// assert!((steepest_slope(100.0) - 6.0805).abs() < 5e-5);
/// ```
pub fn steepest_slope(exponent: f64) -> f64 {
    // ((n−1)/n)^((n−1)/2) by the logarithm of 1 − 1/n, which is as exact for large n as for small ones.
    let fewer = exponent - 1.0;
    let power = if fewer > 0.0 { libm::exp(0.5 * fewer * libm::log1p(-1.0 / exponent)) } else { 1.0 };
    exponent.sqrt() * power
}

/// The largest whole n, up to 10⁹, for which cosⁿ changes by no more than `change` where its angle is off by `error`:
/// M(n)·error ≤ change. `None` if even n = 1, a diffuse term, changes by more.
///
/// ```
/// use crease::num::{Degrees, largest_exponent};
///
/// // Half a step of 8 bits. 0.0588° is the worst of octahedral codes of 12 + 12 bits, 0.64° that of 8 + 8.
/// assert_eq!(largest_exponent(Degrees(0.0588).into(), 1.0 / 510.0), Some(9));
/// assert_eq!(largest_exponent(Degrees(0.64).into(), 1.0 / 510.0), None);
/// ```
pub fn largest_exponent(error: Radians, change: f64) -> Option<u64> {
    const LARGEST: u64 = 1_000_000_000;
    let serves = |exponent: u64| steepest_slope(exponent as f64) * error.0 <= change;
    if !serves(1) {
        return None;
    }
    // M grows with n: bisect between one that serves and one that does not.
    let (mut low, mut high) = (1, LARGEST + 1);
    while high - low > 1 {
        let middle = low.midpoint(high);
        if serves(middle) { low = middle } else { high = middle }
    }
    Some(low)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The published digits, and the slope found by looking at all angles.
    #[test]
    fn slopes_are_the_largest_there_are() {
        let printed =
            [(2, 1.0), (5, 1.4311), (10, 1.9683), (50, 4.3105), (100, 6.0805), (200, 8.5884), (1000, 19.185)];
        for (exponent, slope) in printed {
            let n = f64::from(exponent);
            // Rounded to the digits printed: five significant ones.
            assert!((steepest_slope(n) / slope - 1.0).abs() < 5e-5, "{exponent}: {}", steepest_slope(n));
            let steepness = |alpha: f64| n * libm::sin(alpha) * libm::pow(libm::cos(alpha), n - 1.0);
            let steepest = (0..100_000).map(|i| steepness(f64::from(i) * 1.5e-5)).fold(0.0, f64::max);
            // A maximum is flat: steps of 1.5e-5 rad miss it by less than n·1e-10 of its height.
            assert!((steepest / steepest_slope(n) - 1.0).abs() < n * 1e-10, "{exponent}: {steepest}");
        }
        assert!((steepest_slope(1e9) / (1e9 / std::f64::consts::E).sqrt() - 1.0).abs() < 1e-9);
    }

    #[test]
    fn the_next_exponent_would_be_too_much() {
        for error in [1e-3, 6.4e-5, 1e-6] {
            let largest = largest_exponent(Radians(error), 1.0 / 510.0).unwrap();
            assert!(steepest_slope(largest as f64) * error <= 1.0 / 510.0);
            assert!(steepest_slope(largest as f64 + 1.0) * error > 1.0 / 510.0);
        }
        assert_eq!(largest_exponent(Radians(0.0), 1.0 / 510.0), Some(1_000_000_000));
        assert_eq!(largest_exponent(Radians(f64::NAN), 1.0 / 510.0), None);
    }
}
