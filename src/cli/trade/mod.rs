//! `crease trade`: measure accuracy against speed.

/// Options.
pub mod args;
/// The report as JSON and as text.
mod report;
/// Measuring.
pub mod run;
