//! How sharp the highlights of faces are, as far as the file tells.

use crate::io::{FileMaterial, FileReflection, Loaded};
use crate::mesh::Mesh;
use crate::quality::geometry::angle_limit::Limit;
use crate::shade::roughness_exponent;

/// The exponent of faces whose material tells none.
const USUAL: f64 = 32.0;

/// Of each material that a part's faces name, how sharp its highlight is.
#[derive(Clone, Debug)]
pub(in crate::quality) struct Gloss {
    /// By the label of a face.
    of_material: Vec<Highlight>,
    /// Of faces without a label, or of all if an exponent was asked for.
    otherwise: Highlight,
}

/// A highlight cosⁿ.
#[derive(Clone, Copy, Debug)]
struct Highlight {
    exponent: f64,
    width: Limit,
}

impl Highlight {
    fn new(exponent: f64) -> Self {
        Self { exponent, width: Limit::new(2.0 * libm::acos(libm::exp2(-1.0 / exponent)).to_degrees()) }
    }
}

/// The materials of a file, if exponents are to be taken from them.
pub(in crate::quality) fn materials(loaded: &Loaded, asked: Option<f64>) -> Vec<FileMaterial> {
    if asked.is_some() { Vec::new() } else { loaded.appearance().materials }
}

impl Gloss {
    pub(in crate::quality) fn new(mesh: &Mesh, materials: &[FileMaterial], asked: Option<f64>) -> Self {
        let otherwise = Highlight::new(asked.unwrap_or(USUAL));
        let names = mesh.columns().materials.as_ref().map(|labels| labels.names.as_slice());
        let of = |name: &String| materials.iter().find(|material| material.name == *name);
        let of_material = names
            .unwrap_or_default()
            .iter()
            .map(|name| of(name).map_or(otherwise, |it| Highlight::new(exponent(it))))
            .collect();
        Self { of_material, otherwise }
    }

    fn of(&self, label: u32) -> Highlight {
        self.of_material.get(label as usize).copied().unwrap_or(self.otherwise)
    }

    /// The angle between the places where the highlight of a face has half its height.
    pub(in crate::quality) fn width(&self, mesh: &Mesh, face: usize) -> Limit {
        let labels = mesh.columns().materials.as_ref();
        labels.map_or(self.otherwise, |labels| self.of(labels.of_face[face])).width
    }

    /// The largest exponent of any face.
    pub(in crate::quality) fn largest_exponent(&self, mesh: &Mesh) -> f64 {
        let Some(labels) = mesh.columns().materials.as_ref() else { return self.otherwise.exponent };
        labels.of_face.iter().map(|&label| self.of(label).exponent).fold(1.0, f64::max)
    }
}

/// What the highlight of a material has; 1, as sharp as diffuse light, if it has none.
fn exponent(material: &FileMaterial) -> f64 {
    match material.reflection {
        FileReflection::Phong { specular: Some([0.0, 0.0, 0.0]), .. }
        | FileReflection::MetallicRoughness { unlit: true, .. } => 1.0,
        FileReflection::Phong { exponent, .. } => exponent.unwrap_or(USUAL).max(1.0),
        FileReflection::MetallicRoughness { roughness, .. } => roughness_exponent(roughness),
    }
}
