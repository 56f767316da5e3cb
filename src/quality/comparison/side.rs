//! The corners of a file, numbered through all its parts.

use crate::mesh::{Faces, Mesh, triangulate};

/// Polygons of more corners are only compared from their first corner, and not with triangles.
pub(crate) const MOST_CORNERS: usize = 1024;

/// The corners of all parts of a file, numbered through.
pub(crate) struct Side<'a> {
    meshes: Vec<&'a Mesh>,
    /// The number of the first corner of each part, and of all corners at the end.
    starts: Vec<usize>,
}

impl<'a> Side<'a> {
    pub(crate) fn new(meshes: Vec<&'a Mesh>) -> Self {
        let mut starts = vec![0];
        for mesh in &meshes {
            starts.push(starts[starts.len() - 1] + mesh.faces().corner_count());
        }
        Self { meshes, starts }
    }

    pub(crate) fn corners(&self) -> usize {
        self.starts[self.meshes.len()]
    }

    pub(crate) fn faces(&self) -> usize {
        self.meshes.iter().map(|mesh| mesh.face_count()).sum()
    }

    /// The part of a corner, and its number in that part.
    pub(crate) fn locate(&self, corner: u32) -> (usize, usize) {
        let part = self.starts.partition_point(|&start| start <= corner as usize) - 1;
        (part, corner as usize - self.starts[part])
    }

    /// The bits of a corner's position in single precision, −0 taken as +0.
    pub(crate) fn place(&self, corner: u32) -> [u32; 3] {
        let (part, corner) = self.locate(corner);
        let mesh = self.meshes[part];
        let position = mesh.positions()[mesh.faces().corners()[corner] as usize];
        position.to_array().map(|x| (x as f32 + 0.0).to_bits())
    }

    /// All faces, as lists of corners.
    pub(crate) fn whole(&self) -> Faces {
        let mut faces = Faces::with_capacity(self.corners());
        let mut corners = Vec::new();
        for (mesh, start) in self.meshes.iter().zip(&self.starts) {
            for range in mesh.faces().ranges() {
                corners.clear();
                corners.extend(range.map(|corner| (start + corner) as u32));
                faces.push(&corners);
            }
        }
        faces
    }

    /// The triangles of marked faces, as lists of corners, and the face of each.
    pub(crate) fn triangles(&self, wanted: &[bool]) -> (Faces, Vec<u32>) {
        let (mut corners, mut owners) = (Vec::new(), Vec::new());
        let mut first_face = 0;
        for (mesh, &start) in self.meshes.iter().zip(&self.starts) {
            let cut = triangulate(mesh);
            for (triangle, face) in cut.triangles.iter().zip(cut.source_face) {
                if wanted[first_face + face as usize] {
                    corners.extend(triangle.iter().map(|corner| start as u32 + corner));
                    owners.push((first_face + face as usize) as u32);
                }
            }
            first_face += mesh.face_count();
        }
        (Faces::triangles(corners), owners)
    }
}
