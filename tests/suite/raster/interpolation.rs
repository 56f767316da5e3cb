//! How values spread over faces.

use super::shapes::{Model, linear, pixel_camera, scene};
use crease::num::{Degrees, LinearRgb, Transfer};
use crease::raster::{
    Camera, FlatSample, Image, Interpolation, Paint, Projection, RenderSettings, Scene, Shading, render,
};
use glam::DVec3;

/// Exercise 1.6.25: v1 to v4, of which v1 and v3 lie on the scanline through the centre at 0 degrees.
const DIAMOND: [[f64; 3]; 4] = [[0.0, 0.4, 0.4], [0.0, 0.2, 0.2], [0.2, 0.6, 0.6], [0.4, 0.4, 0.0]];

/// The diamond turned about its centre, the centre of pixel (50, 50), as one quad or as two triangles; and its picture.
fn diamond(degrees: f64, diagonal: Option<usize>, settings: &RenderSettings) -> Image {
    let centre = DVec3::new(50.5, 50.5, 0.0);
    let corner = |k: usize| {
        let (sin, cos) = libm::sincos((degrees + 90.0 * k as f64).to_radians());
        centre + DVec3::new(cos, sin, 0.0) * 45.0
    };
    let corners = [0, 1, 2, 3].map(corner).to_vec();
    let model = match diagonal {
        None => Model::polygon(&corners),
        Some(start) => {
            let [a, b, c, d] = [0, 1, 2, 3].map(|k| (start + k) as u32 % 4);
            Model::new(corners, crease::mesh::Faces::triangles(vec![a, b, c, a, c, d]))
        }
    };
    let mut object = model.object();
    object.paint = Paint::Given(DIAMOND.iter().map(|&colour| LinearRgb::from(colour)).collect());
    let scene = Scene { camera: pixel_camera([101, 101]), ..scene(vec![object]) };
    render(&scene, settings).unwrap()
}

fn settings(shading: Shading, interpolation: Interpolation) -> RenderSettings {
    RenderSettings { shading, interpolation, transfer: Transfer::Direct, ..linear([101, 101]) }
}

fn centre(image: &Image) -> [f64; 3] {
    let index = image.index(50, 50).unwrap();
    image.linear.as_ref().unwrap()[index].map(f64::from)
}

/// Within one step of 8 bits, as linear colours and as the picture's own numbers.
fn assert_close(image: &Image, expected: [f64; 3], what: &str) {
    let (got, pixel) = (centre(image), image.pixel(50, 50).unwrap());
    for k in 0..3 {
        assert!((got[k] - expected[k]).abs() < 1.0 / 255.0, "{what}: {got:?} is not {expected:?}");
        let code = (255.0 * expected[k]).round();
        assert!((f64::from(pixel[k]) - code).abs() <= 1.0, "{what}: {pixel:?} is not {expected:?}");
    }
}

/// The law of reference §4.1: the lectures' algorithm depends on how the polygon lies on the picture.
#[test]
fn the_scanline_diamond_turns_its_centre() {
    for shading in [Shading::Gouraud, Shading::Phong] {
        for step in 0..=18 {
            let degrees = 5.0 * f64::from(step);
            let (sin, cos) = libm::sincos(degrees.to_radians());
            let expected = [0, 1, 2].map(|k| {
                let (c13, c24) =
                    ((DIAMOND[0][k] + DIAMOND[2][k]) / 2.0, (DIAMOND[1][k] + DIAMOND[3][k]) / 2.0);
                (cos * c13 + sin * c24) / (cos + sin)
            });
            let image = diamond(degrees, None, &settings(shading, Interpolation::Scanline));
            assert_close(&image, expected, &format!("{degrees}°"));
        }
    }
    // Exercise 1.6.25b: the printed colours of both positions.
    let at = |degrees| diamond(degrees, None, &settings(Shading::Gouraud, Interpolation::Scanline));
    assert_close(&at(0.0), [0.1, 0.5, 0.5], "position 1");
    assert_close(&at(90.0), [0.2, 0.3, 0.1], "position 2");
}

