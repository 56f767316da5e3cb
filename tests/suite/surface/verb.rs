//! `crease surface` from outside.

use assert_cmd::Command;
use crease::io::{ReadOptions, read};
use crease::mesh::Mesh;
use glam::DVec3;
use serde_json::Value;
use std::path::Path;
use std::process::Output;
use tempfile::TempDir;

const KINDS: [&str; 12] = [
    "plane",
    "sphere",
    "ellipsoid",
    "cylinder",
    "cone",
    "torus",
    "catenoid",
    "wave",
    "monkey-saddle",
    "superquadric",
    "bezier",
    "teapot",
];

fn surface(args: &[&str]) -> Output {
    Command::new(env!("CARGO_BIN_EXE_crease")).arg("surface").args(args).output().unwrap()
}

fn code(output: &Output) -> i32 {
    output.status.code().expect("no signal")
}

fn text(bytes: &[u8]) -> &str {
    std::str::from_utf8(bytes).unwrap()
}

/// A run that has to succeed: its report, and the mesh that it wrote.
fn written(args: &[&str], name: &str) -> (Value, Mesh) {
    let folder = TempDir::new().unwrap();
    let path = folder.path().join(name);
    let output = surface(&[args, &["--json", "-o", path.to_str().unwrap()]].concat());
    assert_eq!(code(&output), 0, "{args:?}: {}", text(&output.stderr));
    (serde_json::from_slice(&output.stdout).unwrap(), load(&path))
}

fn load(path: &Path) -> Mesh {
    read(path, None, &ReadOptions::default()).unwrap().parts.swap_remove(0).mesh
}

fn normals(mesh: &Mesh) -> &[DVec3] {
    &mesh.columns().normals.as_ref().unwrap().values
}

#[test]
fn the_torus_of_the_reference_comes_out_with_exact_normals() {
    let (report, mesh) = written(&["torus", "--segments", "64x32", "--jitter", "0.5"], "torus.ply");
    assert_eq!(report["schema"], "crease-surface/1");
    assert_eq!((&report["status"], &report["surface"]), (&"ok".into(), &"torus".into()));
    assert_eq!((&report["mesh"]["vertices"], &report["mesh"]["triangles"]), (&2048.into(), &4096.into()));
    assert_eq!((&report["mesh"]["euler"], &report["mesh"]["open_edges"]), (&0.into(), &0.into()));
    assert_eq!(report["output"]["vertices"], 2048);
    assert_eq!((mesh.vertex_count(), mesh.face_count()), (2048, 4096));
    for (p, n) in mesh.positions().iter().zip(normals(&mesh)) {
        let ring = DVec3::new(p.x, 0.0, p.z);
        let tube = p - ring.normalize();
        // Both are doubles.
        assert!((tube.length() - 0.4).abs() < 1e-15);
        assert!((tube / 0.4 - *n).length() < 2e-15);
    }
}

/// To the bit: a float would be off by up to 3e-6 degrees.
#[test]
fn normals_in_ply_and_obj_are_as_exact_as_positions() {
    use crease::surface::{Surface, Tessellation, Torus};
    let tessellation = Tessellation { segments: [12, 8], ..Tessellation::default() };
    let made = Surface::from(Torus::default()).tessellate(&tessellation).unwrap();
    for name in ["torus.ply", "torus.obj"] {
        let (_, mesh) = written(&["torus", "--segments", "12x8"], name);
        assert_eq!(mesh.positions(), made.positions(), "{name}");
        assert!(by_corner(&mesh) == by_corner(&made), "{name}");
    }
}

/// The normal at each corner, however a format shares them.
fn by_corner(mesh: &Mesh) -> Vec<DVec3> {
    let column = mesh.columns().normals.as_ref().unwrap();
    let corners = mesh.faces().corners().iter().enumerate();
    corners.map(|(corner, &vertex)| *column.get(corner, vertex).unwrap()).collect()
}

