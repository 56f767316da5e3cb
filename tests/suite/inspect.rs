//! Tests of the diagnosis: faults planted at known positions, clean meshes, real meshes with known faults, and whether the
//! suggested commands fix what was found.

mod attributes;
mod authored;
mod borders;
mod causes;
mod cavities;
mod clean;
mod comparison;
mod coordinate_spaces;
mod cut_fans;
mod degrees_and_steps;
mod estimates;
mod geometry;
mod light_documents;
mod outliers;
mod own_output;
mod page;
mod planted;
mod real;
mod recall;
mod remedies;
mod rooms;
mod rotated;
mod seams;
mod sharp_or_round;
mod whole_meshes;

use crease::io::{Document, FileNode, Format, Loaded, Part};
use crease::mesh::{Columns, Faces, Mesh, MeshBuilder};
use crease::normals::{Crease, NormalRecipe, Weight, compute};
use crease::num::Degrees;
use crease::quality::{Diagnosis, Severity, Thresholds, diagnose};
use crease::surface::{Surface, Tessellation};
use glam::DVec3;

/// A mesh as if it were read from a file that can share vertices.
fn loaded(mesh: Mesh) -> Loaded {
    Loaded {
        format: Format::Obj,
        parts: vec![Part { mesh, ..Part::default() }],
        nodes: Vec::<FileNode>::new(),
        notes: Vec::new(),
        document: Document::None,
    }
}

/// The diagnosis of a mesh, with at most `places` places for each finding.
fn inspect(mesh: &Mesh, places: usize) -> Diagnosis {
    diagnose(&loaded(mesh.clone()), &Thresholds { places, ..Thresholds::default() }, &|_| {})
}

/// The ids of the findings that are more severe than a note.
fn grave(diagnosis: &Diagnosis) -> Vec<&'static str> {
    let grave = diagnosis.findings.iter().filter(|finding| finding.severity > Severity::Note);
    grave.map(|finding| finding.kind.id()).collect()
}

fn recipe(weight: Weight, crease: f64) -> NormalRecipe {
    NormalRecipe { weight, crease: Crease::Angle(Degrees(crease)), ..NormalRecipe::default() }
}

/// A mesh with the normals of a recipe stored in it.
fn with_normals(mesh: Mesh, recipe: &NormalRecipe) -> Mesh {
    let normals = compute(&mesh, recipe).normals;
    mesh.with_normals(Some(normals))
}

/// A mesh of a surface of the catalogue, with its exact normals.
fn surface(surface: &Surface, segments: [u32; 2]) -> Mesh {
    surface.tessellate(&Tessellation { segments, ..Tessellation::default() }).unwrap()
}

/// A mesh of other positions or faces, without columns.
fn rebuilt(positions: Vec<DVec3>, faces: Faces) -> Mesh {
    MeshBuilder { positions: positions.into(), faces, columns: Columns::default() }.build().unwrap()
}
