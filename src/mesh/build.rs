//! The one place where a mesh is checked.

use super::topology::MAX_CORNERS;
use super::{ColumnIndex, Columns, Faces, Mesh, NONE, Storage};
use glam::DVec3;
use rayon::prelude::*;

/// Why raw data do not make a [`Mesh`].
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum MeshError {
    /// A corner names a vertex that is not there.
    #[error("face {face} refers to vertex {vertex}, but there are only {count}")]
    VertexOutOfRange {
        /// The face, counted from 0.
        face: usize,
        /// The vertex that it asks for, counted from 0.
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
        /// What it holds.
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
        /// What there is too much of.
        what: &'static str,
        /// How much.
        count: usize,
    },
}

/// Raw parts of a mesh, checked by [`MeshBuilder::build`].
///
/// ```
/// use crease::mesh::{Faces, MeshBuilder, Storage};
/// use glam::DVec3;
///
/// let mesh = MeshBuilder {
///     positions: vec![DVec3::ZERO, DVec3::X, DVec3::Y],
///     faces: Faces::triangles(vec![0, 1, 2]),
///     ..MeshBuilder::default()
/// }
/// .build()?;
/// assert_eq!(mesh.face_count(), 1);
/// # Ok::<(), crease::mesh::MeshError>(())
/// ```
#[derive(Clone, Debug, Default)]
pub struct MeshBuilder {
    /// Position of every vertex.
    pub positions: Vec<DVec3>,
    /// The precision that the positions came with.
    pub storage: Storage,
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
        if let Some(vertex) = self.positions.par_iter().position_first(|p| !p.is_finite()) {
            return Err(MeshError::NonFinite { vertex, position: self.positions[vertex] });
        }
        self.check_faces()?;
        self.check_columns()?;
        let Self { positions, storage, faces, columns } = self;
        Ok(Mesh { positions: positions.into(), storage, faces: faces.into(), columns })
    }

    /// As [`build`](Self::build), but drops the faces that use a vertex without a finite position instead of
    /// failing, and puts such vertices at the origin. Returns the dropped faces, as numbers of the input.
    ///
    /// # Errors
    /// As [`build`](Self::build), except `NonFinite`.
    pub fn build_dropping_non_finite(mut self) -> Result<(Mesh, Vec<u32>), MeshError> {
        self.check_faces()?;
        self.check_columns()?;
        let bad: Vec<bool> = self.positions.iter().map(|p| !p.is_finite()).collect();
        let dropped: Vec<u32> = (0..self.faces.len() as u32)
            .filter(|&face| self.faces.face(face as usize).iter().any(|&v| bad[v as usize]))
            .collect();
        for (position, _) in self.positions.iter_mut().zip(&bad).filter(|(_, bad)| **bad) {
            *position = DVec3::ZERO;
        }
        let mesh = self.build()?;
        Ok((mesh, dropped))
    }

    fn check_faces(&self) -> Result<(), MeshError> {
        // `NONE` marks absence in indices, so the last usable vertex is one below it.
        let limits = [
            ("vertices", self.positions.len(), NONE as usize),
            ("corners", self.faces.corner_count(), MAX_CORNERS),
        ];
        if let Some(&(what, count, _)) = limits.iter().find(|(_, count, limit)| count > limit) {
            return Err(MeshError::TooLarge { what, count });
        }
        let count = self.positions.len();
        if !self.faces.is_triangles()
            && let Some(face) = self.faces.ranges().position(|range| range.len() < 3)
        {
            return Err(MeshError::TooFewCorners { face, corners: self.faces.range(face).len() });
        }
        if let Some(corner) = self.faces.corners().par_iter().position_first(|&v| v as usize >= count) {
            let face = self.faces.ranges().position(|range| range.contains(&corner)).unwrap_or(0);
            return Err(MeshError::VertexOutOfRange { face, vertex: self.faces.corners()[corner], count });
        }
        Ok(())
    }

    fn check_columns(&self) -> Result<(), MeshError> {
        let (vertices, faces) = (self.positions.len(), self.faces.len());
        let columns = &self.columns;
        let length = |what, found, expected| {
            if found == expected { Ok(()) } else { Err(MeshError::ColumnLength { what, found, expected }) }
        };
        if let Some(normals) = &columns.normals {
            self.check_index("normals", &normals.index, normals.values.len())?;
        }
        if let Some(uvs) = &columns.uvs {
            self.check_index("texture coordinates", &uvs.index, uvs.values.len())?;
        }
        if let Some(colors) = &columns.colors {
            length("vertex colours", colors.len(), vertices)?;
        }
        if let Some(smoothing) = &columns.smoothing {
            length("smoothing groups", smoothing.of_face.len(), faces)?;
        }
        for (what, labels) in [("materials", &columns.materials), ("objects", &columns.objects)] {
            let Some(labels) = labels else { continue };
            length(what, labels.of_face.len(), faces)?;
            let count = labels.names.len();
            if let Some(&index) = labels.of_face.iter().find(|&&l| l != NONE && l as usize >= count) {
                return Err(MeshError::ColumnIndex { what, index, count });
            }
        }
        for target in &columns.morph_targets {
            length("morph target displacements", target.len(), vertices)?;
        }
        let loose =
            columns.hard_edges.iter().flatten().chain(&columns.points).chain(columns.lines.iter().flatten());
        for &index in loose {
            if index as usize >= vertices {
                return Err(MeshError::ColumnIndex { what: "vertices", index, count: vertices });
            }
        }
        Ok(())
    }

    fn check_index(&self, what: &'static str, index: &ColumnIndex, count: usize) -> Result<(), MeshError> {
        match index {
            ColumnIndex::PerVertex if count == self.positions.len() => Ok(()),
            ColumnIndex::PerVertex => {
                Err(MeshError::ColumnLength { what, found: count, expected: self.positions.len() })
            }
            ColumnIndex::PerCorner(index) if index.len() != self.faces.corner_count() => {
                Err(MeshError::ColumnLength { what, found: index.len(), expected: self.faces.corner_count() })
            }
            ColumnIndex::PerCorner(index) => {
                match index.iter().find(|&&i| i != NONE && i as usize >= count) {
                    Some(&index) => Err(MeshError::ColumnIndex { what, index, count }),
                    None => Ok(()),
                }
            }
        }
    }
}
