//! The words of a text, and where its lines end.

use std::ops::Range;

pub fn is_blank(byte: u8) -> bool {
    matches!(byte, b' ' | b'\t'..=b'\r')
}

/// The first word at or after `at`, on whatever line.
pub fn next_word(text: &[u8], at: usize) -> Option<Range<usize>> {
    let rest = &text[at..];
    let start = at + rest.iter().position(|byte| !is_blank(*byte))?;
    let length = text[start..].iter().position(|byte| is_blank(*byte));
    Some(start..length.map_or(text.len(), |length| start + length))
}

/// The length of the line end that a text starts with: LF, CR LF or CR; 0 without one.
pub fn line_end_length(text: &[u8]) -> usize {
    match text {
        [b'\r', b'\n', ..] => 2,
        [b'\r' | b'\n', ..] => 1,
        _ => 0,
    }
}

/// The text without the byte order mark that some editors put in front of UTF-8.
pub fn without_byte_order_mark(text: &[u8]) -> &[u8] {
    text.strip_prefix(b"\xef\xbb\xbf").unwrap_or(text)
}

/// The words of a text with comments, which go from `#` to the end of the line.
pub struct Words<'a> {
    text: &'a [u8],
    /// Where the search for the next word starts.
    pub at: usize,
}

impl<'a> Words<'a> {
    pub fn new(text: &'a [u8]) -> Self {
        Self { text, at: text.len() - without_byte_order_mark(text).len() }
    }

    /// Moves to the end of the line and returns what was left of it.
    pub fn rest_of_line(&mut self) -> Range<usize> {
        let start = self.at;
        let rest = &self.text[start..];
        self.at += memchr::memchr2(b'\n', b'\r', rest).unwrap_or(rest.len());
        start..self.at
    }
}

impl Iterator for Words<'_> {
    type Item = Range<usize>;

    fn next(&mut self) -> Option<Range<usize>> {
        loop {
            let word = next_word(self.text, self.at);
            self.at = word.as_ref().map_or(self.text.len(), |word| word.end);
            let word = word?;
            if self.text[word.start] != b'#' {
                return Some(word);
            }
            self.at = word.start;
            self.rest_of_line();
        }
    }
}
