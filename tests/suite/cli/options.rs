//! Each option has its effect. Other tests check the results of the library.

use super::{TRIANGLE, code, data, folder, normals, path, succeed, text};
use std::fs;
use std::path::Path;

/// The JSON report of a run.
fn report(args: &[&str]) -> serde_json::Value {
    serde_json::from_slice(&succeed(args.iter().copied().chain(["--json"])).stdout).unwrap()
}

fn part(args: &[&str]) -> serde_json::Value {
    report(args)["parts"][0].clone()
}

#[test]
fn every_value_of_every_option_runs_on_every_format() {
    let table: &[(&str, &[&str])] = &[
        ("--emit", &["corner", "vertex"]),
        ("--weight", &["uniform", "area", "angle", "angle-area", "max", "edge", "quadric", "jet", "best"]),
        ("--crease", &["0", "40", "180", "off"]),
        ("--crease-rule", &["fan", "cone"]),
        ("--groups", &["honour", "ignore"]),
        ("--hard-edges", &["uv", "material", "authored", "uv,material"]),
        ("--when", &["always", "missing", "broken"]),
        ("--weld", &["exact", "off", "1e-6"]),
        ("--slivers", &["exclude", "keep"]),
        ("--degenerate", &["keep", "drop"]),
        ("--orient", &["keep", "consistent", "outward"]),
        ("--precision", &["faithful", "fast"]),
        ("--tangents", &["auto", "drop", "keep", "regenerate"]),
        ("--normal-format", &["same", "f32", "i16", "i8"]),
        ("--material", &["default", "none"]),
        ("--compress", &["none"]),
        ("--threads", &["1", "3"]),
    ];
    let inputs =
        ["gear.obj", "slivers.obj", "far.ply", "leaf.ply", "part.stl", "morph.gltf", "sphere-seam.glb"];
    let inputs = inputs.map(|name| path(data(name)));
    for (option, values) in table {
        for value in *values {
            let args = inputs.iter().map(String::as_str).chain(["--dry-run", "-q", option, value]);
            succeed(args);
        }
    }
}

#[test]
fn every_format_goes_to_every_format() {
    let work = folder(&[]);
    for input in ["bracket.obj", "polygons.obj", "leaf.ply", "part-binary.stl", "mirrored.gltf", "morph.gltf"]
    {
        for to in ["obj", "ply", "stl", "gltf", "glb"] {
            let out =
                path(work.path().join(format!("{}.{to}", Path::new(input).file_stem().unwrap().display())));
            succeed([&path(data(input)), "-o", &out]);
            let again = report(&[&out, "--dry-run"]);
            let faces = |report: &serde_json::Value| -> u64 {
                report["parts"].as_array().unwrap().iter().map(|part| part["faces"].as_u64().unwrap()).sum()
            };
            assert!(faces(&again) > 0, "{input} to {to}");
        }
    }
}

#[test]
fn any_number_of_threads_gives_the_same_bytes() {
    let work = folder(&[]);
    for (input, to) in
        [("gear.obj", "glb"), ("slivers.obj", "ply"), ("morph.gltf", "gltf"), ("far.ply", "ply")]
    {
        let outputs = ["1", "2", "3", "8"].map(|threads| {
            let out = path(work.path().join(format!("{threads}.{to}")));
            succeed([&path(data(input)), "-o", &out, "--weight", "quadric", "--threads", threads]);
            fs::read(out).unwrap()
        });
        assert!(outputs.windows(2).all(|pair| pair[0] == pair[1]), "{input}");
    }
}

#[test]
fn the_angle_applies_next_to_groups_only_if_typed() {
    let gear = path(data("gear.obj"));
    assert_eq!(part(&[&gear, "--dry-run"])["crease_degrees"], serde_json::Value::Null);
    assert_eq!(part(&[&gear, "--dry-run"])["edges"]["crease"], 0);
    assert_eq!(part(&[&gear, "--dry-run", "--crease", "30"])["crease_degrees"], 30.0);
    assert!(part(&[&gear, "--dry-run", "--crease", "30"])["edges"]["crease"].as_u64() > Some(0));
    assert_eq!(part(&[&gear, "--dry-run", "--groups", "ignore"])["crease_degrees"], 40.0);
    assert_eq!(part(&[&path(data("part.stl")), "--dry-run"])["crease_degrees"], 40.0);
    assert_eq!(part(&[&path(data("part.stl")), "--dry-run", "--crease", "off"])["edges"]["crease"], 0);
}

#[test]
fn the_chamfer_of_45_degrees_is_sharp_at_44_and_smooth_at_46() {
    let creased =
        |angle| part(&[&path(data("gear.obj")), "--dry-run", "--crease", angle])["edges"]["crease"].as_u64();
    assert!(creased("44") > creased("46"));
}

