//! Speed of drawing as ratios, for the README: every candidate in turn, several rounds, medians.
//!
//!     cargo bench --bench raster -- [ROUNDS] [TRIANGLES]... [in-order]
//!
//! A torus seen by a perspective camera covers 40 % of 1920 × 1080 pixels; one directional light, Blinn's highlight with
//! n = 32 and the viewer where the camera is, back faces culled, 8 bits without transfer. The baseline is a plain scalar
//! rasterizer in one thread.

#![allow(clippy::print_stdout, reason = "it prints a table")]

mod baseline;

use baseline::{Baseline, Mode};
use crease::num::{Degrees, LinearRgb, Transfer};
use crease::raster::{
    Camera, Cull, Object, Projection, RenderSettings, Scene, Shading, Shape, Statistics, Times, Triangles,
    render,
};
use crease::shade::{Light, Material};
use glam::{DMat4, DVec3};
use std::f64::consts::TAU;
use std::hint::black_box;
use std::time::Instant;

const SIZE: [u32; 2] = [1920, 1080];
const TOWARDS: DVec3 = DVec3::new(0.4, 0.6, 1.0);
const EYE: DVec3 = DVec3::new(0.0, 3.2, 4.0);

fn main() {
    let numbers: Vec<usize> =
        std::env::args().skip(1).filter_map(|argument| argument.replace('_', "").parse().ok()).collect();
    let rounds = numbers.first().copied().unwrap_or(7).max(5);
    let sizes = if numbers.len() > 1 { numbers[1..].to_vec() } else { vec![70_000, 1_000_000] };
    println!(
        "| triangles | shading | baseline ms | 1 thread | 2 threads | covered | geometry, bins, tiles ms |"
    );
    println!("|---|---|---:|---:|---:|---:|---:|");
    for size in sizes {
        let model = torus(size);
        let mut models = vec![("in order", model)];
        if std::env::args().all(|argument| argument != "in-order") {
            models.push(("shuffled", models[0].1.shuffled()));
        }
        for (order, model) in &models {
            for (name, shading, mode) in [
                ("flat", Shading::Flat, Mode::Flat),
                ("Gouraud", Shading::Gouraud, Mode::Gouraud),
                ("Phong", Shading::Phong, Mode::Phong),
            ] {
                let ([baseline, one, two], statistics) = measure(model, shading, mode, rounds);
                let pixels = f64::from(SIZE[0] * SIZE[1]);
                let Times { geometry, binning, tiles } = statistics.times;
                let [geometry, binning, tiles] =
                    [geometry, binning, tiles].map(|time| time.as_secs_f64() * 1e3);
                println!(
                    "| {} {order} | {name} | {:.2} | {:.2}× | {:.2}× | {:.1} % | {geometry:.1}, {binning:.1}, {tiles:.1} |",
                    model.triangles.len(),
                    baseline * 1e3,
                    baseline / one,
                    baseline / two,
                    100.0 * statistics.covered_pixels as f64 / pixels,
                );
            }
        }
    }
}

/// What both rasterizers draw: resident buffers in single precision.
struct Model {
    positions: Vec<[f32; 3]>,
    triangles: Vec<[u32; 3]>,
    normals: Vec<[f32; 3]>,
    face_normals: Vec<[f32; 3]>,
}

/// A torus of about this many triangles, in rows around the tube.
fn torus(triangles: usize) -> Model {
    let around = ((triangles as f64).sqrt() as usize).next_multiple_of(2);
    let across = (triangles / 2).div_ceil(around);
    let (mut positions, mut normals, mut list) = (Vec::new(), Vec::new(), Vec::new());
    for i in 0..around {
        for j in 0..across {
            let (u, v) = (TAU * i as f64 / around as f64, TAU * j as f64 / across as f64);
            let ((su, cu), (sv, cv)) = (libm::sincos(u), libm::sincos(v));
            let normal = DVec3::new(cv * su, sv, cv * cu);
            positions.push((DVec3::new(su, 0.0, cu) + normal * 0.4).as_vec3().to_array());
            normals.push(normal.as_vec3().to_array());
            let at = |i: usize, j: usize| (i % around * across + j % across) as u32;
            list.push([at(i, j), at(i + 1, j), at(i + 1, j + 1)]);
            list.push([at(i, j), at(i + 1, j + 1), at(i, j + 1)]);
        }
    }
    let mut face_normals = vec![[0.0; 3]; list.len()];
    crease::normals::face_normals(&positions, &list, &mut crease::normals::Scratch::new(), &mut face_normals)
        .expect("the mesh is sound");
    Model { positions, triangles: list, normals, face_normals }
}

