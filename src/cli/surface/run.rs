//! Runs `crease surface`.

use super::args::SurfaceArgs;
use super::report::{MeshReport, SurfaceReport};
use super::request::Request;
use crate::cli::common::choice::Choose;
use crate::cli::common::console::{Console, HELP};
use crate::cli::common::failure::{Exit, Failure, exit_code, guarded};
use crate::cli::common::options::Color;
use crate::cli::common::output::{Store, stem};
use crate::cli::common::report::MeshOutput;
use crate::cli::usage::usage_error;
use crease::io::{Format, Note, Part, Place, WriteOptions, write_new};
use crease::mesh::{Column, Mesh, TransformFault};
use crease::normals::{NormalRecipe, compute};
use glam::DVec3;
use std::time::Instant;

pub fn main(args: &SurfaceArgs, color: Color) -> Exit {
    let console = Console::new(&args.run, color, Some(&args.output));
    args.run.use_threads();
    let request = Request::resolve(args).unwrap_or_else(|message| usage_error("surface", message));
    let mut report = SurfaceReport::new(args, &request);
    let start = Instant::now();
    let result = guarded(|| run(args, &request, &mut report));
    report.seconds = start.elapsed().as_secs_f64();
    report.head.record(&result);
    if let Err(failure) = &result {
        report.output = None;
        console.error(&failure.message);
    }
    console.print(&report, || {
        for note in &report.notes {
            console.about(note.severity, &note.text);
        }
        if result.is_ok() { report.text(console.report_style) } else { String::new() }
    });
    exit_code(result, &console)
}

/// Makes the mesh and stores it. Settings that do not go together end the program as wrong usage.
fn run(args: &SurfaceArgs, request: &Request, report: &mut SurfaceReport) -> Result<Exit, Failure> {
    let mesh = request.surface.tessellate(&request.tessellation);
    let shape = mesh.unwrap_or_else(|error| usage_error("surface", error));
    let mesh = shape.transformed(request.placement).unwrap_or_else(|TransformFault::Overflow| {
        usage_error("surface", "--scale and --offset move a position beyond the range of numbers")
    });
    if mesh.face_count() == 0 {
        usage_error("surface", "no faces at this resolution\nhelp: use more --segments");
    }
    report.mesh = Some(MeshReport::new(&mesh));
    report.notes.extend(placement_note(&shape, &mesh, args));
    let mesh = if request.format == Format::Stl { with_facet_normals(mesh) } else { mesh };
    let parts = [Part { name: args.kind.choice().to_owned(), mesh, ..Part::default() }];
    let options = WriteOptions { stem: request.target.path().and_then(stem), ..WriteOptions::default() };
    let written = write_new(&parts, request.format, &options).map_err(Failure::output)?;
    report.notes.extend_from_slice(&written.notes);
    report.output = Some(MeshOutput::new(Some(&request.target), request.format, false, &written));
    report.notes.extend(Store::new(args.sync, false).store(written, &request.target)?.notes);
    Ok(Exit::Done)
}

/// A surface smaller than this has coordinates, and differences of them, without all of their digits.
const SMALLEST: f64 = f64::MIN_POSITIVE / f64::EPSILON;

/// A warning if the surface is so small, or so far from the origin, that doubles cannot hold its shape.
fn placement_note(shape: &Mesh, placed: &Mesh, args: &SurfaceArgs) -> Option<Note> {
    let (scale, offset) = (args.shape.scale, args.shape.offset);
    let moved = |(own, there): (DVec3, DVec3)| (there - offset).distance(own * scale);
    let largest = shape.positions().iter().zip(placed.positions().iter()).map(moved).fold(0.0, f64::max);
    let size = shape.bounds().map_or(0.0, |(low, high)| ((high - low) * scale).length());
    if size < SMALLEST {
        let text = format!(
            "the surface is {size:e} wide: doubles near zero have few digits or none{HELP}use a larger --scale"
        );
        return Some(Note::warning(Place::File, text));
    }
    // As where positions are rounded to 32 bits.
    (largest > size / f64::from(1 << 20)).then(|| {
        let text = format!(
            "far from the origin, positions are rounded by up to {largest:.3e}, {:.1e} of the surface's \
             size{HELP}use a smaller --offset or a larger --scale",
            largest / size
        );
        Note::warning(Place::File, text)
    })
}

/// STL has normals of facets only.
fn with_facet_normals(mesh: Mesh) -> Mesh {
    let normals = compute(&mesh, &NormalRecipe::default()).face_normals;
    let owners = mesh.faces().owners();
    mesh.with_normals(Some(Column::per_corner(normals, owners)))
}
