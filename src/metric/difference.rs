//! How far pictures differ: colours, and normals drawn as colours.

use super::pairs::{MetricError, Moments, pairs};
use crate::num::{Degrees, LinearRgb, Radians, Transfer};
use crate::raster::Image;
use glam::DVec3;
use serde::Serialize;

/// Steps of 8 bits in the range from 0 to 1: the unit of all differences. Nothing is rounded to it.
const STEPS: f64 = 255.0;

/// The difference of two pictures over the pixels that both cover alike; the others are counted separately.
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
/// *Measures* differences of light, of luminance and of codes. *Does not measure* whether they are visible: a slight change
/// of a large area is less visible than a line between two areas.
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
///     objects: None,
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
    let mut error = ImageError::default();
    let mut sums: [Sum; 3] = std::array::from_fn(|_| Sum { threshold, ..Sum::default() });
    for pair in pairs(picture, truth)? {
        if pair.is_comparable() {
            error.compared += 1;
            let colours = pair.colours;
            sums[0].add(colours);
            sums[1].add(colours.map(|colour| [LinearRgb::from(colour).luminance()]));
            sums[2].add(colours.map(|colour| colour.map(|component| Transfer::Srgb.encode(component))));
        } else {
            error.disagreeing += u64::from(pair.covered != [0, 0]);
        }
    }
    let either = error.compared + error.disagreeing;
    error.disagreement = error.disagreeing as f64 / either.max(1) as f64;
    [error.linear, error.luminance, error.srgb] = sums.map(|sum| sum.finish());
    Ok(error)
}

#[derive(Default)]
struct Sum {
    threshold: f64,
    pixels: u64,
    over: u64,
    components: Moments,
}

impl Sum {
    fn add<const N: usize>(&mut self, [a, b]: [[f64; N]; 2]) {
        let differences: [f64; N] = std::array::from_fn(|i| STEPS * (a[i] - b[i]).abs());
        differences.into_iter().for_each(|difference| self.components.add(difference));
        self.pixels += 1;
        self.over += u64::from(differences.into_iter().any(|difference| difference > self.threshold));
    }

    fn finish(self) -> Difference {
        let Self { pixels, over, components, .. } = self;
        Difference {
            max: components.max,
            mean: components.mean(),
            rms: components.rms(),
            over: over as f64 / pixels.max(1) as f64,
        }
    }
}

/// Angles between the normals of two pictures, in degrees.
#[derive(Clone, Debug, Default, PartialEq, Serialize)]
pub struct NormalDeviation {
    /// Pixels compared: covered in both, by as many of their samples.
    pub compared: u64,
    /// Pixels that only one picture covers, or of which one covers more samples, or whose normals cancel.
    pub disagreeing: u64,
    /// The mean angle.
    pub mean: f64,
    /// The root of the mean square.
    pub rms: f64,
    /// The largest.
    pub max: f64,
    /// The angle of each pixel, in order; `None` where there is no comparison.
    #[serde(skip)]
    pub angles: Vec<Option<f64>>,
}

/// Compares the normals of two pictures drawn with [`Show::Normals`](crate::raster::Show::Normals), pixel by pixel: for instance
/// those of a mesh with those of the surface that it approximates, drawn with
/// [`Shading::Exact`](crate::raster::Shading::Exact).
///
/// The angle is atan2(|a×b|, a·b) of the two means of a pixel's samples. Pictures hold (n + 1)/2 in single precision, so angles
/// are right to about 2·10⁻⁷ rad ≈ 10⁻⁵°. *Measures* the angle at each pixel. *Does not measure* surfaces that are not
/// visible; surfaces seen edge-on have few pixels. *Does not measure* how much light changes: an angle of δ changes diffuse
/// light by at most δ, a highlight by up to [`steepest_slope`](crate::num::steepest_slope)·δ.
///
/// # Errors
/// Pictures of different sizes or without linear colours.
pub fn normal_deviation(picture: &Image, truth: &Image) -> Result<NormalDeviation, MetricError> {
    let mut deviation = NormalDeviation::default();
    let mut moments = Moments::default();
    for pair in pairs(picture, truth)? {
        let [found, expected] = pair.colours.map(normal);
        let angle = if pair.is_comparable() { angle(found, expected) } else { None };
        deviation.angles.push(angle);
        match angle {
            Some(angle) => moments.add(angle),
            None => deviation.disagreeing += u64::from(pair.covered != [0, 0]),
        }
        deviation.compared += u64::from(angle.is_some());
    }
    (deviation.mean, deviation.rms, deviation.max) = (moments.mean(), moments.rms(), moments.max);
    Ok(deviation)
}

