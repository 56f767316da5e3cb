//! crease next to other Rust crates, in one process: every candidate in turn, several rounds, medians.
//!
//!     cargo run --release --manifest-path benches/peers/Cargo.toml -- [ROUNDS] [TRIANGLES]...
//!
//! Peers get their mesh in their own type before the clock starts. What is timed is one call that computes normals.

#[allow(dead_code, reason = "other benches use the other meshes")]
#[path = "../../meshes.rs"]
mod meshes;
mod peers;

use crease::mesh::{Faces, MeshBuilder};
use crease::normals::{
    Averaging, Crease, Extras, NormalRecipe, Precision, Scratch, Weight, compute_reusing, corner_normals,
    vertex_normals,
};
use crease::num::Degrees;
use meshes::{Mesh, grid, shuffled};
use rayon::ThreadPool;
use std::hint::black_box;
use std::time::Instant;

/// A name and something to measure.
type Candidate<'a> = (String, Box<dyn FnMut() + 'a>);

/// Each measurement repeats its work until about this many triangles are done.
const TRIANGLES_PER_MEASUREMENT: usize = 1_000_000;

fn main() {
    let numbers: Vec<usize> =
        std::env::args().skip(1).filter_map(|argument| argument.replace('_', "").parse().ok()).collect();
    let rounds = numbers.first().copied().unwrap_or(7).max(1);
    let sizes = if numbers.len() > 1 { numbers[1..].to_vec() } else { vec![70_000, 1_000_000, 10_000_000] };
    let pools = [1, 2].map(|threads| {
        rayon::ThreadPoolBuilder::new().num_threads(threads).build().expect("a pool of threads")
    });
    println!("Mtri/s, medians of {rounds} rounds; in brackets the ratio to the first row of a block.\n");
    for size in sizes {
        let in_order = grid(size);
        let mixed = shuffled(&in_order);
        for mesh in [in_order, mixed] {
            println!("### {} triangles, {}\n", mesh.triangles.len(), mesh.name);
            block("area", area(&mesh, &pools), &mesh, rounds);
            block("angle", angle(&mesh, &pools), &mesh, rounds);
            block("crease 40°", crease(&mesh, &pools), &mesh, rounds);
        }
    }
    let obj = peers::obj_text(&grid(1_000_000));
    println!("### OBJ of a million triangles, {:.1} MB\n", obj.len() as f64 / 1e6);
    block("read", reading(&obj, &pools), &grid(1_000_000), rounds);
}

fn area<'a>(mesh: &'a Mesh, pools: &'a [ThreadPool; 2]) -> Vec<Candidate<'a>> {
    let mut candidates: Vec<Candidate> = vec![
        ("three-d-asset".into(), peers::three_d_asset(mesh)),
        ("bevy_mesh".into(), peers::bevy_area(mesh)),
        ("plain loop".into(), peers::plain_loop(mesh)),
    ];
    candidates.extend(ours(mesh, pools, Weight::Area));
    candidates
}

fn angle<'a>(mesh: &'a Mesh, pools: &'a [ThreadPool; 2]) -> Vec<Candidate<'a>> {
    let mut candidates: Vec<Candidate> = vec![("bevy_mesh".into(), peers::bevy_angle(mesh))];
    candidates.extend(ours(mesh, pools, Weight::Angle));
    candidates
}

/// `vertex_normals` on slices, and `compute_reusing` on a mesh without creases.
fn ours<'a>(mesh: &'a Mesh, pools: &'a [ThreadPool; 2], weight: Weight) -> Vec<Candidate<'a>> {
    let mut candidates: Vec<Candidate> = Vec::new();
    let kinds = [
        (&pools[0], Precision::Faithful, "1 thread"),
        (&pools[1], Precision::Faithful, "2 threads"),
        (&pools[0], Precision::Fast, "fast, 1 thread"),
        (&pools[1], Precision::Fast, "fast, 2 threads"),
    ];
    for (pool, precision, kind) in kinds {
        let averaging = Averaging { weight, precision, ..Averaging::default() };
        let (mut scratch, mut normals) = (Scratch::new(), vec![[0.0_f32; 3]; mesh.positions.len()]);
        let work = move || {
            let result = pool.install(|| {
                let Mesh { positions, triangles, .. } = mesh;
                vertex_normals(positions, triangles, averaging, &mut scratch, &mut normals)
            });
            black_box(result.expect("the mesh is sound"));
        };
        candidates.push((format!("crease, {kind}"), Box::new(work)));
    }
    candidates.push(on_mesh(
        mesh,
        &pools[1],
        NormalRecipe { weight, crease: Crease::OFF, ..Default::default() },
    ));
    candidates
}

