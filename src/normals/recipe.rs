//! The recipe: everything that determines a normal, and nothing that must not change it.

use crate::mesh::Weld;
use crate::num::{Degrees, names};

/// How much each face counts in the mean at a corner. With edges e1, e2 from the corner, the interior angle α
/// between them and the unit face normal n̂, the mean is the unit vector of Σ w n̂.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash, serde::Serialize, serde::Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum Weight {
    /// w = 1 (Gouraud 1971): depends on how the surface happens to be cut into faces.
    Uniform,
    /// w = area of the whole face: cheapest, drawn towards large faces.
    Area,
    /// w = α (Thürmer & Wüthrich 1998): does not change when flat parts are triangulated differently.
    #[default]
    Angle,
    /// w = α · area.
    AngleArea,
    /// w = |e1×e2| / (|e1|² |e2|²) (Max 1999): exact where the vertices lie on a sphere.
    Max,
    /// w = 1 / (|e1| |e2|).
    Edge,
    /// The normal of a least-squares quadric through the two-ring: second order, slow. The angle mean is used where there are
    /// fewer than six neighbours, where they lie on a conic, as on two rings of points, where the normals among them differ by more
    /// than 90° from the mean, as at the tip of a cone, or where the fit turns the mean more than twice as far as the means of the
    /// neighbours turn in that direction, so that rounding of positions is not taken for shape: [`Summary::quadric_fallbacks`](crate::normals::Summary::quadric_fallbacks) counts these.
    Quadric,
    /// The normal of an osculating jet: a polynomial of degree 3 through the vertex, fitted with rows of weight 1/d² to the two-ring, or to
    /// more rings where that has fewer than 14 vertices (Cazals & Pouget 2005). Third order on surfaces without noise. Where there
    /// is no fit a polynomial of degree 2 is used, and then the angle mean:
    /// [`Summary::jet_fallbacks`](crate::normals::Summary::jet_fallbacks) counts these by the reason.
    Jet,
    /// [`Jet`](Self::Jet), [`Quadric`](Self::Quadric) or [`Angle`](Self::Angle): whichever has the smallest estimated error on
    /// the mesh. [`Summary::choice`](crate::normals::Summary::choice) holds the estimates.
    Best,
}

names! { Weight:
    Uniform = "uniform", Area = "area", Angle = "angle", AngleArea = "angle-area", Max = "max",
    Edge = "edge", Quadric = "quadric", Jet = "jet", Best = "best",
}

impl Weight {
    /// Those that sum face normals, in the order of [`ALL`](Self::ALL).
    pub const SUMS: [Weight; 6] =
        [Weight::Uniform, Weight::Area, Weight::Angle, Weight::AngleArea, Weight::Max, Weight::Edge];

    /// Whether it fits a surface to the neighbours of a vertex, rather than sum face normals: it starts from the angle mean, and
    /// takes a mesh with its topology.
    pub fn is_fit(self) -> bool {
        !Self::SUMS.contains(&self)
    }
}

/// When the dihedral angle makes an edge hard.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub enum Crease {
    /// [`Crease::DEFAULT_ANGLE`], unless smoothing groups decide.
    #[default]
    Default,
    /// This angle, in addition to smoothing groups where there are any. 0: every edge is hard; 180: none.
    Angle(Degrees),
}

impl Crease {
    /// The angle used where none was given and no smoothing groups decide.
    pub const DEFAULT_ANGLE: Degrees = Degrees(40.0);
    /// No edge is hard for its angle.
    pub const OFF: Crease = Crease::Angle(Degrees(180.0));
}

/// What hard edges do to the faces around a vertex.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub enum CreaseRule {
    /// Hard edges cut the fan into smooth groups with one normal each.
    #[default]
    Fan,
    /// Each corner averages those faces of the fan whose normals are within the angle of its own face's.
    Cone,
}

/// What smoothing groups of a file do.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub enum Groups {
    /// They decide which edges are hard.
    #[default]
    Honour,
    /// They are ignored.
    Ignore,
}

/// Further kinds of hard edges.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub struct HardEdges {
    /// Where texture coordinates of the two sides differ at either end.
    pub uv: bool,
    /// Between faces of different materials.
    pub material: bool,
    /// Where stored normals of the two sides differ by more than 0.1° at either end.
    pub authored: bool,
}

/// The weight of slivers: faces whose height is below the rounding of their coordinates.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub enum Slivers {
    /// None, unless a smooth group has no other face.
    #[default]
    Exclude,
    /// The same as that of any other face.
    Keep,
}

/// The precision of the computation.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash, serde::Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum Precision {
    /// Right to the last bit of the output at any magnitude, offset or thinness.
    #[default]
    Faithful,
    /// Sums in `f32`, for triangles with edges of 1e-6 to 1e6 and height/length ≥ 1e-3, valence ≤ 1000. One triangle in 32 may
    /// be thinner, and one sum in 32 may nearly cancel: these are computed in double precision. Sharp edges are those of
    /// `Faithful`, and so is everything else: other meshes, fits, the cone rule.
    Fast,
}

names! { Precision: Faithful = "faithful", Fast = "fast" }

/// How the normals of faces become one, for callers with slices of their own.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub struct Averaging {
    /// How much each face counts.
    pub weight: Weight,
    /// The weight of slivers.
    pub slivers: Slivers,
    /// The precision of the computation.
    pub precision: Precision,
}

/// Whether hard edges give a vertex several normals.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub enum Scope {
    /// One normal per vertex and smooth group.
    #[default]
    Corner,
    /// One normal per vertex: all faces at it and at vertices joined to it by a welded edge; no edge is hard.
    Vertex,
}

/// Everything that determines the normals of a mesh.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct NormalRecipe {
    /// How much each face counts.
    pub weight: Weight,
    /// When the angle makes an edge hard.
    pub crease: Crease,
    /// What hard edges do.
    pub rule: CreaseRule,
    /// What smoothing groups do.
    pub groups: Groups,
    /// Further hard edges.
    pub hard_edges: HardEdges,
    /// Which coincident edges are joined.
    pub weld: Weld,
    /// The weight of slivers.
    pub slivers: Slivers,
    /// The precision of the computation.
    pub precision: Precision,
    /// Whether hard edges give a vertex several normals.
    pub scope: Scope,
}
