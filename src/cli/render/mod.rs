//! `crease render`: draw a mesh or a scene.

/// Options.
pub mod args;
/// Pictures of many scenes.
pub mod batch;
/// A scene changed by options.
pub mod changes;
/// Pictures, panels and animations.
pub mod draw;
/// Values of `--camera`, `--light` and `--material`.
mod fields;
/// The report as JSON and as text.
mod report;
/// Options made into what is drawn.
pub mod request;
/// Loading, drawing and storing.
pub mod run;
/// Values of options.
pub mod values;
/// Options without effect, and materials that cannot be drawn as meant.
mod warnings;
