//! Edges that are hard whatever their angle: marked by groups, materials, seams, stored normals or a list.

use crate::mesh::{Column, Mesh, Topology};
use crate::normals::creases::dihedral_test::AngleLimit;
use crate::normals::recipe::{Crease, Groups, NormalRecipe};
use crate::num::Degrees;
use glam::{DVec2, DVec3};
use rustc_hash::FxHashSet;

/// Stored normals of the two sides of an edge that differ by more than this, in degrees, make it hard under
/// `authored`: well above the steps of 16-bit normals, well below what shading shows.
const AUTHORED_DEGREES: f64 = 0.1;

/// The edges that are hard for other reasons than their angle.
pub(crate) struct Marks<'a> {
    mesh: &'a Mesh,
    groups: Option<&'a [u32]>,
    materials: Option<&'a [u32]>,
    uvs: Option<&'a Column<DVec2>>,
    authored: Option<(&'a Column<DVec3>, AngleLimit)>,
    listed: FxHashSet<[u32; 2]>,
}

impl<'a> Marks<'a> {
    /// The marks that a recipe asks for and a mesh has.
    pub(crate) fn new(mesh: &'a Mesh, recipe: &NormalRecipe) -> Self {
        let columns = mesh.columns();
        let hard = recipe.hard_edges;
        Self {
            mesh,
            groups: honoured_groups(mesh, recipe),
            materials: columns.materials.as_ref().filter(|_| hard.material).map(|m| m.of_face.as_slice()),
            uvs: columns.uvs.as_ref().filter(|_| hard.uv),
            authored: columns
                .normals
                .as_ref()
                .filter(|_| hard.authored)
                .map(|normals| (normals, AngleLimit::degrees(AUTHORED_DEGREES))),
            listed: columns.hard_edges.iter().map(|&[a, b]| [a.min(b), a.max(b)]).collect(),
        }
    }

    /// Whether no edge can be marked.
    pub(crate) fn is_empty(&self) -> bool {
        self.groups.is_none()
            && self.materials.is_none()
            && self.uvs.is_none()
            && self.authored.is_none()
            && self.listed.is_empty()
    }

    /// Whether the edge between a half-edge and the one across it is marked. Both sides give the same answer.
    pub(crate) fn is_marked(&self, topology: &Topology, half_edge: u32, across: u32) -> bool {
        if self.is_empty() {
            return false;
        }
        let mesh = self.mesh;
        let (face, other) = (topology.face_of(half_edge), topology.face_of(across));
        let labels_differ = |labels: &[u32]| labels[face as usize] != labels[other as usize];
        if let Some(groups) = self.groups
            && (labels_differ(groups) || groups[face as usize] == 0)
        {
            return true;
        }
        if self.materials.is_some_and(labels_differ) {
            return true;
        }
        let faces = mesh.faces();
        // The corners of the two sides at each end of the edge.
        let ends = [(half_edge, topology.next(across)), (topology.next(half_edge), across)];
        if let Some(uvs) = self.uvs
            && ends.iter().any(|&(a, b)| at(uvs, mesh, a) != at(uvs, mesh, b))
        {
            return true;
        }
        if let Some((normals, limit)) = &self.authored
            && ends.iter().any(|&(a, b)| match (at(normals, mesh, a), at(normals, mesh, b)) {
                (Some(a), Some(b)) => a != b && limit.exceeded_by_any(*a, *b),
                _ => false,
            })
        {
            return true;
        }
        !self.listed.is_empty()
            && [half_edge, across].iter().any(|&h| {
                let (a, b) = topology.ends(faces.corners(), h);
                self.listed.contains(&[a.min(b), a.max(b)])
            })
    }
}

fn at<'a, T>(column: &'a Column<T>, mesh: &Mesh, corner: u32) -> Option<&'a T> {
    column.get(corner as usize, mesh.faces().corners()[corner as usize])
}

/// The smoothing groups, if the mesh has any and the recipe honours them.
fn honoured_groups<'a>(mesh: &'a Mesh, recipe: &NormalRecipe) -> Option<&'a [u32]> {
    let smoothing = mesh.columns().smoothing.as_ref()?;
    (recipe.groups == Groups::Honour).then_some(smoothing.of_face.as_slice())
}

impl NormalRecipe {
    /// Whether an edge of a mesh may be hard for its angle or for another reason that the recipe names.
    pub(crate) fn can_split(&self, mesh: &Mesh) -> bool {
        !Marks::new(mesh, self).is_empty()
            || applied_angle(mesh, self).is_some_and(|Degrees(angle)| angle < 180.0)
    }
}

/// The crease angle that applies: the one typed; without one, the default where no smoothing groups decide.
pub(crate) fn applied_angle(mesh: &Mesh, recipe: &NormalRecipe) -> Option<Degrees> {
    match recipe.crease {
        Crease::Angle(angle) => Some(angle),
        Crease::Default if honoured_groups(mesh, recipe).is_some() => None,
        Crease::Default => Some(Crease::DEFAULT_ANGLE),
    }
}
