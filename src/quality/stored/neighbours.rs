//! What lies round a part in its file.

use crate::io::{Format, Loaded};
use crate::mesh::{Mesh, Placed, Weld, cavities};
use crate::quality::stored::borders::Borders;
use glam::DVec3;
use std::sync::OnceLock;

/// The file round its parts, looked at when a part first asks.
pub(in crate::quality) struct Around<'a> {
    loaded: &'a Loaded,
    /// The distance, as a share of the diagonal, below which open edges are taken for one.
    near: f64,
    cavities: OnceLock<Vec<Vec<usize>>>,
    borders: OnceLock<Borders>,
}

impl<'a> Around<'a> {
    pub(in crate::quality) fn new(loaded: &'a Loaded, near: f64) -> Self {
        Self { loaded, near, cavities: OnceLock::new(), borders: OnceLock::new() }
    }

    /// The distance, as a share of the diagonal, below which open edges are taken for one.
    pub(in crate::quality) fn near(&self) -> f64 {
        self.near
    }

    /// The mesh of a part.
    pub(in crate::quality) fn mesh(&self, part: usize) -> &'a Mesh {
        &self.loaded.parts[part].mesh
    }

    /// Whether the file can share vertices at all; STL cannot.
    pub(in crate::quality) fn shares_vertices(&self) -> bool {
        self.loaded.format != Format::Stl
    }

    /// Whether the file has a choice of how normals are stored; only glTF has.
    pub(in crate::quality) fn has_normal_formats(&self) -> bool {
        self.loaded.format.is_gltf()
    }

    /// Components of a part that face inwards because other meshes of the file lie round them.
    pub(in crate::quality) fn cavities(&self, part: usize) -> &[usize] {
        let find = || {
            let parts = self.loaded.parts.iter().zip(self.loaded.places());
            let parts: Vec<Placed<'_>> =
                parts.map(|(part, places)| Placed { mesh: &part.mesh, places }).collect();
            cavities(&parts, Weld::Exact)
        };
        &self.cavities.get_or_init(find)[part]
    }

    /// Whether a normal at a point of a part is that of another part there as well.
    pub(in crate::quality) fn go_on(&self, part: usize, position: DVec3, normal: DVec3) -> bool {
        self.loaded.parts.len() > 1
            && self.borders.get_or_init(|| Borders::new(self.loaded)).go_on(part, position, normal)
    }
}
