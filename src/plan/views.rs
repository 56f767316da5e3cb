//! Views around a scene.

use crate::raster::Camera;
use glam::{DVec3, dvec3};
use std::f64::consts::PI;

/// Views at the same distance as a camera on a sphere around its target, evenly spread: Fibonacci's lattice (Á. González, *Measurement of areas
/// on a sphere using Fibonacci and latitude–longitude lattices*, Mathematical Geosciences 42, 2010). `offset` from 0 to 1 moves all of them
/// along the spiral: views between the others have one half.
pub fn around(camera: &Camera, count: u32, offset: f64) -> Vec<Camera> {
    let golden = PI * (3.0 - 5.0_f64.sqrt());
    let distance = camera.eye.distance(camera.target);
    let view = |number: u32| {
        let place = f64::from(number) + offset;
        let y = 1.0 - 2.0 * (place + 0.5) / (f64::from(count) + 1.0).max(1.0);
        let (ring, angle) = ((1.0 - y * y).max(0.0).sqrt(), golden * place);
        let towards = dvec3(ring * libm::cos(angle), y, ring * libm::sin(angle));
        let up = if y.abs() > 0.99 { DVec3::X } else { DVec3::Y };
        Camera { eye: camera.target + towards * distance, up, ..*camera }
    };
    (0..count).map(view).collect()
}
