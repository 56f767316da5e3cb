//! Luminance along a scanline, and the response of a difference of Gaussians to it, as lateral inhibition predicts.

use super::pairs::{MetricError, luminances};
use crate::raster::{Image, Samples};
use serde::Serialize;
use std::f64::consts::{PI, SQRT_2};

/// Relative luminance Y (ITU-R BT.709, linear) of neighbouring pixels of one row, all covered by all of their samples.
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

    /// x of the centre of a pixel of the profile.
    fn centre(&self, number: usize) -> f64 {
        f64::from(self.start) + number as f64 + 0.5
    }
}

/// Pixels in a degree of the field of view: a monitor 0.7 m wide with 3840 pixels, seen from 0.7 m (the viewing conditions of
/// FLIP, Andersson et al. 2020).
pub const PIXELS_PER_DEGREE: f64 = 67.0;

/// A receptive field with an exciting centre and an inhibiting surround: the Gaussian of the centre less that of the surround,
/// both of area 1, with standard deviations in pixels.
///
/// Its answer to even light and to an even slope is 0. To a break of slope by Δ it is Δ(σs − σc)/√(2π), dark at the foot of
/// a ramp and bright at its knee; next to a step of ΔI it is ΔI (Φ(x/σc) − Φ(x/σs)) at the distance x.
///
/// *Measures* what this linear model predicts for these σ, which are a choice; state them with every number. *Does not
/// measure* what is seen. Wallis & Georgeson (Journal of Vision 12(13):18, 2012) rule out such models as measures of
/// strength: perceived bands hardly grow with contrast, and a step, next to which the model predicts bands, shows none. Call
/// the number *predicted*.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct DifferenceOfGaussians {
    centre: f64,
    surround: f64,
}

/// How far a Gaussian is followed, in standard deviations of the surround. Beyond are 6e-7 of it.
const REACH: f64 = 5.0;

impl Default for DifferenceOfGaussians {
    /// σ of 1 and 1.6 pixels: 0.9 and 1.4 minutes of arc at [`PIXELS_PER_DEGREE`]; the ratio is that at which the difference
    /// comes closest to the Laplacian of a Gaussian (Marr & Hildreth 1980).
    fn default() -> Self {
        Self { centre: 1.0, surround: 1.6 }
    }
}

impl DifferenceOfGaussians {
    /// The standard deviations of centre and surround, in pixels.
    pub fn widths(&self) -> [f64; 2] {
        [self.centre, self.surround]
    }

    /// The answer at a break of slope from g to g + Δ per pixel: Δ(σc − σs)/√(2π), negative (dark) where slope increases.
    pub fn at_corner(&self, jump: f64) -> f64 {
        jump * (self.centre - self.surround) / (2.0 * PI).sqrt()
    }

    /// The largest answer next to a step of ΔI, and its distance: ΔI (Φ(x/σc) − Φ(x/σs)) is largest at
    /// x = σcσs √(2 ln(σs/σc)/(σs² − σc²)). For 1 and 1.6 that is 0.111682 ΔI at 1.2420 pixels.
    pub fn near_step(&self, step: f64) -> (f64, f64) {
        let Self { centre, surround } = *self;
        let spread = (surround - centre) * (surround + centre);
        let at = centre * surround * (2.0 * libm::log(surround / centre) / spread).sqrt();
        (step * (normal_share(at / centre) - normal_share(at / surround)), at)
    }

    /// x and answer along a profile, at the pixels that are at least 5 σ of the surround from its ends; none if it is shorter.
    ///
    /// Pixels are squares of even light, as a screen shows them: Gaussians are integrated over each. So a step between
    /// pixels is answered exactly, and a break of slope at a pixel's centre by 1 + 1/(24 σcσs) times the answer to the
    /// unbroken ramp, and less where σ is larger.
    pub fn along(&self, profile: &Profile) -> Vec<[f64; 2]> {
        let reach = (REACH * self.surround).ceil() as usize;
        let (centre, surround) = (kernel(self.centre, reach), kernel(self.surround, reach));
        let weights: Vec<f64> = centre.iter().zip(&surround).map(|(c, s)| c - s).collect();
        let windows = profile.luminance.windows(weights.len()).enumerate();
        let answer = |window: &[f64]| window.iter().zip(&weights).map(|(y, weight)| y * weight).sum();
        windows.map(|(i, window)| [profile.centre(i + reach), answer(window)]).collect()
    }
}

/// Φ: the share of a normal distribution below `x` standard deviations.
fn normal_share(x: f64) -> f64 {
    0.5 * libm::erfc(-x / SQRT_2)
}

/// A Gaussian integrated over pixels, with area 1.
fn kernel(width: f64, reach: usize) -> Vec<f64> {
    let edge = |pixel: f64| normal_share(pixel / width);
    let half: Vec<f64> =
        (0..=reach).map(|pixel| edge(0.5 - pixel as f64) - edge(-0.5 - pixel as f64)).collect();
    let area = half[0] + 2.0 * half[1..].iter().sum::<f64>();
    half[1..].iter().rev().chain(&half).map(|weight| weight / area).collect()
}

#[cfg(test)]
mod tests {
    use super::super::pictures_tests::shape;
    use super::*;

