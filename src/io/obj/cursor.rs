//! Bytes to tokens.
//!
//! OBJ is read as bytes: names and comments of real files are in any encoding. A statement is one line; a
//! backslash at its end continues it on the next. Comments start at `#` and end with their line: one that ends
//! in a backslash (a Windows path, say) does not swallow the statement after it. Lines end with LF, CR LF or CR.

use crate::io::text::{at_byte, counted, float, float_prefix, integer_prefix, line_end_length, shown};
use crate::io::{Problem, ReadError};
use glam::DVec3;
use memchr::{memchr2, memchr3};
use std::ops::Range;

/// One corner of a face as its statement spells it: numbers from 1, or negative ones that count back.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct CornerSpelling {
    pub vertex: i64,
    pub uv: Option<i64>,
    pub normal: Option<i64>,
}

#[derive(Clone, Debug)]
pub(super) struct Cursor<'a> {
    pub text: &'a [u8],
    pub at: usize,
}

#[inline]
fn is_blank(byte: u8) -> bool {
    matches!(byte, b' ' | b'\t' | 0x0b | 0x0c)
}

#[inline]
fn is_line_end(byte: u8) -> bool {
    matches!(byte, b'\n' | b'\r')
}

impl<'a> Cursor<'a> {
    pub fn new(text: &'a [u8], at: usize) -> Self {
        Self { text, at }
    }

    #[inline]
    pub fn peek(&self) -> u8 {
        self.text.get(self.at).copied().unwrap_or(b'\n')
    }

    #[inline]
    pub fn is_done(&self) -> bool {
        self.at >= self.text.len()
    }

    #[inline]
    pub fn skip_blanks(&mut self) {
        loop {
            let byte = self.peek();
            if is_blank(byte) {
                self.at += 1;
            } else if byte == b'\\'
                && let Some(next) = self.continuation(self.at)
            {
                self.at = next;
            } else {
                return;
            }
        }
    }

    /// Where the text continues if the backslash at `at` continues the line. Blanks behind it are ignored.
    fn continuation(&self, at: usize) -> Option<usize> {
        let rest = &self.text[at + 1..];
        let blanks = rest.iter().take_while(|&&byte| is_blank(byte)).count();
        let line_end = line_end_length(&rest[blanks..]);
        (line_end > 0).then_some(at + 1 + blanks + line_end)
    }

    #[inline]
    pub fn at_token_end(&self) -> bool {
        let byte = self.peek();
        // All that numbers and names are made of comes behind `#`.
        if byte > b'#' && byte != b'\\' {
            return false;
        }
        byte == b' ' || is_line_end(byte) || self.at_rare_token_end(byte)
    }

    #[cold]
    fn at_rare_token_end(&self, byte: u8) -> bool {
        is_blank(byte) || byte == b'#' || (byte == b'\\' && self.continuation(self.at).is_some())
    }

    /// Skips blanks and returns where the next argument starts; `None` at the end of the statement.
    #[inline]
    pub fn next_argument(&mut self) -> Option<usize> {
        self.skip_blanks();
        let byte = self.peek();
        (!is_line_end(byte) && byte != b'#').then_some(self.at)
    }

    pub fn token(&mut self) -> &'a [u8] {
        let start = self.at;
        while !self.at_token_end() {
            self.at += 1;
        }
        &self.text[start..self.at]
    }

    #[inline]
    pub fn skip_statement(&mut self) {
        match self.peek() {
            b'\n' => self.at += 1,
            _ => self.skip_rest(),
        }
        // Past the end there are line ends, but no next statement.
        self.at = self.at.min(self.text.len());
    }

    fn skip_rest(&mut self) {
        loop {
            let Some(step) = memchr3(b'\n', b'\r', b'#', &self.text[self.at..]) else {
                self.at = self.text.len();
                return;
            };
            let end = self.at + step;
            if self.text[end] == b'#' {
                self.at = memchr2(b'\n', b'\r', &self.text[end..]).map_or(self.text.len(), |step| end + step);
                return self.skip_line_end();
            }
            let continued = continues(&self.text[self.at..end]);
            self.at = end;
            self.skip_line_end();
            if !continued {
                return;
            }
        }
    }

    pub fn skip_line_end(&mut self) {
        self.at += line_end_length(&self.text[self.at..]);
    }

    /// Takes the rest of the statement as a name. Real names have blanks and `#` inside; blanks around it are not part of it.
    pub fn name(&mut self) -> Range<usize> {
        self.skip_blanks();
        let start = self.at;
        loop {
            self.at += memchr2(b'\n', b'\r', &self.text[self.at..]).unwrap_or(self.text.len() - self.at);
            let line = &self.text[start..self.at];
            if self.is_done() || !continues(line) {
                return start..start + line.trim_ascii_end().len();
            }
            self.skip_line_end();
        }
    }

    /// Reads `v`, `v/vt`, `v//vn` or `v/vt/vn` (a number after a slash may be missing); `None` if there is something else.
    #[inline]
    pub fn corner(&mut self) -> Option<CornerSpelling> {
        let vertex = self.index()?;
        let (mut uv, mut normal) = (None, None);
        if self.peek() == b'/' {
            self.at += 1;
            uv = self.index();
            if self.peek() == b'/' {
                self.at += 1;
                normal = self.index();
            }
        }
        self.at_token_end().then_some(CornerSpelling { vertex, uv, normal })
    }

    #[inline]
    pub fn index(&mut self) -> Option<i64> {
        let (value, length) = integer_prefix(&self.text[self.at..])?;
        self.at += length;
        Some(value)
    }
}