impl Model {
    /// The same with triangles in another order.
    fn shuffled(&self) -> Self {
        let mut order: Vec<usize> = (0..self.triangles.len()).collect();
        let mut state = 1_u64;
        for i in (1..order.len()).rev() {
            state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
            order.swap(i, (state >> 33) as usize % (i + 1));
        }
        Self {
            positions: self.positions.clone(),
            normals: self.normals.clone(),
            triangles: order.iter().map(|&i| self.triangles[i]).collect(),
            face_normals: order.iter().map(|&i| self.face_normals[i]).collect(),
        }
    }

    fn scene(&self) -> Scene<'_> {
        let shape = Shape::Triangles(Triangles {
            positions: &self.positions,
            triangles: &self.triangles,
            normals: &self.normals,
            face_normals: &self.face_normals,
        });
        Scene {
            objects: vec![Object { transform: DMat4::IDENTITY, ..Object::new(shape, Material::default()) }],
            lines: Vec::new(),
            lights: vec![Light::Directional { towards: TOWARDS, colour: LinearRgb::WHITE }],
            camera: camera(),
            background: LinearRgb::BLACK,
        }
    }
}

fn camera() -> Camera {
    Camera {
        eye: EYE,
        target: DVec3::ZERO,
        up: DVec3::Y,
        projection: Projection::Perspective(Degrees(ANGLE).into()),
        near: 0.1,
    }
}

/// The vertical angle with which the torus covers 40 % of the picture.
const ANGLE: f64 = 27.25;

fn settings(shading: Shading) -> RenderSettings {
    RenderSettings {
        size: SIZE,
        shading,
        cull: Cull::Back,
        transfer: Transfer::Direct,
        ..RenderSettings::default()
    }
}

/// Median seconds of the baseline and of ours with one and two threads; and the statistics of the last picture drawn
/// with one.
fn measure(model: &Model, shading: Shading, mode: Mode, rounds: usize) -> ([f64; 3], Statistics) {
    let mut baseline = Baseline::new(SIZE, &camera(), TOWARDS, mode);
    let scene = model.scene();
    let settings = settings(shading);
    let pools = [1, 2].map(|threads| {
        rayon::ThreadPoolBuilder::new().num_threads(threads).build().expect("a pool of threads")
    });
    let mut statistics = Statistics::default();
    let mut candidates: [Box<dyn FnMut()>; 3] = [
        Box::new(|| {
            baseline.draw(&model.positions, &model.triangles, &model.normals, &model.face_normals);
            black_box(&baseline.pixels);
        }),
        Box::new(|| {
            let image = pools[0].install(|| render(&scene, &settings)).expect("the scene is sound");
            statistics = black_box(&image).statistics;
        }),
        Box::new(|| {
            black_box(pools[1].install(|| render(&scene, &settings)).expect("the scene is sound"));
        }),
    ];
    let mut seconds = [Vec::new(), Vec::new(), Vec::new()];
    for round in 0..=rounds {
        for (work, seconds) in candidates.iter_mut().zip(&mut seconds) {
            let start = Instant::now();
            work();
            // The first round is for warming up.
            if round > 0 {
                seconds.push(start.elapsed().as_secs_f64());
            }
        }
    }
    drop(candidates);
    let medians = seconds.map(|mut seconds| {
        seconds.sort_by(f64::total_cmp);
        seconds[seconds.len() / 2]
    });
    (medians, statistics)
}
