//! Numbers from pictures (layer 4).

mod difference;

pub use difference::{Difference, ImageError, MetricError, image_error};
