//! What `crease stress` tells programs.
//!
//! # The JSON schema, `crease-stress/1`
//! One object on one line.
//!
//! | member | meaning |
//! |---|---|
//! | `schema`, `crease` | `"crease-stress/1"`; the program's version |
//! | `status` | `"ok"`, or `"broken"` if an expectation does not hold |
//! | `cases` | one object a case, as below |
//! | `summary` | `cases`, `broken` (how many do not hold), `plain_fails` (in how many plain `f32` code fails visibly) |
//! | `seconds` | how long it took |
//!
//! Members of a case:
//!
//! | member | meaning |
//! |---|---|
//! | `group`, `name` | together they name the case |
//! | `what`, `expectation` | in words |
//! | `samples` | how many results were looked at |
//! | `faithful` | an error, as below, with `bound` |
//! | `without_fast` | where there is no `fast` beside it: why |
//! | `fast` | absent where it does not concern `fast`; an error with `bound` and `declined`, the samples left to `faithful` |
//! | `plain` | absent where there is no plain formula; an error with `formula` and `fails`, whether it can be seen |
//! | `holds` | whether the expectation holds |
//!
//! An error has `worst` (the largest of the results that are numbers; `null` if it is infinite), `undefined` (how many
//! results are no numbers or no directions) and `unit`: `ulps` of `f32`, `degrees`, `relative`, `absolute`, or `wrong`
//! (answers). A `bound` has `most`, in the same unit, and its `source`.

use crease::trade::stress::{Bound, StressResult, Unit, Worst};
use serde::Serialize;

#[derive(Debug, Serialize)]
pub struct Report<'a> {
    schema: &'static str,
    crease: &'static str,
    status: &'static str,
    cases: Vec<CaseReport<'a>>,
    summary: Summary,
    seconds: f64,
}

#[derive(Debug, Serialize)]
struct CaseReport<'a> {
    group: &'static str,
    name: &'a str,
    what: String,
    expectation: String,
    samples: usize,
    faithful: ErrorReport,
    #[serde(skip_serializing_if = "Option::is_none")]
    fast: Option<ErrorReport>,
    #[serde(skip_serializing_if = "Option::is_none")]
    without_fast: Option<&'static str>,
    #[serde(skip_serializing_if = "Option::is_none")]
    plain: Option<ErrorReport>,
    holds: bool,
}

#[derive(Debug, Serialize)]
struct ErrorReport {
    worst: Option<f64>,
    undefined: usize,
    unit: &'static str,
    #[serde(skip_serializing_if = "Option::is_none")]
    bound: Option<BoundReport>,
    #[serde(skip_serializing_if = "Option::is_none")]
    declined: Option<usize>,
    #[serde(skip_serializing_if = "Option::is_none")]
    formula: Option<String>,
    #[serde(skip_serializing_if = "Option::is_none")]
    fails: Option<bool>,
}

#[derive(Debug, Serialize)]
struct BoundReport {
    most: f64,
    source: String,
}

/// Counts over cases.
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
        Self {
            schema: "crease-stress/1",
            crease: env!("CARGO_PKG_VERSION"),
            status: if summary.broken == 0 { "ok" } else { "broken" },
            cases: results.iter().map(CaseReport::new).collect(),
            summary,
            seconds,
        }
    }
}

impl<'a> CaseReport<'a> {
    fn new(result: &StressResult<'a>) -> Self {
        let (case, measured) = (result.case, result.measured);
        let fast = measured.fast.zip(case.fast_bound).map(|(worst, bound)| ErrorReport {
            declined: Some(measured.declined),
            ..ErrorReport::bounded(worst, bound)
        });
        let plain = measured.plain.map(|worst| ErrorReport {
            formula: Some(case.plain_formula()),
            fails: Some(result.plain_fails()),
            ..ErrorReport::new(worst, case.plain_unit)
        });
        Self {
            group: case.group.name(),
            name: &case.name,
            what: case.what(),
            expectation: case.expectation(),
            samples: measured.samples,
            faithful: ErrorReport::bounded(measured.faithful, case.bound),
            without_fast: fast.is_none().then(|| case.group.without_fast()),
            fast,
            plain,
            holds: result.holds(),
        }
    }
}

impl ErrorReport {
    fn new(worst: Worst, unit: Unit) -> Self {
        Self {
            worst: worst.error.is_finite().then_some(worst.error),
            undefined: worst.undefined,
            unit: unit.name(),
            bound: None,
            declined: None,
            formula: None,
            fails: None,
        }
    }

    fn bounded(worst: Worst, bound: Bound) -> Self {
        let report = BoundReport { most: bound.most, source: bound.source() };
        Self { bound: Some(report), ..Self::new(worst, bound.unit) }
    }
}
