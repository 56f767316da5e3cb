//! The JSON report: its members are those that are documented, no more and no fewer.

use super::{BAD, TRIANGLE, code, data, folder, normals, path, succeed, text};
use serde::Deserialize;
use std::collections::BTreeMap;

#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields)]
#[allow(dead_code, reason = "the members are checked by being read")]
struct Report {
    schema: String,
    crease: String,
    status: String,
    error: Option<serde_json::Value>,
    input: Input,
    output: Option<Output>,
    dry_run: bool,
    recipe: Recipe,
    parts: Vec<Part>,
    notes: Vec<Note>,
    seconds: Seconds,
}

#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields)]
struct Input {
    path: String,
    format: Option<String>,
    bytes: Option<u64>,
}

#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields)]
#[allow(dead_code, reason = "the members are checked by being read")]
struct Output {
    path: Option<String>,
    format: String,
    bytes: u64,
    vertices: u64,
    added_vertices: u64,
    merged_vertices: u64,
    moved: Option<Moved>,
    matrix: Option<[f64; 16]>,
    unchanged: bool,
    companions: Vec<String>,
}

#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields)]
#[allow(dead_code, reason = "the members are checked by being read")]
struct Moved {
    vertices: usize,
    longest: f64,
}

#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields)]
#[allow(dead_code, reason = "the members are checked by being read")]
struct Recipe {
    emit: String,
    weight: String,
    crease: Option<f64>,
    crease_rule: String,
    groups: String,
    hard_edges: Vec<String>,
    when: String,
    weld: serde_json::Value,
    slivers: String,
    precision: String,
}

#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields)]
#[allow(dead_code, reason = "the members are checked by being read")]
struct Part {
    name: String,
    vertices: usize,
    referenced_vertices: usize,
    faces: usize,
    corners: usize,
    triangles: usize,
    quads: usize,
    polygons: usize,
    entries: usize,
    splits: usize,
    crease_degrees: Option<f64>,
    near_crease: usize,
    near_cancellation: Option<BTreeMap<String, f64>>,
    edges: BTreeMap<String, usize>,
    faults: BTreeMap<String, BTreeMap<String, usize>>,
    kept_corners: usize,
    replaced_corners: BTreeMap<String, usize>,
    #[serde(default)]
    fault_places: Vec<Spot>,
    #[serde(default)]
    broken_places: Vec<Spot>,
    reversed_faces: usize,
    dropped_faces: usize,
    non_finite_faces: usize,
    orientation: Option<BTreeMap<String, Option<f64>>>,
    quadric_fallbacks: usize,
    jet_fallbacks: Option<BTreeMap<String, BTreeMap<String, usize>>>,
    best: Option<Best>,
    cone_declined: usize,
    wide_clusters: usize,
    faces_before_groups: usize,
    fast_declined: bool,
    face_normals: Option<Vec<Option<[f64; 3]>>>,
}

#[derive(Debug, PartialEq, Deserialize)]
#[serde(deny_unknown_fields)]
#[allow(dead_code, reason = "the members are checked by being read")]
struct Best {
    weight: String,
    sampled: usize,
    fitted: usize,
    noise: f64,
    jet: f64,
    quadric: f64,
    angle: f64,
}

#[derive(Debug, PartialEq, Deserialize)]
#[serde(deny_unknown_fields)]
struct Spot {
    face: Option<u32>,
    corner: Option<u32>,
    vertex: Option<u32>,
    reason: String,
}

#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields)]
#[allow(dead_code, reason = "the members are checked by being read")]
struct Note {
    severity: String,
    place: Option<serde_json::Value>,
    text: String,
    more: Option<u64>,
    #[serde(default)]
    also: Vec<serde_json::Value>,
}

#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields)]
struct Seconds {
    read: f64,
    compute: f64,
    write: f64,
    total: f64,
}

fn reports(output: &std::process::Output) -> Vec<Report> {
    text(&output.stdout).lines().map(|line| serde_json::from_str(line).unwrap()).collect()
}

fn one(args: &[&str]) -> Report {
    let mut reports = reports(&succeed(args.iter().copied().chain(["--json"])));
    assert_eq!(reports.len(), 1);
    reports.pop().unwrap()
}

