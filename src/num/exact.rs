//! Sums without any rounding error.

/// Bits of one limb.
const LIMB_BITS: u32 = 32;
/// Limbs from 2^-1074 to beyond 2^1024, with room for the carries of 2^64 numbers.
const LIMBS: usize = 68;
/// Each addition raises a limb by less than 2^32, so that this many leave an `i64` in range.
const ADDITIONS_BETWEEN_CARRIES: u32 = 1 << 30;

/// A fixed-point number wide enough for every `f64` (Kulisch's accumulator): any number of finite values are
/// added without error, in constant time each, however far apart their exponents are. It is what expansion
/// arithmetic grows to on hostile input, where an expansion would grow with the input.
pub(crate) struct ExactSum {
    limbs: [i64; LIMBS],
    additions: u32,
}

impl ExactSum {
    /// Zero.
    pub(crate) fn new() -> Self {
        Self { limbs: [0; LIMBS], additions: 0 }
    }

    /// Adds a finite number.
    pub(crate) fn add(&mut self, x: f64) {
        debug_assert!(x.is_finite());
        let bits = x.to_bits();
        let (exponent, fraction) = ((bits >> 52) as u32 & 0x7ff, bits & ((1 << 52) - 1));
        // x = significand · 2^(shift − 1074)
        let (significand, shift) =
            if exponent == 0 { (fraction, 0) } else { (fraction | 1 << 52, exponent - 1) };
        let (limb, offset) = ((shift / LIMB_BITS) as usize, shift % LIMB_BITS);
        let wide = u128::from(significand) << offset;
        let sign = if x < 0.0 { -1 } else { 1 };
        for part in 0..3 {
            self.limbs[limb + part] += sign * i64::from((wide >> (LIMB_BITS as usize * part)) as u32);
        }
        self.additions += 1;
        if self.additions == ADDITIONS_BETWEEN_CARRIES {
            self.carry();
        }
    }

    /// The sum, rounded to nearest.
    pub(crate) fn value(mut self) -> f64 {
        self.carry();
        let negative = self.limbs[LIMBS - 1] < 0;
        if negative {
            self.limbs.iter_mut().for_each(|limb| *limb = -*limb);
            self.carry();
        }
        let Some(top) = self.limbs.iter().rposition(|&limb| limb != 0) else { return 0.0 };
        // The highest three limbs hold at least 65 bits; what lies below only breaks ties.
        let low = top.saturating_sub(2);
        let head = (low..=top).rev().fold(0_u128, |head, i| head << LIMB_BITS | self.limbs[i] as u128);
        let sticky = self.limbs[..low].iter().any(|&limb| limb != 0);
        let magnitude = (head << 1 | u128::from(sticky)) as f64;
        let value = libm::ldexp(magnitude, LIMB_BITS as i32 * low as i32 - 1075);
        if negative { -value } else { value }
    }

    /// Brings every limb but the highest into 0..2^32; the highest keeps the sign.
    fn carry(&mut self) {
        let mut carry = 0;
        for limb in &mut self.limbs[..LIMBS - 1] {
            let sum = *limb + carry;
            carry = sum >> LIMB_BITS;
            *limb = sum & ((1 << LIMB_BITS) - 1);
        }
        self.limbs[LIMBS - 1] += carry;
        self.additions = 0;
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::num::test_numbers::Numbers;
    use dashu_ratio::RBig;

    fn sum(numbers: &[f64]) -> f64 {
        let mut sum = ExactSum::new();
        numbers.iter().for_each(|&x| sum.add(x));
        sum.value()
    }

    #[test]
    fn extremes_cancel_without_trace() {
        assert_eq!(sum(&[]), 0.0);
        assert_eq!(sum(&[f64::MAX, f64::MAX, 5e-324, -f64::MAX, -f64::MAX]), 5e-324);
        assert_eq!(sum(&[1.0, -1.0]), 0.0);
        assert_eq!(sum(&[-f64::MAX]), -f64::MAX);
        assert_eq!(sum(&[1e300, 1.0, -1e300, -3.0]), -2.0);
        assert_eq!(sum(&[f64::MIN_POSITIVE, -5e-324]), f64::MIN_POSITIVE - 5e-324);
    }

    #[test]
    fn a_tie_is_broken_by_what_lies_far_below() {
        let half_ulp = f64::EPSILON / 2.0;
        assert_eq!(sum(&[1.0, half_ulp]), 1.0);
        assert_eq!(sum(&[1.0, half_ulp, 1e-300]), 1.0 + f64::EPSILON);
        assert_eq!(sum(&[1.0, half_ulp, -1e-300]), 1.0);
    }

    #[test]
    fn agrees_with_rational_arithmetic() {
        let mut numbers = Numbers::new(4);
        for round in 0..2000 {
            let spread = [3, 60, 400, 1000][round % 4];
            let values: Vec<f64> = (0..20).map(|_| numbers.spread(spread)).collect();
            let truth = values.iter().fold(RBig::ZERO, |sum, &x| sum + RBig::try_from(x).unwrap());
            assert_eq!(sum(&values), truth.to_f64().value(), "{values:?}");
        }
    }
}
