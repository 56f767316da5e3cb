//! Materials, cameras and lights of mesh files as those of this crate.

use crate::io::{
    Appearance, FileCamera, FileLight, FileLightKind, FileMaterial, FileOptics, FileProjection,
    FileReflection, Note, Place, Problem, ReadError, Severity,
};
use crate::num::{LinearRgb, Radians};
use crate::raster::load::scene_file::plain_material;
use crate::raster::view::camera::{Camera, Projection};
use crate::shade::{Attenuation, Cone, Light, Material, Optics, Reflectance, Reflection, roughness_exponent};
use glam::DVec3;
use std::f64::consts::{FRAC_1_PI, FRAC_PI_2};

/// Reflectance of what is no metal, seen from straight above: that of glass (glTF 2.0, appendix B).
const DIELECTRIC: f64 = 0.04;

/// A white surface under 1 lux shows 1/π; under a light of this crate with intensity 1 it shows 1.
const PER_LUX: f64 = FRAC_1_PI;

/// A material; whether it is unlit.
pub(super) fn material(file: &FileMaterial) -> (Material, bool) {
    match file.reflection {
        FileReflection::Phong { ambient, diffuse, specular, exponent } => {
            let plain = plain_material();
            let merged = |colour: [f64; 3]| Reflectance::Merged(colour.into());
            let diffuse = diffuse.map_or(plain.diffuse, merged);
            let material = Material {
                ambient: ambient.map_or(diffuse, merged),
                diffuse,
                specular: specular.map_or(Reflectance::NONE, merged),
                exponent: exponent.unwrap_or(plain.exponent),
                reflection: Reflection::Blinn,
            };
            (material, false)
        }
        FileReflection::MetallicRoughness { base_colour, metallic, roughness, unlit } => {
            let material = metallic_roughness(base_colour.into(), metallic, roughness);
            let left = 1.0 - file.optics.lost;
            if left == 1.0 {
                return (material, unlit);
            }
            // Transmitted light is not reflected in all directions.
            let [ambient, diffuse] =
                [material.ambient, material.diffuse].map(|it| Reflectance::Merged(it.merged() * left));
            (Material { ambient, diffuse, ..material }, unlit)
        }
    }
}

/// What a material mirrors and transmits, with absorption for a scale of 1; and whether its refractive index is invalid, and 1
/// is taken in its place.
pub(super) fn optics(file: &FileMaterial) -> (Optics, bool) {
    let FileOptics { reflect, transmit, ior, absorb, .. } = file.optics;
    let is_valid = ior >= 1.0 && ior.is_finite();
    let [reflect, transmit, absorb] = [reflect, transmit, absorb].map(LinearRgb::from);
    (Optics { reflect, transmit, ior: if is_valid { ior } else { 1.0 }, absorb }, !is_valid)
}

/// The largest that a highlight becomes at its peak: half of white, so that the shape beneath it still shows.
const LARGEST_HIGHLIGHT: f64 = 0.5;

/// glTF's metallic-roughness model by Blinn's, as [`SceneFile::from_loaded`](crate::raster::SceneFile::from_loaded) describes. A
/// smaller highlight is brighter (T. Akenine-Möller et al., *Real-Time Rendering*, 3rd ed., 2008, eq. 7.49); the factor 1 − α
/// replaces the missing N·L; metals keep diffuse light, for they have no surroundings to mirror. If a component of K_s
/// is above ½, all are scaled down, so that the hue stays.
fn metallic_roughness(base: LinearRgb, metallic: f64, roughness: f64) -> Material {
    let alpha = roughness * roughness;
    let exponent = roughness_exponent(roughness);
    let from_above = LinearRgb::grey(DIELECTRIC * (1.0 - metallic)) + base * metallic;
    let strength = (1.0 - alpha) * (exponent + 8.0) / 8.0;
    // A black metal reflects nothing: the smaller one of something and infinity.
    let specular = from_above * strength.min(LARGEST_HIGHLIGHT / from_above.largest());
    let diffuse = base * (1.0 - metallic * (2.0 - alpha) / 4.0);
    let diffuse = diffuse * ((1.0 - specular.largest()) / diffuse.largest()).min(1.0);
    Material {
        ambient: Reflectance::Merged(base),
        diffuse: Reflectance::Merged(diffuse),
        specular: Reflectance::Merged(specular),
        exponent,
        reflection: Reflection::Blinn,
    }
}

