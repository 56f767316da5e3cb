//! Light from behind the sphere, and what of it a highlight shows on the dark side.

use super::super::stage::linear;
use super::{BEHIND, WINDOW};
use crate::num::Radians;
use crate::raster::Image;
use glam::DVec3;

/// The normal of the sphere at a pixel of a picture of this size.
fn normal(pixel: u32, size: u32) -> Option<DVec3> {
    let place = |k: u32| ((f64::from(k) + 0.5) / f64::from(size) - 0.5) * WINDOW;
    let (x, y) = (place(pixel % size), place(pixel / size));
    let square = 1.0 - x * x - y * y;
    (square > 0.0).then(|| DVec3::new(x, y, square.sqrt()))
}

fn light() -> DVec3 {
    let (sine, cosine) = libm::sincos(Radians::from(BEHIND).0);
    DVec3::new(sine, 0.0, cosine)
}

/// Pixels with N·L < 0, by more than single precision leaves open.
fn turned_away(size: u32) -> impl Iterator<Item = (usize, DVec3)> {
    let pixels = (0..size * size).filter_map(move |pixel| Some((pixel as usize, normal(pixel, size)?)));
    pixels.filter(|(_, normal)| normal.dot(light()) < -1e-6)
}

/// The brightest of them.
pub(super) fn brightest(image: &Image) -> f64 {
    let pixels = linear(image);
    turned_away(image.size[0]).map(|(pixel, _)| f64::from(pixels[pixel][0])).fold(0.0, f64::max)
}

/// The same by the formula: Blinn's (N·H)ⁿ.
pub(super) fn law(exponent: f64, size: u32) -> f64 {
    let half = (light() + DVec3::Z).normalize();
    let highlight = |(_, normal): (usize, DVec3)| libm::pow(normal.dot(half).max(0.0), exponent);
    turned_away(size).map(highlight).fold(0.0, f64::max)
}
