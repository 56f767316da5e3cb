//! Outlines stay polygons, however smoothly the faces are shaded.

mod curved_triangles;
mod outline;
mod round_surfaces;
#[cfg(test)]
mod tests;
mod user_mesh;

use super::error::ArtefactError;
use super::experiment::Experiment;
use super::outcome::Outcome;
use super::parameter_name::ParameterName;
use super::parameters::{Parameters, Setup};
use super::recorder::Recorder;
use crate::num::Degrees;
use crate::text::{Catalogue, catalogue};

static TEXTS: Catalogue = catalogue!("texts");

pub(super) static EXPERIMENT: Experiment = Experiment {
    id: "silhouette",
    texts: &TEXTS,
    takes: &[
        ParameterName::Size,
        ParameterName::Segments,
        ParameterName::Light,
        ParameterName::Crease,
        ParameterName::Mesh,
    ],
    // More would be hardly larger than pixels.
    segments: 3..=256,
    defaults: Parameters { segments: 12, light: Degrees(40.0), ..Parameters::USUAL },
    run,
    frame: None,
};

fn run(setup: &Setup) -> Result<Outcome, ArtefactError> {
    let out = Recorder::new(&TEXTS, &[]);
    match &setup.mesh {
        None => round_surfaces::run(&setup.parameters, out),
        Some(own) => user_mesh::run(own, &setup.parameters, out),
    }
}
