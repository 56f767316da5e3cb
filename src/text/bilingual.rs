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
/// let half = Text::each(|language| language.number(0.5));
/// assert_eq!(half.get(Language::Portuguese), "0,5");
/// ```
#[derive(Clone, Debug, PartialEq, Eq, Serialize)]
pub struct Text {
    en: Cow<'static, str>,
    pt: Cow<'static, str>,
}

impl Text {
    /// A name or symbol that both languages write alike.
    pub const fn same(text: &'static str) -> Self {
        Self { en: Cow::Borrowed(text), pt: Cow::Borrowed(text) }
    }

    /// A text made by a function of the language.
    pub fn each(text: impl Fn(Language) -> String) -> Self {
        let [en, pt] = Language::ALL.map(|language| Cow::Owned(text(language)));
        Self { en, pt }
    }

    /// A number that is written with a decimal point, which becomes that of each language.
    pub fn number(digits: &str) -> Self {
        Self::each(|language| language.localised(digits))
    }

    /// The English text.
    pub fn english(&self) -> &str {
        &self.en
    }

    /// The text in a language.
    pub fn get(&self, language: Language) -> &str {
        match language {
            Language::English => &self.en,
            Language::Portuguese => &self.pt,
        }
    }
}
