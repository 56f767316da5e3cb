//! `crease stress`: run the numerical extremes.

/// Options.
pub mod args;
/// The report as JSON.
mod json;
/// Running the cases.
pub mod run;
mod text;
