//! The settings and the camera of a scene file.

use crate::io::ReadError;
use crate::num::{Degrees, Transfer};
use crate::raster::load::toml::choose;
use crate::raster::load::toml::keys::{CameraKeys, SettingsKeys, WireKeys};
use crate::raster::load::toml::material::Colouring;
use crate::raster::load::toml::place::Source;
use crate::raster::load::toml::values::Number;
use crate::raster::load::{SceneFile, SceneObject, SceneShape};
use crate::raster::samples::Samples;
use crate::raster::settings::{Bits, Cull, FlatSample, Interpolation, LineStyle, RenderSettings, Shading};
use crate::raster::view::camera::{Camera, CameraError, Projection};
use crate::shade::{DepthCue, Guards, Terminator, ToneRule};
use glam::DVec3;
use toml::Spanned;

/// The largest side of a picture.
const LARGEST: u32 = 16384;

/// Near distance of a perspective camera that has none, as a share of the distance to its target.
const NEAR_SHARE: f64 = 1e-3;

/// Sets what the file sets; returns the colouring of objects that say nothing about theirs.
pub(super) fn apply(
    source: Source,
    keys: &SettingsKeys,
    scene: &mut SceneFile,
) -> Result<Option<Colouring>, ReadError> {
    let settings = &mut scene.settings;
    sizes(source, keys, settings)?;
    if let Some(name) = &keys.shading {
        let choices = [
            ("flat", Shading::Flat),
            ("gouraud", Shading::Gouraud),
            ("phong", Shading::Phong),
            ("wireframe", Shading::Wireframe),
            ("exact", Shading::Exact),
        ];
        settings.shading = choose(source, name, &choices)?;
    }
    if let Some(name) = &keys.interpolation {
        let choices = [
            ("scanline", Interpolation::Scanline),
            ("affine", Interpolation::Affine),
            ("perspective", Interpolation::Perspective),
        ];
        settings.interpolation = choose(source, name, &choices)?;
    }
    if let Some(name) = &keys.flat_sample {
        let choices = [("centroid", FlatSample::Centroid), ("vertex-mean", FlatSample::VertexMean)];
        settings.flat_sample = choose(source, name, &choices)?;
    }
    if let Some(name) = &keys.cull {
        settings.cull =
            choose(source, name, &[("none", Cull::None), ("back", Cull::Back), ("front", Cull::Front)])?;
    }
    if let Some(name) = &keys.tone {
        let rules = [ToneRule::Clamp, ToneRule::DivideByMax].map(|rule| (rule.name(), rule));
        settings.tone = choose(source, name, &rules)?;
    }
    if let Some(name) = &keys.transfer {
        let choices = [("srgb", Transfer::Srgb), ("direct", Transfer::Direct)];
        settings.transfer = choose(source, name, &choices)?;
    }
    settings.two_sided = keys.two_sided.unwrap_or(settings.two_sided);
    settings.infinite_viewer = keys.infinite_viewer.unwrap_or(settings.infinite_viewer);
    settings.guards = guards(source, keys)?;
    if let Some(name) = &keys.terminator {
        let choices =
            [("smooth", Terminator::Smooth), ("hard", Terminator::Hard), ("soft", Terminator::Soft)];
        settings.terminator = choose(source, name, &choices)?;
    }
    if let Some(k) = &keys.depth_cue {
        let Number(k) = *not_negative(source, k, "the depth cue's k")?;
        settings.depth_cue = Some(DepthCue { k });
    }
    if let Some(wire) = &keys.wire {
        settings.wire = line_style(source, wire)?;
    }
    scene.background = keys.background.map_or(scene.background, |background| background.0);
    keys.reflection.as_ref().map(|name| Colouring::named(source, name)).transpose()
}

fn sizes(source: Source, keys: &SettingsKeys, settings: &mut RenderSettings) -> Result<(), ReadError> {
    if let Some(size) = &keys.size {
        if !size.get_ref().iter().all(|side| (1..=LARGEST).contains(side)) {
            let [width, height] = size.get_ref();
            let found = format!("a picture of {width} by {height} pixels");
            return Err(source.error(&size.span(), &found, "each side must be 1 to 16384"));
        }
        settings.size = *size.get_ref();
    }
    if let Some(samples) = &keys.samples {
        let pattern = usize::try_from(*samples.get_ref()).ok().and_then(Samples::new);
        settings.samples = pattern.ok_or_else(|| {
            let found = format!("{} samples", samples.get_ref());
            source.error(&samples.span(), &found, "it may be 1, 4, 8 or 16")
        })?;
    }
    if let Some(bits) = &keys.bits {
        settings.bits = match bits.get_ref() {
            8 => Bits::Eight,
            16 => Bits::Sixteen,
            other => return Err(source.error(&bits.span(), &format!("{other} bits"), "it may be 8 or 16")),
        };
    }
    Ok(())
}

