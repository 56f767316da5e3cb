//! The words of ascii STL.

use std::ops::Range;

/// The words of a text; comments are skipped.
pub(super) struct Words<'a> {
    text: &'a [u8],
    /// Where the next word is looked for.
    pub at: usize,
}

impl<'a> Words<'a> {
    pub fn new(text: &'a [u8]) -> Self {
        let at = if text.starts_with(b"\xef\xbb\xbf") { 3 } else { 0 };
        Self { text, at }
    }

    /// The rest of the line, which is passed.
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
            let blanks = self.text[self.at..].iter().position(|byte| !is_blank(*byte));
            self.at += blanks.unwrap_or(self.text.len() - self.at);
            match self.text.get(self.at)? {
                b'#' => drop(self.rest_of_line()),
                _ => break,
            }
        }
        let start = self.at;
        let length = self.text[start..].iter().position(|byte| is_blank(*byte));
        self.at = length.map_or(self.text.len(), |length| start + length);
        Some(start..self.at)
    }
}

/// Blanks and line ends.
pub(super) fn is_blank(byte: u8) -> bool {
    matches!(byte, b' ' | b'\t'..=b'\r')
}
