//! The body, row by row.

use super::header::{Element, Header, Kind};
use super::scalar::{Encoding, Scalar};
use crate::io::error::{NoteKind, RepeatedNotes};
use crate::io::mesh_checks::DAMAGED;
use crate::io::text::{at_byte, counted, line_end_length, line_places, next_word, shown};
use crate::io::{Place, Problem, ReadError};
use crate::mesh::NONE;
use std::ops::Range;

/// A row of ascii that has more words than properties.
pub(super) const OVERLONG: NoteKind =
    NoteKind::warning(2, "a row has more values than the header defines; they were skipped");

pub(super) fn damaged(problem: Problem, offset: usize, found: impl Into<String>) -> ReadError {
    at_byte(problem, offset, found, DAMAGED)
}

fn truncated(offset: usize, found: impl Into<String>) -> ReadError {
    at_byte(Problem::Truncated, offset, found, "the file is cut off, or a count in its header is wrong")
}

/// Where ascending offsets are: on lines in ascii, at bytes in binary.
pub(super) fn places(bytes: &[u8], encoding: Encoding, offsets: &[usize]) -> Vec<Place> {
    match encoding {
        Encoding::Ascii => line_places(bytes, offsets),
        _ => offsets.iter().map(|&offset| Place::Byte(offset as u64)).collect(),
    }
}

#[derive(Clone, Debug, Default)]
pub(super) struct Row {
    /// All of its bytes: in ascii, including blank lines before it and the rest of its last line.
    pub span: Range<usize>,
    /// The bytes of each property; of a list, its count included.
    pub fields: Vec<Range<usize>>,
}

#[derive(Clone, Debug)]
pub(super) struct Rows<'a> {
    pub bytes: &'a [u8],
    pub encoding: Encoding,
    pub at: usize,
    /// Whether several ascii rows may share a line. If not, extra words behind a row are skipped.
    pub shared_lines: bool,
    pub notes: RepeatedNotes,
}

impl<'a> Rows<'a> {
    pub fn new(bytes: &'a [u8], header: &Header, shared_lines: bool) -> Self {
        let (encoding, at) = (header.encoding, header.body);
        Self { bytes, encoding, at, shared_lines, notes: RepeatedNotes::default() }
    }

    /// Calls `each` with the number of every row of an element and the row.
    pub fn each(
        &mut self,
        element: &Element,
        mut each: impl FnMut(usize, &Row, &Self) -> Result<(), ReadError>,
    ) -> Result<(), ReadError> {
        let rest = (self.bytes.len() - self.at) as u64;
        let needed = element.count.saturating_mul(element.smallest_row(self.encoding));
        // The last line may have no end.
        let needed = needed.saturating_sub(u64::from(self.encoding == Encoding::Ascii));
        if needed > rest {
            let found = format!(
                "{} of `{}` need at least {}, but only {rest} remain",
                counted(element.count, "row", "rows"),
                element.name,
                counted(needed, "byte", "bytes"),
            );
            return Err(truncated(self.at, found));
        }
        if element.properties.is_empty() {
            return Ok(());
        }
        let mut row = Row::default();
        let stride = element.stride(self.encoding);
        for number in 0..element.count as usize {
            match stride {
                Some(stride) if number > 0 => self.shift(&mut row, stride),
                _ => self.next(element, &mut row)?,
            }
            each(number, &row, self)?;
        }
        Ok(())
    }

    /// The number of rows in the header, but no more than there are bytes for.
    pub fn plausible_count(&self, element: &Element) -> usize {
        let rest = (self.bytes.len() - self.at) as u64;
        element.count.min(rest / element.smallest_row(self.encoding).max(1)) as usize
    }

    /// Goes on to the next of rows that are all alike, which is known to be there.
    #[inline]
    fn shift(&mut self, row: &mut Row, stride: usize) {
        for place in row.fields.iter_mut().chain([&mut row.span]) {
            place.start += stride;
            place.end += stride;
        }
        self.at += stride;
    }

    pub fn next(&mut self, element: &Element, row: &mut Row) -> Result<(), ReadError> {
        let start = self.at;
        row.fields.clear();
        for property in &element.properties {
            let field = match self.encoding {
                Encoding::Ascii => self.ascii_field(property.kind),
                _ => self.binary_field(property.kind),
            };
            row.fields.push(field.map_err(|error| match error.problem {
                Problem::Truncated => {
                    ReadError { found: format!("the file ends inside a row of `{}`", element.name), ..error }
                }
                _ => error,
            })?);
        }
        if self.encoding == Encoding::Ascii {
            self.finish_line();
        }
        row.span = start..self.at;
        Ok(())
    }

    fn cut_off(&self) -> ReadError {
        truncated(self.bytes.len(), "")
    }

