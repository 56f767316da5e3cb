//! Values for the placeholders of a text.

use super::bilingual::Text;
use super::language::Language;
use fluent_bundle::FluentValue;

/// What fills a placeholder: a number that each language writes in its own way, or a text.
///
/// Whole numbers select plural forms; decimal ones are written with three significant digits, as captions need them.
#[derive(Clone, Debug)]
pub enum Value {
    /// A whole number, for plurals.
    Count(u64),
    /// A decimal number to three significant digits, with a unit that may be empty.
    Short(f64, &'static str),
    /// A decimal number to six significant digits, with a unit that may be empty.
    Number(f64, &'static str),
    /// A text of its own, the same or not in both languages.
    Text(Text),
}

impl Value {
    /// A number to six significant digits.
    pub fn number(x: f64) -> Self {
        Value::Number(x, "")
    }

    /// A number to three significant digits with its unit: `0.5 px`, `35°`.
    pub fn quantity(x: f64, unit: &'static str) -> Self {
        Value::Short(x, unit)
    }

    /// A number that is written with a decimal point.
    pub fn digits(number: &str) -> Self {
        Value::Text(Text::number(number))
    }

    /// The value as Fluent takes it.
    pub(super) fn in_language(&self, language: Language) -> FluentValue<'_> {
        match self {
            // Exact up to 2⁵³; plural forms need no more.
            Value::Count(count) => FluentValue::from(*count as f64),
            Value::Short(x, unit) => language.short(*x, unit).into(),
            Value::Number(x, unit) => language.quantity(*x, unit).into(),
            Value::Text(text) => text.get(language).into(),
        }
    }
}

impl From<f64> for Value {
    fn from(x: f64) -> Self {
        Value::Short(x, "")
    }
}

impl From<u32> for Value {
    fn from(count: u32) -> Self {
        Value::Count(count.into())
    }
}

impl From<u64> for Value {
    fn from(count: u64) -> Self {
        Value::Count(count)
    }
}

impl From<usize> for Value {
    fn from(count: usize) -> Self {
        Value::Count(count as u64)
    }
}

impl From<&str> for Value {
    fn from(text: &str) -> Self {
        Value::Text(Text::each(|_| text.to_owned()))
    }
}

impl From<String> for Value {
    fn from(text: String) -> Self {
        Value::Text(Text::each(|_| text.clone()))
    }
}

impl From<Text> for Value {
    fn from(text: Text) -> Self {
        Value::Text(text)
    }
}

impl From<&Text> for Value {
    fn from(text: &Text) -> Self {
        Value::Text(text.clone())
    }
}