#[test]
fn one_object_reports_everything() {
    let work = folder(&[]);
    let out = path(work.path().join("gear.glb"));
    let report =
        one(&[&path(data("gear.obj")), "-o", &out, "--crease", "40", "--weight", "max", "--weld", "1e-6"]);
    assert_eq!((report.schema.as_str(), report.status.as_str()), ("crease-normals/1", "ok"));
    assert!(report.error.is_none() && !report.dry_run);
    assert_eq!(report.input.format.as_deref(), Some("obj"));
    assert_eq!(report.input.bytes, Some(std::fs::metadata(data("gear.obj")).unwrap().len()));
    let output = report.output.unwrap();
    assert_eq!(output.path, Some(out.clone()));
    assert_eq!(output.bytes, std::fs::metadata(out).unwrap().len());
    assert_eq!((report.recipe.weight.as_str(), report.recipe.crease), ("max", Some(40.0)));
    assert_eq!(report.recipe.weld, 1e-6);
    let part = &report.parts[0];
    assert_eq!((part.vertices, part.faces, part.quads, part.corners), (1260, 1260, 1260, 5040));
    assert_eq!(part.crease_degrees, Some(40.0));
    assert_eq!(part.entries - part.referenced_vertices, part.splits);
    // A closed surface of quads has as many edges as half its corners.
    let kinds = ["smooth", "boundary", "non_manifold", "inconsistent", "ambiguous", "marked", "crease"];
    assert_eq!(kinds.iter().map(|kind| part.edges[*kind]).sum::<usize>(), 2520);
    assert!(part.edges["crease"] > 0 && part.edges["marked"] > 0 && part.edges["boundary"] == 0);
    let Seconds { read, compute, write, total } = report.seconds;
    assert!(read > 0.0 && compute > 0.0 && write > 0.0 && total >= read + compute + write);
}

/// A wave with a wall under one of its sides, at a crease.
fn wave_on_a_wall() -> String {
    const N: usize = 24;
    let mut text = String::new();
    let share = |i: usize| i as f64 / N as f64;
    let wave = |i: usize, j: usize| 0.1 * libm::sin(6.0 * share(i)) * libm::cos(4.0 * share(j));
    for (i, j) in (0..=N).flat_map(|i| (0..=N).map(move |j| (i, j))) {
        text += &format!("v {} {} {}\n", share(i), wave(i, j), share(j));
    }
    let top = |i: usize, j: usize| i * (N + 1) + j + 1;
    for (i, j) in (0..N).flat_map(|i| (0..N).map(move |j| (i, j))) {
        text += &format!("f {} {} {} {}\n", top(i, j), top(i, j + 1), top(i + 1, j + 1), top(i + 1, j));
    }
    // The wall, down from the side with i = 0.
    for j in 0..=N {
        text += &format!("v 0 -1 {}\n", share(j));
    }
    let foot = |j: usize| (N + 1) * (N + 1) + j + 1;
    for j in 0..N {
        text += &format!("f {} {} {} {}\n", top(0, j), foot(j), foot(j + 1), top(0, j + 1));
    }
    text
}

#[test]
fn the_best_weight_keeps_creases() {
    let work = folder(&[("wave.obj", &wave_on_a_wall())]);
    let [input, out] = ["wave.obj", "out.obj"].map(|name| path(work.path().join(name)));
    let report = one(&[&input, "-o", &out, "--weight", "best", "--crease", "40"]);
    let part = &report.parts[0];
    let best = part.best.as_ref().unwrap();
    assert_eq!(best.weight, "jet", "{best:?}");
    assert_eq!((part.edges["crease"], part.splits), (24, 25));
    // Normals on the wall are horizontal, though a fit across the crease would tilt them.
    let written = std::fs::read_to_string(&out).unwrap();
    let numbers = |line: &str| -> Vec<f64> { line.split(' ').skip(1).map(|x| x.parse().unwrap()).collect() };
    let normals: Vec<Vec<f64>> = written.lines().filter(|it| it.starts_with("vn ")).map(numbers).collect();
    let horizontal = normals.iter().filter(|normal| normal[1].abs() < 1e-6).collect::<Vec<_>>();
    assert!(!horizontal.is_empty() && horizontal.iter().all(|it| it[0] < -0.999_999), "{horizontal:?}");
    let steep = |normal: &&Vec<f64>| (0.001..0.7).contains(&normal[1].abs());
    assert_eq!(normals.iter().filter(steep).count(), 0, "no normal is between top and wall");
}

