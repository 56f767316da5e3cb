//! Materials, cameras and lights of files, as plain data for renderers.

use super::{Note, OutputContent, Place, ReadError};
use glam::DMat4;
use std::sync::Arc;

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
    /// Those of an MTL that glTF can have too, and the other way round while a glTF is written as OBJ; otherwise none.
    pub images: FileImages,
}

/// The images of a material that both MTL and glTF can have, and what the other format cannot have.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct FileImages {
    /// `map_Kd` of MTL, the base colour texture of glTF: it is multiplied by the colour of the material.
    pub base_colour: Option<FileImage>,
    /// `norm`, `map_Bump` or `bump` of MTL, the normal texture of glTF.
    pub normal: Option<FileImage>,
    /// Statements of MTL, or members of glTF, that the other format lacks, in words.
    pub omitted: Vec<String>,
}

impl FileImages {
    /// Whether there is an image.
    pub(super) fn has_any(&self) -> bool {
        self.base_colour.is_some() || self.normal.is_some()
    }
}

/// A PNG or JPEG.
#[derive(Clone, Debug, PartialEq)]
pub struct FileImage {
    /// Its name in the folder of an output: relative, with `/` between folders, and inside. It ends as its kind does, so that it is
    /// not the name of another file of the output.
    pub name: String,
    /// Its bytes, or the file that has them. Many materials may share it.
    pub content: Arc<OutputContent>,
    /// How it is compressed.
    pub kind: ImageKind,
    /// The factor of the x and y of a normal texture; 1 for colours.
    pub scale: f64,
}

impl FileImage {
    pub(super) fn new(name: String, content: Arc<OutputContent>, kind: ImageKind, scale: f64) -> Self {
        let lower = name.to_ascii_lowercase();
        let is_usual = kind.extensions().iter().any(|extension| lower.ends_with(extension));
        let name = if is_usual { name } else { name + kind.extensions()[0] };
        Self { name, content, kind, scale }
    }
}

/// The compression of an image that glTF can have.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum ImageKind {
    /// Portable Network Graphics.
    Png,
    /// JPEG.
    Jpeg,
}

impl ImageKind {
    /// Bytes of a PNG up to the end of its header chunk.
    pub(super) const HEAD: usize = 33;

    /// By the first bytes of a file, [`HEAD`](Self::HEAD) or more. A PNG has its header whole.
    pub(super) fn of(bytes: &[u8]) -> Option<Self> {
        if bytes.starts_with(b"\x89PNG\r\n\x1a\n") {
            return (bytes.len() >= Self::HEAD && bytes[12..].starts_with(b"IHDR")).then_some(Self::Png);
        }
        bytes.starts_with(b"\xff\xd8\xff").then_some(Self::Jpeg)
    }

    /// The media type of glTF.
    pub(super) fn mime_type(self) -> &'static str {
        match self {
            Self::Png => "image/png",
            Self::Jpeg => "image/jpeg",
        }
    }

    /// The endings of file names, the usual one first.
    pub(super) fn extensions(self) -> &'static [&'static str] {
        match self {
            Self::Png => &[".png"],
            Self::Jpeg => &[".jpg", ".jpeg"],
        }
    }
}

/// The warning about what the materials of these names lack in another format; `None` if they lack nothing.
pub(super) fn omitted_note<'a>(lost: impl IntoIterator<Item = (&'a str, String)>) -> Option<Note> {
    /// The most materials that are named.
    const MOST: usize = 10;
    let mut materials: Vec<(&str, Vec<String>)> = Vec::new();
    for (name, what) in lost {
        match materials.last_mut() {
            Some((last, list)) if *last == name => list.push(what),
            _ => materials.push((name, vec![what])),
        }
    }
    let mut all: Vec<String> =
        materials.into_iter().map(|(name, list)| format!("{} of `{name}`", list.join(", "))).collect();
    let more = all.len().saturating_sub(MOST);
    all.truncate(MOST);
    if more > 0 {
        all.push(format!("{more} more"));
    }
    (!all.is_empty())
        .then(|| Note::warning(Place::File, format!("omitted from materials: {}", all.join(", "))))
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
