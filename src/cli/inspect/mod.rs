//! The verb `inspect`: what is wrong with the normals of meshes.

mod against;
mod args;
mod report;
mod text;

pub use args::InspectArgs;

use super::args::Color;
use super::batch::{exit_of, guarded};
use super::console::{Console, Verbosity, escaped};
use super::inputs::{self, Source};
use super::normals::{self, Failure};
use super::output::{Store, is_same_file};
use super::progress::{FileProgress, Progress, Stage};
use super::report::{ErrorReport, json_line};
use super::request::{Job, RequestError, Target, resolve_parent};
use super::{Exit, usage_error, use_threads};
use against::AgainstReport;
use args::{Explained, FindingArgs, PictureArgs};
use crease::io::{Loaded, ReadOptions, Written};
use crease::num::Transfer;
use crease::quality::{Comparison, Diagnosis, Thresholds, compare, diagnose};
use crease::report::{After, ReportError, deviation_picture, diagnosis_page, encode_png};
use report::{Counts, InspectReport};
use std::path::{Path, PathBuf};
use std::time::Instant;

/// What a heat map of a file without normals shows.
const NO_DEVIATION: &str = "no normals are stored, so none can be off: the heat map has one colour for that; \
                            `crease normals` computes them";

/// Carries the verb out.
pub fn main(args: &InspectArgs, color: Color) -> Exit {
    let PictureArgs { html, heatmap, .. } = &args.pictures;
    let to_stdout = [html, heatmap].into_iter().flatten().find(|path| is_stdout(path));
    let console = Console::new(&args.run, color, to_stdout.map(PathBuf::as_path));
    if let Some(explained) = args.findings.explain {
        let style = console.report_style();
        console.report(&match explained {
            Explained::All => text::catalogue(style),
            Explained::One(kind) => text::explanation(kind.entry(), style),
        });
        return if console.has_reported() { Exit::Done } else { Exit::OutputFailed };
    }
    let mut thresholds = args.thresholds.resolve().unwrap_or_else(|message| usage_error("inspect", message));
    thresholds.places = args.findings.places.unwrap_or(thresholds.places);
    let jobs = match jobs(args) {
        Ok(jobs) => jobs,
        Err(RequestError::Usage(message)) => usage_error("inspect", message),
        Err(RequestError::Input(message)) => {
            console.error(&message);
            return Exit::BadInput;
        }
    };
    use_threads(args.run.threads);
    run(&jobs, args, &thresholds, &console)
}

fn jobs(args: &InspectArgs) -> Result<Vec<Job>, RequestError> {
    if let Some(root) = args.root.as_ref().filter(|root| !root.is_dir()) {
        return Err(RequestError::Usage(format!("--root {} is no folder", root.display())));
    }
    let found = inputs::expand(&args.inputs, args.recursive, None)?;
    let options = [
        ("--html", args.pictures.html.is_some()),
        ("--heatmap", args.pictures.heatmap.is_some()),
        ("--against", args.against.is_some()),
    ];
    if let Some((option, _)) = options.iter().find(|(_, is_given)| *is_given && found.len() > 1) {
        return Err(RequestError::Usage(format!("{option} takes one input, not {}", found.len())));
    }
    let sources: Vec<Source> = found.into_iter().map(|input| input.source).collect();
    let is_stdin = |source: &Source| matches!(source, Source::Stdin);
    if args.against.as_deref().map(source).is_some_and(|it| is_stdin(&it)) && sources.iter().any(is_stdin) {
        return Err(RequestError::Usage("standard input can be read once; name one of the two files".into()));
    }
    check_outputs(&sources, args)?;
    Ok(sources
        .into_iter()
        .map(|source| Job { source, format: args.format, target: None, to: None })
        .collect())
}

/// Whether a picture goes to standard output.
fn is_stdout(path: &Path) -> bool {
    path == Path::new("-")
}

/// The file that `--against` names, or standard input.
fn source(path: &Path) -> Source {
    if path == Path::new("-") { Source::Stdin } else { Source::File(path.to_path_buf()) }
}

