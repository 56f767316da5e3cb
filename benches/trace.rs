//! Speed of tracing rays against drawing the same picture by Phong's shading, in the same run: medians of several rounds.
//!
//!     cargo bench --bench trace -- [ROUNDS] [TRIANGLES]...
//!
//! The torus, camera and size of `raster.rs`: 40 % of 1920 × 1080 pixels are covered. Both use two threads. `embree.py`
//! measures Embree on the same torus: the median of its first hits on the same machine is the bar.

#![allow(clippy::print_stdout, reason = "it prints a table")]

mod torus;

use crease::raster::{RenderSettings, Shading, TraceSettings, render};
use std::hint::black_box;
use torus::{SIZE, Torus};

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
                    .map(|(shading, samples)| draw(&torus, shading, samples))
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

/// Seconds for geometry and for tiles.
fn draw(torus: &Torus, shading: Shading, shadow_samples: u32) -> [f64; 2] {
    let tracing = TraceSettings { shadow_samples, ..TraceSettings::default() };
    let settings = RenderSettings { size: SIZE, shading, tracing, ..RenderSettings::default() };
    let image = render(&torus.scene(), &settings).expect("the scene is valid");
    let times = black_box(image).statistics.times;
    [times.geometry.as_secs_f64(), times.tiles.as_secs_f64()]
}
