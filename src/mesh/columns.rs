//! Optional data of vertices, corners and faces.

use glam::{DVec2, DVec3};

/// In a per-corner index: this corner has no value.
pub const NONE: u32 = u32::MAX;

/// How the corners of a mesh refer to the values of a [`Column`].
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub enum ColumnIndex {
    /// Value `v` belongs to vertex `v`, at all of its corners.
    #[default]
    PerVertex,
    /// One index a corner, [`NONE`] where there is no value.
    PerCorner(Vec<u32>),
}

/// Values shared by corners: authored normals, computed normals, texture coordinates.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Column<T> {
    /// The values, in the order of the file that they came from.
    pub values: Vec<T>,
    /// Which corner has which value.
    pub index: ColumnIndex,
}

impl<T> Column<T> {
    /// One value a vertex.
    pub fn per_vertex(values: Vec<T>) -> Self {
        Self { values, index: ColumnIndex::PerVertex }
    }

    /// Values with one index a corner.
    pub fn per_corner(values: Vec<T>, index: Vec<u32>) -> Self {
        Self { values, index: ColumnIndex::PerCorner(index) }
    }

    /// The number of the value at a corner of a vertex, if it has one.
    #[inline]
    pub fn slot(&self, corner: usize, vertex: u32) -> Option<u32> {
        match &self.index {
            ColumnIndex::PerVertex => Some(vertex),
            ColumnIndex::PerCorner(index) => Some(index[corner]).filter(|&slot| slot != NONE),
        }
    }

    /// The value at a corner of a vertex, if it has one.
    #[inline]
    pub fn get(&self, corner: usize, vertex: u32) -> Option<&T> {
        self.slot(corner, vertex).map(|slot| &self.values[slot as usize])
    }

    /// One index a corner, whatever the storage.
    pub fn corner_index(&self, corner_vertices: &[u32]) -> Vec<u32> {
        match &self.index {
            ColumnIndex::PerVertex => corner_vertices.to_vec(),
            ColumnIndex::PerCorner(index) => index.clone(),
        }
    }
}

/// A label a face, out of a list of names: materials, objects, groups.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct FaceLabels {
    /// The label of each face, [`NONE`] for a face without.
    pub of_face: Vec<u32>,
    /// The names that the labels count.
    pub names: Vec<String>,
}

/// OBJ smoothing groups.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct SmoothingGroups {
    /// The group id of each face; 0 is `s off`. Ids are names, not bit masks.
    pub of_face: Vec<u32>,
    /// How many faces came before the first `s` statement; they count as `off`.
    pub before_first: usize,
}

/// Everything optional of a mesh. Columns that a file does not have are absent, not filled with defaults.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Columns {
    /// The normals that the file had, as stored: not renormalised, possibly wrong.
    pub normals: Option<Column<DVec3>>,
    /// Texture coordinates (the first set), the origin at the lower left of the image as OBJ has it; glTF's are
    /// flipped when read and written.
    pub uvs: Option<Column<DVec2>>,
    /// Linear or sRGB colour and opacity of each vertex, as stored, in 0..=1.
    pub colors: Option<Vec<[f32; 4]>>,
    /// Smoothing groups; present if the file has any smoothing statement at all.
    pub smoothing: Option<SmoothingGroups>,
    /// Material of each face.
    pub materials: Option<FaceLabels>,
    /// Object or group of each face.
    pub objects: Option<FaceLabels>,
    /// Edges to keep sharp, by their two vertices in any order.
    pub hard_edges: Vec<[u32; 2]>,
    /// Displacement of every vertex by each morph target.
    pub morph_targets: Vec<Vec<DVec3>>,
    /// Vertices drawn as points.
    pub points: Vec<u32>,
    /// Vertices of each polyline, two or more.
    pub lines: Vec<Vec<u32>>,
}
