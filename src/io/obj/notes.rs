//! The notes on a file, each once, with a count and the first places, and where bad references are.

use super::cursor::Cursor;
use super::statements::{Keyword, statements};
use crate::io::error::{NoteKind, RepeatedNotes};
use crate::io::text::{at_byte, line_places, shown};
use crate::io::{Note, Problem, ReadError, Severity};

/// In the text of a note: the word of the file that it is about.
const WORD: &str = "{word}";

pub(super) const SHORT_FACE: NoteKind = NoteKind::warning(0, "a face with fewer than 3 corners was skipped");
pub(super) const SHORT_LINE: NoteKind = NoteKind::warning(1, "a line with fewer than 2 vertices was skipped");
pub(super) const UNKNOWN: NoteKind = NoteKind::warning(2, "the unknown statement `{word}` was ignored");
pub(super) const FREE_FORM: NoteKind =
    NoteKind::warning(3, "the statement `{word}` of free-form curves and surfaces was ignored");
pub(super) const WEIGHT: NoteKind = NoteKind(
    4,
    Severity::Note,
    "a vertex has a fourth number (a weight for rational curves), which was ignored",
);
pub(super) const EXTRA_NUMBERS: NoteKind =
    NoteKind::warning(5, "a vertex has numbers after its position that are not a colour; they were ignored");
pub(super) const UV_OUT_OF_RANGE: NoteKind =
    NoteKind::warning(6, "a corner refers to a texture coordinate that does not exist; the corner has none");
pub(super) const NORMAL_OUT_OF_RANGE: NoteKind =
    NoteKind::warning(7, "a corner refers to a normal that does not exist; the corner has none");
pub(super) const UV_NOT_FINITE: NoteKind =
    NoteKind::warning(8, "a texture coordinate is not finite; its corners have none");
pub(super) const SMOOTHING_NAME: NoteKind = NoteKind::warning(
    9,
    "`{word}` is not a number of a smoothing group (0 to 4294967294); it was read as the name of one",
);

/// The notes in order of their first places.
pub(super) fn notes(found: &RepeatedNotes, text: &[u8]) -> Vec<Note> {
    let mut notes: Vec<(usize, Note)> = found.notes(|offsets| line_places(text, offsets)).collect();
    notes.sort_by_key(|&(first, _)| first);
    let with_word = |(first, note): (usize, Note)| {
        let mut cursor = Cursor::new(text, first);
        cursor.skip_blanks();
        Note { text: note.text.replace(WORD, &shown(cursor.token())), ..note }
    };
    notes.into_iter().map(with_word).collect()
}

pub(super) struct BadReference {
    pub offset: usize,
    spelled: i64,
    defined_before: usize,
}

/// The first references of faces, lines and points to what statements of `target` define: vertices, texture coordinates or
/// normals, if the whole file does not define so many; at most `most`.
pub(super) fn bad_references(text: &[u8], total: usize, target: Keyword, most: usize) -> Vec<BadReference> {
    let (mut before, mut found) = (0, Vec::new());
    for statement in statements(text) {
        match statement.keyword {
            keyword if keyword == target => before += 1,
            // Only faces keep texture coordinates and normals.
            Keyword::Line | Keyword::Point if target != Keyword::Vertex => {}
            Keyword::Face | Keyword::Line | Keyword::Point => {
                let known = found.len();
                let corners = add_bad_corners(text, statement.arguments, (before, total), target, &mut found);
                // Faces that are too short are skipped, whatever they refer to.
                if statement.keyword == Keyword::Face && corners < 3 {
                    found.truncate(known);
                }
                if found.len() >= most {
                    found.truncate(most);
                    break;
                }
            }
            _ => {}
        }
    }
    found
}

/// Adds the bad references of one statement and returns how many corners it has.
fn add_bad_corners(
    text: &[u8],
    arguments: usize,
    (defined_before, total): (usize, usize),
    target: Keyword,
    found: &mut Vec<BadReference>,
) -> usize {
    let mut cursor = Cursor::new(text, arguments);
    let mut corners = 0;
    while let Some(offset) = cursor.next_argument() {
        let Some(corner) = cursor.corner() else { break };
        corners += 1;
        let spelled = match target {
            Keyword::TextureCoordinate => corner.uv,
            Keyword::Normal => corner.normal,
            _ => Some(corner.vertex),
        };
        let is_bad = |spelled: &i64| match *spelled {
            0 => true,
            forward @ 1.. => forward as u64 > total as u64,
            back => back.unsigned_abs() > defined_before as u64,
        };
        let bad = spelled.filter(is_bad).map(|spelled| BadReference { offset, spelled, defined_before });
        found.extend(bad);
    }
    corners
}

impl BadReference {
    pub fn into_error(self, total: usize) -> ReadError {
        let found = match self.spelled {
            back @ ..0 => format!(
                "vertex index -{} is out of range ({} before this line)",
                back.unsigned_abs(),
                self.defined_before
            ),
            index => format!("vertex index {index} is out of range (the file has {total})"),
        };
        let advice = "correct the index, or add the missing vertices; the file may be cut off";
        at_byte(Problem::Range, self.offset, found, advice)
    }
}

/// Where the arguments of the `number`-th statement with a keyword start, counted from 0.
pub(super) fn arguments_of(text: &[u8], keyword: Keyword, number: usize) -> Option<usize> {
    let mut found = statements(text).filter(|statement| statement.keyword == keyword);
    found.nth(number).map(|statement| statement.arguments)
}
