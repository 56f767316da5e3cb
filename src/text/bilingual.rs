//! A text in both languages.

use super::language::Language;
use serde::Serialize;
use std::borrow::Cow;

/// A text in English and Portuguese, usually from a [`Catalogue`](super::Catalogue). There is no way to make one of a single
/// language, so no caption can lack its translation.
///
/// ```
/// use crease::artefact::{Language, Text};
///
/// const LIGHT: Text = Text::new("light", "luz");
/// assert_eq!(LIGHT.get(Language::Portuguese), "luz");
/// ```
#[derive(Clone, Debug, PartialEq, Eq, Serialize)]
pub struct Text {
    en: Cow<'static, str>,
    pt: Cow<'static, str>,
}

impl Text {
    /// The text in English and in Portuguese.
    pub const fn new(en: &'static str, pt: &'static str) -> Self {
        Self { en: Cow::Borrowed(en), pt: Cow::Borrowed(pt) }
    }

    /// A name or symbol that both languages write alike.
    pub const fn same(text: &'static str) -> Self {
        Self::new(text, text)
    }

    /// Both languages with numbers in them.
    pub fn made(en: String, pt: String) -> Self {
        Self { en: en.into(), pt: pt.into() }
    }

    /// Both languages with numbers, to three digits, for each `{}` in them.
    pub fn with(en: &str, pt: &str, numbers: &[f64]) -> Self {
        let filled = |text: &str, language: Language| {
            let fill = |text: String, &x: &f64| text.replacen("{}", &language.short(x, ""), 1);
            numbers.iter().fold(text.to_owned(), fill)
        };
        Self::made(filled(en, Language::English), filled(pt, Language::Portuguese))
    }

    /// A text made by a function of the language.
    pub fn each(text: impl Fn(Language) -> String) -> Self {
        Self::made(text(Language::English), text(Language::Portuguese))
    }

    /// The text in a language.
    pub fn get(&self, language: Language) -> &str {
        match language {
            Language::English => &self.en,
            Language::Portuguese => &self.pt,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_follow_the_language() {
        let filled = Text::with("{} of {}", "{} de {}", &[-0.123_456, 1234.6]);
        assert_eq!(
            Language::ALL.map(|language| filled.get(language).to_owned()),
            ["−0.123 of 1235", "−0,123 de 1235"]
        );
    }
}
