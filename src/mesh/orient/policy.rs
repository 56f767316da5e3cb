//! The orientation policies: which faces to reverse so that neighbours agree and surfaces face outwards.

use super::components::Components;
use super::shells::{Role, Shell, roles, shells};
use super::visibility::votes;
use crate::mesh::face_normals::vector_area;
use crate::mesh::polygon_mesh::Mesh;
use crate::mesh::topology::Topology;
use crate::num::parallel;
use crate::num::unit_scale;
use rayon::prelude::*;

/// Which faces are reversed.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub enum Orient {
    /// None.
    #[default]
    Keep,
    /// In each component the minority with a winding opposite to the others; of two equal halves the one opposite to the lowest
    /// face. Faces without area (twice the area below a millionth of the longest edge squared), such as fillers next to a vertex
    /// on an edge, do not count and are reversed with the others.
    Consistent,
    /// In each closed component the faces that do not face outwards, if it lies in an even number of other closed
    /// components, or inwards, as a cavity, if it lies in an odd number. A room faces inwards and does not count for its
    /// contents: a component that faces inwards with most of its stored normals, around components at least half of
    /// which face outwards by theirs. In each component with a boundary those that do not face the side that sees more of
    /// the surroundings, if that is confident enough ([`Confidence`]). Others stay unchanged.
    Outward,
}

/// The confidence about the outer side that a component with a boundary needs to be reversed: from ½, a mere majority, to
/// 1, which no vote reaches.
///
/// At up to 64 points of the component 64 rays compare how much of the surroundings either side sees (Takayama et al.,
/// JCGT 3(4), 2014); a point votes if that differs by a quarter. With *a* votes of *b* for one side the confidence is
/// (a + 1)/(b + 2), Laplace's rule of succession. A plane has no votes: ½.
#[derive(Clone, Copy, Debug, PartialEq, PartialOrd)]
pub struct Confidence(pub f64);

impl Confidence {
    /// No component with a boundary is reversed.
    pub const NEVER: Self = Self(1.0);
}

impl Default for Confidence {
    fn default() -> Self {
        Self(0.9)
    }
}

/// What [`orient`] found.
///
/// A *component* is faces connected over edges that join exactly two of them, by vertex index or welded. It is
/// *closed* if, once its faces agree, their half-edges cancel at every edge. Faces of fewer than three distinct
/// positions belong to none.
#[derive(Clone, Debug, Default, PartialEq, serde::Serialize)]
pub struct Orientation {
    /// The faces to reverse, ascending: [`FaceEdit::reversed`](crate::mesh::FaceEdit::reversed).
    #[serde(skip)]
    pub reversed: Vec<u32>,
    /// The reversed faces of components with a boundary, ascending ([`Orient::Outward`] only).
    #[serde(skip)]
    pub reversed_open: Vec<u32>,
    /// How many components there are.
    pub components: usize,
    /// Closed components whose faces can all be made to agree.
    pub closed: usize,
    /// Components with a boundary whose outer side was confident enough ([`Orient::Outward`] only).
    pub open_told: usize,
    /// The least confidence among those; 0 if there are none.
    #[serde(serialize_with = "null_if_zero")]
    pub confidence: f64,
    /// Components with a boundary, unchanged because their outer side was uncertain ([`Orient::Outward`] only).
    pub open_left: usize,
    /// Components whose faces cannot all agree, such as a Möbius strip; unchanged.
    pub non_orientable: usize,
    /// Closed components whose volume is not above its rounding error, such as a sheet with two sides; unchanged, and
    /// taken to contain nothing ([`Orient::Outward`] only).
    pub flat: usize,
    /// Closed components whose nesting is undetermined: every point tried lies on the other's surface, or the search
    /// became too long. Unchanged ([`Orient::Outward`] only).
    pub undecided: usize,
    /// Closed components with more than half of their faces reversed ([`Orient::Outward`] only).
    pub inside_out: usize,
    /// Components with a boundary and more than half of their faces reversed ([`Orient::Outward`] only).
    pub open_inside_out: usize,
    /// Closed components that lie in an odd number of others and now face inwards ([`Orient::Outward`] only).
    pub cavities: usize,
    /// Closed components that face inwards and stay so, as rooms ([`Orient::Outward`] only).
    pub rooms: usize,
    /// The faces of these, ascending.
    #[serde(skip)]
    pub room_faces: Vec<u32>,
}

