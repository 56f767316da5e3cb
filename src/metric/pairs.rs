//! What measurements need of pictures: linear colours and equal sizes, and the errors if these are missing.

use crate::num::{CompensatedSum, LinearRgb};
use crate::raster::Image;

/// Why pictures cannot be measured or compared.
#[derive(Clone, Copy, Debug, PartialEq, thiserror::Error)]
pub enum MetricError {
    /// They are not of one size.
    #[error("the pictures are {} by {} and {} by {} pixels; draw both at the same size", .0[0], .0[1], .1[0], .1[1])]
    Sizes([u32; 2], [u32; 2]),
    /// One has quantised colours only.
    #[error("a picture has no linear colours; draw it with RenderSettings::keep_linear")]
    NoLinear,
    /// Nothing is drawn in one of them.
    #[error("a picture shows nothing that could be measured; check its camera and its objects")]
    Empty,
    /// A row that the picture does not have.
    #[error("row {row} of a picture of {height} rows; rows count from 0 at the top")]
    Row {
        /// The requested row.
        row: u32,
        /// How many there are.
        height: u32,
    },
}

/// The relative luminance of every pixel, in order.
pub(super) fn luminances(image: &Image) -> Result<Vec<f64>, MetricError> {
    let colours = image.linear.as_ref().ok_or(MetricError::NoLinear)?;
    Ok(colours.iter().map(|colour| LinearRgb::from(colour.map(f64::from)).luminance()).collect())
}

pub(super) fn same_size(picture: &Image, truth: &Image) -> Result<(), MetricError> {
    if picture.size == truth.size { Ok(()) } else { Err(MetricError::Sizes(picture.size, truth.size)) }
}

pub(super) struct Pair {
    pub(super) covered: [u8; 2],
    pub(super) colours: [[f64; 3]; 2],
}

impl Pair {
    /// Whether both pictures cover the pixel, by as many samples.
    pub(super) fn is_comparable(&self) -> bool {
        self.covered[0] == self.covered[1] && self.covered[0] > 0
    }
}

pub(super) fn pairs<'a>(
    picture: &'a Image,
    truth: &'a Image,
) -> Result<impl Iterator<Item = Pair> + 'a, MetricError> {
    same_size(picture, truth)?;
    let (Some(colours), Some(true_colours)) = (&picture.linear, &truth.linear) else {
        return Err(MetricError::NoLinear);
    };
    Ok((0..colours.len()).map(|pixel| Pair {
        covered: [picture.coverage[pixel], truth.coverage[pixel]],
        colours: [colours[pixel], true_colours[pixel]].map(|colour| colour.map(f64::from)),
    }))
}

/// Mean, root mean square and maximum of numbers.
#[derive(Default)]
pub(super) struct Moments {
    count: u64,
    pub(super) max: f64,
    sum: CompensatedSum,
    squares: CompensatedSum,
}

impl Moments {
    pub(super) fn add(&mut self, value: f64) {
        self.count += 1;
        self.max = self.max.max(value);
        self.sum += value;
        self.squares += value * value;
    }

    /// 0 without numbers.
    pub(super) fn mean(&self) -> f64 {
        self.sum.value() / self.count.max(1) as f64
    }

    /// The root of the mean square; 0 without numbers.
    pub(super) fn rms(&self) -> f64 {
        (self.squares.value() / self.count.max(1) as f64).sqrt()
    }
}
