//! What every report begins with.

use super::ErrorReport;
use serde::Serialize;

/// Which schema, whose report, and how it went.
#[derive(Debug, Serialize)]
pub struct Head {
    pub schema: &'static str,
    /// The program's version.
    pub crease: &'static str,
    pub status: &'static str,
    #[serde(skip_serializing_if = "Option::is_none")]
    pub error: Option<ErrorReport>,
}

impl Head {
    /// Of a report in which nothing has failed yet.
    pub fn new(schema: &'static str) -> Self {
        Self { schema, crease: env!("CARGO_PKG_VERSION"), status: "ok", error: None }
    }

    /// Notes down what failed.
    pub fn fail(&mut self, error: ErrorReport) {
        self.status = "failed";
        self.error = Some(error);
    }
}
