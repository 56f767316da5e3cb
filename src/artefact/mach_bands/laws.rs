//! The jumps of luminance and of its slope at an edge, in closed form.

/// The jump at an edge at the angle θ (radians) under a light, for facets of the angle Δ (radians).
use super::super::prelude::*;

pub(super) type Law = fn(f64, Degrees, f64) -> f64;

pub(super) fn flat_step(theta: f64, light: Degrees, delta: f64) -> f64 {
    2.0 * libm::sin(theta - Radians::from(light).0).abs() * libm::sin(delta / 2.0)
}

pub(super) fn gouraud_jump(theta: f64, light: Degrees, delta: f64) -> f64 {
    -libm::cos(Radians::from(light).0) * (libm::tan(theta + delta / 2.0) - libm::tan(theta - delta / 2.0))
}

pub(super) fn phong_jump(theta: f64, light: Degrees, delta: f64) -> f64 {
    let bend = libm::tan(theta + delta / 2.0) - libm::tan(theta - delta / 2.0);
    -libm::sin(theta - Radians::from(light).0) * libm::sin(theta) * bend
}
