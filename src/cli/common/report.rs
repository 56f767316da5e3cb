//! Members that JSON reports share.

use super::failure::Failure;
use super::input::Source;
use super::output::Target;
use crease::io::{Format, Written};
use crease::mesh::Movement;
use serde::Serialize;

/// The first members of every report: the schema, the program's version, and the status.
#[derive(Debug, Default, Serialize)]
pub struct Head {
    schema: &'static str,
    crease: &'static str,
    pub status: &'static str,
    #[serde(skip_serializing_if = "Option::is_none")]
    pub error: Option<Failure>,
}

impl Head {
    pub fn new(schema: &'static str) -> Self {
        Self { schema, crease: env!("CARGO_PKG_VERSION"), status: "ok", error: None }
    }

    pub fn record<T>(&mut self, result: &Result<T, Failure>) {
        if let Err(failure) = result {
            self.status = "failed";
            self.error = Some(failure.clone());
        }
    }
}

/// The status of an input that an earlier run has done.
pub const SKIPPED: &str = "skipped";

#[derive(Debug, Default, Serialize)]
pub struct InputReport {
    pub path: String,
    #[serde(skip_serializing_if = "Option::is_none")]
    pub format: Option<Format>,
    #[serde(skip_serializing_if = "Option::is_none")]
    pub bytes: Option<u64>,
}

impl InputReport {
    pub fn new(source: &Source, format: Option<Format>) -> Self {
        Self { path: source.name(), format, bytes: source.length() }
    }
}

#[derive(Debug, Serialize)]
pub struct MeshOutput {
    #[serde(skip_serializing_if = "Option::is_none")]
    pub path: Option<String>,
    pub format: Format,
    pub bytes: u64,
    pub vertices: u64,
    pub added_vertices: u64,
    pub merged_vertices: u64,
    /// Vertices that were moved, and how far.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub moved: Option<Movement>,
    /// The conversion of axes and units, column by column.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub matrix: Option<[f64; 16]>,
    /// The same in words.
    #[serde(skip)]
    pub conversion: String,
    pub unchanged: bool,
    pub companions: Vec<String>,
}

impl MeshOutput {
    /// An output that is made but not stored yet.
    pub fn new(target: Option<&Target>, format: Format, unchanged: bool, written: &Written) -> Self {
        Self {
            path: target.map(Target::name),
            format,
            bytes: written.bytes.len() as u64,
            vertices: written.vertices,
            added_vertices: written.added_vertices,
            merged_vertices: written.merged_vertices,
            moved: None,
            matrix: None,
            conversion: String::new(),
            unchanged,
            companions: written.companions.iter().map(|companion| companion.name.clone()).collect(),
        }
    }
}
