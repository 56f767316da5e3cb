//! Merging vertices at the same position.

use super::columns::{ColumnIndex, Columns};
use super::polygon_mesh::Mesh;
use glam::DVec3;
use rustc_hash::FxHashMap;

/// The bits of a position, with −0 taken as +0: equal for positions that are merged or welded exactly.
pub(crate) fn place_key(p: DVec3) -> [u64; 3] {
    (p + DVec3::ZERO).to_array().map(f64::to_bits)
}

impl Mesh {
    /// The mesh with one vertex for all corners at the same position (to the bit, −0 = +0), numbered in the order of the
    /// corners, without unreferenced vertices. Unchanged if vertices have other attributes than positions.
    pub(crate) fn with_shared_vertices(mut self) -> Self {
        if has_vertex_attributes(&self.columns) {
            return self;
        }
        // The usual number of a closed mesh of triangles.
        let likely = self.faces.corner_count() / 6 + 2;
        let mut known = FxHashMap::with_capacity_and_hasher(likely, rustc_hash::FxBuildHasher);
        let mut positions = Vec::with_capacity(likely);
        let corners = self.faces.corners().iter().map(|&vertex| {
            let position = self.positions[vertex as usize];
            *known.entry(place_key(position)).or_insert_with(|| {
                positions.push(position);
                positions.len() as u32 - 1
            })
        });
        self.faces = self.faces.with_corners(corners.collect()).into();
        self.positions = positions.into();
        self
    }
}

fn has_vertex_attributes(columns: &Columns) -> bool {
    let of_vertices = |index: &ColumnIndex| *index == ColumnIndex::PerVertex;
    columns.normals.as_ref().is_some_and(|normals| of_vertices(&normals.index))
        || columns.uvs.as_ref().is_some_and(|uvs| of_vertices(&uvs.index))
        || columns.colors.is_some()
        || !(columns.hard_edges.is_empty() && columns.morph_targets.is_empty())
        || !(columns.points.is_empty() && columns.lines.is_empty())
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::mesh::{Column, Faces, MeshBuilder};

    fn soup(columns: Columns) -> Mesh {
        let places = [
            [0., 0., 0.],
            [1., 0., 0.],
            [1., 1., 0.],
            [-0., 0., 0.],
            [1., 1., 0.],
            [0., 1., 0.],
            [7., 7., 7.],
        ];
        let positions = places.map(DVec3::from).to_vec();
        let faces = Faces::triangles((0..6).collect());
        MeshBuilder { positions, faces, columns, ..MeshBuilder::default() }.build().unwrap()
    }

    #[test]
    fn corners_at_one_place_share_a_vertex() {
        let normals = Column::per_corner(vec![DVec3::Z, DVec3::X], vec![0, 0, 0, 1, 1, 1]);
        let mesh =
            soup(Columns { normals: Some(normals.clone()), ..Columns::default() }).with_shared_vertices();
        assert_eq!(mesh.faces().corners(), [0, 1, 2, 0, 2, 3]);
        assert_eq!(
            mesh.positions(),
            [[0., 0., 0.], [1., 0., 0.], [1., 1., 0.], [0., 1., 0.]].map(DVec3::from)
        );
        assert_eq!(mesh.columns().normals, Some(normals));
    }

    #[test]
    fn what_vertices_have_keeps_them_separate() {
        let normals = Some(Column::per_vertex(vec![DVec3::Z; 7]));
        for columns in [
            Columns { normals, ..Columns::default() },
            Columns { colors: Some(vec![[1.0; 4]; 7]), ..Columns::default() },
            Columns { points: vec![6], ..Columns::default() },
        ] {
            let mesh = soup(columns);
            assert_eq!(mesh.clone().with_shared_vertices(), mesh);
        }
    }
}
