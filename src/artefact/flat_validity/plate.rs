//! A plate under a near lamp or before a near viewer, and the closed forms of its errors.

use super::super::prelude::*;
use std::f64::consts::SQRT_2;

/// Distances in circumradii of the face.
pub(super) const RATIOS: [f64; 6] = [2.0, 5.0, 10.0, 50.0, 100.0, 510.0];
/// The circumradius of the plate of side 2.
pub(super) const RADIUS: f64 = SQRT_2;

fn plate(cells: u32) -> Result<Mesh> {
    squares(cells, &[(DVec3::new(-1.0, -1.0, 0.0), DVec3::X * 2.0, DVec3::Y * 2.0)])
}

/// Parallelograms, given by a corner and two sides, cut into so many smaller ones each way.
pub(super) fn squares(cells: u32, sides: &[(DVec3, DVec3, DVec3)]) -> Result<Mesh> {
    let row = cells + 1;
    let share = |k: u32| f64::from(k) / f64::from(cells);
    let corners = sides.iter().flat_map(|&(corner, along, up)| {
        (0..row * row).map(move |k| corner + along * share(k % row) + up * share(k / row))
    });
    sheets(corners.collect(), [cells; 2])
}

fn centres(size: u32) -> impl Iterator<Item = DVec3> {
    let place = move |k: u32| (f64::from(k) + 0.5) * 2.0 / f64::from(size) - 1.0;
    (0..size * size).map(move |k| DVec3::new(place(k % size), -place(k / size), 0.0))
}

/// A lamp over the plate's middle, and chalk.
pub(super) struct Lamp {
    pub(super) angle: Degrees,
    pub(super) distance: f64,
}

impl Lamp {
    /// Flat shading against shading every pixel.
    pub(super) fn error(&self, cells: u32, size: u32) -> Result<f64> {
        difference(cells, chalk(), self.light(), front(2.0), size)
    }

    pub(super) fn light(&self) -> Light {
        lamp(direction(self.angle) * self.distance)
    }

    /// The same by the formula: N·L at the pixel and at the middle of its square. Pixels on an edge may count to either square, since
    /// edges snap to 256ths of pixels: the least and the most that the error may be.
    pub(super) fn law(&self, cells: u32, size: u32) -> (f64, f64) {
        let lamp = direction(self.angle) * self.distance;
        let light = |point: DVec3| ((lamp - point).z / (lamp - point).length()).max(0.0);
        let side = 2.0 / f64::from(cells);
        let snap = f64::from(cells) / (256.0 * f64::from(size));
        let middles = |x: f64| {
            let place = (x + 1.0) / side;
            [place - snap, place + snap].map(|place| (place.floor() + 0.5) * side - 1.0)
        };
        let errors = |p: DVec3| {
            let [[left, right], [low, high]] = [p.x, p.y].map(middles);
            let places = [(left, low), (left, high), (right, low), (right, high)];
            let errors = places.map(|(x, y)| (light(p) - light(DVec3::new(x, y, 0.0))).abs());
            (errors.into_iter().fold(f64::INFINITY, f64::min), errors.into_iter().fold(0.0, f64::max))
        };
        let larger = |(least, most): (f64, f64), (a, b): (f64, f64)| (least.max(a), most.max(b));
        centres(size).map(errors).fold((0.0, 0.0), larger)
    }
}

/// A viewer over the plate's middle, and nothing but Phong's highlight of a far light.
pub(super) struct Viewer {
    pub(super) angle: Degrees,
    pub(super) distance: f64,
    pub(super) exponent: f64,
}

impl Viewer {
    /// Flat shading against shading every pixel.
    pub(super) fn error(&self, cells: u32, size: u32) -> Result<f64> {
        let (material, light, camera) = self.scene();
        difference(cells, material, light, camera, size)
    }

    pub(super) fn scene(&self) -> (Material, Light, Camera) {
        let material = Material { reflection: Reflection::Phong, ..shiny([0.0, 1.0], self.exponent) };
        let light = light_at(self.angle);
        let camera = Camera {
            eye: DVec3::Z * self.distance,
            projection: Projection::Perspective(Radians(2.0 * libm::atan(1.0 / self.distance))),
            near: 0.5 * self.distance,
            ..front(2.0)
        };
        (material, light, camera)
    }

    /// The same by the formula, (V·R)ⁿ at the pixel and in the middle; and the steepest slope of that power at a pixel.
    pub(super) fn law(&self, size: u32) -> (f64, f64) {
        if self.angle.0.abs() >= 90.0 {
            return (0.0, 0.0);
        }
        let eye = DVec3::Z * self.distance;
        let mirrored = direction(Degrees(-self.angle.0));
        let cosine = |point: DVec3| (eye - point).normalize().dot(mirrored);
        // Even an exponent of 0 gives nothing where the mirrored ray leads away.
        let highlight = |cosine: f64| if cosine > 0.0 { libm::pow(cosine, self.exponent) } else { 0.0 };
        let slope = |cosine: f64| self.exponent * libm::pow(cosine.max(0.0), self.exponent - 1.0);
        let middle = highlight(cosine(DVec3::ZERO));
        let larger = |(off, steepest): (f64, f64), cosine: f64| {
            (off.max((highlight(cosine) - middle).abs()), steepest.max(slope(cosine)))
        };
        centres(size).map(cosine).fold((0.0, 0.0), larger)
    }
}

fn difference(cells: u32, material: Material, light: Light, camera: Camera, size: u32) -> Result<f64> {
    let paint = |shading| paint_plate(cells, material, light, camera, size, shading);
    largest_error(&paint(Shading::Flat)?, &paint(Shading::Phong)?)
}

pub(super) fn paint_plate(
    cells: u32,
    material: Material,
    light: Light,
    camera: Camera,
    size: u32,
    shading: Shading,
) -> Result<Image> {
    let mesh = plate(cells)?;
    let normals = compute(&mesh, &NormalRecipe::default());
    draw(vec![object(&mesh, &normals, material)], &[light], camera, settings([size; 2], shading))
}
