//! Pictures of many scenes: those of a manifest.

use super::args::RenderArgs;
use super::report::{Report, line};
use super::request::Request;
use super::run::{print, run};
use super::values::FileKind;
use crate::cli::common::batch::BatchArgs;
use crate::cli::common::choice::Choose;
use crate::cli::common::console::{Console, Verbosity};
use crate::cli::common::failure::{Exit, Failure, guarded};
use crate::cli::common::input::{Input, Source};
use crate::cli::common::ledger::{Ledger, Outcome, Work, skipped};
use crate::cli::common::options::{Color, RunArgs};
use crate::cli::common::output::Target;
use crate::cli::common::output_conflicts::Files;
use crate::cli::common::report::SKIPPED;
use crate::cli::common::run_batch::{Recorded, Shared, run_batch};
use crate::cli::line_options::with_line;
use crate::cli::usage::refused;
use crease::io::{Format, ReadLog};
use std::path::PathBuf;
use std::time::Instant;

/// Draws all inputs of the manifest that options name.
pub fn main(args: &RenderArgs, color: Color) -> Exit {
    let console = &Console::new(&args.run, color, None);
    let failed = |failure| refused("render", &failure, console);
    let all = match options(args) {
        Ok(all) => all,
        Err(failure) => return failed(failure),
    };
    let prepared = jobs(&all).and_then(|it| Ok((it, Ledger::open(&args.batch, false, false)?)));
    let (jobs, ledger) = match prepared {
        Ok(prepared) => prepared,
        Err(failure) => return failed(failure),
    };
    args.run.use_threads();
    run_batch(console, &args.batch, &ledger, &jobs, source, one, |(_, request), report: Report, batch| {
        batch.count(&report.input.path, &report.head);
        if report.head.status == SKIPPED {
            console.print(&report, || skipped(&report.input.path));
        } else if report.head.error.is_none() && console.verbosity < Verbosity::Verbose {
            console.print(&report, || {
                console.notes(&report.input.path, &report.notes, true);
                line(&report, console.report_style)
            });
        } else {
            print(&report, request, console);
        }
    })
}

fn source<'a>((_, request): &'a Job<'_>) -> (&'a Source, Option<Format>) {
    (&request.source, request.format)
}

/// The inputs with their options.
fn options(args: &RenderArgs) -> Result<Vec<(Input, RenderArgs)>, Failure> {
    let own = |input: Input| {
        let own = if input.options.is_empty() { args.clone() } else { with_line("render", &input)? };
        let own = of_input(own, &input).map_err(|failure| input.refused(failure))?;
        Ok((input, own))
    };
    args.batch.inputs(|| Ok(Vec::new()))?.into_iter().map(own).collect()
}

/// An input of the manifest, and what is drawn.
type Job<'a> = (&'a Input, Request<'a>);

/// What is drawn for each. Each picture has a place of its own, which is no input.
fn jobs(all: &[(Input, RenderArgs)]) -> Result<Vec<Job<'_>>, Failure> {
    let mut files = Files::read(all.iter().filter_map(|(input, _)| input.source.path()));
    let mut jobs = Vec::with_capacity(all.len());
    for (input, args) in all {
        let refused = |why: String| input.refused(Failure::usage(why));
        let mut request = Request::resolve(args).map_err(refused)?;
        if let Some(Target::File(path)) = &request.target {
            files.check(path).and_then(|()| files.write(path, input.source.name())).map_err(refused)?;
        }
        request.load.read.log = ReadLog::default();
        jobs.push((input, request));
    }
    jobs.retain(|(input, request)| request.args.batch.takes(&input.source));
    Ok(jobs)
}

/// The options for one input.
fn of_input(mut args: RenderArgs, input: &Input) -> Result<RenderArgs, Failure> {
    let output = &mut args.output;
    let kind = output.to.unwrap_or(if output.turntable.is_some() { FileKind::Gif } else { FileKind::Png });
    output.output = match (&input.output, &output.out_dir) {
        (Some(named), _) => Some(named.clone()),
        (None, Some(folder)) => Some(folder.join(input.place.with_extension(kind.choice()))),
        (None, None) => {
            return Err(Failure::usage(format!(
                "no output for {}\nhelp: give --out-dir, or name an `output` in the manifest",
                input.source.name()
            )));
        }
    };
    args.input = input.source.path().map(PathBuf::from);
    Ok(args)
}

/// Draws a picture unless an earlier run has, and records it.
fn one((input, request): &Job<'_>, shared: &Shared<'_>) -> Recorded<Report> {
    let start = Instant::now();
    let mut report = Report::new(request);
    let own = RenderArgs { batch: BatchArgs::default(), run: RunArgs::default(), ..request.args.clone() };
    let work = Work {
        verb: "render",
        input,
        output: request.target.as_ref().map(Target::name),
        options: format!("{own:?}"),
    };
    if shared.ledger.done_before(&work).is_some() {
        report.head.status = SKIPPED;
        return Recorded::skipped(report);
    }
    let result = shared.ledger.retried(&request.source, || {
        report = Report::new(request);
        guarded(|| run(request, None, &mut report))
    });
    report.seconds.total = start.elapsed().as_secs_f64();
    report.head.record(&result);
    if result.is_err() {
        report.output = None;
    }
    let done = Outcome {
        bytes: report.input.bytes.unwrap_or_default(),
        error: result.as_ref().err(),
        read: request.load.read.log.files().into_iter().chain(own.input).collect(),
        written: own.output.output.into_iter().collect(),
        seconds: report.seconds.total,
        ..Outcome::default()
    };
    let journal = shared.ledger.record(&work, done);
    Recorded { report, has_failed: result.is_err(), journal }
}
