//! The verb `stress`: the catalogue of numerical extremes, run and told about.

mod args;
mod report;
mod table;

pub use args::StressArgs;

use super::args::Color;
use super::console::{Console, Verbosity};
use super::progress::CountProgress;
use super::report::json_line;
use super::{Exit, use_threads};
use crease::trade::stress::{Group, StressCase, StressResult, cases_of};
use rayon::prelude::*;
use report::Report;
use std::time::Instant;

/// Carries the verb out.
pub fn main(args: &StressArgs, color: Color) -> Exit {
    let console = Console::new(&args.run, color, None);
    use_threads(args.run.threads);
    let is_wanted = |group: &Group| args.only.is_empty() || args.only.contains(group);
    let cases: Vec<StressCase> = Group::ALL.into_iter().filter(is_wanted).flat_map(cases_of).collect();
    if args.list {
        console.report(&table::list(&cases, console.report_style()));
        return exit(&console, Exit::Done);
    }
    let start = Instant::now();
    let progress = CountProgress::new(&console, "running", "cases", cases.len() as u64);
    let done = |_: &StressResult| progress.done();
    let results: Vec<StressResult> = cases.par_iter().map(StressCase::run).inspect(done).collect();
    drop(progress);
    let seconds = start.elapsed().as_secs_f64();
    if console.json {
        console.report(&json_line(&Report::new(&results, seconds)));
    } else if console.verbosity > Verbosity::Quiet {
        let verbose = console.verbosity > Verbosity::Normal;
        console.report(&table::table(&results, seconds, verbose, console.report_style()));
    }
    for result in results.iter().filter(|result| !result.holds()) {
        console.error(&table::breach(result));
    }
    exit(&console, verdict(&results))
}

fn verdict(results: &[StressResult]) -> Exit {
    if results.iter().all(StressResult::holds) { Exit::Done } else { Exit::Findings }
}

/// A report that was lost matters more than what it said.
fn exit(console: &Console, exit: Exit) -> Exit {
    if console.has_reported() { exit } else { Exit::OutputFailed }
}

#[cfg(test)]
mod tests {
    use super::super::console::Style;
    use super::*;
    use crease::trade::stress::{Measured, Worst};

    /// No expectation of the catalogue breaks, so one is made to.
    #[test]
    fn an_expectation_that_breaks_is_reported_and_ends_with_1() {
        let cases = cases_of(Group::Product);
        let mut results: Vec<StressResult> = cases.iter().map(StressCase::run).collect();
        assert_eq!(verdict(&results), Exit::Done);
        assert!(table::table(&results, 0.0, true, Style::PLAIN).contains("3 cases: all expectations hold."));
        let measured = Measured { faithful: Worst { error: 0.5, undefined: 3 }, ..results[1].measured };
        results[1] =
            StressResult { case: results[1].case, measured, faithful_holds: false, fast_holds: true };
        assert_eq!(verdict(&results), Exit::Findings);
        let text = table::table(&results, 0.0, false, Style::PLAIN);
        assert!(text.contains("BREAKS") && text.contains("3 cases: 1 do not hold."), "{text}");
        let reported = table::breach(&results[1]);
        assert!(
            reported.starts_with("product: nearly equal products: faithful is off by 0.5 rel, NaN x3"),
            "{reported}"
        );
        assert!(json_line(&Report::new(&results, 0.0)).contains("\"status\":\"broken\""));
    }
}
