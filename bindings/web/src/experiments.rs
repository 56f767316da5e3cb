//! The experiments: their list, and the outcome of a run as texts, numbers, plots and pictures.

use crate::laboratory::{Result, value};
use crate::pictures::rgba;
use crease::artefact::{
    EXPERIMENTS, Experiment, Language, Outcome, ParameterName, Parameters, Range, Setup, Shot, Verdict,
    experiment,
};
use crease::normals::Weight;
use crease::num::Degrees;
use crease::raster::Interpolation;
use crease::report::{chart_plot, mathml, measure_table, running, verdict_text};
use serde::Deserialize;
use serde_json::{Value, json};

/// A run of an experiment. Parameters that it does not take are ignored.
#[derive(Clone, Debug, Default, Deserialize)]
#[serde(default)]
pub(crate) struct Run {
    id: String,
    language: String,
    size: Option<u32>,
    segments: Option<u32>,
    light: Option<f64>,
    turn: Option<f64>,
    intensity: Option<f64>,
    exponent: Option<f64>,
    crease: Option<f64>,
    weight: Option<Weight>,
    interpolation: Option<Interpolation>,
    /// Only numbers: no pictures, no plots.
    brief: bool,
}

fn language(tag: &str) -> Language {
    Language::ALL.into_iter().find(|language| language.tag() == tag).unwrap_or_default()
}

pub(crate) fn list(tag: &str) -> Value {
    let language = language(tag);
    json!(EXPERIMENTS.iter().map(|experiment| about(experiment, language)).collect::<Vec<_>>())
}

fn about(experiment: &Experiment, language: Language) -> Value {
    let setup = Setup { parameters: experiment.defaults, mesh: None };
    let formula = |formula: crease::artefact::Formula| {
        json!({
            "math": mathml(formula.notation.get(language)),
            "says": running(formula.says.get(language)),
        })
    };
    let parameter = |&name: &ParameterName| {
        let default = experiment.defaults.value(name)?;
        let range = experiment.range(name).map(|range| [*range.start(), *range.end()]);
        Some(json!({ "name": name.name(), "default": default, "range": range }))
    };
    json!({
        "id": experiment.id,
        "title": experiment.title().get(language),
        "claim": running(experiment.claim().get(language)),
        "sources": experiment.sources().iter().map(|text| running(text.get(language))).collect::<Vec<_>>(),
        "formulas": experiment.closed_forms(&setup).into_iter().map(formula).collect::<Vec<_>>(),
        "parameters": experiment.takes.iter().filter_map(parameter).collect::<Vec<_>>(),
    })
}

impl Run {
    fn parameters(&self, defaults: Parameters) -> Parameters {
        Parameters {
            size: self.size.unwrap_or(defaults.size),
            segments: self.segments.unwrap_or(defaults.segments),
            light: self.light.map_or(defaults.light, Degrees),
            turn: self.turn.map_or(defaults.turn, Degrees),
            intensity: self.intensity.unwrap_or(defaults.intensity),
            exponent: self.exponent.unwrap_or(defaults.exponent),
            crease: self.crease.map_or(defaults.crease, Degrees),
            weight: self.weight.unwrap_or(defaults.weight),
            interpolation: self.interpolation.unwrap_or(defaults.interpolation),
        }
    }

    /// Runs the experiment. Every picture is a buffer.
    pub(crate) fn outcome(&self) -> Result {
        let experiment = experiment(&self.id).map_err(|error| error.to_string())?;
        let setup = Setup { parameters: self.parameters(experiment.defaults), mesh: None };
        let outcome = experiment.run(&setup).map_err(|error| error.to_string())?;
        let language = language(&self.language);
        let mut answer = json!({
            "verdict": verdict(&outcome),
            "effect": value(&outcome.effect)?,
            "measures": measures(&outcome, language),
        });
        if self.brief {
            return Ok((answer, Vec::new()));
        }
        let [name, condition] = verdict_text(&outcome, language);
        let table = measure_table(&outcome, language);
        let cells = table.rows.iter().map(|row| row.iter().map(|cell| running(cell)).collect::<Vec<_>>());
        let mut buffers = Vec::new();
        let series = outcome.series().map(|shots| {
            let difference = Shot::difference(shots);
            let shot = |shot: &Shot| {
                buffers.push(rgba(&shot.image));
                json!({
                    "name": shot.name,
                    "role": shot.role,
                    "label": running(shot.label.get(language)),
                    "caption": shot.caption.get(language),
                    "size": shot.image.size,
                })
            };
            shots.iter().chain(&difference).map(shot).collect::<Vec<_>>()
        });
        let series: Vec<_> = series.collect();
        let charts = outcome.charts.iter().map(|chart| {
            let caption = running(chart.caption.get(language));
            json!({ "svg": chart_plot(chart, language).svg(chart.name), "caption": caption })
        });
        let more = json!({
            "verdict_name": name,
            "condition": running(&condition),
            "table": { "headings": table.columns, "rows": cells.collect::<Vec<_>>() },
            "series": series,
            "charts": charts.collect::<Vec<_>>(),
            "notes": outcome.notes.iter().map(|note| running(note.get(language))).collect::<Vec<_>>(),
            "command": experiment.command(&setup, language),
        });
        if let (Some(all), Value::Object(more)) = (answer.as_object_mut(), more) {
            all.extend(more);
        }
        Ok((answer, buffers))
    }
}

fn verdict(outcome: &Outcome) -> &'static str {
    match outcome.verdict {
        Verdict::Holds(_) => "holds",
        Verdict::HoldsOnlyIf(_) => "holds-only-if",
        Verdict::Fails(_) => "fails",
        Verdict::Absent(_) => "absent",
    }
}

/// The measures that have a closed form or a bound, for the plot along a parameter.
fn measures(outcome: &Outcome, language: Language) -> Vec<Value> {
    let measure = |measure: &crease::artefact::Measure| {
        let range = measure.expected.as_ref().map(|expected| match expected.range {
            Range::Near { value, tolerance } => [value - tolerance, value, value + tolerance],
            Range::AtMost { at_most } => [0.0, at_most, at_most],
        });
        json!({
            "name": measure.name.get(language),
            "unit": measure.unit,
            "value": measure.value,
            "expected": range,
            "agrees": measure.agrees,
        })
    };
    outcome.measures.iter().map(measure).collect()
}
