//! What `crease artefact --json` tells.
//!
//! # The JSON schema, `crease-artefact/1`
//! One object on one line for each experiment.
//!
//! | member | meaning |
//! |---|---|
//! | `schema`, `crease` | `"crease-artefact/1"`; the program's version |
//! | `status`, `error` | as in `crease-normals/1`; `status` is `findings` if a number is not what it should be |
//! | `experiment`, `title` | its id and title |
//! | `claim`, `sources`, `formulas` | what is claimed, by whom, and the closed forms |
//! | `takes` | the parameters that it takes |
//! | `own_mesh` | what a mesh of one's own is looked at for, if it takes one |
//! | `mesh`, `finer` | the meshes that were given, if any |
//! | `parameters` | their values |
//! | `outcome` | [`Outcome`](crease::artefact::Outcome): `verdict`, `moved`, `measures`, `shots`, `charts`, `notes` |
//! | `command` | the command that does it again |
//! | `files` | what was written |
//! | `seconds` | how long it took |
//!
//! Texts are objects with `en` and `pt`. Nothing but `seconds` differs from run to run. `list` has the members up to `own_mesh`,
//! and `parameters` as they are by default.

use super::super::report::ErrorReport;
use crease::artefact::{Experiment, Knob, Outcome, Setup, Taken, Text};
use serde::Serialize;

#[derive(Debug, Serialize)]
pub struct Report<'a> {
    pub schema: &'static str,
    pub crease: &'static str,
    pub status: &'static str,
    #[serde(skip_serializing_if = "Option::is_none")]
    pub error: Option<ErrorReport>,
    pub experiment: &'static str,
    pub title: &'static Text,
    pub claim: &'static Text,
    pub sources: &'static [Text],
    pub formulas: Vec<FormulaReport>,
    pub takes: &'static [Knob],
    #[serde(skip_serializing_if = "Option::is_none")]
    pub own_mesh: Option<&'static Text>,
    #[serde(skip_serializing_if = "Option::is_none")]
    pub mesh: Option<&'a str>,
    #[serde(skip_serializing_if = "Option::is_none")]
    pub finer: Option<&'a str>,
    pub parameters: Taken<'a>,
    #[serde(skip_serializing_if = "Option::is_none")]
    pub outcome: Option<&'a Outcome>,
    #[serde(skip_serializing_if = "Option::is_none")]
    pub command: Option<String>,
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub files: Vec<String>,
    #[serde(skip_serializing_if = "Option::is_none")]
    pub seconds: Option<f64>,
}

#[derive(Debug, Serialize)]
pub struct FormulaReport {
    notation: &'static Text,
    says: &'static Text,
}

impl<'a> Report<'a> {
    pub fn new(experiment: &'static Experiment, setup: &'a Setup<'a>) -> Self {
        let formulas = experiment.formulas.iter();
        let formulas =
            formulas.map(|formula| FormulaReport { notation: &formula.notation, says: &formula.says });
        Self {
            schema: "crease-artefact/1",
            crease: env!("CARGO_PKG_VERSION"),
            status: "ok",
            error: None,
            experiment: experiment.id,
            title: &experiment.title,
            claim: &experiment.claim,
            sources: experiment.sources,
            formulas: formulas.collect(),
            takes: experiment.takes,
            own_mesh: experiment.own_mesh.as_ref(),
            mesh: setup.mesh.map(|own| own.name),
            finer: setup.mesh.and_then(|own| own.finer).map(|(name, _)| name),
            parameters: Taken { knobs: experiment.takes, parameters: &setup.parameters },
            outcome: None,
            command: None,
            files: Vec::new(),
            seconds: None,
        }
    }
}
