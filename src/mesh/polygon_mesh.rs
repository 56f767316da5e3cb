//! The polygon mesh, and the builder that checks its parts once.

use super::columns::{ColumnIndex, Columns, NONE};
use super::faces::Faces;
use super::link::MAX_CORNERS;
use super::positions::{Positions, PositionsRef, Storage};
use crate::num::parallel;
use glam::DVec3;
use std::sync::Arc;

/// A polygon mesh: positions, faces of three corners or more, and optional [`Columns`].
///
/// Built by [`MeshBuilder`], which checks once that every corner's vertex exists, that each face has three
/// corners or more, that positions are finite and that columns fit. Degenerate *geometry* is allowed: two
/// corners may be the same vertex, a face may have no area.
///
/// Positions are `f32` or `f64`, as they came in. [`Mesh::positions`] is a view of either, which widens a position when it is
/// read; [`PositionsRef`] explains how loops use it.
///
/// Clones share positions and faces: operations that change a mesh return a new one.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Mesh {
    pub(super) positions: Arc<Positions>,
    pub(super) faces: Arc<Faces>,
    pub(super) columns: Columns,
}

impl Mesh {
    /// A mesh without columns.
    ///
    /// # Errors
    /// As [`MeshBuilder::build`].
    pub fn new(positions: impl Into<Positions>, faces: Faces) -> Result<Self, MeshError> {
        MeshBuilder { positions: positions.into(), faces, ..MeshBuilder::default() }.build()
    }

    /// Position of every vertex, in the type that positions came in.
    #[inline]
    pub fn positions(&self) -> PositionsRef<'_> {
        self.positions.view()
    }

    /// Position of one vertex.
    #[inline]
    pub(crate) fn position(&self, vertex: u32) -> DVec3 {
        self.positions().at(vertex)
    }

    /// The precision that the positions came with.
    pub fn storage(&self) -> Storage {
        self.positions.storage()
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
        self.positions().len()
    }

    /// The number of faces.
    pub fn face_count(&self) -> usize {
        self.faces.len()
    }

    /// The longest side of the bounding box; 0 without vertices.
    pub(crate) fn extent(&self) -> f64 {
        self.bounds().map_or(0.0, |(low, high)| (high - low).max_element())
    }

    /// Smallest and largest corner of the bounding box; `None` without vertices.
    pub fn bounds(&self) -> Option<(DVec3, DVec3)> {
        let first = self.positions().iter().next()?;
        Some(self.positions().iter().fold((first, first), |(low, high), p| (low.min(p), high.max(p))))
    }
}

/// Why raw data do not make a [`Mesh`].
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum MeshError {
    /// A corner refers to a vertex that does not exist.
    #[error("face {face} refers to vertex {vertex}, but there are only {count}")]
    VertexOutOfRange {
        /// The face, counted from 0.
        face: usize,
        /// The vertex that it refers to, counted from 0.
        vertex: u32,
        /// How many vertices there are.
        count: usize,
    },
    /// A face with one or two corners.
    #[error("face {face} has {corners} corners; a face needs 3")]
    TooFewCorners {
        /// The face, counted from 0.
        face: usize,
        /// How many corners it has.
        corners: usize,
    },
    /// A position that is infinite or not a number.
    #[error("vertex {vertex} has the position ({}, {}, {}), which is not finite", .position.x, .position.y, .position.z)]
    NonFinite {
        /// The vertex, counted from 0.
        vertex: usize,
        /// Its position.
        position: DVec3,
    },
    /// A column whose length does not fit the mesh.
    #[error("the column of {what} has {found} entries; {expected} were expected")]
    ColumnLength {
        /// Which column.
        what: &'static str,
        /// Entries found.
        found: usize,
        /// Entries needed.
        expected: usize,
    },
    /// A column index past the column's values.
    #[error("a corner refers to {what} number {index}, but there are only {count}")]
    ColumnIndex {
        /// Which column.
        what: &'static str,
        /// The index found, counted from 0.
        index: u32,
        /// How many values there are.
        count: usize,
    },
    /// More vertices than 2³² − 1, or more corners than 2³⁰.
    #[error("the mesh has {count} {what}, more than this program can count")]
    TooLarge {
        /// What is counted.
        what: &'static str,
        /// How many.
        count: usize,
    },
}

/// Raw parts of a mesh, checked by [`MeshBuilder::build`].
///
/// ```
/// use crease::mesh::{Faces, MeshBuilder};
/// use glam::DVec3;
///
/// let mesh = MeshBuilder {
///     positions: vec![DVec3::ZERO, DVec3::X, DVec3::Y].into(),
///     faces: Faces::triangles(vec![0, 1, 2]),
///     ..MeshBuilder::default()
/// }
/// .build()?;
/// assert_eq!(mesh.face_count(), 1);
/// # Ok::<(), crease::mesh::MeshError>(())
/// ```
#[derive(Clone, Debug, Default)]
pub struct MeshBuilder {
    /// Position of every vertex; a vector becomes this by `into`, an iterator by `collect`.
    pub positions: Positions,
    /// The faces.
    pub faces: Faces,
    /// Everything optional.
    pub columns: Columns,
}

