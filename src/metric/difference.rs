//! How far one picture is from another.

use super::MetricError;
use super::luminance::same_size;
use crate::num::{CompensatedSum, LinearRgb, Transfer};
use crate::raster::Image;
use serde::Serialize;

/// Steps of 8 bits in the range from 0 to 1: the unit of all differences. Nothing is rounded to it.
const STEPS: f64 = 255.0;

/// The difference of two pictures over the pixels that both cover alike; how many they do not is told apart.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize)]
pub struct ImageError {
    /// Pixels compared: covered in both, by as many of their samples.
    pub compared: u64,
    /// Pixels that only one picture covers, or of which one covers more samples.
    pub disagreeing: u64,
    /// [`disagreeing`](Self::disagreeing) as a share of the pixels that either covers; 0 if none does.
    pub disagreement: f64,
    /// Of linear red, green and blue, each component for itself.
    pub linear: Difference,
    /// Of relative luminance Y (ITU-R BT.709).
    pub luminance: Difference,
    /// Of red, green and blue as sRGB codes them: closest to what eyes see of it.
    pub srgb: Difference,
}

/// Differences in steps of 1/255 of the full range.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize)]
pub struct Difference {
    /// The largest.
    pub max: f64,
    /// The mean of their magnitudes.
    pub mean: f64,
    /// The root of the mean of their squares.
    pub rms: f64,
    /// The share of pixels that differ by more than the threshold, in any component.
    pub over: f64,
}

/// Compares two pictures of one size by their linear samples, before any rounding; both drawn with
/// [`keep_linear`](crate::raster::RenderSettings::keep_linear). `threshold` is in steps of 1/255: ½ is where rounding to 8 bits
/// may begin to show.
///
/// Pixels that both cover partly but alike mix the same background into both, so their differences are those of the
/// surface, less in proportion.
///
/// *Claims* differences of light, of luminance and of codes, as the pictures have them. *Does not claim* that they are seen:
/// the eye forgives a large area that is a little off and not a line between two that are ([`slope_jumps`](super::slope_jumps)).
///
/// ```
/// use crease::metric::image_error;
/// use crease::raster::{Image, Pixels, Statistics};
///
/// let picture = |value: f32| Image {
///     size: [2, 1],
///     pixels: Pixels::Eight(vec![[0; 3]; 2]),
///     coverage: vec![1, 0],
///     linear: Some(vec![[value; 3], [0.0; 3]]),
///     statistics: Statistics::default(),
/// };
/// let error = image_error(&picture(0.5), &picture(0.25), 0.5)?;
/// assert_eq!((error.compared, error.linear.max, error.linear.over), (1, 63.75, 1.0));
/// # Ok::<(), crease::metric::MetricError>(())
/// ```
///
/// # Errors
/// [`MetricError`].
pub fn image_error(picture: &Image, truth: &Image, threshold: f64) -> Result<ImageError, MetricError> {
    same_size(picture, truth)?;
    let (Some(colours), Some(true_colours)) = (&picture.linear, &truth.linear) else {
        return Err(MetricError::NoLinear);
    };
    let mut error = ImageError::default();
    let mut sums: [Sum; 3] = std::array::from_fn(|_| Sum::new(threshold));
    for (pixel, (&covered, &truly)) in picture.coverage.iter().zip(&truth.coverage).enumerate() {
        if covered != truly {
            error.disagreeing += 1;
        } else if covered > 0 {
            error.compared += 1;
            let pair = [colours[pixel], true_colours[pixel]].map(|colour| colour.map(f64::from));
            let coded = pair.map(|colour| colour.map(|component| Transfer::Srgb.encode(component)));
            let luminance = pair.map(|colour| [LinearRgb::from(colour).luminance()]);
            sums[0].add(pair);
            sums[1].add(luminance);
            sums[2].add(coded);
        }
    }
    let either = error.compared + error.disagreeing;
    error.disagreement = if either > 0 { error.disagreeing as f64 / either as f64 } else { 0.0 };
    [error.linear, error.luminance, error.srgb] = sums.map(|sum| sum.finish());
    Ok(error)
}

/// Differences on their way to means.
struct Sum {
    threshold: f64,
    pixels: u64,
    components: u64,
    over: u64,
    max: f64,
    magnitudes: CompensatedSum,
    squares: CompensatedSum,
}

