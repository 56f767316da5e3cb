//! What a scene file may say: its tables and keys.

use crate::raster::load::toml::values::{Colour, Number, Reflects, Step, Vector};
use serde::Deserialize;
use std::collections::BTreeMap;
use toml::Spanned;

/// The whole file.
#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
pub(super) struct SceneKeys {
    #[serde(default)]
    pub(super) settings: SettingsKeys,
    pub(super) camera: Option<Spanned<CameraKeys>>,
    #[serde(default)]
    pub(super) light: LightKeys,
    #[serde(default)]
    pub(super) object: Vec<Spanned<ObjectKeys>>,
}

/// `[settings]`
#[derive(Default, Deserialize)]
#[serde(deny_unknown_fields, rename_all = "kebab-case")]
pub(super) struct SettingsKeys {
    pub(super) size: Option<Spanned<[u32; 2]>>,
    pub(super) samples: Option<Spanned<u32>>,
    pub(super) bits: Option<Spanned<u32>>,
    pub(super) shading: Option<Spanned<String>>,
    pub(super) interpolation: Option<Spanned<String>>,
    pub(super) flat_sample: Option<Spanned<String>>,
    pub(super) cull: Option<Spanned<String>>,
    pub(super) two_sided: Option<bool>,
    pub(super) infinite_viewer: Option<bool>,
    /// For all objects that say nothing themselves.
    pub(super) reflection: Option<Spanned<String>>,
    /// All guards off, before `guards` switches single ones.
    pub(super) literal: Option<bool>,
    #[serde(default)]
    pub(super) guards: BTreeMap<Spanned<String>, bool>,
    pub(super) terminator: Option<Spanned<String>>,
    pub(super) depth_cue: Option<Spanned<Number>>,
    pub(super) tone: Option<Spanned<String>>,
    pub(super) transfer: Option<Spanned<String>>,
    pub(super) background: Option<Colour>,
    pub(super) wire: Option<Spanned<WireKeys>>,
}

/// `wire = { … }`
#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
pub(super) struct WireKeys {
    #[serde(alias = "color")]
    pub(super) colour: Option<Colour>,
    pub(super) width: Option<Number>,
    pub(super) hide: Option<bool>,
}

/// `[camera]`
#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
pub(super) struct CameraKeys {
    pub(super) eye: Vector,
    pub(super) target: Vector,
    pub(super) up: Option<Vector>,
    /// Degrees from bottom to top: perspective.
    pub(super) angle: Option<Number>,
    /// From bottom to top: orthographic.
    pub(super) height: Option<Number>,
    pub(super) near: Option<Number>,
}

/// `[[light.…]]`, by kind.
#[derive(Default, Deserialize)]
#[serde(deny_unknown_fields, default)]
pub(super) struct LightKeys {
    pub(super) ambient: Vec<Spanned<AmbientKeys>>,
    pub(super) directional: Vec<Spanned<DirectionalKeys>>,
    pub(super) point: Vec<Spanned<PointKeys>>,
    pub(super) spot: Vec<Spanned<SpotKeys>>,
    pub(super) rectangle: Vec<Spanned<RectangleKeys>>,
    pub(super) disc: Vec<Spanned<DiscKeys>>,
}

/// `[[light.ambient]]`
#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
pub(super) struct AmbientKeys {
    #[serde(alias = "color")]
    pub(super) colour: Colour,
}

/// `[[light.directional]]`
#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
pub(super) struct DirectionalKeys {
    pub(super) towards: Vector,
    #[serde(alias = "color", default = "white")]
    pub(super) colour: Colour,
}

/// `[[light.point]]`
#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
pub(super) struct PointKeys {
    /// x, y, z, or homogeneous with w: 0 for a light that is infinitely far away.
    pub(super) position: Vec<Number>,
    #[serde(alias = "color", default = "white")]
    pub(super) colour: Colour,
    #[serde(default)]
    pub(super) attenuation: AttenuationKeys,
}

