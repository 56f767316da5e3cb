//! Runs `crease stress`: the catalogue of numerical extremes.

use super::args::StressArgs;
use super::report::{Report, breach, list, table};
use crate::cli::common::console::{Console, Verbosity};
use crate::cli::common::failure::{Exit, exit_code};
use crate::cli::common::options::Color;
use crate::cli::common::progress::Progress;
use crease::trade::stress::{Group, StressCase, StressResult, cases_of};
use rayon::prelude::*;
use std::time::Instant;

pub fn main(args: &StressArgs, color: Color) -> Exit {
    let console = Console::new(&args.run, color, None);
    args.run.use_threads();
    let is_wanted = |group: &Group| args.only.is_empty() || args.only.contains(group);
    let cases: Vec<StressCase> = Group::ALL.into_iter().filter(is_wanted).flat_map(cases_of).collect();
    if args.list {
        console.report(&list(&cases, console.report_style));
        return exit_code(Ok(Exit::Done), &console);
    }
    let start = Instant::now();
    let progress = Progress::of_count(&console, "running", "cases", cases.len() as u64);
    let done = |_: &StressResult| progress.done();
    let results: Vec<StressResult> = cases.par_iter().map(StressCase::run).inspect(done).collect();
    drop(progress);
    let seconds = start.elapsed().as_secs_f64();
    let verbose = console.verbosity > Verbosity::Normal;
    console
        .print(&Report::new(&results, seconds), || table(&results, seconds, verbose, console.report_style));
    for result in results.iter().filter(|result| !result.holds()) {
        console.error(&breach(result));
    }
    exit_code(Ok(verdict(&results)), &console)
}

fn verdict(results: &[StressResult]) -> Exit {
    if results.iter().all(StressResult::holds) { Exit::Done } else { Exit::Findings }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::cli::common::console::Style;
    use crease::trade::stress::Measured;

    /// No expectation of the catalogue breaks, so one is made to.
    #[test]
    fn an_expectation_that_breaks_is_reported_and_ends_with_1() {
        let cases = cases_of(Group::Product);
        let mut results: Vec<StressResult> = cases.iter().map(StressCase::run).collect();
        assert_eq!(verdict(&results), Exit::Done);
        assert!(table(&results, 0.0, true, Style::PLAIN).contains("3 cases: all expectations hold."));
        let mut measured: Measured = results[1].measured;
        (measured.faithful.error, measured.faithful.nan) = (0.5, 3);
        results[1] =
            StressResult { case: results[1].case, measured, faithful_holds: false, fast_holds: true };
        assert_eq!(verdict(&results), Exit::Findings);
        let text = table(&results, 0.0, false, Style::PLAIN);
        assert!(text.contains("BREAKS") && text.contains("3 cases: 1 do not hold."), "{text}");
        let reported = breach(&results[1]);
        assert!(
            reported.starts_with("product: nearly equal products: faithful is off by 0.5 rel, NaN x3"),
            "{reported}"
        );
        assert!(
            serde_json::to_string(&Report::new(&results, 0.0)).unwrap().contains("\"status\":\"broken\"")
        );
    }
}