/// A glTF of so many triangles, each a mesh of its own.
fn triangles(count: usize) -> String {
    let meshes: Vec<String> = (0..count)
        .map(|n| format!(r#"{{"name":"m{n}","primitives":[{{"attributes":{{"POSITION":0}}}}]}}"#))
        .collect();
    let nodes: Vec<String> = (0..count).map(|n| format!(r#"{{"mesh":{n}}}"#)).collect();
    let bytes = "AAAAAAAAAAAAAAAAAACAPwAAAAAAAAAAAAAAAAAAgD8AAAAA";
    let buffer = format!(r#"{{"byteLength":36,"uri":"data:application/octet-stream;base64,{bytes}"}}"#);
    format!(
        r#"{{"asset":{{"version":"2.0"}},"nodes":[{}],"meshes":[{}],"buffers":[{buffer}],
        "bufferViews":[{{"buffer":0,"byteLength":36}}],"accessors":[{{"bufferView":0,"componentType":5126,"count":3,
        "type":"VEC3","min":[0,0,0],"max":[1,1,0]}}]}}"#,
        nodes.join(","),
        meshes.join(",")
    )
}

#[test]
fn the_best_weight_is_explained_for_each_of_few_submeshes() {
    let [few, many] = [2, 5].map(triangles);
    let work = folder(&[("few.gltf", &few), ("many.gltf", &many)]);
    let printed = |name: &str| {
        let output = normals([&*path(work.path().join(name)), "--weight", "best", "--dry-run"]);
        assert_eq!(code(&output), 0, "{}", text(&output.stderr));
        text(&output.stdout).to_owned()
    };
    let few = printed("few.gltf");
    for name in ["m0", "m1"] {
        let line = format!("best     angle for {name}: surfaces can be fitted at 0 of 3 normals only\n");
        assert!(few.contains(&line), "{few}");
    }
    assert!(printed("many.gltf").contains("best     angle for 5 submeshes\n"));
}

#[test]
fn several_inputs_give_a_line_each_in_their_order_whatever_happens() {
    let work = folder(&[("b.obj", TRIANGLE), ("a.obj", BAD), ("c.obj", TRIANGLE)]);
    let inputs = ["b.obj", "a.obj", "c.obj"].map(|name| path(work.path().join(name)));
    let args = inputs.iter().map(String::as_str).chain(["--dry-run", "--json", "--threads", "2"]);
    let output = normals(args);
    assert_eq!(code(&output), 5);
    let reports = reports(&output);
    assert_eq!(
        reports.iter().map(|report| &report.input.path).collect::<Vec<_>>(),
        inputs.iter().collect::<Vec<_>>()
    );
    assert_eq!(
        reports.iter().map(|report| report.status.as_str()).collect::<Vec<_>>(),
        ["ok", "failed", "ok"]
    );
    let error = reports[1].error.as_ref().unwrap();
    assert_eq!(error["kind"], "input");
    assert_eq!(error["place"]["line"], 2);
    for member in ["problem", "found", "advice", "message"] {
        assert!(error[member].as_str().is_some_and(|text| !text.is_empty()), "{member}: {error}");
    }
}

#[test]
fn a_failure_to_write_is_reported_as_such() {
    let work = folder(&[("a.obj", TRIANGLE)]);
    let input = path(work.path().join("a.obj"));
    let output = normals([&input, "-o", &format!("{input}/b.obj"), "--json"]);
    assert_eq!(code(&output), 4);
    let report = &reports(&output)[0];
    assert_eq!(report.error.as_ref().unwrap()["kind"], "output");
    assert!(report.output.is_none());
}

#[test]
fn face_normals_are_rows_where_nothing_is_written() {
    let report = one(&[&path(data("part.stl")), "--emit", "face"]);
    assert!(report.output.is_none());
    let rows = report.parts[0].face_normals.as_ref().unwrap();
    assert_eq!(rows.len(), report.parts[0].faces);
    for row in rows {
        let [x, y, z] = row.expect("no face is dropped");
        assert!(((x * x + y * y + z * z).sqrt() - 1.0).abs() < 1e-15);
    }
    // The bottom of the part is its fourth triangle, and it is flat.
    assert_eq!(rows[3], Some([0.0, -1.0, 0.0]));

    let work = folder(&[]);
    let written = one(&[&path(data("part.stl")), "--emit", "face", "-o", &path(work.path().join("p.ply"))]);
    assert!(written.parts[0].face_normals.is_none() && written.output.is_some());
}

/// The second triangle's second corner has a normal of length 3; the third triangle has no area.
const BROKEN: &str = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 1 1 0\nvn 0 0 1\nvn 0 0 3\n\
                      f 1//1 2//1 3//1\nf 2//1 4//2 3//1\nf 1//1 1//1 2//1\n";

#[test]
fn places_are_identified_by_face_corner_and_vertex() {
    let work = folder(&[("a.obj", BROKEN)]);
    let input = path(work.path().join("a.obj"));
    let args = [input.as_str(), "--dry-run", "--when", "broken"];
    let part = one(&args).parts.pop().unwrap();
    let spot = |face, corner, vertex, reason: &str| Spot { face, corner, vertex, reason: reason.into() };
    assert_eq!(part.broken_places, [spot(Some(1), Some(1), Some(3), "Length")]);
    assert!(part.fault_places.contains(&spot(Some(2), None, None, "ZeroArea")), "{:?}", part.fault_places);
    let output = succeed(args);
    let reported = text(&output.stdout);
    for piece in [
        "1 not of unit length; ",
        "1 without area",
        "face 1, corner 1 (vertex 3): stored normal not of unit length",
    ] {
        assert!(reported.contains(piece), "no {piece:?} in\n{reported}");
    }
    assert!(!reported.contains("AgainstFace") && !reported.contains("ZeroArea"), "{reported}");
}

#[test]
fn all_places_of_a_note_are_printed_if_asked_for() {
    let lines: String = (0..150).map(|k| format!("odd {k}\n")).collect();
    let work = folder(&[("a.obj", &format!("{TRIANGLE}{lines}"))]);
    let input = path(work.path().join("a.obj"));
    let said = |args: &[&str]| text(&succeed([&[&*input, "--dry-run"], args].concat()).stderr).to_owned();
    assert!(said(&[]).contains("line 5: the unknown statement `odd` was ignored (and 149 more like it)\n"));
    let all = said(&["-v"]);
    assert!(all.contains("(and 149 more like it: line 6, line 7, ") && all.contains("line 105, …)"), "{all}");
    let note = &one(&[&input, "--dry-run"]).notes[0];
    assert_eq!((note.more, note.also.len()), (Some(149), 100));
    assert_eq!(note.also[99], serde_json::json!({ "line": 105 }));
}

#[test]
fn reports_have_what_was_done_and_no_more() {
    let gear = path(data("gear.obj"));
    let reported = |args: &[&str]| {
        text(&succeed([&[&*gear, "--dry-run", "--to", "ply"], args].concat()).stdout).to_owned()
    };
    assert!(reported(&["--crease", "off"]).contains("fan rule, crease off"));
    let faces = reported(&["--emit", "face"]);
    assert!(faces.contains("normals  1260, one per face\n") && !faces.contains("split"), "{faces}");
    let vertices = reported(&["--emit", "vertex"]);
    assert!(vertices.contains("edges    2520: 2520 smooth\n"), "{vertices}");
}

#[test]
fn dropped_faces_have_no_row() {
    let report = one(&[&path(data("slivers.obj")), "--emit", "face", "--degenerate", "drop"]);
    let part = &report.parts[0];
    assert_eq!(part.dropped_faces, part.faults["faces"]["ZeroArea"]);
    let rows = part.face_normals.as_ref().unwrap();
    assert_eq!(rows.iter().filter(|row| row.is_none()).count(), part.dropped_faces);
    assert!(part.dropped_faces > 0 && rows.len() == part.faces);
}

/// Only scans have the row: the folds of a corrugated sheet are chains of two edges, too, but end at its boundary.
#[test]
fn scattered_creases_are_reported_of_scans_and_not_of_folds() {
    let (mut folds, mut faces) = (String::new(), String::new());
    for i in 0..30 {
        let (x, z) = (0.5 * f64::from(i), 0.5 * f64::from(i % 2));
        folds += &format!("v {x} 0 {z}\nv {x} 1 {z}\nv {x} 2 {z}\n");
        for v in [3 * i - 2, 3 * i - 1].into_iter().filter(|_| i > 0) {
            faces += &format!("f {v} {} {} {}\n", v + 3, v + 4, v + 1);
        }
    }
    let files = folder(&[("folds.obj", &(folds + &faces))]);
    let scan = path(files.path().join("scan.ply"));
    let noisy =
        ["surface", "torus", "--segments", "48x24", "--jitter", "0.5", "--noise", "0.15", "-o", &scan];
    assert!(super::crease().args(noisy).output().unwrap().status.success());
    let said = |file: &str, more: &[&str]| {
        text(&succeed([&[file, "--dry-run"], more].concat()).stdout).contains("scattered")
    };
    let folds = path(files.path().join("folds.obj"));
    assert!(said(&scan, &[]) && !said(&scan, &["--crease", "0"]) && !said(&folds, &[]));
    // Creases of a prism end at its slivers.
    assert!(!said(&path(data("slivers.obj")), &[]));
    for crease in ["10", "25", "40", "60"] {
        assert!(!said(&path(data("gear.obj")), &["--crease", crease]), "{crease}");
    }
}
