//! Notes on an edit.

use crate::io::text::counted;
use crate::io::{Note, Place};

/// Counts of what an edit changed besides normals; each becomes one note.
#[derive(Default)]
pub struct Remarks {
    /// Corners without a normal of their own among others that have one.
    pub without_normal: usize,
    /// Primitives whose morph targets have normal deltas that were not recomputed.
    pub stale_deltas: usize,
    /// Primitives whose tangents were omitted.
    pub tangents_dropped: usize,
    /// Primitives whose morph targets lost their tangents to new ones of the base.
    pub tangent_deltas_dropped: usize,
    /// Primitives that lost all their faces.
    pub emptied: usize,
    /// Primitives whose compressed copy was omitted.
    pub draco_dropped: usize,
    /// Normals are stored as integers.
    pub quantized: bool,
}

impl Remarks {
    /// Adds a note for each count.
    pub fn add_to(&self, notes: &mut Vec<Note>) {
        let (corners, primitives) = (["corner", "corners"], ["primitive", "primitives"]);
        for (count, [one, many], text) in [
            (
                self.without_normal,
                corners,
                "without a normal to write, the stored one is kept, or +Z written",
            ),
            (self.stale_deltas, primitives, "normal deltas of morph targets still belong to the old normals"),
            (
                self.tangents_dropped,
                primitives,
                "tangents belonged to the old normals and were left out; viewers make them again (a validator then \
                 reports MESH_PRIMITIVE_GENERATED_TANGENT_SPACE where there is a normal map), see --tangents",
            ),
            (
                self.tangent_deltas_dropped,
                primitives,
                "morph targets had tangents for the old ones of the base, which were left out",
            ),
            (
                self.emptied,
                primitives,
                "all faces are gone, and one triangle without area stands for them, as glTF needs one",
            ),
            (self.draco_dropped, primitives, "the Draco copy was left out and the plain data kept"),
        ] {
            if count > 0 {
                let text = format!("{text}: {}", counted(count, one, many));
                notes.push(Note::warning(Place::File, text));
            }
        }
    }
}