/// `[[light.spot]]`
#[derive(Deserialize)]
#[serde(deny_unknown_fields, rename_all = "kebab-case")]
pub(super) struct SpotKeys {
    pub(super) position: Vector,
    #[serde(alias = "color", default = "white")]
    pub(super) colour: Colour,
    #[serde(default)]
    pub(super) attenuation: AttenuationKeys,
    /// The way of the light along the middle.
    pub(super) axis: Vector,
    /// Degrees; 180 for none.
    pub(super) cut_off: Option<Number>,
    /// Degrees.
    pub(super) soft_edge: Option<Number>,
    pub(super) exponent: Option<Number>,
}

/// `[[light.rectangle]]`
#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
pub(super) struct RectangleKeys {
    pub(super) centre: Vector,
    pub(super) u: Vector,
    pub(super) v: Vector,
    #[serde(alias = "color", default = "white")]
    pub(super) colour: Colour,
}

/// `[[light.disc]]`
#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
pub(super) struct DiscKeys {
    pub(super) centre: Vector,
    pub(super) normal: Vector,
    pub(super) radius: Number,
    #[serde(alias = "color", default = "white")]
    pub(super) colour: Colour,
}

fn white() -> Colour {
    Colour(crate::num::LinearRgb::WHITE)
}

/// `attenuation = …`
#[derive(Clone, Copy, Default, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub(super) enum AttenuationKeys {
    #[default]
    None,
    InverseSquare,
    /// The range.
    InverseSquareWithin(Number),
    /// k of 1/(d + k).
    Offset(Number),
    /// kc, kl, kq.
    Quadratic([Number; 3]),
}

/// `[[object]]`
#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
pub(super) struct ObjectKeys {
    #[serde(default)]
    pub(super) name: String,
    pub(super) mesh: Option<Spanned<String>>,
    pub(super) polygons: Option<Spanned<PolygonKeys>>,
    pub(super) surface: Option<Spanned<SurfaceKeys>>,
    pub(super) tessellation: Option<Spanned<TessellationKeys>>,
    pub(super) normals: Option<Spanned<String>>,
    #[serde(default)]
    pub(super) transform: Vec<Step>,
    pub(super) material: Option<Spanned<MaterialKeys>>,
}

/// `polygons = { … }`
#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
pub(super) struct PolygonKeys {
    pub(super) vertices: Vec<Vector>,
    pub(super) faces: Vec<Vec<u32>>,
    /// One a vertex.
    pub(super) normals: Option<Vec<Vector>>,
    /// One a vertex.
    #[serde(alias = "colors")]
    pub(super) colours: Option<Vec<Colour>>,
}

/// `surface = { sphere = { radius = 1 } }`
#[derive(Clone, Copy, Deserialize)]
#[serde(deny_unknown_fields, rename_all = "kebab-case", rename_all_fields = "kebab-case")]
pub(super) enum SurfaceKeys {
    Plane { width: Number, height: Number },
    Sphere { radius: Number },
    Ellipsoid { semi_axes: Vector },
    Cylinder { radius: Number, height: Number },
    Cone { radius: Number, height: Number },
    Torus { major: Number, minor: Number },
    Catenoid { waist: Number, height: Number },
    Wave { size: Number },
    MonkeySaddle { size: Number },
    Superquadric { semi_axes: Vector, roundness: [Number; 2] },
    Teapot {},
}

/// `tessellation = { … }`
#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
pub(super) struct TessellationKeys {
    #[serde(default)]
    pub(super) pattern: PatternKeys,
    pub(super) segments: Option<[u32; 2]>,
    pub(super) jitter: Option<Number>,
    pub(super) noise: Option<Number>,
    pub(super) seed: Option<u32>,
}

/// `pattern = …`
#[derive(Clone, Copy, Default, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub(super) enum PatternKeys {
    #[default]
    Triangles,
    Stretched(Number),
    Slivers(Number),
    Quads,
    Polygons,
    Icosphere(u32),
    Marching,
    Scattered,
}

/// `[object.material]`
#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
pub(super) struct MaterialKeys {
    /// O of what is given as a coefficient: ambient and diffuse.
    #[serde(alias = "color")]
    pub(super) colour: Option<Colour>,
    pub(super) ambient: Option<Reflects>,
    pub(super) diffuse: Option<Reflects>,
    /// As a coefficient it goes with white.
    pub(super) specular: Option<Reflects>,
    pub(super) exponent: Option<Number>,
    pub(super) reflection: Option<Spanned<String>>,
}