/// Null without votes.
fn null_if_zero<S: serde::Serializer>(confidence: &f64, serializer: S) -> Result<S::Ok, S::Error> {
    serde::Serialize::serialize(&Some(confidence).filter(|it| **it > 0.0), serializer)
}

/// Finds the faces to reverse so that neighbours agree and, for [`Orient::Outward`], closed surfaces face outwards.
///
/// Welded edges count as connections. Outward is decided by signed volume, nesting by rays from points of the inner
/// surface; both hold at any size and any distance from the origin. Surfaces that intersect each other are not nested.
/// Stored normals, if any, distinguish rooms from surfaces that are inside out ([`Orient::Outward`]); without them every
/// closed surface counts as solid. Components with a boundary are reversed by a vote of visibility, if its confidence is
/// above `confidence`.
///
/// Linear in faces, and n log n in closed components that lie in the boxes of others and in faces where a component has a
/// boundary; long searches are cut short (see [`Orientation::undecided`]; such points do not vote). The result does not
/// depend on the number of threads. [`Orient::Keep`] checks nothing and leaves all counts at 0.
///
/// ```
/// use crease::mesh::{Confidence, FaceEdit, Faces, MeshBuilder, Orient, Topology, Weld, orient};
/// use glam::DVec3;
///
/// // A tetrahedron with its last face reversed.
/// let mesh = MeshBuilder {
///     positions: vec![DVec3::ZERO, DVec3::X, DVec3::Y, DVec3::Z].into(),
///     faces: Faces::triangles(vec![0, 2, 1, 0, 1, 3, 0, 3, 2, 1, 3, 2]),
///     ..MeshBuilder::default()
/// }
/// .build()?;
/// let topology = Topology::build(&mesh, Weld::Exact);
/// let found = orient(&mesh, &topology, Orient::Outward, Confidence::default());
/// assert_eq!(found.reversed, [3]);
/// let repaired = mesh.with_faces(&FaceEdit { reversed: found.reversed, ..FaceEdit::default() });
/// assert_eq!(repaired.faces().face(3), [1, 2, 3]);
/// # Ok::<(), crease::mesh::MeshError>(())
/// ```
pub fn orient(mesh: &Mesh, topology: &Topology, policy: Orient, confidence: Confidence) -> Orientation {
    match policy {
        Orient::Keep => Orientation::default(),
        Orient::Consistent => Orientations::new(mesh, topology).consistent(mesh),
        Orient::Outward => Orientations::new(mesh, topology).outward(mesh, confidence, &[]),
    }
}

/// The components of a mesh, for callers that need several orientations of it.
pub(crate) struct Orientations {
    pub(super) components: Components,
    /// The orientable components, ascending: the closed ones, and those with a boundary.
    closed: Vec<usize>,
    open: Vec<usize>,
}

impl Orientations {
    pub(crate) fn new(mesh: &Mesh, topology: &Topology) -> Self {
        let components = Components::find(mesh, topology);
        let is_closed = |component: usize| {
            components.orientable[component] && components.is_closed(component, mesh, topology)
        };
        let is_closed = parallel::map(components.len(), is_closed);
        let (closed, open) = (0..components.len())
            .filter(|&component| components.orientable[component])
            .partition(|&component| is_closed[component]);
        Self { components, closed, open }
    }

    /// The faces of each component, ascending.
    pub(crate) fn components(&self) -> Vec<&[u32]> {
        (0..self.components.len()).map(|component| self.components.faces(component)).collect()
    }

    /// The closed components with a volume, ascending.
    pub(super) fn shells(&self, mesh: &Mesh) -> Vec<Shell> {
        shells(mesh, &self.components, &self.closed)
    }

