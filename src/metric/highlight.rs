//! The brightest spot of a picture.

use super::pairs::{MetricError, luminances, same_size};
use crate::raster::Image;
use serde::Serialize;

/// The brightest spot of a picture: the peak of its highlight, if it has one.
///
/// The covered pixel of the largest relative luminance. If its four neighbours are covered alike and at most four pixels
/// have that luminance, position and peak are those of the parabolas through the logarithms of it and its neighbours, across
/// and down; of more pixels with exactly the same luminance, such as flat faces have, the position is the mean.
///
/// *Accuracy*: exact for a Gaussian, up to the single precision of pictures: 10⁻⁷σ² pixels; cosⁿ is nearly one. At a corner
/// of Gouraud shading, where luminance has no parabola, within half a pixel. *Does not measure* whether the brightest spot
/// is a highlight, or the only one: light the object accordingly.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct Highlight {
    /// The largest luminance, linear and not clamped.
    pub peak: f64,
    /// Its position, in pixels.
    pub at: [f64; 2],
}

/// The change of a highlight.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct HighlightChange {
    /// The peak over the true one; 1 if both are 0.
    pub peak_ratio: f64,
    /// Its distance from the true position, in pixels; if the peak is lost, the distance to the brightest spot.
    pub displacement: f64,
}

impl Highlight {
    /// Finds it.
    ///
    /// # Errors
    /// A picture without linear colours, or in which nothing is covered.
    pub fn of(image: &Image) -> Result<Self, MetricError> {
        let values = luminances(image)?;
        let covered =
            || values.iter().zip(&image.coverage).enumerate().filter(|(_, (_, covered))| **covered > 0);
        let largest =
            covered().map(|(_, (&value, _))| value).max_by(f64::total_cmp).ok_or(MetricError::Empty)?;
        let width = image.size[0] as usize;
        let place = |pixel: usize| [(pixel % width) as f64 + 0.5, (pixel / width) as f64 + 0.5];
        let equal: Vec<usize> =
            covered().filter(|(_, (value, _))| **value == largest).map(|(pixel, _)| pixel).collect();
        // A peak between pixel centres may leave four alike.
        if equal.len() <= 4
            && let Some(found) = refined(image, &values, equal[0], place(equal[0]))
        {
            return Ok(found);
        }
        let mean =
            |axis: usize| equal.iter().map(|&pixel| place(pixel)[axis]).sum::<f64>() / equal.len() as f64;
        Ok(Self { peak: largest, at: [mean(0), mean(1)] })
    }

    /// How this one differs from the true one.
    pub fn against(&self, truth: &Self) -> HighlightChange {
        HighlightChange {
            peak_ratio: if self.peak == truth.peak { 1.0 } else { self.peak / truth.peak },
            displacement: libm::hypot(self.at[0] - truth.at[0], self.at[1] - truth.at[1]),
        }
    }

    /// How the highlight of one picture differs from that of a true one of the same size.
    ///
    /// # Errors
    /// Those of [`of`](Self::of); different sizes.
    pub fn change(picture: &Image, truth: &Image) -> Result<HighlightChange, MetricError> {
        same_size(picture, truth)?;
        Ok(Self::of(picture)?.against(&Self::of(truth)?))
    }
}

/// The peak of the parabolas through a pixel and its neighbours; `None` at borders, next to black and in even light.
fn refined(image: &Image, values: &[f64], pixel: usize, place: [f64; 2]) -> Option<Highlight> {
    let width = image.size[0] as usize;
    let (x, y) = (pixel % width, pixel / width);
    if x == 0 || y == 0 || x + 1 == width || y + 1 == image.size[1] as usize {
        return None;
    }
    let (mut gain, mut at) = (0.0, place);
    for (axis, step) in [1, width].into_iter().enumerate() {
        let neighbours = [pixel - step, pixel + step];
        let usable = |other: usize| image.coverage[other] == image.coverage[pixel] && values[other] > 0.0;
        if !neighbours.into_iter().all(usable) {
            return None;
        }
        let [before, beyond] = neighbours.map(|other| libm::log(values[other] / values[pixel]));
        let slope = 0.5 * (beyond - before);
        let curvature = beyond + before;
        if curvature >= 0.0 {
            return None;
        }
        at[axis] -= slope / curvature;
        gain -= 0.5 * slope * slope / curvature;
    }
    Some(Highlight { peak: values[pixel] * libm::exp(gain), at })
}

#[cfg(test)]
mod tests {
    use super::super::pictures_tests::{grey, shape};
    use super::*;
    use crate::raster::Samples;

    fn gaussian(centre: [f64; 2], width: f64, peak: f64) -> Image {
        grey([48, 40], |x, y| {
            let square = (x - centre[0]) * (x - centre[0]) + (y - centre[1]) * (y - centre[1]);
            peak * libm::exp(-0.5 * square / (width * width))
        })
    }

    #[test]
    fn shifted_gaussians_are_found() {
        for width in [2.0, 4.0] {
            for step in 0..20 {
                let centre = [20.0 + 0.05 * f64::from(step), 17.5 + 0.03 * f64::from(step)];
                let found = Highlight::of(&gaussian(centre, width, 0.8)).unwrap();
                // Single precision, 6e-8, against a curvature of 1/σ².
                let off = libm::hypot(found.at[0] - centre[0], found.at[1] - centre[1]);
                assert!(off < 3e-7 * width * width, "{width} {centre:?}: {off}");
                assert!((found.peak / 0.8 - 1.0).abs() < 3e-7, "{width}: {}", found.peak);
            }
            let truth = gaussian([20.3, 20.6], width, 0.8);
            let change = Highlight::change(&gaussian([23.3, 16.6], width, 0.6), &truth).unwrap();
            // The same place in the pixel: both are off alike.
            assert!((change.displacement - 5.0).abs() < 1e-5 && (change.peak_ratio - 0.75).abs() < 1e-6);
        }
    }

    #[test]
    fn even_faces_have_their_middle() {
        let image = grey([12, 10], |x, y| if x > 4.0 && x < 9.0 && y > 2.0 && y < 5.0 { 0.7 } else { 0.1 });
        let found = Highlight::of(&image).unwrap();
        assert_eq!((found.at, found.peak as f32), ([6.5, 3.5], 0.7));
    }

    #[test]
    fn borders_are_taken_as_they_are_and_nothing_is_an_error() {
        let found = Highlight::of(&grey([5, 5], |x, _| x)).unwrap();
        assert_eq!(found.at, [4.5, 2.5]);
        assert!((found.peak - 4.5).abs() < 1e-14);
        let nothing = shape([4, 4], Samples::One, |_, _| false);
        assert_eq!(Highlight::of(&nothing), Err(MetricError::Empty));
        let small = grey([3, 3], |_, _| 1.0);
        assert_eq!(Highlight::change(&small, &nothing), Err(MetricError::Sizes([3, 3], [4, 4])));
    }
}
