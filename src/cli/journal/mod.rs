//! `crease journal`: what batches have done.

/// Options.
pub mod args;
/// Reading journals and printing.
pub mod run;
