//! Runs `crease normals`: all inputs one after the other. A bad one does not stop the others.

use super::args::NormalsArgs;
use super::conversion::{Conversion, axes_note, conversion};
use super::json::{Part, Report};
use super::ledger::Ledger;
use super::request::{Job, Request};
use super::text;
use crate::cli::common::console::{Console, Verbosity, escaped};
use crate::cli::common::failure::{Batch, Exit, Failure, guarded};
use crate::cli::common::options::Color;
use crate::cli::common::output::{Store, folder_of, stem};
use crate::cli::common::progress::{FileProgress, Progress, Stage};
use crate::cli::common::report::MeshOutput;
use crate::cli::usage::refused;
use crease::io::{self, Format, Loaded, MeshCompression, Written};
use crease::mesh::Movement;
use crease::pipeline;
use std::path::Path;
use std::sync::atomic::{AtomicUsize, Ordering};
use std::time::Instant;

pub fn main(args: &NormalsArgs, color: Color) -> Exit {
    let console = Console::new(&args.run, color, args.output.output.as_deref());
    let request = match Request::resolve(args) {
        Ok(request) => request,
        Err(failure) => return refused("normals", &failure, &console),
    };
    args.run.use_threads();
    let mut ledger = match Ledger::open(&request) {
        Ok(ledger) => ledger,
        Err(failure) => return refused("normals", &failure, &console),
    };
    ledger.note(&console);
    let progress = Progress::of_inputs(&console, request.jobs.iter().map(|job| &job.source));
    let mut store = Store::new(args.output.sync, args.output.dry_run);
    let mut batch = Batch::new(request.jobs.len());
    for job in &request.jobs {
        let mut report = Report::new(job, &request);
        let start = Instant::now();
        let file = progress.begin(&job.source);
        if ledger.has(job) {
            report.head.status = "skipped";
            batch.skip();
            progress.suspended(|| print(&report, &request, &console));
            continue;
        }
        let done = ledger.retried(|| guarded(|| run(job, &request, &mut store, &file, &mut report)));
        drop(file);
        report.seconds.total = start.elapsed().as_secs_f64();
        report.head.record(&done);
        let recorded = ledger.record(job, &report, &store);
        if let Err(failure) = done {
            batch.record(&report.input.path, failure);
            report.output = None;
        }
        progress.suspended(|| print(&report, &request, &console));
        if let Err(failure) = recorded {
            drop(progress);
            console.error(&failure.message);
            return failure.exit();
        }
    }
    drop(progress);
    batch.finish(Exit::Done, &console)
}

fn print(report: &Report, request: &Request, console: &Console) {
    if let Some(error) = &report.head.error {
        // The message itself names outputs.
        console.error(&format!("{}: {}", escaped(&report.input.path), error.message));
    }
    let brief = request.jobs.len() > 1 && console.verbosity < Verbosity::Verbose;
    console.print(report, || {
        console.notes(&report.input.path, &report.notes, brief);
        match brief {
            _ if report.head.error.is_some() => String::new(),
            _ if report.head.status == "skipped" => text::skipped(report),
            true => text::line(report, console.report_style),
            false => text::block(report, request.args.output.dry_run, console),
        }
    });
}

