//! Dropping and reversing faces.

use super::columns::{Column, ColumnIndex};
use super::faces::Faces;
use super::polygon_mesh::Mesh;

/// Faces of a mesh to drop and to reverse, by their numbers in that mesh.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct FaceEdit {
    /// Faces to drop, ascending.
    pub dropped: Vec<u32>,
    /// Faces to reverse, ascending. The first corner stays the first.
    pub reversed: Vec<u32>,
}

impl FaceEdit {
    /// Whether every face stays unchanged.
    pub fn is_empty(&self) -> bool {
        self.dropped.is_empty() && self.reversed.is_empty()
    }

    /// Whether a face stays.
    pub fn keeps(&self, face: u32) -> bool {
        self.dropped.binary_search(&face).is_err()
    }

    /// Whether a face is reversed.
    pub fn reverses(&self, face: u32) -> bool {
        self.reversed.binary_search(&face).is_ok()
    }

    /// The corners of a mesh in their new order, face by face, as numbers of the old one.
    pub fn corner_order(&self, faces: &Faces) -> (Faces, Vec<u32>) {
        let mut order = Vec::with_capacity(faces.corner_count());
        let mut kept = Faces::with_capacity(faces.corner_count());
        let (mut dropped, mut reversed) = (self.dropped.iter().peekable(), self.reversed.iter().peekable());
        let mut vertices = Vec::new();
        for (face, range) in faces.ranges().enumerate() {
            let reverse = reversed.next_if(|&&f| f as usize == face).is_some();
            if dropped.next_if(|&&f| f as usize == face).is_some() {
                continue;
            }
            let start = order.len();
            order.extend(range.map(|corner| corner as u32));
            if reverse {
                order[start + 1..].reverse();
            }
            vertices.clear();
            vertices.extend(order[start..].iter().map(|&corner| faces.corners()[corner as usize]));
            kept.push(&vertices);
        }
        (kept, order)
    }
}

impl Mesh {
    /// The mesh with faces dropped and reversed; every column follows. Vertices stay, used or not.
    pub fn with_faces(&self, edit: &FaceEdit) -> Mesh {
        if edit.is_empty() {
            return self.clone();
        }
        let (faces, order) = edit.corner_order(&self.faces);
        let kept: Vec<u32> = (0..self.faces.len() as u32).filter(|&face| edit.keeps(face)).collect();
        let of_face = |values: &mut Vec<u32>| *values = kept.iter().map(|&f| values[f as usize]).collect();
        let mut columns = self.columns.clone();
        if let Some(normals) = &mut columns.normals {
            reorder(normals, &order);
        }
        if let Some(uvs) = &mut columns.uvs {
            reorder(uvs, &order);
        }
        if let Some(smoothing) = &mut columns.smoothing {
            of_face(&mut smoothing.of_face);
            smoothing.before_first = kept.partition_point(|&face| (face as usize) < smoothing.before_first);
        }
        for labels in [&mut columns.materials, &mut columns.objects].into_iter().flatten() {
            of_face(&mut labels.of_face);
        }
        Mesh { positions: self.positions.clone(), faces: faces.into(), columns }
    }

    /// The mesh with other normals.
    pub fn with_normals(mut self, normals: Option<Column<glam::DVec3>>) -> Mesh {
        if let Some(Column { index: ColumnIndex::PerCorner(index), .. }) = &normals {
            assert_eq!(index.len(), self.faces.corner_count(), "one normal index a corner");
        }
        self.columns.normals = normals;
        self
    }
}

fn reorder<T>(column: &mut Column<T>, order: &[u32]) {
    if let ColumnIndex::PerCorner(index) = &mut column.index {
        *index = order.iter().map(|&corner| index[corner as usize]).collect();
    }
}
