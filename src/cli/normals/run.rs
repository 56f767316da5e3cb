//! Runs `crease normals` on all inputs. A bad one does not stop the others.

use super::args::NormalsArgs;
use super::conversion::{Conversion, axes_note, conversion};
use super::json::{Part, Report};
use super::request::{self, Job, Settings};
use super::text;
use crate::cli::common::console::{Console, Verbosity, escaped};
use crate::cli::common::failure::{Exit, Failure, guarded};
use crate::cli::common::input::Source;
use crate::cli::common::ledger::{Ledger, Outcome, Work, skipped};
use crate::cli::common::options::Color;
use crate::cli::common::output::{Store, Stored, Target, folder_of, stem};
use crate::cli::common::progress::{FileProgress, Stage};
use crate::cli::common::report::{MeshOutput, SKIPPED};
use crate::cli::common::run_batch::{Recorded, Shared, run_batch};
use crate::cli::usage::refused;
use crease::io::{self, Format, Loaded, MeshCompression, ReadLog, ReadOptions, Written};
use crease::mesh::Movement;
use crease::pipeline::{self, Task};
use std::path::{Path, PathBuf};
use std::sync::atomic::{AtomicUsize, Ordering};
use std::time::Instant;

pub fn main(args: &NormalsArgs, color: Color) -> Exit {
    let console = Console::new(&args.run, color, args.output.output.as_deref());
    let prepared = request::jobs(args)
        .and_then(|jobs| Ok((jobs, Ledger::open(&args.batch, args.output.dry_run, args.output.sync)?)));
    let (jobs, ledger) = match prepared {
        Ok(prepared) => prepared,
        Err(failure) => return refused("normals", &failure, &console),
    };
    args.run.use_threads();
    let store = Store::new(args.output.sync, args.output.dry_run);
    let work = |job, shared: &Shared<'_>| one(job, &store, shared);
    run_batch(&console, &args.batch, &ledger, &jobs, source, work, |_, mut report: Report, batch| {
        batch.count(&report.input.path, &report.head);
        if report.head.error.is_some() {
            report.output = None;
        }
        print(&report, jobs.len(), &console);
    })
}

fn source(job: &Job) -> (&Source, Option<Format>) {
    (&job.input.source, job.format)
}

/// Does one job unless an earlier run has, and records it.
fn one<'a>(job: &'a Job, store: &Store, shared: &Shared<'_>) -> Recorded<Report<'a>> {
    let mut report = Report::new(job);
    let start = Instant::now();
    let work = work(job);
    let mut before = shared.ledger.done_before(&work);
    if before.as_ref().is_some_and(|entry| entry.written.len() > 1) {
        // An input before this one may have replaced a companion.
        shared.turn.wait();
        before = shared.ledger.done_before(&work);
    }
    if let Some(entry) = before {
        store.keep(entry.written.into_keys());
        report.head.status = SKIPPED;
        return Recorded::skipped(report);
    }
    let log = ReadLog::default();
    let read = ReadOptions { log: log.clone(), ..job.settings.read.clone() };
    let done = shared.ledger.retried(&job.input.source, || {
        report = Report::new(job);
        guarded(|| run(job, &read, store, shared, &mut report))
    });
    report.seconds.total = start.elapsed().as_secs_f64();
    report.head.record(&done);
    let faults = report.parts.iter().flat_map(|part| part.outcome.faults.corners.values());
    let outcome = Outcome {
        bytes: report.input.bytes.unwrap_or_default(),
        error: done.as_ref().err(),
        read: log.files().into_iter().collect(),
        written: done.as_ref().ok().cloned().unwrap_or_default(),
        faults: faults.sum::<usize>() as u64,
        seconds: report.seconds.total,
        ..Outcome::default()
    };
    let journal = shared.ledger.record(&work, outcome);
    Recorded { report, has_failed: done.is_err(), journal }
}

/// The work of a job, with all options that affect its result.
fn work(job: &Job) -> Work<'_> {
    let Settings { args, task, read, write, merge_distance, .. } = &*job.settings;
    // Edges are counted for reports only.
    let task = Task { edge_counts: false, ..task.clone() };
    let mesh = (args.mesh.up, args.mesh.scale, merge_distance);
    let reading = (&read.root, read.non_finite, &read.allowed_extensions);
    Work {
        verb: "normals",
        input: &job.input,
        output: job.target.as_ref().map(Target::name),
        options: format!("{:?}", (task, write, mesh, reading, job.format, job.to)),
    }
}

fn print(report: &Report, jobs: usize, console: &Console) {
    if let Some(error) = &report.head.error {
        // The message itself names outputs.
        console.error(&format!("{}: {}", escaped(&report.input.path), error.message));
    }
    let brief = jobs > 1 && console.verbosity < Verbosity::Verbose;
    console.print(report, || {
        console.notes(&report.input.path, &report.notes, brief);
        match brief {
            _ if report.head.error.is_some() => String::new(),
            _ if report.head.status == SKIPPED => skipped(&report.input.path),
            true => text::line(report, console.report_style),
            false => text::block(report, console),
        }
    });
}

