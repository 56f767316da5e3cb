//! Notes that a reader may have for many places of a file: each kind once, with a count and the first places.

use super::{Note, Place, Severity};
use std::collections::BTreeMap;

/// A kind of note: its rank among the kinds of its format, its severity and its text.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub(super) struct NoteKind(pub u8, pub Severity, pub &'static str);

/// How often each kind of note is due, and at which byte offsets first.
#[derive(Clone, Debug, Default)]
pub(super) struct RepeatedNotes(BTreeMap<NoteKind, Occurrences>);

#[derive(Clone, Debug, Default)]
struct Occurrences {
    count: u64,
    /// No more than a note lists.
    offsets: Vec<usize>,
}

impl RepeatedNotes {
    /// Adds one occurrence.
    pub fn add(&mut self, kind: NoteKind, offset: usize) {
        self.add_all(kind, 1, [offset]);
    }

    /// Adds `count` occurrences, some of which are at these offsets.
    pub fn add_all(&mut self, kind: NoteKind, count: u64, offsets: impl IntoIterator<Item = usize>) {
        let known = self.0.entry(kind).or_default();
        let room = (1 + Note::MOST_PLACES).saturating_sub(known.offsets.len());
        known.offsets.extend(offsets.into_iter().take(room));
        known.count += count;
    }

    /// Appends what was found further back in the file.
    pub fn append(&mut self, other: Self) {
        for (kind, found) in other.0 {
            self.add_all(kind, found.count, found.offsets);
        }
    }

    /// Whether there is any note of a kind.
    pub fn has(&self, kind: NoteKind) -> bool {
        self.0.contains_key(&kind)
    }

    /// The value, or zero and a note if it is not valid.
    pub fn valid_or_zero<T: Default>(
        &mut self,
        kind: NoteKind,
        offset: usize,
        is_valid: bool,
        value: T,
    ) -> T {
        if is_valid {
            return value;
        }
        self.add(kind, offset);
        T::default()
    }

    /// The notes by rank, each with its first offset; `places` converts ascending offsets.
    pub fn notes(&self, places: impl Fn(&[usize]) -> Vec<Place>) -> impl Iterator<Item = (usize, Note)> {
        self.0.iter().filter_map(move |(&NoteKind(_, severity, text), found)| {
            let mut offsets = found.offsets.clone();
            offsets.sort_unstable();
            let note = Note::for_all(severity, found.count, places(&offsets), text)?;
            Some((*offsets.first()?, note))
        })
    }
}