#[test]
fn every_surface_goes_to_every_format() {
    for kind in KINDS {
        for format in ["obj", "ply", "stl", "gltf", "glb"] {
            let segments = if kind == "teapot" { "5" } else { "6x4" };
            let (report, mesh) = written(&[kind, "--segments", segments, "--uv"], &format!("it.{format}"));
            assert_eq!(report["mesh"]["faces"], mesh.face_count(), "{kind} {format}");
            assert_eq!(report["output"]["format"], format);
            // Facets of STL point the way of their own triangle, vertex normals to the same side of it.
            for (face, range) in mesh.faces().iter().zip(mesh.faces().ranges()) {
                let [a, b, c] = [0, 1, 2].map(|k| mesh.positions().at(face[k]));
                let column = mesh.columns().normals.as_ref().unwrap();
                let sum: DVec3 = range.zip(face).map(|(corner, &v)| *column.get(corner, v).unwrap()).sum();
                assert!((b - a).cross(c - a).dot(sum) > 0.0, "{kind} {format}");
            }
        }
    }
}

#[test]
fn every_pattern_is_written_or_refused_with_its_reason() {
    let patterns =
        ["triangles", "stretched", "slivers", "quads", "polygons", "icosphere", "marching", "scattered"];
    let mut refused = 0;
    for kind in KINDS {
        for pattern in patterns {
            let output = surface(&[kind, "--pattern", pattern, "--to", "ply", "-o", "-", "--json"]);
            if code(&output) == 0 {
                assert!(output.stdout.starts_with(b"ply\n"), "{kind} {pattern}");
                let report: Value = serde_json::from_slice(&output.stderr).unwrap();
                assert_eq!(report["tessellation"]["pattern"], pattern);
            } else {
                assert_eq!(code(&output), 2, "{kind} {pattern}: {}", text(&output.stderr));
                assert!(output.stdout.is_empty());
                assert!(text(&output.stderr).contains(&format!("error: {pattern} is not possible here")));
                refused += 1;
            }
        }
    }
    // Nine surfaces have no icosphere, two no marching, nine no scattering.
    assert_eq!(refused, 9 + 2 + 9);
}

/// A loss of shape by an offset is reported in every format: in doubles by the verb, in single precision by the writer.
#[test]
fn offsets_that_lose_the_shape_are_reported() {
    let warned = |offset: &str, name: &str| {
        let (report, _) = written(&["sphere", "--segments", "12x6", "--offset", offset], name);
        let notes = report["notes"].as_array().cloned().unwrap_or_default();
        notes
            .iter()
            .any(|note| note["severity"] == "warning" && note["text"].as_str().unwrap().contains("size"))
    };
    for name in ["a.ply", "a.obj", "a.stl", "a.glb"] {
        assert!(warned("1e30,0,0", name), "{name}");
        assert!(!warned("10,0,0", name), "{name}");
    }
    assert!(warned("1e3,0,0", "a.stl") && warned("1e3,0,0", "a.glb"));
    let (report, _) = written(&["sphere", "--radius", "1e-60", "--scale", "1e-300"], "tiny.ply");
    assert!(report["notes"][0]["text"].as_str().unwrap().contains("few digits or none"), "{report}");
    assert!(!warned("1e3,0,0", "a.ply") && !warned("1e3,0,0", "a.obj"));
}

#[test]
fn scaled_and_moved_copies_are_what_they_say() {
    let (_, plain) = written(&["sphere", "--segments", "12x6"], "a.ply");
    let moved = ["sphere", "--segments", "12x6", "--scale", "2,1,-0.5", "--offset", "1e6,-3,0.25"];
    let (report, copy) = written(&moved, "b.ply");
    assert_eq!(report["offset"], serde_json::json!([1e6, -3.0, 0.25]));
    let (scale, offset) = (DVec3::new(2.0, 1.0, -0.5), DVec3::new(1e6, -3.0, 0.25));
    for ((p, q), n) in plain.positions().iter().zip(copy.positions().iter()).zip(normals(&copy)) {
        // A double of 1e6 has steps of 1.2e-10.
        assert!((p * scale + offset - q).length() < 1.2e-10);
        assert!(((p / scale).normalize() - *n).length() < 1e-7);
    }
    // Mirrored, the faces run the other way round in the list and outward in space.
    assert_ne!(plain.faces().face(0), copy.faces().face(0));
}

