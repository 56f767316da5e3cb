//! Numbers from pictures (layer 4): how far one is from another, where outlines lie, how luminance runs, what a model of
//! the eye predicts of it, where a highlight is, how far normals are off.
//!
//! - [`image_error`]: differences in linear light, luminance and sRGB, with coverage apart.
//! - [`Contour`] and [`contour_distance`]: outlines, sub-pixel where pixels have several samples.
//! - [`Profile`]: luminance along a scanline and its derivatives; [`slope_jumps`]: how they break at edges of a mesh.
//! - [`DifferenceOfGaussians`]: the overshoot that lateral inhibition *predicts* there.
//! - [`Highlight`]: where the brightest spot is, and how it differs from the true one.
//! - [`normal_deviation`]: the angle between normals, pixel by pixel.
//!
//! All of them read linear samples before any rounding, so pictures are to be drawn with
//! [`keep_linear`](crate::raster::RenderSettings::keep_linear). They are numbers of pictures, not of perception: none says
//! that a difference is seen. Places are in pixels from a picture's upper left corner, y down, pixel centres at +½.

mod contour;
mod deviation;
mod difference;
mod distance;
mod error;
mod gaussians;
mod highlight;
mod luminance;
#[cfg(test)]
mod pictures_tests;
mod profile;
mod slopes;

pub use contour::Contour;
pub use deviation::{NormalDeviation, normal_deviation};
pub use difference::{Difference, ImageError, image_error};
pub use distance::{ContourDistance, Distances, contour_distance};
pub use error::MetricError;
pub use gaussians::{DifferenceOfGaussians, Overshoot, PIXELS_PER_DEGREE};
pub use highlight::{Highlight, HighlightChange};
pub use profile::Profile;
pub use slopes::{EdgeJump, slope_jumps};
