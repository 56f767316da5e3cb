//! Numbers for people.

/// A number with three significant digits, with an exponent where it would otherwise be long.
///
/// ```
/// use crease::num::three_digits;
///
/// assert_eq!([0.49837, 46.686, 4321.4, 7.4e-7].map(three_digits), ["0.498", "46.7", "4321", "7.40e-7"]);
/// ```
pub fn three_digits(x: f64) -> String {
    if x == 0.0 || !x.is_finite() {
        return format!("{x}");
    }
    match libm::floor(libm::log10(x.abs())) as i32 {
        place @ -3..=2 => format!("{x:.*}", (2 - place) as usize),
        3..=6 => format!("{x:.0}"),
        _ => format!("{x:.2e}"),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn three_digits_are_kept() {
        let texts = [0.0, 0.0, -0.001_234, 1.0, 1.644, 312.4, 1e7, f64::INFINITY].map(three_digits);
        assert_eq!(texts, ["0", "0", "-0.00123", "1.00", "1.64", "312", "1.00e7", "inf"]);
    }
}
