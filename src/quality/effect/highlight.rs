//! The width of the highlights of faces, from their materials.

use crate::io::{FileMaterial, FileReflection};
use crate::mesh::Mesh;
use crate::quality::angles::Limit;
use crate::quality::facts::Facts;
use crate::shade::roughness_exponent;

const USUAL: f64 = 32.0;

/// The highlight of each material that the faces of a part name.
#[derive(Clone, Debug)]
pub(crate) struct Highlights {
    /// By the label of a face.
    of_material: Vec<Highlight>,
    /// For faces without a label, or for all if the thresholds give an exponent.
    otherwise: Highlight,
}

/// A highlight cosⁿ.
#[derive(Clone, Copy, Debug)]
struct Highlight {
    exponent: f64,
    /// The angle between the positions where it has half of its height.
    width: Limit,
}

impl Highlight {
    fn new(exponent: f64) -> Self {
        Self { exponent, width: Limit::new(2.0 * libm::acos(libm::exp2(-1.0 / exponent)).to_degrees()) }
    }
}

impl Highlights {
    pub(crate) fn new(facts: &Facts<'_>) -> Self {
        let otherwise = Highlight::new(facts.thresholds.exponent.unwrap_or(USUAL));
        let materials = facts.file.materials();
        let of = |name: &String| materials.iter().find(|material| material.name == *name);
        let labels = facts.mesh.columns().materials.iter();
        let of_material = labels
            .flat_map(|labels| &labels.names)
            .map(|name| of(name).map_or(otherwise, |material| Highlight::new(exponent(material))))
            .collect();
        Self { of_material, otherwise }
    }

    fn of(&self, mesh: &Mesh, face: usize) -> Highlight {
        let label = mesh.columns().materials.as_ref().map(|labels| labels.of_face[face] as usize);
        label.and_then(|label| self.of_material.get(label)).copied().unwrap_or(self.otherwise)
    }

    /// The angle between the positions where the highlight of a face has half of its height.
    pub(crate) fn width(&self, mesh: &Mesh, face: usize) -> Limit {
        self.of(mesh, face).width
    }

    /// The largest exponent of any face.
    pub(crate) fn largest_exponent(&self, mesh: &Mesh) -> f64 {
        if mesh.columns().materials.is_none() {
            return self.otherwise.exponent;
        }
        (0..mesh.face_count()).map(|face| self.of(mesh, face).exponent).fold(1.0, f64::max)
    }
}

/// The exponent of a material; 1, the width of diffuse light, if it has no highlight.
fn exponent(material: &FileMaterial) -> f64 {
    match material.reflection {
        FileReflection::Phong { specular: Some([0.0, 0.0, 0.0]), .. }
        | FileReflection::MetallicRoughness { unlit: true, .. } => 1.0,
        FileReflection::Phong { exponent, .. } => exponent.unwrap_or(USUAL).max(1.0),
        FileReflection::MetallicRoughness { roughness, .. } => roughness_exponent(roughness),
    }
}
