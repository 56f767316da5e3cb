//! Runs `crease inspect`: checks of the command line, then all inputs.

use super::args::{FindingArgs, HeatMapOf, InspectArgs, PictureArgs};
use super::explanation;
use super::json::{Against, Counts, FindingReport, InspectReport, SkippedReport};
use super::symptoms;
use super::text::Layout;
use crate::cli::common::console::{Console, HELP, Style, Verbosity, escaped};
use crate::cli::common::failure::{Exit, Failure, exit_code, guarded};
use crate::cli::common::input::{Input, Source, expand};
use crate::cli::common::ledger::{Ledger, Outcome, Work, skipped};
use crate::cli::common::options::Color;
use crate::cli::common::output::{Target, stem};
use crate::cli::common::output_conflicts::Files;
use crate::cli::common::progress::{FileProgress, Stage};
use crate::cli::common::report::SKIPPED;
use crate::cli::common::run_batch::{Recorded, Shared, run_batch};
use crate::cli::line_options::with_line;
use crate::cli::usage::{refused, usage_error};
use crease::io::{Format, Loaded, ReadLog, ReadOptions};
use crease::num::Transfer;
use crease::quality::catalogue::{Kind, entries};
use crease::quality::{Diagnosis, Severity, Thresholds, compare, diagnose};
use crease::report::{After, DiagnosisPage, HeatMap, encode_png, heat_map};
use crease::text::Language;
use std::collections::{BTreeMap, HashMap};
use std::path::Path;
use std::sync::Arc;
use std::time::Instant;

/// What a map of angles of a file without normals shows.
const NO_DEVIATION: &str =
    "no normals are stored: the picture shows no deviations\nhelp: compute normals with `crease normals`";

/// The side of a heat map in pixels.
const SIDE: u32 = 800;

pub fn main(args: &InspectArgs, color: Color) -> Exit {
    let to_stdout = args.pictures.paths().find(|path| Target::of(path) == Target::Standard);
    let console = Console::new(&args.run, color, to_stdout.map(|path| path.as_path()));
    if !args.findings.explain.is_empty() {
        let findings = &args.findings;
        console.report(&explained(
            &findings.explain.join(" "),
            findings.lang.unwrap_or_default(),
            console.report_style,
        ));
        return exit_code(Ok(Exit::Done), &console);
    }
    let jobs = match jobs(args) {
        Ok(jobs) => jobs,
        Err(failure) => return refused("inspect", &failure, &console),
    };
    args.run.use_threads();
    run(&jobs, args, &console)
}

/// What the catalogue has on a finding, on all, or on those that a symptom fits.
fn explained(words: &str, language: Language, style: Style) -> String {
    let found = match Kind::of_id(words) {
        Some(kind) => vec![kind.entry()],
        None if words == "all" => entries().collect(),
        None => symptoms::search(words),
    };
    match &found[..] {
        [] => usage_error(
            "inspect",
            format!(
                "no finding fits {words:?}{HELP}{}name what is visible ({}), or `all` for every finding",
                symptoms::similar(words),
                symptoms::examples()
            ),
        ),
        [entry] => explanation::one(entry, language, style),
        found if words == "all" => explanation::all(found, language, style),
        found => explanation::list(found, language, style),
    }
}

fn run(jobs: &[Job], args: &InspectArgs, console: &Console) -> Exit {
    let ledger = match Ledger::open(&args.batch, false, false) {
        Ok(ledger) => ledger,
        Err(failure) => return refused("inspect", &failure, console),
    };
    let mut has_findings = false;
    let exit = run_batch(console, &args.batch, &ledger, jobs, source, one, |job, report, batch| {
        has_findings |= !report.findings.is_empty();
        batch.count(&report.input.path, &report.head);
        if report.is_grave {
            batch.exit = Exit::Findings;
        }
        if report.lacks_normals && console.verbosity != Verbosity::Quiet {
            console.note(&format!("{}: {NO_DEVIATION}", report.input.path));
        }
        print(&report, &job.args, jobs.len() > 1, console);
    });
    if has_findings && jobs.len() > 1 && console.verbosity == Verbosity::Normal {
        console.text(|| "-v lists the findings of each file\n".to_owned());
    }
    exit
}

