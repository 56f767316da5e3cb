//! What to do with a file.

use crate::io::Emit;
use crate::mesh::{Confidence, Orient};
use crate::normals::{NormalRecipe, When};

/// What to do with a file.
#[derive(Clone, Debug, Default)]
pub struct Task {
    /// What determines the normals.
    pub recipe: NormalRecipe,
    /// Which normals the output carries.
    pub emit: Emit,
    /// Which stored normals are replaced.
    pub when: When,
    /// How faces are oriented. A component that faces inwards inside a volume of another part, where the nodes of the file place
    /// them, is a cavity of it. The stored normals of the file identify rooms. Stored normals that [`when`](Self::when) keeps do
    /// not change.
    pub orient: Orient,
    /// The confidence that [`Orient::Outward`] needs to flip components with a boundary.
    pub confidence: Confidence,
    /// Reverse every face after that, together with the stored normals that are kept.
    pub flip: bool,
    /// What happens to faces without area.
    pub degenerate: Degenerate,
    /// Whether to count edges even where none can be sharp; otherwise their counts are 0 there.
    pub edge_counts: bool,
}

/// What happens to faces whose area is exactly zero.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub enum Degenerate {
    /// They stay, with a fallback normal.
    #[default]
    Keep,
    /// They are removed from the output. Normals are those of the faces that remain: seams close if only such faces were
    /// between their two sides.
    Drop,
}