#[test]
fn emit_vertex_gives_one_normal_a_vertex() {
    let found = part(&[&path(data("gear.obj")), "--dry-run", "--emit", "vertex"]);
    assert_eq!((&found["splits"], &found["entries"]), (&0.into(), &1260.into()));
}

#[test]
fn welding_joins_the_seam() {
    let sphere = path(data("sphere-seam.glb"));
    assert!(part(&[&sphere, "--dry-run"])["edges"]["welded"].as_u64() > Some(0));
    let apart = part(&[&sphere, "--dry-run", "--weld", "off"]);
    assert_eq!(apart["edges"]["welded"], 0);
    assert!(apart["edges"]["boundary"].as_u64() > Some(0));
    assert!(part(&[&sphere, "--dry-run", "--hard-edges", "uv"])["edges"]["marked"].as_u64() > Some(0));
}

#[test]
fn slivers_are_counted() {
    let slivers = path(data("slivers.obj"));
    let faults = &part(&[&slivers, "--dry-run"])["faults"]["faces"];
    // Fourteen cap triangles have no direction of their own: one exactly, the others by rounding.
    assert_eq!((&faults["ZeroArea"], &faults["BelowStorage"]), (&1.into(), &13.into()), "{faults}");
}

#[test]
fn flipping_turns_faces_and_normals() {
    let work = folder(&[("a.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nvn 0 0 1\nf 1//1 2//1 3//1\n")]);
    let input = path(work.path().join("a.obj"));
    for when in ["always", "missing", "broken"] {
        let out = path(work.path().join("out.obj"));
        succeed([&input, "-o", &out, "--flip", "--when", when]);
        let out = fs::read_to_string(out).unwrap();
        assert!(out.contains("vn 0 0 -1\n") || out.contains("vn -0 -0 -1\n"), "{when}: {out}");
        let corners: Vec<&str> =
            out.lines().find_map(|line| line.strip_prefix("f ")).unwrap().split(' ').collect();
        let vertices: Vec<&str> = corners.iter().map(|corner| corner.split('/').next().unwrap()).collect();
        assert_eq!(vertices, ["1", "3", "2"], "{when}");
    }
}

#[test]
fn orienting_outward_mends_a_mesh_turned_inside_out() {
    let work = folder(&[]);
    let [flipped, mended] = ["flipped.ply", "mended.ply"].map(|name| path(work.path().join(name)));
    succeed([&path(data("polygons.obj")), "-o", &flipped, "--flip"]);
    let found = part(&[&flipped, "-o", &mended, "--orient", "outward"]);
    assert_eq!(found["reversed_faces"], found["faces"]);
    assert_eq!(found["orientation"]["closed"], 3);
    assert_eq!(part(&[&mended, "--dry-run", "--orient", "outward"])["reversed_faces"], 0);
    // Reversed by orientation, then flipped back.
    let both = part(&[&flipped, "--dry-run", "--orient", "outward", "--flip"]);
    assert_eq!(both["reversed_faces"], 0);
}

#[test]
fn force_drops_faces_without_finite_positions() {
    let content = format!("{}v nan 0 0\nf 1 2 4\n", TRIANGLE);
    let work = folder(&[("a.obj", &content)]);
    let [input, out] = ["a.obj", "b.obj"].map(|name| path(work.path().join(name)));
    let refused = normals([&input, "-o", &out]);
    assert_eq!(code(&refused), 3);
    assert!(text(&refused.stderr).contains("line 5"), "{}", text(&refused.stderr));
    let found = part(&[&input, "-o", &out, "--force"]);
    assert_eq!((&found["faces"], &found["non_finite_faces"]), (&2.into(), &1.into()));
    assert_eq!(fs::read_to_string(out).unwrap().lines().filter(|line| line.starts_with("f ")).count(), 1);
}

#[test]
fn missing_and_broken_normals_are_replaced_and_counted() {
    let obj = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 1 1 0\nvn 0 0 1\nvn 0 0 -1\nvn 0 0 3\n\
               f 1//1 2//2 3//3\nf 2 4 3\n";
    let work = folder(&[("a.obj", obj)]);
    let [input, out] = ["a.obj", "b.obj"].map(|name| path(work.path().join(name)));
    let missing = part(&[&input, "--dry-run", "--when", "missing"]);
    assert_eq!(missing["replaced_corners"], serde_json::json!({ "Missing": 3 }));
    assert_eq!(missing["kept_corners"], 3);
    let broken = part(&[&input, "-o", &out, "--when", "broken"]);
    assert_eq!(
        broken["replaced_corners"],
        serde_json::json!({ "Missing": 3, "Length": 1, "AgainstFace": 1 })
    );
    let again = report(&[&out, "--dry-run", "--when", "broken"]);
    assert_eq!(again["output"]["unchanged"], true, "a second time changes nothing");
}