/// Whether a line, given without its end, continues on the next.
pub(super) fn continues(line: &[u8]) -> bool {
    line.iter().rev().find(|&&byte| !is_blank(byte)) == Some(&b'\\')
}

/// A name as text: UTF-8 if it is, else Latin-1; continued lines are joined by a blank.
pub(super) fn name_text(name: &[u8]) -> String {
    let text = match std::str::from_utf8(name) {
        Ok(text) => text.to_owned(),
        Err(_) => name.iter().map(|&byte| byte as char).collect(),
    };
    if !text.contains(['\n', '\r']) {
        return text;
    }
    let lines: Vec<&str> =
        text.split(['\n', '\r']).map(|line| line.trim_end().trim_end_matches('\\').trim()).collect();
    lines.join(" ")
}

/// Whether the control points of a free-form surface have the form v/vt/vn.
pub(super) fn refers_to_normals(cursor: &mut Cursor<'_>) -> bool {
    while cursor.next_argument().is_some() {
        if cursor.token().iter().filter(|&&byte| byte == b'/').count() == 2 {
            return true;
        }
    }
    false
}

/// A count as a 32-bit number. One statement can be as long as the file, so the length of a piece does not bound it.
pub(super) fn checked_end(total: usize, offset: usize) -> Result<u32, ReadError> {
    u32::try_from(total).map_err(|_| too_many("corners", total, offset))
}

pub(super) fn too_many(what: &str, count: usize, offset: usize) -> ReadError {
    let found = format!("{count} {what}, more than 32-bit indices can count");
    at_byte(Problem::Limit, offset, found, "split the file")
}

/// Reads the next corner of a face, or vertex of a line or of points; `None` at the end of the statement.
#[inline]
pub(super) fn next_corner(cursor: &mut Cursor<'_>) -> Result<Option<CornerSpelling>, ReadError> {
    let Some(at) = cursor.next_argument() else { return Ok(None) };
    match cursor.corner() {
        Some(corner) if corner.vertex != 0 => Ok(Some(corner)),
        corner => Err(bad_corner(cursor, at, corner.is_some())),
    }
}

#[cold]
fn bad_corner(cursor: &mut Cursor<'_>, at: usize, is_zero: bool) -> ReadError {
    if is_zero {
        let advice = "correct the index: it counts from 1, or back from -1";
        return at_byte(Problem::Range, at, "index 0 is not valid in OBJ", advice);
    }
    cursor.at = at;
    let found = format!("`{}` is not a vertex reference", shown(cursor.token()));
    at_byte(Problem::Syntax, at, found, "write v, v/vt, v//vn or v/vt/vn with integers")
}

#[inline]
pub(super) fn three_numbers(cursor: &mut Cursor<'_>, what: &'static str) -> Result<DVec3, ReadError> {
    let mut values = [0.0; 3];
    for (count, value) in values.iter_mut().enumerate() {
        if cursor.next_argument().is_none() {
            return Err(too_few(cursor, what, count, "3 are needed"));
        }
        *value = number(cursor)?;
    }
    Ok(DVec3::from_array(values))
}

#[inline]
pub(super) fn number(cursor: &mut Cursor<'_>) -> Result<f64, ReadError> {
    let start = cursor.at;
    if let Some((value, length)) = float_prefix(&cursor.text[start..]) {
        cursor.at += length;
        if cursor.at_token_end() {
            return Ok(value);
        }
    }
    unusual_number(cursor, start)
}

#[cold]
fn unusual_number(cursor: &mut Cursor<'_>, start: usize) -> Result<f64, ReadError> {
    cursor.at = start;
    let token = cursor.token();
    float(token).ok_or_else(|| {
        let advice = match token {
            [.., b','] => "separate numbers by blanks only",
            _ if token.contains(&b',') => "write decimals with a point",
            _ if token.contains(&b'd') || token.contains(&b'D') => "write exponents with an e",
            _ => "correct it, or remove the line",
        };
        at_byte(Problem::Syntax, start, format!("`{}` is not a number", shown(token)), advice)
    })
}

#[cold]
pub(super) fn too_few(cursor: &Cursor<'_>, what: &str, count: usize, needed: &str) -> ReadError {
    let found = format!("{what} has {}, but {needed}", counted(count, "number", "numbers"));
    let advice = "complete or remove the line; the file may be cut off";
    at_byte(Problem::Syntax, cursor.at, found, advice)
}