/// In triangles it does not depend on how they lie, but on the diagonal; also with the scanline algorithm.
#[test]
fn triangles_depend_on_the_diagonal_instead() {
    for interpolation in [Interpolation::Scanline, Interpolation::Affine, Interpolation::Perspective] {
        for step in 0..=6 {
            let degrees = 15.0 * f64::from(step);
            for (start, expected) in [(0, [0.1, 0.5, 0.5]), (1, [0.2, 0.3, 0.1])] {
                let image = diamond(degrees, Some(start), &settings(Shading::Gouraud, interpolation));
                assert_close(&image, expected, &format!("{interpolation:?} {degrees}° {start}"));
            }
        }
    }
}

/// Exercise 1.6.25a: the flat colour is the mean of the corners', in any position.
#[test]
fn a_given_flat_colour_is_the_mean() {
    for degrees in [0.0, 33.0, 90.0] {
        for flat_sample in [FlatSample::Centroid, FlatSample::VertexMean] {
            let settings = RenderSettings { flat_sample, ..settings(Shading::Flat, Interpolation::Affine) };
            let got = centre(&diamond(degrees, None, &settings));
            // Single precision.
            assert!(got.iter().zip([0.15, 0.4, 0.3]).all(|(a, b)| (a - b).abs() < 1e-7), "{got:?}");
        }
    }
}

/// A strip that runs away from the viewer, its colour from 0 at the near edge to 1 at the far one.
fn strip(near: f64, far: f64) -> (Model, Scene<'static>) {
    let corners = [
        DVec3::new(-1.0, -1.0, -near),
        DVec3::new(1.0, -1.0, -near),
        DVec3::new(1.0, -1.0, -far),
        DVec3::new(-1.0, -1.0, -far),
    ];
    let mut scene = scene(Vec::new());
    scene.camera = Camera {
        eye: DVec3::ZERO,
        target: DVec3::NEG_Z,
        up: DVec3::Y,
        projection: Projection::Perspective(Degrees(100.0).into()),
        near: 0.01,
    };
    (Model::polygon(&corners), scene)
}

/// Reference §4.2: the largest error of interpolating on the picture is (√ρ−1)/(√ρ+1) for a ratio ρ of distances.
#[test]
fn affine_is_wrong_by_what_the_closed_form_says() {
    const SIZE: [u32; 2] = [3, 1501];
    for ratio in [1.5, 2.0, 4.0, 10.0_f64] {
        let (model, scene) = strip(1.0, ratio);
        let colour = [0.0, 0.0, 1.0, 1.0].map(LinearRgb::grey);
        let mut object = model.object();
        object.paint = Paint::Given(colour.to_vec().into());
        let scene = Scene { objects: vec![object], ..scene };
        let column = |interpolation| -> Vec<Option<f64>> {
            let image =
                render(&scene, &RenderSettings { shading: Shading::Gouraud, interpolation, ..linear(SIZE) });
            let image = image.unwrap();
            let linear = image.linear.unwrap();
            let rows = (0..SIZE[1] as usize).map(|y| 3 * y + 1);
            rows.map(|i| (image.coverage[i] > 0).then(|| f64::from(linear[i][0]))).collect()
        };
        let (right, affine) = (column(Interpolation::Perspective), column(Interpolation::Affine));
        let mut worst = 0.0_f64;
        let mut rows = 0;
        for (y, (right, affine)) in right.iter().zip(&affine).enumerate() {
            let (Some(right), Some(affine)) = (right, affine) else { continue };
            worst = worst.max(affine - right);
            rows += 1;
            // The truth from the ray: y = −1 at distance z, so z = 1/tan of the pixel's angle below the axis.
            let slope = (y as f64 + 0.5 - 750.5) / 750.5 * libm::tan(50.0_f64.to_radians());
            let truth = (1.0 / slope - 1.0) / (ratio - 1.0);
            // Snapping moves an edge by 1/512 pixel; at the far edge a pixel is the most.
            assert!((right - truth).abs() < 1e-4 * ratio, "{ratio} {y}: {right} is not {truth}");
        }
        let expected = (ratio.sqrt() - 1.0) / (ratio.sqrt() + 1.0);
        // The maximum is flat, so sampling it on some hundred rows costs little.
        assert!(rows > 200 && (worst - expected).abs() < 2e-4, "{ratio}: {worst} is not {expected}");
    }
}

