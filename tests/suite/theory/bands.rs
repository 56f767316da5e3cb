//! Mach bands on a cylinder of N flat sides with the normals of the round one, and affine colours under perspective.
//!
//! The cylinder has radius 1, the light comes at θL from the axis of view, a vertex lies at θ, and x = sin θ on the picture;
//! Δ = 2π/N.

use super::{HALF_STEP, Lit, diffuse};
use crease::mesh::{Faces, MeshBuilder};
use crease::normals::{NormalRecipe, compute};
use crease::num::{Degrees, LinearRgb};
use crease::raster::{
    Camera, Interpolation, Object, ObjectSettings, Paint, Projection, RenderSettings, Scene, Shading, Shape,
    render,
};
use crease::shade::Optics;
use glam::{DMat4, DVec3};

fn round(angle: f64) -> DVec3 {
    DVec3::new(libm::sin(angle), 0.0, libm::cos(angle))
}

/// The cylinder under its light.
struct Cylinder {
    lit: Lit,
    light: f64,
    delta: f64,
}

impl Cylinder {
    fn new(sides: usize, light: f64) -> Self {
        let delta = std::f64::consts::TAU / sides as f64;
        Self { lit: Lit::far(&diffuse(), round(light), DVec3::Z), light, delta }
    }

    /// Step of flat shading between the sides that meet at a vertex.
    fn flat(&self, vertex: f64) -> f64 {
        self.lit.of(round(vertex + 0.5 * self.delta)) - self.lit.of(round(vertex - 0.5 * self.delta))
    }

    /// Jump of the slope of Gouraud's colours.
    fn gouraud(&self, vertex: f64) -> f64 {
        let slope =
            |a: f64, b: f64| (self.lit.of(round(b)) - self.lit.of(round(a))) / (libm::sin(b) - libm::sin(a));
        slope(vertex, vertex + self.delta) - slope(vertex - self.delta, vertex)
    }

    /// Jump of the slope of the colours of interpolated normals, by differences next to the vertex.
    fn phong(&self, vertex: f64) -> f64 {
        let side = |other: f64| {
            let (a, b) = (round(vertex), round(other));
            let at = |t: f64| self.lit.of(a + (b - a) * t);
            // Second order at the end of an interval.
            let step = 1e-5;
            let slope = (4.0 * at(step) - at(2.0 * step) - 3.0 * at(0.0)) / (2.0 * step);
            slope / (b.x - a.x)
        };
        side(vertex + self.delta) - side(vertex - self.delta)
    }

    fn tangents(&self, vertex: f64) -> f64 {
        libm::tan(vertex + 0.5 * self.delta) - libm::tan(vertex - 0.5 * self.delta)
    }
}

#[test]
fn steps_and_jumps_are_those_of_the_formulas() {
    let mut compared = 0;
    for sides in [16, 32, 64, 128] {
        for light in [-80.0_f64, -40.0, 0.0, 25.0, 60.0] {
            let cylinder = Cylinder::new(sides, light.to_radians());
            for degrees in -60..=60 {
                let vertex = f64::from(degrees).to_radians();
                let lit = [-1.5, 1.5].map(|k| (vertex + k * cylinder.delta - cylinder.light).abs());
                let seen = [-1.0, 1.0].map(|k| (vertex + k * cylinder.delta).abs());
                // Formulas hold where nothing is turned away from light or viewer.
                if lit.iter().chain(&seen).any(|angle| *angle > 1.55) {
                    continue;
                }
                compared += 1;
                let (from_light, tangents) = (vertex - cylinder.light, cylinder.tangents(vertex));
                let flat = -2.0 * libm::sin(from_light) * libm::sin(0.5 * cylinder.delta);
                assert!((cylinder.flat(vertex) - flat).abs() < 1e-14);
                let gouraud = -libm::cos(cylinder.light) * tangents;
                assert!((cylinder.gouraud(vertex) - gouraud).abs() < 1e-11, "{sides} {light} {degrees}");
                let phong = -libm::sin(from_light) * libm::sin(vertex) * tangents;
                assert!((cylinder.phong(vertex) - phong).abs() < 1e-7, "{sides} {light} {degrees}");
            }
        }
    }
    assert!(compared > 1000, "{compared}");
    // The printed example: N = 16, θ = −45°, θL = −80°.
    let printed = Cylinder::new(16, f64::to_radians(-80.0));
    let vertex = f64::to_radians(-45.0);
    assert!(
        (printed.gouraud(vertex) + 0.14385).abs() < 5e-6 && (printed.phong(vertex) - 0.33599).abs() < 5e-6
    );
}

