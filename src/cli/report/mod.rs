//! What a run tells about one input: the one source of the JSON and of the text for people.
//!
//! # The JSON schema, `crease-normals/1`
//! One object on one line for each input, in the order of the inputs. A change that could break a reader raises
//! the number after the slash; new members may come at any time.
//!
//! | member | meaning |
//! |---|---|
//! | `schema`, `crease` | `"crease-normals/1"`; the program's version |
//! | `status` | `"ok"` or `"failed"` |
//! | `error` | absent if `ok`; else `kind` (`"usage"`, `"input"`, `"output"`, `"internal"`), `message`, and for `input` also `problem` (such as `"Syntax"`), `place`, `found`, `advice` |
//! | `input` | `path` (`"-"`: standard input), `format`, `bytes`; the last two absent if unknown |
//! | `output` | absent if none was made; else `path` (absent: nowhere), `format`, `bytes`, `vertices`, `added_vertices`, `unchanged` (the bytes are the input's), `companions` (names) |
//! | `dry_run` | whether writing was left out |
//! | `recipe` | what was asked for: `emit`, `weight`, `crease` (degrees; null: the default), `crease_rule`, `groups`, `hard_edges`, `when`, `weld` (`"exact"`, `"off"` or a fraction), `slivers`, `precision` |
//! | `parts` | one object for each mesh of the file, below |
//! | `notes` | `severity` (`"note"`, `"warning"`), `place` (absent: the file as a whole), `text`, and where there are several alike `more` (how many) and `also` (the places of the first 100 of these) |
//! | `seconds` | `read`, `compute`, `write`, `total` |
//!
//! A `place` is `{"line": n}` from 1, `{"byte": n}` from 0, or `{"json": "/a/pointer"}`. A part has `name`; its
//! mesh as it was read: `vertices`, `referenced_vertices`, `faces`, `corners`, `triangles`, `quads`, `polygons` (of
//! five corners or more); the computed normals: `entries` (one for each vertex and smooth group), `splits`
//! (entries minus referenced vertices), `crease_degrees` (the angle that was applied, or null), `near_crease` (edges
//! within 0.1° of it, or within what the few digits of positions allow), `edges` (by kind; the kinds up to `crease` add up to all, `welded` is how many of them were
//! joined by position), `faults` (of `faces`, `corners`, `vertices`: how often which reason), `kept_corners`,
//! `replaced_corners` (by reason: `Missing`, `NotFinite`, `Zero`, `AgainstFace` for a computed normal, `Length` for the stored
//! one divided by its length; both zero or empty unless `when` is `missing` or `broken`), `fault_places` and
//! `broken_places` (the first places of faults, and of corners whose stored normal was broken: `face`, or `face`, `corner`
//! and `vertex`, or `vertex`, all from 0 as in the file, and `reason`; at most 100 of each kind, absent if there are none), `reversed_faces`,
//! `dropped_faces` (without area), `non_finite_faces` (dropped under `--force`), `orientation` (absent unless
//! asked for: counts of `components`, `closed`, `open_told`, `open_left`, `non_orientable`, `flat`, `undecided`,
//! `inside_out`, `open_inside_out`, `cavities`, `rooms`, and `confidence`, the least of those of `open_told`, or null), `quadric_fallbacks`, `cone_declined` (fans too large for the cone rule), `wide_clusters`, `faces_before_groups`, `fast_declined`; and under
//! `--emit face --json` without an output `face_normals`: `[x, y, z]` for each face, null for a dropped one.

mod fill;
mod head;

pub use head::Head;

use serde::Serialize;
use std::collections::BTreeMap;

/// The schema's name and version.
pub const SCHEMA: &str = "crease-normals/1";

/// A report as JSON on one line.
pub fn json_line(report: &impl Serialize) -> String {
    let mut line = serde_json::to_string(report).expect("a report has string keys and finite numbers");
    line.push('\n');
    line
}

#[derive(Debug, Serialize)]
pub struct Report {
    #[serde(flatten)]
    pub head: Head,
    pub input: InputReport,
    #[serde(skip_serializing_if = "Option::is_none")]
    pub output: Option<OutputReport>,
    pub dry_run: bool,
    pub recipe: Recipe,
    pub parts: Vec<PartReport>,
    pub notes: Vec<NoteReport>,
    pub seconds: Seconds,
}

#[derive(Debug, Serialize)]
pub struct ErrorReport {
    pub kind: &'static str,
    pub message: String,
    #[serde(flatten)]
    pub input: Option<InputError>,
}

#[derive(Debug, Serialize)]
pub struct InputError {
    pub problem: String,
    #[serde(skip_serializing_if = "Option::is_none")]
    pub place: Option<PlaceReport>,
    pub found: String,
    pub advice: String,
}