    /// The faces that [`Orient::Consistent`] reverses.
    pub(crate) fn consistent(&self, mesh: &Mesh) -> Orientation {
        /// Twice the area over the square of the longest edge; the remainder of faces without area after rounding to
        /// single precision is below it.
        const THIN: f64 = 1e-6;
        let mut found = self.counts();
        let scale = unit_scale(mesh.extent());
        let has_area = |face: u32| {
            let corners = mesh.faces().face(face as usize);
            let place = |i: usize| mesh.position(corners[i % corners.len()]) * scale;
            let edges = (0..corners.len()).map(|i| (place(i + 1) - place(i)).length_squared());
            2.0 * vector_area(mesh, face as usize, scale).length() > THIN * edges.fold(0.0, f64::max)
        };
        for &component in self.closed.iter().chain(&self.open) {
            let minority = self.components.agrees_with_lowest(component, has_area);
            found.reversed.extend(self.components.side(component, minority));
        }
        found.reversed.par_sort_unstable();
        found
    }

    /// The faces that [`Orient::Outward`] reverses, if some components, ascending, are known to be [cavities] of another
    /// mesh.
    ///
    /// [cavities]: super::cavities::cavities
    pub(crate) fn outward(&self, mesh: &Mesh, confidence: Confidence, cavities: &[usize]) -> Orientation {
        let mut found = self.counts();
        self.orient_closed(mesh, cavities, &mut found);
        self.orient_open(mesh, confidence, &mut found);
        found.reversed.extend_from_slice(&found.reversed_open);
        found.reversed.par_sort_unstable();
        found
    }

    /// The given faces, ascending, of each component more than half of whose faces are among them.
    pub(crate) fn inside_out(&self, reversed: &[u32]) -> Vec<Vec<u32>> {
        if reversed.is_empty() {
            return Vec::new();
        }
        let is_reversed = |face: &u32| reversed.binary_search(face).is_ok();
        parallel::filter_map(self.components.len(), |component| {
            let faces = self.components.faces(component);
            let found: Vec<u32> = faces.iter().copied().filter(is_reversed).collect();
            (2 * found.len() > faces.len()).then_some(found)
        })
    }

    fn counts(&self) -> Orientation {
        Orientation {
            components: self.components.len(),
            closed: self.closed.len(),
            non_orientable: self.components.len() - self.closed.len() - self.open.len(),
            ..Orientation::default()
        }
    }

    fn orient_closed(&self, mesh: &Mesh, cavities: &[usize], found: &mut Orientation) {
        let shells = self.shells(mesh);
        found.flat = self.closed.len() - shells.len();
        for (&Shell { component, outward, .. }, role) in shells.iter().zip(roles(&shells, cavities)) {
            match role {
                Role::Unknown => {
                    found.undecided += 1;
                    continue;
                }
                Role::Cavity => found.cavities += 1,
                Role::Room => {
                    found.rooms += 1;
                    found.room_faces.extend_from_slice(self.components.faces(component));
                }
                Role::Solid => {}
            }
            let is_inward = role != Role::Solid;
            let before = found.reversed.len();
            // Faces that run with the lowest one are right if they face outwards and should.
            found.reversed.extend(self.components.side(component, outward != is_inward));
            let count = found.reversed.len() - before;
            found.inside_out += usize::from(self.components.is_majority(component, count));
        }
        found.room_faces.par_sort_unstable();
    }

    fn orient_open(&self, mesh: &Mesh, confidence: Confidence, found: &mut Orientation) {
        if confidence >= Confidence::NEVER {
            found.open_left = self.open.len();
            return;
        }
        for (&component, vote) in self.open.iter().zip(votes(mesh, &self.components, &self.open)) {
            let is_sure = vote.confidence > confidence.0;
            if !is_sure {
                found.open_left += 1;
                continue;
            }
            let least = if found.open_told == 0 { 1.0 } else { found.confidence };
            (found.open_told, found.confidence) = (found.open_told + 1, least.min(vote.confidence));
            let before = found.reversed_open.len();
            found.reversed_open.extend(self.components.side(component, vote.outward));
            let count = found.reversed_open.len() - before;
            found.open_inside_out += usize::from(self.components.is_majority(component, count));
        }
        found.reversed_open.par_sort_unstable();
    }
}
