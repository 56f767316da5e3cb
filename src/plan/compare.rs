//! Pictures compared before their values are rounded, and outlines.

use crate::metric::{Contour, FLIP_PIXELS_PER_DEGREE, MetricError, Perceived, contour_distance};
use crate::num::{Transfer, three_digits};
use crate::raster::{Image, RenderSettings, Samples};
use crate::shade::ToneRule;
use std::cell::OnceCell;

/// Pixels beyond the tolerance, in excess of those allowed, after which a comparison ends.
const ENOUGH: u64 = 256;

/// The largest value of a code.
const STEPS: f64 = 255.0;

/// How pictures are compared.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, serde::Serialize)]
#[serde(rename_all = "lowercase")]
pub enum Metric {
    /// The largest difference over pixels and channels that show the same objects.
    #[default]
    Steps,
    /// The mean of ꟻLIP over the whole picture, outlines included.
    Flip,
}

impl Metric {
    /// A difference as reports print it.
    pub fn text(self, difference: f64) -> String {
        match self {
            Self::Steps => format!("{} steps", three_digits(difference)),
            Self::Flip => format!("ꟻLIP {}", three_digits(difference)),
        }
    }
}

/// The largest difference of two pictures, where it is, and how many pixels are beyond the tolerance.
#[derive(Clone, Copy, Debug, Default, PartialEq, serde::Serialize)]
pub struct Difference {
    /// In steps of 1/255 of the encoded values, before they are rounded.
    pub steps: f64,
    /// Column and row.
    pub pixel: [u32; 2],
    /// Pixels whose difference is above the tolerance.
    pub beyond: u64,
    /// The mean of ꟻLIP, if pictures are compared by it.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub flip: Option<f64>,
}

impl Difference {
    /// The difference by a metric.
    pub fn by(&self, metric: Metric) -> f64 {
        match metric {
            Metric::Steps => self.steps,
            Metric::Flip => self.flip.unwrap_or(0.0),
        }
    }
}

/// The picture of the reference from one view.
#[derive(Clone, Debug)]
pub struct Truth {
    /// The picture.
    pub image: Image,
    /// Encoded values of all channels, 0 to 255.
    codes: Vec<[f64; 3]>,
    tone: ToneRule,
    transfer: Transfer,
    samples: Samples,
    /// What an eye sees of it, computed when it is needed.
    perceived: OnceCell<Perceived>,
}

impl Truth {
    /// Of a picture with linear colours and objects.
    pub fn new(image: Image, settings: &RenderSettings) -> Self {
        let RenderSettings { tone, transfer, samples, .. } = *settings;
        let linear = image.linear.as_deref().unwrap_or_default();
        let codes = linear.iter().map(|&colour| encoded(tone, transfer, colour)).collect();
        Self { image, codes, tone, transfer, samples, perceived: OnceCell::new() }
    }

    /// The samples of each of its pixels.
    pub fn samples(&self) -> Samples {
        self.samples
    }

    /// The mean of ꟻLIP over all pixels.
    ///
    /// # Errors
    /// Pictures that cannot be compared.
    pub fn flip(&self, picture: &Image) -> Result<f64, MetricError> {
        let perceived = |image| Perceived::new(&self.displayed(image), FLIP_PIXELS_PER_DEGREE);
        let theirs = perceived(picture)?;
        if self.perceived.get().is_none() {
            let _ = self.perceived.set(perceived(&self.image)?);
        }
        let Some(ours) = self.perceived.get() else { return Ok(0.0) };
        Ok(theirs.flip(ours).mean)
    }

    /// A picture with the light that a screen makes of its codes, which takes them for sRGB.
    fn displayed(&self, image: &Image) -> Image {
        let code = |colour: &[f32; 3]| encoded(self.tone, self.transfer, *colour);
        let light = |code: f64| Transfer::Srgb.decode(code / STEPS) as f32;
        let linear = image.linear.as_ref();
        let linear = linear.map(|colours| colours.iter().map(|colour| code(colour).map(light)).collect());
        Image { linear, ..image.clone() }
    }

    /// The difference of a picture over the pixels that `is_compared`. Pixels beyond the tolerance are counted
    /// up to `most` and a few more, so that a bad one is found.
    pub fn difference(
        &self,
        picture: &Image,
        tolerance: f64,
        most: u64,
        is_compared: impl Fn(usize) -> bool,
    ) -> Difference {
        let (ours, theirs) = (self.image.linear.as_deref(), picture.linear.as_deref());
        let (ours, theirs) = (ours.unwrap_or_default(), theirs.unwrap_or_default());
        let mut worst = Difference::default();
        for (pixel, (ours, theirs)) in ours.iter().zip(theirs).enumerate() {
            if ours == theirs || !is_compared(pixel) {
                continue;
            }
            if self.tone == ToneRule::Clamp && !self.may_exceed(*ours, *theirs, worst.steps.min(tolerance)) {
                continue;
            }
            let other = encoded(self.tone, self.transfer, *theirs);
            let codes = self.codes[pixel].iter().zip(other);
            let steps = codes.map(|(code, other)| (code - other).abs()).fold(0.0, f64::max);
            if steps > worst.steps {
                let width = picture.size[0] as usize;
                worst.steps = steps;
                worst.pixel = [(pixel % width) as u32, (pixel / width) as u32];
            }
            worst.beyond += u64::from(steps > tolerance);
            if worst.beyond > most.saturating_add(ENOUGH) {
                break;
            }
        }
        worst
    }

