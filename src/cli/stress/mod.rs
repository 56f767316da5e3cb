//! `crease stress`: run the numerical extremes.

/// Options.
pub mod args;
/// The report as JSON and as text.
mod report;
/// Running the cases.
pub mod run;
