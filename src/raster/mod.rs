//! Polygons to pixels (layer 3).

mod camera;
mod clip;
mod coverage;
mod fixed;
mod project;
mod samples;
mod setup;
mod view;

pub use camera::{Camera, CameraError, Projection};
pub use samples::Samples;
