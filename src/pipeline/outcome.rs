//! What a revision found, counted.

use crate::io::Part;
use crate::mesh::Orientation;
use crate::normals::{
    Choice, CreaseChains, EdgeCounts, Fault, Faults, JetFallbacks, NearCancellation, Selection,
};
use serde::Serialize;
use std::collections::BTreeMap;

/// The most places that are kept of each kind of element. Counts are always complete.
pub const MOST_PLACES: usize = 100;

/// An element of a mesh as it was read; all numbers count from 0.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
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

/// An element, and what was found there.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
pub struct FaultPlace {
    /// The element.
    #[serde(flatten)]
    pub spot: Spot,
    /// The name of the reason.
    pub reason: &'static str,
}

/// Counts by the name of a reason, of those that occurred.
pub type Counts = BTreeMap<&'static str, usize>;

/// What was found in one part. Counts of a part without faces are zero.
#[derive(Clone, Debug, Default, Serialize)]
pub struct PartOutcome {
    /// Name of the part.
    pub name: String,
    /// Vertices, used or not.
    pub vertices: usize,
    /// Vertices that a face uses.
    pub referenced_vertices: usize,
    /// Faces.
    pub faces: usize,
    /// Corners of all faces.
    pub corners: usize,
    /// Faces with 3 corners.
    pub triangles: usize,
    /// Faces with 4 corners.
    pub quads: usize,
    /// Faces with 5 corners or more.
    pub polygons: usize,
    /// Distinct (vertex, smooth group) pairs.
    pub entries: usize,
    /// Entries minus referenced vertices.
    pub splits: usize,
    /// The crease angle applied, in degrees; `None` where smoothing groups decide alone.
    pub crease_degrees: Option<f64>,
    /// Edges near the crease angle: [`Summary::near_crease`](crate::normals::Summary::near_crease).
    pub near_crease: usize,
    /// Normals from sums that nearly cancel; not in JSON if there are none.
    #[serde(skip_serializing_if = "is_exact")]
    pub near_cancellation: NearCancellation,
    /// Chains of crease edges.
    #[serde(skip)]
    pub crease_chains: CreaseChains,
    /// Edges by kind.
    pub edges: EdgeCounts,
    /// Faults of the computation.
    pub faults: FaultCounts,
    /// Corners that keep their stored normal.
    pub kept_corners: usize,
    /// Corners with a computed normal, if not all were to be replaced.
    pub replaced_corners: Counts,
    /// Where the first faults are: of faces, of corners, of vertices, at most [`MOST_PLACES`] of each.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub fault_places: Vec<FaultPlace>,
    /// The first corners whose stored normal was broken, at most [`MOST_PLACES`].
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub broken_places: Vec<FaultPlace>,
    /// Faces reversed.
    pub reversed_faces: usize,
    /// Faces dropped because their area is zero.
    pub dropped_faces: usize,
    /// Faces dropped because they use a position that is not finite.
    pub non_finite_faces: usize,
    /// What orientation found, if it was asked for; its list of faces is empty because the edit has it.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub orientation: Option<Orientation>,
    /// Quadric fits that fell back to angle weights.
    pub quadric_fallbacks: usize,
    /// Jets of lower degree, where there were jets.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub jet_fallbacks: Option<JetFallbacks>,
    /// With [`Weight::Best`](crate::normals::Weight::Best): what it chose, and why.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub best: Option<Choice>,
    /// Fans too large for the cone rule, cut by the fan rule instead.
    pub cone_declined: usize,
    /// Clusters of welded positions wider than twice the welding distance.
    pub wide_clusters: usize,
    /// Faces before the first `s` statement of an OBJ file, where groups were honoured.
    pub faces_before_groups: usize,
    /// Whether `fast` was not applicable and `faithful` was used.
    pub fast_declined: bool,
}

fn is_exact(sums: &NearCancellation) -> bool {
    sums.normals == 0
}

impl PartOutcome {
    pub(super) fn new(part: &Part) -> Self {
        let mut arities = [0; 3];
        for range in part.mesh.faces().ranges() {
            arities[range.len().clamp(3, 5) - 3] += 1;
        }
        let [triangles, quads, polygons] = arities;
        Self {
            name: part.name.clone(),
            vertices: part.mesh.vertex_count(),
            faces: part.mesh.face_count(),
            corners: part.mesh.faces().corner_count(),
            triangles,
            quads,
            polygons,
            non_finite_faces: part.non_finite_faces.len(),
            ..Self::default()
        }
    }
}

/// Faults by element.
#[derive(Clone, Debug, Default, PartialEq, Eq, Serialize)]
pub struct FaultCounts {
    /// Of faces.
    pub faces: Counts,
    /// Of corners.
    pub corners: Counts,
    /// Of vertices.
    pub vertices: Counts,
}

impl FaultCounts {
    pub(super) fn of(faults: &Faults) -> Self {
        let of = |list: &[Fault]| counted(list.iter().map(|fault| fault.reason.name()));
        Self { faces: of(&faults.faces), corners: of(&faults.corners), vertices: of(&faults.vertices) }
    }
}

/// The corners that a selection replaces, by the reason.
pub(super) fn replaced(selection: &Selection) -> Counts {
    let mut counts = counted(selection.broken.iter().map(|(_, cause)| cause.name()));
    if !selection.missing.is_empty() {
        counts.insert("Missing", selection.missing.len());
    }
    counts
}

fn counted(names: impl Iterator<Item = &'static str>) -> Counts {
    let mut counts = Counts::new();
    names.for_each(|name| *counts.entry(name).or_default() += 1);
    counts
}