/// Carries out one job: read, compute, write, store. The report contains the results up to the first error. Returns the files that
/// were written.
fn run(
    job: &Job,
    read: &ReadOptions,
    store: &Store,
    shared: &Shared<'_>,
    report: &mut Report<'_>,
) -> Result<Vec<PathBuf>, Failure> {
    let (settings, progress) = (&*job.settings, shared.progress);
    progress.stage(Stage::Read);
    let start = Instant::now();
    let mut loaded = progress.read(&job.input.source, job.format, read, &mut report.input.bytes)?;
    report.seconds.read = start.elapsed().as_secs_f64();
    report.input.format = Some(loaded.format);
    report.notes.extend_from_slice(&loaded.notes);

    progress.stage(Stage::Compute);
    let start = Instant::now();
    let target = (!job.rows).then(|| job.to.unwrap_or(loaded.format));
    if target == Some(Format::ThreeMf) {
        return Err(Failure::usage("3MF has no normals\nhelp: choose another format with --to, such as glb"));
    }
    if let Some(target) =
        target.filter(|&target| settings.write.compression != MeshCompression::None && target != Format::Glb)
    {
        return Err(Failure::usage(format!(
            "--compress meshopt needs a GLB, but the output is {target}\nhelp: name an output that ends in .glb, or use --to glb"
        )));
    }
    pipeline::forget_unused(&mut loaded, &settings.task, target);
    let moved = match (settings.merge_distance, target) {
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
        Some(target) => conversion(&settings.args.mesh, loaded.format, target)?,
        None => None,
    };
    report.notes.extend(target.and_then(|to| axes_note(conversion.as_ref(), loaded.format, to)));
    let revision = compute(&loaded, settings, target, progress);
    report.seconds.compute = start.elapsed().as_secs_f64();
    let parts = revision.parts.into_iter().zip(&revision.edits);
    report.parts = parts.map(|(part, edit)| Part::new(part, job.rows.then_some(edit))).collect();
    let Some(format) = target else { return Ok(Vec::new()) };

    progress.stage(Stage::Write);
    let start = Instant::now();
    let place = place(job);
    let (stem, folder) = (place.and_then(stem), place.map(folder_of));
    let map = conversion.as_ref().map(|conversion| conversion.map).filter(|map| !map.is_identity());
    let options = io::WriteOptions { stem, folder, conversion: map, ..settings.write.clone() };
    let written = io::write(&loaded, revision.edits, format, &options).map_err(Failure::output)?;
    let unchanged = loaded.document.is_unchanged(&written.bytes);
    // A large input takes as long to give back as its output to write.
    rayon::spawn(move || drop(loaded));
    report.notes.extend_from_slice(&written.notes);
    let moved = (moved.vertices > 0).then_some(moved);
    let output = MeshOutput { moved, ..MeshOutput::new(job.target.as_ref(), format, unchanged, &written) };
    report.output = Some(match conversion {
        Some(Conversion { text, .. }) => {
            MeshOutput { matrix: map.map(|map| map.matrix().to_cols_array()), conversion: text, ..output }
        }
        None => output,
    });
    if !written.companions.is_empty() {
        // Of two inputs with different companions of one name, the later one fails.
        shared.turn.wait();
    }
    if settings.task.flip && job.target.as_ref() == Some(&job.input.source) && !unchanged {
        // Flipped twice, the file would be as before. If the run is killed now, the next one finds in the journal whether the file
        // was replaced.
        let read = read.log.files().into_iter().collect();
        let planned = Outcome { read, replacement: Some(&written.bytes), ..Outcome::default() };
        shared.ledger.record(&work(job), planned)?;
    }
    let stored = put(job, store, written, unchanged)?;
    report.notes.extend(stored.notes);
    report.seconds.write = start.elapsed().as_secs_f64();
    Ok(stored.files)
}

fn compute(
    loaded: &Loaded,
    settings: &Settings,
    target: Option<Format>,
    progress: &FileProgress<'_>,
) -> pipeline::Revision {
    let all = loaded.parts.iter().map(|part| part.mesh.face_count()).sum();
    let done = AtomicUsize::new(0);
    pipeline::revise(loaded, &settings.task, target, &|faces| {
        let before = done.fetch_add(faces, Ordering::Relaxed);
        progress.within(Stage::Compute, before + faces, all);
    })
}

/// Where the output will be, for its companion files; `None` for a stream or a device.
fn place(job: &Job) -> Option<&Path> {
    let path = job.target.as_ref().unwrap_or(&job.input.source).path()?;
    let is_device = job.target.is_some() && path.metadata().is_ok_and(|it| !it.is_file() && !it.is_dir());
    (!is_device).then_some(path)
}

/// Stores the output.
fn put(job: &Job, store: &Store, written: Written, unchanged: bool) -> Result<Stored, Failure> {
    let Some(target) = &job.target else { return Ok(Stored::default()) };
    // An unchanged input keeps its modification time too.
    if unchanged && *target == job.input.source && target.path().is_some() {
        return Ok(Stored::default());
    }
    Ok(store.store(written, target)?)
}
