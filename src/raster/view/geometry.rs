//! The form of an object: faces, vertices and normals, whatever arrays they come in.

use crate::mesh::Mesh;
use crate::normals::NormalField;
use crate::raster::scene::{Shape, Triangles};
use crate::raster::view::project::Points;
use glam::DVec3;
use rayon::prelude::*;

impl<'a> Shape<'a> {
    /// How many faces there are; an analytic surface has none.
    pub fn face_count(&self) -> usize {
        match self {
            Shape::Mesh { mesh, .. } => mesh.face_count(),
            Shape::Triangles(triangles) => triangles.triangles.len(),
            Shape::Surface(_) => 0,
        }
    }

    /// The vertices of a face.
    pub(crate) fn face(&self, face: u32) -> &'a [u32] {
        match *self {
            Shape::Mesh { mesh, .. } => mesh.faces().face(face as usize),
            Shape::Triangles(triangles) => &triangles.triangles[face as usize],
            Shape::Surface(_) => &[],
        }
    }

    /// The vertices of each face.
    pub(crate) fn faces(&self) -> impl Iterator<Item = &'a [u32]> {
        (0..self.face_count() as u32).map(|face| self.face(face))
    }

    /// The edges of the faces, each once: two vertices, the lower one first, in ascending order.
    pub fn edges(&self) -> Vec<[u32; 2]> {
        self.edges_of(|_| true)
    }

    /// The edges of those faces that are wanted, by their numbers; likewise.
    pub(crate) fn edges_of(&self, wanted: impl Fn(usize) -> bool) -> Vec<[u32; 2]> {
        let faces = || self.faces().enumerate().filter(|&(number, _)| wanted(number)).map(|(_, face)| face);
        // As many as there are corners, before each is left once: no room is taken twice.
        let mut edges = Vec::with_capacity(faces().map(<[u32]>::len).sum());
        for face in faces() {
            let next = face.iter().cycle().skip(1);
            edges.extend(face.iter().zip(next).map(|(&a, &b)| [a.min(b), a.max(b)]));
        }
        edges.par_sort_unstable();
        edges.dedup();
        edges.shrink_to_fit();
        edges
    }

    /// Where the vertices are; an analytic surface has none.
    pub(crate) fn points(&self) -> Option<Points<'a>> {
        match *self {
            Shape::Mesh { mesh, .. } => Some(Points::F64(mesh.positions())),
            Shape::Triangles(triangles) => Some(Points::F32(triangles.positions)),
            Shape::Surface(_) => None,
        }
    }

    /// Where a vertex is, in the object's own space; the origin for an analytic surface, which has none.
    ///
    /// # Panics
    /// If there is no vertex of this number.
    pub fn point(&self, vertex: u32) -> DVec3 {
        self.points().map_or(DVec3::ZERO, |points| points.get(vertex))
    }

    /// The normals of vertices; an analytic surface has none.
    pub(crate) fn normals(&self) -> Points<'a> {
        match *self {
            Shape::Mesh { normals, .. } => Points::F64(&normals.normals.values),
            Shape::Triangles(triangles) => Points::F32(triangles.normals),
            Shape::Surface(_) => Points::F64(&[]),
        }
    }

    /// The normals of faces: of all, or of none.
    pub(crate) fn face_normals(&self) -> Points<'a> {
        match *self {
            Shape::Mesh { normals, .. } => Points::F64(&normals.face_normals),
            Shape::Triangles(triangles) => Points::F32(triangles.face_normals),
            Shape::Surface(_) => Points::F64(&[]),
        }
    }

    /// The vertices with the numbers of their normals, in ascending order, each pair once: several for a vertex where smooth
    /// groups meet, of a mesh none for one that no face uses. What [`LinePath::VertexNormals`](crate::raster::LinePath::VertexNormals) takes.
    ///
    /// ```
    /// use crease::raster::{Shape, Triangles};
    ///
    /// let positions = [[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0]];
    /// let triangles = Triangles { positions: &positions, triangles: &[[0, 1, 2]], normals: &[[0.0, 0.0, 1.0]; 3], face_normals: &[] };
    /// assert_eq!(Shape::Triangles(triangles).vertex_normals(), [[0, 0], [1, 1], [2, 2]]);
    /// ```
    pub fn vertex_normals(&self) -> Vec<[u32; 2]> {
        match *self {
            Shape::Mesh { mesh, normals } => normals_in_use(mesh, normals),
            Shape::Triangles(Triangles { normals, .. }) => {
                (0..normals.len() as u32).map(|n| [n, n]).collect()
            }
            Shape::Surface(_) => Vec::new(),
        }
    }
}

fn normals_in_use(mesh: &Mesh, normals: &NormalField) -> Vec<[u32; 2]> {
    let corners = mesh.faces().corners();
    let mut pairs = Vec::with_capacity(corners.len());
    let slot = |(corner, &vertex): (usize, &u32)| Some([vertex, normals.normals.slot(corner, vertex)?]);
    pairs.extend(corners.iter().enumerate().filter_map(slot));
    pairs.par_sort_unstable();
    pairs.dedup();
    pairs.shrink_to_fit();
    pairs
}
