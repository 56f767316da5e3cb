//! Triangles that are hard to draw.

use super::case::{Bound, Measured, StressCase};
use super::group::Group;
use super::pixel_coverage::{View, coverage_count, plain_coverage, true_coverage};
use crate::num::numbers::Numbers;
use glam::Vec3;

/// The number of triangles of each kind, each in a separate picture.
const TRIANGLES: usize = 12;
/// Slivers in a disc of radius 30: each is 1/100 of a pixel wide at the rim.
const SLIVERS: usize = 20_000;
/// The picture of the large triangle.
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
        let (mut samples, mut wrong, mut plain_wrong) = (0, 0, 0);
        for _ in 0..TRIANGLES {
            let triangle = triangle(&mut numbers);
            let view = View::perspective();
            let drawn = view.draw(&triangle, &[[0, 1, 2]]);
            let plain = plain_coverage(&view.plain_projection(&triangle), view.size);
            for (pixel, truth) in true_coverage(&triangle, &view).into_iter().enumerate() {
                let Some(truth) = truth else { continue };
                samples += 1;
                wrong += usize::from((drawn[pixel] > 0) != truth);
                plain_wrong += usize::from((plain[pixel] > 0) != truth);
            }
        }
        Measured::wrong(samples, wrong, plain_wrong)
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
    let corners = [[0.0, 0.0], [0.0, 2048.0], [2048.0, 0.0]].map(|[x, y]| Vec3::new(x, y, 0.0));
    let drawn = view.draw(&corners.map(|corner| view.upright(corner)), &[[0, 1, 2]]);
    let plain = plain_coverage(&corners, LARGE);
    let wrong = |coverage: &[u8]| {
        let is_wrong = |&pixel: &usize| {
            let (i, j) = (pixel % LARGE[0] as usize, pixel / LARGE[0] as usize);
            (coverage[pixel] > 0) != (i + j + 1 < 2048)
        };
        (0..coverage.len()).filter(is_wrong).count()
    };
    Measured::wrong(drawn.len(), wrong(&drawn), wrong(&plain))
}

/// Slivers that together are a disc: each pixel of it belongs to exactly one.
fn measure_slivers() -> Measured {
    let size = [64, 64];
    let view = View::orthographic(size);
    // The middle of a pixel, which every sliver touches; many spokes pass through the middles of other pixels.
    let middle = [32.5, 32.5];
    let rim = |k: usize| {
        let turn = std::f64::consts::TAU * k as f64 / SLIVERS as f64;
        [middle[0] + 30.0 * libm::cos(turn), middle[1] + 30.0 * libm::sin(turn)]
    };
    let points: Vec<[f64; 2]> = std::iter::once(middle).chain((0..SLIVERS).map(rim)).collect();
    let points: Vec<Vec3> = points.iter().map(|p| Vec3::new(p[0] as f32, p[1] as f32, 0.0)).collect();
    let triangles: Vec<[u32; 3]> =
        (0..SLIVERS as u32).map(|k| [0, (k + 1) % SLIVERS as u32 + 1, k + 1]).collect();
    let upright: Vec<Vec3> = points.iter().map(|&point| view.upright(point)).collect();
    // Sixteen passes, so that no two slivers of one pass share an edge.
    let count = coverage_count(&view, &upright, &triangles, 16);
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
        (0..count.len()).filter(is_wrong).count()
    };
    Measured::wrong(count.len(), wrong(&count), wrong(&plain))
}
