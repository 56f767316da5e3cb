//! The report on one input file, as JSON. Members are described in `docs/json.md`.

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
