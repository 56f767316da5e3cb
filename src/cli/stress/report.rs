//! The report of `crease stress` as JSON and as text. Members are described in `docs/json.md`.

use crate::cli::common::console::Style;
use crate::cli::common::numbers::count;
use crate::cli::common::report::Head;
use crease::trade::stress::{Bound, Cause, Group, StressCase, StressResult, Unit, Worst};
use serde::Serialize;
use std::fmt::Write as _;

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

#[derive(Debug, Default, Serialize)]
struct Error {
    /// JSON has `null` for infinity.
    worst: f64,
    undefined: usize,
    nan: usize,
    infinite: usize,
    zero: usize,
    unit: &'static str,
    #[serde(skip_serializing_if = "Option::is_none")]
    bound: Option<Bound>,
    #[serde(skip_serializing_if = "Option::is_none")]
    declined: Option<usize>,
    #[serde(skip_serializing_if = "Option::is_none")]
    formula: Option<String>,
    #[serde(skip_serializing_if = "Option::is_none")]
    fails: Option<bool>,
    #[serde(skip_serializing_if = "Option::is_none")]
    cause: Option<&'static str>,
    #[serde(skip_serializing_if = "Option::is_none")]
    definition: Option<Box<Error>>,
}

#[derive(Clone, Copy, Debug, Serialize)]
pub struct Summary {
    pub cases: usize,
    pub broken: usize,
    pub plain_fails: usize,
    pub plain_fails_by_rounding: usize,
    pub plain_fails_by_definition: usize,
}

