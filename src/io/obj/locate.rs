//! Where in the text something is that the reader did not keep a place of.
//!
//! Line numbers and spans are not stored while parsing: they would cost as much memory as the mesh. The few that a
//! message needs are found by reading the text again, which is only done once something is wrong.

use super::arguments::Fault;
use super::lexer::{Cursor, Keyword, statements};
use crate::io::Problem;

/// How many vertices, texture coordinates and normals a file defines.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct Counts {
    pub vertices: usize,
    pub uvs: usize,
    pub normals: usize,
}

/// What a corner refers to.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Target {
    Vertex,
    Uv,
    Normal,
}

/// A reference that leads nowhere.
pub(super) struct BadReference {
    pub offset: usize,
    spelled: i64,
    defined_before: usize,
}

/// The first reference of faces, lines and points to something that the whole file does not define.
pub(super) fn first_bad_reference(text: &[u8], total: Counts, target: Target) -> Option<BadReference> {
    let mut before = Counts::default();
    for statement in statements(text) {
        match statement.keyword {
            Keyword::Vertex => before.vertices += 1,
            Keyword::TextureCoordinate => before.uvs += 1,
            Keyword::Normal => before.normals += 1,
            Keyword::Face | Keyword::Line | Keyword::Point => {
                let is_face = statement.keyword == Keyword::Face;
                if let Some(bad) = bad_corner(text, statement.arguments, is_face, before, total, target) {
                    return Some(bad);
                }
            }
            _ => {}
        }
    }
    None
}

fn bad_corner(
    text: &[u8],
    arguments: usize,
    is_face: bool,
    before: Counts,
    total: Counts,
    target: Target,
) -> Option<BadReference> {
    let mut cursor = Cursor::new(text, arguments);
    let (mut bad, mut corners) = (None, 0);
    loop {
        cursor.skip_blanks();
        if cursor.at_statement_end() {
            break;
        }
        let offset = cursor.at;
        let corner = cursor.corner()?;
        corners += 1;
        let (spelled, defined_before, defined) = match target {
            Target::Vertex => (Some(corner.vertex), before.vertices, total.vertices),
            // Only faces keep these.
            Target::Uv => (corner.uv.filter(|_| is_face), before.uvs, total.uvs),
            Target::Normal => (corner.normal.filter(|_| is_face), before.normals, total.normals),
        };
        let is_bad = |spelled: &i64| match *spelled {
            0 => true,
            forward @ 1.. => forward as u64 > defined as u64,
            back => back.unsigned_abs() > defined_before as u64,
        };
        if bad.is_none() {
            bad = spelled.filter(is_bad).map(|spelled| BadReference { offset, spelled, defined_before });
        }
    }
    // Faces that are too short are skipped, whatever they refer to.
    bad.filter(|_| !is_face || corners >= 3)
}

impl BadReference {
    pub fn into_fault(self, total: Counts) -> Fault {
        let found = match self.spelled {
            back @ ..0 => format!(
                "a reference {} vertices back, but only {} are defined before it",
                back.unsigned_abs(),
                self.defined_before
            ),
            index => format!("a reference to vertex {index}, but the file defines {}", total.vertices),
        };
        Fault {
            offset: self.offset,
            problem: Problem::Range,
            found,
            advice: "correct the index, or add the missing vertices; perhaps the file was cut off or put together from parts",
        }
    }
}

/// Where the arguments are of the statement with this keyword that has `number` such in front of it.
pub(super) fn arguments_of(text: &[u8], keyword: Keyword, number: usize) -> Option<usize> {
    statements(text)
        .filter(|statement| statement.keyword == keyword)
        .nth(number)
        .map(|statement| statement.arguments)
}
