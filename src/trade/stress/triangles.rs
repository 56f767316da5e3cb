//! Triangles that are hard to draw: the pixels that they cover by the rasterizer, by exact arithmetic, and by plain `f32` edge
//! functions.

use super::prelude::*;
use crate::raster::{Camera, Object, Projection, RenderSettings, Scene, Shading, Shape, Triangles, render};
use crate::trade::exact::Target;

struct View {
    size: [u32; 2],
    camera: Camera,
}

impl View {
    const NEAR: f64 = 0.01;

    /// The eye at the origin, looking along −z, 90° wide: a pixel's ray has whole multiples of 1/64 as coordinates.
    fn perspective() -> Self {
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
    fn orthographic(size: [u32; 2]) -> Self {
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
    fn upright(&self, [x, y]: [f32; 2]) -> Vec3 {
        Vec3::new(x, self.size[1] as f32 - y, 0.0)
    }

    fn draw(&self, positions: &[Vec3], triangles: &[[u32; 3]]) -> Vec<u8> {
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
    fn plain_projection(&self, triangle: &[Vec3; 3]) -> [[f32; 2]; 3] {
        let [width, height] = self.size.map(|n| n as f32);
        triangle.map(|p| {
            let (x, y) = (p.x / -p.z, p.y / -p.z);
            [(x + 1.0) * 0.5 * width, (1.0 - y) * 0.5 * height]
        })
    }
}

/// Whether the plain formula covers a pixel in exact arithmetic: edge functions of corners divided by w, whatever its sign.
fn covers_by_definition(triangle: &[Vec3; 3], target: &Target, ray: DVec3) -> bool {
    let w = triangle.map(|corner| if corner.z == 0.0 { 0 } else { -corner.z.signum() as i8 });
    let sides = target.sides(ray);
    let edges = [0, 1, 2].map(|k| sides[k] * w[k] * w[(k + 1) % 3]);
    !w.contains(&0) && (edges.iter().all(|&edge| edge >= 0) || edges.iter().all(|&edge| edge <= 0))
}

/// Whether each pixel of a perspective view shows a triangle, by exact arithmetic, and whether by the plain formula; `None` so
/// close to an edge that the rounding of corners to 1/256 pixel may decide.
fn true_coverage(triangle: &[Vec3; 3], view: &View) -> Vec<Option<[bool; 2]>> {
    let target = Target::new(&triangle.map(|corner| corner.as_dvec3()), View::NEAR);
    let sees = |x: f64, y: f64| target.is_hit(view.ray(x, y));
    let [width, height] = view.size;
    let centres = (0..height).flat_map(|j| (0..width).map(move |i| (f64::from(i) + 0.5, f64::from(j) + 0.5)));
    let certain = |(x, y): (f64, f64)| {
        const OFF: f64 = 1.0 / 128.0;
        let middle = sees(x, y);
        let around = [(OFF, OFF), (OFF, -OFF), (-OFF, OFF), (-OFF, -OFF)];
        let is_certain = around.iter().all(|(dx, dy)| sees(x + dx, y + dy) == middle);
        is_certain.then(|| [middle, covers_by_definition(triangle, &target, view.ray(x, y))])
    };
    centres.map(certain).collect()
}

/// The number of triangles that cover each pixel. They are drawn in several passes, so that the triangles of one pass, at
/// a distance of a multiple of `passes`, have no edge in common.
fn coverage_count(view: &View, positions: &[Vec3], triangles: &[[u32; 3]], passes: usize) -> Vec<u32> {
    let mut count = vec![0; (view.size[0] * view.size[1]) as usize];
    for pass in 0..passes {
        let some: Vec<[u32; 3]> = triangles.iter().copied().skip(pass).step_by(passes).collect();
        let coverage = view.draw(positions, &some);
        count.iter_mut().zip(coverage).for_each(|(n, c)| *n += u32::from(c));
    }
    count
}

/// Edge functions at the pixel centres of the triangle's bounding box, edges included.
fn plain_coverage<R: Real>(corners: &[[R; 2]; 3], [width, height]: [u32; 2]) -> Vec<u8> {
    let mut coverage = vec![0; (width * height) as usize];
    let edge = |a: [R; 2], b: [R; 2], x: R, y: R| (b[0] - a[0]) * (y - a[1]) - (b[1] - a[1]) * (x - a[0]);
    let [a, b, c] = *corners;
    let area = edge(a, b, c[0], c[1]);
    let sign = if area < R::ZERO { -R::ONE } else { R::ONE };
    let range = |axis: usize, size: u32| {
        let all = corners.map(|corner| corner[axis].to_f64());
        let (low, high) =
            (all.into_iter().fold(f64::NAN, f64::min), all.into_iter().fold(f64::NAN, f64::max));
        low.max(0.0) as u32..(high as u32).saturating_add(1).min(size)
    };
    for j in range(1, height) {
        for i in range(0, width) {
            let (x, y) = (R::of(f64::from(i) + 0.5), R::of(f64::from(j) + 0.5));
            let sides = [edge(a, b, x, y), edge(b, c, x, y), edge(c, a, x, y)];
            coverage[(j * width + i) as usize] =
                u8::from(sides.into_iter().all(|side| side * sign >= R::ZERO));
        }
    }
    coverage
}

/// The number of triangles of each kind, each in a separate picture.
const TRIANGLES: usize = 12;
/// Slivers in a disc of radius 30: each is 1/100 of a pixel wide at the rim.
const SLIVERS: usize = 20_000;
const LARGE: [u32; 2] = [2048, 1024];

pub(super) fn cases() -> Vec<StressCase> {
    vec![
        view_case("far-corners", "1e30 off the picture", far_away),
        view_case("behind-eye", "behind the eye", behind_the_eye),
        view_case("near-plane", "w near 0", near_zero),
        case("large", "a million pixels", "large-bound", measure_large),
        case("thin", "slivers thinner than a pixel", "thin-bound", measure_slivers),
    ]
}

fn case(
    texts: &'static str,
    name: &str,
    bound: &'static str,
    measure: impl Fn() -> Measured + Send + Sync + 'static,
) -> StressCase {
    StressCase::new(Group::Raster, texts, name, (Bound::none_wrong(bound), None), measure)
}

/// Pixels against exact arithmetic on the corners in the scene.
fn view_case(texts: &'static str, name: &str, triangle: fn(&mut Numbers) -> [Vec3; 3]) -> StressCase {
    case(texts, name, "view-bound", move || {
        let mut numbers = Numbers::new(24);
        let (mut samples, mut wrong) = (0, [0; 3]);
        for _ in 0..TRIANGLES {
            let triangle = triangle(&mut numbers);
            let view = View::perspective();
            let drawn = view.draw(&triangle, &[[0, 1, 2]]);
            let plain = plain_coverage(&view.plain_projection(&triangle), view.size);
            for (pixel, truth) in true_coverage(&triangle, &view).into_iter().enumerate() {
                let Some([truth, by_definition]) = truth else { continue };
                samples += 1;
                let shown = [drawn[pixel] > 0, plain[pixel] > 0, by_definition];
                wrong.iter_mut().zip(shown).for_each(|(wrong, shown)| *wrong += usize::from(shown != truth));
            }
        }
        Measured::wrong(samples, wrong)
    })
}

fn within(numbers: &mut Numbers, low: f64, high: f64) -> f32 {
    (low + (high - low) * numbers.unit()) as f32
}

fn far_away(numbers: &mut Numbers) -> [Vec3; 3] {
    let mut far = || Vec3::from_array([0; 3].map(|_| within(numbers, -1e30, 1e30)));
    let (a, b) = (far(), far());
    [Vec3::new(within(numbers, -2.0, 2.0), within(numbers, -2.0, 2.0), -3.0), a, b]
}

fn behind_the_eye(numbers: &mut Numbers) -> [Vec3; 3] {
    let mut at = |low, high| {
        Vec3::new(within(numbers, -3.0, 3.0), within(numbers, -3.0, 3.0), within(numbers, low, high))
    };
    [at(-4.0, -1.0), at(-4.0, 4.0), at(0.1, 4.0)]
}

fn near_zero(numbers: &mut Numbers) -> [Vec3; 3] {
    let mut at = |size: f64, z: f32| Vec3::new(within(numbers, -size, size), within(numbers, -size, size), z);
    let near = View::NEAR as f32;
    let [a, b] = [at(3.0, -2.0), at(3.0, -4.0)];
    let w = [0.0, 1e-30, -1e-30, near * (1.0 + 1e-6), near * (1.0 - 1e-6)];
    let mut c = at(1e-3, 0.0);
    c.z = -w[numbers.below(w.len())];
    [a, b, c]
}

/// A triangle of 1.5 million pixels, with the centres of 1024 of them on its long edge.
fn measure_large() -> Measured {
    let view = View::orthographic(LARGE);
    let corners: [[f32; 2]; 3] = [[0.0, 0.0], [0.0, 2048.0], [2048.0, 0.0]];
    let drawn = view.draw(&corners.map(|corner| view.upright(corner)), &[[0, 1, 2]]);
    let plain = plain_coverage(&corners, LARGE);
    let exact = plain_coverage(&corners.map(|corner| corner.map(f64::from)), LARGE);
    let wrong = |coverage: &[u8]| {
        let is_wrong = |&pixel: &usize| {
            let (i, j) = (pixel % LARGE[0] as usize, pixel / LARGE[0] as usize);
            (coverage[pixel] > 0) != (i + j + 1 < 2048)
        };
        (0..coverage.len()).filter(is_wrong).count()
    };
    Measured::wrong(drawn.len(), [&drawn, &plain, &exact].map(|coverage| wrong(coverage)))
}

/// Slivers that together are a disc: each pixel of it belongs to exactly one.
fn measure_slivers() -> Measured {
    let size = [64, 64];
    let view = View::orthographic(size);
    // The middle of a pixel, which every sliver touches; many spokes pass through the middles of other pixels.
    let middle = [32.5, 32.5];
    let rim = |k: usize| {
        let turn = TAU * k as f64 / SLIVERS as f64;
        [middle[0] + 30.0 * libm::cos(turn), middle[1] + 30.0 * libm::sin(turn)]
    };
    let points = std::iter::once(middle).chain((0..SLIVERS).map(rim));
    let points: Vec<[f32; 2]> = points.map(|point| point.map(|x| x as f32)).collect();
    let triangles: Vec<[u32; 3]> =
        (0..SLIVERS as u32).map(|k| [0, (k + 1) % SLIVERS as u32 + 1, k + 1]).collect();
    let upright: Vec<Vec3> = points.iter().map(|&point| view.upright(point)).collect();
    // Sixteen passes, so that no two slivers of one pass share an edge.
    let count = coverage_count(&view, &upright, &triangles, 16);
    let mut plain = [(); 2].map(|()| vec![0_u32; count.len()]);
    for triangle in &triangles {
        let corners = triangle.map(|v| points[v as usize]);
        let exact = plain_coverage(&corners.map(|corner| corner.map(f64::from)), size);
        for (count, coverage) in plain.iter_mut().zip([plain_coverage(&corners, size), exact]) {
            count.iter_mut().zip(coverage).for_each(|(n, c)| *n += u32::from(c));
        }
    }
    let [plain, exact] = plain;
    let wrong = |count: &[u32]| {
        let is_wrong = |&pixel: &usize| {
            let (x, y) = ((pixel % 64) as f64 + 0.5 - middle[0], (pixel / 64) as f64 + 0.5 - middle[1]);
            let distance = libm::hypot(x, y);
            (distance - 30.0).abs() > 1.0 / 64.0 && count[pixel] != u32::from(distance < 30.0)
        };
        (0..count.len()).filter(is_wrong).count()
    };
    Measured::wrong(count.len(), [&count, &plain, &exact].map(|count| wrong(count)))
}