fn source(job: &Job) -> (&Source, Option<Format>) {
    (&job.input.source, job.args.format)
}

/// Inspects an input unless an earlier run has, and records it.
fn one(job: &Job, shared: &Shared<'_>) -> Recorded<InspectReport> {
    let mut report = InspectReport::new(&job.input.source);
    let start = Instant::now();
    let work = Work { verb: "inspect", input: &job.input, output: None, options: job.options() };
    if let Some(entry) = shared.ledger.done_before(&work) {
        report.head.status = SKIPPED;
        let worst = Severity::ALL.into_iter().find(|it| Some(it.name()) == entry.verdict.as_deref());
        report.is_grave = job.args.findings.fail_on.is_some_and(|least| worst >= Some(least));
        report.verdict = worst;
        report.before = entry.findings;
        return Recorded::skipped(report);
    }
    let log = ReadLog::default();
    let read = ReadOptions { log: log.clone(), ..job.args.companions.read_options(false) };
    let result = shared.ledger.retried(&job.input.source, || {
        report = InspectReport::new(&job.input.source);
        guarded(|| inspect(job, &read, shared.progress, &mut report))
    });
    report.seconds.total = start.elapsed().as_secs_f64();
    report.head.record(&result);
    let mut findings = BTreeMap::new();
    for FindingReport { finding, .. } in &report.findings {
        *findings.entry(finding.kind.id().to_owned()).or_default() += finding.count;
    }
    let done = Outcome {
        bytes: report.input.bytes.unwrap_or_default(),
        error: result.as_ref().err(),
        read: log.files().into_iter().collect(),
        written: report.written.iter().map(|(_, path)| path.into()).collect(),
        findings,
        verdict: report.verdict.map(|worst| worst.name().to_owned()),
        seconds: report.seconds.total,
        ..Outcome::default()
    };
    let journal = shared.ledger.record(&work, done);
    if report.is_grave {
        report.head.status = "findings";
    }
    Recorded { report, has_failed: result.is_err(), journal }
}

/// Reads, diagnoses and draws.
fn inspect(
    job: &Job,
    read: &ReadOptions,
    progress: &FileProgress<'_>,
    report: &mut InspectReport,
) -> Result<(), Failure> {
    let (source, args) = (&job.input.source, &*job.args);
    let thresholds = &args.thresholds.resolve(args.findings.places);
    progress.stage(Stage::Read);
    let start = Instant::now();
    let loaded = progress.read(source, args.format, read, &mut report.input.bytes)?.without_source();
    report.seconds.read = start.elapsed().as_secs_f64();
    report.input.format = Some(loaded.format);

    progress.stage(Stage::Compute);
    let start = Instant::now();
    let all = loaded.parts.iter().map(|part| part.mesh.face_count()).sum();
    let done = std::cell::Cell::new(0);
    let mut diagnosis = diagnose(&loaded, thresholds, &|faces| {
        done.set(done.get() + faces);
        progress.within(Stage::Compute, done.get(), all);
    });
    let mut after = None;
    if let Some(path) = &args.against {
        let source = Source::of(path);
        let path = source.name();
        let other = progress.read(&source, None, read, &mut None);
        let other = other.map_err(|error| Failure::read(&path, error))?.without_source();
        let findings = diagnose(&other, thresholds, &|_| {});
        let comparison = compare([&loaded, &other], [&diagnosis, &findings], thresholds.places)
            .map_err(|error| Failure::advised(format!("--against {path}: {error}")))?;
        report.against = Some(Against { path, comparison });
        after = Some(other);
    }
    report.seconds.inspect = start.elapsed().as_secs_f64();
    let stem = source.path().map_or("stdin".into(), |path| stem(path).unwrap_or_default());
    let number = if job.number == 1 { String::new() } else { format!("-{}", job.number) };
    // 3MF is not written.
    let format = if loaded.format == Format::ThreeMf { Format::Glb } else { loaded.format };
    report.fix_as = format!("{stem}-fixed{number}.{}", format.extension());
    let (wanted, names) = (&args.findings, [&*report.input.path, &*report.fix_as]);
    report.fix = diagnosis.fix(|finding| wanted.takes(finding), wanted.names_notes(), names);
    report.hidden = keep_wanted(&mut diagnosis, wanted);
    report.fill(&diagnosis);
    draw(&loaded, (&diagnosis, thresholds), after.as_ref(), report, args)?;
    report.is_grave = args.findings.fail_on.is_some_and(|least| diagnosis.worst() >= Some(least));
    let of_angles = matches!(args.pictures.heatmap_of, Some(HeatMapOf::Deviation | HeatMapOf::Weight(_)));
    let has_pictures = args.pictures.html.is_some() || of_angles;
    let has_faces = loaded.parts.iter().any(|part| part.mesh.face_count() > 0);
    report.lacks_normals = has_pictures && has_faces && !has_normals(&loaded);
    Ok(())
}

