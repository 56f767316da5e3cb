//! Runs `crease render`: load a scene, change it, draw it, store the picture.

use super::args::RenderArgs;
use super::changes::change;
use super::draw::{Drawing, draw, fit_deviation, turn_of};
use super::report::{PictureReport, Report, SceneReport, Settings, block};
use super::request::{Request, Subject};
use super::warnings;
use crate::cli::common::console::{Console, HELP, escaped, push_wrapped};
use crate::cli::common::failure::{Exit, Failure, FailureKind, exit_code, guarded};
use crate::cli::common::input::Source;
use crate::cli::common::options::Color;
use crate::cli::common::progress::Progress;
use crate::cli::usage::usage_error;
use crease::io::{Note, Place, ReadError};
use crease::num::{Degrees, three_digits};
use crease::raster::{Image, Object, Projection, RenderScratch, SceneFile, Shading, Shape, Unseen, load};
use crease::report::{PixelReport, probe_pixel};
use glam::DVec3;
use std::time::Instant;

pub fn main(args: &RenderArgs, color: Color) -> Exit {
    let console = Console::new(&args.run, color, args.output.output.as_deref());
    if args.scene.scene_help {
        console.report(&scene_help(include_str!("../../../docs/scenes.md")));
        return exit_code(Ok(Exit::Done), &console);
    }
    if args.batch.journal.is_some() || args.batch.shard.is_some() || args.batch.jobs > 1 {
        usage_error("render", "--journal, --shard and --jobs are for the inputs of --manifest");
    }
    let request = Request::resolve(args).unwrap_or_else(|message| usage_error("render", message));
    args.run.use_threads();
    let mut report = Report::new(&request);
    let start = Instant::now();
    let result = guarded(|| run(&request, Some(&console), &mut report));
    report.seconds.total = start.elapsed().as_secs_f64();
    report.head.record(&result);
    if result.is_err() {
        report.output = None;
    }
    print(&report, &request, &console);
    exit_code(result, &console)
}

/// The page of scene files for a terminal of 100 columns: table rows become a line of keys and an indented line of meaning.
fn scene_help(page: &str) -> String {
    let page = without_links(page);
    let (mut out, mut is_code) = (String::new(), false);
    let is_rule = |line: &str| line.starts_with("|---");
    let mut lines = page.lines().peekable();
    let mut headers: Vec<&str> = Vec::new();
    while let Some(line) = lines.next() {
        is_code ^= line.starts_with("```");
        let row = line.strip_prefix("| ").and_then(|row| row.strip_suffix('|'));
        match row {
            _ if is_rule(line) => {}
            Some(row) if lines.peek().is_some_and(|next| is_rule(next)) => headers = cells(row).collect(),
            Some(row) => {
                let mut named: Vec<(&str, &str)> = cells(row).zip(headers.iter().copied()).collect();
                let (meaning, _) = named.pop().unwrap_or_default();
                let keys = named.into_iter().filter(|(cell, _)| !cell.is_empty()).map(|(cell, header)| {
                    let is_default = header == "default" && !cell.starts_with("required");
                    if is_default { format!("[default: {cell}]") } else { cell.to_owned() }
                });
                let keys: Vec<String> = keys.collect();
                push_wrapped(&mut out, &keys.join("  "), ["  "; 2]);
                if !meaning.is_empty() {
                    push_wrapped(&mut out, meaning, ["      "; 2]);
                }
            }
            None if is_code || line.is_empty() => out.extend([line, "\n"]),
            None => {
                let mut text = line.to_owned();
                while let Some(next) = lines
                    .next_if(|next| !next.is_empty() && !next.starts_with("- ") && !next.starts_with("```"))
                {
                    text.extend([" ", next.trim_start()]);
                }
                push_wrapped(&mut out, &text, if line.starts_with("- ") { ["", "  "] } else { ["", ""] });
            }
        }
    }
    out
}

/// The cells of a row of a table.
fn cells(row: &str) -> impl Iterator<Item = &str> {
    row.split(" |").map(str::trim)
}

/// A text with the words of links only.
fn without_links(text: &str) -> String {
    match text.split_once("](") {
        Some((before, after)) => {
            let after = after.split_once(')').map_or("", |(_, after)| after);
            let (text, label) = before.rsplit_once('[').unwrap_or((before, ""));
            format!("{text}{label}{}", without_links(after))
        }
        None => text.to_owned(),
    }
}

