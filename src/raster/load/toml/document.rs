//! A whole scene file, its settings and its camera.

use crate::io::ReadError;
use crate::normals::{Precision, Weight};
use crate::num::{Degrees, List, Transfer};
use crate::raster::load::normal_settings::{CreaseValue, MergeName, StoredFormat, of_keys};
use crate::raster::load::scene_file::{LoadOptions, SceneFile, SceneObject, SceneShape};
use crate::raster::load::toml::lighting::{LightTables, ReflectionName, lights};
use crate::raster::load::toml::objects::{Builder, ObjectTable};
use crate::raster::load::toml::source::Source;
use crate::raster::load::toml::values::Colour;
use crate::raster::settings::{
    Bits, Cull, FlatSample, Interpolation, LARGEST_SIDE, LineStyle, RenderSettings, Samples, Shading,
    TraceSettings,
};
use crate::raster::view::camera::{Camera, CameraError, Projection};
use crate::shade::{DepthCue, Guards, Terminator, ToneRule};
use glam::DVec3;
use serde::Deserialize;
use std::collections::BTreeMap;
use std::path::Path;
use toml::Spanned;

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct Document {
    #[serde(default)]
    settings: SettingsTable,
    camera: Option<Spanned<CameraTable>>,
    #[serde(default)]
    light: LightTables,
    #[serde(default)]
    object: Vec<Spanned<ObjectTable>>,
}

impl SceneFile {
    /// A scene from the text of a TOML file that lies in the folder `base`; `docs/scenes.md` lists its keys.
    /// Meshes are looked for there, and in no place outside of it unless
    /// [`ReadOptions::root`](crate::io::ReadOptions::root) names one.
    ///
    /// ```
    /// use crease::raster::{LoadOptions, SceneFile, render};
    ///
    /// let text = "[[object]]\nsurface.sphere.radius = 1\nmaterial.colour = \"#3080c0\"\n";
    /// let file = SceneFile::from_toml(text, "".as_ref(), &LoadOptions::default())?;
    /// assert!(render(&file.scene(), &file.settings)?.statistics.covered_pixels > 0);
    ///
    /// let error = SceneFile::from_toml("[settings]\nsize = 7\n", "".as_ref(), &LoadOptions::default()).unwrap_err();
    /// assert!(error.to_string().starts_with("line 2: `settings.size`: "));
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    ///
    /// # Errors
    /// With the line and the key: what is no TOML, unknown keys, values of the wrong type or out of range, and what is
    /// wrong with meshes that the scene names.
    pub fn from_toml(text: &str, base: &Path, options: &LoadOptions) -> Result<Self, ReadError> {
        let source = Source(text);
        let document: Document = toml::from_str(text).map_err(|error| source.syntax(&error))?;
        let (lights, kept_lights) = lights(source, document.light)?;
        let mut scene = SceneFile { lights, kept_lights, ..SceneFile::default() };
        document.settings.apply(source, &mut scene)?;
        scene.camera = document.camera.map(|camera| CameraTable::camera(source, &camera)).transpose()?;
        let SettingsTable { reflection, weight, crease, precision, normal_format, merge, .. } =
            document.settings;
        let normals = of_keys(weight, crease, precision, normal_format, merge);
        let mut builder = Builder::new(source, base, options, reflection, normals, scene);
        document.object.into_iter().try_for_each(|object| builder.add(object))?;
        let scene = builder.finish()?;
        document.settings.check_scene(source, &scene)?;
        Ok(scene)
    }
}

