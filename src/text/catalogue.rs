//! The texts of one Fluent file, or of one file for each language.

use super::bilingual::Text;
use super::language::Language;
use super::value::Value;
use fluent_bundle::concurrent::FluentBundle;
use fluent_bundle::{FluentArgs, FluentResource};
use std::sync::OnceLock;

/// Texts by key. Made by `catalogue!` as a `static`; the files are parsed at the first use.
pub struct Catalogue {
    sources: [&'static str; 2],
    bundles: OnceLock<[FluentBundle<FluentResource>; 2]>,
}

/// A [`Catalogue`] of the files `NAME.en.ftl` and `NAME.pt.ftl` in the folder of the source file; with `, en`, of English
/// alone, for texts that no page shows in Portuguese.
macro_rules! catalogue {
    ($name:literal) => {
        $crate::text::Catalogue::new(
            include_str!(concat!($name, ".en.ftl")),
            include_str!(concat!($name, ".pt.ftl")),
        )
    };
    ($name:literal, en) => {
        $crate::text::Catalogue::new(
            include_str!(concat!($name, ".en.ftl")),
            include_str!(concat!($name, ".en.ftl")),
        )
    };
}
pub(crate) use catalogue;

impl Catalogue {
    /// Of the contents of an English and a Portuguese file.
    pub const fn new(english: &'static str, portuguese: &'static str) -> Self {
        Self { sources: [english, portuguese], bundles: OnceLock::new() }
    }

    /// The text of a key without placeholders.
    pub fn get(&self, key: &str) -> Text {
        self.with(key, &[])
    }

    /// The text of a key, its placeholders filled by name.
    ///
    /// A line break in the file is a space in the text; an empty line stays. A key or placeholder that is missing shows as
    /// its name in braces; tests of this module find both before a user does.
    pub fn with(&self, key: &str, values: &[(&'static str, Value)]) -> Text {
        Text::each(|language| self.format(key, values, language))
    }

    /// Whether there is a text of this key.
    pub fn has(&self, key: &str) -> bool {
        self.bundles()[0].has_message(key)
    }

    /// The texts of `STEM-1`, `STEM-2`, … up to the last number in the file.
    pub fn list(&self, stem: &str) -> Vec<Text> {
        let keys = (1..).map(|number| format!("{stem}-{number}"));
        keys.take_while(|key| self.has(key)).map(|key| self.get(&key)).collect()
    }

    fn format(&self, key: &str, values: &[(&'static str, Value)], language: Language) -> String {
        let bundle = &self.bundles()[language as usize];
        let Some(pattern) = bundle.get_message(key).and_then(|message| message.value()) else {
            return format!("{{{key}}}");
        };
        let arguments: FluentArgs =
            values.iter().map(|(name, value)| (*name, value.in_language(language))).collect();
        let text = bundle.format_pattern(pattern, Some(&arguments), &mut Vec::new());
        let paragraphs: Vec<String> = text.split("\n\n").map(|lines| lines.replace('\n', " ")).collect();
        paragraphs.join("\n\n")
    }

    fn bundles(&self) -> &[FluentBundle<FluentResource>; 2] {
        self.bundles.get_or_init(|| {
            Language::ALL.map(|language| {
                // The tags are constants, and a file that does not parse fails the tests of this module: what parsed is used.
                let locale = language.tag().parse().unwrap_or_default();
                let mut bundle = FluentBundle::new_concurrent(vec![locale]);
                bundle.set_use_isolating(false);
                let source = self.sources[language as usize].to_owned();
                let resource = FluentResource::try_new(source).unwrap_or_else(|(parsed, _)| parsed);
                bundle.add_resource_overriding(resource);
                bundle
            })
        })
    }
}

impl std::fmt::Debug for Catalogue {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.debug_struct("Catalogue").finish_non_exhaustive()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    static TEXTS: Catalogue = Catalogue::new(
        "plain = A sphere\nfaces = { $count ->\n    [one] one face of { $size }\n   *[other] { $count } faces of { $size }\n }\nlong = first line\n    second line\n\n    new paragraph\nitem-1 = a\nitem-2 = b\nlatex = {\"\\\\frac{a}{b}\"}\n",
        "plain = Uma esfera\nfaces = { $count } faces de { $size }\nlong = x\nitem-1 = a\nitem-2 = b\nlatex = y\n",
    );

    #[test]
    fn texts_follow_language_number_and_plural() {
        let faces = |count: u32| {
            TEXTS.with("faces", &[("count", count.into()), ("size", Value::quantity(0.25, "px"))])
        };
        assert_eq!(faces(1).get(Language::English), "one face of 0.25 px");
        assert_eq!(faces(1260).get(Language::English), "1260 faces of 0.25 px");
        assert_eq!(faces(1).get(Language::Portuguese), "1 faces de 0,25 px");
        assert_eq!(TEXTS.get("plain").get(Language::Portuguese), "Uma esfera");
        assert_eq!(TEXTS.get("long").get(Language::English), "first line second line\n\nnew paragraph");
        assert_eq!(TEXTS.get("latex").get(Language::English), "\\frac{a}{b}");
        assert_eq!(TEXTS.list("item").len(), 2);
    }

    #[test]
    fn missing_texts_show_their_key() {
        assert_eq!(TEXTS.get("absent").get(Language::English), "{absent}");
        assert_eq!(TEXTS.get("faces").get(Language::English), "{$count} faces of {$size}");
    }
}