/// Loads, draws and stores. Frames have a bar of their own if there is a console.
pub fn run(request: &Request, console: Option<&Console>, report: &mut Report) -> Result<Exit, Failure> {
    let start = Instant::now();
    let mut file = read(request)?;
    if !request.has_places() {
        let moved = file.recentre();
        file.notes.extend(moved);
    }
    report.notes.append(&mut file.notes);
    change(request, &mut file)?;
    fit_deviation(&mut file, request)?;
    report.notes.extend(warnings::notes(request, &file));
    report.scene = Some(SceneReport::new(&file));
    report.settings = Some(Settings(file.settings));
    report.seconds.load = start.elapsed().as_secs_f64();

    let start = Instant::now();
    let frames = match request.subject {
        // Without a file each is drawn once.
        Subject::Turntable(frames) if request.target.is_none() => frames.into(),
        Subject::Turntable(frames) => turn_of(frames).drawings(file.settings.size),
        _ => 1,
    };
    let progress = console.map_or_else(Progress::hidden, |console| {
        Progress::of_count(console, "drawing", "frames", frames as u64)
    });
    let drawn = draw(&mut file, request, &progress, &mut RenderScratch::default())?;
    drop(progress);
    report.drawings = drawn.drawings;
    if let (Some(pixel), Some(image)) = (request.args.output.probe, &drawn.image) {
        report.probe = Some(probe(&file, image, pixel).map_err(Failure::input)?);
    }
    report.notes.extend(unseen(&file, &report.drawings, request));
    report.notes.extend(cut_light(&file, &report.drawings));
    report.seconds.draw = start.elapsed().as_secs_f64();

    let start = Instant::now();
    if let Some(target) = &request.target {
        report.output = Some(PictureReport::new(target, request.file, drawn.size, drawn.length));
        if let Some(bytes) = drawn.bytes {
            target.store(bytes)?;
            report.seconds.write = start.elapsed().as_secs_f64();
        }
    }
    Ok(Exit::Done)
}

fn read(request: &Request) -> Result<SceneFile, ReadError> {
    match &request.source {
        Source::File(path) => load(path, request.format, &request.load),
        Source::Standard => {
            let loaded = request.source.read(request.format, &request.load.read, |_| ())?;
            SceneFile::from_loaded(loaded, &request.load)
        }
    }
}

/// A warning about what is not visible, and why. An empty picture may be intended, so it is no error.
fn unseen(file: &SceneFile, drawings: &[Drawing], request: &Request) -> Option<Note> {
    let scene = file.scene();
    let is_solid = |object: &Object| matches!(object.shape, Shape::Surface(_));
    let is_empty = drawings.iter().all(|drawing| drawing.statistics.covered_pixels == 0);
    let wants_edges = file.settings.shading == Shading::Wireframe || !request.args.shading.overlay.is_empty();
    let text = match scene.unseen(&file.settings) {
        Some(cause) if is_empty || cause == Unseen::NoEdges => {
            format!("nothing is visible: {cause}{}", advice(cause, file))
        }
        _ if wants_edges && scene.objects.iter().any(is_solid) => {
            format!("lines of some objects are missing: {}", Unseen::NoEdges)
        }
        _ => small(file, drawings)?,
    };
    Some(Note::warning(Place::File, text))
}

/// The share of the light that limits of rays may cut off without a note.
const CUT: f64 = 1e-3;

/// A note about light that the limits of rays cut off.
fn cut_light(file: &SceneFile, drawings: &[Drawing]) -> Option<Note> {
    let largest = drawings.iter().map(|drawing| drawing.statistics.light_cut).fold(0.0, f64::max);
    let limits = &file.settings.tracing;
    (largest > CUT).then(|| {
        let (percent, depth, weight) = (three_digits(100.0 * largest), limits.depth, limits.weight);
        let text = format!(
            "the limits of rays cut off up to {percent} % of the light (limit 0.1 %): a larger `ray-depth` than {depth}, or a \
             smaller `ray-weight` than {weight}, in the settings of a scene file follows more rays"
        );
        Note::warning(Place::File, text)
    })
}

/// The share of the picture below which objects are easily overlooked.
const SMALL: f64 = 0.01;