    #[test]
    fn gaps_and_partly_covered_pixels_part_runs() {
        let image = shape([12, 1], Samples::Four, |x, _| x > 1.4 && !(6.0..=8.0).contains(&x));
        let runs = Profile::of_row(&image, Samples::Four, 0).unwrap();
        let spans: Vec<(u32, usize)> = runs.iter().map(|run| (run.start, run.luminance.len())).collect();
        assert_eq!(spans, [(2, 4), (8, 4)]);
        let beyond = Profile::of_row(&image, Samples::Four, 1);
        assert_eq!(beyond, Err(MetricError::Row { row: 1, height: 1 }));
    }

    fn profile(value: impl Fn(f64) -> f64) -> Profile {
        Profile { row: 0, start: 0, luminance: (0..200).map(|i| value(f64::from(i) + 0.5)).collect() }
    }

    fn of(surround: f64) -> DifferenceOfGaussians {
        DifferenceOfGaussians { centre: 1.0, surround }
    }

    #[derive(Debug)]
    struct Overshoot {
        bright: f64,
        bright_at: f64,
        dark: f64,
        dark_at: f64,
    }

    /// The largest and the smallest answer along a profile.
    fn overshoot(model: &DifferenceOfGaussians, profile: &Profile) -> Overshoot {
        let answers = model.along(profile);
        let by_answer = |a: &&[f64; 2], b: &&[f64; 2]| a[1].total_cmp(&b[1]);
        let [bright_at, bright] = *answers.iter().max_by(by_answer).unwrap();
        let [dark_at, dark] = *answers.iter().rev().min_by(by_answer).unwrap();
        Overshoot { bright, bright_at, dark, dark_at }
    }

    /// The figures of the closed forms, to the digits that they were computed to independently.
    #[test]
    fn figures_by_formula() {
        for (surround, corner, step) in
            [(1.6, 0.239_365, 0.111_682), (2.0, 0.398_942, 0.161_337), (5.0, 1.595_769, 0.323_558)]
        {
            assert!((of(surround).at_corner(-1.0) - corner).abs() < 1e-6);
            assert!((of(surround).near_step(1.0).0 - step).abs() < 1e-6);
        }
        assert!((of(3.0).near_step(2.0).0 - 2.0 * 0.242_164).abs() < 2e-6);
        assert!((of(1.6).near_step(1.0).1 - 1.242_0).abs() < 1e-4);
        let [centre, surround] =
            DifferenceOfGaussians::default().widths().map(|width| width / PIXELS_PER_DEGREE);
        assert!((60.0 * centre - 0.895_5).abs() < 1e-4 && (60.0 * surround - 1.432_8).abs() < 1e-4);
    }

    #[test]
    fn even_light_and_slopes_have_no_answer() {
        for flat in [profile(|_| 0.7), profile(|x| 0.001 * x)] {
            let overshoot = overshoot(&DifferenceOfGaussians::default(), &flat);
            // Seventeen products of numbers below 1.
            assert!(overshoot.bright < 1e-15 && overshoot.dark > -1e-15, "{overshoot:?}");
        }
        let short = Profile { row: 0, start: 0, luminance: vec![1.0; 16] };
        assert!(DifferenceOfGaussians::default().along(&short).is_empty());
    }

    /// A step between pixels: Φ(x/σc) − Φ(x/σs) at every pixel centre, by erf; what is cut off is below 1e-6.
    #[test]
    fn a_step_is_answered_by_the_closed_form() {
        for surround in [1.6, 2.0, 5.0] {
            let model = of(surround);
            let step = profile(|x| if x > 100.0 { 0.6 } else { 0.2 });
            for [x, answer] in model.along(&step) {
                let t = x - 100.0;
                let share = |width: f64| 0.5 * libm::erf(t / (width * SQRT_2));
                let expected = 0.4 * (share(1.0) - share(surround));
                assert!((answer - expected).abs() < 1e-6, "{surround} {x}: {answer} {expected}");
            }
            let (largest, at) = model.near_step(0.4);
            let overshoot = overshoot(&model, &step);
            assert!(overshoot.bright <= largest + 1e-6 && overshoot.bright > 0.9 * largest);
            assert!((overshoot.bright_at - 100.0 - at).abs() < 1.0, "nearest pixel");
            assert!((overshoot.bright + overshoot.dark).abs() < 1e-12, "steps are symmetric");
        }
    }

    /// A ramp: dark at the foot, bright at the knee, by the closed form and the stated effect of pixels.
    #[test]
    fn a_ramp_is_answered_by_the_closed_form() {
        for (centre, surround) in [(1.0, 1.6), (2.0, 3.2), (4.0, 6.4)] {
            let model = DifferenceOfGaussians { centre, surround };
            let ramp = profile(|x| 0.01 * (x - 60.5).clamp(0.0, 80.0));
            let overshoot = overshoot(&model, &ramp);
            let expected = model.at_corner(-0.01) * (1.0 + 1.0 / (24.0 * centre * surround));
            // The next terms of Euler and Maclaurin's formula are a thousandth of these at σ = 1.
            assert!((overshoot.bright / expected - 1.0).abs() < 2e-3, "{overshoot:?} {expected}");
            assert!((overshoot.dark / expected + 1.0).abs() < 2e-3, "{overshoot:?} {expected}");
            assert_eq!((overshoot.dark_at, overshoot.bright_at), (60.5, 140.5));
        }
    }
}