/// No picture may be written over what is read, nor over the other.
fn check_outputs(sources: &[Source], args: &InspectArgs) -> Result<(), RequestError> {
    let files = sources.iter().filter_map(|source| match source {
        Source::File(path) => Some(path.as_path()),
        Source::Stdin => None,
    });
    let inputs: Vec<&Path> = files.chain(args.against.as_deref()).collect();
    let PictureArgs { html, heatmap, .. } = &args.pictures;
    for output in [html, heatmap].into_iter().flatten().filter(|path| !is_stdout(path)) {
        if let Some(input) = inputs.iter().find(|input| is_same_file(input, output)) {
            let input = input.display();
            return Err(RequestError::Usage(format!(
                "this would overwrite the input {input}; name another output"
            )));
        }
    }
    let is_png = |path: &Path| path.extension().is_some_and(|name| name.eq_ignore_ascii_case("png"));
    match (html, heatmap) {
        (Some(html), Some(heatmap)) if resolve_parent(html) == resolve_parent(heatmap) => Err(
            RequestError::Usage(format!("--html and --heatmap would both be written to {}", html.display())),
        ),
        (_, Some(path)) if !is_stdout(path) && !is_png(path) => Err(RequestError::Usage(format!(
            "{} does not end in .png, which is what --heatmap writes",
            path.display()
        ))),
        _ => Ok(()),
    }
}

fn run(jobs: &[Job], args: &InspectArgs, thresholds: &Thresholds, console: &Console) -> Exit {
    let progress = Progress::new(console, jobs);
    let read = ReadOptions { root: args.root.clone(), ..ReadOptions::default() };
    let (mut failed, mut told, mut failure_exit) = (0, false, Exit::BadInput);
    for job in jobs {
        let mut report = InspectReport::new(&name(job));
        let start = Instant::now();
        let file = progress.begin(job);
        let result = guarded(|| inspect(job, &read, args, thresholds, &file, &mut report));
        drop(file);
        report.seconds.total = start.elapsed().as_secs_f64();
        let mut lacks_normals = false;
        match result {
            Ok(outcome) => {
                lacks_normals = outcome.lacks_normals;
                if outcome.is_grave {
                    (report.status, told) = ("findings", true);
                }
            }
            Err(failure) => {
                failed += 1;
                failure_exit = exit_of(&failure);
                report.status = "failed";
                report.error = Some(ErrorReport::new(&failure));
            }
        }
        progress.suspended(|| {
            if lacks_normals {
                let name = &report.input.path;
                console.note(&format!("{name}: {NO_DEVIATION}"));
            }
            tell(&report, args, jobs.len() > 1, console);
        });
    }
    drop(progress);
    match (failed, jobs.len()) {
        _ if !console.has_reported() => Exit::OutputFailed,
        (0, _) => {
            if told {
                Exit::Findings
            } else {
                Exit::Done
            }
        }
        (_, 1) => failure_exit,
        _ => Exit::PartOfBatch,
    }
}

/// Reads, looks and draws.
fn inspect(
    job: &Job,
    read: &ReadOptions,
    args: &InspectArgs,
    thresholds: &Thresholds,
    progress: &FileProgress<'_>,
    report: &mut InspectReport,
) -> Result<Outcome, Failure> {
    progress.stage(Stage::Read);
    let start = Instant::now();
    let loaded = normals::load(job, read, progress, &mut report.input.bytes).map_err(Failure::Read)?;
    let loaded = loaded.without_source();
    report.seconds.read = start.elapsed().as_secs_f64();
    report.input.format = Some(loaded.format.extension());

    progress.stage(Stage::Compute);
    let start = Instant::now();
    let all = loaded.parts.iter().map(|part| part.mesh.face_count()).sum();
    let done = std::cell::Cell::new(0);
    let mut diagnosis = diagnose(&loaded, thresholds, &|faces| {
        done.set(done.get() + faces);
        progress.within(Stage::Compute, done.get(), all);
    });
    let after = match &args.against {
        Some(path) => Some(Later::read(path, read, thresholds, &loaded, &diagnosis, progress)?),
        None => None,
    };
    report.seconds.inspect = start.elapsed().as_secs_f64();
    report.against = after.as_ref().map(|after| AgainstReport::new(&after.path, &after.comparison));
    report.hidden = keep_wanted(&mut diagnosis, &args.findings);
    let output = mended(job, loaded.format.extension());
    report.fill(&diagnosis, &output);
    draw(&loaded, &diagnosis, after.as_ref(), [&report.input.path, &output], args)?;
    let is_grave = args.findings.fail_on.is_some_and(|least| diagnosis.worst() >= Some(least));
    let has_pictures = args.pictures.html.is_some() || args.pictures.heatmap.is_some();
    let has_faces = loaded.parts.iter().any(|part| part.mesh.face_count() > 0);
    Ok(Outcome { is_grave, lacks_normals: has_pictures && has_faces && !has_normals(&loaded) })
}

