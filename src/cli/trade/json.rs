//! The report of `crease trade` as JSON. Members are described in `docs/json.md`.

use crate::cli::common::report::Head;
use crease::trade::{OwnMesh, Trade};
use serde::Serialize;

#[derive(Debug, Default, Serialize)]
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
    pub fn new(input: Option<String>) -> Self {
        Self { head: Head::new("crease-trade/1"), input, ..Self::default() }
    }
}
