//! What is drawn: a plate and a sphere whose highlights fall between vertices, and what light there is on them.

use super::super::prelude::*;
use std::f64::consts::SQRT_2;

/// Of diffuse light; the rest of 1 is highlight.
pub(super) const DIFFUSE: f64 = 0.4;
/// How far the normals at the corners of the plate lean outwards.
pub(super) const TILT: Degrees = Degrees(35.0);
/// The window's side; plate and sphere are 2 wide.
pub(super) const WINDOW: f64 = 2.2;

/// The light on a vertex whose normal is this far from the viewer and the light.
pub(super) fn law(angle: f64, exponent: f64) -> f64 {
    let cosine = libm::cos(angle);
    DIFFUSE * cosine + (1.0 - DIFFUSE) * libm::pow(cosine, exponent)
}

/// What is missing of the diffuse light of such a vertex.
pub(super) fn of_diffuse(angle: f64) -> f64 {
    DIFFUSE * (1.0 - libm::cos(angle))
}

pub(super) fn material(exponent: f64) -> Material {
    Material {
        ambient: Reflectance::NONE,
        diffuse: Reflectance::Merged(LinearRgb::grey(DIFFUSE)),
        specular: Reflectance::Merged(LinearRgb::grey(1.0 - DIFFUSE)),
        exponent,
        ..Material::default()
    }
}

/// Two triangles whose normals at the corners lean outwards.
pub(super) fn plate() -> TriangleMesh {
    let (sine, cosine) = libm::sincos(Radians::from(TILT).0);
    TriangleMesh::grid([1, 1], Diagonal::Rising, |u, v| {
        let place = DVec3::new(2.0 * u - 1.0, 2.0 * v - 1.0, 0.0);
        (place, place * (sine / SQRT_2) + DVec3::Z * cosine)
    })
}

/// Light and viewer in front, far away.
pub(super) fn paint(object: Object, size: u32, shading: Shading) -> Result<Image> {
    look(object, size, shading, WINDOW)
}

/// The same through a window of any side.
pub(super) fn look(object: Object, size: u32, shading: Shading, window: f64) -> Result<Image> {
    let light = Light::Directional { towards: DVec3::Z, colour: LinearRgb::WHITE };
    draw(vec![object], &[light], front(window), &settings([size; 2], shading, Interpolation::Perspective))
}