#[derive(Default, Deserialize)]
#[serde(deny_unknown_fields, default, rename_all = "kebab-case")]
pub(super) struct SettingsTable {
    size: Option<Spanned<List<u32, 2>>>,
    samples: Option<Spanned<u32>>,
    bits: Option<Spanned<u32>>,
    shading: Option<Spanned<Shading>>,
    interpolation: Interpolation,
    flat_sample: FlatSample,
    cull: Cull,
    two_sided: bool,
    weight: Option<Weight>,
    crease: Option<CreaseValue>,
    precision: Option<Precision>,
    normal_format: Option<StoredFormat>,
    merge: Option<MergeName>,
    infinite_viewer: bool,
    /// For objects without a reflection.
    pub(super) reflection: Option<ReflectionName>,
    /// Switches all guards off, before `guards` switches single ones.
    literal: bool,
    guards: BTreeMap<Spanned<String>, bool>,
    terminator: Terminator,
    depth_cue: Option<Spanned<f64>>,
    tone: ToneRule,
    transfer: Transfer,
    background: Option<Colour>,
    ray_depth: Option<Spanned<u32>>,
    ray_weight: Option<Spanned<f64>>,
    shadow_samples: Option<Spanned<u32>>,
    wire: WireTable,
}

/// `wire = { … }`
#[derive(Default, Deserialize)]
#[serde(deny_unknown_fields, default)]
struct WireTable {
    #[serde(alias = "color")]
    colour: Option<Colour>,
    width: Option<Spanned<f64>>,
    hide: Option<bool>,
}

/// Near distance of a perspective camera that has none, as a share of the distance to its target.
const NEAR_SHARE: f64 = 1e-3;

impl SettingsTable {
    pub(super) fn apply(&self, source: Source, scene: &mut SceneFile) -> Result<(), ReadError> {
        let default = RenderSettings::default();
        let size = |List(size): &List<u32, 2>| {
            size.iter().all(|side| (1..=LARGEST_SIDE).contains(side)).then_some(*size)
        };
        let samples = |&count: &u32| Samples::new(count as usize);
        let bits =
            |&bits: &u32| [Bits::Eight, Bits::Sixteen].into_iter().find(|b| u32::from(b.count()) == bits);
        let k = |&k: &f64| (k >= 0.0 && k.is_finite()).then_some(Some(DepthCue { k }));
        scene.settings = RenderSettings {
            size: source.checked(&self.size, default.size, size, "each side must be 1 to 16384")?,
            samples: source.checked(&self.samples, default.samples, samples, "it may be 1, 4, 8 or 16")?,
            bits: source.checked(&self.bits, default.bits, bits, "it may be 8 or 16")?,
            shading: self.shading.as_ref().map_or(default.shading, |shading| *shading.get_ref()),
            interpolation: self.interpolation,
            flat_sample: self.flat_sample,
            cull: self.cull,
            two_sided: self.two_sided,
            infinite_viewer: self.infinite_viewer,
            guards: self.guards(source)?,
            terminator: self.terminator,
            depth_cue: source.checked(&self.depth_cue, None, k, "it must be finite and not negative")?,
            tone: self.tone,
            transfer: self.transfer,
            wire: self.wire.style(source)?,
            tracing: self.tracing(source)?,
            ..default
        };
        scene.background = self.background.map_or(scene.background, |Colour(background)| background);
        Ok(())
    }

    fn tracing(&self, source: Source) -> Result<TraceSettings, ReadError> {
        let default = TraceSettings::default();
        let depth = |&depth: &u32| (depth <= TraceSettings::MOST_DEPTH).then_some(depth);
        let weight = |&weight: &f64| (0.0..=1.0).contains(&weight).then_some(weight);
        let samples = |&samples: &u32| (samples <= TraceSettings::MOST_SHADOW_SAMPLES).then_some(samples);
        let (depths, counts) = ("it must be a whole number from 0 to 64", "it must be 0 to 4096");
        Ok(TraceSettings {
            depth: source.checked(&self.ray_depth, default.depth, depth, depths)?,
            weight: source.checked(&self.ray_weight, default.weight, weight, "it must be 0 to 1")?,
            shadow_samples: source.checked(&self.shadow_samples, default.shadow_samples, samples, counts)?,
        })
    }

    fn guards(&self, source: Source) -> Result<Guards, ReadError> {
        let mut guards = if self.literal { Guards::literal() } else { Guards::default() };
        for (name, &on) in &self.guards {
            if !guards.set(name.get_ref(), on) {
                let advice = format!("there are {}", Guards::NAMES.join(", "));
                return Err(source.error(&name.span(), "unknown guard", &advice));
            }
        }
        Ok(guards)
    }

