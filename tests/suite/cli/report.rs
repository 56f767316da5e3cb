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
    unchanged: bool,
    companions: Vec<String>,
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
    edges: BTreeMap<String, usize>,
    faults: BTreeMap<String, BTreeMap<String, usize>>,
    kept_corners: usize,
    replaced_corners: BTreeMap<String, usize>,
    reversed_faces: usize,
    dropped_faces: usize,
    non_finite_faces: usize,
    orientation: Option<BTreeMap<String, usize>>,
    quadric_fallbacks: usize,
    wide_clusters: usize,
    faces_before_groups: usize,
    fast_declined: bool,
    face_normals: Option<Vec<Option<[f64; 3]>>>,
}

#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields)]
#[allow(dead_code, reason = "the members are checked by being read")]
struct Note {
    severity: String,
    place: Option<serde_json::Value>,
    text: String,
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
fn one_object_tells_everything() {
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
fn a_failure_to_write_is_told_as_such() {
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

#[test]
fn dropped_faces_have_no_row() {
    let report = one(&[&path(data("slivers.obj")), "--emit", "face", "--degenerate", "drop"]);
    let part = &report.parts[0];
    assert_eq!(part.dropped_faces, part.faults["faces"]["ZeroArea"]);
    let rows = part.face_normals.as_ref().unwrap();
    assert_eq!(rows.iter().filter(|row| row.is_none()).count(), part.dropped_faces);
    assert!(part.dropped_faces > 0 && rows.len() == part.faces);
}
