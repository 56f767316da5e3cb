//! Triangles that are hard to draw.

use crate::num::numbers::Numbers;
use crate::trade::stress::case::{Bound, Measured, StressCase, Unit, Worst};
use crate::trade::stress::group::Group;
use crate::trade::stress::pictures::pixel_coverage::{Picture, covered_by, plain_coverage, seen_by};
use glam::Vec3;

/// Triangles of each kind, each on a picture of its own.
const TRIANGLES: usize = 12;
/// Slivers in a disc of radius 30: each is 1/100 of a pixel wide at the rim.
const SLIVERS: usize = 20_000;
/// The picture of the large triangle.
const LARGE: [u32; 2] = [2048, 1024];

pub(in crate::trade::stress) fn cases() -> Vec<StressCase> {
    let far = "one corner in sight, two 1e30 away in any direction, 64 × 64 pixels";
    let behind = "corners before and behind the eye, 64 × 64 pixels";
    let near = "one corner at w = 0, 1e-30 beside it, or a millionth before or behind the near plane, 64 × 64 pixels";
    vec![
        seen("1e30 off the picture", far, far_away),
        seen("behind the eye", behind, behind_the_eye),
        seen("w near 0", near, near_zero),
        large(),
        slivers(),
    ]
}

/// Pixels against exact arithmetic on the corners in the scene.
fn seen(name: &str, what: &'static str, triangle: fn(&mut Numbers) -> [Vec3; 3]) -> StressCase {
    let source = "exact signs of volumes at pixels whose centre is 1/128 pixel or more from an edge: corners snap to 1/256";
    StressCase {
        group: Group::Raster,
        name: name.into(),
        what,
        expectation: "every pixel right",
        bound: Bound::none_wrong(source),
        fast_bound: None,
        plain_unit: Unit::Wrong,
        plain_formula: "x/w, y/w; three edge functions >= 0 in f32",
        measure: Box::new(move || {
            let mut numbers = Numbers::new(24);
            let mut measured = Measured::default();
            let mut plain = Worst::default();
            for _ in 0..TRIANGLES {
                let triangle = triangle(&mut numbers);
                let picture = Picture::of_eye();
                let drawn = picture.draw(&triangle, &[[0, 1, 2]]);
                let portable = plain_coverage(&picture.naively_projected(&triangle), picture.size);
                for (pixel, truth) in seen_by(&triangle, &picture).into_iter().enumerate() {
                    let Some(truth) = truth else { continue };
                    measured.samples += 1;
                    measured.faithful.error += f64::from(u8::from((drawn[pixel] > 0) != truth));
                    plain.error += f64::from(u8::from((portable[pixel] > 0) != truth));
                }
            }
            Measured { plain: Some(plain), ..measured }
        }),
    }
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
    let near = Picture::NEAR as f32;
    let [a, b] = [at(3.0, -2.0), at(3.0, -4.0)];
    let w = [0.0, 1e-30, -1e-30, near * (1.0 + 1e-6), near * (1.0 - 1e-6)];
    let mut c = at(1e-3, 0.0);
    c.z = -w[numbers.below(w.len())];
    [a, b, c]
}

/// A triangle of 1.5 million pixels, with the centres of 1024 of them on its long edge.
fn large() -> StressCase {
    StressCase {
        group: Group::Raster,
        name: "a million pixels".into(),
        what: "corners (0, 0), (2048, 0), (0, 2048) on a picture of 2048 × 1024",
        expectation: "every pixel right, on the edge by the top-left rule",
        bound: Bound::none_wrong(
            "closed form: pixel (i, j) is covered if i + j + 1 < 2048, its centre on the edge is not",
        ),
        fast_bound: None,
        plain_unit: Unit::Wrong,
        plain_formula: "three edge functions >= 0 in f32",
        measure: Box::new(|| {
            let picture = Picture::of_pixels(LARGE);
            let corners = [[0.0, 0.0], [0.0, 2048.0], [2048.0, 0.0]].map(|[x, y]| Vec3::new(x, y, 0.0));
            let drawn = picture.draw(&corners.map(|corner| picture.upright(corner)), &[[0, 1, 2]]);
            let plain = plain_coverage(&corners, LARGE);
            let wrong = |coverage: &[u8]| {
                let is_wrong = |&pixel: &usize| {
                    let (i, j) = (pixel % LARGE[0] as usize, pixel / LARGE[0] as usize);
                    (coverage[pixel] > 0) != (i + j + 1 < 2048)
                };
                Worst::wrong((0..coverage.len()).filter(is_wrong).count())
            };
            let (faithful, plain) = (wrong(&drawn), Some(wrong(&plain)));
            Measured { samples: drawn.len(), faithful, plain, ..Measured::default() }
        }),
    }
}

/// Slivers that together are a disc: each pixel of it belongs to exactly one.
fn slivers() -> StressCase {
    StressCase {
        group: Group::Raster,
        name: "slivers thinner than a pixel".into(),
        what: "20000 triangles round a point, together a disc of radius 30 on 64 × 64 pixels",
        expectation: "every pixel of the disc is covered exactly once",
        bound: Bound::none_wrong(
            "neighbours share corners; pixels whose centre is within 1/64 pixel of the rim left out",
        ),
        fast_bound: None,
        plain_unit: Unit::Wrong,
        plain_formula: "three edge functions >= 0 in f32",
        measure: Box::new(measure_slivers),
    }
}

fn measure_slivers() -> Measured {
    let size = [64, 64];
    let picture = Picture::of_pixels(size);
    // In the middle of a pixel, which every sliver touches; many spokes run through others.
    let middle = [32.5, 32.5];
    let rim = |k: usize| {
        let turn = std::f64::consts::TAU * k as f64 / SLIVERS as f64;
        [middle[0] + 30.0 * libm::cos(turn), middle[1] + 30.0 * libm::sin(turn)]
    };
    let points: Vec<[f64; 2]> = std::iter::once(middle).chain((0..SLIVERS).map(rim)).collect();
    let points: Vec<Vec3> = points.iter().map(|p| Vec3::new(p[0] as f32, p[1] as f32, 0.0)).collect();
    let triangles: Vec<[u32; 3]> =
        (0..SLIVERS as u32).map(|k| [0, (k + 1) % SLIVERS as u32 + 1, k + 1]).collect();
    let upright: Vec<Vec3> = points.iter().map(|&point| picture.upright(point)).collect();
    // Each sliver with those far from it, so that no two of one drawing share an edge.
    let count = covered_by(&picture, &upright, &triangles, 16);
    let mut plain = vec![0_u32; count.len()];
    for triangle in &triangles {
        let corners = triangle.map(|v| points[v as usize]);
        plain.iter_mut().zip(plain_coverage(&corners, size)).for_each(|(n, c)| *n += u32::from(c));
    }
    let wrong = |count: &[u32]| {
        let is_wrong = |&pixel: &usize| {
            let (x, y) = ((pixel % 64) as f64 + 0.5 - middle[0], (pixel / 64) as f64 + 0.5 - middle[1]);
            let distance = libm::hypot(x, y);
            (distance - 30.0).abs() > 1.0 / 64.0 && count[pixel] != u32::from(distance < 30.0)
        };
        Worst::wrong((0..count.len()).filter(is_wrong).count())
    };
    let (faithful, plain) = (wrong(&count), Some(wrong(&plain)));
    Measured { samples: count.len(), faithful, plain, ..Measured::default() }
}
