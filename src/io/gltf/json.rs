//! A JSON text with the byte span of every value.
//!
//! A glTF document is edited, not written anew. The text is scanned without recursion and with bounded nesting into a
//! flat list of nodes in document order: every number keeps its spelling, every object its duplicates and order.
//! `serde_json` checks that it is JSON.

use crate::io::{Place, Problem, ReadError, WriteError};
use serde::de::IgnoredAny;
use std::borrow::Cow;
use std::ops::Range;

/// A value of a [`Json`] text: its number in document order.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub struct Value(u32);

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Kind {
    Object,
    Array,
    String,
    Number,
    Literal,
}

#[derive(Clone, Copy, Debug)]
struct Node {
    start: u32,
    end: u32,
    /// The node after this one and all that is in it.
    next: u32,
    kind: Kind,
}

/// What is wrong, without the line and the column: the place has the offset in the file.
fn without_position(error: &serde_json::Error) -> String {
    let text = error.to_string();
    text.rsplit_once(" at line ").map_or(text.as_str(), |(found, _)| found).to_owned()
}

/// A JSON text and the spans of its values.
#[derive(Clone, Debug)]
pub struct Json {
    text: String,
    nodes: Vec<Node>,
}

impl Json {
    /// Reads a text. `origin` is the offset of the text in its file, for error places.
    pub fn parse(text: Vec<u8>, origin: u64, max_depth: usize) -> Result<Json, ReadError> {
        let error = |problem, at: usize, found: String, advice: &str| {
            ReadError::new(problem, Place::Byte(origin + at as u64), found, advice)
        };
        let syntax =
            |at, found| error(Problem::Syntax, at, found, "the JSON is damaged; export the file again");
        if u32::try_from(text.len()).is_err() {
            let found = format!("the JSON has {} bytes (limit 4 GiB)", text.len());
            return Err(error(Problem::Limit, 0, found, "store the buffers in binary files"));
        }
        let text = String::from_utf8(text)
            .map_err(|error| syntax(error.utf8_error().valid_up_to(), "the JSON is not UTF-8".into()))?;
        let begin = if text.starts_with('\u{FEFF}') { '\u{FEFF}'.len_utf8() } else { 0 };
        let nodes = scan(text.as_bytes(), begin, max_depth).map_err(|at| {
            let found = format!("the JSON is nested more than {max_depth} deep");
            error(Problem::Limit, at, found, "export the file again, with less nesting")
        })?;
        serde_json::from_str::<IgnoredAny>(&text[begin..])
            .map_err(|error| syntax(begin + offset_of(&error, &text[begin..]), without_position(&error)))?;
        Ok(Json { text, nodes })
    }

    /// Parses a text that edits of this program have made. Splicing keeps JSON JSON; its depth was bounded when it was read.
    pub fn of_edited(text: String) -> Result<Json, WriteError> {
        Json::parse(text.into_bytes(), 0, usize::MAX).map_err(|error| WriteError::TooLarge(error.to_string()))
    }

    pub fn text(&self) -> &str {
        &self.text
    }

    pub fn root(&self) -> Value {
        Value(0)
    }

    pub fn kind(&self, value: Value) -> Kind {
        self.node(value).kind
    }

    pub fn span(&self, value: Value) -> Range<usize> {
        let node = self.node(value);
        node.start as usize..node.end as usize
    }

    pub fn raw(&self, value: Value) -> &str {
        &self.text[self.span(value)]
    }

    pub fn place(&self, value: Value) -> Place {
        Place::Json(self.pointer(value))
    }

    /// The JSON pointer of a value, such as `/accessors/3`.
    pub fn pointer(&self, value: Value) -> String {
        let holds = |inner: Value| inner <= value && value.0 < self.node(inner).next;
        let (mut pointer, mut at) = (String::new(), self.root());
        while at != value {
            let member = self.members(at).find(|&(_, inner)| holds(inner));
            let member = member.map(|(key, inner)| (self.string(key).unwrap_or_default(), inner));
            let element = || self.elements(at).enumerate().find(|&(_, inner)| holds(inner));
            let step = member.or_else(|| element().map(|(k, inner)| (Cow::from(k.to_string()), inner)));
            let Some((name, inner)) = step else { break };
            pointer.extend(["/", &name]);
            at = inner;
        }
        pointer
    }

