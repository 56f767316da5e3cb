//! A polygon mesh and its topology (layer 1).

mod box_tree;
mod build;
mod column;
mod edges;
mod faces;
mod near;
mod obstacles;
mod orient;
mod rings;
mod select;
mod sets;
mod share;
mod side;
mod split;
mod topology;
mod transform;
mod triangulate;
mod weld;

pub use build::{MeshBuilder, MeshError};
pub use column::{Column, ColumnIndex, Columns, FaceLabels, NONE, SmoothingGroups};
pub(crate) use edges::EdgeMatcher;
pub use faces::Faces;
pub(crate) use faces::{FacesRef, next_in_triangle, previous_in_triangle};
pub(crate) use obstacles::Obstacles;
pub use orient::{Confidence, Orient, Orientation, orient};
pub(crate) use orient::{Orientations, Placed, cavities};
pub(crate) use rings::{Rings, Scatter};
pub use select::FaceEdit;
pub(crate) use sets::DisjointSets;
pub(crate) use side::{are_same, normals_oppose, stored_unit, vector_area};
pub use split::{VertexSplit, split_vertices};
pub(crate) use topology::MAX_CORNERS;
pub use topology::{Link, Topology};
pub use transform::{NormalMatrix, TransformFault, normal_matrix};
pub use triangulate::{Triangulation, triangulate};
pub use weld::Weld;
pub(crate) use weld::place_key;

use glam::DVec3;
use std::sync::Arc;

/// The precision that positions had where they came from. It sets the height below which the direction of a
/// face is noise of the file's own rounding.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub enum Storage {
    /// Every coordinate is an `f32` value: binary STL, glTF, PLY `float` and integers, and text that spells the
    /// shortest decimals of such values.
    F32,
    /// Doubles, or other decimal text.
    #[default]
    F64,
}

/// A polygon mesh: positions, faces of three corners or more, and optional [`Columns`].
///
/// Built by [`MeshBuilder`], which checks once that every corner's vertex exists, that each face has three
/// corners or more, that positions are finite and that columns fit. Degenerate *geometry* is allowed: two
/// corners may be the same vertex, a face may have no area.
///
/// Clones share positions and faces: what changes a mesh gives a new one.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Mesh {
    positions: Arc<Vec<DVec3>>,
    storage: Storage,
    faces: Arc<Faces>,
    columns: Columns,
}

impl Mesh {
    /// Position of every vertex.
    pub fn positions(&self) -> &[DVec3] {
        &self.positions
    }

    /// The precision that the positions came with.
    pub fn storage(&self) -> Storage {
        self.storage
    }

    /// The faces.
    pub fn faces(&self) -> &Faces {
        &self.faces
    }

    /// Everything optional.
    pub fn columns(&self) -> &Columns {
        &self.columns
    }

    /// The number of vertices, referenced or not.
    pub fn vertex_count(&self) -> usize {
        self.positions.len()
    }

    /// The number of faces.
    pub fn face_count(&self) -> usize {
        self.faces.len()
    }

    /// Smallest and largest corner of the bounding box; `None` without vertices.
    pub fn bounds(&self) -> Option<(DVec3, DVec3)> {
        let first = *self.positions.first()?;
        Some(self.positions.iter().fold((first, first), |(low, high), &p| (low.min(p), high.max(p))))
    }
}
