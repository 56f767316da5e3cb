//! What a revision found, counted.

use crate::io::Part;
use crate::mesh::Orientation;
use crate::normals::{Broken, Fault, FaultReason, Faults, Selection, Summary};

/// The most places that are kept of each kind of element. Counts are always complete.
pub const MOST_PLACES: usize = 100;

/// An element of a mesh as it was read; all numbers count from 0.
#[derive(Clone, Copy, Debug, PartialEq, Eq, serde::Serialize)]
#[serde(rename_all = "lowercase")]
pub enum Spot {
    /// A face.
    Face(u32),
    /// A vertex.
    Vertex(u32),
    /// A corner of a face.
    #[serde(untagged)]
    Corner {
        /// The face.
        face: u32,
        /// Which of the face's corners.
        corner: u32,
        /// The vertex at the corner.
        vertex: u32,
    },
}

/// What was found in one part. Counts of a part without faces are zero.
#[derive(Clone, Debug, Default)]
pub struct PartOutcome {
    /// Name of the part.
    pub name: String,
    /// Vertices, used or not.
    pub vertices: usize,
    /// Faces.
    pub faces: usize,
    /// Corners of all faces.
    pub corners: usize,
    /// Faces with 3, 4, and 5 or more corners.
    pub arities: [usize; 3],
    /// Faces dropped because they use a position that is not finite.
    pub non_finite_faces: usize,
    /// Faces dropped because their area is zero.
    pub dropped_faces: usize,
    /// Faces reversed.
    pub reversed_faces: usize,
    /// What orientation found, if it was asked for; its list of faces is empty because the edit has it.
    pub orientation: Option<Orientation>,
    /// Distinct (vertex, smooth group) pairs.
    pub entries: usize,
    /// Counts of the computation.
    pub summary: Summary,
    /// Faults of the computation.
    pub faults: FaultCounts,
    /// Where the first faults are: of faces, of corners, of vertices, at most [`MOST_PLACES`] of
    /// each.
    pub fault_places: Vec<(Spot, FaultReason)>,
    /// Corners that keep their stored normal.
    pub kept: usize,
    /// Corners that got a computed normal although not all were to be replaced, by the reason.
    pub replaced: ReplacedCounts,
    /// The first corners whose stored normal was broken, at most [`MOST_PLACES`].
    pub broken_places: Vec<(Spot, Broken)>,
}

impl PartOutcome {
    pub(super) fn new(part: &Part) -> Self {
        let mut arities = [0; 3];
        for range in part.mesh.faces().ranges() {
            arities[range.len().clamp(3, 5) - 3] += 1;
        }
        Self {
            name: part.name.clone(),
            vertices: part.mesh.vertex_count(),
            faces: part.mesh.face_count(),
            corners: part.mesh.faces().corner_count(),
            arities,
            non_finite_faces: part.non_finite_faces.len(),
            ..Self::default()
        }
    }
}

/// How often each [`FaultReason`] occurred, in the order of [`FaultReason::ALL`].
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct ReasonCounts(pub [usize; FaultReason::ALL.len()]);

impl ReasonCounts {
    fn of(list: &[Fault]) -> Self {
        let mut counts = Self::default();
        for fault in list {
            counts.0[fault.reason as usize] += 1;
        }
        counts
    }

    /// The reasons that occurred.
    pub fn iter(&self) -> impl Iterator<Item = (FaultReason, usize)> + '_ {
        FaultReason::ALL.into_iter().zip(self.0).filter(|&(_, count)| count > 0)
    }
}

/// Faults by element.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct FaultCounts {
    /// Of faces.
    pub faces: ReasonCounts,
    /// Of corners.
    pub corners: ReasonCounts,
    /// Of vertices.
    pub vertices: ReasonCounts,
}

impl FaultCounts {
    pub(super) fn of(faults: &Faults) -> Self {
        Self {
            faces: ReasonCounts::of(&faults.faces),
            corners: ReasonCounts::of(&faults.corners),
            vertices: ReasonCounts::of(&faults.vertices),
        }
    }
}

/// Corners whose stored normal was replaced, by the reason.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct ReplacedCounts {
    /// There was none.
    pub missing: usize,
    /// In the order of [`Broken::ALL`].
    pub broken: [usize; Broken::ALL.len()],
}

impl ReplacedCounts {
    pub(super) fn of(selection: &Selection) -> Self {
        let mut counts = Self { missing: selection.missing.len(), ..Self::default() };
        for &(_, cause) in &selection.broken {
            counts.broken[cause as usize] += 1;
        }
        counts
    }

    /// All of them.
    pub fn total(&self) -> usize {
        self.missing + self.broken.iter().sum::<usize>()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_lists_of_reasons_are_in_the_order_of_their_discriminants() {
        assert!(FaultReason::ALL.iter().enumerate().all(|(i, &reason)| reason as usize == i));
        assert!(Broken::ALL.iter().enumerate().all(|(i, &cause)| cause as usize == i));
    }
}
