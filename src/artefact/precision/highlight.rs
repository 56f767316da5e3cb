//! A material with a highlight, and how much its light changes with the normal.

use super::super::prelude::*;
use crate::num::steepest_slope;

/// The shares of light that the material scatters and mirrors.
pub(super) const DIFFUSE: f64 = 0.3;
pub(super) const SPECULAR: f64 = 0.7;

/// A material that scatters and mirrors these shares of the light.
pub(super) fn with_shares(exponent: f64, [diffuse, specular]: [f64; 2]) -> Material {
    Material {
        ambient: Reflectance::NONE,
        diffuse: Reflectance::Merged(LinearRgb::grey(diffuse)),
        specular: Reflectance::Merged(LinearRgb::grey(specular)),
        exponent,
        ..Material::default()
    }
}

/// The material of the pictures.
pub(super) fn material(exponent: f64) -> Material {
    with_shares(exponent, [DIFFUSE, SPECULAR])
}

/// The error of a normal, in degrees, at which this highlight changes by half a step of 8 bits where it is steepest.
pub(super) fn needed(exponent: f64) -> f64 {
    Degrees::from(Radians(Threshold::HALF_STEP / (SPECULAR * steepest_slope(exponent)))).0
}

/// The largest change of the light for a normal that is off by so many degrees: Δ_d ≤ δ and Δ_s ≤ M(n) δ.
pub(super) fn bound(exponent: f64, degrees: f64) -> f64 {
    (DIFFUSE + SPECULAR * steepest_slope(exponent)) * Radians::from(Degrees(degrees)).0
}

/// The angle between two directions, in degrees.
pub(super) fn angle(a: DVec3, b: DVec3) -> f64 {
    Degrees::from(Radians(libm::atan2(a.cross(b).length(), a.dot(b)))).0
}
