//! The verb `trade`: accuracy against speed, measured.

mod args;
mod report;
mod text;

pub use args::TradeArgs;

use super::args::Color;
use super::batch::{exit_of, guarded};
use super::console::{Console, Verbosity, escaped};
use super::normals::{Failure, read_stdin};
use super::output::Store;
use super::output::make_folder;
use super::progress::StepProgress;
use super::report::{ErrorReport, json_line};
use super::request::Target;
use super::{Exit, usage_error, use_threads};
use crease::io::{self, Limits, Loaded, ReadError, ReadOptions, Written};
use crease::mesh::Mesh;
use crease::normals::{Crease, NormalRecipe};
use crease::report::{own_page, trade_page};
use crease::trade::{OwnMesh, Trade};
use report::{Measured, Report};
use std::path::Path;
use std::time::Instant;

/// The name of the page in the folder that was asked for.
const PAGE: &str = "index.html";

/// Carries the verb out.
pub fn main(args: &TradeArgs, color: Color) -> Exit {
    // clap does not ask for an input where --quick or --full exclude one.
    if args.input.is_none() && (args.crease.is_some() || args.format.is_some()) {
        usage_error("trade", "--crease and --format are about an input, and none is given".into());
    }
    let console = Console::new(&args.run, color, None);
    use_threads(args.run.threads);
    let start = Instant::now();
    let mut report = Report::new(args);
    let result = guarded(|| work(args, &console, &mut report));
    report.seconds = start.elapsed().as_secs_f64();
    if let Err(failure) = &result {
        let error = ErrorReport::new(failure);
        match &args.input {
            Some(path) => {
                console.error(&format!("{}: {}", escaped(&path.to_string_lossy()), error.message));
            }
            None => console.error(&error.message),
        }
        report.head.fail(error);
    }
    if console.json {
        console.report(&json_line(&report));
    } else if let Some(measured) = &report.measured
        && console.verbosity > Verbosity::Quiet
        && result.is_ok()
    {
        console.report(&match args.markdown {
            true => text::markdown(measured),
            false => {
                text::text(measured, &report, console.report_style(), console.verbosity == Verbosity::Verbose)
            }
        });
    }
    match result {
        Err(failure) => exit_of(&failure),
        Ok(()) if !console.has_reported() => Exit::OutputFailed,
        Ok(()) => Exit::Done,
    }
}

fn work(args: &TradeArgs, console: &Console, report: &mut Report) -> Result<(), Failure> {
    if let Some(folder) = &args.output {
        make_folder(folder).map_err(|error| Failure::Write(format!("{error:#}")))?;
    }
    let progress = StepProgress::new(console);
    let observe = |step| progress.step(step);
    let (measured, page) = match &args.input {
        Some(path) => {
            let loaded = read(path, args).map_err(Failure::Read)?;
            let meshes: Vec<&Mesh> = loaded.parts.iter().map(|part| &part.mesh).collect();
            if meshes.iter().all(|mesh| mesh.face_count() == 0) {
                let advice = "there is nothing to measure: give a mesh with faces";
                return Err(Failure::Draw(format!("the mesh has no faces; {advice}")));
            }
            let recipe = NormalRecipe {
                crease: args.crease.map_or(Crease::Default, Crease::Angle),
                ..NormalRecipe::default()
            };
            let own = OwnMesh::measure(&meshes, &recipe, &observe);
            let page = || own_page(&own, &meshes, &recipe, &path.to_string_lossy());
            let page = args.output.is_some().then(page).transpose();
            let page = page.map_err(|error| Failure::Write(error.to_string()))?;
            (Measured::Own(Box::new(own)), page)
        }
        None => {
            let trade =
                Trade::measure(args.effort(), &observe).map_err(|error| Failure::Draw(error.to_string()))?;
            let page = args.output.is_some().then(|| trade_page(&trade)).transpose();
            let page = page.map_err(|error| Failure::Write(error.to_string()))?;
            (Measured::Surfaces(Box::new(trade)), page)
        }
    };
    drop(progress);
    report.measured = Some(measured);
    if let (Some(folder), Some(page)) = (&args.output, page) {
        let path = folder.join(PAGE);
        report.output = Some(path.to_string_lossy().into_owned());
        let written = Written { bytes: page.into_bytes(), ..Written::default() };
        let stored = Store::new(false, false).store(written, &Target::File(path));
        stored.map_err(|error| Failure::Write(format!("{error:#}")))?;
    }
    Ok(())
}

fn read(path: &Path, args: &TradeArgs) -> Result<Loaded, ReadError> {
    let options = ReadOptions::default();
    if path.as_os_str() == "-" {
        let bytes = read_stdin(&Limits::default(), |_| ())?;
        return io::read_bytes(bytes, args.format, None, &options);
    }
    io::read(path, args.format, &options)
}
