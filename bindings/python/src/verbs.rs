//! Diagnosis, pictures, plans, and the program as a whole.

use crate::arrays::wrong;
use crate::cli;
use crate::cli::args::Verb;
use crate::cli::common::command_line;
use crate::cli::common::console::Console;
use crate::cli::common::failure::Failure;
use crate::cli::common::input::{Input, Source};
use crate::cli::common::options::Color;
use crate::cli::common::progress::Progress;
use crate::cli::inspect::json::InspectReport;
use crate::cli::inspect::run::keep_wanted;
use crate::cli::normals::request::jobs_of;
use crate::cli::plan::args::Reference;
use crate::cli::render::{changes, draw, request};
use crate::command_line::{Line, parse};
use crate::errors::{failure, usage};
use crate::threads::{Stop, ThreadCount, interruptible};
use crease::io;
use crease::plan::{PlanError, most_accurate, scene_text, with_size};
use crease::quality::diagnose;
use crease::raster::{Image, LoadOptions, Pixels, RenderScratch, load};
use numpy::{PyArray1, PyArrayMethods};
use pyo3::prelude::*;
use pyo3::types::PyDict;
use std::ffi::OsString;
use std::path::{Path, PathBuf};

/// The diagnosis of a file as JSON, as `crease inspect --json` prints it, without times.
#[pyfunction]
#[pyo3(signature = (path, threads=None, options=None))]
pub fn inspect(
    py: Python<'_>,
    path: PathBuf,
    threads: Option<ThreadCount>,
    options: Option<&Bound<'_, PyDict>>,
) -> PyResult<String> {
    let line = Line::new("inspect", &path, options)?;
    let file = path.clone();
    let report = interruptible(py, threads, move |stop| diagnosis(&file, &line, stop))?;
    report.map_err(|error| failure(py, &path, error))
}

fn diagnosis(path: &Path, line: &Line, stop: &Stop) -> Result<String, Failure> {
    let Verb::Inspect(args) = line.parse().map_err(Failure::usage)? else {
        unreachable!("the verb is inspect")
    };
    let loaded = io::read(path, args.format, &args.companions.read_options(false))?.without_source();
    let thresholds = args.thresholds.resolve(args.findings.places);
    let mut diagnosis = diagnose(&loaded, &thresholds, &|_| stop.check());
    let mut report = InspectReport::new(&Source::File(path.to_path_buf()));
    report.input.format = Some(loaded.format);
    let name = path.file_stem().unwrap_or_default().to_string_lossy();
    report.fix_as = format!("{name}-fixed.{}", loaded.format.extension());
    let (wanted, names) = (&args.findings, [&*report.input.path, &*report.fix_as]);
    report.fix = diagnosis.fix(|finding| wanted.takes(finding), wanted.names_notes(), names);
    report.hidden = keep_wanted(&mut diagnosis, wanted);
    report.fill(&diagnosis);
    serde_json::to_string(&report).map_err(Failure::output)
}

/// Draws a mesh file or a scene file.
///
/// Parameters
/// ----------
/// path : str or path
///     OBJ, PLY, STL, glTF, GLB or 3MF, or a scene in TOML.
/// size : (int, int), optional
///     Width and height in pixels; default: that of the scene, else 640 x 480.
/// shading : str, optional
///     "flat", "gouraud", "phong" and others; default: that of the scene, else "phong".
/// threads : int, optional
/// **options
///     The options of `crease render`, with underscores. A tuple is a vector or a colour, a list repeats an option, a dictionary has
///     fields: camera={"eye": (3, 2, 4), "target": (0, 0, 0)}, light=["directional towards=1,1,1"], samples=4, weight="area",
///     crease=30, background="#ffffff", overlay=("wire", "creases"), bits=16. `python -m crease_normals render --help` describes them.
///
/// Returns
/// -------
/// array (height, width, 3) of uint8
///     Red, green, blue, row by row from the top; sRGB unless the scene or `transfer` states another curve. uint16 with bits=16.
///
/// Raises
/// ------
/// ReadError
///     The file cannot be read or drawn.
/// ValueError
///     An unknown option or value.
#[pyfunction]
#[pyo3(signature = (path, *, threads=None, **options), text_signature = "(path, *, size=None, shading=None, threads=None, **options)")]
pub fn render<'py>(
    py: Python<'py>,
    path: PathBuf,
    threads: Option<ThreadCount>,
    options: Option<&Bound<'py, PyDict>>,
) -> PyResult<Bound<'py, PyAny>> {
    let line = Line::new("render", &path, options)?;
    let file = path.clone();
    let image = interruptible(py, threads, move |stop| picture(&file, &line, stop))?;
    let image = image.map_err(|error| failure(py, &path, error))?;
    let [width, height] = image.size.map(|side| side as usize);
    let shape = [height, width, 3];
    match image.pixels {
        Pixels::Eight(pixels) => {
            Ok(PyArray1::from_vec(py, pixels.into_flattened()).reshape(shape)?.into_any())
        }
        Pixels::Sixteen(pixels) => {
            Ok(PyArray1::from_vec(py, pixels.into_flattened()).reshape(shape)?.into_any())
        }
    }
}