impl Sum {
    fn new(threshold: f64) -> Self {
        let nothing = CompensatedSum::default();
        Self { threshold, pixels: 0, components: 0, over: 0, max: 0.0, magnitudes: nothing, squares: nothing }
    }

    fn add<const N: usize>(&mut self, [a, b]: [[f64; N]; 2]) {
        let mut largest = 0.0_f64;
        for (a, b) in a.into_iter().zip(b) {
            let difference = STEPS * (a - b).abs();
            largest = largest.max(difference);
            self.magnitudes += difference;
            self.squares += difference * difference;
        }
        self.pixels += 1;
        self.components += N as u64;
        self.over += u64::from(largest > self.threshold);
        self.max = self.max.max(largest);
    }

    fn finish(self) -> Difference {
        if self.pixels == 0 {
            return Difference::default();
        }
        let count = self.components as f64;
        Difference {
            max: self.max,
            mean: self.magnitudes.value() / count,
            rms: (self.squares.value() / count).sqrt(),
            over: self.over as f64 / self.pixels as f64,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::raster::{Pixels, Statistics};

    fn picture(colours: &[[f32; 3]], coverage: &[u8]) -> Image {
        Image {
            size: [colours.len() as u32, 1],
            pixels: Pixels::Eight(vec![[0; 3]; colours.len()]),
            coverage: coverage.to_vec(),
            linear: Some(colours.to_vec()),
            statistics: Statistics::default(),
        }
    }

    #[test]
    fn a_picture_does_not_differ_from_itself() {
        let image = picture(&[[0.1, 0.2, 0.3], [0.0; 3]], &[1, 0]);
        let error = image_error(&image, &image, 0.0).unwrap();
        assert_eq!(error, ImageError { compared: 1, ..ImageError::default() });
    }

    /// A quarter of red in one pixel, an eighth of blue in the other.
    #[test]
    fn differences_by_hand() {
        let first = picture(&[[0.5, 0.5, 0.5], [0.25, 0.25, 0.5], [9.0; 3]], &[1, 1, 1]);
        let second = picture(&[[0.75, 0.5, 0.5], [0.25, 0.25, 0.375], [0.0; 3]], &[1, 1, 0]);
        let error = image_error(&first, &second, 40.0).unwrap();
        assert_eq!((error.compared, error.disagreeing, error.disagreement), (2, 1, 1.0 / 3.0));
        let expected = Difference {
            max: 63.75,
            mean: (63.75 + 31.875) / 6.0,
            rms: ((63.75_f64 * 63.75 + 31.875 * 31.875) / 6.0).sqrt(),
            over: 0.5,
        };
        assert_eq!(error.linear, expected);
        // 0.2126 of a quarter, 0.0722 of an eighth; within a rounding.
        assert!((error.luminance.max - 0.2126 * 63.75).abs() < 1e-12);
        assert!((error.luminance.mean - (0.2126 * 63.75 + 0.0722 * 31.875) / 2.0).abs() < 1e-12);
        // sRGB of 0.5 and 0.75: 0.735357 and 0.880825 (published to six digits).
        assert!(
            (error.srgb.max / 255.0 - (0.880_825 - 0.735_357)).abs() < 1e-6,
            "{}",
            error.srgb.max / 255.0
        );
    }

    #[test]
    fn a_difference_at_the_threshold_is_not_over_it() {
        let (first, second) = (picture(&[[0.5; 3]], &[1]), picture(&[[0.25; 3]], &[1]));
        assert_eq!(image_error(&first, &second, 63.75).unwrap().linear.over, 0.0);
        assert_eq!(image_error(&first, &second, 63.7).unwrap().linear.over, 1.0);
    }

    #[test]
    fn what_cannot_be_compared_is_refused() {
        let image = picture(&[[0.0; 3]], &[1]);
        let wide = picture(&[[0.0; 3]; 2], &[1, 1]);
        assert_eq!(image_error(&image, &wide, 0.5), Err(MetricError::Sizes([1, 1], [2, 1])));
        let coded = Image { linear: None, ..image.clone() };
        assert_eq!(image_error(&image, &coded, 0.5), Err(MetricError::NoLinear));
        let nothing = image_error(&picture(&[[0.0; 3]], &[0]), &picture(&[[1.0; 3]], &[0]), 0.5).unwrap();
        assert_eq!(nothing, ImageError::default());
    }
}