/// A camera of a file, `distance` away from its target, which is any point on its axis. Checked.
fn camera(file: &FileCamera, distance: impl Fn(DVec3) -> f64) -> Result<Camera, ReadError> {
    let axis = |axis: DVec3| file.world_from_camera.transform_vector3(axis);
    let eye = file.world_from_camera.w_axis.truncate();
    let camera = Camera {
        eye,
        target: eye + axis(DVec3::NEG_Z).normalize_or_zero() * distance(eye),
        up: axis(DVec3::Y),
        projection: match file.projection {
            FileProjection::Perspective(angle) => Projection::Perspective(Radians(angle)),
            FileProjection::Orthographic { height, .. } => Projection::Orthographic(height),
        },
        near: file.near,
    };
    camera.check().map(|()| camera).map_err(|error| {
        let found = format!("invalid camera: {error}");
        ReadError::new(Problem::Range, file.place.clone(), found, "correct the camera or its parent nodes")
    })
}

/// A light of `KHR_lights_punctual`: 1/d² within its range; a spot fades from its inner to its outer cone.
fn light(file: &FileLight) -> Light {
    let map = file.world_from_light;
    let (position, along) = (map.w_axis.truncate(), map.transform_vector3(DVec3::NEG_Z));
    let colour = LinearRgb::from(file.colour) * (file.intensity * PER_LUX);
    let attenuation = match file.range {
        Some(range) => Attenuation::InverseSquareWithin(range),
        None => Attenuation::InverseSquare,
    };
    match file.kind {
        FileLightKind::Directional => Light::Directional { towards: -along, colour },
        FileLightKind::Point => Light::Point { position, colour, attenuation },
        FileLightKind::Spot { inner, outer } => {
            // Single precision writes a right angle a little too large.
            let outer = if (FRAC_PI_2..FRAC_PI_2 + 1e-6).contains(&outer) { FRAC_PI_2 } else { outer };
            let soft_edge = Radians(outer - inner);
            let cone = Cone { axis: along, cut_off: Radians(outer), soft_edge, exponent: 0.0 };
            Light::Spot { position, colour, attenuation, cone }
        }
    }
}

/// The first valid camera of a file, with its description there; others are noted.
///
/// # Errors
/// An invalid first camera, unless pictures are taken with another one.
pub(super) fn first_camera(
    appearance: &Appearance,
    distance: impl Fn(DVec3) -> f64,
    from_elsewhere: bool,
    notes: &mut Vec<Note>,
) -> Result<Option<(Camera, FileCamera)>, ReadError> {
    let mut cameras = Vec::new();
    for file in &appearance.cameras {
        match file.clone().and_then(|file| Ok((camera(&file, &distance)?, file))) {
            Ok(camera) => cameras.push(camera),
            Err(error) if cameras.is_empty() && !from_elsewhere => {
                let advice = format!("{}, or remove the camera from the file", error.advice);
                return Err(ReadError { advice, ..error });
            }
            Err(ReadError { place, found, .. }) => {
                notes.push(Note::new(Severity::Note, place, format!("{found}; this camera is omitted")));
            }
        }
    }
    if cameras.len() > 1 {
        notes.push(Note::remark(format!("the first of {} cameras is used", cameras.len())));
    }
    Ok(cameras.into_iter().next())
}

/// The lights of a file; `None` if it has none. Lights that cannot be used are skipped with a note.
pub(super) fn lights(appearance: &Appearance, notes: &mut Vec<Note>) -> Option<Vec<Light>> {
    let mut lights = Vec::new();
    for (number, file) in appearance.lights.iter().enumerate() {
        let light = light(file);
        match light.check(number) {
            Ok(()) => lights.push(light),
            Err(error) => {
                let which = match &*file.name {
                    "" => "a light".to_owned(),
                    name => format!("the light `{name}`"),
                };
                notes.push(Note::warning(Place::File, format!("{which} is omitted: {error}")));
            }
        }
    }
    (!lights.is_empty()).then_some(lights)
}
