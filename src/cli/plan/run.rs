//! Runs `crease plan`.

use super::apply::{self, Source, mesh_name};
use super::args::{PlanArgs, Reference};
use super::report::{DrawSeconds, EXPLANATION, Report, text};
use crate::cli::common::command_line;
use crate::cli::common::console::{Console, HELP, escaped};
use crate::cli::common::failure::{Exit, Failure, exit_code, guarded};
use crate::cli::common::options::Color;
use crate::cli::common::output::{Target, resolve_parent};
use crate::cli::common::output_conflicts::Files;
use crate::cli::common::progress::Progress;
use crate::cli::usage::usage_error;
use crease::io::shell_word;
use crease::num::Transfer;
use crease::plan::{PlanError, most_accurate, plan, plan_with_evidence, scene_text, with_mesh_names};
use crease::raster::{LoadOptions, SceneFile, render};
use crease::report::{PlanPage, encode_png, plan_page, plan_sheet};
use std::path::Path;
use std::time::Instant;

pub fn main(args: &PlanArgs, color: Color) -> Exit {
    let to_stdout = args.files().find(|path| Target::of(path) == Target::Standard);
    let console = Console::new(&args.run, color, to_stdout.map(|path| path.as_path()));
    if args.explain {
        console.report(EXPLANATION);
        return exit_code(Ok(Exit::Done), &console);
    }
    let mut files = Files::read([args.scene()]);
    let mut outputs = args.files().chain(&args.apply);
    let checked = outputs.try_for_each(|path| {
        files.check(path)?;
        files.write(path, String::new())
    });
    if let Some(message) = checked.err().or_else(|| apply::refusal(args)) {
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
    let options = args.options().unwrap_or_else(|message| usage_error("plan", message));
    let loading = LoadOptions::default();
    let base = source.base();
    let text = apply::declared(args, &source, scene_text(&source.path, &loading)?)?;
    let text = match args.size {
        Some(size) => crease::plan::with_size(&text, size).map_err(Failure::input)?,
        None => text,
    };
    let text = match args.reference {
        Reference::Declared => text,
        Reference::Accurate => most_accurate(&text).map_err(Failure::input)?,
    };
    // Refused before the search.
    for_output(args, base, text.clone())?;
    let progress = Progress::of_steps(console);
    let advance = |step| progress.plan(step);
    let planned = match args.html.as_ref().or(args.picture.as_ref()) {
        None => plan(&text, base, &loading, &options, &advance).map(|plan| (plan, None)),
        Some(_) => plan_with_evidence(&text, base, &loading, &options, &advance)
            .map(|(plan, evidence)| (plan, Some(evidence))),
    };
    drop(progress);
    let (mut planned, evidence) = planned.map_err(|error| match error {
        PlanError::Read(error) => error.into(),
        error => Failure::advised(error),
    })?;
    report.draw_seconds = Some(DrawSeconds {
        declared: draw_seconds(&text, base, &loading)?,
        planned: draw_seconds(&planned.text, base, &loading)?,
    });
    report.files = apply::store(args, &source, &mut planned)?;
    if let Some(path) = apply::scene_output(args) {
        planned.text = for_output(args, base, planned.text)?;
        report.output = Some(Target::of(&path).store(planned.text.clone().into_bytes())?);
    }
    if let Some(evidence) = evidence {
        let about = PlanPage {
            scene: &args.scene().file_name().unwrap_or_default().to_string_lossy(),
            command: &command(),
            minimise: args.minimise(),
            metric: args.metric,
            tolerance: options.tolerance,
            language: args.lang,
        };
        if let Some(path) = &args.html {
            let page = plan_page(&planned, &evidence, &about).map_err(Failure::input)?;
            report.page = Some(Target::of(path).store(page.into_bytes())?);
        }
        if let Some(path) = &args.picture {
            let sheet = plan_sheet(&planned, &evidence, &about).map_err(Failure::input)?;
            let png = encode_png(&sheet, None, Transfer::Srgb).map_err(Failure::input)?;
            report.picture = Some(Target::of(path).store(png)?);
        }
    }
    report.plan = Some(planned);
    Ok(Exit::Done)
}

/// The text of a scene whose mesh files are named from the folder that it is written to, not from `base`. A scene names files of its own
/// folder and below.
fn for_output(args: &PlanArgs, base: &Path, text: String) -> Result<String, Failure> {
    let Some(output) = args.output.as_deref().filter(|_| args.apply.is_none()) else { return Ok(text) };
    let is_elsewhere = resolve_parent(output).parent() != resolve_parent(&base.join("_")).parent();
    if !is_elsewhere || Target::of(output) == Target::Standard {
        return Ok(text);
    }
    let output = resolve_parent(output);
    let renamed = with_mesh_names(&text, &|name| mesh_name(&output, &resolve_parent(&base.join(name))));
    renamed.map_err(Failure::input)?.map_err(|name| {
        let found = format!("the planned scene cannot refer to {} from its folder", escaped(&name));
        let advice =
            "write it into the folder of the input or above it, or write its meshes too with --apply";
        Failure::usage(format!("{found}{HELP}{advice}"))
    })
}

/// The command line, as a shell takes it.
fn command() -> String {
    let mut line = "crease".to_owned();
    for word in command_line::words() {
        let word = word.to_string_lossy();
        line.push(' ');
        line += &if word.starts_with('-') { word } else { shell_word(&word).into_owned().into() };
    }
    line
}

/// The shortest of three times to draw a scene from its own camera.
fn draw_seconds(text: &str, base: &Path, loading: &LoadOptions) -> Result<f64, Failure> {
    let file = SceneFile::from_toml(text, base, loading)?;
    let scene = file.scene();
    let mut shortest = f64::INFINITY;
    for _ in 0..3 {
        let start = Instant::now();
        render(&scene, &file.settings).map_err(Failure::advised)?;
        shortest = shortest.min(start.elapsed().as_secs_f64());
    }
    Ok(shortest)
}
