//! Tests of results that were derived, not taken from papers: identities up to rounding, and bounds that samples keep to and come
//! near.

mod bands;
mod distance;
mod faces;
mod max;
mod slopes;

use crate::random::Random;
use crease::num::LinearRgb;
use crease::shade::{Light, Material, Reflectance, Reflection, ShadeSettings, Shader, SurfacePoint, Viewer};
use glam::{DQuat, DVec3};

/// Half a step of an 8-bit picture.
const HALF_STEP: f64 = 1.0 / 510.0;

/// A white surface that is diffuse only.
fn diffuse() -> Material {
    Material {
        diffuse: Reflectance::Merged(LinearRgb::WHITE),
        specular: Reflectance::NONE,
        ..Material::default()
    }
}

/// A white surface that has a highlight only.
fn shiny(reflection: Reflection, exponent: f64) -> Material {
    let specular = Reflectance::Merged(LinearRgb::WHITE);
    Material { diffuse: Reflectance::NONE, specular, exponent, reflection, ..Material::default() }
}

/// The light that a material sends from a point to a viewer far away, by the library's own formulas in `f64`.
struct Lit(Shader<f64>);

impl Lit {
    /// Light and viewer at infinity.
    fn far(material: &Material, light: DVec3, view: DVec3) -> Self {
        let light = Light::Directional { towards: light, colour: LinearRgb::WHITE };
        Self::new(material, light, Viewer::Towards(view))
    }

    fn new(material: &Material, light: Light, viewer: Viewer) -> Self {
        let settings = ShadeSettings { viewer, ..ShadeSettings::default() };
        Self(Shader::new(&[light], material, &settings).unwrap())
    }

    fn at(&self, position: DVec3, normal: DVec3) -> f64 {
        self.0.shade(&SurfacePoint { position: position.to_array(), normal: normal.to_array() }).unwrap()[0]
    }

    /// Where position does not matter.
    fn of(&self, normal: DVec3) -> f64 {
        self.at(DVec3::ZERO, normal)
    }
}

fn angle(a: DVec3, b: DVec3) -> f64 {
    libm::atan2(a.cross(b).length(), a.dot(b))
}

/// A vector turned about a random axis perpendicular to it.
fn turned(v: DVec3, angle: f64, random: &mut Random) -> DVec3 {
    let axis = v.cross(crate::shade::direction(random)).normalize();
    DQuat::from_axis_angle(axis, angle) * v
}

/// A direction within an angle of another.
fn near(v: DVec3, most: f64, random: &mut Random) -> DVec3 {
    let angle = most * crate::shade::uniform(random);
    turned(v, angle, random)
}
