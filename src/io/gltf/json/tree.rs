//! JSON that knows where every value stands in the text.
//!
//! A glTF document is edited, not written anew, so what matters here is the byte span of each value. The text
//! is scanned once, without recursion and with bounded nesting, into a flat list of nodes in document order;
//! every number keeps its spelling, every object its duplicates and order.

use crate::io::{Place, Problem, ReadError};
use std::borrow::Cow;
use std::ops::Range;

/// A value of a [`Json`] text: its number in document order.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub struct Value(u32);

/// What a value is.
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

/// A JSON text and the spans of its values.
#[derive(Clone, Debug)]
pub struct Json {
    text: String,
    nodes: Vec<Node>,
}

impl Json {
    /// Scans a text. `origin` is the offset of the text in its file, for error places.
    pub fn parse(text: Vec<u8>, origin: u64, max_depth: usize) -> Result<Json, ReadError> {
        let syntax = |at: usize, found: String| {
            let advice = "the JSON is broken; export the file again";
            ReadError::new(Problem::Syntax, Place::Byte(origin + at as u64), found, advice)
        };
        if u32::try_from(text.len()).is_err() {
            let found = format!("{} bytes of JSON, more than 4 GiB", text.len());
            return Err(ReadError::new(
                Problem::Limit,
                Place::File,
                found,
                "store the buffers in binary files",
            ));
        }
        let text = String::from_utf8(text)
            .map_err(|error| syntax(error.utf8_error().valid_up_to(), "a byte that is not UTF-8".into()))?;
        let mut scanner = Scanner { text: text.as_bytes(), at: 0, nodes: Vec::new(), max_depth };
        match scanner.document() {
            Ok(()) => {
                let nodes = scanner.nodes;
                Ok(Json { text, nodes })
            }
            Err(Fault::Depth(at)) => Err(ReadError::new(
                Problem::Limit,
                Place::Byte(origin + at as u64),
                format!("JSON nested more than {max_depth} deep"),
                "no glTF file needs this; check where it comes from",
            )),
            Err(Fault::Syntax(at, found)) => Err(syntax(at, found)),
        }
    }

    /// The whole text.
    pub fn text(&self) -> &str {
        &self.text
    }

    /// The outermost value.
    pub fn root(&self) -> Value {
        Value(0)
    }

    pub fn kind(&self, value: Value) -> Kind {
        self.node(value).kind
    }

    /// The bytes of the text that a value takes.
    pub fn span(&self, value: Value) -> Range<usize> {
        let node = self.node(value);
        node.start as usize..node.end as usize
    }

    /// A value as it is spelt.
    pub fn raw(&self, value: Value) -> &str {
        &self.text[self.span(value)]
    }

    /// The members of an object, in order; nothing for other values.
    pub fn members(&self, object: Value) -> impl Iterator<Item = (Value, Value)> + '_ {
        let end = if self.kind(object) == Kind::Object { self.node(object).next } else { object.0 + 1 };
        let mut key = object.0 + 1;
        std::iter::from_fn(move || {
            if key >= end {
                return None;
            }
            let pair = (Value(key), Value(key + 1));
            key = self.nodes[key as usize + 1].next;
            Some(pair)
        })
    }

    /// The elements of an array, in order; nothing for other values.
    pub fn elements(&self, array: Value) -> impl Iterator<Item = Value> + '_ {
        let end = if self.kind(array) == Kind::Array { self.node(array).next } else { array.0 + 1 };
        let mut element = array.0 + 1;
        std::iter::from_fn(move || {
            if element >= end {
                return None;
            }
            let value = Value(element);
            element = self.nodes[element as usize].next;
            Some(value)
        })
    }

    /// All values inside a value, at any depth, keys included.
    pub fn descendants(&self, value: Value) -> impl Iterator<Item = Value> + '_ {
        (value.0 + 1..self.node(value).next).map(Value)
    }

    /// The member of an object with a name; the last one if there are several, as browsers do.
    pub fn member(&self, object: Value, name: &str) -> Option<Value> {
        self.members(object).filter(|&(key, _)| self.is_string(key, name)).map(|(_, value)| value).last()
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

    /// A number; `None` for other values.
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

    /// `true` or `false`; `None` for other values.
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

    fn is_string(&self, value: Value, text: &str) -> bool {
        self.string(value).is_some_and(|string| string == text)
    }
}

/// A string as JSON, quotes included.
pub fn quoted(text: &str) -> String {
    serde_json::Value::from(text).to_string()
}

enum Fault {
    Syntax(usize, String),
    Depth(usize),
}

struct Scanner<'a> {
    text: &'a [u8],
    at: usize,
    nodes: Vec<Node>,
    max_depth: usize,
}

