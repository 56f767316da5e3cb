//! Speed of tracing rays against drawing the same picture by Phong's shading, in the same run: medians of several rounds.
//!
//!     cargo bench --bench trace -- [ROUNDS] [TRIANGLES]...
//!
//! The torus, camera and size of `raster.rs`: 40 % of 1920 × 1080 pixels are covered. Both use two threads. `embree.py`
//! measures Embree on the same torus: the median of its first hits on the same machine is the bar.

#![allow(clippy::print_stdout, reason = "it prints a table")]

use crease::num::{Degrees, LinearRgb};
use crease::raster::{
    Camera, Object, Projection, RenderSettings, Scene, Shading, Shape, TraceSettings, Triangles, render,
};
use crease::shade::{Light, Material};
use glam::DVec3;
use std::f64::consts::TAU;
use std::hint::black_box;

const SIZE: [u32; 2] = [1920, 1080];
const EYE: DVec3 = DVec3::new(0.0, 3.2, 4.0);
const TOWARDS: DVec3 = DVec3::new(0.4, 0.6, 1.0);
const ANGLE: f64 = 27.25;

fn main() {
    let numbers: Vec<usize> =
        std::env::args().skip(1).filter_map(|argument| argument.replace('_', "").parse().ok()).collect();
    let rounds = numbers.first().copied().unwrap_or(5).max(3);
    let sizes = if numbers.len() > 1 { numbers[1..].to_vec() } else { vec![70_000, 1_000_000] };
    let pool = rayon::ThreadPoolBuilder::new().num_threads(2).build().expect("two threads");
    println!("| triangles | tree ms | first hits ms | Mrays/s | with shadows ms | Phong ms | first hits |");
    println!("|---|---:|---:|---:|---:|---:|---:|");
    for size in sizes {
        let torus = Torus::new(size);
        let (mut tree, mut hits, mut shadows, mut plain) = (vec![], vec![], vec![], vec![]);
        for _ in 0..rounds {
            let [drawn, traced, shadowed] = pool.install(|| {
                [(Shading::Phong, 0), (Shading::Traced, 0), (Shading::Traced, 1)]
                    .map(|(shading, samples)| torus.draw(shading, samples))
            });
            // The tree is built with what the rasterizer needs of the geometry, too.
            tree.push(traced[0] - drawn[0]);
            hits.push(traced[1]);
            shadows.push(shadowed[1]);
            plain.push(drawn[0] + drawn[1]);
        }
        let [tree, hits, shadows, plain] = [tree, hits, shadows, plain].map(median);
        let rays = f64::from(SIZE[0] * SIZE[1]);
        println!(
            "| {} | {:.0} | {:.0} | {:.1} | {:.0} | {:.1} | {:.1}× Phong |",
            torus.triangles.len(),
            tree * 1e3,
            hits * 1e3,
            rays / hits / 1e6,
            shadows * 1e3,
            plain * 1e3,
            hits / plain
        );
    }
}

fn median(mut times: Vec<f64>) -> f64 {
    times.sort_by(f64::total_cmp);
    times[times.len() / 2]
}

struct Torus {
    positions: Vec<[f32; 3]>,
    triangles: Vec<[u32; 3]>,
    normals: Vec<[f32; 3]>,
}

impl Torus {
    /// A torus of about this many triangles.
    fn new(triangles: usize) -> Self {
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
        Self { positions, triangles: list, normals }
    }

    fn scene(&self) -> Scene<'_> {
        let shape = Shape::Triangles(Triangles {
            positions: &self.positions,
            triangles: &self.triangles,
            normals: &self.normals,
            face_normals: &[],
        });
        Scene {
            objects: vec![Object::new(shape, Material::default())],
            lines: Vec::new(),
            lights: vec![Light::Directional { towards: TOWARDS, colour: LinearRgb::WHITE }],
            camera: Camera {
                eye: EYE,
                target: DVec3::ZERO,
                up: DVec3::Y,
                projection: Projection::Perspective(Degrees(ANGLE).into()),
                near: 0.1,
            },
            background: LinearRgb::BLACK,
        }
    }

    /// Seconds for geometry and for tiles.
    fn draw(&self, shading: Shading, shadow_samples: u32) -> [f64; 2] {
        let tracing = TraceSettings { shadow_samples, ..TraceSettings::default() };
        let settings = RenderSettings { size: SIZE, shading, tracing, ..RenderSettings::default() };
        let image = render(&self.scene(), &settings).expect("the scene is valid");
        let times = black_box(image).statistics.times;
        [times.geometry.as_secs_f64(), times.tiles.as_secs_f64()]
    }
}
