//! Speed of drawing as ratios, for the README: every candidate in turn, several rounds, medians.
//!
//!     cargo bench --bench raster -- [ROUNDS] [TRIANGLES]... [in-order]
//!
//! A torus seen by a perspective camera covers 40 % of 1920 × 1080 pixels; one directional light, Blinn's highlight with
//! n = 32 and the viewer where the camera is, back faces culled, 8 bits without transfer. The baseline is a plain scalar
//! rasterizer in one thread.

#![allow(clippy::print_stdout, reason = "it prints a table")]

mod baseline;
mod torus;

use baseline::{Baseline, Mode};
use crease::num::Transfer;
use crease::raster::{Cull, RenderScratch, RenderSettings, Shading, Statistics, Times, render_reusing};
use std::hint::black_box;
use std::time::Instant;
use torus::{SIZE, TOWARDS, Torus, camera};

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
        let mut models = vec![("in order", Torus::new(size))];
        if std::env::args().all(|argument| argument != "in-order") {
            models.push(("shuffled", shuffled(&models[0].1)));
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

/// The same with triangles in another order.
fn shuffled(torus: &Torus) -> Torus {
    let mut order: Vec<usize> = (0..torus.triangles.len()).collect();
    let mut state = 1_u64;
    for i in (1..order.len()).rev() {
        state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        order.swap(i, (state >> 33) as usize % (i + 1));
    }
    Torus {
        positions: torus.positions.clone(),
        normals: torus.normals.clone(),
        triangles: order.iter().map(|&i| torus.triangles[i]).collect(),
        face_normals: order.iter().map(|&i| torus.face_normals[i]).collect(),
    }
}

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
fn measure(model: &Torus, shading: Shading, mode: Mode, rounds: usize) -> ([f64; 3], Statistics) {
    let mut baseline = Baseline::new(SIZE, &camera(), TOWARDS, mode);
    let scene = model.scene();
    let settings = settings(shading);
    let pools = [1, 2].map(|threads| {
        rayon::ThreadPoolBuilder::new().num_threads(threads).build().expect("a pool of threads")
    });
    let mut statistics = Statistics::default();
    // The baseline keeps its memory as well.
    let mut scratches = [RenderScratch::default(), RenderScratch::default()];
    let [of_one, of_two] = &mut scratches;
    let mut candidates: [Box<dyn FnMut()>; 3] = [
        Box::new(|| {
            baseline.draw(&model.positions, &model.triangles, &model.normals, &model.face_normals);
            black_box(&baseline.pixels);
        }),
        Box::new(|| {
            let image = pools[0].install(|| render_reusing(&scene, &settings, of_one));
            let image = image.expect("the scene is sound");
            statistics = black_box(&image).statistics;
            of_one.recycle(image);
        }),
        Box::new(|| {
            let image = pools[1].install(|| render_reusing(&scene, &settings, of_two));
            of_two.recycle(black_box(image.expect("the scene is sound")));
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
