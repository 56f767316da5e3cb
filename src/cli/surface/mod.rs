//! The verb `surface`: an analytic surface as a mesh with its exact normals.

mod args;
mod report;
mod request;

pub use args::SurfaceArgs;

use super::args::Color;
use super::batch::{exit_of, guarded};
use super::console::{Console, Verbosity};
use super::normals::Failure;
use super::output::{Store, replaced_note};
use super::report::{ErrorReport, NoteReport, OutputReport, json_line};
use super::{Exit, usage_error, use_threads};
use args::KINDS;
use crease::io::{Format, Part, WriteOptions, write_new};
use crease::mesh::{Column, Mesh, TransformFault};
use crease::normals::{NormalRecipe, compute};
use report::{MeshReport, SurfaceReport};
use request::Request;
use std::time::Instant;

/// Carries the verb out.
pub fn main(args: &SurfaceArgs, color: Color) -> Exit {
    let console = Console::new(&args.run, color, Some(&args.output));
    use_threads(args.run.threads);
    let request = Request::resolve(args).unwrap_or_else(|message| usage_error("surface", message));
    let mut report = SurfaceReport::new(args, &request);
    let start = Instant::now();
    let result = guarded(|| run(args, &request, &mut report));
    report.seconds = start.elapsed().as_secs_f64();
    if let Err(failure) = &result {
        report.fail(ErrorReport::new(failure));
    }
    if let Some(error) = &report.head.error {
        console.error(&error.message);
    }
    if console.json {
        console.report(&json_line(&report));
    } else if console.verbosity > Verbosity::Quiet {
        for note in &report.notes {
            if note.severity == "warning" { console.warning(&note.text) } else { console.note(&note.text) }
        }
        if report.head.error.is_none() {
            console.report(&report.text(console.report_style()));
        }
    }
    match result {
        Err(failure) => exit_of(&failure),
        Ok(()) if !console.has_reported() => Exit::OutputFailed,
        Ok(()) => Exit::Done,
    }
}

/// Makes the mesh and stores it. Settings that do not go together end the program as wrong usage.
fn run(args: &SurfaceArgs, request: &Request, report: &mut SurfaceReport) -> Result<(), Failure> {
    let mesh = request.surface.tessellate(&request.tessellation);
    let mesh = mesh.unwrap_or_else(|error| usage_error("surface", error.to_string()));
    let mesh = mesh.transformed(request.placement).unwrap_or_else(|TransformFault::Overflow| {
        usage_error("surface", "--scale and --offset take a position beyond the range of numbers".into())
    });
    report.mesh = Some(MeshReport::new(&mesh));
    let name = super::choice::name_of(KINDS, &args.kind).to_owned();
    let mesh = if request.format == Format::Stl { with_facet_normals(mesh) } else { mesh };
    let parts = [Part { name, mesh, ..Part::default() }];
    let options = WriteOptions { stem: request.stem(), ..WriteOptions::default() };
    let written =
        write_new(&parts, request.format, &options).map_err(|error| Failure::Write(error.to_string()))?;
    report.notes = written.notes.iter().map(NoteReport::new).collect();
    report.output = Some(OutputReport::new(Some(&request.target), request.format, false, &written));
    let stored = Store::new(args.sync, false).store(written, &request.target);
    let replaced = stored.map_err(|error| Failure::Write(format!("{error:#}")))?;
    report.notes.extend(replaced.iter().map(|path| NoteReport::new(&replaced_note(path))));
    Ok(())
}

/// STL knows facets only.
fn with_facet_normals(mesh: Mesh) -> Mesh {
    let normals = compute(&mesh, &NormalRecipe::default()).face_normals;
    let owners = mesh.faces().owners();
    mesh.with_normals(Some(Column::per_corner(normals, owners)))
}