impl MeshBuilder {
    /// Checks everything and makes the mesh.
    ///
    /// # Errors
    /// The first [`MeshError`] met, in the order vertices, faces, columns.
    pub fn build(self) -> Result<Mesh, MeshError> {
        if let Some(vertex) = self.positions.view().first_non_finite() {
            return Err(MeshError::NonFinite { vertex, position: self.positions.view().at(vertex as u32) });
        }
        self.check_faces()?;
        self.check_columns()?;
        let Self { positions, faces, columns } = self;
        Ok(Mesh { positions: positions.into(), faces: faces.into(), columns })
    }

    /// As [`build`](Self::build), but drops the faces that use a vertex without a finite position instead of
    /// failing, and puts such vertices at the origin. Returns the dropped faces, as numbers of the input.
    ///
    /// # Errors
    /// As [`build`](Self::build), except `NonFinite`.
    pub fn build_dropping_non_finite(mut self) -> Result<(Mesh, Vec<u32>), MeshError> {
        self.check_faces()?;
        self.check_columns()?;
        let bad: Vec<bool> = self.positions.view().iter().map(|p| !p.is_finite()).collect();
        let dropped: Vec<u32> = (0..self.faces.len() as u32)
            .filter(|&face| self.faces.face(face as usize).iter().any(|&v| bad[v as usize]))
            .collect();
        for (vertex, _) in bad.iter().enumerate().filter(|(_, bad)| **bad) {
            self.positions.clear(vertex);
        }
        let mesh = self.build()?;
        Ok((mesh, dropped))
    }

    fn check_faces(&self) -> Result<(), MeshError> {
        // `NONE` marks absence in indices, so the last usable vertex is one below it.
        let limits = [
            ("vertices", self.positions.view().len(), NONE as usize),
            ("corners", self.faces.corner_count(), MAX_CORNERS),
        ];
        if let Some(&(what, count, _)) = limits.iter().find(|(_, count, limit)| count > limit) {
            return Err(MeshError::TooLarge { what, count });
        }
        let count = self.positions.view().len();
        if !self.faces.is_triangles()
            && let Some(face) = self.faces.ranges().position(|range| range.len() < 3)
        {
            return Err(MeshError::TooFewCorners { face, corners: self.faces.range(face).len() });
        }
        if let Some(corner) = parallel::position(self.faces.corners(), |&v| v as usize >= count) {
            let face = self.faces.ranges().position(|range| range.contains(&corner)).unwrap_or(0);
            return Err(MeshError::VertexOutOfRange { face, vertex: self.faces.corners()[corner], count });
        }
        Ok(())
    }

    fn check_columns(&self) -> Result<(), MeshError> {
        let (vertices, faces) = (self.positions.view().len(), self.faces.len());
        let columns = &self.columns;
        if let Some(normals) = &columns.normals {
            self.check_column("normals", &normals.index, normals.values.len())?;
        }
        if let Some(uvs) = &columns.uvs {
            self.check_column("texture coordinates", &uvs.index, uvs.values.len())?;
        }
        if let Some(colors) = &columns.colors {
            check_length("vertex colours", colors.len(), vertices)?;
        }
        if let Some(smoothing) = &columns.smoothing {
            check_length("smoothing groups", smoothing.of_face.len(), faces)?;
        }
        for (what, labels) in [("materials", &columns.materials), ("objects", &columns.objects)] {
            let Some(labels) = labels else { continue };
            check_length(what, labels.of_face.len(), faces)?;
            check_indices(what, labels.of_face.iter().filter(|&&label| label != NONE), labels.names.len())?;
        }
        for target in &columns.morph_targets {
            check_length("morph target displacements", target.len(), vertices)?;
        }
        let edges_and_points = columns.hard_edges.iter().flatten().chain(&columns.points);
        check_indices("vertices", edges_and_points.chain(columns.lines.iter().flatten()), vertices)
    }

    fn check_column(&self, what: &'static str, index: &ColumnIndex, count: usize) -> Result<(), MeshError> {
        match index {
            ColumnIndex::PerVertex => check_length(what, count, self.positions.view().len()),
            ColumnIndex::PerCorner(index) => {
                check_length(what, index.len(), self.faces.corner_count())?;
                check_indices(what, index.iter().filter(|&&i| i != NONE), count)
            }
        }
    }
}

fn check_length(what: &'static str, found: usize, expected: usize) -> Result<(), MeshError> {
    if found == expected { Ok(()) } else { Err(MeshError::ColumnLength { what, found, expected }) }
}

fn check_indices<'a>(
    what: &'static str,
    mut indices: impl Iterator<Item = &'a u32>,
    count: usize,
) -> Result<(), MeshError> {
    match indices.find(|&&index| index as usize >= count) {
        Some(&index) => Err(MeshError::ColumnIndex { what, index, count }),
        None => Ok(()),
    }
}
