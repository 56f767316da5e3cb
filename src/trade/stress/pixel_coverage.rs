//! The pixels that a triangle covers: by the rasterizer, by exact arithmetic, and by plain `f32` edge functions.

use crate::num::{Degrees, LinearRgb};
use crate::raster::{Camera, Object, Projection, RenderSettings, Scene, Shading, Shape, Triangles, render};
use crate::shade::Material;
use crate::trade::exact::Target;
use glam::{DVec3, Vec3};

/// A camera and the size of its picture.
pub(super) struct View {
    pub(super) size: [u32; 2],
    camera: Camera,
}

impl View {
    /// The distance of the near plane.
    pub(super) const NEAR: f64 = 0.01;

    /// The eye at the origin, looking along −z, 90° wide: a pixel's ray has whole multiples of 1/64 as coordinates.
    pub(super) fn perspective() -> Self {
        let camera = Camera {
            eye: DVec3::ZERO,
            target: DVec3::NEG_Z,
            up: DVec3::Y,
            projection: Projection::Perspective(Degrees(90.0).into()),
            near: Self::NEAR,
        };
        Self { size: [64, 64], camera }
    }

    /// Pixels are units of the scene, (0, 0) is the upper left corner once points are [`upright`](Self::upright).
    pub(super) fn orthographic(size: [u32; 2]) -> Self {
        let [width, height] = size.map(f64::from);
        let middle = DVec3::new(width, height, 0.0) * 0.5;
        let camera = Camera {
            eye: middle + DVec3::Z,
            target: middle,
            up: DVec3::Y,
            projection: Projection::Orthographic(height),
            near: 0.0,
        };
        Self { size, camera }
    }

    /// A point of the picture, y down, as a point of the scene, y up.
    pub(super) fn upright(&self, point: Vec3) -> Vec3 {
        Vec3::new(point.x, self.size[1] as f32 - point.y, point.z)
    }

    /// The number of covered samples of each pixel, of one.
    pub(super) fn draw(&self, positions: &[Vec3], triangles: &[[u32; 3]]) -> Vec<u8> {
        let positions: Vec<[f32; 3]> = positions.iter().map(Vec3::to_array).collect();
        let normals = vec![[0.0, 0.0, 1.0]; positions.len()];
        let shape = Triangles { positions: &positions, triangles, normals: &normals, face_normals: &[] };
        let scene = Scene {
            objects: vec![Object::new(Shape::Triangles(shape), Material::default())],
            lines: Vec::new(),
            lights: Vec::new(),
            camera: self.camera,
            background: LinearRgb::BLACK,
        };
        let settings =
            RenderSettings { size: self.size, shading: Shading::Gouraud, ..RenderSettings::default() };
        render(&scene, &settings).expect("a scene that can be drawn").coverage
    }

    /// The direction of a point of the picture of [`perspective`](Self::perspective), in pixels.
    fn ray(&self, x: f64, y: f64) -> DVec3 {
        let [width, height] = self.size.map(f64::from);
        DVec3::new(2.0 * x / width - 1.0, 1.0 - 2.0 * y / height, -1.0)
    }

    /// Corners on the picture of [`perspective`](Self::perspective) by division, whatever the divisor.
    pub(super) fn plain_projection(&self, triangle: &[Vec3; 3]) -> [Vec3; 3] {
        let [width, height] = self.size.map(|n| n as f32);
        triangle.map(|p| {
            let (x, y) = (p.x / -p.z, p.y / -p.z);
            Vec3::new((x + 1.0) * 0.5 * width, (1.0 - y) * 0.5 * height, 0.0)
        })
    }
}

/// Whether each pixel of a perspective view shows a triangle, by exact arithmetic; `None` so close to an edge that the
/// rounding of corners to 1/256 pixel may decide.
pub(super) fn true_coverage(triangle: &[Vec3; 3], view: &View) -> Vec<Option<bool>> {
    let target = Target::new(&triangle.map(|corner| corner.as_dvec3()), View::NEAR);
    let sees = |x: f64, y: f64| target.is_hit(view.ray(x, y));
    let [width, height] = view.size;
    let centres = (0..height).flat_map(|j| (0..width).map(move |i| (f64::from(i) + 0.5, f64::from(j) + 0.5)));
    let certain = |(x, y): (f64, f64)| {
        const OFF: f64 = 1.0 / 128.0;
        let middle = sees(x, y);
        let around = [(OFF, OFF), (OFF, -OFF), (-OFF, OFF), (-OFF, -OFF)];
        around.iter().all(|(dx, dy)| sees(x + dx, y + dy) == middle).then_some(middle)
    };
    centres.map(certain).collect()
}

/// The number of triangles that cover each pixel. They are drawn in several passes, so that the triangles of one pass, a
/// multiple of `passes` apart, have no edge in common.
pub(super) fn coverage_count(
    view: &View,
    positions: &[Vec3],
    triangles: &[[u32; 3]],
    passes: usize,
) -> Vec<u32> {
    let mut count = vec![0; (view.size[0] * view.size[1]) as usize];
    for pass in 0..passes {
        let some: Vec<[u32; 3]> = triangles.iter().copied().skip(pass).step_by(passes).collect();
        let coverage = view.draw(positions, &some);
        count.iter_mut().zip(coverage).for_each(|(n, c)| *n += u32::from(c));
    }
    count
}

/// Edge functions in `f32` at the pixel centres of the triangle's bounding box, edges included.
pub(super) fn plain_coverage(corners: &[Vec3; 3], [width, height]: [u32; 2]) -> Vec<u8> {
    let mut coverage = vec![0; (width * height) as usize];
    let edge = |a: Vec3, b: Vec3, x: f32, y: f32| (b.x - a.x) * (y - a.y) - (b.y - a.y) * (x - a.x);
    let [a, b, c] = *corners;
    let area = edge(a, b, c.x, c.y);
    let low = a.min(b).min(c).max(Vec3::ZERO);
    let high = a.max(b).max(c);
    for j in low.y as u32..(high.y as u32).saturating_add(1).min(height) {
        for i in low.x as u32..(high.x as u32).saturating_add(1).min(width) {
            let (x, y) = (i as f32 + 0.5, j as f32 + 0.5);
            let sides = [edge(a, b, x, y), edge(b, c, x, y), edge(c, a, x, y)];
            let is_inside = sides.iter().all(|side| side * area.signum() >= 0.0);
            coverage[(j * width + i) as usize] = u8::from(is_inside);
        }
    }
    coverage
}
