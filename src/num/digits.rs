//! Numbers as text for people.

use std::fmt;

/// A number with three significant digits, with an exponent where it would otherwise be long.
///
/// ```
/// use crease::num::three_digits;
///
/// assert_eq!([0.49837, 46.686, 4321.4, 7.4e-7].map(three_digits), ["0.498", "46.7", "4321", "7.40e-7"]);
/// ```
pub fn three_digits(x: f64) -> String {
    significant_digits(x, 3)
}

/// A number with so many significant digits, from 1 to 7, with an exponent where it would otherwise be long.
///
/// ```
/// assert_eq!([1.64449, 46.686, 4321.4, 7.4e-7].map(|x| crease::num::significant_digits(x, 4)), ["1.644", "46.69", "4321", "7.400e-7"]);
/// ```
pub fn significant_digits(x: f64, digits: usize) -> String {
    if x == 0.0 || !x.is_finite() {
        return format!("{x}");
    }
    let after = digits.max(1) as i32 - 1;
    match libm::floor(libm::log10(x.abs())) as i32 {
        place @ -3..=6 => format!("{x:.*}", (after - place).max(0) as usize),
        _ => format!("{x:.*e}", after as usize),
    }
}

/// A number rounded to six significant digits, without the zeros that follow them: a coordinate to be typed again.
///
/// ```
/// use crease::num::six_digits;
///
/// assert_eq!([0.6139867940184421, -4.0, 1234567.0].map(six_digits), ["0.613987", "-4", "1234570"]);
/// ```
pub fn six_digits(x: f64) -> String {
    format!("{x:.5e}").parse::<f64>().unwrap_or(x).to_string()
}

/// A number as [`three_digits`] writes it, for pages: with a power of ten in place of an exponent, and a true minus sign.
///
/// ```
/// assert_eq!(crease::num::powers_of_ten("-2.38e-5"), "−2.38 × 10⁻⁵");
/// ```
pub fn powers_of_ten(number: &str) -> String {
    let signed = |digits: &str| digits.replace('-', "−");
    match number.split_once('e') {
        Some(("1", power)) => format!("10{}", superscript(power)),
        Some(("-1", power)) => format!("−10{}", superscript(power)),
        Some((digits, power)) => format!("{} × 10{}", signed(digits), superscript(power)),
        None => signed(number),
    }
}

/// A whole number as an exponent, above the line.
pub(crate) fn superscript(number: &str) -> String {
    const DIGITS: [char; 10] = ['⁰', '¹', '²', '³', '⁴', '⁵', '⁶', '⁷', '⁸', '⁹'];
    number.chars().map(|c| c.to_digit(10).map_or('⁻', |digit| DIGITS[digit as usize])).collect()
}

/// A number with nine decimals, which distinguish every printed figure of the lectures; without the sign that a zero may have, or
/// that rounding leaves in front of one.
pub(crate) struct Nine(pub(crate) f64);

impl fmt::Display for Nine {
    fn fmt(&self, f: &mut fmt::Formatter) -> fmt::Result {
        // What is nearer to zero than half of the last place is printed as zero.
        let shown = if self.0.abs() < 0.5e-9 { 0.0 } else { self.0 };
        write!(f, "{shown:.9}")
    }
}

/// A vector or a colour, with nine decimals each.
pub(crate) struct NineEach(pub(crate) [f64; 3]);

impl fmt::Display for NineEach {
    fn fmt(&self, f: &mut fmt::Formatter) -> fmt::Result {
        let [x, y, z] = self.0.map(Nine);
        write!(f, "({x}, {y}, {z})")
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn exponents_become_powers() {
        let texts = ["2.38e-5", "-1.5e12", "1e7", "-1e-5", "-0.25", "12"].map(powers_of_ten);
        assert_eq!(texts, ["2.38 × 10⁻⁵", "−1.5 × 10¹²", "10⁷", "−10⁻⁵", "−0.25", "12"]);
    }

    #[test]
    fn three_digits_are_kept() {
        let texts = [0.0, 0.0, -0.001_234, 1.0, 1.644, 312.4, 1e7, f64::INFINITY].map(three_digits);
        assert_eq!(texts, ["0", "0", "-0.00123", "1.00", "1.64", "312", "1.00e7", "inf"]);
    }

    #[test]
    fn no_zero_has_a_sign() {
        let texts = [-0.0, -4e-10, -6e-10, -1.0 / 3.0, f64::NAN].map(|x| Nine(x).to_string());
        assert_eq!(texts, ["0.000000000", "0.000000000", "-0.000000001", "-0.333333333", "NaN"]);
        assert_eq!(NineEach([-0.0, 1.0, -2.0]).to_string(), "(0.000000000, 1.000000000, -2.000000000)");
    }
}
