//! Outlines stay polygons, however smoothly the faces are shaded.

// Curved triangles over those of a mesh, from its normals alone.
mod curved_triangles;
// Outlines of drawn surfaces and the distance between them.
mod outline;
// Outlines that are known: a ball seen along its axis is a regular polygon, a torus two of them.
mod round_surfaces;
// Outlines of balls and of meshes.
#[cfg(test)]
mod tests;
// The outline of a user's mesh, compared with that of a finer one or of its own curved triangles.
mod user_mesh;

use super::prelude::*;

static TEXTS: Catalogue = catalogue!("texts");

pub(super) static EXPERIMENT: Experiment = Experiment {
    takes: &[
        ParameterName::Size,
        ParameterName::Segments,
        ParameterName::Light,
        ParameterName::Crease,
        ParameterName::Mesh,
    ],
    // More would be hardly larger than pixels.
    ranges: &[(ParameterName::Segments, [3.0, 256.0])],
    defaults: Parameters { segments: 12, light: Degrees(40.0), ..Parameters::USUAL },
    ..Experiment::new("silhouette", &TEXTS, run)
};

fn run(setup: &Setup) -> Result<Outcome> {
    let out = Recorder::new(&TEXTS, &[]);
    match &setup.mesh {
        None => round_surfaces::run(&setup.parameters, out),
        Some(own) => user_mesh::run(own, &setup.parameters, out),
    }
}
