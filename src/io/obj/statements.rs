//! Bytes to statements: keywords, statements in order, and the pieces that are parsed in parallel.

use super::cursor::{Cursor, continues};
use crate::io::text::without_byte_order_mark;
use memchr::memchr2;
use std::ops::Range;

/// Bytes that are parsed in one go. It does not depend on the number of threads, so the mesh does not either.
pub(super) const PIECE: usize = 1 << 20;

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
    /// Attributes for display, which do not affect geometry.
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

    #[inline]
    pub fn read(cursor: &mut Cursor<'_>) -> Self {
        // Nearly all lines of a large file are one of these two.
        if let Some(&[first, b' ']) = cursor.text.get(cursor.at..cursor.at + 2)
            && matches!(first, b'v' | b'f')
        {
            cursor.at += 2;
            return if first == b'v' { Keyword::Vertex } else { Keyword::Face };
        }
        cursor.skip_blanks();
        match cursor.token() {
            [] => Keyword::Blank,
            word => Keyword::of(word),
        }
    }
}

#[derive(Clone, Copy, Debug)]
pub(super) struct Statement {
    pub keyword: Keyword,
    pub start: usize,
    pub arguments: usize,
    pub end: usize,
}

fn text_start(text: &[u8]) -> usize {
    text.len() - without_byte_order_mark(text).len()
}

pub(super) fn statements(text: &[u8]) -> impl Iterator<Item = Statement> + '_ {
    statements_in(text, text_start(text)..text.len())
}

/// The statements of a range of a text, which begins and ends at line starts.
pub(super) fn statements_in(text: &[u8], range: Range<usize>) -> impl Iterator<Item = Statement> + '_ {
    let mut cursor = Cursor::new(&text[..range.end], range.start);
    std::iter::from_fn(move || {
        if cursor.is_done() {
            return None;
        }
        let start = cursor.at;
        let keyword = Keyword::read(&mut cursor);
        let arguments = cursor.at;
        if matches!(keyword, Keyword::Object | Keyword::Group | Keyword::Material | Keyword::Library) {
            // The `#` of a name starts no comment.
            cursor.name();
        }
        cursor.skip_statement();
        Some(Statement { keyword, start, arguments, end: cursor.at })
    })
}

/// The pieces of a text that are parsed on their own; each begins and ends at the start of a statement.
pub(super) fn pieces(text: &[u8]) -> Vec<Range<usize>> {
    let mut start = text_start(text);
    let mut pieces = Vec::with_capacity(text.len() / PIECE + 1);
    loop {
        let end = next_line_start(text, start.saturating_add(PIECE));
        pieces.push(start..end);
        if end == text.len() {
            return pieces;
        }
        start = end;
    }
}

/// The first offset at or after `at` where a statement's line starts, judged by line ends alone.
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
