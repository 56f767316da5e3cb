//! Speed as ratios, for the README: every candidate in turn, several rounds, medians.
//!
//!     cargo bench --bench ratios -- [ROUNDS] [TRIANGLES]...

#![allow(clippy::print_stdout, reason = "it prints a table")]

mod meshes;

use crease::mesh::Faces;
use crease::normals::{
    Averaging, Crease, Extras, NormalRecipe, Precision, Scratch, Weight, compute_with, corner_normals,
    vertex_normals,
};
use crease::num::{Degrees, three_digits};
use crease::trade::plain_vertex_normals;
use meshes::{Mesh, grid, icosphere, shuffled};
use std::hint::black_box;
use std::time::Instant;

/// A name and something to measure.
type Candidate<'a> = (&'static str, Box<dyn FnMut() + 'a>);

/// Each measurement repeats its work until about this many triangles are done.
const TRIANGLES_PER_MEASUREMENT: usize = 1_000_000;

/// Normals of larger meshes are not fitted.
const MOST_FITTED: usize = 2_000_000;

fn main() {
    let numbers: Vec<usize> =
        std::env::args().skip(1).filter_map(|argument| argument.replace('_', "").parse().ok()).collect();
    let rounds = numbers.first().copied().unwrap_or(7).max(5);
    let sizes = if numbers.len() > 1 { numbers[1..].to_vec() } else { vec![70_000, 1_000_000, 10_000_000] };
    let pools = [1, 2].map(|threads| {
        rayon::ThreadPoolBuilder::new().num_threads(threads).build().expect("a pool of threads")
    });
    let mut table: Vec<(String, Vec<(&str, f64)>)> = Vec::new();
    for size in sizes {
        for mesh in [grid(size), icosphere(size)] {
            let mixed = shuffled(&mesh);
            for mesh in [mesh, mixed] {
                let row = format!("{} {}", mesh.triangles.len(), mesh.name);
                table.push((row, measure(&mesh, &pools, rounds)));
            }
        }
    }
    print(&table);
}

/// Median seconds of each candidate.
fn measure(mesh: &Mesh, pools: &[rayon::ThreadPool; 2], rounds: usize) -> Vec<(&'static str, f64)> {
    let Mesh { positions, triangles, .. } = mesh;
    let bytes = triangles.len() * 12 + positions.len() * 24;
    let (source, mut target) = (vec![1_u8; bytes], vec![0_u8; bytes]);
    let mut normals = vec![[0.0_f32; 3]; positions.len()];
    // Fits take a hundred times as long as sums.
    let fitted = (triangles.len() <= MOST_FITTED).then(|| {
        let faces = Faces::triangles(triangles.concat());
        crease::mesh::Mesh::new(positions.clone(), faces).expect("the mesh is sound")
    });
    let mut candidates: Vec<Candidate> = vec![
        ("baseline", Box::new(move || plain_vertex_normals(positions, triangles, black_box(&mut normals)))),
        ("memory copy", Box::new(move || black_box(&mut target).copy_from_slice(black_box(&source)))),
    ];
    let ours = [
        ("area, 1 thread", Weight::Area, Precision::Faithful, &pools[0]),
        ("area, 2 threads", Weight::Area, Precision::Faithful, &pools[1]),
        ("area, fast, 1 thread", Weight::Area, Precision::Fast, &pools[0]),
        ("area, fast, 2 threads", Weight::Area, Precision::Fast, &pools[1]),
        ("angle, 1 thread", Weight::Angle, Precision::Faithful, &pools[0]),
        ("angle, 2 threads", Weight::Angle, Precision::Faithful, &pools[1]),
        ("angle, fast, 1 thread", Weight::Angle, Precision::Fast, &pools[0]),
        ("angle, fast, 2 threads", Weight::Angle, Precision::Fast, &pools[1]),
    ];
    for (name, weight, precision, pool) in ours {
        let averaging = Averaging { weight, precision, ..Averaging::default() };
        let (mut scratch, mut normals) = (Scratch::new(), vec![[0.0_f32; 3]; positions.len()]);
        let work = move || {
            let result =
                pool.install(|| vertex_normals(positions, triangles, averaging, &mut scratch, &mut normals));
            black_box(result.expect("the mesh is sound"));
        };
        candidates.push((name, Box::new(work)));
    }
    let (mut scratch, mut corner_entries, mut index) =
        (Scratch::new(), Vec::new(), vec![0; 3 * triangles.len()]);
    let crease = move || {
        let result = pools[1].install(|| {
            corner_normals(
                positions,
                triangles,
                Averaging::default(),
                Degrees(40.0),
                &mut scratch,
                &mut corner_entries,
                &mut index,
            )
        });
        black_box(result.expect("the mesh is sound"));
    };
    candidates.push(("crease 40°, 2 threads", Box::new(crease)));
    let fits = [("quadric, 2 threads", Weight::Quadric), ("jet, 2 threads", Weight::Jet)];
    for ((name, weight), mesh) in fits.into_iter().flat_map(|fit| fitted.iter().map(move |mesh| (fit, mesh)))
    {
        let recipe = NormalRecipe { weight, crease: Crease::OFF, ..NormalRecipe::default() };
        let work = move || drop(black_box(pools[1].install(|| compute_with(mesh, &recipe, Extras::NONE))));
        candidates.push((name, Box::new(work)));
    }
    let repeats = (TRIANGLES_PER_MEASUREMENT / triangles.len()).max(1);
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
    let medians = seconds.into_iter().map(|mut seconds: Vec<f64>| {
        seconds.sort_by(f64::total_cmp);
        seconds[seconds.len() / 2]
    });
    candidates.iter().map(|&(name, _)| name).zip(medians).collect()
}

fn print(table: &[(String, Vec<(&str, f64)>)]) {
    let Some((_, columns)) = table.first() else { return };
    let names: Vec<&str> = columns.iter().map(|&(name, _)| name).collect();
    println!("| triangles | {} Mtri/s | {} |", names[0], names[1..].join(" | "));
    println!("|---|{}", "---:|".repeat(names.len()));
    for (row, columns) in table {
        let baseline = columns[0].1;
        let triangles: f64 = row.split(' ').next().and_then(|count| count.parse().ok()).unwrap_or(f64::NAN);
        let ratios: Vec<String> = columns[1..]
            .iter()
            .map(|&(_, seconds)| format!("{}×", three_digits(baseline / seconds)))
            .collect();
        println!("| {row} | {:.0} | {} |", triangles / baseline / 1e6, ratios.join(" | "));
    }
}
