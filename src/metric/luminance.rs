//! Pictures as one number a pixel.

use super::MetricError;
use crate::num::LinearRgb;
use crate::raster::Image;

/// The relative luminance of every pixel, in order.
pub(super) fn luminances(image: &Image) -> Result<Vec<f64>, MetricError> {
    let colours = image.linear.as_ref().ok_or(MetricError::NoLinear)?;
    Ok(colours.iter().map(|colour| LinearRgb::from(colour.map(f64::from)).luminance()).collect())
}

/// Refuses pictures of different sizes.
pub(super) fn same_size(picture: &Image, truth: &Image) -> Result<(), MetricError> {
    match picture.size == truth.size {
        true => Ok(()),
        false => Err(MetricError::Sizes(picture.size, truth.size)),
    }
}
