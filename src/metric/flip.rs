//! ꟻLIP: how different two pictures look when a viewer flips between them (Andersson, Nilsson, Akenine-Möller, Oskarsson,
//! Åström & Fairchild, *FLIP: A difference evaluator for alternating images*, HPG 2020), for pictures of low dynamic range.

use super::pairs::{MetricError, same_size};
use crate::num::CompensatedSum;
use crate::num::parallel;
use crate::raster::Image;
use std::f64::consts::{FRAC_1_SQRT_2, PI};

/// The viewing conditions of the paper, in pixels per degree: a screen 0.7 m wide with 3840 pixels, seen from 0.7 m.
pub const FLIP_PIXELS_PER_DEGREE: f64 = 0.7 * 3840.0 / 0.7 * PI / 180.0;

/// Contrast sensitivity as sums of Gaussians, (a, b) each, by opponent channel: achromatic, red-green, blue-yellow (table 1).
const SENSITIVITY: [&[[f64; 2]]; 3] = [&[[1.0, 0.0047]], &[[1.0, 0.0053]], &[[34.1, 0.04], [13.5, 0.025]]];
/// The largest b above: it sets the radius of all filters.
const WIDEST: f64 = 0.04;
/// Exponent q_c of colour differences; below p_c of the largest they fill the range to p_t (§4.1.4).
const COLOUR_EXPONENT: f64 = 0.7;
const KNEE: f64 = 0.4;
const KNEE_VALUE: f64 = 0.95;
/// The width of the edges that eyes are most sensitive to, in degrees (§4.2).
const FEATURE_WIDTH: f64 = 0.082;

/// The result of [`flip`].
#[derive(Clone, Debug, PartialEq)]
pub struct Flip {
    /// The mean over all pixels, from 0 (no visible difference) to 1.
    pub mean: f64,
    /// The value of every pixel, in order.
    pub map: Vec<f64>,
}

/// Compares two pictures of one size by their linear samples, clamped to 0…1; both drawn with
/// [`keep_linear`](crate::raster::RenderSettings::keep_linear). `pixels_per_degree` sets the distance of the viewer: see
/// [`FLIP_PIXELS_PER_DEGREE`].
///
/// *Measures* how visible differences of colour are after the blur of the eye, more so at edges and points that only one
/// picture has. *Does not measure* differences in size of codes: that is [`image_error`](super::image_error).
///
/// Values agree with those of the authors' tool (flip-evaluator 1.7, which computes in `f32`) to 4·10⁻⁵.
///
/// # Errors
/// [`MetricError`].
pub fn flip(picture: &Image, truth: &Image, pixels_per_degree: f64) -> Result<Flip, MetricError> {
    same_size(picture, truth)?;
    let of = |image: &Image| Perceived::new(image, pixels_per_degree);
    Ok(of(picture)?.flip(&of(truth)?))
}

fn linear(image: &Image) -> Result<Vec<[f64; 3]>, MetricError> {
    let colours = image.linear.as_ref().ok_or(MetricError::NoLinear)?;
    Ok(colours.iter().map(|colour| colour.map(|value| f64::from(value).clamp(0.0, 1.0))).collect())
}

/// What an eye sees of one picture: to compare many pictures with one.
#[derive(Clone, Debug)]
pub struct Perceived {
    /// The blurred colour in CIELAB, its chroma scaled by lightness (Hunt's effect).
    lab: Vec<[f64; 3]>,
    /// The strength of edges and of points (and lines) in the luminance of each pixel.
    edges: Vec<f64>,
    points: Vec<f64>,
}

impl Perceived {
    /// Of a picture with linear samples.
    ///
    /// # Errors
    /// [`MetricError::NoLinear`].
    pub fn new(image: &Image, pixels_per_degree: f64) -> Result<Self, MetricError> {
        let (linear, size) = (linear(image)?, image.size);
        let plane = |of: &(dyn Fn([f64; 3]) -> f64 + Sync)| Plane {
            width: size[0] as usize,
            values: parallel::map_each(&linear, |&colour| of(colour)),
        };
        let blurred: [Plane; 3] = std::array::from_fn(|channel| {
            let of = plane(&|colour| opponent(colour)[channel]);
            of.blurred(SENSITIVITY[channel], pixels_per_degree)
        });
        let lab = parallel::map(linear.len(), |pixel| {
            let colour = from_opponent(blurred.each_ref().map(|plane| plane.values[pixel]));
            hunt_lab(colour.map(|component| component.clamp(0.0, 1.0)))
        });
        let luminance = plane(&|colour| relative(colour)[1]);
        let [edges, points] = luminance.features(0.5 * FEATURE_WIDTH * pixels_per_degree);
        Ok(Self { lab, edges, points })
    }