#[test]
fn options_of_shape_and_mesh_reach_what_they_name() {
    let bounds = |args: &[&str]| {
        let (report, _) = written(args, "a.ply");
        let of = |end: &str| -> Vec<f64> {
            report["mesh"]["bounds"][end].as_array().unwrap().iter().map(|x| x.as_f64().unwrap()).collect()
        };
        (of("low"), of("high"))
    };
    let high = |args: &[&str]| bounds(args).1;
    assert_eq!(high(&["sphere", "--radius", "3"]), [3.0, 3.0, 3.0]);
    assert_eq!(high(&["cylinder", "--radius", "3", "--height", "10"]), [3.0, 5.0, 3.0]);
    assert_eq!(high(&["cone", "--radius", "3", "--height", "10"]), [3.0, 5.0, 3.0]);
    assert_eq!(high(&["torus", "--major", "3", "--minor", "1"]), [4.0, 1.0, 4.0]);
    assert_eq!(high(&["ellipsoid", "--semi-axes", "3,2,1"]), [3.0, 2.0, 1.0]);
    assert_eq!(high(&["superquadric", "--semi-axes", "3,2,1", "--roundness", "1"]), [3.0, 2.0, 1.0]);
    assert_eq!(high(&["plane", "--size", "3,5"]), [1.5, 2.5, 0.0]);
    assert_eq!(high(&["monkey-saddle", "--size", "4"]), [2.0, 2.0, 16.0]);
    assert_eq!(high(&["catenoid", "--waist", "1", "--height", "2"])[..2], [libm::cosh(1.0), 1.0]);
    assert_eq!(bounds(&["teapot"]).0[1], 0.0);
    let vertices = |args: &[&str]| written(args, "a.ply").0["mesh"]["vertices"].as_u64().unwrap();
    assert_eq!(vertices(&["sphere", "--pattern", "icosphere", "--level", "1"]), 42);
    assert_eq!(vertices(&["torus", "--segments", "7"]), 49);
    assert_eq!(vertices(&["torus", "--segments", "40x10", "--pattern", "stretched", "--ratio", "4"]), 400);
    let noisy = |args: &[&str]| written(&[&["sphere"], args].concat(), "a.ply").1;
    assert_ne!(noisy(&[]), noisy(&["--noise", "0.1"]));
    assert_ne!(noisy(&["--noise", "0.1"]), noisy(&["--noise", "0.1", "--seed", "1"]));
    assert_eq!(noisy(&["--threads", "1", "--jitter", "0.3"]), noisy(&["--threads", "3", "--jitter", "0.3"]));
    assert!(noisy(&["--uv"]).columns().uvs.is_some() && noisy(&[]).columns().uvs.is_none());
}

#[test]
fn reports_for_people_say_what_was_made() {
    let folder = TempDir::new().unwrap();
    let path = folder.path().join("c.obj");
    let path = path.to_str().unwrap();
    let output = surface(&["cone", "--segments", "8x3", "--pattern", "quads", "-o", path]);
    let report = text(&output.stdout);
    assert!(report.starts_with(&format!("cone -> {path}\n")), "{report}");
    assert!(
        report.contains("25 vertices, 8 triangles, 16 quads, open at 8 edges, Euler number 1"),
        "{report}"
    );
    assert!(surface(&["cone", "-q", "-o", path]).stdout.is_empty());
}

