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
use crease::io::{Format, Note, Part, Place, WriteOptions, write_new};
use crease::mesh::{Column, Mesh, TransformFault};
use crease::normals::{NormalRecipe, compute};
use glam::DVec3;
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
    let shape = mesh.unwrap_or_else(|error| usage_error("surface", error.to_string()));
    let mesh = shape.transformed(request.placement).unwrap_or_else(|TransformFault::Overflow| {
        usage_error("surface", "--scale and --offset take a position beyond the range of numbers".into())
    });
    if mesh.face_count() == 0 {
        usage_error("surface", "so coarsely cut it has no faces; give more --segments".into());
    }
    report.mesh = Some(MeshReport::new(&mesh));
    report.notes.extend(placement_note(&shape, &mesh, args).as_ref().map(NoteReport::new));
    let name = super::choice::name_of(KINDS, &args.kind).to_owned();
    let mesh = if request.format == Format::Stl { with_facet_normals(mesh) } else { mesh };
    let parts = [Part { name, mesh, ..Part::default() }];
    let options = WriteOptions { stem: request.stem(), ..WriteOptions::default() };
    let written =
        write_new(&parts, request.format, &options).map_err(|error| Failure::Write(error.to_string()))?;
    report.notes.extend(written.notes.iter().map(NoteReport::new));
    report.output = Some(OutputReport::new(Some(&request.target), request.format, false, &written));
    let stored = Store::new(args.sync, false).store(written, &request.target);
    let replaced = stored.map_err(|error| Failure::Write(format!("{error:#}")))?;
    report.notes.extend(replaced.iter().map(|path| NoteReport::new(&replaced_note(path))));
    Ok(())
}

/// A surface smaller than this has coordinates, and differences of them, without all of their digits.
const SMALLEST: f64 = f64::MIN_POSITIVE / f64::EPSILON;

/// Tells when a surface is so small, or an offset so long that places in doubles, however they are stored, no longer tell the shape.
fn placement_note(shape: &Mesh, placed: &Mesh, args: &SurfaceArgs) -> Option<Note> {
    let (scale, offset) = (args.shape.scale, args.shape.offset);
    let moved = |(&own, &there): (&DVec3, &DVec3)| (there - offset).distance(own * scale);
    let largest = shape.positions().iter().zip(placed.positions()).map(moved).fold(0.0, f64::max);
    let size = shape.bounds().map_or(0.0, |(low, high)| ((high - low) * scale).length());
    if size < SMALLEST {
        let text = format!(
            "the surface is {size:e} wide: so near to zero doubles have few digits or none; take a larger --scale"
        );
        return Some(Note::warning(Place::File, text));
    }
    // As where positions are rounded to 32 bits.
    (largest > size / f64::from(1 << 20)).then(|| {
        let text = format!(
            "so far out positions are rounded by up to {largest:.3e}, {:.1e} of the surface's size; take a smaller --offset, or \
             a larger --scale",
            largest / size
        );
        Note::warning(Place::File, text)
    })
}

/// STL knows facets only.
fn with_facet_normals(mesh: Mesh) -> Mesh {
    let normals = compute(&mesh, &NormalRecipe::default()).face_normals;
    let owners = mesh.faces().owners();
    mesh.with_normals(Some(Column::per_corner(normals, owners)))
}