    /// Compares two pictures of one size.
    pub fn flip(&self, other: &Self) -> Flip {
        let largest = power(hyab(hunt_lab([0.0, 1.0, 0.0]), hunt_lab([0.0, 0.0, 1.0])));
        let value = |pixel: usize| {
            let colour = spread(power(hyab(self.lab[pixel], other.lab[pixel])), largest);
            let change = |of: fn(&Self) -> &[f64]| (of(self)[pixel] - of(other)[pixel]).abs();
            let feature = change(|seen| &seen.edges).max(change(|seen| &seen.points));
            libm::pow(colour, 1.0 - (FRAC_1_SQRT_2 * feature).sqrt())
        };
        let pixels = self.lab.len().min(other.lab.len());
        let map = parallel::map(pixels, value);
        let mut sum = CompensatedSum::default();
        map.iter().for_each(|&value| sum += value);
        Flip { mean: sum.value() / map.len().max(1) as f64, map }
    }
}

/// One channel of a picture.
struct Plane {
    width: usize,
    values: Vec<f64>,
}

impl Plane {
    /// Convolved with a kernel along rows and another along columns, both of odd length. Beyond the border, the pixels at it
    /// repeat.
    fn convolved(&self, along_rows: &[f64], along_columns: &[f64]) -> Self {
        let height = self.values.len() / self.width.max(1);
        let clamped = |at: usize, tap: usize, radius: usize, count: usize| {
            (at + tap).saturating_sub(radius).min(count - 1)
        };
        let pass = |values: &[f64], kernel: &[f64], is_row: bool| -> Vec<f64> {
            let radius = kernel.len() / 2;
            let at = |pixel: usize| {
                let (x, y) = (pixel % self.width, pixel / self.width);
                let taps = kernel.iter().enumerate().map(|(tap, weight)| {
                    let source = match is_row {
                        true => y * self.width + clamped(x, tap, radius, self.width),
                        false => clamped(y, tap, radius, height) * self.width + x,
                    };
                    weight * values[source]
                });
                taps.sum()
            };
            parallel::map(values.len(), at)
        };
        let rows = pass(&self.values, along_rows, true);
        Self { width: self.width, values: pass(&rows, along_columns, false) }
    }

    /// Filtered by a contrast sensitivity a √(π/b) e^(−π² d² / b), summed over (a, b), where d is in degrees.
    fn blurred(&self, sensitivity: &[[f64; 2]], pixels_per_degree: f64) -> Self {
        let radius = (3.0 * (WIDEST / (2.0 * PI * PI)).sqrt() * pixels_per_degree).ceil() as i32;
        let mut sum = vec![0.0; self.values.len()];
        let mut total = 0.0;
        for &[a, b] in sensitivity {
            let gaussian = |x: i32| {
                let degrees = f64::from(x) / pixels_per_degree;
                libm::exp(-PI * PI * degrees * degrees / b)
            };
            let kernel: Vec<f64> = (-radius..=radius).map(gaussian).collect();
            let height = a * (PI / b).sqrt();
            let side: f64 = kernel.iter().sum();
            total += height * side * side;
            let blurred = self.convolved(&kernel, &kernel);
            sum.iter_mut().zip(blurred.values).for_each(|(sum, value)| *sum += height * value);
        }
        sum.iter_mut().for_each(|value| *value /= total);
        Self { width: self.width, values: sum }
    }

    /// The lengths of the gradients of first and of second derivatives of Gaussians, whose positive weights add up to 1 and
    /// whose negative ones to −1: edges, and points.
    fn features(&self, deviation: f64) -> [Vec<f64>; 2] {
        let radius = (3.0 * deviation).ceil() as i32;
        let kernel = |derivative: fn(f64) -> f64| -> Vec<f64> {
            let weight = |x: i32| {
                let x = f64::from(x) / deviation;
                derivative(x) * libm::exp(-0.5 * x * x)
            };
            (-radius..=radius).map(weight).collect()
        };
        let scaled = |kernel: Vec<f64>| -> Vec<f64> {
            let side = |sign: f64| kernel.iter().map(|weight| (sign * weight).max(0.0)).sum::<f64>();
            let (above, below) = (side(1.0), side(-1.0));
            kernel.iter().map(|&weight| if weight > 0.0 { weight / above } else { weight / below }).collect()
        };
        let smooth = kernel(|_| 1.0);
        let total: f64 = smooth.iter().sum();
        let smooth: Vec<f64> = smooth.iter().map(|weight| weight / total).collect();
        [kernel(|x| -x), kernel(|x| x * x - 1.0)].map(|kernel| {
            let kernel = scaled(kernel);
            let (across, down) = (self.convolved(&kernel, &smooth), self.convolved(&smooth, &kernel));
            let pairs = across.values.iter().zip(&down.values);
            pairs.map(|(&x, &y)| libm::hypot(x, y)).collect()
        })
    }
}

