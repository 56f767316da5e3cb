//! Bytes that are copied with changes.

use std::ops::Range;

/// A copy of a text, made from front to back.
pub struct Copier<'a> {
    pub text: &'a [u8],
    pub out: Vec<u8>,
    /// The text before this offset is copied or skipped.
    pub at: usize,
}

impl<'a> Copier<'a> {
    /// A copy that is probably longer than the text by one part in `growth`.
    pub fn new(text: &'a [u8], growth: usize) -> Self {
        Self { text, out: Vec::with_capacity(text.len() + text.len() / growth), at: 0 }
    }

    pub fn copy_to(&mut self, end: usize) {
        self.out.extend_from_slice(&self.text[self.at..end]);
        self.at = end;
    }

    /// Copies up to a piece and skips the piece, so that what is written next replaces it.
    pub fn skip(&mut self, piece: Range<usize>) {
        self.copy_to(piece.start);
        self.at = piece.end;
    }
}

/// Replacements of pieces of a text, in any order.
#[derive(Default)]
pub struct Changes {
    /// Each piece in the order of their offsets, and its replacement as a piece of `new`.
    pieces: Vec<(Range<usize>, Range<usize>)>,
    new: Vec<u8>,
}

impl Changes {
    pub fn clear(&mut self) {
        self.pieces.clear();
        self.new.clear();
    }

    /// Replaces a piece, which may be empty, by what `write` appends. Several at one offset keep their order.
    pub fn replace(&mut self, piece: Range<usize>, write: impl FnOnce(&mut Vec<u8>)) {
        let start = self.new.len();
        write(&mut self.new);
        let place = self.pieces.partition_point(|(other, _)| other.start <= piece.start);
        self.pieces.insert(place, (piece, start..self.new.len()));
    }

    /// Appends the bytes of `span` to `out`, changed.
    pub fn copy(&self, bytes: &[u8], span: Range<usize>, out: &mut Vec<u8>) {
        let mut at = span.start;
        for (piece, new) in &self.pieces {
            out.extend_from_slice(&bytes[at..piece.start]);
            out.extend_from_slice(&self.new[new.clone()]);
            at = piece.end;
        }
        out.extend_from_slice(&bytes[at..span.end]);
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn pieces_are_replaced_in_order_of_place() {
        let mut changes = Changes::default();
        changes.replace(4..5, |out| out.extend(b"-four-"));
        changes.replace(1..1, |out| out.extend(b"<"));
        changes.replace(1..1, |out| out.extend(b">"));
        changes.replace(2..4, |_| {});
        let mut out = Vec::new();
        changes.copy(b"0123456789", 1..7, &mut out);
        assert_eq!(out, b"<>1-four-56");
    }
}