    /// Whether the finished scene can be drawn with these settings.
    pub(super) fn check_scene(&self, source: Source, scene: &SceneFile) -> Result<(), ReadError> {
        let has_no_surface =
            |object: &SceneObject| matches!(object.shape, SceneShape::Mesh(_)) && object.surface.is_none();
        if let Some(shading) = self.shading.as_ref().filter(|shading| *shading.get_ref() == Shading::Exact)
            && let Some(number) = scene.objects.iter().position(has_no_surface)
        {
            let name = match &*scene.objects[number].name {
                "" => String::new(),
                name => format!(" (`{name}`)"),
            };
            let found = format!("exact shading, but object {number}{name} is not an analytic surface");
            let advice = "choose another shading, or give the object a `surface`";
            return Err(source.error(&shading.span(), &found, advice));
        }
        let is_parallel = |camera: &Camera| matches!(camera.projection, Projection::Orthographic(_));
        match &self.depth_cue {
            Some(k) if scene.camera.as_ref().is_some_and(is_parallel) => {
                let found = "depth cueing by the distance to the viewer, but the camera is a parallel one";
                Err(source.error(&k.span(), found, "give the camera an `angle` in place of a `height`"))
            }
            _ => Ok(()),
        }
    }
}

impl WireTable {
    fn style(&self, source: Source) -> Result<LineStyle, ReadError> {
        let default = LineStyle::default();
        let width = |&width: &f64| (width > 0.0 && width.is_finite()).then_some(width);
        Ok(LineStyle {
            colour: self.colour.map_or(default.colour, |Colour(colour)| colour),
            width: source.checked(
                &self.width,
                default.width,
                width,
                "the width must be finite and above 0",
            )?,
            hide: self.hide.unwrap_or(default.hide),
        })
    }
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
pub(super) struct CameraTable {
    eye: List<f64, 3>,
    target: List<f64, 3>,
    up: Option<List<f64, 3>>,
    /// Degrees from bottom to top: perspective.
    angle: Option<f64>,
    /// From bottom to top: orthographic.
    height: Option<f64>,
    near: Option<f64>,
}

impl CameraTable {
    pub(super) fn camera(source: Source, table: &Spanned<Self>) -> Result<Camera, ReadError> {
        let (span, table) = (table.span(), table.get_ref());
        let projection = match (table.angle, table.height) {
            (_, None) => Projection::Perspective(Degrees(table.angle.unwrap_or(30.0)).into()),
            (None, Some(height)) => Projection::Orthographic(height),
            (Some(_), Some(_)) => {
                let advice = "give one: a perspective camera has an angle, a parallel one a height";
                return Err(source.error(&span, "angle and height are both given", advice));
            }
        };
        let (eye, target) = (DVec3::from(table.eye), DVec3::from(table.target));
        let near = match projection {
            // Above 0 even if eye and target are the same, which is reported below.
            Projection::Perspective(_) => (eye.distance(target) * NEAR_SHARE).max(f64::MIN_POSITIVE),
            Projection::Orthographic(_) => 0.0,
        };
        let up = table.up.map_or(DVec3::Y, DVec3::from);
        let camera = Camera { eye, target, up, projection, near: table.near.unwrap_or(near) };
        let error = |error: CameraError| {
            let (names, advice): (Vec<&str>, _) = match error {
                CameraError::NonFinite(field) => (field.split(' ').collect(), "write finite numbers"),
                CameraError::NoDirection(_) => (vec!["target"], "move one of them"),
                CameraError::NoUp(_) => (vec!["up"], "choose another `up`"),
                CameraError::Angle(_) => (vec!["angle"], ""),
                CameraError::Height(_) => (vec!["height"], ""),
                CameraError::Near(_) => (vec!["near"], ""),
            };
            source.error(&source.member(&span, &names), &error.to_string(), advice)
        };
        camera.check().map(|()| camera).map_err(error)
    }
}
