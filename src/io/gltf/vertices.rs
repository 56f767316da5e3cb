//! How the corners of a mesh become the triangles and vertices of a new file.

use crate::io::{Note, Written};
use crate::mesh::{Column, ColumnIndex, Mesh, NONE, VertexSplit, split_vertices, triangulate};
use rayon::prelude::*;
use rustc_hash::FxHashMap;
use std::borrow::Cow;

/// Triangles that become one primitive.
#[derive(Clone, Copy, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub struct Group {
    pub label: u32,
    /// Some corner of its faces has no normal.
    pub flat: bool,
}

/// How the corners of a mesh become triangles and vertices.
pub struct Shape<'a> {
    /// The written vertex of every corner.
    pub vertex_of: Cow<'a, [u32]>,
    /// Corner numbers, three a triangle, and the face of each; `None` if the faces are triangles already.
    triangles: Option<(Vec<u32>, Vec<u32>)>,
    /// `None` if no vertex has to be split. Its `corners` are in `vertex_of`.
    pub split: Option<VertexSplit>,
}

impl<'a> Shape<'a> {
    pub fn new(mesh: &'a Mesh, written: &mut Written) -> Self {
        let columns = mesh.columns();
        let triangles = (!mesh.faces().is_triangles()).then(|| {
            let cut = triangulate(mesh);
            if let Some(first) = cut.failed.first() {
                let text = format!("without area or with crossing edges cut into fans (first: face {first})");
                written.notes.extend(Note::counted(cut.failed.len(), ["polygon", "polygons"], text));
            }
            (cut.triangles.into_flattened(), cut.source_face)
        });
        let normal_keys = columns.normals.as_ref().and_then(corner_keys);
        let uv_keys = columns.uvs.as_ref().and_then(corner_keys);
        let corners = mesh.faces().corners();
        // Values that are stored per corner, but are the same at all corners of a vertex, split none.
        let keys: Vec<&[u32]> =
            normal_keys.into_iter().chain(uv_keys).filter(|&keys| keys != corners).collect();
        if keys.is_empty() {
            return Self { vertex_of: Cow::Borrowed(corners), triangles, split: None };
        }
        let mut split = split_vertices(mesh.vertex_count(), corners, &keys);
        Self { vertex_of: Cow::Owned(std::mem::take(&mut split.corners)), triangles, split: Some(split) }
    }

    pub fn vertex_count(&self, mesh: &Mesh) -> usize {
        self.split.as_ref().map_or(mesh.vertex_count(), |split| split.source.len())
    }

    /// The vertex of the mesh behind a written one.
    pub fn source(&self, vertex: usize) -> usize {
        self.split.as_ref().map_or(vertex, |split| split.source[vertex] as usize)
    }

    /// The value of every written vertex, `default` where no corner has one.
    pub fn values<T: Sync, U: Copy + Send + Sync>(
        &self,
        mesh: &Mesh,
        column: &Column<T>,
        default: U,
        convert: impl Fn(&T) -> U + Send + Sync,
    ) -> Vec<U> {
        match (&self.split, &column.index) {
            (None, ColumnIndex::PerVertex) => column.values.par_iter().map(convert).collect(),
            // Without a split, each corner's value has the number of its vertex.
            (None, ColumnIndex::PerCorner(index)) => {
                let mut used = vec![false; mesh.vertex_count()];
                index.iter().for_each(|&vertex| used[vertex as usize] = true);
                let value = |(v, used)| if used { convert(&column.values[v]) } else { default };
                used.into_par_iter().enumerate().map(value).collect()
            }
            (Some(split), ColumnIndex::PerVertex) => {
                split.source.iter().map(|&v| convert(&column.values[v as usize])).collect()
            }
            (Some(split), ColumnIndex::PerCorner(_)) => {
                let value = |(&sample, &source): (&u32, &u32)| match sample {
                    NONE => default,
                    sample => column.get(sample as usize, source).map_or(default, &convert),
                };
                split.sample.iter().zip(&split.source).map(value).collect()
            }
        }
    }

    /// The corners of the triangles of each primitive; `None` for every corner of the mesh in order.
    pub fn groups(&self, mesh: &Mesh) -> Vec<(Group, Option<Vec<u32>>)> {
        let faces = mesh.face_count();
        if faces == 0 {
            return Vec::new();
        }
        let flat = faces_without_normals(mesh);
        let labels = mesh.columns().materials.as_ref();
        let of_face = |face: u32| Group {
            label: labels.map_or(NONE, |labels| labels.of_face[face as usize]),
            flat: flat.as_ref().is_some_and(|flat| flat[face as usize]),
        };
        let first = of_face(0);
        if (1..faces as u32).all(|face| of_face(face) == first) {
            return vec![(first, self.triangles.as_ref().map(|(corners, _)| corners.clone()))];
        }
        let mut groups: Vec<(Group, Vec<u32>)> = Vec::new();
        let mut numbers: FxHashMap<Group, usize> = FxHashMap::default();
        for triangle in 0..self.triangles.as_ref().map_or(faces, |(_, faces)| faces.len()) {
            let (face, corners) = match &self.triangles {
                None => (triangle as u32, [0, 1, 2].map(|k| (3 * triangle + k) as u32)),
                Some((corners, faces)) => (faces[triangle], [0, 1, 2].map(|k| corners[3 * triangle + k])),
            };
            let group = of_face(face);
            let number = *numbers.entry(group).or_insert_with(|| {
                groups.push((group, Vec::new()));
                groups.len() - 1
            });
            groups[number].1.extend(corners);
        }
        groups.into_iter().map(|(group, corners)| (group, Some(corners))).collect()
    }
}

fn corner_keys<T>(column: &Column<T>) -> Option<&[u32]> {
    match &column.index {
        ColumnIndex::PerVertex => None,
        ColumnIndex::PerCorner(index) => Some(index),
    }
}

/// Which faces have a corner without a normal; `None` if all have all or no normals are there at all.
fn faces_without_normals(mesh: &Mesh) -> Option<Vec<bool>> {
    let index = mesh.columns().normals.as_ref().and_then(corner_keys)?;
    if !index.contains(&NONE) {
        return None;
    }
    Some(mesh.faces().ranges().map(|range| index[range].contains(&NONE)).collect())
}
