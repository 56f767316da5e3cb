//! Numbers, vectors and colours of options.

use crease::num::{LinearRgb, Srgb8};
use glam::DVec3;

pub fn number(text: &str) -> Result<f64, String> {
    let number = text.trim().parse().ok().filter(|number: &f64| number.is_finite());
    number.ok_or_else(|| format!("{text:?} is not a finite number"))
}

pub fn not_negative(text: &str) -> Result<f64, String> {
    let number = number(text).ok().filter(|&number| number >= 0.0);
    number.ok_or_else(|| format!("{text:?} is not a finite number, 0 or more"))
}

pub fn finite_numbers(text: &str) -> Result<Vec<f64>, String> {
    text.split(',').map(number).collect()
}

/// `1,2,3`.
pub fn vector(text: &str) -> Result<DVec3, String> {
    match finite_numbers(text)?[..] {
        [x, y, z] => Ok(DVec3::new(x, y, z)),
        _ => Err(format!("{text:?} is not three numbers such as 1,0,2.5")),
    }
}

/// `#rrggbb` in sRGB, three linear components, or one for a grey.
pub fn colour(text: &str) -> Result<LinearRgb, String> {
    let wrong = || {
        format!("{text:?} is not a colour: expected #rrggbb (sRGB), R,G,B or one number (linear, 0 or more)")
    };
    if let Some(digits) = text.strip_prefix('#') {
        let is_hexadecimal = digits.len() == 6 && digits.bytes().all(|digit| digit.is_ascii_hexdigit());
        let code = u32::from_str_radix(digits, 16).ok().filter(|_| is_hexadecimal).ok_or_else(wrong)?;
        let [_, r, g, b] = code.to_be_bytes();
        return Ok(Srgb8([r, g, b]).into());
    }
    let numbers: Result<Vec<f64>, _> = text.split(',').map(not_negative).collect();
    match numbers.map_err(|_| wrong())?[..] {
        [grey] => Ok(LinearRgb::grey(grey)),
        [r, g, b] => Ok(LinearRgb::new(r, g, b)),
        _ => Err(wrong()),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn colours_are_codes_or_light() {
        assert_eq!(colour("#ff0000"), Ok(LinearRgb::new(1.0, 0.0, 0.0)));
        assert!((colour("#bcbcbc").unwrap().g - 0.502_886_5).abs() < 1e-6, "188 is about half the light");
        assert_eq!(colour("0.5"), Ok(LinearRgb::grey(0.5)));
        assert_eq!(colour("2, 0,1e-3"), Ok(LinearRgb::new(2.0, 0.0, 1e-3)));
        for wrong in ["", "#12", "#+12345", "#12345g", "1,2", "1,2,3,4", "-1", "nan", "1,inf,1", "red"] {
            assert!(colour(wrong).unwrap_err().contains("#rrggbb"), "{wrong}");
        }
    }
}
