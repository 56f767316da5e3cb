//! `crease inspect`: find what is wrong with the normals of meshes.

/// Options.
pub mod args;
/// The report as JSON.
pub mod json;
/// Reading, diagnosing and drawing.
pub mod run;
/// From symptoms to findings.
mod symptoms;
/// The report as text.
mod text;
