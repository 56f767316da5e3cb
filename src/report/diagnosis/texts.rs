//! The texts of the page and of the pictures of a diagnosis.

use crate::text::{Catalogue, Language, Value, catalogue};

static TEXTS: Catalogue = catalogue!("texts");

/// The texts in one language.
#[derive(Clone, Copy)]
pub(super) struct Texts(pub(super) Language);

impl Texts {
    pub(super) fn get(self, key: &str) -> String {
        self.with(key, &[])
    }

    pub(super) fn with(self, key: &str, values: &[(&'static str, Value)]) -> String {
        TEXTS.with(key, values).get(self.0).to_owned()
    }

    /// The part of a text in several parts: `of("valence", "caption")` is `valence-caption`.
    pub(super) fn of(self, name: &str, part: &str) -> String {
        self.get(&format!("{name}-{part}"))
    }

    /// Several texts, as the names of columns.
    pub(super) fn each<const N: usize>(self, keys: [&str; N]) -> [String; N] {
        keys.map(|key| self.get(key))
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::report::panel::has_letters;

    /// Legends are lettered with a small font.
    #[test]
    fn legends_have_only_letters_of_the_font() {
        let values: &[(&'static str, Value)] = &[];
        let keys =
            include_str!("texts.pt.ftl").lines().filter_map(|line| line.split_once(" = ")).map(|it| it.0);
        let parts = ["legend-", "worst-", "scale-", "angle-of-", "elements-", "up-to", "not-shown"];
        let of_legend: Vec<&str> =
            keys.filter(|key| parts.iter().any(|part| key.starts_with(part))).collect();
        assert!(of_legend.len() > 18);
        for (key, language) in of_legend.iter().flat_map(|key| Language::ALL.map(|language| (key, language)))
        {
            let text = Texts(language).with(key, values);
            assert!(has_letters(&text), "{key}: {text}");
        }
    }
}
