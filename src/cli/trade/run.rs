//! Runs `crease trade`: accuracy against speed, measured.

use super::args::TradeArgs;
use super::report::{Report, markdown, text};
use crate::cli::common::console::{Console, Verbosity, escaped};
use crate::cli::common::failure::{Exit, Failure, exit_code, guarded};
use crate::cli::common::input::Source;
use crate::cli::common::options::Color;
use crate::cli::common::output::{Target, make_folder};
use crate::cli::common::progress::Progress;
use crate::cli::usage::usage_error;
use crease::io::{Format, ReadOptions};
use crease::mesh::Mesh;
use crease::normals::{Crease, NormalRecipe};
use crease::report::{own_page, trade_page};
use crease::trade::{OwnMesh, Trade, Truth, advice};
use std::time::Instant;

const PAGE: &str = "index.html";

pub fn main(args: &TradeArgs, color: Color) -> Exit {
    // clap does not ask for an input where --quick or --full exclude one.
    if args.input.is_none() && (args.crease.is_some() || args.format.is_some() || args.truth.is_some()) {
        usage_error("trade", "--crease, --format and --truth need an input");
    }
    let console = Console::new(&args.run, color, None);
    args.run.use_threads();
    let start = Instant::now();
    let input = args.input.as_deref().map(Source::of);
    let mut report = Report::new(input.as_ref().map(Source::name));
    let result = guarded(|| measure(args, input.as_ref(), &console, &mut report));
    report.seconds = start.elapsed().as_secs_f64();
    report.head.record(&result);
    if let Err(failure) = &result {
        let name = report.input.as_ref().map(|path| format!("{}: ", escaped(path))).unwrap_or_default();
        console.error(&format!("{name}{}", failure.message));
    }
    let verbose = console.verbosity == Verbosity::Verbose;
    console.print(&report, || match (&result, &report.surfaces) {
        (Err(_), _) => String::new(),
        (Ok(_), Some(trade)) if args.markdown => markdown(trade),
        (Ok(_), _) => text(&report, console.report_style, verbose),
    });
    exit_code(result, &console)
}

fn measure(
    args: &TradeArgs,
    input: Option<&Source>,
    console: &Console,
    report: &mut Report,
) -> Result<Exit, Failure> {
    // Before the measurement, which takes long, and after the input has been checked.
    let prepare = || args.output.as_deref().map_or(Ok(()), make_folder);
    let progress = Progress::of_steps(console);
    let observe = |step| progress.step(step);
    let page;
    if let Some(input) = input {
        let loaded = input.read(args.format, &ReadOptions::default(), |_| ())?;
        let meshes: Vec<&Mesh> = loaded.parts.iter().map(|part| &part.mesh).collect();
        if meshes.iter().all(|mesh| mesh.face_count() == 0) {
            return Err(Failure::input("the mesh has no faces to measure\nhelp: name a mesh with faces"));
        }
        let crease = args.crease.map_or(Crease::Default, Crease::Angle);
        let recipe = NormalRecipe { crease, ..NormalRecipe::default() };
        let truth = args.truth.unwrap_or_default();
        if truth == Truth::Stored && meshes.iter().all(|mesh| mesh.columns().normals.is_none()) {
            return Err(Failure::input(
                "the mesh stores no normals\nhelp: omit --truth stored to estimate them",
            ));
        }
        if truth == Truth::Stored && loaded.format == Format::Stl {
            return Err(Failure::input(
                "an STL stores the normals of its facets, not those of the surface at its vertices\nhelp: omit --truth \
                 stored to estimate these",
            ));
        }
        prepare()?;
        let own = OwnMesh::measure(&meshes, &recipe, truth, &observe);
        page = args.output.is_some().then(|| own_page(&own, &meshes, &recipe, &input.name())).transpose()?;
        report.advice = Some(own.reasons.clone());
        report.mesh = Some(own);
    } else {
        prepare()?;
        let trade = Trade::measure(args.effort(), &observe).map_err(Failure::input)?;
        page = args.output.is_some().then(|| trade_page(&trade)).transpose()?;
        report.advice = Some(advice(&trade));
        report.surfaces = Some(trade);
    }
    drop(progress);
    if let (Some(folder), Some((page, drawings))) = (&args.output, page) {
        for drawing in drawings {
            let name = format!("{}.svg", drawing.name);
            Target::File(folder.join(name)).store(drawing.svg.into_bytes())?;
        }
        report.output = Some(Target::File(folder.join(PAGE)).store(page.into_bytes())?);
    }
    Ok(Exit::Done)
}
