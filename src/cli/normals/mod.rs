//! `crease normals`: compute normals and write them.

/// Options.
pub mod args;
/// Axes and units.
mod conversion;
/// The report as JSON.
mod json;
/// Options made into jobs.
pub mod request;
/// Reading, computing and writing.
pub mod run;
/// The report as text.
mod text;
