//! Plates one behind the other, which fade with their distance from the viewer.

use super::super::prelude::*;
use crate::shade::DepthCue;

/// Distances of the plates that fade with depth, from the viewer, and their k.
pub(super) const DEPTHS: [f64; 3] = [4.0, 7.0, 12.0];
pub(super) const CUE: DepthCue = DepthCue { k: 1.0 };
/// The tangent of half the angle of view at which they are seen.
const TANGENT: f64 = 0.5;

/// Three equal plates one behind the other, of the same size on the picture.
pub(super) fn plates(depth_cue: Option<DepthCue>, size: u32) -> Result<Image> {
    let bodies: Vec<TriangleMesh> = (0..3)
        .map(|plate| {
            let depth = DEPTHS[plate];
            let (middle, half) = ((plate as f64 - 1.0) * 0.6, 0.25);
            TriangleMesh::grid([1, 1], Diagonal::Rising, |u, v| {
                let [x, y] = [middle + (2.0 * u - 1.0) * half, (2.0 * v - 1.0) * 2.5 * half];
                (DVec3::new(x, y, 0.0) * (TANGENT * depth) - DVec3::Z * depth, DVec3::Z)
            })
        })
        .collect();
    let camera = Camera {
        eye: DVec3::ZERO,
        target: DVec3::NEG_Z,
        projection: Projection::Perspective(Radians(2.0 * libm::atan(TANGENT))),
        near: 1.0,
        ..front(1.0)
    };
    let light = Light::Directional {
        towards: DVec3::Z,
        colour: LinearRgb::grey(if depth_cue.is_some() { 4.0 } else { 0.8 }),
    };
    let settings =
        RenderSettings { depth_cue, ..settings([size; 2], Shading::Phong, Interpolation::Perspective) };
    draw(bodies.iter().map(|body| body.object(chalk())).collect(), &[light], camera, &settings)
}

/// The pixel in the middle of a plate.
pub(super) fn plate_pixel([width, height]: [u32; 2], plate: usize) -> [u32; 2] {
    [(f64::from(width) * (0.5 + 0.5 * (plate as f64 - 1.0) * 0.6)) as u32, height / 2]
}

/// The distance to what is seen at a pixel's centre, over its depth: the secant of the angle off the axis of view.
pub(super) fn obliqueness(pixel: [u32; 2], size: u32) -> f64 {
    let [x, y] = pixel.map(|k| TANGENT * (2.0 * (f64::from(k) + 0.5) / f64::from(size) - 1.0));
    (1.0 + x * x + y * y).sqrt()
}

/// The luminance in the middle of a plate.
pub(super) fn plate_value(image: &Image, plate: usize) -> f64 {
    let [x, y] = plate_pixel(image.size, plate);
    image.index(x, y).map_or(f64::NAN, |i| f64::from(linear(image)[i][0]))
}
