//! Numbers without meshes (layer 0).

mod angle;
mod scale;
mod sum;

pub use angle::{Degrees, Radians};
pub use scale::unit_scale;
pub use sum::CompensatedSum;
