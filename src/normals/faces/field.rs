//! Normals of faces, for those who need them before they know by which recipe those of corners are computed.

use crate::mesh::{Mesh, Topology};
use crate::normals::faces::face_normals::FaceNormals;
use crate::normals::faces::face_normals::face_normals;
use crate::normals::faces::positions::Positions;
use crate::normals::fallback::fallback_normals::{FallbackNormals, face_faults};
use crate::normals::fault::Fault;
use crate::normals::recipe::Slivers;
use glam::DVec3;

/// The normals of the faces of a mesh, as [`compute_on`](crate::normals::compute_on) gives them.
#[derive(Clone, Debug, Default)]
pub(crate) struct FaceField {
    faces: FaceNormals,
    /// The faces without a direction, whose normals are made up.
    fallbacks: Vec<u32>,
}

impl FaceField {
    /// Of a mesh unchanged, faithful.
    pub(crate) fn new(mesh: &Mesh, topology: &Topology) -> Self {
        let positions = Positions::F64(mesh.positions(), mesh.storage());
        Self::with_fallbacks(mesh, topology, face_normals(mesh.faces().view(), positions))
    }

    /// Adds fallback normals for faces without a direction.
    pub(in crate::normals) fn with_fallbacks(
        mesh: &Mesh,
        topology: &Topology,
        mut faces: FaceNormals,
    ) -> Self {
        let fallbacks = FallbackNormals::new(mesh.faces().view(), topology, &faces);
        let undefined = (0..faces.unit.len() as u32).filter(|&face| faces.unit[face as usize] == DVec3::ZERO);
        let (fallbacks, normals): (Vec<u32>, Vec<DVec3>) =
            undefined.map(|face| (face, fallbacks.for_face(face))).unzip();
        for (&face, normal) in fallbacks.iter().zip(normals) {
            faces.unit[face as usize] = normal;
        }
        Self { faces, fallbacks }
    }

    /// The unit normal of every face.
    pub(crate) fn units(&self) -> &[DVec3] {
        &self.faces.unit
    }

    /// The same for keeps.
    pub(in crate::normals) fn into_units(self) -> Vec<DVec3> {
        self.faces.unit
    }

    /// What is wrong with faces.
    pub(crate) fn faults(&self) -> Vec<Fault> {
        face_faults(&self.faces, Slivers::default())
    }

    /// The zero vector where there is no direction.
    pub(in crate::normals) fn into_computed(mut self) -> FaceNormals {
        for face in self.fallbacks {
            self.faces.unit[face as usize] = DVec3::ZERO;
        }
        self.faces
    }
}
