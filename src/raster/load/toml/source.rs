//! The line and the key of an error in a scene file.

use crate::io::{Place, Problem, ReadError};
use std::ops::Range;
use toml::Spanned;
use toml::de::{DeTable, DeValue};

/// The text of a scene file, which is parsed again to report an error.
#[derive(Clone, Copy)]
pub(super) struct Source<'a>(pub(super) &'a str);

/// A key of a table and its value, as ranges of bytes.
struct Entry {
    path: String,
    key: Range<usize>,
    value: Range<usize>,
}

/// Words of serde and the words that authors of scenes know, longer ones first.
const WORDS: [(&str, &str); 21] = [
    (
        "unit variant, expected struct variant",
        "a name alone, expected members, as in `{ sphere = { radius = 1 } }`",
    ),
    ("unit variant, expected newtype variant", "a name alone, expected a value, as in `{ NAME = 1 }`"),
    ("wanted exactly 1 element, more than 1 element", "expected one of these keys, found several"),
    ("wanted exactly 1 element, found 0 elements", "expected one key, found none"),
    ("wanted string or table", "expected a name or a table"),
    ("expected struct variant", "expected members, as in `{ sphere = { radius = 1 } }`"),
    ("unexpected keys in table", "unknown keys"),
    ("unknown variant", "unknown name"),
    ("unknown field", "unknown key"),
    ("missing field", "missing key"),
    ("invalid length ", "found a list of length "),
    ("an array of length ", "a list of length "),
    ("invalid type: ", "found "),
    ("invalid value: ", "found "),
    ("expected f64", "expected a number"),
    ("expected u32", "expected a whole number from 0 to 4294967295"),
    ("expected table", "expected a table"),
    ("a sequence", "a list"),
    ("sequence", "a list"),
    ("a map", "a table"),
    ("found map", "found a table"),
];

/// A message of serde in the words of authors of scenes. What is quoted is the author's own.
fn in_plain_words(message: &str) -> String {
    // The name of a variant of ours may follow.
    let message = message.split(" SurfaceTable::").next().unwrap_or_default();
    let mut plain = String::new();
    let mut rest = message;
    while !rest.is_empty() {
        let quote = rest.find(['`', '"']).unwrap_or(rest.len());
        let mut text = rest[..quote].to_owned();
        for (from, to) in WORDS {
            text = text.replace(from, to);
        }
        // The name of a type of ours.
        if let Some((before, name)) = text.split_once("expected struct ") {
            let after = name.trim_start_matches(|c: char| c.is_alphanumeric());
            text = format!("{before}expected a table{after}");
        }
        plain.push_str(&text);
        rest = &rest[quote..];
        let Some(mark) = rest.chars().next() else { break };
        let end = rest[1..].find(mark).map_or(rest.len(), |end| end + 2);
        plain.push_str(&rest[..end]);
        rest = &rest[end..];
    }
    plain
}

impl Source<'_> {
    /// An error of the TOML parser, or of a value that does not have the type of its key.
    pub(super) fn syntax(self, error: &toml::de::Error) -> ReadError {
        let span = error.span().unwrap_or(0..0);
        let message = in_plain_words(error.message());
        let found = match self.0.get(span.clone()) {
            // Such a message names only the allowed values.
            Some(value) if message.starts_with("expected") => format!("`{value}`: {message}"),
            _ => message,
        };
        let advice = match self.key(&span) {
            Some(key) if found == "found a table, expected a list" => {
                format!("write `[[{key}]]`: there may be several")
            }
            _ => String::new(),
        };
        ReadError { problem: Problem::Syntax, ..self.error(&span, &found, &advice) }
    }

    pub(super) fn error(self, span: &Range<usize>, found: &str, advice: &str) -> ReadError {
        let before = &self.0.as_bytes()[..span.start.min(self.0.len())];
        let line = 1 + before.iter().filter(|&&byte| byte == b'\n').count() as u64;
        let found = match self.key(span) {
            Some(key) => format!("`{key}`: {found}"),
            None => found.to_owned(),
        };
        ReadError::new(Problem::Range, Place::Line(line), found, advice)
    }

    /// What `make` returns for a value, or an error that says what was expected. `default` if there is no value.
    pub(super) fn checked<T, U>(
        self,
        value: &Option<Spanned<T>>,
        default: U,
        make: impl FnOnce(&T) -> Option<U>,
        expected: &str,
    ) -> Result<U, ReadError> {
        let Some(value) = value else { return Ok(default) };
        let error = || {
            self.error(
                &value.span(),
                &format!("found {}", self.0.get(value.span()).unwrap_or_default()),
                expected,
            )
        };
        make(value.get_ref()).ok_or_else(error)
    }

    /// The span of the first of these keys in the table at `span`; that of the table if it has none of them.
    pub(super) fn member(self, span: &Range<usize>, names: &[&str]) -> Range<usize> {
        let entries = self.entries();
        let Some(table) = entries.iter().position(|entry| entry.value == *span) else { return span.clone() };
        let prefix = format!("{}.", entries[table].path);
        let in_table = entries[table + 1..].iter().take_while(|entry| entry.path.starts_with(&prefix));
        let mut named = in_table.filter(|entry| names.contains(&&entry.path[prefix.len()..]));
        named.next().map_or_else(|| span.clone(), |entry| entry.key.clone())
    }

    /// The innermost key that a span belongs to; `None` if the text is no TOML.
    fn key(self, span: &Range<usize>) -> Option<String> {
        let holds = |outer: &&Range<usize>| outer.start <= span.start && span.end <= outer.end;
        let length =
            |entry: &Entry| [&entry.key, &entry.value].into_iter().filter(holds).map(|r| r.len()).min();
        let holding = self.entries().into_iter().filter_map(|entry| Some((length(&entry)?, entry.path)));
        holding.min().map(|(_, path)| path)
    }

    /// All keys, each before those in its value; none if the text cannot be parsed.
    fn entries(self) -> Vec<Entry> {
        let mut entries = Vec::new();
        if let Ok(root) = DeTable::parse(self.0) {
            add(root.get_ref(), "", &mut entries);
        }
        entries
    }
}

/// The parser limits the depth of tables.
fn add(table: &DeTable<'_>, prefix: &str, entries: &mut Vec<Entry>) {
    for (key, value) in table {
        let path = format!("{prefix}{}", key.get_ref());
        let tables = match value.get_ref() {
            DeValue::Array(list) if list.iter().any(|element| element.get_ref().is_table()) => &list[..],
            _ => std::slice::from_ref(value),
        };
        for value in tables {
            entries.push(Entry { path: path.clone(), key: key.span(), value: value.span() });
            if let DeValue::Table(inner) = value.get_ref() {
                add(inner, &format!("{path}."), entries);
            }
        }
    }
}
