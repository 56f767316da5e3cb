//! Materials, cameras and lights of files, as plain data for renderers.

use super::{Note, Place, ReadError};
use glam::DMat4;

/// Materials, cameras and lights of a file.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Appearance {
    /// The materials that the labels of faces ([`Columns::materials`](crate::mesh::Columns::materials)) name, each
    /// name once; materials that no library defines are missing.
    pub materials: Vec<FileMaterial>,
    /// Cameras of the default scene, in the order of the node tree; an error for each that the format does not allow.
    pub cameras: Vec<Result<FileCamera, ReadError>>,
    /// Lights of the default scene, in the order of the node tree.
    pub lights: Vec<FileLight>,
    /// What could not be used; it is ignored.
    pub notes: Vec<Note>,
}

/// A material.
#[derive(Clone, Debug, PartialEq)]
pub struct FileMaterial {
    /// Its name, as labels of faces have it.
    pub name: String,
    /// How it reflects light.
    pub reflection: FileReflection,
    /// 1 if opaque; `None` if the file does not specify it.
    pub opacity: Option<f64>,
    /// What it mirrors and transmits, for ray tracers.
    pub optics: FileOptics,
    /// The number of images it refers to, which vary it over the surface.
    pub textures: usize,
}

/// What a material mirrors and transmits: `KHR_materials_transmission`, `KHR_materials_ior` and `KHR_materials_volume` of glTF,
/// `illum` from 3 to 9, `Ni` and `Tf` of MTL.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct FileOptics {
    /// The share of mirrored light.
    pub reflect: [f64; 3],
    /// The share of light that passes through.
    pub transmit: [f64; 3],
    /// The share of `transmit` before it is coloured, which diffuse reflection lacks.
    pub lost: f64,
    /// The refractive index; 1 for thin walls, which do not bend light.
    pub ior: f64,
    /// The absorption for each unit of length in the file.
    pub absorb: [f64; 3],
}

impl Default for FileOptics {
    /// Neither mirrored nor transmitted light.
    fn default() -> Self {
        Self { reflect: [0.0; 3], transmit: [0.0; 3], lost: 0.0, ior: 1.0, absorb: [0.0; 3] }
    }
}

/// How a material reflects light, in the terms of its format.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum FileReflection {
    /// MTL's: Ka, Kd, Ks and Ns, where they are given. Its highlight is (N·H)^Ns.
    Phong {
        /// Ka.
        ambient: Option<[f64; 3]>,
        /// Kd.
        diffuse: Option<[f64; 3]>,
        /// Ks; zero if `illum` disables highlights.
        specular: Option<[f64; 3]>,
        /// Ns.
        exponent: Option<f64>,
    },
    /// glTF's, without images.
    MetallicRoughness {
        /// Linear base colour.
        base_colour: [f64; 3],
        /// 0 for plastic to 1 for metal.
        metallic: f64,
        /// 0 for a mirror to 1.
        roughness: f64,
        /// Whether light does not matter (`KHR_materials_unlit`).
        unlit: bool,
    },
}

/// A camera with its transform.
#[derive(Clone, Debug, PartialEq)]
pub struct FileCamera {
    /// Its name, possibly empty.
    pub name: String,
    /// Where the file describes it.
    pub place: Place,
    /// From its own space, where it looks along −z with +y up, to the world's: a rotation and a translation.
    pub world_from_camera: DMat4,
    /// How it maps.
    pub projection: FileProjection,
    /// Distance before which nothing is drawn.
    pub near: f64,
    /// Distance beyond which nothing is to be drawn, if there is one.
    pub far: Option<f64>,
}

/// How a camera maps.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum FileProjection {
    /// The angle from bottom to top, in radians.
    Perspective(f64),
    /// Lengths in its own space.
    Orthographic {
        /// From left to right.
        width: f64,
        /// From bottom to top.
        height: f64,
    },
}

/// A light with its transform (`KHR_lights_punctual`).
#[derive(Clone, Debug, PartialEq)]
pub struct FileLight {
    /// Its name, possibly empty.
    pub name: String,
    /// From its own space, where it shines from the origin along −z, to the world's.
    pub world_from_light: DMat4,
    /// What it is.
    pub kind: FileLightKind,
    /// Linear.
    pub colour: [f64; 3],
    /// Candela, or lux where the light is directional.
    pub intensity: f64,
    /// Distance beyond which it does not shine.
    pub range: Option<f64>,
}

/// What a light is.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum FileLightKind {
    /// Infinitely far away.
    Directional,
    /// To all sides.
    Point,
    /// Into a cone, given by half its opening angle in radians.
    Spot {
        /// Where it begins to fade.
        inner: f64,
        /// Where it ends.
        outer: f64,
    },
}

/// The number that was written, from the nearest `f32`: 0.1, not 0.10000000149011612.
pub(super) fn as_written(single: f32) -> f64 {
    // The shortest decimal that reads back as the f32 is the text of the file, if that had up to six digits.
    single.to_string().parse().unwrap_or(f64::from(single))
}
