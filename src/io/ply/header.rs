//! The header: elements and their properties, with the byte ranges that an edit may change.

use super::scalar::{Encoding, Scalar};
use crate::io::text::{next_word, shown};
use crate::io::{Place, Problem, ReadError};
use std::ops::Range;

#[derive(Clone, Debug)]
pub(super) struct Header {
    pub encoding: Encoding,
    pub elements: Vec<Element>,
    pub line_end: &'static str,
    pub body: usize,
}

#[derive(Clone, Debug)]
pub(super) struct Element {
    pub name: String,
    pub name_at: Range<usize>,
    pub count: u64,
    pub count_at: Range<usize>,
    pub properties: Vec<Property>,
    pub line: u64,
}

#[derive(Clone, Debug)]
pub(super) struct Property {
    pub name: String,
    pub kind: Kind,
    /// The type: of the items, if it is a list.
    pub type_at: Range<usize>,
    /// Whether the type is named with its size.
    pub sized_name: bool,
    /// Where its line ends, line end included.
    pub line_end: usize,
}

/// One number a row, or a list of them.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Kind {
    Scalar(Scalar),
    List { count: Scalar, item: Scalar },
}

impl Kind {
    /// The type of its numbers: of the items, if it is a list.
    pub fn scalar(self) -> Scalar {
        match self {
            Kind::Scalar(scalar) | Kind::List { item: scalar, .. } => scalar,
        }
    }
}

impl Element {
    pub fn property(&self, name: &str) -> Option<usize> {
        self.properties.iter().position(|property| property.name == name)
    }

    /// The scalar properties of these names, if all are there.
    pub fn scalars<const N: usize>(&self, names: [&str; N]) -> Option<[usize; N]> {
        let found = names.map(|name| {
            self.property(name).filter(|&at| matches!(self.properties[at].kind, Kind::Scalar(_)))
        });
        found.iter().all(Option::is_some).then(|| found.map(Option::unwrap_or_default))
    }

    /// The bytes of every row, if rows are binary and have no lists.
    pub fn stride(&self, encoding: Encoding) -> Option<usize> {
        let has_lists = self.properties.iter().any(|property| matches!(property.kind, Kind::List { .. }));
        (encoding != Encoding::Ascii && !has_lists).then(|| self.smallest_row(encoding) as usize)
    }

    /// The fewest bytes that a row takes; in ascii each number takes a digit and a separator.
    pub fn smallest_row(&self, encoding: Encoding) -> u64 {
        let size = |kind| match kind {
            Kind::Scalar(scalar) => scalar.size() as u64,
            Kind::List { count, .. } => count.size() as u64,
        };
        match encoding {
            Encoding::Ascii => 2 * self.properties.len() as u64,
            _ => self.properties.iter().map(|property| size(property.kind)).sum(),
        }
    }
}

/// A line of the header: its words, and where it ends.
struct Line<'a> {
    number: u64,
    words: Vec<(&'a [u8], Range<usize>)>,
    end: usize,
}

impl Line<'_> {
    fn fault(&self, found: impl Into<String>, advice: &str) -> ReadError {
        ReadError::new(Problem::Syntax, Place::Line(self.number), found, advice)
    }
}

/// Parses a header. Lines end as the first one does; blanks may be anywhere; comments are in any encoding.
pub(super) fn parse(bytes: &[u8]) -> Result<Header, ReadError> {
    let line_end = match bytes {
        [b'p', b'l', b'y', rest @ ..] => line_end(rest),
        _ => None,
    };
    let Some(line_end) = line_end else {
        let found = "not a PLY file: the first line is not `ply`";
        return Err(ReadError::new(Problem::Syntax, Place::File, found, "name the format with --format"));
    };
    let (mut encoding, mut elements) = (None, Vec::<Element>::new());
    let (mut at, mut number) = (0, 0);
    loop {
        let Some(line) = next_line(bytes, at, number + 1, line_end) else {
            let (place, found) = (Place::Line(number), "the header has no `end_header` line");
            return Err(ReadError::new(
                Problem::Truncated,
                place,
                found,
                "the file is cut off; copy or export it again",
            ));
        };
        (at, number) = (line.end, line.number);
        let keyword = line.words.first().map_or(&b""[..], |(word, _)| word);
        match keyword {
            b"" | b"comment" | b"obj_info" => {}
            b"ply" if number == 1 => {}
            b"format" => encoding = Some(format(&line)?),
            b"element" => elements.push(element(&line)?),
            b"property" => {
                let Some(element) = elements.last_mut() else {
                    let found = "this property comes before the first element";
                    return Err(line.fault(found, "correct the header"));
                };
                element.properties.push(property(&line)?);
            }
            b"end_header" => break,
            word => {
                let found = format!("unknown header line `{}`", shown(word));
                return Err(line.fault(found, "correct the line, or make it a comment"));
            }
        }
    }
    let Some(encoding) = encoding else {
        let found = "the header has no `format` line";
        return Err(ReadError::new(Problem::Syntax, Place::Line(number), found, "add it"));
    };
    Ok(Header { encoding, elements, line_end, body: at })
}