/// Phong's bands are the stronger ones somewhere on the lit arc if and only if cos θL < 1/3: from 70.5288° on.
#[test]
fn phong_is_worse_than_gouraud_beyond_70_degrees() {
    let share = |light: f64| {
        let cylinder = Cylinder::new(4096, light.to_radians());
        // Seen and lit: from the silhouette to where the light ends, less than a side from either.
        let (low, high) = (f64::max(-90.0, light - 90.0), f64::min(90.0, light + 90.0));
        let vertices = (1..2000).map(|k| low + (high - low) * f64::from(k) / 2000.0);
        let inside = vertices.filter(|v| *v > low + 0.2 && *v < high - 0.2).map(f64::to_radians);
        let worse: Vec<bool> =
            inside.map(|v| cylinder.phong(v).abs() > cylinder.gouraud(v).abs() * (1.0 + 1e-3)).collect();
        worse.iter().filter(|worse| **worse).count() as f64 / worse.len() as f64
    };
    assert_eq!(share(60.0), 0.0);
    assert_eq!(share(70.0), 0.0);
    assert!(share(71.0) > 0.0);
    // Printed: .592 and .796 of the lit, visible arc.
    assert!((share(80.0) - 0.592).abs() < 0.01 && (share(85.0) - 0.796).abs() < 0.01);
}

/// The ratio of the two jumps is sin(θL − θ) sin θ / cos θL, whose largest is at θ = θL/2: there Phong's bands become the
/// stronger ones first, where cos θL = 1/3.
#[test]
fn phong_becomes_worse_at_half_the_lights_angle_first() {
    let ratio = |light: f64, vertex: f64| {
        let cylinder = Cylinder::new(128, light.to_radians());
        let vertex = vertex.to_radians();
        cylinder.phong(vertex).abs() / cylinder.gouraud(vertex).abs()
    };
    let turning = libm::acos(1.0 / 3.0).to_degrees();
    assert!((turning - 70.5288).abs() < 5e-5);
    // At 10⁻³ degrees from it the ratio is 7.4e-5 off 1; differences resolve it to 1e-6.
    assert!(ratio(turning - 1e-3, 0.5 * turning) < 1.0 && ratio(turning + 1e-3, 0.5 * turning) > 1.0);
    for light in [60.0, turning, 80.0] {
        let places: Vec<f64> = (1..40).map(|k| light * f64::from(k) / 40.0).collect();
        let worst = places.iter().copied().max_by(|a, b| ratio(light, *a).total_cmp(&ratio(light, *b)));
        assert!((worst.unwrap() - 0.5 * light).abs() < 1e-9, "{light}: {worst:?}");
    }
}

/// Under light at right angles to the view N·L is x itself: Gouraud is exact, and Phong alone has bands, on all of the lit arc.
#[test]
fn gouraud_is_exact_where_light_comes_from_the_side() {
    let cylinder = Cylinder::new(16, std::f64::consts::FRAC_PI_2);
    for side in 0..3 {
        let [a, b] = [0.0, 1.0].map(|k| round((f64::from(side) + k) * cylinder.delta));
        for step in 0..=10 {
            let t = f64::from(step) / 10.0;
            let linear = cylinder.lit.of(a) * (1.0 - t) + cylinder.lit.of(b) * t;
            let x = a.x + (b.x - a.x) * t;
            assert!((linear - x).abs() < 1e-15 && (cylinder.lit.of(round(libm::asin(x))) - x).abs() < 1e-15);
        }
    }
    for degrees in 25..65 {
        let vertex = f64::from(degrees).to_radians();
        assert!(cylinder.gouraud(vertex).abs() < 1e-12 && cylinder.phong(vertex).abs() > 0.01, "{degrees}");
    }
}

