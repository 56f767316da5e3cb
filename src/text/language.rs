//! The two languages of captions and pages, and how each writes numbers.

use crate::num::superscript;
use serde::{Serialize, Serializer};

/// A language of captions and pages.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub enum Language {
    /// English.
    #[default]
    English,
    /// Portuguese, the lectures' language.
    Portuguese,
}

impl Language {
    /// Both.
    pub const ALL: [Language; 2] = [Language::English, Language::Portuguese];

    /// Its tag (BCP 47).
    pub fn tag(self) -> &'static str {
        match self {
            Language::English => "en",
            Language::Portuguese => "pt",
        }
    }

    /// The sign between the whole part and the decimals of a number.
    pub fn decimal_mark(self) -> char {
        match self {
            Language::English => '.',
            Language::Portuguese => ',',
        }
    }

    /// A number that is written with a decimal point.
    ///
    /// ```
    /// use crease::artefact::Language;
    ///
    /// assert_eq!(Language::Portuguese.localised("0.25"), "0,25");
    /// ```
    pub fn localised(self, number: &str) -> String {
        number.replace('.', self.decimal_mark().encode_utf8(&mut [0; 4]))
    }

    /// A number to six significant digits, with a power of ten where it would be long.
    ///
    /// ```
    /// use crease::artefact::Language;
    ///
    /// assert_eq!(Language::ALL.map(|language| language.number(70.528_779)), ["70.5288", "70,5288"]);
    /// assert_eq!(Language::ALL.map(|language| language.number(-1e-5)), ["−1 × 10⁻⁵", "−1 × 10⁻⁵"]);
    /// ```
    pub fn number(self, x: f64) -> String {
        self.rounded(x, 6)
    }

    /// A number to three significant digits with its unit, for captions.
    pub fn short(self, x: f64, unit: &str) -> String {
        with_unit(&self.rounded(x, 3), unit)
    }

    /// A number to six significant digits with its unit.
    pub fn quantity(self, x: f64, unit: &str) -> String {
        with_unit(&self.number(x), unit)
    }

    /// A number to this many significant digits; digits before the decimal mark are never dropped.
    fn rounded(self, x: f64, digits: i32) -> String {
        let trimmed = |text: String| match text.contains('.') {
            true => text.trim_end_matches('0').trim_end_matches('.').to_owned(),
            false => text,
        };
        let text = match x.abs() {
            0.0 => "0".to_owned(),
            magnitude if magnitude.is_infinite() => "∞".to_owned(),
            magnitude @ 1e-4..1e7 => {
                let decimals = (digits - 1 - libm::floor(libm::log10(magnitude)) as i32).max(0) as usize;
                trimmed(format!("{magnitude:.decimals$}"))
            }
            magnitude => match format!("{magnitude:.2e}").split_once('e') {
                Some((mantissa, power)) => {
                    format!("{} × 10{}", trimmed(mantissa.to_owned()), superscript(power))
                }
                None => "NaN".to_owned(),
            },
        };
        let sign = if x < 0.0 { "−" } else { "" };
        format!("{sign}{}", self.localised(&text))
    }
}

/// A number and its unit: no space before a degree sign or a division, one before other units.
fn with_unit(number: &str, unit: &str) -> String {
    if let Some(divisor) = unit.strip_prefix("1/") {
        return format!("{number}/{divisor}");
    }
    let space = if unit.is_empty() || unit == "°" { "" } else { " " };
    format!("{number}{space}{unit}")
}

/// A number with all its digits, as a user would type it, with an exponent where it would be long.
pub fn given(x: f64) -> String {
    match x.abs() {
        0.0 => "0".into(),
        1e-4..1e7 => x.to_string(),
        _ => format!("{x:e}"),
    }
}

impl Serialize for Language {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        serializer.serialize_str(self.tag())
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_are_short() {
        let numbers = [0.0, 70.528_779, -0.134_38, 1e-7, 0.1, 1_234_567.0, f64::INFINITY];
        let shown = numbers.map(|x| Language::English.number(x));
        assert_eq!(shown, ["0", "70.5288", "−0.13438", "1 × 10⁻⁷", "0.1", "1234567", "∞"]);
        assert_eq!(Language::Portuguese.number(-1.25e-17), "−1,25 × 10⁻¹⁷");
        assert_eq!([f64::NAN, f64::NEG_INFINITY].map(|x| Language::English.number(x)), ["NaN", "−∞"]);
        assert_eq!(
            ["", "°", "px", "1/R"].map(|unit| Language::English.short(2.5, unit)),
            ["2.5", "2.5°", "2.5 px", "2.5/R"]
        );
        assert_eq!(
            [1e308, -0.0, 1e-300, 1e6, 1.0 / 3.0].map(given),
            ["1e308", "0", "1e-300", "1000000", "0.3333333333333333"]
        );
    }
}