/// A warning if objects cover hardly anything of any drawing, with a camera that frames them.
fn small(file: &SceneFile, drawings: &[Drawing]) -> Option<String> {
    let [width, height] = file.settings.size.map(f64::from);
    let largest = drawings.iter().map(|drawing| drawing.statistics.covered_pixels).max()?;
    let share = largest as f64 / (width * height);
    if share >= SMALL || file.settings.shading == Shading::Wireframe {
        return None;
    }
    let percent = match 100.0 * share {
        ..0.001 => "less than 0.001".to_owned(),
        percent => format!("only {}", three_digits(percent)),
    };
    Some(format!("the objects cover {percent} % of the picture{HELP}{} frames them", framing_camera(file)?))
}

/// The option with a camera that frames all objects of a scene; `None` for a scene without extent.
fn framing_camera(file: &SceneFile) -> Option<String> {
    let [width, height] = file.settings.size.map(f64::from);
    let camera = file.scene().framing(width / height)?;
    let distance = camera.eye.distance(camera.target);
    let vector = |at: DVec3| at.to_array().map(|x| rounded_to(x, distance)).join(",");
    let (eye, target) = (vector(camera.eye), vector(camera.target));
    let angle = match camera.projection {
        Projection::Perspective(angle) => format!(" angle={}", three_digits(Degrees::from(angle).0)),
        Projection::Orthographic(_) => String::new(),
    };
    Some(format!("--camera 'eye={eye} target={target}{angle}'"))
}

/// A coordinate with the digits that matter at a distance: to a thousandth of its power of ten.
fn rounded_to(x: f64, distance: f64) -> String {
    let exponent = format!("{distance:e}").split_once('e').and_then(|(_, digits)| digits.parse().ok());
    let decimals = 3 - exponent.unwrap_or(0_i32);
    if decimals > 12 {
        return if x.abs() < 1e-3 * distance { "0".to_owned() } else { three_digits(x) };
    }
    let decimals = decimals.max(0) as usize;
    let text = format!("{x:.decimals$}");
    let text = if decimals > 0 { text.trim_end_matches('0').trim_end_matches('.') } else { &text };
    if text == "-0" { "0".to_owned() } else { text.to_owned() }
}

/// What brings something into the picture, if the cause does not say so itself.
fn advice(cause: Unseen, file: &SceneFile) -> String {
    match cause {
        Unseen::NoEdges => String::new(),
        Unseen::Behind | Unseen::OutsidePicture | Unseen::Small => match framing_camera(file) {
            Some(camera) => format!("{HELP}{camera} frames the objects"),
            None => format!("{HELP}move it with --camera"),
        },
        Unseen::Culled => format!("{HELP}--cull none draws all faces"),
        Unseen::NoArea => format!("{HELP}`crease inspect` reports what is wrong with them"),
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
    // Faces have their numbers in the file.
    for seen in report.samples.iter_mut().filter_map(|sample| sample.seen.as_mut()) {
        if let (Some(face), Some(mesh)) = (seen.face, file.mesh_of(seen.object)) {
            seen.face = Some(mesh.source_faces.as_ref().map_or(face, |faces| faces[face as usize]));
        }
    }
    Ok(report)
}

pub fn print(report: &Report, request: &Request, console: &Console) {
    if let Some(error) = &report.head.error {
        let path = escaped(&report.input.path);
        let help = match error.message.contains(HELP) {
            true => "; ",
            false => HELP,
        };
        match error.kind {
            // Not a fault of the file.
            FailureKind::Usage => console.error(&error.message),
            _ if request.has_settings() => {
                let keys = "`crease render --scene-help` lists the keys of scene files";
                console.error(&format!("{path}: {}{help}{keys}", error.message));
            }
            _ => console.error(&format!("{path}: {}", error.message)),
        }
    }
    console.print(report, || {
        console.notes(&report.input.path, &report.notes, false);
        let has_block = report.head.error.is_none() && report.probe.is_none();
        if has_block { block(report, console.report_style) } else { String::new() }
    });
    // A probe is printed even under --quiet.
    if let Some(probe) = report.probe.as_ref().filter(|_| !console.json) {
        console.report(&probe.to_string());
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn coordinates_have_the_digits_that_matter_at_their_distance() {
        for (x, distance, expected) in [
            (1.07e-4, 5.0, "0"),
            (-9.3e-5, 10.3, "0"),
            (1.25, 4.0, "1.25"),
            // Far from the origin.
            (-123456.789, 4.0, "-123456.789"),
            (2.5e7, 3e6, "25000000"),
            (1.5e-20, 4e-20, "1.50e-20"),
            (1e-24, 4e-20, "0"),
        ] {
            assert_eq!(rounded_to(x, distance), expected, "{x} at {distance}");
        }
    }
}