impl Summary {
    pub fn new(results: &[StressResult]) -> Self {
        let count = |of: &dyn Fn(&StressResult) -> bool| results.iter().filter(|result| of(result)).count();
        let [by_rounding, by_definition] = [Cause::Rounding, Cause::Definition]
            .map(|cause| count(&|result| result.plain_failure() == Some(cause)));
        Self {
            cases: results.len(),
            broken: count(&|result| !result.holds()),
            plain_fails: by_rounding + by_definition,
            plain_fails_by_rounding: by_rounding,
            plain_fails_by_definition: by_definition,
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
            fails: Some(result.plain_failure().is_some()),
            cause: result.plain_failure().map(Cause::name),
            definition: Some(Box::new(Error::new(measured.definition, case.plain_unit))),
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
    fn new(worst: Worst, unit: Unit) -> Self {
        let Worst { error, nan, infinite, zero } = worst;
        let (undefined, unit) = (worst.undefined(), unit.name());
        Self { worst: error, undefined, nan, infinite, zero, unit, ..Self::default() }
    }

    fn bounded(worst: Worst, bound: Bound) -> Self {
        Self { bound: Some(bound), ..Self::new(worst, bound.unit) }
    }
}

/// Marks plain code that fails so that it can be seen.
const CROSS: char = '✗';
/// Plain code has two columns: its error is in that of its cause.
const HEADINGS: [&str; 7] =
    ["case", "allowed", "faithful", "fast", "f32: overflow or rounding", "f32: definition", ""];

type Row = [String; 7];

pub fn table(results: &[StressResult], seconds: f64, verbose: bool, style: Style) -> String {
    let rows: Vec<Row> = results.iter().map(row).collect();
    let widths: [usize; 7] = std::array::from_fn(|column| {
        let cells = rows.iter().map(|row| row[column].chars().count());
        cells.chain([HEADINGS[column].len()]).max().unwrap_or(0)
    });
    let mut out = String::new();
    let mut before: (Option<Group>, String) = (None, String::new());
    for (result, row) in results.iter().zip(&rows) {
        let case = result.case;
        if before.0 != Some(case.group) {
            let blank = if out.is_empty() { "" } else { "\n" };
            let name = style.paint(Style::BOLD, case.group.name());
            let _ = writeln!(out, "{blank}{name}: {}", case.group.about());
            line(&mut out, &HEADINGS.map(str::to_owned), &widths, result, style);
        }
        let expectation = (Some(case.group), case.expectation());
        if before != expectation {
            let _ = writeln!(out, "  expected: {}", expectation.1);
        }
        line(&mut out, row, &widths, result, style);
        if verbose {
            detail(&mut out, result);
        }
        before = expectation;
    }
    let summary = Summary::new(results);
    let verdict = match summary.broken {
        0 => "all expectations hold".to_owned(),
        broken => style.paint(Style::RED, &format!("{broken} do not hold")),
    };
    let _ = writeln!(
        out,
        "\n{}: {verdict}. Plain f32 code fails visibly ({CROSS}) in {} by overflow or rounding, in {} by definition. \
         {seconds:.1} s",
        count(summary.cases, "case"),
        summary.plain_fails_by_rounding,
        summary.plain_fails_by_definition
    );
    out
}

fn line(out: &mut String, row: &Row, widths: &[usize; 7], result: &StressResult, style: Style) {
    let mut text = String::from("  ");
    for (cell, width) in row.iter().zip(widths) {
        let _ = write!(text, "{cell:width$}  ");
    }
    let text = text.trim_end();
    let text = if result.holds() { text.to_owned() } else { style.paint(Style::RED, text) };
    let _ = writeln!(out, "{text}");
}

fn row(result: &StressResult) -> Row {
    let (case, measured) = (result.case, result.measured);
    let fast = match (measured.fast, case.fast_bound) {
        (Some(_), Some(_)) if measured.declined == measured.samples => "declined".to_owned(),
        (Some(worst), Some(bound)) if measured.declined > 0 => {
            format!("{}, {} declined", error(worst, bound.unit), measured.declined)
        }
        (Some(worst), Some(bound)) => error(worst, bound.unit),
        _ => "none".to_owned(),
    };
    let plain = measured.plain.map_or("–".to_owned(), |worst| error(worst, case.plain_unit));
    let [rounding, definition] = match result.plain_failure() {
        None => [plain, String::new()],
        Some(Cause::Rounding) => [format!("{plain} {CROSS}"), String::new()],
        Some(Cause::Definition) => [String::new(), format!("{plain} {CROSS}")],
    };
    [
        case.name.clone(),
        allowed(case.bound),
        error(measured.faithful, case.bound.unit),
        fast,
        rounding,
        definition,
        if result.holds() { "holds" } else { "BREAKS" }.to_owned(),
    ]
}

fn detail(out: &mut String, result: &StressResult) {
    let case = result.case;
    let _ = writeln!(out, "      {} ({})", case.what(), count(result.measured.samples, "result"));
    let _ = writeln!(out, "      bound: {}", case.bound.source());
    if let Some(bound) = case.fast_bound {
        let _ = writeln!(out, "      fast: {}; {}", allowed(bound), bound.source());
    } else {
        let _ = writeln!(out, "      fast: none: {}", case.group.without_fast());
    }
    if result.measured.plain.is_some() {
        let definition = error(result.measured.definition, case.plain_unit);
        let _ = writeln!(out, "      plain: {}; in exact arithmetic: {definition}", case.plain_formula());
    }
}

/// What a bound allows. Half a turn is everything that there is.
fn allowed(bound: Bound) -> String {
    if bound.unit == Unit::Degrees && bound.most >= 180.0 {
        return "no promise".to_owned();
    }
    amount(bound.most, bound.unit)
}

/// The worst of many, and how many have no error.
fn error(worst: Worst, unit: Unit) -> String {
    let number = (worst.error > 0.0 || worst.undefined() == 0).then(|| amount(worst.error, unit));
    let kinds = [("NaN", worst.nan), ("inf", worst.infinite), ("zero", worst.zero)];
    let kinds = kinds.into_iter().filter(|(_, count)| *count > 0);
    let counts = kinds.map(|(kind, count)| format!("{kind} x{count}"));
    number.into_iter().chain(counts).collect::<Vec<_>>().join(", ")
}

fn amount(x: f64, unit: Unit) -> String {
    let number = match x {
        0.0 => "0".to_owned(),
        x if !x.is_finite() => "inf".to_owned(),
        x if unit == Unit::Wrong => format!("{x}"),
        x if (1e-2..1e4).contains(&x) => {
            format!("{x:.3}").trim_end_matches('0').trim_end_matches('.').to_owned()
        }
        x => format!("{x:.1e}"),
    };
    match unit {
        Unit::Ulps => number + " ulp",
        Unit::Degrees => number + "°",
        Unit::Relative => number + " rel",
        Unit::Absolute => number,
        Unit::Wrong => number + " wrong",
    }
}

pub fn list(cases: &[StressCase], style: Style) -> String {
    let mut out = String::new();
    let width = cases.iter().map(|case| case.name.chars().count()).max().unwrap_or(0);
    let mut group = None;
    for case in cases {
        if group.replace(case.group) != Some(case.group) {
            let name = style.paint(Style::BOLD, case.group.name());
            let _ = writeln!(out, "{name}: {}", case.group.about());
        }
        let _ = writeln!(out, "  {:width$}  {}", case.name, case.what());
    }
    out
}

pub fn breach(result: &StressResult) -> String {
    let (case, measured) = (result.case, result.measured);
    let (way, worst, bound) = match (measured.fast, case.fast_bound) {
        (Some(fast), Some(bound)) if result.faithful_holds => ("fast", fast, bound),
        _ => ("faithful", measured.faithful, case.bound),
    };
    format!(
        "{case:?}: {way} is off by {} (allowed: {}; {})",
        error(worst, bound.unit),
        amount(bound.most, bound.unit),
        bound.source()
    )
}