fn has_normals(loaded: &Loaded) -> bool {
    let columns = loaded.parts.iter().map(|part| part.mesh.columns());
    columns.flat_map(|columns| &columns.normals).any(|normals| !normals.values.is_empty())
}

/// Makes and stores the pictures that were asked for. `after` is the file that `--against` names.
fn draw(
    loaded: &Loaded,
    (diagnosis, thresholds): (&Diagnosis, &Thresholds),
    after: Option<&Loaded>,
    report: &mut InspectReport,
    args: &InspectArgs,
) -> Result<(), Failure> {
    let PictureArgs { html, heatmap, heatmap_of, view } = &args.pictures;
    if let Some(path) = html {
        let after = after.zip(report.against.as_ref());
        let after =
            after.map(|(loaded, Against { path, comparison })| After { name: path, loaded, comparison });
        let page = DiagnosisPage {
            name: &report.input.path,
            fix: report.fix.as_ref(),
            omitted: report.hidden.total(),
            after,
            sight: *view,
            language: args.findings.lang.unwrap_or_default(),
            thresholds,
        };
        let page = page.html(loaded, diagnosis).map_err(Failure::input)?;
        report.written.push(("page", Target::of(path).store(page.into_bytes())?));
    }
    if let Some(path) = heatmap {
        let (mut one, mut shown) = (None, diagnosis);
        let of = match heatmap_of {
            Some(HeatMapOf::Deviation) => HeatMap::Deviation,
            Some(HeatMapOf::Weight(weight)) => HeatMap::From(*weight),
            Some(HeatMapOf::Finding(kind)) => {
                let diagnosis: &mut Diagnosis = one.insert(diagnosis.clone());
                diagnosis.findings.retain(|finding| finding.kind == *kind);
                shown = diagnosis;
                HeatMap::AllFindings
            }
            None if args.findings.names_notes() => HeatMap::AllFindings,
            None => HeatMap::Findings,
        };
        let picture =
            heat_map(loaded, (shown, thresholds), of, *view, SIDE, args.findings.lang.unwrap_or_default())
                .map_err(Failure::input)?;
        let png = encode_png(&picture, None, Transfer::Srgb).map_err(Failure::input)?;
        report.written.push(("picture", Target::of(path).store(png)?));
    }
    Ok(())
}

/// Keeps the findings that were asked for and returns the counts of the others.
pub fn keep_wanted(diagnosis: &mut Diagnosis, args: &FindingArgs) -> Counts {
    let all = Counts::of(diagnosis);
    diagnosis.findings.retain(|finding| args.takes(finding));
    all.without(Counts::of(diagnosis))
}

