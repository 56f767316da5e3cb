//! The verb `render`: load a scene, change it as asked, draw it, store the picture, tell about it.

mod args;
mod case;
mod contrast;
mod draw;
mod fields;
mod option_effects;
mod report;
mod request;
mod text;
mod turn;
mod unused;
mod values;

pub use args::{INTERPOLATIONS, RenderArgs};

use super::args::Color;
use super::batch::{exit_of, guarded};
use super::console::{Console, Verbosity, escaped};
use super::inputs::Source;
use super::normals::{Failure, read_stdin};
use super::output::Store;
use super::progress::CountProgress;
use super::report::{ErrorReport, NoteReport, json_line};
use super::{Exit, notes, usage_error, use_threads};
use case::{Before, Stage};
use crease::io::{self, ReadError, Written};
use crease::raster::{Image, Object, SceneFile, SceneObject, Shading, Shape, Unseen, load};
use crease::report::{PixelReport, probe_pixel};
use draw::{DrawError, Drawn, Made};
use report::{DrawingReport, OutputReport, Report, SceneReport, SettingsReport};
use request::{Request, Subject};
use std::time::Instant;

/// Carries the verb out.
pub fn main(args: &RenderArgs, color: Color) -> Exit {
    let console = Console::new(&args.run, color, args.output.output.as_deref());
    let request = Request::resolve(args).unwrap_or_else(|message| usage_error("render", message));
    use_threads(args.run.threads);
    let mut report = Report::new(&request);
    let start = Instant::now();
    let result = guarded(|| work(&request, &console, &mut report));
    report.seconds.total = start.elapsed().as_secs_f64();
    if let Err(failure) = &result {
        report.fail(ErrorReport::new(failure));
    }
    tell(&report, &console);
    match result {
        Err(failure) => exit_of(&failure),
        Ok(()) if !console.has_reported() => Exit::OutputFailed,
        Ok(()) => Exit::Done,
    }
}

fn work(request: &Request, console: &Console, report: &mut Report) -> Result<(), Failure> {
    let start = Instant::now();
    let mut file = read(request).map_err(Failure::Read)?;
    if !request.has_places() {
        let moved = file.recentre();
        file.notes.extend(moved);
    }
    report.notes.extend(file.notes.iter().map(NoteReport::new));
    let before = Before::of(&file);
    request.change(&mut file)?;
    let stage = Stage::new(request.args, &file, &before);
    report.notes.extend(unused::notes(request, &stage));
    report.notes.extend(gains(&stage));
    report.scene = Some(SceneReport::new(&file, &file.scene()));
    report.settings = Some(SettingsReport::new(&file.settings));
    report.seconds.load = start.elapsed().as_secs_f64();

    let start = Instant::now();
    let frames = match request.subject {
        // Without a file each is drawn once.
        Subject::Turntable(frames) if request.target.is_none() => frames.into(),
        Subject::Turntable(frames) => draw::turn_of(frames).drawings(file.settings.size),
        _ => 1,
    };
    let progress = CountProgress::new(console, "drawing", "frames", frames as u64);
    let drawn = draw::draw(&mut file, request, &progress).map_err(|error| match error {
        DrawError::Render(error) => {
            let lights = file.lights.as_ref().map_or(0, Vec::len);
            let typed = request.blame(&error, lights).map(Failure::Usage);
            typed.unwrap_or_else(|| Failure::Draw(error.to_string()))
        }
        DrawError::Report(error) => Failure::Write(error.to_string()),
        DrawError::Store(error) => Failure::Write(format!("{error:#}")),
    })?;
    drop(progress);
    report.drawings = drawn.drawings.iter().map(DrawingReport::new).collect();
    if let (Some(pixel), Some(image)) = (request.args.output.probe, &drawn.image) {
        report.probe = Some(probe(&file, image, pixel).map_err(Failure::Draw)?);
    }
    report.notes.extend(unseen(&file, &drawn, request));
    report.seconds.draw = start.elapsed().as_secs_f64();

    let Some(target) = &request.target else { return Ok(()) };
    let start = Instant::now();
    report.output = Some(OutputReport::new(target, request.file, &drawn));
    let Made::Bytes(bytes) = drawn.made else { return Ok(()) };
    let written = Written { bytes, ..Written::default() };
    Store::new(false, false).store(written, target).map_err(|error| Failure::Write(format!("{error:#}")))?;
    report.seconds.write = start.elapsed().as_secs_f64();
    Ok(())
}

