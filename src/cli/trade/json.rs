//! The report of `crease trade` as JSON.
//!
//! # The JSON schema, `crease-trade/1`
//! One object on one line.
//!
//! | member | meaning |
//! |---|---|
//! | `schema`, `crease` | `"crease-trade/1"`; the program's version |
//! | `status`, `error` | as in `crease-normals/1` |
//! | `input` | the mesh that was given, if any |
//! | `output` | the page, if one was asked for |
//! | `surfaces` | without an input: [`Trade`](crease::trade::Trade), whose members are described there |
//! | `mesh` | with one: [`OwnMesh`](crease::trade::OwnMesh) |
//! | `advice` | sentences; absent if nothing was measured |
//! | `seconds` | how long it took |
//!
//! Angles are in degrees. Nanoseconds (`…_ns`, `ns…`), `milliseconds`, `ratio` and `seconds` differ from run to run, and so may
//! the sentences that name them; nothing else does.

use crate::cli::common::report::Head;
use crease::trade::{OwnMesh, Trade};
use serde::Serialize;

#[derive(Debug, Serialize)]
pub struct Report {
    #[serde(flatten)]
    pub head: Head,
    #[serde(skip_serializing_if = "Option::is_none")]
    pub input: Option<String>,
    #[serde(skip_serializing_if = "Option::is_none")]
    pub output: Option<String>,
    #[serde(skip_serializing_if = "Option::is_none")]
    pub surfaces: Option<Trade>,
    #[serde(skip_serializing_if = "Option::is_none")]
    pub mesh: Option<OwnMesh>,
    #[serde(skip_serializing_if = "Option::is_none")]
    pub advice: Option<Vec<String>>,
    pub seconds: f64,
}

impl Report {
    /// A report in which nothing is measured yet.
    pub fn new(input: Option<String>) -> Self {
        Self {
            head: Head::new("crease-trade/1"),
            input,
            output: None,
            surfaces: None,
            mesh: None,
            advice: None,
            seconds: 0.0,
        }
    }
}
