//! The command-line program: one folder for each verb, and what they share.

/// The command line: verbs and options.
pub mod args;
/// Run the experiments on shading artefacts.
mod artefact;
/// Shared by the verbs.
pub mod common;
/// Completion scripts and manual pages.
mod docs;
/// The help of the command line.
mod help;
/// Find what is wrong with normals.
pub mod inspect;
/// Summarise journals of batches.
mod journal;
/// Options of a line of a manifest.
pub mod line_options;
/// Compute normals and write them.
pub mod normals;
/// Find the cheapest model that a scene requires.
pub mod plan;
/// From the command line to an exit code.
pub mod program;
/// Draw a mesh or a scene.
pub mod render;
/// Run the numerical extremes.
mod stress;
/// Write an analytic surface as a mesh.
mod surface;
/// Measure accuracy against speed.
mod trade;
/// The message of wrong usage.
pub mod usage;