    #[inline]
    fn take(&mut self, length: usize) -> Result<Range<usize>, ReadError> {
        let end = self.at.checked_add(length).filter(|&end| end <= self.bytes.len());
        let end = end.ok_or_else(|| self.cut_off())?;
        let start = std::mem::replace(&mut self.at, end);
        Ok(start..end)
    }

    #[inline]
    fn binary_field(&mut self, kind: Kind) -> Result<Range<usize>, ReadError> {
        let Kind::List { count, item } = kind else { return self.take(kind.scalar().size()) };
        let counted = self.take(count.size())?;
        let number = count.read(&self.bytes[counted.clone()], self.encoding).unwrap_or(0.0);
        if number < 0.0 {
            return Err(damaged(Problem::Range, counted.start, format!("a list has {number} items")));
        }
        let items = self.take((number as usize).saturating_mul(item.size()))?;
        Ok(counted.start..items.end)
    }

    fn ascii_field(&mut self, kind: Kind) -> Result<Range<usize>, ReadError> {
        let first = self.word()?;
        let Kind::List { count, .. } = kind else { return Ok(first) };
        let word = &self.bytes[first.clone()];
        let Some(number) = count.read(word, Encoding::Ascii).filter(|n| *n >= 0.0 && n.fract() == 0.0) else {
            let found = format!("`{}` is not a valid list length", shown(word));
            return Err(damaged(Problem::Syntax, first.start, found));
        };
        // Each number takes two bytes or more.
        if number > (self.bytes.len() - first.end) as f64 {
            return Err(self.cut_off());
        }
        for _ in 0..number as usize {
            self.word()?;
        }
        Ok(first.start..self.at)
    }

    fn word(&mut self) -> Result<Range<usize>, ReadError> {
        let word = next_word(self.bytes, self.at).ok_or_else(|| self.cut_off())?;
        self.at = word.end;
        Ok(word)
    }

    /// Skips the line end behind a row, and the words before it if lines are not shared.
    fn finish_line(&mut self) {
        let rest = &self.bytes[self.at..];
        let ahead = rest.iter().position(|byte| !matches!(byte, b' ' | b'\t')).unwrap_or(rest.len());
        let is_line_end = |byte: &u8| matches!(byte, b'\n' | b'\r');
        let mut length = ahead;
        if rest.get(ahead).is_some_and(|byte| !is_line_end(byte)) {
            if self.shared_lines {
                return;
            }
            self.notes.add(OVERLONG, self.at);
            length = rest.iter().position(is_line_end).unwrap_or(rest.len());
        }
        self.at += length + line_end_length(&rest[length..]);
    }

    #[inline]
    pub fn scalar(&self, field: &Range<usize>, scalar: Scalar) -> Result<f64, ReadError> {
        let bytes = &self.bytes[field.clone()];
        scalar.read(bytes, self.encoding).ok_or_else(|| {
            let found = format!("`{}` is not a number", shown(bytes));
            damaged(Problem::Syntax, field.start, found)
        })
    }

    pub fn corners(&self, list: &Range<usize>, kind: Kind, corners: &mut Vec<u32>) -> Result<(), ReadError> {
        corners.clear();
        let scalar = kind.scalar();
        for item in self.items(list, kind) {
            corners.push(vertex_index(self.scalar(&item, scalar)?, item.start)?);
        }
        Ok(())
    }

    pub fn items(&self, field: &Range<usize>, kind: Kind) -> Items<'a> {
        let mut items = Items { bytes: self.bytes, rest: field.clone(), size: 0 };
        match kind {
            Kind::List { count, item } if self.encoding != Encoding::Ascii => {
                items.rest.start += count.size();
                items.size = item.size();
            }
            Kind::List { .. } => drop(items.next()),
            Kind::Scalar(_) => {}
        }
        items
    }
}

/// The items of a list: of one size, or words.
pub(super) struct Items<'a> {
    bytes: &'a [u8],
    rest: Range<usize>,
    /// Bytes of an item; 0 in ascii.
    size: usize,
}

impl Iterator for Items<'_> {
    type Item = Range<usize>;

    #[inline]
    fn next(&mut self) -> Option<Range<usize>> {
        let start = self.rest.start;
        if self.size > 0 {
            if self.rest.is_empty() {
                return None;
            }
            self.rest.start += self.size;
            return Some(start..self.rest.start);
        }
        let word = next_word(&self.bytes[..self.rest.end], start)?;
        self.rest.start = word.end;
        Some(word)
    }
}

/// A number as that of a vertex.
#[inline]
pub(super) fn vertex_index(value: f64, offset: usize) -> Result<u32, ReadError> {
    let number = value as u32;
    if f64::from(number) == value && number != NONE {
        return Ok(number);
    }
    Err(damaged(Problem::Range, offset, format!("{value} is not a vertex index")))
}
