//! Half precision.

/// Digits of binary16 behind the leading one.
const DIGITS: i32 = 10;
/// The exponent of its smallest normal number.
const SMALLEST: i32 = -14;

/// The nearest IEEE 754 binary16, ties to even. Beyond its range ∞, NaN stays NaN.
pub fn to_half(x: f64) -> u16 {
    let sign = if x.is_sign_negative() { 1 << 15 } else { 0 };
    let magnitude = x.abs();
    if magnitude.is_nan() {
        return sign | 0x7e00;
    }
    // 65520 is halfway from the largest number to the one that there would be next.
    if magnitude >= 65_520.0 {
        return sign | 0x7c00;
    }
    let exponent = if magnitude == 0.0 { SMALLEST } else { libm::ilogb(magnitude).max(SMALLEST) };
    let steps = libm::rint(libm::scalbn(magnitude, DIGITS - exponent)) as u16;
    // The leading one adds to the exponent's field; so does a step that carries over.
    let field = ((exponent - SMALLEST) as u16) << DIGITS;
    sign | (field + steps)
}

/// The value of an IEEE 754 binary16.
pub fn from_half(bits: u16) -> f64 {
    let (exponent, digits) = (i32::from(bits >> DIGITS & 0x1f), f64::from(bits & 0x3ff));
    let magnitude = match exponent {
        0 => libm::scalbn(digits, SMALLEST - DIGITS),
        0x1f if digits > 0.0 => f64::NAN,
        0x1f => f64::INFINITY,
        _ => libm::scalbn(digits + 1024.0, exponent - 1 + SMALLEST - DIGITS),
    };
    if bits >> 15 == 1 { -magnitude } else { magnitude }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_half_comes_back() {
        for bits in 0..=u16::MAX {
            let value = from_half(bits);
            if value.is_nan() {
                assert!(from_half(to_half(value)).is_nan());
            } else {
                assert_eq!(to_half(value), bits, "{value}");
            }
        }
    }

    /// Between neighbours: the nearer one, the even one in the middle.
    #[test]
    fn rounding_is_to_the_nearest() {
        for bits in 0..0x7bff_u16 {
            let (low, high) = (from_half(bits), from_half(bits + 1));
            let middle = f64::midpoint(low, high);
            let even = bits + bits % 2;
            assert_eq!(to_half(middle), even, "{middle}");
            assert_eq!(to_half(middle.next_down()), bits);
            assert_eq!(to_half(-middle.next_up()), (bits + 1) | 0x8000);
        }
        assert_eq!((to_half(65_519.9), to_half(65_520.0)), (0x7bff, 0x7c00));
    }

    #[test]
    fn known_numbers() {
        let known = [(1.0, 0x3c00), (-2.0, 0xc000), (65_504.0, 0x7bff), (0.0, 0), (-0.0, 0x8000)];
        for (value, bits) in known {
            assert_eq!((to_half(value), from_half(bits)), (bits, value));
        }
        // A third, the smallest normal and the smallest subnormal number.
        assert_eq!([1.0 / 3.0, 6.103_515_625e-5, 5.960_464_477_539_063e-8].map(to_half), [0x3555, 0x0400, 1]);
    }
}
