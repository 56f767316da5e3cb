//! Errors and notes, with the places that they are about.

use super::Format;
use std::collections::BTreeMap;
use std::fmt;

/// A place in an input file.
#[derive(Clone, Debug, Default, PartialEq, Eq, serde::Serialize)]
#[serde(rename_all = "lowercase")]
pub enum Place {
    /// The file as a whole.
    #[default]
    File,
    /// A line, counted from 1.
    Line(u64),
    /// A byte offset, counted from 0.
    Byte(u64),
    /// A JSON pointer into a glTF document, such as `/accessors/3`.
    Json(String),
}

impl Place {
    fn is_file(&self) -> bool {
        *self == Place::File
    }

    /// What a message about it begins with: nothing for the whole file, nor for the root of a document.
    fn prefix(&self) -> String {
        let place = self.to_string();
        if place.is_empty() { place } else { format!("{place}: ") }
    }
}

fn is_zero(count: &u64) -> bool {
    *count == 0
}

impl fmt::Display for Place {
    fn fmt(&self, out: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Place::File => Ok(()),
            Place::Line(line) => write!(out, "line {line}"),
            Place::Byte(offset) => write!(out, "byte {offset}"),
            Place::Json(pointer) => out.write_str(pointer),
        }
    }
}

/// What kind of fault stopped a reader.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, serde::Serialize)]
pub enum Problem {
    /// The file could not be read.
    Io,
    /// The bytes are not of the format.
    Syntax,
    /// The file ends too early.
    Truncated,
    /// An index, count or offset that points outside.
    Range,
    /// A position that is infinite or not a number.
    NonFinite,
    /// Right, but beyond a limit of this program.
    Limit,
    /// A feature that this program does not handle, named in the message.
    Unsupported,
    /// A file that is needed and not there, or that may not be read.
    Companion,
}

/// Why a file could not be read: where, what was found, and what to do about it.
///
/// It prints as `line 12: a face refers to vertex 9, but 8 are defined; fix the index or …`. The caller puts the
/// file's name in front.
#[derive(Clone, Debug, PartialEq, Eq, serde::Serialize)]
pub struct ReadError {
    /// The kind of fault.
    pub problem: Problem,
    /// Where it is.
    #[serde(skip_serializing_if = "Place::is_file")]
    pub place: Place,
    /// What was found.
    pub found: String,
    /// What to do.
    pub advice: String,
}

impl ReadError {
    /// An error at a place, with what was found and what to do.
    pub fn new(problem: Problem, place: Place, found: impl Into<String>, advice: impl Into<String>) -> Self {
        Self { problem, place, found: found.into(), advice: advice.into() }
    }
}

impl fmt::Display for ReadError {
    fn fmt(&self, out: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(out, "{}{}", self.place.prefix(), self.found)?;
        if self.advice.is_empty() { Ok(()) } else { write!(out, "; {}", self.advice) }
    }
}

impl std::error::Error for ReadError {}

/// How much a note matters.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash, serde::Serialize)]
#[serde(rename_all = "lowercase")]
pub enum Severity {
    /// For information.
    Note,
    /// Something in the input was repaired or skipped, or something could not be kept.
    Warning,
}

/// A remark about an input or an output.
#[derive(Clone, Debug, PartialEq, Eq, serde::Serialize)]
pub struct Note {
    /// How much it matters.
    pub severity: Severity,
    /// Where.
    #[serde(skip_serializing_if = "Place::is_file")]
    pub place: Place,
    /// What. The next step may follow on a line that starts with `help: `; JSON has both on one line.
    #[serde(serialize_with = "in_one_line")]
    pub text: String,
    /// How many more like it there are.
    #[serde(skip_serializing_if = "is_zero")]
    pub more: u64,
    /// Where the first of these are, at most [`Note::MOST_PLACES`].
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub also: Vec<Place>,
}

fn in_one_line<S: serde::Serializer>(text: &str, serializer: S) -> Result<S::Ok, S::Error> {
    serializer.serialize_str(&text.replace("\nhelp: ", "; "))
}

impl Note {
    /// The most places that a note lists after its own.
    pub const MOST_PLACES: usize = 100;

    /// A note at a place.
    pub fn new(severity: Severity, place: Place, text: impl Into<String>) -> Self {
        Self { severity, place, text: text.into(), more: 0, also: Vec::new() }
    }