    /// The difference of a linear colour from that of a pixel, in steps.
    pub fn steps_at(&self, [x, y]: [u32; 2], colour: [f32; 3]) -> f64 {
        let Some(pixel) = self.image.index(x, y) else { return 0.0 };
        let codes = self.codes[pixel].iter().zip(encoded(self.tone, self.transfer, colour));
        codes.map(|(code, other)| (code - other).abs()).fold(0.0, f64::max)
    }

    /// The least difference of a pixel from linear colours within these ends, in steps: 0 if one of them is its own. A tone rule
    /// that divides makes a channel smallest where the others are largest. The step of 10⁻⁷ where the pieces of the curve of sRGB meet
    /// is allowed for.
    pub fn steps_between(&self, [x, y]: [u32; 2], low: [f64; 3], high: [f64; 3]) -> f64 {
        let Some(pixel) = self.image.index(x, y) else { return 0.0 };
        let code = |channel: usize, own: [f64; 3], mut others: [f64; 3]| {
            others[channel] = own[channel];
            STEPS * self.transfer.encode(self.tone.apply(others)[channel])
        };
        let channels = self.codes[pixel].iter().enumerate();
        channels
            .map(|(channel, own)| (code(channel, low, high) - own).max(own - code(channel, high, low)) - 1e-4)
            .fold(0.0, f64::max)
    }

    /// The difference of each pixel and channel in steps, and the largest one.
    pub fn code_differences(&self, picture: &Image) -> (Vec<[f64; 3]>, f64) {
        let linear = picture.linear.as_deref().unwrap_or_default();
        let of_pixel = |(codes, colour): (&[f64; 3], &[f32; 3])| {
            let other = encoded(self.tone, self.transfer, *colour);
            std::array::from_fn(|channel| (codes[channel] - other[channel]).abs())
        };
        let steps: Vec<[f64; 3]> = self.codes.iter().zip(linear).map(of_pixel).collect();
        let largest = steps.iter().flatten().copied().fold(0.0, f64::max);
        (steps, largest)
    }

    /// Whether two colours may differ by more than so many steps. The curve of sRGB is concave but for a step of 10⁻⁷ where its
    /// pieces meet, so the slope at the smaller value bounds the difference.
    fn may_exceed(&self, ours: [f32; 3], theirs: [f32; 3], steps: f64) -> bool {
        (0..3).any(|channel| {
            let (a, b) = (f64::from(ours[channel]), f64::from(theirs[channel]));
            let low = a.min(b).max(0.0);
            STEPS * self.slope(low) * (a - b).abs() + 1e-4 > steps
        })
    }

    /// A bound on the slope of the transfer curve at a value and above it.
    fn slope(&self, value: f64) -> f64 {
        /// Values, and the slope 1.055/2.4 x^(1/2.4 − 1) there, rounded up.
        const SLOPES: [(f64, f64); 6] =
            [(0.5, 0.66), (0.25, 0.99), (0.125, 1.48), (0.0625, 2.22), (0.03125, 3.32), (0.0156, 4.98)];
        match self.transfer {
            Transfer::Direct => 1.0,
            Transfer::Srgb => {
                SLOPES.iter().find(|(from, _)| value >= *from).map_or(12.93, |(_, slope)| *slope)
            }
        }
    }
}

fn encoded(tone: ToneRule, transfer: Transfer, colour: [f32; 3]) -> [f64; 3] {
    tone.apply(colour.map(f64::from)).map(|component| STEPS * transfer.encode(component))
}

/// How far the outlines of two pictures are from each other, in pixels: 0 if both cover the same. Each picture has its samples of a pixel.
///
/// # Errors
/// A picture in which nothing is covered, next to one in which something is.
pub fn outline_distance(
    (picture, samples): (&Image, Samples),
    (truth, samples_of_truth): (&Image, Samples),
) -> Result<f64, MetricError> {
    if samples == samples_of_truth && picture.coverage == truth.coverage {
        return Ok(0.0);
    }
    Ok(contour_distance(&Contour::of(picture, samples), &Contour::of(truth, samples_of_truth))?.hausdorff)
}