fn on_mesh<'a>(mesh: &Mesh, pool: &'a ThreadPool, recipe: NormalRecipe) -> Candidate<'a> {
    let built = MeshBuilder {
        positions: mesh.positions.clone().into(),
        faces: Faces::triangles(mesh.triangles.as_flattened().to_vec()),
        ..MeshBuilder::default()
    };
    let built = built.build().expect("the mesh is sound");
    let mut scratch = Scratch::new();
    let work = move || {
        let field = pool.install(|| compute_reusing(&built, &recipe, Extras::NONE, &mut scratch));
        drop(black_box(field));
    };
    ("crease on a Mesh, 2 threads".into(), Box::new(work))
}

fn crease<'a>(mesh: &'a Mesh, pools: &'a [ThreadPool; 2]) -> Vec<Candidate<'a>> {
    let mut candidates: Vec<Candidate> = vec![("meshopt".into(), peers::meshopt_crease(mesh))];
    for (pool, threads) in pools.iter().zip(["1 thread", "2 threads"]) {
        let (mut scratch, mut normals) = (Scratch::new(), Vec::new());
        let mut index = vec![0; 3 * mesh.triangles.len()];
        let work = move || {
            let result = pool.install(|| {
                let Mesh { positions, triangles, .. } = mesh;
                corner_normals(
                    positions,
                    triangles,
                    Averaging::default(),
                    Degrees(40.0),
                    &mut scratch,
                    &mut normals,
                    &mut index,
                )
            });
            black_box(result.expect("the mesh is sound"));
        };
        candidates.push((format!("crease, {threads}"), Box::new(work)));
    }
    candidates.push(on_mesh(mesh, &pools[1], NormalRecipe::default()));
    candidates
}

/// Only loading with tobj; reading, normals and writing a GLB with crease.
fn reading<'a>(obj: &'a [u8], pools: &'a [ThreadPool; 2]) -> Vec<Candidate<'a>> {
    use crease::io::{Format, ReadOptions, WriteOptions, read_bytes, write};
    use crease::pipeline::{Task, revise};
    let work = move || {
        pools[1].install(|| {
            let loaded = read_bytes(obj.to_vec(), Some(Format::Obj), None, &ReadOptions::default()).unwrap();
            let mut task = Task::default();
            task.recipe.crease = Crease::OFF;
            let revision = revise(&loaded, &task, Some(Format::Glb), &|_| {});
            black_box(write(&loaded, revision.edits, Format::Glb, &WriteOptions::default()).unwrap());
        });
    };
    vec![
        ("tobj, loading only".into(), peers::tobj_load(obj)),
        ("crease, OBJ to GLB, 2 threads".into(), Box::new(work)),
    ]
}

/// Measures candidates in turn and prints a table.
fn block(job: &str, mut candidates: Vec<Candidate>, mesh: &Mesh, rounds: usize) {
    let triangles = mesh.triangles.len();
    let repeats = (TRIANGLES_PER_MEASUREMENT / triangles).max(1);
    let mut seconds = vec![Vec::new(); candidates.len()];
    for round in 0..=rounds {
        for ((_, work), seconds) in candidates.iter_mut().zip(&mut seconds) {
            let start = Instant::now();
            (0..repeats).for_each(|_| work());
            // The first round is for warming up.
            if round > 0 {
                seconds.push(start.elapsed().as_secs_f64() / repeats as f64);
            }
        }
    }
    let medians: Vec<f64> = seconds
        .into_iter()
        .map(|mut seconds| {
            seconds.sort_by(f64::total_cmp);
            seconds[seconds.len() / 2]
        })
        .collect();
    println!("| {job} | Mtri/s | ratio |\n|---|---:|---:|");
    for ((name, _), median) in candidates.iter().zip(&medians) {
        println!("| {name} | {:.1} | {:.2}× |", triangles as f64 / median / 1e6, medians[0] / median);
    }
    println!();
}
