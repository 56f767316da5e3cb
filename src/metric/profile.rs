//! Luminance along a scanline.

use super::MetricError;
use super::luminance::luminances;
use crate::raster::{Image, Samples};
use serde::Serialize;

/// Relative luminance Y (ITU-R BT.709, linear) of neighbouring pixels of one row, all covered by all of their samples.
///
/// *Claims*: the samples and their differences, nothing between them. *Does not claim* that a peak of the second derivative
/// is seen as a band: Wallis & Georgeson (*Mach bands and multiscale models of spatial vision*, Journal of Vision 12(13):18,
/// 2012) rule out models by the second derivative alone; what is seen goes with its ratio to the first at the
/// scale where the response peaks, and hardly with contrast.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Profile {
    /// The row, from 0 at the top.
    pub row: u32,
    /// The column of the first pixel.
    pub start: u32,
    /// One number a pixel.
    pub luminance: Vec<f64>,
}

impl Profile {
    /// The runs of covered pixels of a row, from left to right; none if nothing is covered there.
    ///
    /// # Errors
    /// A picture without linear colours, a row that it does not have.
    pub fn of_row(image: &Image, samples: Samples, row: u32) -> Result<Vec<Self>, MetricError> {
        let luminances = luminances(image)?;
        let [width, height] = image.size;
        if row >= height {
            return Err(MetricError::Row { row, height });
        }
        let full = samples.count();
        let mut profiles: Vec<Self> = Vec::new();
        for x in 0..width {
            let pixel = row as usize * width as usize + x as usize;
            if usize::from(image.coverage[pixel]) < full {
                continue;
            }
            match profiles.last_mut() {
                Some(run) if run.start as usize + run.luminance.len() == x as usize => {
                    run.luminance.push(luminances[pixel]);
                }
                _ => profiles.push(Self { row, start: x, luminance: vec![luminances[pixel]] }),
            }
        }
        Ok(profiles)
    }

    /// The part between two columns, the second not included.
    #[must_use]
    pub fn between(&self, from: u32, to: u32) -> Self {
        let end = self.start + self.luminance.len() as u32;
        let start = from.clamp(self.start, end);
        let range = (start - self.start) as usize..(to.clamp(start, end) - self.start) as usize;
        Self { row: self.row, start, luminance: self.luminance[range].to_vec() }
    }

    /// x and Y of pixel centres.
    pub fn points(&self) -> Vec<[f64; 2]> {
        self.luminance.iter().enumerate().map(|(i, &y)| [self.centre(i), y]).collect()
    }

    /// x and Y′ per pixel between neighbouring centres: Y(x + ½) − Y(x − ½), the mean slope between them. One point
    /// fewer than pixels.
    pub fn slopes(&self) -> Vec<[f64; 2]> {
        let pairs = self.luminance.windows(2).enumerate();
        pairs.map(|(i, pair)| [self.centre(i) + 0.5, pair[1] - pair[0]]).collect()
    }

    /// x and Y″ per square pixel at centres: Y(x − 1) − 2Y(x) + Y(x + 1). Two points fewer than pixels. A break of slope
    /// by Δ anywhere between two centres adds up to Δ over the two.
    pub fn curvatures(&self) -> Vec<[f64; 2]> {
        let triples = self.luminance.windows(3).enumerate();
        triples.map(|(i, y)| [self.centre(i) + 1.0, (y[2] - y[1]) - (y[1] - y[0])]).collect()
    }

    /// x of the centre of a pixel of the profile.
    pub(super) fn centre(&self, number: usize) -> f64 {
        f64::from(self.start) + number as f64 + 0.5
    }
}

#[cfg(test)]
mod tests {
    use super::super::pictures_tests::{grey, shape};
    use super::*;

    #[test]
    fn derivatives_of_a_parabola_are_exact() {
        // Dyadic numbers, rounded only where the three components are added up: two units in the last place of 10.
        let image = grey([9, 3], |x, y| 0.25 * (x - 4.5) * (x - 4.5) + y);
        let [profile] = &Profile::of_row(&image, Samples::One, 1).unwrap()[..] else { panic!("one run") };
        let is = |found: f64, expected: f64| (found - expected).abs() < 1e-14;
        assert!(profile.slopes().iter().all(|&[x, slope]| is(slope, 0.5 * (x - 4.5))));
        assert!(profile.curvatures().iter().all(|&[_, curvature]| is(curvature, 0.5)));
        assert_eq!((profile.points().len(), profile.slopes().len(), profile.curvatures().len()), (9, 8, 7));
        let [x, first] = profile.points()[0];
        assert!(x == 0.5 && is(first, 5.5), "{first}");
    }

    #[test]
    fn gaps_and_partly_covered_pixels_part_runs() {
        let image = shape([12, 1], Samples::Four, |x, _| x > 1.4 && !(6.0..=8.0).contains(&x));
        let runs = Profile::of_row(&image, Samples::Four, 0).unwrap();
        let spans: Vec<(u32, usize)> = runs.iter().map(|run| (run.start, run.luminance.len())).collect();
        assert_eq!(spans, [(2, 4), (8, 4)]);
        assert_eq!(runs[1].between(9, 11).start, 9);
        assert_eq!(runs[1].between(9, 11).luminance.len(), 2);
        assert_eq!(runs[1].between(20, 30).luminance.len(), 0);
        let beyond = Profile::of_row(&image, Samples::Four, 1);
        assert_eq!(beyond, Err(MetricError::Row { row: 1, height: 1 }));
    }
}
