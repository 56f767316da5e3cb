//! The result: one normal per (vertex, smooth group).

use crate::mesh::Column;
use crate::normals::creases::chains::CreaseChains;
use crate::normals::fault::Faults;
use crate::normals::fits::choice::Choice;
use crate::normals::fits::jet::JetFallbacks;
use glam::DVec3;

/// The normals of a mesh.
///
/// `normals` has one value per (vertex, smooth group), never merged across vertices, ordered by vertex and then
/// by the lowest corner of the group, and one index a corner. Every value is finite and of unit length.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct NormalField {
    /// The normals; the index is per corner.
    pub normals: Column<DVec3>,
    /// The vertex of each entry of `normals.values`.
    pub entry_vertex: Vec<u32>,
    /// Unit normal of every face.
    pub face_normals: Vec<DVec3>,
    /// Unit normals of each morph target's shape, one per entry.
    pub morph_normals: Vec<Vec<DVec3>>,
    /// The elements with a fallback normal.
    pub faults: Faults,
    /// What was found on the way.
    pub summary: Summary,
}

/// What to compute in addition to the normals of corners. What is not asked for stays empty in the [`NormalField`], and
/// costs neither time nor memory.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Extras {
    /// [`NormalField::face_normals`].
    pub face_normals: bool,
    /// [`Summary::edges`], [`Summary::near_crease`] and [`Summary::crease_chains`].
    pub edge_counts: bool,
}

impl Extras {
    /// Everything.
    pub const ALL: Self = Self { face_normals: true, edge_counts: true };
    /// Only the normals of corners.
    pub const NONE: Self = Self { face_normals: false, edge_counts: false };
}

/// Counts of a computation, for reports.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Summary {
    /// Vertices that a face uses.
    pub referenced_vertices: usize,
    /// Entries minus referenced vertices.
    pub splits: usize,
    /// Edges, each counted once, by kind.
    pub edges: EdgeCounts,
    /// Edges whose dihedral angle is within 0.1° of the crease angle. If positions were rounded to few decimals, the tolerance is
    /// the angle by which that can rotate the normals of the two faces.
    pub near_crease: usize,
    /// Normals kept although the weighted normals of their faces nearly cancel, and the bound on their error.
    pub near_cancellation: NearCancellation,
    /// Chains of crease edges; none are counted if any edge is [`marked`](EdgeCounts::marked) or none is smooth.
    pub crease_chains: CreaseChains,
    /// The crease angle applied, in degrees; `None` where smoothing groups decide alone.
    pub crease_degrees: Option<f64>,
    /// Clusters of welded positions wider than twice the welding distance.
    pub wide_clusters: usize,
    /// Quadric fits that fell back to the angle mean.
    pub quadric_fallbacks: usize,
    /// Jets of lower degree.
    pub jet_fallbacks: JetFallbacks,
    /// With [`Weight::Best`](crate::normals::Weight::Best): what it chose, and why.
    pub choice: Option<Choice>,
    /// Fans too large for the cone rule, cut by the fan rule instead.
    pub cone_declined: usize,
    /// Entries whose normal in a morph target's shape had to be that of the base shape.
    pub morph_fallbacks: usize,
    /// Faces before the first `s` statement of an OBJ file, where groups were honoured.
    pub faces_before_groups: usize,
    /// Whether `fast` left its promised range and `faithful` was used instead.
    pub fast_declined: bool,
}

/// Entries whose sum is right to no more than 10⁻⁶ rad, because its terms nearly cancel. Above 10⁻³ rad they are faults:
/// [`FaultReason::CancellingFan`](crate::normals::FaultReason::CancellingFan).
#[derive(Clone, Copy, Debug, Default, PartialEq, serde::Serialize)]
pub struct NearCancellation {
    /// How many.
    pub normals: usize,
    /// The largest possible error, in radians: 10⁻⁵, 10⁻⁴ or 10⁻³.
    pub bound: f64,
}

impl NearCancellation {
    /// Of sums with these bounds.
    pub(crate) fn of(bounds: impl Iterator<Item = f64>) -> Self {
        bounds.fold(Self::default(), Self::with)
    }

    fn with(self, bound: f64) -> Self {
        Self { normals: self.normals + 1, bound: self.bound.max(bound) }
    }
}

impl std::ops::Add for NearCancellation {
    type Output = Self;

    fn add(self, other: Self) -> Self {
        Self { normals: self.normals + other.normals, bound: self.bound.max(other.bound) }
    }
}

/// Edges by kind. An edge that is hard for several reasons is counted under the first that applies.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, serde::Serialize)]
pub struct EdgeCounts {
    /// Smooth edges between two faces.
    pub smooth: usize,
    /// Edges of one face only.
    pub boundary: usize,
    /// Edges of more than two faces.
    pub non_manifold: usize,
    /// Edges that two faces run through in the same direction: one of the two is reversed.
    pub inconsistent: usize,
    /// Coincident edges that could be joined in several ways, and were not.
    pub ambiguous: usize,
    /// Hard for a smoothing group, a material, a uv seam, an authored normal or a listed edge.
    pub marked: usize,
    /// Hard for their angle.
    pub crease: usize,
    /// Among all of them, joined by welding.
    pub welded: usize,
}

impl EdgeCounts {
    /// The counts of separate triangles, from those of the same triangles with vertices shared by position.
    pub(crate) fn all_welded(self) -> Self {
        Self { ambiguous: self.non_manifold, non_manifold: 0, welded: self.smooth + self.crease, ..self }
    }
}
