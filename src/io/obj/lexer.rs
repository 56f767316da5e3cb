//! Bytes to statements and tokens.
//!
//! OBJ is read as bytes: names and comments of real files are in any encoding. A statement is one line; a
//! backslash at its end continues it on the next. Comments start at `#` and end with their line: one that ends
//! in a backslash (a Windows path, say) does not swallow the statement after it. Lines end with LF, CR LF or CR.

use super::number;
pub(super) use crate::io::text::{line_and_column, shown};
use memchr::{memchr2, memchr3};
use std::ops::Range;

/// What a statement is about.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Keyword {
    /// Nothing: a blank line, a comment, the end.
    Blank,
    Vertex,
    TextureCoordinate,
    Normal,
    /// `f`, and `fo` of the oldest files.
    Face,
    Line,
    Point,
    Smoothing,
    Object,
    Group,
    Material,
    Library,
    /// A free-form surface, which may refer to normals by number.
    Surface,
    /// The rest of free-form geometry.
    FreeForm,
    /// Attributes for display that say nothing about geometry.
    Display,
    Unknown,
}

impl Keyword {
    fn of(word: &[u8]) -> Self {
        match word {
            b"v" => Keyword::Vertex,
            b"vt" => Keyword::TextureCoordinate,
            b"vn" => Keyword::Normal,
            b"f" | b"fo" => Keyword::Face,
            b"l" => Keyword::Line,
            b"p" => Keyword::Point,
            b"s" => Keyword::Smoothing,
            b"o" => Keyword::Object,
            b"g" => Keyword::Group,
            b"usemtl" => Keyword::Material,
            b"mtllib" => Keyword::Library,
            b"surf" => Keyword::Surface,
            b"vp" | b"cstype" | b"deg" | b"bmat" | b"step" | b"curv" | b"curv2" | b"parm" | b"trim"
            | b"hole" | b"scrv" | b"sp" | b"end" | b"con" | b"mg" | b"bzp" | b"bsp" | b"cdc" | b"cdp"
            | b"res" => Keyword::FreeForm,
            b"bevel" | b"c_interp" | b"d_interp" | b"lod" | b"shadow_obj" | b"trace_obj" | b"ctech"
            | b"stech" | b"maplib" | b"usemap" => Keyword::Display,
            _ => Keyword::Unknown,
        }
    }
}

/// One corner of a face as its statement spells it: numbers from 1, or negative ones that count back.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct CornerSpelling {
    pub vertex: i64,
    pub uv: Option<i64>,
    pub normal: Option<i64>,
}

/// A position in the text. Past the end there is nothing but line ends.
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

    /// Skips blanks and continued line ends.
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

    /// Where the text goes on if the backslash at `at` continues the line. Blanks behind it are forgiven.
    fn continuation(&self, at: usize) -> Option<usize> {
        let blanks = self.text[at + 1..].iter().take_while(|&&byte| is_blank(byte)).count();
        match self.text[at + 1 + blanks..] {
            [b'\r', b'\n', ..] => Some(at + blanks + 3),
            [b'\r' | b'\n', ..] => Some(at + blanks + 2),
            _ => None,
        }
    }

    /// Whether, blanks skipped, nothing more of the statement follows.
    #[inline]
    pub fn at_statement_end(&self) -> bool {
        let byte = self.peek();
        is_line_end(byte) || byte == b'#'
    }

    /// Whether a token may end here.
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

    /// Reads the keyword of the statement that starts here.
    #[inline]
    pub fn keyword(&mut self) -> Keyword {
        // Nearly all lines of a large file are one of these two.
        if let Some(&[first, b' ']) = self.text.get(self.at..self.at + 2)
            && matches!(first, b'v' | b'f')
        {
            self.at += 2;
            return if first == b'v' { Keyword::Vertex } else { Keyword::Face };
        }
        self.skip_blanks();
        match self.token() {
            [] => Keyword::Blank,
            word => Keyword::of(word),
        }
    }

    /// Takes the token that starts here; empty at the end of a statement.
    pub fn token(&mut self) -> &'a [u8] {
        let start = self.at;
        while !self.at_token_end() {
            self.at += 1;
        }
        &self.text[start..self.at]
    }

    /// Goes to the next statement.
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

    fn skip_line_end(&mut self) {
        if self.text[self.at..].starts_with(b"\r\n") {
            self.at += 2;
        } else if !self.is_done() {
            self.at += 1;
        }
    }

    /// Takes the rest of the statement as a name: whole, with blanks and `#` inside, because names of real files
    /// have both. Blanks around it are left out.
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

    /// Reads a corner, `v`, `v/vt`, `v//vn` or `v/vt/vn` (a number after a slash may be missing); `None` if there
    /// is something else, with the cursor wherever it got to.
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

    /// Reads an index; the cursor stays if there is none.
    #[inline]
    pub fn index(&mut self) -> Option<i64> {
        let (value, length) = number::index(&self.text[self.at..])?;
        self.at += length;
        Some(value)
    }
}

/// Whether a line, given without its end, goes on behind it.
fn continues(line: &[u8]) -> bool {
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

/// A statement of the text.
#[derive(Clone, Copy, Debug)]
pub(super) struct Statement {
    pub keyword: Keyword,
    /// Where its line starts.
    pub start: usize,
    /// Where its arguments start.
    pub arguments: usize,
    /// Where the next statement's line starts.
    pub end: usize,
}

/// Where the first statement starts: behind the byte order mark that some editors put in front of UTF-8.
pub(super) fn text_start(text: &[u8]) -> usize {
    const BYTE_ORDER_MARK: &[u8] = b"\xef\xbb\xbf";
    if text.starts_with(BYTE_ORDER_MARK) { BYTE_ORDER_MARK.len() } else { 0 }
}

/// The statements of a text, in order.
pub(super) fn statements(text: &[u8]) -> impl Iterator<Item = Statement> + '_ {
    statements_in(text, text_start(text)..text.len())
}

/// The statements that begin in a part of a text, which begins and ends at line starts.
pub(super) fn statements_in(text: &[u8], range: Range<usize>) -> impl Iterator<Item = Statement> + '_ {
    let mut cursor = Cursor::new(&text[..range.end], range.start);
    std::iter::from_fn(move || {
        if cursor.is_done() {
            return None;
        }
        let start = cursor.at;
        let keyword = cursor.keyword();
        let arguments = cursor.at;
        if matches!(keyword, Keyword::Object | Keyword::Group | Keyword::Material | Keyword::Library) {
            // The `#` of a name starts no comment.
            cursor.name();
        }
        cursor.skip_statement();
        Some(Statement { keyword, start, arguments, end: cursor.at })
    })
}

/// The first place at or after `at` where a statement's line starts, judged by line ends alone.
pub(super) fn next_line_start(text: &[u8], at: usize) -> usize {
    let mut cursor = Cursor::new(text, at.min(text.len()));
    loop {
        let Some(step) = memchr2(b'\n', b'\r', &text[cursor.at..]) else { return text.len() };
        cursor.at += step;
        // `at` may have fallen behind the backslash, or between CR and LF: look back as far as it takes.
        let line = &text[..cursor.at];
        let line = if text[cursor.at] == b'\n' { line.strip_suffix(b"\r").unwrap_or(line) } else { line };
        let continued = continues(line);
        cursor.skip_line_end();
        if !continued {
            return cursor.at;
        }
    }
}