    /// The members of an object, in order; none for other values.
    pub fn members(&self, object: Value) -> impl Iterator<Item = (Value, Value)> + '_ {
        let keys = self.siblings(object, Kind::Object, 1);
        keys.map(|key| (key, Value(key.0 + 1)))
    }

    /// The elements of an array, in order; none for other values.
    pub fn elements(&self, array: Value) -> impl Iterator<Item = Value> + '_ {
        self.siblings(array, Kind::Array, 0)
    }

    /// The first values of the entries of a container of a kind; the last value of an entry is `last` nodes after its first.
    fn siblings(&self, container: Value, kind: Kind, last: u32) -> impl Iterator<Item = Value> + '_ {
        let end = if self.kind(container) == kind { self.node(container).next } else { 0 };
        let mut at = container.0 + 1;
        std::iter::from_fn(move || {
            let value = (at < end).then_some(Value(at))?;
            at = self.nodes[(at + last) as usize].next;
            Some(value)
        })
    }

    /// All values inside a value, at any depth, keys included.
    pub fn descendants(&self, value: Value) -> impl Iterator<Item = Value> + '_ {
        (value.0 + 1..self.node(value).next).map(Value)
    }

    /// The member of an object with a name; the last one if there are several, as browsers do.
    pub fn member(&self, object: Value, name: &str) -> Option<Value> {
        let has_name = |key| self.string(key).is_some_and(|string| string == name);
        self.members(object).filter(|&(key, _)| has_name(key)).map(|(_, value)| value).last()
    }

    /// The elements of a member that is an array; none if it is not.
    pub fn items(&self, object: Value, name: &str) -> impl Iterator<Item = Value> + '_ {
        self.member(object, name).into_iter().flat_map(|array| self.elements(array))
    }

    /// The text of a string, without quotes and escapes; `None` for other values.
    pub fn string(&self, value: Value) -> Option<Cow<'_, str>> {
        if self.kind(value) != Kind::String {
            return None;
        }
        let raw = self.raw(value);
        let inner = &raw[1..raw.len() - 1];
        if inner.contains('\\') {
            // Lone surrogates are the one thing that the scanner lets pass and this does not.
            Some(Cow::Owned(serde_json::from_str(raw).unwrap_or_else(|_| inner.to_owned())))
        } else {
            Some(Cow::Borrowed(inner))
        }
    }

    pub fn number(&self, value: Value) -> Option<f64> {
        if self.kind(value) == Kind::Number { self.raw(value).parse().ok() } else { None }
    }

    /// A number without fraction and sign, however spelt (`3`, `3.0`, `3e0`); `None` for other values.
    pub fn integer(&self, value: Value) -> Option<u64> {
        if self.kind(value) != Kind::Number {
            return None;
        }
        self.raw(value).parse().ok().or_else(|| {
            // Beyond 2^53 not every integer is a double.
            self.number(value).filter(|n| (0.0..9e15).contains(n) && n.trunc() == *n).map(|n| n as u64)
        })
    }

    /// The integer that a member is; `None` for other values, and without the member.
    pub fn integer_member(&self, object: Value, name: &str) -> Option<u64> {
        self.integer(self.member(object, name)?)
    }

    pub fn boolean(&self, value: Value) -> Option<bool> {
        match self.raw(value) {
            "true" => Some(true),
            "false" => Some(false),
            _ => None,
        }
    }

    fn node(&self, value: Value) -> &Node {
        &self.nodes[value.0 as usize]
    }
}

pub fn quoted(text: &str) -> String {
    serde_json::Value::from(text).to_string()
}