/// In a parallel projection there is no perspective to be right about.
#[test]
fn parallel_projections_interpolate_alike() {
    let [affine, perspective] = [Interpolation::Affine, Interpolation::Perspective]
        .map(|interpolation| diamond(20.0, None, &settings(Shading::Phong, interpolation)).linear.unwrap());
    assert!(affine == perspective);
}

/// Gouraud stays within its corners' colours, sample by sample, and Phong need not: exercise 1.6.7's plate.
#[test]
fn gouraud_stays_within_its_corners_and_phong_does_not() {
    // A plate under a spot-like highlight in its middle: corners away from it.
    let corners = [[-1.0, -1.0], [1.0, -1.0], [1.0, 1.0], [-1.0, 1.0]].map(|[x, y]| DVec3::new(x, y, 0.0));
    let plate = Model::polygon(&corners);
    let mut scene = scene(vec![plate.object()]);
    scene.lights = vec![crease::shade::Light::Point {
        position: DVec3::new(0.0, 0.0, 0.7),
        colour: LinearRgb::WHITE,
        attenuation: crease::shade::Attenuation::None,
    }];
    for interpolation in [Interpolation::Scanline, Interpolation::Affine, Interpolation::Perspective] {
        let draw = |shading| {
            let image =
                render(&scene, &RenderSettings { shading, interpolation, ..linear([80, 80]) }).unwrap();
            let pixels = image.linear.unwrap().into_iter().zip(image.coverage).filter(|(_, n)| *n > 0);
            pixels.map(|(colour, _)| colour[1]).collect::<Vec<f32>>()
        };
        let (gouraud, phong) = (draw(Shading::Gouraud), draw(Shading::Phong));
        let range =
            |pixels: &[f32]| pixels.iter().fold((1.0_f32, 0.0_f32), |(l, h), &x| (l.min(x), h.max(x)));
        // All four corners are lit alike, so Gouraud is constant but for the rounding of its weights.
        let (low, high) = range(&gouraud);
        assert!(high - low < 3e-7, "{interpolation:?}: {low} {high}");
        assert!(range(&phong).1 > 2.0 * high, "{interpolation:?}");
    }
}

/// Weights are never negative, so no sample leaves the range of its corners' colours: in any projection, at any tilt,
/// clipped or not.
#[test]
fn gouraud_stays_within_the_hull_of_random_triangles() {
    let mut random = crate::random::Random(51);
    let mut samples = 0;
    for round in 0..300 {
        let mut number = || super::shapes::unit(&mut random);
        let corners = [(); 3].map(|()| DVec3::new(number(), number(), number()) * 6.0 - 3.0);
        let colours = [(); 3].map(|()| LinearRgb::new(number(), number(), number()));
        let triangle = Model::polygon(&corners);
        let mut object = triangle.object();
        object.paint = Paint::Given(colours.to_vec().into());
        let mut scene = scene(vec![object]);
        scene.camera.eye = DVec3::new(0.0, 0.0, 1.5);
        for interpolation in [Interpolation::Scanline, Interpolation::Affine, Interpolation::Perspective] {
            let settings = RenderSettings { shading: Shading::Gouraud, interpolation, ..linear([48, 48]) };
            let image = render(&scene, &settings).unwrap();
            for (colour, coverage) in image.linear.unwrap().into_iter().zip(image.coverage) {
                if coverage == 0 {
                    continue;
                }
                samples += 1;
                for (k, &component) in colour.iter().enumerate() {
                    let each = colours.map(|colour| colour.to_array()[k] as f32);
                    let (low, high) = (each.into_iter().reduce(f32::min), each.into_iter().reduce(f32::max));
                    // Three products and two sums in single precision.
                    let room = 4.0 * f32::EPSILON;
                    assert!(component >= low.unwrap() - room && component <= high.unwrap() + room, "{round}");
                }
            }
        }
    }
    assert!(samples > 50_000, "{samples}");
}