fn print(report: &InspectReport, args: &InspectArgs, brief: bool, console: &Console) {
    if let Some(error) = &report.head.error {
        console.error(&format!("{}: {}", escaped(&report.input.path), error.message));
    }
    if report.head.status == SKIPPED {
        return console.print(&SkippedReport::new(report), || skipped(&report.input.path));
    }
    console.print(report, || {
        let verbose = console.verbosity == Verbosity::Verbose;
        let style = console.report_style;
        let layout = Layout {
            style,
            verbose,
            hides_notes: !verbose && args.findings.severity.is_none() && args.findings.only.is_empty(),
            selects_by_severity: args.findings.only.is_empty() && args.findings.ignore.is_empty(),
            places: args.findings.places.unwrap_or(if verbose { usize::MAX } else { 1 }),
        };
        match brief && !verbose {
            _ if report.head.error.is_some() => String::new(),
            true => layout.brief(report),
            false => layout.block(report),
        }
    });
}

/// An input with its options.
struct Job {
    input: Input,
    /// Its number among those of the same stem, from 1: each fixed version has a name of its own.
    number: usize,
    args: Arc<InspectArgs>,
}

impl Job {
    /// All options that affect the result, as text.
    fn options(&self) -> String {
        let InspectArgs { format, companions, against, pictures, findings, thresholds, .. } = &*self.args;
        let findings = (findings.severity, &findings.ignore, &findings.only, findings.places, findings.lang);
        format!("{:?}", (format, companions, against, pictures, findings, thresholds))
    }
}

fn jobs(args: &InspectArgs) -> Result<Vec<Job>, Failure> {
    args.companions.check().map_err(Failure::usage)?;
    let found = args.batch.inputs(|| expand(&args.inputs, args.recursive, None))?;
    let options = [
        ("--html", args.pictures.html.is_some()),
        ("--heatmap", args.pictures.heatmap.is_some()),
        ("--against", args.against.is_some()),
    ];
    if let Some((option, _)) = options.iter().find(|(_, is_given)| *is_given && found.len() > 1) {
        return Err(Failure::usage(format!(
            "{option} takes one input, not {}\nhelp: inspect one file at a time",
            found.len()
        )));
    }
    let base = Arc::new(args.clone());
    let (mut numbers, mut jobs) = (HashMap::new(), Vec::with_capacity(found.len()));
    for input in found {
        if input.output.is_some() {
            return Err(input.refused(Failure::usage(
                "`inspect` has no `output`\nhelp: \"options\": [\"--html\", \"page.html\"] writes a page",
            )));
        }
        let args =
            if input.options.is_empty() { base.clone() } else { Arc::new(with_line("inspect", &input)?) };
        let number = numbers.entry(input.source.path().and_then(stem)).or_insert(0);
        *number += 1;
        jobs.push(Job { number: *number, args, input });
    }
    let sources = || jobs.iter().map(|job| &job.input.source);
    let compared = jobs.iter().filter_map(|job| job.args.against.as_deref());
    let mut files = Files::read(sources().filter_map(Source::path).chain(compared));
    for Job { input, args, .. } in &jobs {
        let refused = |message: String| input.refused(Failure::usage(message));
        if args.findings.lang.is_some() && args.pictures.paths().next().is_none() {
            return Err(refused(
                "--lang needs --explain, --html or --heatmap\nhelp: the text report is in English".into(),
            ));
        }
        if args.against.as_deref().map(Source::of) == Some(Source::Standard)
            && sources().any(|source| *source == Source::Standard)
        {
            return Err(refused(
                "standard input can be read only once\nhelp: name one of the two files".into(),
            ));
        }
        for path in args.pictures.paths() {
            let written = files.check(path).and_then(|()| files.write(path, input.source.name()));
            written.map_err(refused)?;
        }
        let is_png = |path: &Path| path.extension().is_some_and(|name| name.eq_ignore_ascii_case("png"));
        let heat_map = args.pictures.heatmap.as_ref();
        if let Some(path) = heat_map.filter(|path| Target::of(path) != Target::Standard && !is_png(path)) {
            let path = path.display();
            let found = format!("--heatmap writes a PNG, not {path}\nhelp: use a name that ends in .png");
            return Err(refused(found));
        }
    }
    jobs.retain(|job| args.batch.takes(&job.input.source));
    Ok(jobs)
}
