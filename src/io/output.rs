//! What a writer returns.

use super::Note;
use std::path::PathBuf;

/// An output, ready to be stored.
#[derive(Clone, Debug, Default)]
pub struct Written {
    /// The file itself.
    pub bytes: Vec<u8>,
    /// Files that belong with it.
    pub companions: Vec<OutputFile>,
    /// What could not be kept, and other notes.
    pub notes: Vec<Note>,
    /// Vertices in the output.
    pub vertices: u64,
    /// Vertices added by splitting.
    pub added_vertices: u64,
}

/// A file that belongs with the main output.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct OutputFile {
    /// Path relative to the main output's folder.
    pub name: String,
    /// Its content.
    pub content: OutputContent,
}

/// Where a companion's bytes are.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum OutputContent {
    /// New bytes.
    Bytes(Vec<u8>),
    /// A copy of this file, which the input refers to; nothing to do when both are the same file.
    CopyOf(PathBuf),
}
