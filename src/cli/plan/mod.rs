//! `crease plan`: find the cheapest model that a scene requires.

/// Mesh files as planned.
mod apply;
/// Options.
pub mod args;
/// The report as JSON and as text.
mod report;
/// Reading the scene, planning, storing the planned scene.
pub mod run;
