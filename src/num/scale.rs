//! Powers of two that bring numbers to a size at which products neither overflow nor vanish.

use super::unit::exponent;

/// The power of two that brings a magnitude into [½, 1). Multiplying by it changes no digit, so what is computed
/// from the products does not depend on the unit that they came in.
///
/// 1 for zero. Numbers below the normal range come as close to ½ as the largest power of two, 2¹⁰²³, brings them.
///
/// ```
/// assert_eq!(crease::num::unit_scale(6.0), 0.125);
/// assert_eq!(crease::num::unit_scale(0.5), 1.0);
/// ```
#[inline]
pub fn unit_scale(magnitude: f64) -> f64 {
    if magnitude == 0.0 { 1.0 } else { libm::ldexp(1.0, (-1 - exponent(magnitude)).min(1023)) }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_normal_number_lands_between_a_half_and_one() {
        for exponent in 1..2047_u64 {
            for mantissa in [0, 1, (1 << 52) - 1] {
                let magnitude = f64::from_bits(exponent << 52 | mantissa);
                let scaled = magnitude * unit_scale(magnitude);
                assert!((0.5..1.0).contains(&scaled), "{magnitude:e} became {scaled}");
                assert_eq!(scaled.to_bits() & ((1 << 52) - 1), mantissa);
            }
        }
        assert!(f64::from_bits(1) * unit_scale(f64::from_bits(1)) > 0.0);
    }
}
