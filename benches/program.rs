//! The whole program compared with only loading the file: `crease normals big.obj --crease off -o out.glb` against `tobj`.
//!
//!     cargo bench --bench program -- [ROUNDS] [TRIANGLES]
//!
//! Each round runs both as processes of their own, in turn; the table has medians, and the largest peak of resident memory.

#![allow(clippy::print_stdout, reason = "it prints a table")]

#[expect(dead_code, reason = "only the grid is needed here")]
mod meshes;
mod process;

use process::{median, run};
use std::fmt::Write as _;
use std::path::Path;
use std::process::Command;

/// Makes this program load a file and end.
const LOAD: &str = "--load-with-tobj";

fn main() {
    let arguments: Vec<String> = std::env::args().skip(1).collect();
    if let [flag, path] = &arguments[..]
        && flag == LOAD
    {
        let (models, _) = tobj::load_obj(path, &tobj::GPU_LOAD_OPTIONS).expect("tobj reads the file");
        assert!(!models.is_empty());
        return;
    }
    let numbers: Vec<usize> =
        arguments.iter().filter_map(|number| number.replace('_', "").parse().ok()).collect();
    let rounds = numbers.first().copied().unwrap_or(9).max(5);
    let folder = Path::new(env!("CARGO_TARGET_TMPDIR"));
    let (input, output) = (folder.join("program.obj"), folder.join("program.glb"));
    let text = obj(&meshes::grid(numbers.get(1).copied().unwrap_or(1_000_000)));
    std::fs::write(&input, &text).expect("the target folder can be written");

    let tobj = || {
        let mut command = Command::new(std::env::current_exe().expect("this program has a path"));
        command.arg(LOAD).arg(&input);
        command
    };
    let crease = || {
        let mut command = Command::new(env!("CARGO_BIN_EXE_crease"));
        command.args(["normals", "--crease", "off", "--quiet", "-o"]).arg(&output).arg(&input);
        command
    };
    let (mut loading, mut all) = (Vec::new(), Vec::new());
    for round in 0..=rounds {
        let runs = (run(tobj()), run(crease()));
        // The first round is for warming up.
        if round > 0 {
            loading.push(runs.0);
            all.push(runs.1);
        }
    }
    for file in [&input, &output] {
        std::fs::remove_file(file).expect("the files of this run can be removed");
    }
    println!("{} bytes of OBJ\n", text.len());
    println!("| program | seconds | as fast as tobj | peak bytes per byte of OBJ |\n|---|---:|---:|---:|");
    let baseline = median(&loading);
    for (name, runs) in [("tobj, loading only", &loading), ("crease, OBJ to GLB", &all)] {
        let seconds = median(runs);
        let peak = runs.iter().map(|run| run.peak).max().unwrap_or(0) as f64 / text.len() as f64;
        println!("| {name} | {seconds:.3} | {:.2}× | {peak:.2} |", baseline / seconds);
    }
}

/// Positions with six digits, as most exporters write them, and faces.
fn obj(mesh: &meshes::Mesh) -> String {
    let mut text = String::new();
    for [x, y, z] in &mesh.positions {
        writeln!(text, "v {x:.6} {y:.6} {z:.6}").expect("a string takes all");
    }
    for triangle in &mesh.triangles {
        let [a, b, c] = triangle.map(|vertex| vertex + 1);
        writeln!(text, "f {a} {b} {c}").expect("a string takes all");
    }
    text
}
