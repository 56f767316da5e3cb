//! The report on one input file, as JSON. Members are described in `docs/json.md`.

use super::args::RecipeArgs;
use super::request::Job;
use crate::cli::common::report::{Head, InputReport, MeshOutput};
use crease::io::{Note, PartEdit};
use crease::pipeline::PartOutcome;
use serde::Serialize;

#[derive(Serialize)]
pub struct Report<'a> {
    #[serde(flatten)]
    pub head: Head,
    pub input: InputReport,
    #[serde(skip_serializing_if = "Option::is_none")]
    pub output: Option<MeshOutput>,
    pub dry_run: bool,
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
#[derive(Serialize)]
pub struct Part {
    #[serde(flatten)]
    pub outcome: PartOutcome,
    #[serde(skip_serializing_if = "Option::is_none")]
    pub face_normals: Option<Vec<Option<[f64; 3]>>>,
}

impl<'a> Report<'a> {
    pub fn new(job: &'a Job) -> Self {
        Self {
            head: Head::new("crease-normals/1"),
            input: InputReport::new(&job.input.source, job.format),
            output: None,
            dry_run: job.settings.args.output.dry_run,
            recipe: &job.settings.args.normals,
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
