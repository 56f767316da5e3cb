//! What `crease inspect` costs without pictures, against the plain loop over the same triangles, and in memory.
//!
//!     cargo bench --bench inspect -- [ROUNDS] [TRIANGLES]
//!
//! Two threads, rounds in turn, medians, and the allocator of the program; the loop allocates nothing. The bars are 0.025×
//! the rate of the loop, and 200 bytes for each triangle and 64 MiB; the table says by how much they are met. Memory is the
//! peak above what is there before, where the system tells it.

#![allow(clippy::print_stdout, reason = "it prints a table")]

mod meshes;

use crease::io::{Document, Format, Loaded, Part};
use crease::mesh::{Faces, MeshBuilder, Storage};
use crease::normals::{NormalRecipe, compute};
use crease::quality::{Thresholds, diagnose};
use crease::trade::plain_vertex_normals;
use glam::DVec3;
use meshes::{Mesh, grid, icosphere, shuffled};
use std::hint::black_box;
use std::time::Instant;

/// As in `src/main.rs`.
#[global_allocator]
static ALLOCATOR: mimalloc::MiMalloc = mimalloc::MiMalloc;

/// The least rate, as a share of the plain loop's.
const RATE: f64 = 0.025;

/// The most memory: bytes for each triangle, and bytes at all.
const MEMORY: (f64, f64) = (200.0, 64.0 * 1024.0 * 1024.0);

fn main() {
    let numbers: Vec<usize> =
        std::env::args().skip(1).filter_map(|argument| argument.replace('_', "").parse().ok()).collect();
    let rounds = numbers.first().copied().unwrap_or(5).max(5);
    let triangles = numbers.get(1).copied().unwrap_or(1_000_000);
    let pool = rayon::ThreadPoolBuilder::new().num_threads(2).build().expect("a pool of threads");
    println!(
        "| triangles | plain loop Mtri/s | inspect Mtri/s | of the loop | of the bar | bytes a triangle | of the bar |"
    );
    println!("|---|---:|---:|---:|---:|---:|---:|");
    for mesh in [grid(triangles), icosphere(triangles), shuffled(&icosphere(triangles))] {
        row(&mesh, &pool, rounds);
    }
}

fn row(mesh: &Mesh, pool: &rayon::ThreadPool, rounds: usize) {
    let count = mesh.triangles.len() as f64;
    let loaded = loaded(mesh);
    let thresholds = Thresholds::default();
    let mut normals = vec![[0.0_f32; 3]; mesh.positions.len()];
    let (mut loops, mut looks) = (Vec::new(), Vec::new());
    let mut peak: f64 = 0.0;
    for round in 0..=rounds {
        let start = Instant::now();
        plain_vertex_normals(&mesh.positions, &mesh.triangles, black_box(&mut normals));
        let plain = start.elapsed().as_secs_f64();
        let before = status("VmRSS:");
        // Begins the peak anew where that is possible; elsewhere it is that of the whole run.
        let _ = std::fs::write("/proc/self/clear_refs", "5");
        let start = Instant::now();
        black_box(pool.install(|| diagnose(&loaded, &thresholds, &|_| {})));
        let look = start.elapsed().as_secs_f64();
        peak = peak.max(status("VmHWM:") - before);
        // The first round is for warming up.
        if round > 0 {
            loops.push(plain);
            looks.push(look);
        }
    }
    let [plain, look] = [median(loops), median(looks)];
    let allowed = MEMORY.0 * count + MEMORY.1;
    println!(
        "| {count} {} | {:.0} | {:.2} | {:.4}× | {:.2}× | {:.0} | {:.2}× |",
        mesh.name,
        count / plain / 1e6,
        count / look / 1e6,
        plain / look,
        plain / look / RATE,
        peak / count,
        peak / allowed
    );
}

/// The mesh as if it were read from a file that has normals.
fn loaded(mesh: &Mesh) -> Loaded {
    let builder = MeshBuilder {
        positions: mesh.positions.iter().map(|p| DVec3::from_array(p.map(f64::from))).collect(),
        faces: Faces::triangles(mesh.triangles.as_flattened().to_vec()),
        storage: Storage::F32,
        ..MeshBuilder::default()
    };
    let mesh = builder.build().expect("the mesh is sound");
    let normals = compute(&mesh, &NormalRecipe::default()).normals;
    Loaded {
        format: Format::Glb,
        parts: vec![Part { mesh: mesh.with_normals(Some(normals)), ..Part::default() }],
        nodes: Vec::new(),
        notes: Vec::new(),
        document: Document::None,
    }
}

/// A number of bytes that the system tells of this process; 0 where it does not.
fn status(name: &str) -> f64 {
    let status = std::fs::read_to_string("/proc/self/status").unwrap_or_default();
    let line = status.lines().find_map(|line| line.strip_prefix(name));
    let kilobytes = line.and_then(|line| line.split_whitespace().next()?.parse::<f64>().ok());
    kilobytes.unwrap_or(0.0) * 1024.0
}

fn median(mut seconds: Vec<f64>) -> f64 {
    seconds.sort_by(f64::total_cmp);
    seconds[seconds.len() / 2]
}