fn line_end(after_magic: &[u8]) -> Option<&'static str> {
    let blanks = after_magic.iter().take_while(|byte| matches!(byte, b' ' | b'\t')).count();
    let rest = &after_magic[blanks..];
    ["\r\n", "\r", "\n"].into_iter().find(|end| rest.starts_with(end.as_bytes()))
}

/// The line that starts at `at`; `None` if it does not end.
fn next_line<'a>(bytes: &'a [u8], at: usize, number: u64, line_end: &str) -> Option<Line<'a>> {
    // With CR LF a lone LF ends a line too; with CR alone an LF is the first byte of a binary body.
    let last = if line_end == "\r" { b'\r' } else { b'\n' };
    let end = at + memchr::memchr(last, &bytes[at..])?;
    let (mut words, mut start) = (Vec::new(), at);
    // More words than any line needs are those of a comment.
    while words.len() < 6
        && let Some(word) = next_word(&bytes[..end], start)
    {
        start = word.end;
        words.push((&bytes[word.clone()], word));
    }
    Some(Line { number, words, end: end + 1 })
}

fn format(line: &Line<'_>) -> Result<Encoding, ReadError> {
    match line.words.get(1).map(|(word, _)| *word) {
        Some(b"ascii") => Ok(Encoding::Ascii),
        Some(b"binary_little_endian") => Ok(Encoding::Little),
        Some(b"binary_big_endian") => Ok(Encoding::Big),
        other => {
            let found = format!("unknown format `{}`", shown(other.unwrap_or_default()));
            Err(line.fault(found, "use ascii, binary_little_endian or binary_big_endian"))
        }
    }
}

fn element(line: &Line<'_>) -> Result<Element, ReadError> {
    let [_, (name, name_at), (count, count_at), ..] = &line.words[..] else {
        return Err(line.fault("the element has no name or no count", "correct the line"));
    };
    let text = str::from_utf8(count).ok();
    let Some(number) = text.and_then(|text| text.parse::<u64>().ok()) else {
        let found = format!("`{}` is not a valid row count", shown(count));
        return Err(line.fault(found, "correct the count"));
    };
    Ok(Element {
        name: String::from_utf8_lossy(name).into_owned(),
        name_at: name_at.clone(),
        count: number,
        count_at: count_at.clone(),
        properties: Vec::new(),
        line: line.number,
    })
}

fn property(line: &Line<'_>) -> Result<Property, ReadError> {
    let scalar = |at: usize| {
        let (word, place) = &line.words[at];
        let Some((scalar, sized)) = Scalar::from_name(word) else {
            let found = format!("unknown number type `{}`", shown(word));
            let advice = "use char, uchar, short, ushort, int, uint, float or double";
            return Err(line.fault(found, advice));
        };
        Ok((scalar, sized, place.clone()))
    };
    let (kind, (_, sized_name, type_at), name) = match &line.words[..] {
        [_, (b"list", _), _, _, (name, _), ..] => {
            let ((count, ..), item) = (scalar(2)?, scalar(3)?);
            if !count.is_integer() {
                return Err(line.fault("the count of the list is not an integer type", "correct the type"));
            }
            (Kind::List { count, item: item.0 }, item, name)
        }
        [_, (first, _), (name, _), ..] if *first != b"list" => {
            let scalar = scalar(1)?;
            (Kind::Scalar(scalar.0), scalar, name)
        }
        _ => return Err(line.fault("the property has no type or no name", "correct the line")),
    };
    let name = String::from_utf8_lossy(name).into_owned();
    Ok(Property { name, kind, type_at, sized_name, line_end: line.end })
}
