//! `crease trade`: measure accuracy against speed.

/// Options.
pub mod args;
/// The report as JSON.
mod json;
/// Measuring.
pub mod run;
mod text;
