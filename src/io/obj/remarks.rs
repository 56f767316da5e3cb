//! What was odd about a file: each kind once, with a count and the first places.

use super::lexer::{Cursor, shown};
use crate::io::tally::Tally;
use crate::io::text::lines_of;
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

/// How often each kind was met, and where at first.
#[derive(Clone, Debug, Default)]
pub(super) struct Remarks([Tally; KINDS.len()]);

impl Remarks {
    pub fn add(&mut self, remark: Remark, offset: usize) {
        self.0[remark as usize].add(offset);
    }

    pub fn add_all(&mut self, remark: Remark, count: u64, offsets: impl IntoIterator<Item = usize>) {
        self.0[remark as usize].add_all(count, offsets);
    }

    /// Appends the remarks on a piece of text behind this one's.
    pub fn append(&mut self, other: Remarks) {
        for (tally, other) in self.0.iter_mut().zip(other.0) {
            tally.append(other);
        }
    }

    /// The remarks as notes, in order of their first places.
    pub fn notes(&self, text: &[u8]) -> Vec<Note> {
        let mut met: Vec<_> = KINDS
            .into_iter()
            .zip(&self.0)
            .filter_map(|(kind, tally)| Some((tally.first()?, kind, tally)))
            .collect();
        met.sort_by_key(|&(at, kind, _)| (at, kind as usize));
        met.into_iter().filter_map(|(at, kind, tally)| note(text, at, kind, tally)).collect()
    }
}

fn note(text: &[u8], at: usize, kind: Remark, tally: &Tally) -> Option<Note> {
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
                "`{word}` is no number of a smoothing group (0 to 4294967294); it is treated as the name of a group of \
                 its own"
            ),
        ),
    };
    tally.note(severity, |offsets| lines_of(text, offsets).into_iter().map(Place::Line).collect(), what)
}
