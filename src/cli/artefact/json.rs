//! The report of `crease artefact` as JSON. Members are described in `docs/json.md`.

use crate::cli::common::choice::Choose;
use crate::cli::common::report::Head;
use crease::artefact::{Experiment, Formula, Outcome, ParameterName, ParameterValues, Setup, Text};
use crease::normals::Weight;
use crease::raster::Interpolation;
use serde::Serialize;
use std::collections::BTreeMap;

#[derive(Debug, Serialize)]
pub struct Report<'a> {
    #[serde(flatten)]
    pub head: Head,
    experiment: &'static str,
    title: Text,
    claim: Text,
    sources: Vec<Text>,
    formulas: Vec<Formula>,
    takes: &'static [ParameterName],
    ranges: BTreeMap<&'static str, Range>,
    #[serde(skip_serializing_if = "Option::is_none")]
    own_mesh: Option<Text>,
    #[serde(skip_serializing_if = "Option::is_none")]
    mesh: Option<&'a str>,
    #[serde(skip_serializing_if = "Option::is_none")]
    finer: Option<&'a str>,
    parameters: ParameterValues<'a>,
    #[serde(flatten)]
    pub result: Option<RunReport<'a>>,
}

/// The result of an experiment.
#[derive(Debug, Serialize)]
pub struct RunReport<'a> {
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub unheeded: Vec<&'static str>,
    pub outcome: &'a Outcome,
    pub command: String,
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub files: Vec<String>,
    pub seconds: f64,
}

/// What may be given for a parameter.
#[derive(Debug, Serialize)]
#[serde(untagged)]
enum Range {
    Numbers([f64; 2]),
    Names(Vec<&'static str>),
}

impl Range {
    fn of(experiment: &Experiment, name: ParameterName) -> Option<Self> {
        fn names<T: Choose>() -> Option<Range> {
            Some(Range::Names(T::CHOICES.iter().map(|choice| choice.0).collect()))
        }
        match name {
            ParameterName::Weight => names::<Weight>(),
            ParameterName::Interpolation => names::<Interpolation>(),
            _ => experiment.range(name).map(|range| Range::Numbers([*range.start(), *range.end()])),
        }
    }
}

impl<'a> Report<'a> {
    pub fn new(experiment: &'static Experiment, setup: &'a Setup<'a>) -> Self {
        let ranges =
            experiment.takes.iter().filter_map(|&name| Some((name.name(), Range::of(experiment, name)?)));
        Self {
            head: Head::new("crease-artefact/2"),
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
            result: None,
        }
    }
}
