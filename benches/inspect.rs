//! What `crease inspect` costs without pictures, against the plain loop over the same triangles, and in memory.
//!
//!     cargo bench --bench inspect -- [ROUNDS] [TRIANGLES]
//!
//! Two threads, rounds in turn, medians, and the allocator of the program; the loop allocates nothing. The bars are 0.025×
//! the rate of the loop, and 200 bytes for each triangle and 64 MiB; the tables say by how much they are met. In the first,
//! memory is the peak above what is there before; in the second all that the program takes for a file of each format.

#![allow(clippy::print_stdout, reason = "it prints a table")]

mod meshes;
mod process;

use crease::io::{Document, Format, Loaded, Part};
use crease::mesh::{Faces, MeshBuilder};
use crease::normals::{NormalRecipe, compute};
use crease::quality::{Thresholds, diagnose};
use crease::trade::plain_vertex_normals;
use meshes::{Mesh, grid, icosphere, shuffled};
use process::run;
use std::hint::black_box;
use std::path::Path;
use std::process::{Command, Stdio};
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
    println!("\n| file | bytes a triangle | peak beyond 64 MiB, bytes a triangle | of the bar | seconds |");
    println!("|---|---:|---:|---:|---:|");
    for extension in ["ply", "glb", "obj", "stl"] {
        program_row(extension, triangles, rounds);
    }
}

/// All of `crease inspect` for a file that has its surface's exact normals.
fn program_row(extension: &str, triangles: usize, rounds: usize) {
    let crease = || {
        let mut command = Command::new(env!("CARGO_BIN_EXE_crease"));
        command.stdout(Stdio::null());
        command
    };
    let file = Path::new(env!("CARGO_TARGET_TMPDIR")).join(format!("inspect.{extension}"));
    let segments = ((triangles / 2) as f64).sqrt().round() as usize;
    let mut surface = crease();
    surface
        .args(["surface", "wave", "--quiet", "--segments", &format!("{segments}x{segments}"), "-o"])
        .arg(&file);
    run(surface);
    let bytes = std::fs::metadata(&file).expect("the file was written").len() as f64;
    let inspect = || {
        let mut command = crease();
        command.args(["inspect", "--threads", "2", "--quiet"]).arg(&file);
        command
    };
    let runs: Vec<process::Run> = (0..rounds).map(|_| run(inspect())).collect();
    std::fs::remove_file(&file).expect("the file of this run can be removed");
    let count = (2 * segments * segments) as f64;
    let peak = runs.iter().map(|run| run.peak).max().unwrap_or(0) as f64;
    println!(
        "| {extension} | {:.0} | {:.0} | {:.2}× | {:.2} |",
        bytes / count,
        (peak - MEMORY.1) / count,
        peak / (MEMORY.0 * count + MEMORY.1),
        process::median(&runs)
    );
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
        positions: mesh.positions.clone().into(),
        faces: Faces::triangles(mesh.triangles.as_flattened().to_vec()),
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

/// A number of bytes that the system reports for this process; 0 if it does not.
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
