//! How much a finding matters, and what it counts.

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

impl Severity {
    /// All severities, from the least.
    pub const ALL: [Severity; 3] = [Severity::Note, Severity::Warning, Severity::Error];

    /// The name used on the command line and in reports.
    pub const fn name(self) -> &'static str {
        match self {
            Severity::Note => "note",
            Severity::Warning => "warning",
            Severity::Error => "error",
        }
    }
}

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

impl Element {
    pub(crate) const COUNT: usize = Element::Mesh as usize + 1;

    pub(crate) const fn has_area(self) -> bool {
        matches!(self, Element::Corner | Element::Face | Element::Mesh)
    }

    /// The name used in reports, in the singular.
    pub const fn name(self) -> &'static str {
        match self {
            Element::Corner => "corner",
            Element::Face => "face",
            Element::Edge => "edge",
            Element::Vertex => "vertex",
            Element::Node => "node",
            Element::Mesh => "mesh",
        }
    }
}
