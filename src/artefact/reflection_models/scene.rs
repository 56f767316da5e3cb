//! A sphere with nothing but a highlight.

use super::super::prelude::*;
use crate::shade::Guards;

/// Light far round the sphere.
pub(super) const GRAZING: Degrees = Degrees(120.0);
/// The window's side; the sphere has the radius 1.
pub(super) const WINDOW: f64 = 2.2;

/// The true sphere with nothing but a highlight.
pub(super) fn ball(
    reflection: Reflection,
    exponent: f64,
    light: Degrees,
    guards: Guards,
    size: u32,
) -> Result<Image> {
    let material = Material {
        ambient: Reflectance::NONE,
        diffuse: Reflectance::NONE,
        specular: Reflectance::Merged(LinearRgb::WHITE),
        exponent,
        reflection,
    };
    let sphere = Object::new(Shape::Surface(Primitive::from(Sphere::default())), material);
    let settings =
        RenderSettings { guards, ..settings([size; 2], Shading::Exact, Interpolation::Perspective) };
    draw(vec![sphere], &[light_at(light)], front(WINDOW), &settings)
}
