//! What `crease artefact --json` tells.
//!
//! # The JSON schema, `crease-artefact/2`
//! One object on one line for each experiment.
//!
//! | member | meaning |
//! |---|---|
//! | `schema`, `crease` | `"crease-artefact/2"`; the program's version |
//! | `status`, `error` | as in `crease-normals/1`; `status` is `findings` if a number is not what it should be, and `left-out` if `all` leaves it out for a value that it does not take |
//! | `experiment`, `title` | its id and title |
//! | `claim`, `sources`, `formulas` | what is claimed, by whom, and the closed forms, of its own shapes: none with a mesh of one's own |
//! | `takes` | the parameters that it takes |
//! | `ranges` | of each of these the least and the most, or the names there are |
//! | `own_mesh` | what a mesh of one's own is looked at for, if it takes one |
//! | `mesh`, `finer` | the meshes that were given, if any |
//! | `parameters` | their values |
//! | `unheeded` | of `all`, the options that were given and change nothing of this one, if there are any |
//! | `outcome` | [`Outcome`](crease::artefact::Outcome): `verdict`, `moved`, `measures`, `shots`, `charts`, `notes` |
//! | `command` | the command that does it again |
//! | `files` | what was written |
//! | `seconds` | how long it took |
//!
//! A measure has `name`, `unit` and `value`; where something is known about it `expected`, which has `value` and `tolerance` or, of
//! a bound, `at_most`, and `by`; with it `agrees`; where nothing is known with these parameters `beyond`, which says why.
//!
//! A shot has `name`, `role` (`bad`, `cured`, `attempt`: a cure that does too little, `absent`: no artefact is measured,
//! `difference`, `truth`), `label`, `caption` and `size`; all but the last two roles have `measured`, which the role follows from:
//! `name`, `unit`, `value`, and `present`, the value from which on the artefact is seen.
//!
//! Texts are objects with `en` and `pt`. Nothing but `seconds` differs from run to run. `list` has the members up to `own_mesh`,
//! and `parameters` as they are by default.

use super::super::report::ErrorReport;
use crate::cli::render::INTERPOLATIONS;
use crease::artefact::{Experiment, Formula, Outcome, ParameterName, ParameterValues, Setup, Text};
use crease::normals::Weight;
use serde::Serialize;
use std::collections::BTreeMap;

#[derive(Debug, Serialize)]
pub struct Report<'a> {
    pub schema: &'static str,
    pub crease: &'static str,
    pub status: &'static str,
    #[serde(skip_serializing_if = "Option::is_none")]
    pub error: Option<ErrorReport>,
    pub experiment: &'static str,
    pub title: Text,
    pub claim: Text,
    pub sources: Vec<Text>,
    pub formulas: Vec<Formula>,
    pub takes: &'static [ParameterName],
    pub ranges: BTreeMap<&'static str, Range>,
    #[serde(skip_serializing_if = "Option::is_none")]
    pub own_mesh: Option<Text>,
    #[serde(skip_serializing_if = "Option::is_none")]
    pub mesh: Option<&'a str>,
    #[serde(skip_serializing_if = "Option::is_none")]
    pub finer: Option<&'a str>,
    pub parameters: ParameterValues<'a>,
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub unheeded: Vec<&'static str>,
    #[serde(skip_serializing_if = "Option::is_none")]
    pub outcome: Option<&'a Outcome>,
    #[serde(skip_serializing_if = "Option::is_none")]
    pub command: Option<String>,
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub files: Vec<String>,
    #[serde(skip_serializing_if = "Option::is_none")]
    pub seconds: Option<f64>,
}

/// What may be given for a parameter.
#[derive(Debug, Serialize)]
#[serde(untagged)]
pub enum Range {
    Numbers([f64; 2]),
    Names(Vec<&'static str>),
}

impl Range {
    fn of(experiment: &Experiment, knob: ParameterName) -> Option<Self> {
        match knob {
            ParameterName::Weight => Some(Range::Names(Weight::ALL.map(Weight::name).to_vec())),
            ParameterName::Interpolation => {
                Some(Range::Names(INTERPOLATIONS.iter().map(|choice| choice.0).collect()))
            }
            _ => experiment.range(knob).map(|range| Range::Numbers([*range.start(), *range.end()])),
        }
    }
}

impl<'a> Report<'a> {
    pub fn new(experiment: &'static Experiment, setup: &'a Setup<'a>) -> Self {
        let ranges =
            experiment.takes.iter().filter_map(|&knob| Some((knob.name(), Range::of(experiment, knob)?)));
        Self {
            schema: "crease-artefact/2",
            crease: env!("CARGO_PKG_VERSION"),
            status: "ok",
            error: None,
            experiment: experiment.id,
            title: experiment.title(),
            claim: experiment.claim(),
            sources: experiment.sources(),
            formulas: experiment.closed_forms(setup),
            takes: experiment.takes,
            ranges: ranges.collect(),
            own_mesh: experiment.own_mesh(),
            mesh: setup.mesh.map(|own| own.name),
            finer: setup.mesh.and_then(|own| own.finer).map(|(name, _)| name),
            parameters: ParameterValues { names: experiment.takes, parameters: &setup.parameters },
            unheeded: Vec::new(),
            outcome: None,
            command: None,
            files: Vec::new(),
            seconds: None,
        }
    }
}