fn read(request: &Request) -> Result<SceneFile, ReadError> {
    match &request.source {
        Source::File(path) => load(path, request.format, &request.load),
        Source::Stdin => {
            let bytes = read_stdin(&request.load.read.limits, |_| ())?;
            let loaded = io::read_bytes(bytes, request.format, None, &request.load.read)?;
            SceneFile::from_loaded(loaded, &request.load)
        }
    }
}

/// A warning for each object that reflects more light than it gets, where light is shown.
fn gains(stage: &Stage) -> Vec<NoteReport> {
    let objects = &stage.file.objects;
    let mut is_lit = vec![false; objects.len()];
    for (case, number) in stage.cases().iter().zip((0..objects.len()).cycle()) {
        is_lit[number] |= case.is_lit();
    }
    let lit = objects.iter().enumerate().filter(|&(number, _)| is_lit[number]);
    let warn = |(number, object): (usize, &SceneObject)| {
        let gain = object.material.gain()?;
        Some(NoteReport::warning(format!("object {}: {gain}", number + 1)))
    };
    lit.filter_map(warn).collect()
}

/// What is not seen, and why: an empty picture may be what was asked for, so it is no error.
fn unseen(file: &SceneFile, drawn: &Drawn, request: &Request) -> Option<NoteReport> {
    let scene = file.scene();
    let is_solid = |object: &Object| matches!(object.shape, Shape::Surface(_));
    let is_empty = drawn.drawings.iter().all(|drawing| drawing.statistics.covered_pixels == 0);
    let wants_edges = file.settings.shading == Shading::Wireframe || !request.args.shading.overlay.is_empty();
    let text = match scene.unseen(&file.settings) {
        Some(cause) if is_empty || cause == Unseen::NoEdges => {
            format!("nothing is seen: {cause}{}", advice(cause))
        }
        _ if wants_edges && scene.objects.iter().any(is_solid) => {
            format!("lines of some objects are missing: {}", Unseen::NoEdges)
        }
        _ => return None,
    };
    Some(NoteReport::warning(text))
}

/// What brings something into the picture, where the cause does not say so itself.
fn advice(cause: Unseen) -> &'static str {
    match cause {
        Unseen::NoEdges => "",
        Unseen::Behind | Unseen::Beside | Unseen::Small => "; --camera looks elsewhere",
        Unseen::Culled => "; --cull none leaves out nothing",
        Unseen::NoArea => "; `crease inspect` tells what is wrong with them",
    }
}

fn probe(file: &SceneFile, image: &Image, pixel: [u32; 2]) -> Result<PixelReport, String> {
    let [width, height] = image.size;
    let [x, y] = pixel;
    let Some(shown) = image.pixel(x, y) else {
        return Err(format!("pixel ({x}, {y}) is outside the picture of {width}x{height} pixels"));
    };
    let mut report =
        probe_pixel(&file.scene(), &file.settings, pixel, shown).map_err(|error| error.to_string())?;
    // Faces are told by their numbers in the file.
    for seen in report.samples.iter_mut().filter_map(|sample| sample.seen.as_mut()) {
        if let (Some(face), Some(mesh)) = (seen.face, file.mesh_of(seen.object)) {
            seen.face = Some(mesh.source_faces.as_ref().map_or(face, |faces| faces[face as usize]));
        }
    }
    Ok(report)
}

fn tell(report: &Report, console: &Console) {
    if let Some(error) = &report.head.error {
        match error.kind {
            // It is not the file's fault.
            "usage" => console.error(&error.message),
            _ => console.error(&format!("{}: {}", escaped(&report.input.path), error.message)),
        }
    }
    if console.json {
        console.report(&json_line(report));
        return;
    }
    if console.verbosity > Verbosity::Quiet {
        notes::print(&report.input.path, &report.notes, false, console);
        if report.head.error.is_none() && report.probe.is_none() {
            console.report(&text::block(report, console.report_style()));
        }
    }
    // What was asked for is told however quiet it should be.
    if let Some(probe) = &report.probe {
        console.report(&probe.to_string());
    }
}
