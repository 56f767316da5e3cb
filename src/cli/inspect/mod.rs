//! `crease inspect`: find what is wrong with the normals of meshes.

/// Options.
pub mod args;
/// The texts of `--explain`.
mod explanation;
/// The report as JSON.
pub mod json;
/// Reading, diagnosing and drawing.
pub mod run;
/// From symptoms to findings.
mod symptoms;
/// The report as text.
mod text;