/// The values of a text from `at` on, in document order, or the offset of a container that is nested too deep.
fn scan(text: &[u8], mut at: usize, max_depth: usize) -> Result<Vec<Node>, usize> {
    let mut nodes: Vec<Node> = Vec::new();
    let mut open: Vec<usize> = Vec::new();
    while let Some(&first) = text.get(at) {
        let start = at;
        at += 1;
        let kind = match first {
            b' ' | b'\t' | b'\n' | b'\r' | b',' | b':' => continue,
            b'}' | b']' => {
                if let Some(container) = open.pop() {
                    let next = nodes.len() as u32;
                    let node = &mut nodes[container];
                    (node.end, node.next) = (at as u32, next);
                }
                continue;
            }
            b'{' | b'[' => {
                if open.len() >= max_depth {
                    return Err(start);
                }
                open.push(nodes.len());
                if first == b'{' { Kind::Object } else { Kind::Array }
            }
            b'"' => {
                at = end_of_string(text, at);
                Kind::String
            }
            _ => {
                let is_inside = |byte: &&u8| byte.is_ascii_alphanumeric() || b"+-.".contains(byte);
                at += text[at..].iter().take_while(is_inside).count();
                if first.is_ascii_alphabetic() { Kind::Literal } else { Kind::Number }
            }
        };
        let next = nodes.len() as u32 + 1;
        nodes.push(Node { start: start as u32, end: at as u32, next, kind });
    }
    Ok(nodes)
}

/// The offset after the closing quote of a string, whose content begins at `at`.
fn end_of_string(text: &[u8], mut at: usize) -> usize {
    while let Some(offset) = text.get(at..).and_then(|rest| memchr::memchr2(b'"', b'\\', rest)) {
        at += offset + 1;
        if text[at - 1] == b'"' {
            return at;
        }
        at += 1;
    }
    text.len()
}

/// The offset of what `serde_json` complains about.
fn offset_of(error: &serde_json::Error, text: &str) -> usize {
    if error.is_eof() {
        return text.len();
    }
    let lines = text.split_inclusive('\n').take(error.line().saturating_sub(1));
    lines.map(str::len).sum::<usize>() + error.column().saturating_sub(1)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn parse(text: &str) -> Result<Json, ReadError> {
        Json::parse(text.as_bytes().to_vec(), 0, 16)
    }

    #[test]
    fn spans_and_spelling_survive() {
        let json = parse(" {\"a\" : [1.50, 2e0 ,-0], \"b\":{\"c\":\"x\\u0041\"}, \"a\":true } ").unwrap();
        let root = json.root();
        assert_eq!(json.boolean(json.member(root, "a").unwrap()), Some(true), "the last duplicate counts");
        let first = json.members(root).next().unwrap().1;
        let spelt: Vec<&str> = json.elements(first).map(|v| json.raw(v)).collect();
        assert_eq!(spelt, ["1.50", "2e0", "-0"]);
        let integers: Vec<Option<u64>> = json.elements(first).map(|v| json.integer(v)).collect();
        assert_eq!(integers, [None, Some(2), Some(0)]);
        let b = json.member(root, "b").unwrap();
        assert_eq!(json.string(json.member(b, "c").unwrap()).unwrap(), "xA");
        assert_eq!(json.raw(b), "{\"c\":\"x\\u0041\"}");
    }

    #[test]
    fn agrees_with_serde_json_on_what_is_json() {
        let texts = [
            "{}",
            "[]",
            "[[],{}]",
            "1",
            "-1.5E+3",
            "\"\"",
            "null",
            "[1,]",
            "{,}",
            "{\"a\"}",
            "{\"a\":}",
            "01",
            "1.",
            ".5",
            "1e",
            "+1",
            "\"\\x\"",
            "\"\\u12\"",
            "\"\n\"",
            "tru",
            "[1 2]",
            "{} {}",
            "",
            " ",
            "[",
            "{\"a\":1",
            "]",
            "\"",
            "{\"a\":1,\"a\":2}",
            "[null,true,false]",
            "nul",
            "-",
            "[1]]",
            "{\"a\":[}",
            "{\"a\":1,}",
            "{1:2}",
        ];
        for text in texts {
            let ours = parse(text).is_ok();
            assert_eq!(ours, serde_json::from_str::<serde_json::Value>(text).is_ok(), "{text:?}");
        }
    }

    #[test]
    fn depth_is_bounded_without_recursion() {
        let deep = "[".repeat(200_000);
        assert_eq!(parse(&deep).unwrap_err().problem, Problem::Limit);
        assert!(parse(&("[".repeat(16) + &"]".repeat(16))).is_ok());
        assert!(parse(&("[".repeat(17) + &"]".repeat(17))).is_err());
    }
}
