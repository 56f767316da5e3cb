//! Normals by least-squares quadrics at some corners, from the faces round them alone: at all they would cost many times what the
//! rest of a diagnosis does.

use crate::mesh::{Columns, Faces, Mesh, MeshBuilder, SmoothingGroups, Topology, Weld};
use crate::normals::{Crease, Groups, NormalRecipe, Weight, compute_on};
use crate::num::Degrees;
use crate::quality::estimate::means::{Smoothness, walk};
use crate::quality::facts::Facts;
use glam::DVec3;
use rayon::prelude::*;

/// Corners on the way round a vertex to either side, beyond which it is a pole and left out: its neighbours reach all of them.
const POLE: usize = 128;

/// Some corners of a mesh with all faces that fits there look at, as a mesh of its own.
pub(in crate::quality) struct Patch {
    mesh: Mesh,
    topology: Topology,
    /// Those of the corners that are at no pole nor beside one, as places in the list of all, and their numbers in the patch.
    corners: Vec<(usize, usize)>,
}

impl Patch {
    pub(in crate::quality) fn around(facts: &Facts<'_>, corners: &[u32]) -> Self {
        // A fit takes the two-ring, and its neighbours' means bear it out: all of the faces at the corners of the faces round it.
        let around: Vec<Option<Vec<u32>>> =
            corners.par_iter().map(|&corner| two_rings(facts, corner)).collect();
        let mut faces: Vec<u32> = around.iter().flatten().flatten().copied().collect();
        faces.sort_unstable();
        faces.dedup();
        let mesh = some_faces(facts.mesh, &faces);
        let in_patch = |corner: u32| {
            let face = facts.topology.face_of(corner);
            let own = faces.binary_search(&face).expect("a corner's own face is round it");
            mesh.faces().range(own).start + corner as usize - facts.mesh.faces().range(face as usize).start
        };
        let reported = around.iter().zip(corners).enumerate().filter(|(_, (faces, _))| faces.is_some());
        let corners = reported.map(|(i, (_, &corner))| (i, in_patch(corner))).collect();
        Self { topology: Topology::build(&mesh, Weld::Exact), mesh, corners }
    }

    /// The places in the list of all of those corners that have a normal here.
    pub(in crate::quality) fn places(&self) -> impl Iterator<Item = usize> {
        self.corners.iter().map(|&(place, _)| place)
    }

    /// The normals at these that `crease normals --weight quadric` would give.
    pub(in crate::quality) fn normals(&self, crease: Degrees, groups: bool) -> Vec<DVec3> {
        let recipe = NormalRecipe {
            weight: Weight::Quadric,
            crease: Crease::Angle(crease),
            groups: if groups { Groups::Honour } else { Groups::Ignore },
            ..NormalRecipe::default()
        };
        let field = compute_on(&self.mesh, &self.topology, &recipe);
        let vertices = self.mesh.faces().corners();
        let normal =
            |&(_, corner): &(usize, usize)| *field.normals.get(corner, vertices[corner]).expect("all");
        self.corners.iter().map(normal).collect()
    }
}

/// The faces at all corners of the faces round a vertex, ascending; `None` where too many meet.
fn two_rings(facts: &Facts<'_>, corner: u32) -> Option<Vec<u32>> {
    let round = |corner: u32| {
        let mut faces = Vec::new();
        let add = |corner| faces.push(facts.topology.face_of(corner));
        walk(facts, corner, Smoothness::new(Degrees(180.0), None), POLE, add).then_some(faces)
    };
    let mut all = Vec::new();
    for face in round(corner)? {
        for corner in facts.mesh.faces().range(face as usize) {
            all.extend(round(corner as u32)?);
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
    let positions = vertices.iter().map(|&vertex| mesh.positions()[vertex as usize]).collect();
    let columns = Columns { smoothing, ..Columns::default() };
    let builder = MeshBuilder { positions, storage: mesh.storage(), faces, columns };
    builder.build().expect("a part of a mesh is a mesh")
}
