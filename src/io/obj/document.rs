//! An OBJ file as it was read, and the line numbers of its faces and vertices.

use super::cursor::Cursor;
use super::mtl::Materials;
use super::statements::{Keyword, Statement, pieces, statements_in};
use crate::io::FileMaterial;
use crate::io::text::line_and_column;
use crate::num::parallel;
use std::ops::Range;
use std::sync::OnceLock;

/// An OBJ file as it was read.
#[derive(Clone, Debug)]
pub struct ObjDocument {
    /// `None` after [`free_text`](Self::free_text).
    pub(super) text: Option<Vec<u8>>,
    pub(super) lines: OnceLock<ObjLines>,
    /// Where new normals go, and how many `vn` lines are before that.
    pub(super) insertion: (usize, usize),
    /// Whether a free-form surface refers to normals by number, so that these must not change.
    pub(super) surface_normals: bool,
    pub(super) libraries: Materials,
}

impl ObjDocument {
    pub(in crate::io) fn source(&self) -> Option<&[u8]> {
        self.text.as_deref()
    }

    /// The lines of faces and vertices. The first call parses the text again.
    pub fn lines(&self) -> &ObjLines {
        self.lines.get_or_init(|| ObjLines::new(self.source().unwrap_or_default()))
    }

    /// Frees the text and keeps its line numbers.
    pub(in crate::io) fn forget_text(&mut self) {
        self.lines();
        self.free_text();
    }

    /// Frees the text; line numbers that were not asked for before are lost.
    pub(in crate::io) fn free_text(&mut self) {
        self.text = None;
    }

    pub(in crate::io) fn materials(&self) -> &[FileMaterial] {
        &self.libraries.materials
    }
}

/// The lines of all faces and vertices of an OBJ file, from 1.
///
/// Stored as runs: in most files the lines of faces follow each other, and so do those of vertices. Each run takes 16 bytes.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct ObjLines {
    faces: Runs,
    vertices: Runs,
}

impl ObjLines {
    /// Of a text, as its reader counts: faces of fewer than three corners are skipped.
    pub(super) fn new(text: &[u8]) -> Self {
        let pieces = parallel::map_owned(pieces(text), |piece| Self::of_piece(text, piece));
        let (mut lines, mut before) = (Self::default(), 0);
        for (piece, count) in pieces {
            lines.faces.append(&piece.faces, before);
            lines.vertices.append(&piece.vertices, before);
            before += count;
        }
        lines
    }

    /// Of a piece of the text, counted from 1 at its beginning, and how many lines the piece has.
    fn of_piece(text: &[u8], range: Range<usize>) -> (Self, u64) {
        let (mut lines, mut line, mut at) = (Self::default(), 1, range.start);
        // Between a carriage return and its line feed nothing begins.
        let lines_until = |at: usize, end: usize| line_and_column(&text[at..end], end - at).0 - 1;
        let has_three_corners = |statement: &Statement| {
            let mut cursor = Cursor::new(text, statement.arguments);
            (0..3).all(|_| cursor.next_argument().is_some() && cursor.corner().is_some())
        };
        for statement in statements_in(text, range.clone()) {
            let runs = match statement.keyword {
                Keyword::Vertex => &mut lines.vertices,
                Keyword::Face if has_three_corners(&statement) => &mut lines.faces,
                _ => continue,
            };
            line += lines_until(at, statement.start);
            at = statement.start;
            runs.push(line);
        }
        (lines, line - 1 + lines_until(at, range.end))
    }

    /// The line of a face of the mesh; `None` if there is no such face.
    pub fn of_face(&self, face: u32) -> Option<u64> {
        self.faces.get(face)
    }

    /// The line of a vertex of the mesh; `None` if there is no such vertex.
    pub fn of_vertex(&self, vertex: u32) -> Option<u64> {
        self.vertices.get(vertex)
    }
}

/// The lines of items that are numbered in file order.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
struct Runs {
    count: u32,
    /// The first number of each run, and its line; those behind it are on the lines behind that.
    starts: Vec<(u32, u64)>,
}

impl Runs {
    fn push(&mut self, line: u64) {
        self.start(self.count, line);
        self.count += 1;
    }

    /// Begins a run, unless the line continues the last one.
    fn start(&mut self, first: u32, line: u64) {
        let goes_on = |&(known, at): &(u32, u64)| at + u64::from(first - known) == line;
        if !self.starts.last().is_some_and(goes_on) {
            self.starts.push((first, line));
        }
    }

    /// Those of the next piece, which has so many lines before it.
    fn append(&mut self, other: &Self, lines_before: u64) {
        for &(first, line) in &other.starts {
            self.start(self.count + first, lines_before + line);
        }
        self.count += other.count;
    }

    fn get(&self, number: u32) -> Option<u64> {
        let run = self.starts.partition_point(|&(first, _)| first <= number).checked_sub(1)?;
        let (first, line) = self.starts[run];
        (number < self.count).then(|| line + u64::from(number - first))
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::io::obj::statements::PIECE;

    #[test]
    fn lines_are_those_that_statements_begin_on() {
        let text = b"# a\nv 0 0 0\nv 1 \\\n0 0\r\nv 0 1 0\rv 1 1 0\n\nf 1 2 3\nf 1 2\nf 1 2 4\nf 2 \\\r\n3 4\nvn 0 0 1\nf 1 2 3\n";
        let lines = ObjLines::new(text);
        let vertices: Vec<_> = (0..5).map(|vertex| lines.of_vertex(vertex)).collect();
        assert_eq!(vertices, [Some(2), Some(3), Some(5), Some(6), None]);
        let faces: Vec<_> = (0..5).map(|face| lines.of_face(face)).collect();
        assert_eq!(faces, [Some(8), Some(10), Some(11), Some(14), None]);
        assert_eq!(lines.faces.starts.len(), 3, "two of the four follow each other");
        assert_eq!(ObjLines::new(b"").of_face(0), None);
    }

    /// Pieces are parsed separately, and lines of the second continue those of the first.
    #[test]
    fn lines_go_on_over_pieces() {
        let mut text = b"v 0 0 0\nv 1 0 0\nv 0 1 0\n".to_vec();
        let face = b"f 1 2 3\n";
        let count = 2 * PIECE / face.len() + 7;
        text.extend(face.repeat(count));
        text.extend(b"#\nf 1 2 3");
        assert!(pieces(&text).len() > 2);
        let lines = ObjLines::new(&text);
        for number in [0, 1, PIECE / face.len(), count - 1] {
            assert_eq!(lines.of_face(number as u32), Some(4 + number as u64));
        }
        assert_eq!(lines.of_face(count as u32), Some(5 + count as u64));
        assert_eq!(lines.faces.starts.len(), 2);
    }
}