/// Whether all that is to be shaded exactly has a surface that rays can be cast at.
pub(super) fn check_exact(source: Source, keys: &SettingsKeys, scene: &SceneFile) -> Result<(), ReadError> {
    let Some(name) = keys.shading.as_ref().filter(|_| scene.settings.shading == Shading::Exact) else {
        return Ok(());
    };
    let has_none =
        |object: &SceneObject| matches!(object.shape, SceneShape::Mesh(_)) && object.surface.is_none();
    let Some(number) = scene.objects.iter().position(has_none) else { return Ok(()) };
    let which = match &*scene.objects[number].name {
        "" => format!("object {}", number + 1),
        name => format!("object {} (`{name}`)", number + 1),
    };
    let found = format!("exact shading, but {which} is no analytic surface that rays can be cast at");
    Err(source.error(&name.span(), &found, "choose another shading, or give the object a `surface`"))
}

/// Depth cueing goes by the distance to the viewer, which a parallel camera has none of.
pub(super) fn check_depth_cue(
    source: Source,
    keys: &SettingsKeys,
    scene: &SceneFile,
) -> Result<(), ReadError> {
    let is_parallel =
        |camera: &Camera| !matches!(camera.projection, crate::raster::Projection::Perspective(_));
    match &keys.depth_cue {
        Some(k) if scene.camera.as_ref().is_some_and(is_parallel) => Err(source.error(
            &k.span(),
            "depth cueing by the distance to the viewer, but the camera is a parallel one",
            "give the camera an `angle` in place of a `height`",
        )),
        _ => Ok(()),
    }
}

fn guards(source: Source, keys: &SettingsKeys) -> Result<Guards, ReadError> {
    let mut guards = if keys.literal == Some(true) { Guards::literal() } else { Guards::default() };
    for (name, &on) in &keys.guards {
        if !guards.set(name.get_ref(), on) {
            let advice = format!("there are {}", Guards::NAMES.join(", "));
            return Err(source.error(&name.span(), "no guard of that name", &advice));
        }
    }
    Ok(guards)
}

fn not_negative<'a>(
    source: Source,
    number: &'a Spanned<Number>,
    what: &str,
) -> Result<&'a Number, ReadError> {
    let Number(value) = number.get_ref();
    match *value >= 0.0 {
        true => Ok(number.get_ref()),
        false => Err(source.error(&number.span(), &format!("{what} is {value}"), "it must not be negative")),
    }
}

fn line_style(source: Source, keys: &Spanned<WireKeys>) -> Result<LineStyle, ReadError> {
    let default = LineStyle::default();
    let width = keys.get_ref().width.map_or(default.width, |Number(width)| width);
    if width <= 0.0 {
        let span = source.member(&keys.span(), &["width"]);
        return Err(source.error(&span, &format!("lines {width} pixels wide"), "the width must be above 0"));
    }
    let colour = keys.get_ref().colour.map_or(default.colour, |colour| colour.0);
    Ok(LineStyle { colour, width, hide: keys.get_ref().hide.unwrap_or(default.hide) })
}

/// The camera; it can be used.
pub(super) fn camera(source: Source, keys: &Spanned<CameraKeys>) -> Result<Camera, ReadError> {
    let (span, keys) = (keys.span(), keys.get_ref());
    let projection = match (keys.angle, keys.height) {
        (Some(Number(angle)), None) => Projection::Perspective(Degrees(angle).into()),
        (None, Some(Number(height))) => Projection::Orthographic(height),
        (None, None) => Projection::Perspective(Degrees(30.0).into()),
        (Some(_), Some(_)) => {
            let found = "an angle and a height";
            return Err(source.error(
                &span,
                found,
                "give one: a perspective camera has an angle, a parallel one a height",
            ));
        }
    };
    let (eye, target) = (keys.eye.get(), keys.target.get());
    let near = match projection {
        // Above 0 even where eye and target are the same, which is told below.
        Projection::Perspective(_) => (eye.distance(target) * NEAR_SHARE).max(f64::MIN_POSITIVE),
        Projection::Orthographic(_) => 0.0,
    };
    let camera = Camera {
        eye,
        target,
        up: keys.up.map_or(DVec3::Y, crate::raster::load::toml::values::Vector::get),
        projection,
        near: keys.near.map_or(near, |Number(near)| near),
    };
    camera.check().map(|()| camera).map_err(|error| {
        let key = match error {
            CameraError::NonFinite(_) => "eye",
            CameraError::NoDirection(_) => "target",
            CameraError::NoUp(_) => "up",
            CameraError::Angle(_) => "angle",
            CameraError::Height(_) => "height",
            CameraError::Near(_) => "near",
        };
        source.error(&source.member(&span, &[key]), &error.to_string(), "")
    })
}
