//! Normals by least-squares quadrics at sample corners, from the faces around these only: at all corners they would cost many
//! times as much as the rest of a diagnosis.

use crate::mesh::{Columns, Faces, Mesh, MeshBuilder, SmoothingGroups, Topology, Weld};
use crate::normals::{Crease, Groups, NormalRecipe, Weight, compute_on};
use crate::num::Degrees;
use crate::num::parallel;
use crate::quality::estimate::means::{Smoothness, walk};
use crate::quality::input::part::Part;
use glam::DVec3;

/// The most corners on either side around a vertex. Poles of more are omitted: all their neighbours reach all of them.
const POLE: usize = 128;

/// Some corners of a mesh with all faces that fits there need, as a mesh of its own.
pub(crate) struct Patch {
    mesh: Mesh,
    topology: Topology,
    /// The corners that are neither at a pole nor next to one: the index in the list of all, and the number in the patch.
    corners: Vec<(usize, usize)>,
}

impl Patch {
    pub(crate) fn around(part: &Part<'_>, corners: &[u32]) -> Self {
        // A fit needs the two-ring and the means of its vertices.
        let around = parallel::map_each(corners, |&corner| two_rings(part, corner));
        let mut faces: Vec<u32> = around.iter().flatten().flatten().copied().collect();
        faces.sort_unstable();
        faces.dedup();
        let mesh = some_faces(part.mesh, &faces);
        let in_patch = |corner: usize| {
            let face = part.face_of(corner);
            let own = faces.binary_search(&(face as u32)).expect("a corner's own face is around it");
            mesh.faces().range(own).start + corner - part.corners_of(face).start
        };
        let usable = around.iter().zip(corners).enumerate().filter(|(_, (faces, _))| faces.is_some());
        let corners = usable.map(|(i, (_, &corner))| (i, in_patch(corner as usize))).collect();
        Self { topology: Topology::build(&mesh, Weld::Exact), mesh, corners }
    }

    /// The indices of the corners that have a normal here, in the list of all.
    pub(crate) fn indices(&self) -> impl Iterator<Item = usize> {
        self.corners.iter().map(|&(index, _)| index)
    }

    pub(crate) fn normals(&self, crease: Degrees, groups: bool) -> Vec<DVec3> {
        self.normals_by(Weight::Quadric, crease, groups)
    }

    /// Whether at least half of the corners have a fit. On coarse shapes most have the angle mean, which is no sign of quadrics.
    pub(crate) fn is_fitted(&self, crease: Degrees, groups: bool) -> bool {
        let [fits, means] = [Weight::Quadric, Weight::Angle].map(|it| self.normals_by(it, crease, groups));
        let fitted = fits.iter().zip(&means).filter(|(fit, mean)| fit != mean).count();
        2 * fitted >= fits.len()
    }

    fn normals_by(&self, weight: Weight, crease: Degrees, groups: bool) -> Vec<DVec3> {
        let recipe = NormalRecipe {
            weight,
            crease: Crease::Angle(crease),
            groups: if groups { Groups::Honour } else { Groups::Ignore },
            ..NormalRecipe::default()
        };
        let field = compute_on(&self.mesh, &self.topology, &recipe);
        let vertices = self.mesh.faces().corners();
        let normal = |corner: usize| *field.normals.get(corner, vertices[corner]).expect("all");
        self.corners.iter().map(|&(_, corner)| normal(corner)).collect()
    }
}

/// The faces at all corners of the faces around a vertex, ascending; `None` where too many meet.
fn two_rings(part: &Part<'_>, corner: u32) -> Option<Vec<u32>> {
    let around = |corner: u32| {
        let mut faces = Vec::new();
        let add = |corner| faces.push(part.topology.face_of(corner));
        walk(part, corner, Smoothness::new(Degrees(180.0), None), POLE, add).then_some(faces)
    };
    let mut all = Vec::new();
    for face in around(corner)? {
        for corner in part.corners_of(face as usize) {
            all.extend(around(corner as u32)?);
        }
    }
    all.sort_unstable();
    all.dedup();
    Some(all)
}

/// A mesh of some faces of another, with their smoothing groups.
fn some_faces(mesh: &Mesh, chosen: &[u32]) -> Mesh {
    let all = mesh.faces();
    let mut vertices: Vec<u32> = chosen.iter().flat_map(|&face| all.face(face as usize)).copied().collect();
    vertices.sort_unstable();
    vertices.dedup();
    let number = |vertex: &u32| vertices.binary_search(vertex).expect("it is one of them") as u32;
    let mut faces = Faces::new();
    for &face in chosen {
        faces.push(&all.face(face as usize).iter().map(number).collect::<Vec<_>>());
    }
    let smoothing = mesh.columns().smoothing.as_ref().map(|groups| SmoothingGroups {
        of_face: chosen.iter().map(|&face| groups.of_face[face as usize]).collect(),
        before_first: 0,
    });
    let positions = mesh.positions().gather(&vertices);
    let columns = Columns { smoothing, ..Columns::default() };
    let builder = MeshBuilder { positions, faces, columns };
    builder.build().expect("a part of a mesh is a mesh")
}