/// Tristimulus values of white, and of linear sRGB relative to those of white. The fractions are those of the authors' tool.
const XYZ: [[f64; 3]; 3] = [
    [10_135_552.0 / 24_577_794.0, 8_788_810.0 / 24_577_794.0, 4_435_075.0 / 24_577_794.0],
    [2_613_072.0 / 12_288_897.0, 8_788_810.0 / 12_288_897.0, 887_015.0 / 12_288_897.0],
    [1_425_312.0 / 73_733_382.0, 8_788_810.0 / 73_733_382.0, 70_074_185.0 / 73_733_382.0],
];

fn relative(colour: [f64; 3]) -> [f64; 3] {
    XYZ.map(|row| {
        let white: f64 = row.iter().sum();
        (row[0] * colour[0] + row[1] * colour[1] + row[2] * colour[2]) / white
    })
}

/// Y C_x C_z: CIELAB without its cube root, so that it can be filtered linearly.
fn opponent(colour: [f64; 3]) -> [f64; 3] {
    let [x, y, z] = relative(colour);
    [116.0 * y - 16.0, 500.0 * (x - y), 200.0 * (y - z)]
}

fn from_opponent([y, cx, cz]: [f64; 3]) -> [f64; 3] {
    let y = (y + 16.0) / 116.0;
    let xyz = [cx / 500.0 + y, y, y - cz / 200.0];
    let whites = XYZ.map(|row| row.iter().sum::<f64>());
    let xyz = glam::DVec3::from_array(std::array::from_fn(|i| xyz[i] * whites[i]));
    (glam::DMat3::from_cols_array_2d(&XYZ).transpose().inverse() * xyz).to_array()
}

/// CIELAB of a linear colour, a* and b* scaled by L*/100.
fn hunt_lab(colour: [f64; 3]) -> [f64; 3] {
    const EDGE: f64 = 6.0 / 29.0;
    let [x, y, z] = relative(colour)
        .map(|t| if t > EDGE * EDGE * EDGE { libm::cbrt(t) } else { t / (3.0 * EDGE * EDGE) + 4.0 / 29.0 });
    let lightness = 116.0 * y - 16.0;
    [lightness, 0.01 * lightness * 500.0 * (x - y), 0.01 * lightness * 200.0 * (y - z)]
}

/// The distance HyAB of two colours: that of lightness plus that of chroma.
fn hyab(a: [f64; 3], b: [f64; 3]) -> f64 {
    (a[0] - b[0]).abs() + libm::hypot(a[1] - b[1], a[2] - b[2])
}

fn power(distance: f64) -> f64 {
    libm::pow(distance, COLOUR_EXPONENT)
}