/// Carries out one job: read, compute, write, store. The report contains the results up to the first error.
fn run(
    job: &Job,
    request: &Request,
    store: &mut Store,
    progress: &FileProgress<'_>,
    report: &mut Report,
) -> Result<(), Failure> {
    progress.stage(Stage::Read);
    let start = Instant::now();
    let mut loaded = progress.read(&job.source, job.format, &request.read, &mut report.input.bytes)?;
    report.seconds.read = start.elapsed().as_secs_f64();
    report.input.format = Some(loaded.format);
    report.notes.extend_from_slice(&loaded.notes);

    progress.stage(Stage::Compute);
    let start = Instant::now();
    let target = (!request.rows).then(|| job.to.unwrap_or(loaded.format));
    if let Some(target) =
        target.filter(|&target| request.write.compression != MeshCompression::None && target != Format::Glb)
    {
        return Err(Failure::usage(format!(
            "--compress meshopt needs a GLB, but the output is {target}\nhelp: name an output that ends in .glb, or use --to glb"
        )));
    }
    pipeline::forget_unused(&mut loaded, &request.task, target);
    let moved = match (request.merge_distance, target) {
        (Some(fraction), Some(target)) if !target.edits(loaded.format) => loaded.move_together(fraction),
        (Some(_), Some(target)) => {
            return Err(Failure::usage(format!(
                "--merge with a fraction moves vertices, but {target} is the format of the input, whose positions stay\n\
                 help: choose another format with --to, or --merge exact"
            )));
        }
        _ => Movement::default(),
    };
    let conversion = match target {
        Some(target) => conversion(&request.args.mesh, loaded.format, target)?,
        None => None,
    };
    report.notes.extend(target.and_then(|to| axes_note(conversion.as_ref(), loaded.format, to)));
    let revision = compute(&loaded, request, target, progress);
    report.seconds.compute = start.elapsed().as_secs_f64();
    let parts = revision.parts.into_iter().zip(&revision.edits);
    report.parts = parts.map(|(part, edit)| Part::new(part, request.rows.then_some(edit))).collect();
    let Some(format) = target else { return Ok(()) };

    progress.stage(Stage::Write);
    let start = Instant::now();
    let place = place(job);
    let (stem, folder) = (place.and_then(stem), place.map(folder_of));
    let map = conversion.as_ref().map(|conversion| conversion.map).filter(|map| !map.is_identity());
    let options = io::WriteOptions { stem, folder, conversion: map, ..request.write.clone() };
    let written = io::write(&loaded, revision.edits, format, &options).map_err(Failure::output)?;
    let unchanged = loaded.document.is_unchanged(&written.bytes);
    // A large input takes as long to give back as its output to write.
    rayon::spawn(move || drop(loaded));
    report.notes.extend_from_slice(&written.notes);
    let output = MeshOutput::new(job.target.as_ref(), format, unchanged, &written).with_moved(moved);
    report.output = Some(match conversion {
        Some(Conversion { text, .. }) => {
            MeshOutput { matrix: map.map(|map| map.matrix().to_cols_array()), conversion: text, ..output }
        }
        None => output,
    });
    report.notes.extend(put(job, store, written, unchanged)?);
    report.seconds.write = start.elapsed().as_secs_f64();
    Ok(())
}

fn compute(
    loaded: &Loaded,
    request: &Request,
    target: Option<Format>,
    progress: &FileProgress<'_>,
) -> pipeline::Revision {
    let all = loaded.parts.iter().map(|part| part.mesh.face_count()).sum();
    let done = AtomicUsize::new(0);
    pipeline::revise(loaded, &request.task, target, &|faces| {
        let before = done.fetch_add(faces, Ordering::Relaxed);
        progress.within(Stage::Compute, before + faces, all);
    })
}

/// Where the output will be, for its companion files; `None` for a stream or a device.
fn place(job: &Job) -> Option<&Path> {
    let path = job.target.as_ref().unwrap_or(&job.source).path()?;
    let is_device = job.target.is_some() && path.metadata().is_ok_and(|it| !it.is_file() && !it.is_dir());
    (!is_device).then_some(path)
}

/// Stores the output and returns a note for each other file that it replaces.
fn put(job: &Job, store: &mut Store, written: Written, unchanged: bool) -> Result<Vec<io::Note>, Failure> {
    let Some(target) = &job.target else { return Ok(Vec::new()) };
    // An unchanged input keeps its modification time too.
    if unchanged && *target == job.source && target.path().is_some() {
        return Ok(Vec::new());
    }
    Ok(store.store(written, target)?)
}
