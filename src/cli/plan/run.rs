//! Runs `crease plan`.

use super::args::PlanArgs;
use super::report::{EXPLANATION, Report, text};
use crate::cli::common::console::{Console, escaped};
use crate::cli::common::failure::{Exit, Failure, exit_code, guarded};
use crate::cli::common::options::Color;
use crate::cli::common::output::{Target, is_same_file};
use crate::cli::common::progress::Progress;
use crate::cli::usage::usage_error;
use crease::plan::{Plan, PlanError, PlanOptions, plan, scene_text};
use crease::raster::LoadOptions;
use std::path::Path;
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
    args.run.use_threads();
    let start = Instant::now();
    let mut report = Report::new(args);
    let result = guarded(|| run(args, &console, &mut report));
    report.seconds = start.elapsed().as_secs_f64();
    report.head.record(&result);
    if let Err(failure) = &result {
        console.error(&format!("{}: {}", escaped(&report.input), failure.message));
    }
    console.print(&report, || text(&report, console.report_style));
    exit_code(result, &console)
}

fn run(args: &PlanArgs, console: &Console, report: &mut Report) -> Result<Exit, Failure> {
    let progress = Progress::of_share(console, "planning");
    let planned = find(args, &|share| progress.share(share));
    drop(progress);
    let planned = planned?;
    if let Some(path) = &args.output {
        let target = Target::of(path);
        report.output = Some(target.name());
        target.store(planned.text.clone().into_bytes())?;
    }
    report.plan = Some(planned);
    Ok(Exit::Done)
}

fn find(args: &PlanArgs, progress: &dyn Fn(f64)) -> Result<Plan, Failure> {
    let options = PlanOptions {
        tolerance: args.tolerance,
        share: args.share,
        outline: args.outline,
        minimise: args.minimise,
        views: args.views,
        keep: args.kept(),
        budget: args.budget,
    };
    let base = args.scene().parent().unwrap_or(Path::new(""));
    let loading = LoadOptions::default();
    let text = scene_text(args.scene(), &loading)?;
    let text = match args.size {
        Some(size) => crease::plan::with_size(&text, size).map_err(Failure::input)?,
        None => text,
    };
    plan(&text, base, &loading, &options, progress).map_err(|error| match error {
        PlanError::Read(error) => error.into(),
        error => Failure::advised(error),
    })
}