/// Colour differences from 0 to 1: most of the range is for those below the knee.
fn spread(difference: f64, largest: f64) -> f64 {
    let knee = KNEE * largest;
    if difference < knee {
        KNEE_VALUE / knee * difference
    } else {
        KNEE_VALUE + (difference - knee) / (largest - knee) * (1.0 - KNEE_VALUE)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::num::Transfer;
    use crate::raster::{Pixels, Statistics};

    const SIZE: [u32; 2] = [48, 32];

    /// Eight bits that look random, from integers alone.
    fn noise(x: i64, y: i64, channel: i64, seed: i64) -> i64 {
        let mixed = x * 374_761_393 + y * 668_265_263 + channel * 2_147_483_647 + seed * 1_274_126_177;
        let v = mixed & 0xffff_ffff;
        let v = ((v ^ (v >> 13)) * 1_274_126_177) & 0xffff_ffff;
        (v ^ (v >> 16)) & 255
    }

    /// The sRGB code of a pixel of a picture by its number.
    fn code(picture: u32, x: i64, y: i64, channel: i64) -> i64 {
        let checks = |x: i64| if (x / 4 + y / 4) % 2 == 1 { 255 } else { 0 };
        let disc = |value: fn(i64) -> i64| {
            let squared = (x - 24).pow(2) + (y - 16).pow(2);
            if squared < 100 { value(squared) } else { 20 }
        };
        match picture {
            0 => 128,
            1 => 130,
            2 => [128, 133, 128][channel as usize],
            3 => 5 * x,
            4 => 5 * x / 16 * 16,
            5 => checks(x),
            6 => checks(x + 1),
            7 => {
                if x >= 24 {
                    200
                } else {
                    40
                }
            }
            8 => {
                if x >= 25 {
                    200
                } else {
                    40
                }
            }
            9 => {
                if [x, y] == [20, 11] {
                    255
                } else {
                    128
                }
            }
            10 => noise(x, y, channel, 1),
            11 => noise(x, y, channel, 1) / 2 + noise(x, y, channel, 2) / 2,
            12 => [220, 30, 30][channel as usize],
            13 => [30, 30, 220][channel as usize],
            14 => disc(|squared| 255 - squared),
            15 => disc(|squared| (255 - squared) / 8 * 8),
            16 => 0,
            _ => 255,
        }
    }

    fn picture(number: u32) -> Image {
        let pixels = (0..i64::from(SIZE[1])).flat_map(|y| (0..i64::from(SIZE[0])).map(move |x| [x, y]));
        let linear = pixels.map(|[x, y]| {
            let component = |channel| {
                let code = code(number, x, y, channel) as f64;
                Transfer::Srgb.decode(code / 255.0) as f32
            };
            [0, 1, 2].map(component)
        });
        let linear: Vec<[f32; 3]> = linear.collect();
        Image {
            size: SIZE,
            pixels: Pixels::Eight(vec![[0; 3]; linear.len()]),
            coverage: vec![1; linear.len()],
            linear: Some(linear),
            objects: None,
            statistics: Statistics::default(),
        }
    }

    /// Mean and largest value of flip-evaluator 1.7, `evaluate(reference, test, "LDR")`, on the same pictures. It computes in
    /// `f32`, which shows most where colours differ little: the power 0.7 amplifies the rounding (3.5e-5 at most here).
    #[test]
    fn values_are_those_of_the_authors_tool() {
        let recorded = [
            ([0, 1], 0.048_492, 0.048_492),
            ([0, 2], 0.133_759, 0.133_761),
            ([3, 4], 0.142_806, 0.185_897),
            ([5, 6], 0.312_976, 0.979_473),
            ([7, 8], 0.048_835, 0.621_852),
            ([0, 9], 0.002_800, 0.378_678),
            ([10, 11], 0.331_236, 0.728_061),
            ([12, 13], 0.956_179, 0.956_188),
            ([14, 15], 0.029_935, 0.127_271),
            ([16, 17], 0.967_399, 0.967_388),
            ([10, 0], 0.473_351, 0.915_710),
            ([5, 0], 0.608_521, 0.969_930),
            ([9, 1], 0.051_809, 0.362_730),
        ];
        for ([a, b], mean, largest) in recorded {
            let found = flip(&picture(a), &picture(b), FLIP_PIXELS_PER_DEGREE).unwrap();
            let most = found.map.iter().copied().fold(0.0, f64::max);
            assert!((found.mean - mean).abs() < 5e-5, "{a} {b}: mean {} of {mean}", found.mean);
            assert!((most - largest).abs() < 5e-5, "{a} {b}: largest {most} of {largest}");
        }
    }

    #[test]
    fn the_order_of_the_pictures_and_the_number_of_threads_change_nothing() {
        let [a, b] = [10, 11].map(picture);
        let of = |threads, a: &Image, b: &Image| {
            let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build().unwrap();
            pool.install(|| flip(a, b, 40.0).unwrap())
        };
        assert_eq!(of(1, &a, &b), of(3, &b, &a));
        assert_eq!(of(2, &a, &a).mean, 0.0);
    }

    #[test]
    fn pictures_that_cannot_be_compared_are_refused() {
        let [a, mut b] = [0, 1].map(picture);
        b.linear = None;
        assert_eq!(flip(&a, &b, 67.0), Err(MetricError::NoLinear));
        b.size = [32, 48];
        assert_eq!(flip(&a, &b, 67.0), Err(MetricError::Sizes([48, 32], [32, 48])));
    }
}
