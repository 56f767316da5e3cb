//! A mesh for a format that stores every value per vertex: vertices are split where corners differ.

use super::options::Merge;
use crate::mesh::{Column, ColumnIndex, Mesh, NONE, SplitView, Storage, VertexSplit, split_vertices};
use std::borrow::Cow;

/// A mesh whose vertices have one value of every column.
pub(super) struct SplitMesh<'a> {
    pub mesh: &'a Mesh,
    /// The written vertex of every corner.
    pub vertex_of: Cow<'a, [u32]>,
    /// `None` if no vertex has to be split. Its `corners` are in `vertex_of`.
    split: Option<VertexSplit>,
    /// Whether faces use a vertex. Filled only if nothing is split, and a column is per corner or normals are absent.
    is_used: Vec<bool>,
}

impl<'a> SplitMesh<'a> {
    /// Splits vertices by texture coordinates, and by normals unless these are written per face; then merges those that agree
    /// where normals are written in a type.
    pub fn new(mesh: &'a Mesh, by_face: bool, (merge, storage): (Merge, Storage)) -> Self {
        let columns = mesh.columns();
        let normals = columns.normals.as_ref().filter(|_| !by_face);
        let corners = mesh.faces().corners();
        let indices = [normals.map(|column| &column.index), columns.uvs.as_ref().map(|column| &column.index)];
        let per_corner = indices.into_iter().filter_map(|index| match index? {
            ColumnIndex::PerVertex => None,
            ColumnIndex::PerCorner(index) => Some(&index[..]),
        });
        let per_corner: Vec<&[u32]> = per_corner.collect();
        // Values that are stored per corner, but are the same at all corners of a vertex, split none.
        let keys: Vec<&[u32]> = per_corner.iter().copied().filter(|&keys| keys != corners).collect();
        let merges = merge.applies_to(mesh);
        if merges || !keys.is_empty() {
            let split = || split_vertices(mesh.vertex_count(), corners, &keys);
            let mut split = match merges {
                true if mesh.is_soup() => mesh.merge_split(SplitView::of_soup(corners), storage),
                true => mesh.merge_split((&split()).into(), storage),
                false => split(),
            };
            let vertex_of = Cow::Owned(std::mem::take(&mut split.corners));
            return Self { mesh, vertex_of, split: Some(split), is_used: Vec::new() };
        }
        let mut is_used = Vec::new();
        if normals.is_none() || !per_corner.is_empty() {
            is_used.resize(mesh.vertex_count(), false);
            corners.iter().for_each(|&vertex| is_used[vertex as usize] = true);
        }
        Self { mesh, vertex_of: Cow::Borrowed(corners), split: None, is_used }
    }

    /// Splits written vertices further, where their corners differ in one more value, which has this number at each corner.
    pub fn refine(&mut self, numbers: &[u32]) {
        let again = split_vertices(self.vertex_count(), &self.vertex_of, &[numbers]);
        if again.is_identity(self.vertex_count()) {
            return;
        }
        let source = again.source.iter().map(|&vertex| self.source(vertex as usize) as u32).collect();
        self.vertex_of = Cow::Owned(again.corners);
        self.split = Some(VertexSplit { source, sample: again.sample, corners: Vec::new() });
    }

    /// Whether the written vertices are those of the mesh.
    pub fn is_identity(&self) -> bool {
        self.split.is_none()
    }

    /// The number of written vertices.
    pub fn vertex_count(&self) -> usize {
        self.split.as_ref().map_or(self.mesh.vertex_count(), |split| split.source.len())
    }

    /// The vertex of the mesh behind a written one.
    pub fn source(&self, vertex: usize) -> usize {
        self.split.as_ref().map_or(vertex, |split| split.source[vertex] as usize)
    }

    /// Whether faces use a written vertex, in a mesh without normals per vertex.
    pub fn is_used(&self, vertex: usize) -> bool {
        self.split.as_ref().map_or_else(|| self.is_used[vertex], |split| split.sample[vertex] != NONE)
    }

    /// The value that a written vertex has of a column.
    pub fn value<'c, T>(&self, column: &'c Column<T>, vertex: usize) -> Option<&'c T> {
        match (&column.index, &self.split) {
            (ColumnIndex::PerVertex, _) => Some(&column.values[self.source(vertex)]),
            // Without a split, each corner's value has the number of its vertex.
            (_, None) => self.is_used[vertex].then(|| &column.values[vertex]),
            (_, Some(split)) => match split.sample[vertex] {
                NONE => None,
                corner => column.get(corner as usize, split.source[vertex]),
            },
        }
    }
}
