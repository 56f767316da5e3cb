//! The notes on a file, each once, with a count and the first places.

use super::cursor::Cursor;
use crate::io::repeated_notes::{NoteKind, RepeatedNotes};
use crate::io::text::{line_places, shown};
use crate::io::{Note, Severity};

/// In the text of a note: the word of the file that it is about.
const WORD: &str = "{word}";

pub(super) const SHORT_FACE: NoteKind =
    NoteKind(0, Severity::Warning, "a face with fewer than 3 corners was skipped");
pub(super) const SHORT_LINE: NoteKind =
    NoteKind(1, Severity::Warning, "a line with fewer than 2 vertices was skipped");
pub(super) const UNKNOWN: NoteKind =
    NoteKind(2, Severity::Warning, "the unknown statement `{word}` was ignored");
pub(super) const FREE_FORM: NoteKind =
    NoteKind(3, Severity::Warning, "the statement `{word}` of free-form curves and surfaces was ignored");
pub(super) const WEIGHT: NoteKind = NoteKind(
    4,
    Severity::Note,
    "a vertex has a fourth number, a weight for rational curves, which was ignored",
);
pub(super) const EXTRA_NUMBERS: NoteKind = NoteKind(
    5,
    Severity::Warning,
    "a vertex has numbers behind its position that are no colour; they were ignored",
);
pub(super) const UV_OUT_OF_RANGE: NoteKind = NoteKind(
    6,
    Severity::Warning,
    "a corner refers to a texture coordinate that does not exist; it is treated as having none",
);
pub(super) const NORMAL_OUT_OF_RANGE: NoteKind = NoteKind(
    7,
    Severity::Warning,
    "a corner refers to a normal that does not exist; it is treated as having none",
);
pub(super) const UV_NOT_FINITE: NoteKind = NoteKind(
    8,
    Severity::Warning,
    "a texture coordinate is not finite; corners that use it are treated as having none",
);
pub(super) const SMOOTHING_NAME: NoteKind = NoteKind(
    9,
    Severity::Warning,
    "`{word}` is no number of a smoothing group (0 to 4294967294); it is treated as the name of a group of its own",
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