/// A wall from depth 1 to depth ρ, colours 0 to 1 along it: at the share t of its width on the picture the true one is
/// t/(t + ρ(1 − t)), and affine colours are off by (√ρ − 1)/(√ρ + 1) at most.
#[test]
fn affine_colours_are_off_by_the_depth_ratios_bound() {
    for (ratio, printed) in [(1.5, 0.10102), (2.0, 0.17157), (4.0, 0.33333), (10.0, 0.51949)] {
        let [affine, right] =
            [Interpolation::Affine, Interpolation::Perspective].map(|i| wall(ratio, 1.0, i));
        let mut largest: f64 = 0.0;
        for (column, (affine, right)) in affine.iter().zip(&right).enumerate() {
            let t = (column as f64 + 0.5) / 256.0;
            let true_share = t / (t + ratio * (1.0 - t));
            // Corners are snapped to 1/256 of 256 pixels, and colours are f32: slopes are at most 1/ρ to ρ.
            assert!((f64::from(*affine) - t).abs() < 5e-5, "column {column}: {affine}");
            assert!((f64::from(*right) - true_share).abs() < 5e-5 * ratio, "column {column}: {right}");
            largest = largest.max(f64::from(affine - right));
        }
        let bound = (f64::sqrt(ratio) - 1.0) / (f64::sqrt(ratio) + 1.0);
        assert!((bound - printed).abs() < 5e-6);
        // The worst column is at most half a pixel from the worst place, where the error is flat.
        assert!((largest - bound).abs() < 1e-3, "ratio {ratio}: {largest} for {bound}");
    }
}

/// Affine colours that differ by Δc are within half a step of 8 bits if (√ρ − 1)/(√ρ + 1)·Δc < 1/510, and not beyond.
#[test]
fn affine_colours_are_within_half_a_step_up_to_the_rules_span() {
    for ratio in [1.5, 2.0, 4.0] {
        let bound = (f64::sqrt(ratio) - 1.0) / (f64::sqrt(ratio) + 1.0);
        // Snapping and f32 are some 1 % of so short a span.
        for (share, is_within) in [(0.95, true), (1.05, false)] {
            let span = share * HALF_STEP / bound;
            let [affine, right] =
                [Interpolation::Affine, Interpolation::Perspective].map(|i| wall(ratio, span, i));
            let largest =
                affine.iter().zip(&right).map(|(a, b)| f64::from((a - b).abs())).fold(0.0, f64::max);
            assert_eq!(largest < HALF_STEP, is_within, "ratio {ratio}, {share}: {largest}");
        }
    }
}

/// The middle row of a picture of the wall, `span` from 0, which fills its width exactly.
fn wall(ratio: f64, span: f64, interpolation: Interpolation) -> Vec<f32> {
    let corners = [[-1.0, -1.0], [ratio, -ratio], [ratio, ratio], [-1.0, 1.0]];
    let positions = corners.map(|[x, z_or_y]: [f64; 2]| DVec3::new(x, 2.0 * z_or_y, -x.abs())).to_vec();
    let mut faces = Faces::new();
    faces.push(&[0, 1, 2, 3]);
    let mesh = MeshBuilder { positions: positions.into(), faces, ..MeshBuilder::default() }.build().unwrap();
    let normals = compute(&mesh, &NormalRecipe::default());
    let colours = [0.0, span, span, 0.0].map(LinearRgb::grey).to_vec();
    let object = Object {
        settings: ObjectSettings::default(),
        shape: Shape::Mesh { mesh: &mesh, normals: &normals },
        transform: DMat4::IDENTITY,
        paint: Paint::Given(colours.into()),
        surface: None,
        optics: Optics::NONE,
    };
    let scene = Scene {
        camera: Camera {
            eye: DVec3::ZERO,
            target: DVec3::NEG_Z,
            up: DVec3::Y,
            projection: Projection::Perspective(Degrees(90.0).into()),
            near: 0.1,
        },
        objects: vec![object],
        lines: Vec::new(),
        lights: Vec::new(),
        background: LinearRgb::BLACK,
    };
    let settings = RenderSettings {
        size: [256, 256],
        shading: Shading::Gouraud,
        interpolation,
        keep_linear: true,
        ..RenderSettings::default()
    };
    let image = render(&scene, &settings).unwrap();
    let row = &image.linear.unwrap()[128 * 256..129 * 256];
    row.iter().map(|colour| colour[0]).collect()
}