impl Scanner<'_> {
    fn document(&mut self) -> Result<(), Fault> {
        if self.text.starts_with(b"\xEF\xBB\xBF") {
            self.at = 3;
        }
        let mut open: Vec<u32> = Vec::new();
        loop {
            let complete = self.value(&mut open)?;
            if complete && !self.after_value(&mut open)? {
                break;
            }
        }
        self.blanks();
        if self.at < self.text.len() {
            return Err(self.unexpected("the end of the document"));
        }
        Ok(())
    }

    /// Reads a leaf or an empty container, or opens a container up to its first value. Returns whether the
    /// value is complete.
    fn value(&mut self, open: &mut Vec<u32>) -> Result<bool, Fault> {
        self.blanks();
        let start = self.at;
        match self.text.get(start) {
            Some(&opening @ (b'{' | b'[')) => {
                if open.len() >= self.max_depth {
                    return Err(Fault::Depth(start));
                }
                self.at += 1;
                let object = opening == b'{';
                self.push(start, if object { Kind::Object } else { Kind::Array });
                self.blanks();
                if self.text.get(self.at) == Some(if object { &b'}' } else { &b']' }) {
                    self.at += 1;
                    self.close(self.nodes.len() as u32 - 1);
                    return Ok(true);
                }
                open.push(self.nodes.len() as u32 - 1);
                if object {
                    self.key()?;
                }
                Ok(false)
            }
            Some(b'"') => self.string().map(|()| true),
            Some(b'-' | b'0'..=b'9') => self.number().map(|()| true),
            _ => {
                let literal = [&b"true"[..], b"false", b"null"];
                let found = literal.into_iter().find(|literal| self.text[start..].starts_with(literal));
                let Some(found) = found else { return Err(self.unexpected("a value")) };
                self.at += found.len();
                self.push(start, Kind::Literal);
                Ok(true)
            }
        }
    }

    /// Closes containers up to the next comma. Returns whether a value follows.
    fn after_value(&mut self, open: &mut Vec<u32>) -> Result<bool, Fault> {
        while let Some(&container) = open.last() {
            self.blanks();
            let object = self.nodes[container as usize].kind == Kind::Object;
            match (self.text.get(self.at), object) {
                (Some(b','), _) => {
                    self.at += 1;
                    if object {
                        self.key()?;
                    }
                    return Ok(true);
                }
                (Some(b'}'), true) | (Some(b']'), false) => {
                    self.at += 1;
                    self.close(container);
                    open.pop();
                }
                _ => return Err(self.unexpected(if object { "`,` or `}`" } else { "`,` or `]`" })),
            }
        }
        Ok(false)
    }

    fn key(&mut self) -> Result<(), Fault> {
        self.blanks();
        if self.text.get(self.at) != Some(&b'"') {
            return Err(self.unexpected("a member's name"));
        }
        self.string()?;
        self.blanks();
        if self.text.get(self.at) != Some(&b':') {
            return Err(self.unexpected("`:`"));
        }
        self.at += 1;
        Ok(())
    }

    fn string(&mut self) -> Result<(), Fault> {
        let start = self.at;
        self.at += 1;
        loop {
            let Some(offset) = memchr::memchr2(b'"', b'\\', &self.text[self.at..]) else {
                return Err(Fault::Syntax(start, "a string without an end".into()));
            };
            let piece = &self.text[self.at..self.at + offset];
            if let Some(control) = piece.iter().position(|&byte| byte < 0x20) {
                return Err(Fault::Syntax(self.at + control, "a control character inside a string".into()));
            }
            self.at += offset + 1;
            if self.text[self.at - 1] == b'"' {
                self.push(start, Kind::String);
                return Ok(());
            }
            let hex = |digits: &[u8]| digits.len() == 4 && digits.iter().all(u8::is_ascii_hexdigit);
            let rest = &self.text[self.at..];
            self.at += match rest.first() {
                Some(b'"' | b'\\' | b'/' | b'b' | b'f' | b'n' | b'r' | b't') => 1,
                Some(b'u') if rest.get(1..5).is_some_and(hex) => 5,
                _ => return Err(Fault::Syntax(self.at - 1, "an escape that JSON does not have".into())),
            };
        }
    }

    fn number(&mut self) -> Result<(), Fault> {
        let start = self.at;
        self.at += usize::from(self.text[start] == b'-');
        let whole = self.digits()?;
        if self.text[whole.start] == b'0' && whole.len() > 1 {
            return Err(Fault::Syntax(start, "a number with a leading zero".into()));
        }
        if self.text.get(self.at) == Some(&b'.') {
            self.at += 1;
            self.digits()?;
        }
        if matches!(self.text.get(self.at), Some(b'e' | b'E')) {
            self.at += 1;
            self.at += usize::from(matches!(self.text.get(self.at), Some(b'+' | b'-')));
            self.digits()?;
        }
        self.push(start, Kind::Number);
        Ok(())
    }

    fn digits(&mut self) -> Result<Range<usize>, Fault> {
        let start = self.at;
        while self.text.get(self.at).is_some_and(u8::is_ascii_digit) {
            self.at += 1;
        }
        if self.at == start { Err(self.unexpected("a digit")) } else { Ok(start..self.at) }
    }

    fn blanks(&mut self) {
        while matches!(self.text.get(self.at), Some(b' ' | b'\t' | b'\n' | b'\r')) {
            self.at += 1;
        }
    }

    fn push(&mut self, start: usize, kind: Kind) {
        let next = self.nodes.len() as u32 + 1;
        self.nodes.push(Node { start: start as u32, end: self.at as u32, next, kind });
    }

    fn close(&mut self, container: u32) {
        let next = self.nodes.len() as u32;
        let node = &mut self.nodes[container as usize];
        (node.end, node.next) = (self.at as u32, next);
    }

    fn unexpected(&self, wanted: &str) -> Fault {
        let found = match self.text.get(self.at) {
            None => format!("the end of the text where {wanted} should be"),
            Some(byte) => format!("{:?} where {wanted} should be", *byte as char),
        };
        Fault::Syntax(self.at, found)
    }
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