/// The normal that a colour of [`Show::Normals`](crate::raster::Show::Normals) encodes.
fn normal(colour: [f64; 3]) -> DVec3 {
    DVec3::from(colour) * 2.0 - 1.0
}

/// The angle in degrees; `None` if one has no direction.
fn angle(a: DVec3, b: DVec3) -> Option<f64> {
    // What cancels leaves the rounding of single precision.
    const NOTHING: f64 = f32::EPSILON as f64;
    let angle = Degrees::from(Radians(libm::atan2(a.cross(b).length(), a.dot(b))));
    (a.length() > NOTHING && b.length() > NOTHING).then_some(angle.0)
}

#[cfg(test)]
mod tests {
    use super::super::pictures_tests::grey;
    use super::*;
    use crate::raster::{Pixels, Statistics};

    fn picture(colours: &[[f32; 3]], coverage: &[u8]) -> Image {
        Image {
            size: [colours.len() as u32, 1],
            pixels: Pixels::Eight(vec![[0; 3]; colours.len()]),
            coverage: coverage.to_vec(),
            linear: Some(colours.to_vec()),
            objects: None,
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

    /// A picture of one row of normals.
    fn normals(list: &[DVec3]) -> Image {
        let mut image = grey([list.len() as u32, 1], |_, _| 0.0);
        image.linear = Some(list.iter().map(|&n| ((n + 1.0) * 0.5).as_vec3().to_array()).collect());
        image
    }

    fn turned(degrees: f64) -> DVec3 {
        let (sine, cosine) = libm::sincos(degrees.to_radians());
        DVec3::new(sine, 0.6 * cosine, 0.8 * cosine)
    }

    #[test]
    fn angles_are_those_given() {
        let angles = [0.0, 0.001, 5.0, 90.0, 179.0];
        let truth = normals(&[turned(0.0); 5]);
        let measured = normal_deviation(&normals(&angles.map(turned)), &truth).unwrap();
        for (angle, expected) in measured.angles.iter().zip(angles) {
            // Two codes in single precision on either side.
            assert!((angle.unwrap() - expected).abs() < 2e-5, "{angle:?} {expected}");
        }
        assert!((measured.mean - angles.iter().sum::<f64>() / 5.0).abs() < 1e-5);
        let square: f64 = angles.iter().map(|angle| angle * angle).sum();
        assert!((measured.rms - (square / 5.0).sqrt()).abs() < 1e-5 && (measured.max - 179.0).abs() < 2e-5);
    }

    #[test]
    fn what_is_not_in_both_is_distinguished() {
        let mut picture = normals(&[DVec3::X, DVec3::Y, DVec3::Z, DVec3::ZERO]);
        let mut truth = normals(&[DVec3::X; 4]);
        picture.coverage = vec![1, 0, 0, 1];
        truth.coverage = vec![1, 1, 0, 1];
        let measured = normal_deviation(&picture, &truth).unwrap();
        assert_eq!((measured.compared, measured.disagreeing, measured.max), (1, 2, 0.0));
        assert_eq!(measured.angles, [Some(0.0), None, None, None]);
        truth.linear = None;
        assert_eq!(normal_deviation(&picture, &truth), Err(MetricError::NoLinear));
    }
}
