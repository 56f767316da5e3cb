//! Numbers without meshes (layer 0).

mod angle;

pub use angle::{Degrees, Radians};
