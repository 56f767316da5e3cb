//! Where in a scene file something stands.

use crate::io::{Place, Problem, ReadError};
use std::ops::Range;
use toml::de::{DeTable, DeValue};

/// The text of a scene file, read again to say where a fault is.
#[derive(Clone, Copy)]
pub(super) struct Source<'a>(pub(super) &'a str);

/// A key of a table and what it stands for, as ranges of bytes.
struct Entry {
    /// The dotted key.
    path: String,
    key: Range<usize>,
    value: Range<usize>,
}

/// A message about types, by the names that people who write scenes have for them.
fn in_words(message: &str) -> String {
    if message.contains("expected struct variant") {
        return "it needs members of its own, as in `{ sphere = { radius = 1 } }`".into();
    }
    if message.contains("expected newtype variant") {
        return "it needs a value, as in `{ offset = 1 }`".into();
    }
    message.replace("expected u32", "expected a whole number, 0 or more").replace(
        "wanted exactly 1 element, more than 1 element",
        "it may be one thing, but several are given",
    )
}

impl Source<'_> {
    /// What the parser or a type of a key says.
    pub(super) fn syntax(self, error: &toml::de::Error) -> ReadError {
        let span = error.span().unwrap_or(0..0);
        // Where the text is no TOML there are no keys.
        let key = self.key(&span).map_or_else(String::new, |key| format!("`{key}`: "));
        let found = format!("{key}{}", in_words(error.message()));
        ReadError::new(Problem::Syntax, self.line(&span), found, "see data/scenes for examples")
    }

    /// A value that makes no sense.
    pub(super) fn error(self, span: &Range<usize>, found: &str, advice: &str) -> ReadError {
        let found = match self.key(span) {
            Some(key) => format!("`{key}`: {found}"),
            None => found.to_owned(),
        };
        ReadError::new(Problem::Range, self.line(span), found, advice)
    }

    /// The place of the first of these keys that a table at `span` has; that of the table, if it has none of them.
    pub(super) fn member(self, span: &Range<usize>, names: &[&str]) -> Range<usize> {
        let entries = self.entries();
        let name = |path: &str| path.rsplit('.').next().unwrap_or_default().to_owned();
        // An entry belongs to the innermost table in front of it whose path is its own without the last step.
        let table = entries.iter().position(|entry| entry.value == *span);
        let of_table = entries.iter().skip(table.map_or(usize::MAX, |table| table + 1));
        let prefix = table.map_or("", |table| &entries[table].path);
        let mut own = of_table
            .take_while(|entry| entry.path.len() > prefix.len() && entry.path.starts_with(prefix))
            .filter(|entry| !entry.path[prefix.len() + 1..].contains('.'));
        let found = own.find(|entry| names.contains(&&*name(&entry.path)));
        found.map_or_else(|| span.clone(), |entry| entry.key.clone())
    }

    fn line(self, span: &Range<usize>) -> Place {
        let before = &self.0.as_bytes()[..span.start.min(self.0.len())];
        Place::Line(1 + before.iter().filter(|&&byte| byte == b'\n').count() as u64)
    }

    /// The innermost key that a place belongs to.
    fn key(self, span: &Range<usize>) -> Option<String> {
        let holds = |outer: &Range<usize>| outer.start <= span.start && span.end <= outer.end;
        let reach = |entry: &Entry| {
            [&entry.key, &entry.value].into_iter().filter(|place| holds(place)).map(|place| place.len()).min()
        };
        let entries = self.entries();
        entries
            .iter()
            .filter_map(|entry| Some((reach(entry)?, &entry.path)))
            .min()
            .map(|(_, path)| path.clone())
    }

    /// All keys, each in front of those in it; none, if the text cannot be parsed.
    fn entries(self) -> Vec<Entry> {
        let mut entries = Vec::new();
        if let Ok(root) = DeTable::parse(self.0) {
            add(root.get_ref(), "", &mut entries);
        }
        entries
    }
}

/// The parser bounds how deep tables lie in each other.
fn add(table: &DeTable<'_>, above: &str, entries: &mut Vec<Entry>) {
    for (key, value) in table {
        let path = format!("{above}{}", key.get_ref());
        let below = format!("{path}.");
        let mut entry =
            |value: Range<usize>| entries.push(Entry { path: path.clone(), key: key.span(), value });
        match value.get_ref() {
            DeValue::Table(inner) => {
                entry(value.span());
                add(inner, &below, entries);
            }
            DeValue::Array(list) if list.iter().any(|element| element.get_ref().is_table()) => {
                for element in list {
                    entries.push(Entry { path: path.clone(), key: key.span(), value: element.span() });
                    if let DeValue::Table(inner) = element.get_ref() {
                        add(inner, &below, entries);
                    }
                }
            }
            _ => entry(value.span()),
        }
    }
}
