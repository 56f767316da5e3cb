//! An OBJ file as it was read.

use super::line_numbers::ObjLines;
use super::mtl_files::Materials;
use crate::io::FileMaterial;
use std::sync::OnceLock;

/// An OBJ file as it was read.
#[derive(Clone, Debug)]
pub struct ObjDocument {
    /// `None` after [`forget_text`](Self::forget_text).
    pub(super) text: Option<Vec<u8>>,
    pub(super) lines: OnceLock<ObjLines>,
    /// Where new normals go, and how many `vn` lines are before that.
    pub(super) insertion: (usize, usize),
    /// Whether a free-form surface refers to normals by number, so that these must not change.
    pub(super) surface_normals: bool,
    /// The material libraries.
    pub(super) libraries: Materials,
}

impl ObjDocument {
    /// The file as it was read.
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
        self.text = None;
    }

    /// The materials of the libraries.
    pub(in crate::io) fn materials(&self) -> &[FileMaterial] {
        &self.libraries.materials
    }
}