    /// A warning at a place.
    pub fn warning(place: Place, text: impl Into<String>) -> Self {
        Self::new(Severity::Warning, place, text)
    }

    /// A remark about the file as a whole.
    pub fn remark(text: impl Into<String>) -> Self {
        Self::new(Severity::Note, Place::File, text)
    }

    /// A warning about the file as a whole that starts with a count; `None` if that is 0.
    pub(super) fn counted(count: usize, [one, many]: [&str; 2], text: impl fmt::Display) -> Option<Self> {
        let noun = if count == 1 { one } else { many };
        let warning = || Self::warning(Place::File, format!("{count} {noun} {text}"));
        (count > 0).then(warning)
    }

    /// The same note for `count` things, the first of which are at these places; `None` without any.
    pub(super) fn for_all(
        severity: Severity,
        count: u64,
        places: impl IntoIterator<Item = Place>,
        text: impl Into<String>,
    ) -> Option<Self> {
        let more = count.checked_sub(1)?;
        let mut places = places.into_iter().take(1 + Self::MOST_PLACES);
        let place = places.next().unwrap_or_default();
        Some(Self { severity, place, text: text.into(), more, also: places.collect() })
    }
}

impl fmt::Display for Note {
    fn fmt(&self, out: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(out, "{}{}", self.place.prefix(), self.text)?;
        match self.more {
            0 => Ok(()),
            more => write!(out, " (and {more} more like it)"),
        }
    }
}

/// Why an output could not be made.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
pub enum WriteError {
    /// The format cannot hold this, and leaving it out would be wrong.
    #[error("{0}")]
    Unsupported(String),
    /// The output would be larger than the format can count.
    #[error("{0}")]
    TooLarge(String),
}

impl WriteError {
    /// Compression was asked for in another format than GLB.
    pub(super) fn not_compressible(format: Format) -> Self {
        Self::Unsupported(format!("meshopt compression needs a GLB, but the output is {format}"))
    }

    /// What was read, or kept of it, is not there to edit.
    pub(super) fn no_document() -> Self {
        Self::Unsupported("the file was not kept for editing; write another format".to_owned())
    }
}

/// A kind of note: its rank among the kinds of its format, its severity and its text.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub(super) struct NoteKind(pub u8, pub Severity, pub &'static str);

impl NoteKind {
    pub const fn warning(rank: u8, text: &'static str) -> Self {
        Self(rank, Severity::Warning, text)
    }
}

/// How often each kind of note is due, and at which byte offsets first.
#[derive(Clone, Debug, Default)]
pub(super) struct RepeatedNotes(BTreeMap<NoteKind, (u64, Vec<usize>)>);

impl RepeatedNotes {
    /// Adds one occurrence.
    pub fn add(&mut self, kind: NoteKind, offset: usize) {
        self.add_all(kind, 1, [offset]);
    }

    /// Adds `count` occurrences, some of which are at these offsets.
    pub fn add_all(&mut self, kind: NoteKind, count: u64, offsets: impl IntoIterator<Item = usize>) {
        let (total, known) = self.0.entry(kind).or_default();
        let room = (1 + Note::MOST_PLACES).saturating_sub(known.len());
        known.extend(offsets.into_iter().take(room));
        *total += count;
    }

    /// Appends what was found further back in the file.
    pub fn append(&mut self, other: Self) {
        for (kind, (count, offsets)) in other.0 {
            self.add_all(kind, count, offsets);
        }
    }

    /// Whether there is any note of a kind.
    pub fn has(&self, kind: NoteKind) -> bool {
        self.0.contains_key(&kind)
    }

    /// The value, or zero and a note if it is not valid.
    pub fn valid_or_zero<T: Default>(&mut self, kind: NoteKind, at: usize, is_valid: bool, value: T) -> T {
        if is_valid {
            return value;
        }
        self.add(kind, at);
        T::default()
    }

    /// The notes by rank, each with its first offset; `places` converts ascending offsets.
    pub fn notes(&self, places: impl Fn(&[usize]) -> Vec<Place>) -> impl Iterator<Item = (usize, Note)> {
        self.0.iter().filter_map(move |(&NoteKind(_, severity, text), (count, offsets))| {
            let mut offsets = offsets.clone();
            offsets.sort_unstable();
            let note = Note::for_all(severity, *count, places(&offsets), text)?;
            Some((*offsets.first()?, note))
        })
    }
}
