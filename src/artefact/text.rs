//! What is said, in both languages at once.

use serde::{Serialize, Serializer};
use std::borrow::Cow;

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
}

impl Serialize for Language {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        serializer.serialize_str(self.tag())
    }
}

/// A text in English and Portuguese. There is no way to make one of a single language, so no caption can lack its
/// translation; what is the same in both is said to be.
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
    /// Both languages as they are.
    pub const fn new(en: &'static str, pt: &'static str) -> Self {
        Self { en: Cow::Borrowed(en), pt: Cow::Borrowed(pt) }
    }

    /// What both languages write alike: names, symbols.
    pub const fn same(text: &'static str) -> Self {
        Self::new(text, text)
    }

    /// Both languages with numbers in them.
    pub fn made(en: String, pt: String) -> Self {
        Self { en: en.into(), pt: pt.into() }
    }

    /// Both languages, each by itself.
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
