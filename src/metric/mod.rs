//! Numbers from pictures (layer 4): differences, outlines, luminance along a scanline and the response of a model of the eye
//! to it, highlights, angles between normals.
//!
//! - [`image_error`]: differences in linear light, luminance and sRGB, with coverage counted separately.
//! - [`Contour`] and [`contour_distance`]: outlines, sub-pixel where pixels have several samples.
//! - [`Profile`]: luminance along a scanline.
//! - [`DifferenceOfGaussians`]: the overshoot that lateral inhibition *predicts* there.
//! - [`Highlight`]: where the brightest spot is, and how it differs from the true one.
//! - [`flip`]: the visible difference of pictures that alternate (ꟻLIP).
//! - [`normal_deviation`]: the angle between normals, pixel by pixel.
//!
//! All of them read linear samples before any rounding, so pictures are to be drawn with
//! [`keep_linear`](crate::raster::RenderSettings::keep_linear). All but [`flip`] are numbers of pictures, not of
//! perception: they do not say that a difference is visible. Places are in pixels from a picture's upper left corner, y
//! down, pixel centres at +½.

// Errors, and pixels in pairs.
mod pairs;
// Linear light, luminance and sRGB, and normals drawn as colours.
mod difference;
// Outlines.
mod contour;
// Distances between outlines.
mod distance;
// The visible difference of pictures that alternate.
mod flip;
// The brightest spot.
mod highlight;
// Pictures with known numbers.
#[cfg(test)]
mod pictures_tests;
// Luminance along a scanline, and the response of a difference of Gaussians to it, as lateral inhibition predicts.
mod profile;

pub use contour::Contour;
pub use difference::{Difference, ImageError, NormalDeviation, image_error, normal_deviation};
pub use distance::{ContourDistance, Distances, contour_distance};
pub use flip::{FLIP_PIXELS_PER_DEGREE, Flip, Perceived, flip};
pub use highlight::{Highlight, HighlightChange};
pub use pairs::MetricError;
pub use profile::{DifferenceOfGaussians, PIXELS_PER_DEGREE, Profile};
