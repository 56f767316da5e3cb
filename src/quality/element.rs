//! How much a finding matters, and what it counts.

use crate::num::names;
use serde::Serialize;

/// How much a finding matters.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash, Serialize)]
#[serde(rename_all = "lowercase")]
pub enum Severity {
    /// For information; may be intended.
    Note,
    /// Shows in pictures, in some light or some viewer.
    Warning,
    /// Wrong in any picture.
    Error,
}

// From the least severe.
names! { Severity: Note = "note", Warning = "warning", Error = "error" }

/// What a finding counts.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, Serialize)]
#[serde(rename_all = "lowercase")]
pub enum Element {
    /// Corners of faces.
    Corner,
    /// Faces.
    Face,
    /// Edges between two faces, each counted once.
    Edge,
    /// Vertices that faces use.
    Vertex,
    /// Nodes that place a mesh in the world.
    Node,
    /// Whole meshes.
    Mesh,
}

names! { Element:
    Corner = "corner", Face = "face", Edge = "edge", Vertex = "vertex", Node = "node", Mesh = "mesh",
}

impl Element {
    pub(crate) const COUNT: usize = Element::Mesh as usize + 1;

    pub(crate) const fn has_area(self) -> bool {
        matches!(self, Element::Corner | Element::Face | Element::Mesh)
    }
}
