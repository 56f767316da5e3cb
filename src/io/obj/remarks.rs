//! What was odd about a file: each kind once, with a count and the first place.

use super::lexer::{Cursor, line_and_column, shown};
use crate::io::{Note, Place, Severity};

/// Something odd that does not stop the reader.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Remark {
    ShortFace,
    ShortLine,
    Unknown,
    FreeForm,
    Weight,
    ExtraNumbers,
    UvOutOfRange,
    NormalOutOfRange,
    UvNotFinite,
    OddSmoothing,
}

const KINDS: [Remark; 10] = [
    Remark::ShortFace,
    Remark::ShortLine,
    Remark::Unknown,
    Remark::FreeForm,
    Remark::Weight,
    Remark::ExtraNumbers,
    Remark::UvOutOfRange,
    Remark::NormalOutOfRange,
    Remark::UvNotFinite,
    Remark::OddSmoothing,
];

/// How often each kind was met and the byte offset of the first.
#[derive(Clone, Debug, Default)]
pub(super) struct Remarks([Option<(u64, usize)>; KINDS.len()]);

impl Remarks {
    pub fn add(&mut self, remark: Remark, offset: usize) {
        self.add_many(remark, 1, offset);
    }

    pub fn add_many(&mut self, remark: Remark, count: u64, offset: usize) {
        let entry = self.0[remark as usize].get_or_insert((0, offset));
        entry.0 += count;
        entry.1 = entry.1.min(offset);
    }

    pub fn merge(&mut self, other: &Remarks) {
        for (&kind, entry) in KINDS.iter().zip(other.0) {
            if let Some((count, offset)) = entry {
                self.add_many(kind, count, offset);
            }
        }
    }

    /// The remarks as notes, in order of their first places.
    pub fn notes(&self, text: &[u8]) -> Vec<Note> {
        let mut met: Vec<_> = KINDS
            .into_iter()
            .filter_map(|kind| self.0[kind as usize].map(|(count, at)| (at, kind, count)))
            .collect();
        met.sort_by_key(|&(at, kind, _)| (at, kind as usize));
        met.into_iter().map(|(at, kind, count)| note(text, at, kind, count)).collect()
    }
}

fn note(text: &[u8], at: usize, kind: Remark, count: u64) -> Note {
    let mut cursor = Cursor::new(text, at);
    cursor.skip_blanks();
    let word = shown(cursor.token());
    let (severity, what) = match kind {
        Remark::ShortFace => (Severity::Warning, "a face with fewer than 3 corners was skipped".to_owned()),
        Remark::ShortLine => (Severity::Warning, "a line with fewer than 2 vertices was skipped".to_owned()),
        Remark::Unknown => (Severity::Warning, format!("the unknown statement `{word}` was ignored")),
        Remark::FreeForm => (
            Severity::Warning,
            format!("the statement `{word}` of free-form curves and surfaces was ignored"),
        ),
        Remark::Weight => (
            Severity::Note,
            "a vertex has a fourth number, a weight for rational curves, which was ignored".to_owned(),
        ),
        Remark::ExtraNumbers => (
            Severity::Warning,
            "a vertex has numbers behind its position that are no colour; they were ignored".to_owned(),
        ),
        Remark::UvOutOfRange => (
            Severity::Warning,
            "a corner refers to a texture coordinate that does not exist; it is treated as having none"
                .to_owned(),
        ),
        Remark::NormalOutOfRange => (
            Severity::Warning,
            "a corner refers to a normal that does not exist; it is treated as having none".to_owned(),
        ),
        Remark::UvNotFinite => (
            Severity::Warning,
            "a texture coordinate is not finite; corners that use it are treated as having none".to_owned(),
        ),
        Remark::OddSmoothing => (
            Severity::Warning,
            format!(
                "`{word}` is not a smoothing group number; it is treated as the name of a group of its own"
            ),
        ),
    };
    let more = if count > 1 { format!(" (and {} more like it)", count - 1) } else { String::new() };
    Note { severity, place: Place::Line(line_and_column(text, at).0), text: what + &more }
}
