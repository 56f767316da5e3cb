//! The report of `crease stress` as JSON. Members are described in `docs/json.md`.

use crate::cli::common::report::Head;
use crease::trade::stress::{Bound, StressResult, Unit, Worst};
use serde::Serialize;

#[derive(Debug, Serialize)]
pub struct Report<'a> {
    #[serde(flatten)]
    head: Head,
    cases: Vec<Case<'a>>,
    summary: Summary,
    seconds: f64,
}

#[derive(Debug, Serialize)]
struct Case<'a> {
    group: &'static str,
    name: &'a str,
    what: String,
    expectation: String,
    samples: usize,
    faithful: Error,
    #[serde(skip_serializing_if = "Option::is_none")]
    fast: Option<Error>,
    #[serde(skip_serializing_if = "Option::is_none")]
    without_fast: Option<&'static str>,
    #[serde(skip_serializing_if = "Option::is_none")]
    plain: Option<Error>,
    holds: bool,
}

#[derive(Debug, Serialize)]
struct Error {
    /// JSON has `null` for infinity.
    worst: f64,
    undefined: usize,
    unit: &'static str,
    #[serde(skip_serializing_if = "Option::is_none")]
    bound: Option<Bound>,
    #[serde(skip_serializing_if = "Option::is_none")]
    declined: Option<usize>,
    #[serde(skip_serializing_if = "Option::is_none")]
    formula: Option<String>,
    #[serde(skip_serializing_if = "Option::is_none")]
    fails: Option<bool>,
}

#[derive(Clone, Copy, Debug, Serialize)]
pub struct Summary {
    pub cases: usize,
    pub broken: usize,
    pub plain_fails: usize,
}

impl Summary {
    pub fn new(results: &[StressResult]) -> Self {
        let count = |of: &dyn Fn(&StressResult) -> bool| results.iter().filter(|result| of(result)).count();
        Self {
            cases: results.len(),
            broken: count(&|result| !result.holds()),
            plain_fails: count(&|result| result.plain_fails()),
        }
    }
}

impl<'a> Report<'a> {
    pub fn new(results: &[StressResult<'a>], seconds: f64) -> Self {
        let summary = Summary::new(results);
        let mut head = Head::new("crease-stress/1");
        if summary.broken > 0 {
            head.status = "broken";
        }
        Self { head, cases: results.iter().map(Case::new).collect(), summary, seconds }
    }
}

impl<'a> Case<'a> {
    fn new(result: &StressResult<'a>) -> Self {
        let (case, measured) = (result.case, result.measured);
        let fast = measured.fast.zip(case.fast_bound).map(|(worst, bound)| Error {
            declined: Some(measured.declined),
            ..Error::bounded(worst, bound)
        });
        let plain = measured.plain.map(|worst| Error {
            formula: Some(case.plain_formula()),
            fails: Some(result.plain_fails()),
            ..Error::new(worst, case.plain_unit)
        });
        Self {
            group: case.group.name(),
            name: &case.name,
            what: case.what(),
            expectation: case.expectation(),
            samples: measured.samples,
            faithful: Error::bounded(measured.faithful, case.bound),
            without_fast: fast.is_none().then(|| case.group.without_fast()),
            fast,
            plain,
            holds: result.holds(),
        }
    }
}

impl Error {
    fn new(Worst { error, undefined }: Worst, unit: Unit) -> Self {
        let (bound, declined, formula, fails) = (None, None, None, None);
        Self { worst: error, undefined, unit: unit.name(), bound, declined, formula, fails }
    }

    fn bounded(worst: Worst, bound: Bound) -> Self {
        Self { bound: Some(bound), ..Self::new(worst, bound.unit) }
    }
}