#[test]
fn what_cannot_be_is_refused_before_anything_is_written() {
    let folder = TempDir::new().unwrap();
    let path = folder.path().join("out.ply");
    let path = path.to_str().unwrap();
    let cases: &[(&[&str], &str)] = &[
        (&["torus"], "--output"),
        (&["donut", "-o", path], "donut"),
        (&["torus", "--radius", "1", "-o", path], "torus has no --radius\nhelp: it has --major and --minor"),
        (&["teapot", "--size", "1", "-o", path], "--scale changes its size"),
        (
            &["torus", "--minor", "2", "-o", path],
            "the tube's radius 2 is not smaller than the ring's radius 1",
        ),
        (&["sphere", "--radius", "0", "-o", path], "the radius is 0"),
        (&["wave", "--size", "1,2", "-o", path], "only one --size"),
        (&["superquadric", "--roundness", "2", "-o", path], "the roundness is 2"),
        (&["ellipsoid", "--semi-axes", "1,2", "-o", path], "three numbers"),
        (&["sphere", "--scale", "1,0,1", "-o", path], "a factor of 0"),
        (&["sphere", "--scale", "nan", "-o", path], "one factor, or three"),
        (
            &["sphere", "--offset", "1e308,0,0", "--scale", "1e308", "--radius", "1e3", "-o", path],
            "beyond the range",
        ),
        (
            &["sphere", "--segments", "2x9", "-o", path],
            "2 segments in the first direction; at least 3 expected",
        ),
        (&["sphere", "--segments", "0", "-o", path], "a number of cells"),
        (&["sphere", "--segments", "99999", "-o", path], "9999800001 cells; at most 16777216 expected"),
        (&["sphere", "--level", "2", "-o", path], "the pattern triangles has no --level"),
        (&["sphere", "--ratio", "2", "-o", path], "the pattern triangles has no --ratio"),
        (&["sphere", "--pattern", "icosphere", "--segments", "4", "-o", path], "icosphere has no --segments"),
        (&["sphere", "--jitter", "2", "-o", path], "the jitter is 2; a number from 0 to 1 was expected"),
        (&["sphere", "--pattern", "slivers", "--jitter", "0.1", "-o", path], "it takes no jitter"),
        (&["sphere", "-o", "-"], "unknown output format of standard output"),
        (&["sphere", "-o", folder.path().to_str().unwrap()], "is a folder"),
        (&["sphere", "-o", "a.txt"], "unknown output format \".txt\" (a.txt)"),
    ];
    for (args, expected) in cases {
        let output = surface(args);
        assert_eq!(code(&output), 2, "{args:?}: {}", text(&output.stderr));
        assert!(text(&output.stderr).contains(expected), "{args:?}: {}", text(&output.stderr));
        assert!(output.stdout.is_empty());
    }
    assert_eq!(std::fs::read_dir(folder.path()).unwrap().count(), 0);
    let blocked = folder.path().join("file");
    std::fs::write(&blocked, "").unwrap();
    let output = surface(&["sphere", "--json", "-o", blocked.join("x.ply").to_str().unwrap()]);
    assert_eq!(code(&output), 4, "{}", text(&output.stderr));
    let report: Value = serde_json::from_slice(&output.stdout).unwrap();
    assert_eq!((&report["status"], &report["error"]["kind"]), (&"failed".into(), &"output".into()));
}

#[cfg(target_os = "linux")]
#[test]
fn a_report_that_cannot_be_written_is_a_failure() {
    let folder = TempDir::new().unwrap();
    for json in [&["--json"][..], &[]] {
        let full = std::fs::File::options().write(true).open("/dev/full").unwrap();
        let mut command = std::process::Command::new(env!("CARGO_BIN_EXE_crease"));
        command.args(["surface", "torus", "-o"]).arg(folder.path().join("torus.ply")).args(json);
        let output = command.stdout(full).stderr(std::process::Stdio::piped()).spawn().unwrap();
        let output = output.wait_with_output().unwrap();
        assert_eq!(code(&output), 4, "{json:?}");
        assert!(text(&output.stderr).contains("the report could not be written"), "{json:?}");
    }
}

#[test]
fn help_has_examples_that_work() {
    let output = surface(&["--help"]);
    let help = text(&output.stdout);
    let examples: Vec<&str> =
        help.lines().filter_map(|line| line.trim().strip_prefix("crease surface ")).collect();
    assert_eq!(examples.len(), 3, "{help}");
    for example in examples {
        let folder = TempDir::new().unwrap();
        let mut command = Command::new(env!("CARGO_BIN_EXE_crease"));
        let output =
            command.current_dir(&folder).arg("surface").args(example.split_whitespace()).output().unwrap();
        assert_eq!(code(&output), 0, "{example}: {}", text(&output.stderr));
        assert_eq!(std::fs::read_dir(folder.path()).unwrap().count(), 1, "{example}");
    }
    for option in [
        "--segments",
        "--jitter",
        "--noise",
        "--seed",
        "--pattern",
        "--ratio",
        "--level",
        "--scale",
        "--offset",
    ] {
        assert!(help.contains(option), "{option}");
    }
    assert!(help.contains("Exit codes:"));
}
