//! The tangents that vertices can have: those of the base and of each morph target, as a row of bytes.

use super::rows::Rows;
use crate::io::gltf::accessor::float;
use crate::io::gltf::data::{push_floats, push_tangent};
use crate::io::gltf::records::{Component, Format};
use crate::mesh::{NONE, VertexSplit};
use glam::Vec3;

/// What happens to the tangents of a group.
pub enum Tangents {
    /// They stay as they are stored, or there are none.
    Stay,
    Go,
    New(NewTangents),
}

/// The tangents of corners, and those of the morph targets that have some, as a row of bytes.
pub struct NewTangents {
    pub format: Format,
    /// The sets of the morph targets with tangents.
    pub sets: Vec<usize>,
    /// The row of each corner.
    pub of_corner: Vec<u32>,
    pub rows: Rows,
    /// The row of each vertex as it was stored, or a unit vector.
    pub stored: Rows,
}

pub const DELTA: usize = 12;

impl NewTangents {
    /// The rows of the vertices of a split: as stored where no corner uses the vertex.
    pub fn gather(&self, split: &VertexSplit) -> Rows {
        let row = |(&sample, &source): (&u32, &u32)| match sample {
            NONE => self.stored.get(source as usize),
            corner => self.rows.get(self.of_corner[corner as usize] as usize),
        };
        let bytes = split.sample.iter().zip(&split.source).flat_map(row).copied().collect();
        Rows { bytes, size: self.rows.size }
    }

    /// The tangents of vertices, in their format.
    pub fn values(&self, rows: &Rows) -> Vec<u8> {
        rows.column(0, self.format.size())
    }

    /// The tangent displacements of vertices in the target of one of the `sets`, as floats.
    pub fn deltas(&self, rows: &Rows, number: usize) -> Vec<u8> {
        rows.column(self.format.size() + DELTA * number, DELTA)
    }

    fn decode(&self, row: &[u8]) -> [f32; 4] {
        let Format { component, normalized, .. } = self.format;
        std::array::from_fn(|axis| float(&row[component.size() * axis..], component, normalized))
    }

    /// The tangent of a vertex in a shape, as it was stored. Shape 0 is the base, others are of the `sets`.
    pub fn stored(&self, vertex: usize, shape: usize) -> [f32; 4] {
        let row = self.stored.get(vertex);
        let mut tangent = self.decode(row);
        if let Some(number) = shape.checked_sub(1) {
            let deltas = row[self.format.size() + DELTA * number..].chunks_exact(4);
            deltas.zip(&mut tangent).take(3).for_each(|(delta, x)| *x += float(delta, Component::F32, false));
        }
        tangent
    }

    /// Replaces the tangent of a corner in a shape, that of the base first.
    pub fn set(&mut self, corner: usize, shape: usize, [x, y, z, w]: [f32; 4]) {
        let tangent = Vec3::new(x, y, z).as_dvec3();
        let (start, mut bytes) = (corner * self.rows.size, Vec::new());
        let at = match shape.checked_sub(1) {
            None => {
                push_tangent(tangent, w, self.format, &mut bytes);
                start
            }
            Some(number) => {
                // What readers add the displacement to.
                let base = Vec3::from_slice(&self.decode(&self.rows.bytes[start..]));
                push_floats(tangent - base.as_dvec3(), &mut bytes);
                start + self.format.size() + DELTA * number
            }
        };
        self.rows.bytes[at..at + bytes.len()].copy_from_slice(&bytes);
    }
}