#[derive(Debug, Serialize)]
#[serde(rename_all = "lowercase")]
pub enum PlaceReport {
    Line(u64),
    Byte(u64),
    Json(String),
}

#[derive(Debug, Serialize)]
pub struct InputReport {
    pub path: String,
    #[serde(skip_serializing_if = "Option::is_none")]
    pub format: Option<&'static str>,
    #[serde(skip_serializing_if = "Option::is_none")]
    pub bytes: Option<u64>,
}

#[derive(Debug, Serialize)]
pub struct OutputReport {
    #[serde(skip_serializing_if = "Option::is_none")]
    pub path: Option<String>,
    pub format: &'static str,
    pub bytes: u64,
    pub vertices: u64,
    pub added_vertices: u64,
    pub unchanged: bool,
    pub companions: Vec<String>,
}

#[derive(Debug, Serialize)]
pub struct Recipe {
    pub emit: &'static str,
    pub weight: &'static str,
    pub crease: Option<f64>,
    pub crease_rule: &'static str,
    pub groups: &'static str,
    pub hard_edges: Vec<&'static str>,
    pub when: &'static str,
    pub weld: WeldReport,
    pub slivers: &'static str,
    pub precision: &'static str,
}

#[derive(Debug, Serialize)]
#[serde(untagged)]
pub enum WeldReport {
    Name(&'static str),
    Fraction(f64),
}

#[derive(Debug, Serialize)]
pub struct PartReport {
    pub name: String,
    pub vertices: usize,
    pub referenced_vertices: usize,
    pub faces: usize,
    pub corners: usize,
    pub triangles: usize,
    pub quads: usize,
    pub polygons: usize,
    pub entries: usize,
    pub splits: usize,
    pub crease_degrees: Option<f64>,
    pub near_crease: usize,
    pub edges: Edges,
    pub faults: Faults,
    pub kept_corners: usize,
    pub replaced_corners: BTreeMap<&'static str, usize>,
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub fault_places: Vec<SpotReport>,
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub broken_places: Vec<SpotReport>,
    pub reversed_faces: usize,
    pub dropped_faces: usize,
    pub non_finite_faces: usize,
    #[serde(skip_serializing_if = "Option::is_none")]
    pub orientation: Option<OrientationReport>,
    pub quadric_fallbacks: usize,
    pub cone_declined: usize,
    pub wide_clusters: usize,
    pub faces_before_groups: usize,
    pub fast_declined: bool,
    #[serde(skip_serializing_if = "Option::is_none")]
    pub face_normals: Option<Vec<Option<[f64; 3]>>>,
}

/// An element of a part and what was found there.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
pub struct SpotReport {
    #[serde(skip_serializing_if = "Option::is_none")]
    pub face: Option<u32>,
    #[serde(skip_serializing_if = "Option::is_none")]
    pub corner: Option<u32>,
    #[serde(skip_serializing_if = "Option::is_none")]
    pub vertex: Option<u32>,
    pub reason: &'static str,
}

#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize)]
pub struct Edges {
    pub smooth: usize,
    pub boundary: usize,
    pub non_manifold: usize,
    pub inconsistent: usize,
    pub ambiguous: usize,
    pub marked: usize,
    pub crease: usize,
    pub welded: usize,
}

/// Of a part, what `--orient` found.
#[derive(Debug, Serialize)]
pub struct OrientationReport {
    pub components: usize,
    pub closed: usize,
    pub open_told: usize,
    pub confidence: Option<f64>,
    pub open_left: usize,
    pub non_orientable: usize,
    pub flat: usize,
    pub undecided: usize,
    pub inside_out: usize,
    pub open_inside_out: usize,
    pub cavities: usize,
    pub rooms: usize,
}

#[derive(Debug, Serialize)]
pub struct Faults {
    pub faces: BTreeMap<&'static str, usize>,
    pub corners: BTreeMap<&'static str, usize>,
    pub vertices: BTreeMap<&'static str, usize>,
}

#[derive(Debug, Serialize)]
pub struct NoteReport {
    pub severity: &'static str,
    #[serde(skip_serializing_if = "Option::is_none")]
    pub place: Option<PlaceReport>,
    pub text: String,
    #[serde(skip_serializing_if = "is_zero")]
    pub more: u64,
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub also: Vec<PlaceReport>,
}

fn is_zero(number: &u64) -> bool {
    *number == 0
}

#[derive(Debug, Default, Serialize)]
pub struct Seconds {
    pub read: f64,
    pub compute: f64,
    pub write: f64,
    pub total: f64,
}
