//! The verb `normals` on one input: read, compute, write, store.

use super::inputs::Source;
use super::output::{Store, folder_of, replaced_note};
use super::progress::{FileProgress, Stage};
use super::report::{OutputReport, PartReport, Report};
use super::request::{Job, Request, Target};
use crease::io::{self, Format, Limits, Loaded, Note, Place, Problem, ReadError, ReadOptions, Written};
use crease::pipeline;
use std::io::{IsTerminal, Read};
use std::path::Path;
use std::sync::atomic::{AtomicUsize, Ordering};
use std::time::Instant;

/// Why an input was not done.
#[derive(Debug)]
pub enum Failure {
    Read(ReadError),
    /// What was typed makes no sense with this input.
    Usage(String),
    /// The input was read, but there is nothing in it to draw or to measure, or it cannot be.
    Draw(String),
    Write(String),
    /// A fault of this program.
    Internal(String),
}

impl Failure {
    /// That a file cannot be read, with its name, where the command line may name several.
    pub fn read_of(path: &str, error: ReadError) -> Self {
        let found = match error.place {
            Place::File => format!("{path}: {}", error.found),
            _ => format!("in {path}: {}", error.found),
        };
        Failure::Read(ReadError { found, ..error })
    }
}

/// Carries out one job and writes down in the report what happened, as far as it went.
pub fn run(
    job: &Job,
    request: &Request,
    store: &mut Store,
    progress: &FileProgress<'_>,
    report: &mut Report,
) -> Result<(), Failure> {
    progress.stage(Stage::Read);
    let start = Instant::now();
    let loaded = load(job, &request.read, progress, &mut report.input.bytes).map_err(Failure::Read)?;
    report.seconds.read = start.elapsed().as_secs_f64();
    report.input.format = Some(loaded.format.extension());
    report.add_notes(&loaded.notes);

    progress.stage(Stage::Compute);
    let start = Instant::now();
    let target = (!request.rows).then(|| job.to.unwrap_or(loaded.format));
    let revision = compute(&loaded, request, target, progress);
    report.seconds.compute = start.elapsed().as_secs_f64();
    report.parts = revision.parts.iter().map(PartReport::new).collect();
    if request.rows {
        report.add_rows(&revision.edits);
    }
    let Some(format) = target else { return Ok(()) };

    progress.stage(Stage::Write);
    let start = Instant::now();
    let (stem, folder) = place(job).map(|path| (stem(path), folder_of(path))).unzip();
    let options = io::WriteOptions { stem, folder, ..request.write.clone() };
    let written = io::write(&loaded, revision.edits, format, &options)
        .map_err(|error| Failure::Write(error.to_string()))?;
    let unchanged = loaded.document.is_unchanged(&written.bytes);
    // A large input takes as long to give back as its output to write.
    rayon::spawn(move || drop(loaded));
    report.add_notes(&written.notes);
    report.output = Some(OutputReport::new(job.target.as_ref(), format, unchanged, &written));
    let replaced = put(job, store, written, unchanged)?;
    report.add_notes(&replaced);
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

/// Reads a job's input and tells how many bytes it has.
pub fn load(
    job: &Job,
    options: &ReadOptions,
    progress: &FileProgress<'_>,
    length: &mut Option<u64>,
) -> Result<Loaded, ReadError> {
    match &job.source {
        Source::File(path) => {
            *length = path.metadata().ok().map(|metadata| metadata.len());
            io::read(path, job.format, options)
        }
        Source::Stdin => {
            let bytes = read_stdin(&options.limits, |bytes| progress.came(bytes))?;
            *length = Some(bytes.len() as u64);
            io::read_bytes(bytes, job.format, None, options)
        }
    }
}

/// All of standard input; `came` is told of every piece.
pub fn read_stdin(limits: &Limits, came: impl Fn(u64)) -> Result<Vec<u8>, ReadError> {
    /// Bytes that make a piece.
    const PIECE: u64 = 1 << 20;
    let mut stdin = std::io::stdin().lock();
    let fail = |problem, found: String, advice: &str| ReadError::new(problem, Place::File, found, advice);
    if stdin.is_terminal() {
        return Err(fail(
            Problem::Io,
            "standard input is a terminal".into(),
            "pipe a file into it, or name one",
        ));
    }
    let mut bytes = Vec::new();
    while bytes.len() as u64 <= limits.bytes {
        let read = stdin.by_ref().take(PIECE).read_to_end(&mut bytes);
        match read {
            Ok(0) => return Ok(bytes),
            Ok(more) => came(more as u64),
            Err(error) => {
                let advice = "check the command before the pipe";
                return Err(fail(Problem::Io, format!("could not read standard input: {error}"), advice));
            }
        }
    }
    let found = format!("standard input has more than {} bytes", limits.bytes);
    Err(fail(Problem::Limit, found, "split it"))
}

/// Where the output will be, for files that stand beside it; `None` for a stream or a device.
fn place(job: &Job) -> Option<&Path> {
    match (&job.target, &job.source) {
        (Some(Target::File(path)), _) if path.metadata().is_ok_and(|it| !it.is_file() && !it.is_dir()) => {
            None
        }
        (Some(Target::File(path)), _) | (None, Source::File(path)) => Some(path),
        _ => None,
    }
}

fn stem(path: &Path) -> String {
    path.file_stem().map(|stem| stem.to_string_lossy().into_owned()).unwrap_or_default()
}

/// Stores the output and tells which other files it replaces beside it.
fn put(job: &Job, store: &mut Store, written: Written, unchanged: bool) -> Result<Vec<Note>, Failure> {
    let Some(target) = &job.target else { return Ok(Vec::new()) };
    // An input that stays as it is keeps its time of change too.
    let is_itself = matches!((target, &job.source), (Target::File(a), Source::File(b)) if a == b);
    if unchanged && is_itself {
        return Ok(Vec::new());
    }
    let replaced = store.store(written, target).map_err(|error| Failure::Write(format!("{error:#}")))?;
    Ok(replaced.iter().map(|path| replaced_note(path)).collect())
}
