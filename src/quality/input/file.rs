//! The file of a part, as far as findings about one part need the others.

use crate::io::{FileMaterial, Format, Loaded};
use crate::mesh::{Placed, Weld, cavities};
use crate::quality::input::borders::Borders;
use crate::quality::thresholds::Thresholds;
use glam::DVec3;
use std::sync::OnceLock;

/// A file and the thresholds of its diagnosis. What concerns several parts is computed when a part first needs it.
pub(crate) struct FileContext<'a> {
    pub(crate) loaded: &'a Loaded,
    pub(crate) thresholds: &'a Thresholds,
    cavities: OnceLock<Vec<Vec<usize>>>,
    borders: OnceLock<Borders>,
    materials: OnceLock<Vec<FileMaterial>>,
}

impl<'a> FileContext<'a> {
    pub(crate) fn new(loaded: &'a Loaded, thresholds: &'a Thresholds) -> Self {
        let (cavities, borders, materials) = (OnceLock::new(), OnceLock::new(), OnceLock::new());
        Self { loaded, thresholds, cavities, borders, materials }
    }

    /// Whether the format can share vertices at all; STL cannot.
    pub(crate) fn shares_vertices(&self) -> bool {
        self.loaded.format != Format::Stl
    }

    /// Whether the format has a choice of how normals are stored; only glTF has.
    pub(crate) fn has_normal_formats(&self) -> bool {
        self.loaded.format.is_gltf()
    }

    /// The materials, unless the thresholds give one exponent for all.
    pub(crate) fn materials(&self) -> &[FileMaterial] {
        self.materials.get_or_init(|| match self.thresholds.exponent {
            Some(_) => Vec::new(),
            None => self.loaded.appearance().materials,
        })
    }

    /// Components of a part that face inwards because other meshes of the file enclose them.
    pub(crate) fn cavities(&self, part: usize) -> &[usize] {
        let find = || {
            let parts = self.loaded.parts.iter().zip(self.loaded.places());
            let parts = parts.map(|(part, places)| Placed { mesh: &part.mesh, places });
            cavities(&parts.collect::<Vec<Placed<'_>>>(), Weld::Exact)
        };
        &self.cavities.get_or_init(find)[part]
    }

    /// Whether another part has the normal of a part at the same position.
    pub(crate) fn has_in_other_part(&self, part: usize, position: DVec3, normal: DVec3) -> bool {
        self.loaded.parts.len() > 1
            && self.borders.get_or_init(|| Borders::new(self.loaded)).has(part, position, normal)
    }
}