/// What came of an input that was read.
struct Outcome {
    /// Something is as grave as `--fail-on`.
    is_grave: bool,
    /// Pictures were drawn of a file with faces in which no normals are stored.
    lacks_normals: bool,
}

/// Whether any part of a file has stored normals.
fn has_normals(loaded: &Loaded) -> bool {
    let columns = loaded.parts.iter().map(|part| part.mesh.columns());
    columns.flat_map(|columns| &columns.normals).any(|normals| !normals.values.is_empty())
}

/// The file that `--against` names, and what is different in it.
struct Later {
    path: String,
    loaded: Loaded,
    comparison: Comparison,
}

impl Later {
    fn read(
        path: &Path,
        read: &ReadOptions,
        thresholds: &Thresholds,
        before: &Loaded,
        diagnosis: &Diagnosis,
        progress: &FileProgress<'_>,
    ) -> Result<Self, Failure> {
        let job = Job { source: source(path), format: None, target: None, to: None };
        let path = name(&job);
        let loaded =
            normals::load(&job, read, progress, &mut None).map_err(|error| Failure::read_of(&path, error))?;
        let loaded = loaded.without_source();
        let own = diagnose(&loaded, thresholds, &|_| {});
        let comparison = compare([before, &loaded], [diagnosis, &own], thresholds.places)
            .map_err(|error| Failure::Draw(format!("--against {path}: {error}")))?;
        Ok(Self { path, loaded, comparison })
    }
}

/// Makes and stores the pictures that were asked for. `names` are those of the file and of what mends it.
fn draw(
    loaded: &Loaded,
    diagnosis: &Diagnosis,
    after: Option<&Later>,
    names: [&str; 2],
    args: &InspectArgs,
) -> Result<(), Failure> {
    /// Pixels along the sides of a heat map of its own.
    const SIDE: u32 = 800;
    let PictureArgs { html, heatmap, view } = &args.pictures;
    let drawn = |error: ReportError| Failure::Draw(error.to_string());
    let mut store = Store::new(false, false);
    let mut put = |bytes: Vec<u8>, path: &Path| {
        let written = Written { bytes, ..Written::default() };
        let target = if is_stdout(path) { Target::Stdout } else { Target::File(path.to_path_buf()) };
        let stored = store.store(written, &target);
        stored.map(drop).map_err(|error| Failure::Write(format!("{error:#}")))
    };
    if let Some(path) = html {
        let after = after.map(|it| After { name: &it.path, loaded: &it.loaded, comparison: &it.comparison });
        let page = diagnosis_page(loaded, diagnosis, after, names, *view);
        put(page.map_err(drawn)?.into_bytes(), path)?;
    }
    if let Some(path) = heatmap {
        let picture = deviation_picture(loaded, diagnosis, *view, SIDE).map_err(drawn)?;
        put(encode_png(&picture, Transfer::Srgb).map_err(drawn)?, path)?;
    }
    Ok(())
}

/// Leaves the findings that are to be told, and gives the counts of the others.
fn keep_wanted(diagnosis: &mut Diagnosis, args: &FindingArgs) -> Counts {
    let all = Counts::of(diagnosis);
    diagnosis.findings.retain(|finding| {
        finding.severity >= args.severity
            && !args.ignore.contains(&finding.kind)
            && (args.only.is_empty() || args.only.contains(&finding.kind))
    });
    all.without(Counts::of(diagnosis))
}

fn name(job: &Job) -> String {
    match &job.source {
        Source::Stdin => "-".into(),
        Source::File(path) => path.display().to_string(),
    }
}

/// A name for what mends an input, beside it.
fn mended(job: &Job, extension: &str) -> String {
    let stem = match &job.source {
        Source::File(path) => path.with_extension(""),
        Source::Stdin => Path::new("stdin").to_path_buf(),
    };
    format!("{}-mended.{extension}", stem.display())
}

fn tell(report: &InspectReport, args: &InspectArgs, brief: bool, console: &Console) {
    if let Some(error) = &report.error {
        console.error(&format!("{}: {}", escaped(&report.input.path), error.message));
    }
    if console.json {
        console.report(&json_line(report));
    } else if console.verbosity > Verbosity::Quiet && report.error.is_none() {
        let verbose = console.verbosity == Verbosity::Verbose;
        let style = console.report_style();
        let places = args.findings.places.unwrap_or(if verbose { usize::MAX } else { 1 });
        console.report(&if brief && !verbose {
            text::line(report, style)
        } else {
            text::block(report, style, verbose, places)
        });
    }
}
