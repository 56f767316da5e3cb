//! The report on one input file, as JSON.
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

use super::args::RecipeArgs;
use super::request::{Job, Request};
use crate::cli::common::report::{Head, InputReport, MeshOutput};
use crease::io::{Note, PartEdit};
use crease::normals::Broken;
use crease::pipeline::{PartOutcome, ReasonCounts, ReplacedCounts, Spot};
use serde::ser::SerializeMap;
use serde::{Serialize, Serializer};
use std::collections::BTreeMap;

#[derive(Serialize)]
pub struct Report<'a> {
    #[serde(flatten)]
    pub head: Head,
    pub input: InputReport,
    #[serde(skip_serializing_if = "Option::is_none")]
    pub output: Option<MeshOutput>,
    dry_run: bool,
    pub recipe: &'a RecipeArgs,
    pub parts: Vec<Part>,
    pub notes: Vec<Note>,
    pub seconds: Seconds,
}

#[derive(Debug, Default, Serialize)]
pub struct Seconds {
    pub read: f64,
    pub compute: f64,
    pub write: f64,
    pub total: f64,
}

/// A part of the file and, if they go into the report, the normals of its faces.
pub struct Part {
    pub outcome: PartOutcome,
    pub face_normals: Option<Vec<Option<[f64; 3]>>>,
}

/// Counts by the name of a reason.
pub type Counts = BTreeMap<&'static str, usize>;

impl<'a> Report<'a> {
    /// A report on an input that nothing has been done with yet.
    pub fn new(job: &Job, request: &'a Request) -> Self {
        Self {
            head: Head::new("crease-normals/1"),
            input: InputReport::new(&job.source, job.format),
            output: None,
            dry_run: request.args.output.dry_run,
            recipe: &request.args.normals,
            parts: Vec::new(),
            notes: Vec::new(),
            seconds: Seconds::default(),
        }
    }
}

impl Part {
    pub fn new(outcome: PartOutcome, edit: Option<&PartEdit>) -> Self {
        let face_normals = edit.map(|edit| {
            let rows = edit.face_normals.iter().flatten().enumerate();
            rows.map(|(face, row)| edit.faces.keeps(face as u32).then(|| row.to_array())).collect()
        });
        Self { outcome, face_normals }
    }
}

impl Serialize for Part {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        let PartOutcome { summary, faults, .. } = &self.outcome;
        let outcome = &self.outcome;
        let mut map = serializer.serialize_map(None)?;
        map.serialize_entry("name", &outcome.name)?;
        map.serialize_entry("vertices", &outcome.vertices)?;
        map.serialize_entry("referenced_vertices", &summary.referenced_vertices)?;
        map.serialize_entry("faces", &outcome.faces)?;
        map.serialize_entry("corners", &outcome.corners)?;
        for (kind, count) in ["triangles", "quads", "polygons"].iter().zip(outcome.arities) {
            map.serialize_entry(kind, &count)?;
        }
        map.serialize_entry("entries", &outcome.entries)?;
        map.serialize_entry("splits", &summary.splits)?;
        map.serialize_entry("crease_degrees", &summary.crease_degrees)?;
        map.serialize_entry("near_crease", &summary.near_crease)?;
        map.serialize_entry("edges", &summary.edges)?;
        let faults = Faults {
            faces: by_reason(&faults.faces),
            corners: by_reason(&faults.corners),
            vertices: by_reason(&faults.vertices),
        };
        map.serialize_entry("faults", &faults)?;
        map.serialize_entry("kept_corners", &outcome.kept)?;
        map.serialize_entry("replaced_corners", &replaced(&outcome.replaced))?;
        let places = outcome.fault_places.iter().map(|&(spot, reason)| Place { spot, reason: reason.name() });
        entry_if_any(&mut map, "fault_places", places)?;
        let places =
            outcome.broken_places.iter().map(|&(spot, reason)| Place { spot, reason: reason.name() });
        entry_if_any(&mut map, "broken_places", places)?;
        map.serialize_entry("reversed_faces", &outcome.reversed_faces)?;
        map.serialize_entry("dropped_faces", &outcome.dropped_faces)?;
        map.serialize_entry("non_finite_faces", &outcome.non_finite_faces)?;
        if let Some(orientation) = &outcome.orientation {
            map.serialize_entry("orientation", orientation)?;
        }
        map.serialize_entry("quadric_fallbacks", &summary.quadric_fallbacks)?;
        map.serialize_entry("cone_declined", &summary.cone_declined)?;
        map.serialize_entry("wide_clusters", &summary.wide_clusters)?;
        map.serialize_entry("faces_before_groups", &summary.faces_before_groups)?;
        map.serialize_entry("fast_declined", &summary.fast_declined)?;
        if let Some(normals) = &self.face_normals {
            map.serialize_entry("face_normals", normals)?;
        }
        map.end()
    }
}

#[derive(Serialize)]
struct Faults {
    faces: Counts,
    corners: Counts,
    vertices: Counts,
}

/// An element of a part and what was found there.
#[derive(Serialize)]
struct Place {
    #[serde(flatten)]
    spot: Spot,
    reason: &'static str,
}

fn entry_if_any<M: SerializeMap>(
    map: &mut M,
    key: &str,
    places: impl Iterator<Item = Place>,
) -> Result<(), M::Error> {
    let places: Vec<Place> = places.collect();
    if places.is_empty() { Ok(()) } else { map.serialize_entry(key, &places) }
}

/// Faults by their reason.
pub fn by_reason(counts: &ReasonCounts) -> Counts {
    counts.iter().map(|(reason, count)| (reason.name(), count)).collect()
}

/// Corners whose stored normal was replaced, by the reason.
pub fn replaced(counts: &ReplacedCounts) -> Counts {
    let broken = Broken::ALL.map(Broken::name).into_iter().zip(counts.broken);
    [("Missing", counts.missing)].into_iter().chain(broken).filter(|(_, count)| *count > 0).collect()
}