fn picture(path: &Path, line: &Line, stop: &Stop) -> Result<Image, Failure> {
    let Verb::Render(args) = line.parse().map_err(Failure::usage)? else {
        unreachable!("the verb is render")
    };
    let request = request::Request::resolve(&args).map_err(Failure::usage)?;
    let mut file = load(path, request.format, &request.load)?;
    if !request.has_places() {
        file.recentre();
    }
    stop.check();
    changes::change(&request, &mut file)?;
    stop.check();
    let console = Console::new(&args.run, Color::Never, None);
    let progress = Progress::of_count(&console, "drawing", "frames", 1);
    let mut scratch = RenderScratch::observed({
        let stop = stop.clone();
        move || stop.check()
    });
    let drawn = draw::draw(&mut file, &request, &progress, &mut scratch)?;
    drawn.image.ok_or_else(|| Failure::usage("this draws no single picture"))
}

/// The plan of a scene: its text, and its report as JSON.
#[pyfunction]
#[pyo3(signature = (path, threads=None, options=None))]
pub fn plan(
    py: Python<'_>,
    path: PathBuf,
    threads: Option<ThreadCount>,
    options: Option<&Bound<'_, PyDict>>,
) -> PyResult<(String, String)> {
    let line = Line::new("plan", &path, options)?;
    let file = path.clone();
    let plan = interruptible(py, threads, move |stop| planned(&file, &line, stop))?;
    plan.map_err(|error| failure(py, &path, error))
}

fn planned(path: &Path, line: &Line, stop: &Stop) -> Result<(String, String), Failure> {
    let Verb::Plan(args) = line.parse().map_err(Failure::usage)? else { unreachable!("the verb is plan") };
    if args.apply.is_some() || args.picture.is_some() {
        return Err(Failure::usage(
            "apply and picture write files\nhelp: use the program for it: python -m crease_normals plan",
        ));
    }
    let options = args.options().map_err(Failure::usage)?;
    let loading = LoadOptions::default();
    let mut text = scene_text(path, &loading)?;
    if let Some(size) = args.size {
        text = with_size(&text, size).map_err(Failure::input)?;
    }
    if args.reference == Reference::Accurate {
        text = most_accurate(&text).map_err(Failure::input)?;
    }
    let base = path.parent().unwrap_or(path);
    let plan = crease::plan::plan(&text, base, &loading, &options, &|_| stop.check());
    let plan = plan.map_err(|error| match error {
        PlanError::Read(error) => error.into(),
        error => Failure::advised(error),
    })?;
    let report = serde_json::to_string(&plan).map_err(Failure::output)?;
    Ok((plan.text, report))
}

/// Refuses a batch of `crease normals` with wrong options or outputs, before anything is read. A job is its position in the manifest,
/// input, output and options.
#[pyfunction]
pub fn check_batch(
    jobs: Vec<(String, PathBuf, PathBuf, Vec<String>)>,
    options: Vec<OsString>,
) -> PyResult<()> {
    let line = ["crease", "normals", "--manifest", "-"].map(OsString::from).into_iter().chain(options);
    let line: Vec<_> = line.collect();
    command_line::remember(&line);
    let refused = |text: String| usage(&text);
    let Verb::Normals(args) = parse("normals", &line).map_err(refused)? else {
        unreachable!("the verb is normals")
    };
    let input = |(line, input, output, options)| Input {
        place: PathBuf::new(),
        source: Source::File(input),
        output: Some(output),
        options,
        line: Some(line),
    };
    let checked = jobs_of(&args, || Ok(jobs.into_iter().map(input).collect()));
    // The driver has no such option.
    checked.map(drop).map_err(|failure| refused(failure.message.replace(", or use --in-place", "")))
}

/// Runs the program with the words after its name, and returns its exit code.
#[pyfunction]
pub fn program(py: Python<'_>, words: Vec<OsString>) -> PyResult<u8> {
    let line: Vec<OsString> = std::iter::once("crease".into()).chain(words).collect();
    if line.iter().any(|word| word.as_encoded_bytes().contains(&0)) {
        return Err(wrong("an argument has a zero byte"));
    }
    Ok(py.detach(|| cli::program::run(line)) as u8)
}
