//! `crease artefact`: run the experiments on shading artefacts.

/// Options.
pub mod args;
/// Which experiments are meant.
mod choose;
/// Pages, pictures, plots and animations.
mod files;
/// The report as JSON.
mod json;
/// Running experiments.
pub mod run;
