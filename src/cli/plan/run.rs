//! Runs `crease plan`.

use super::apply::{self, Source};
use super::args::PlanArgs;
use super::report::{EXPLANATION, Report, text};
use crate::cli::common::console::{Console, escaped};
use crate::cli::common::failure::{Exit, Failure, exit_code, guarded};
use crate::cli::common::options::Color;
use crate::cli::common::output::{Target, is_same_file};
use crate::cli::common::progress::Progress;
use crate::cli::help::usage_error;
use crease::plan::{Plan, PlanError, PlanOptions, plan, scene_text};
use crease::raster::LoadOptions;
use std::time::Instant;

pub fn main(args: &PlanArgs, color: Color) -> Exit {
    let console = Console::new(&args.run, color, args.output.as_deref());
    if args.explain {
        console.report(EXPLANATION);
        return exit_code(Ok(Exit::Done), &console);
    }
    if args.output.as_deref().is_some_and(|output| is_same_file(args.scene(), output)) {
        usage_error(
            "plan",
            format!("this would overwrite the input {}\nhelp: name another output", args.scene().display()),
        );
    }
    if let Some(message) = apply::refusal(args) {
        usage_error("plan", message);
    }
    args.run.use_threads();
    let start = Instant::now();
    let mut report = Report::new(args);
    let result = guarded(|| run(args, &console, &mut report));
    report.seconds = start.elapsed().as_secs_f64();
    report.head.record(&result);
    if let Err(failure) = &result {
        console.error(&format!("{}: {}", escaped(&report.input), failure.message));
    }
    console.print(&report, || {
        report.files.iter().for_each(|file| console.notes(&file.output, &file.notes, false));
        text(&report, console.report_style)
    });
    exit_code(result, &console)
}

fn run(args: &PlanArgs, console: &Console, report: &mut Report) -> Result<Exit, Failure> {
    let source = Source::new(args)?;
    let progress = Progress::of_share(console, "planning");
    let planned = find(args, &source, &|share| progress.share(share));
    drop(progress);
    let mut planned = planned?;
    report.files = apply::store(args, &source, &mut planned)?;
    if let Some(path) = apply::scene_output(args) {
        let target = Target::of(&path);
        report.output = Some(target.name());
        target.store(planned.text.clone().into_bytes())?;
    }
    report.plan = Some(planned);
    Ok(Exit::Done)
}

fn find(args: &PlanArgs, source: &Source, progress: &dyn Fn(f64)) -> Result<Plan, Failure> {
    let options = PlanOptions {
        tolerance: args.tolerance,
        share: args.share,
        outline: args.outline,
        minimise: args.minimise(),
        views: args.views,
        keep: args.kept(),
        budget: args.budget,
        for_files: args.apply.is_some(),
    };
    let base = source.base();
    let loading = LoadOptions::default();
    let text = apply::declared(args, source, scene_text(&source.path, &loading)?)?;
    let text = match args.size {
        Some(size) => crease::plan::with_size(&text, size).map_err(Failure::input)?,
        None => text,
    };
    plan(&text, base, &loading, &options, progress).map_err(|error| match error {
        PlanError::Read(error) => error.into(),
        error => Failure::advised(error),
    })
}
