//! Colour: linear light, the sRGB transfer and the rules that make whole numbers of it.

use std::ops::{Add, AddAssign, Mul};
use std::sync::LazyLock;

/// Linear light in the primaries of sRGB: twice the number is twice the light. Not limited to 0…1.
///
/// ```
/// use crease::num::LinearRgb;
///
/// let yellow = LinearRgb::new(1.0, 1.0, 0.0);
/// // What a blue object reflects of it (exercise 1.6.29 of the lecture notes): nothing.
/// assert_eq!(LinearRgb::new(0.0, 0.0, 1.0) * yellow, LinearRgb::BLACK);
/// ```
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct LinearRgb {
    /// Red.
    pub r: f64,
    /// Green.
    pub g: f64,
    /// Blue.
    pub b: f64,
}

impl LinearRgb {
    /// No light.
    pub const BLACK: LinearRgb = LinearRgb::grey(0.0);
    /// All of it.
    pub const WHITE: LinearRgb = LinearRgb::grey(1.0);

    /// From its three components.
    pub const fn new(r: f64, g: f64, b: f64) -> Self {
        Self { r, g, b }
    }

    /// The same amount of each.
    pub const fn grey(value: f64) -> Self {
        Self::new(value, value, value)
    }

    /// Red, green, blue.
    pub const fn to_array(self) -> [f64; 3] {
        [self.r, self.g, self.b]
    }

    /// The largest component.
    pub fn largest(self) -> f64 {
        self.r.max(self.g).max(self.b)
    }

    /// Whether no component is infinite or NaN.
    pub fn is_finite(self) -> bool {
        self.to_array().into_iter().all(f64::is_finite)
    }

    /// Relative luminance Y = 0.2126 R + 0.7152 G + 0.0722 B (ITU-R BT.709).
    pub fn luminance(self) -> f64 {
        0.2126 * self.r + 0.7152 * self.g + 0.0722 * self.b
    }
}

impl From<[f64; 3]> for LinearRgb {
    fn from([r, g, b]: [f64; 3]) -> Self {
        Self::new(r, g, b)
    }
}

impl Add for LinearRgb {
    type Output = Self;

    fn add(self, other: Self) -> Self {
        Self::new(self.r + other.r, self.g + other.g, self.b + other.b)
    }
}

impl AddAssign for LinearRgb {
    fn add_assign(&mut self, other: Self) {
        *self = *self + other;
    }
}

impl Mul for LinearRgb {
    type Output = Self;

    /// Component by component: what a surface of one colour reflects of light of the other.
    fn mul(self, other: Self) -> Self {
        Self::new(self.r * other.r, self.g * other.g, self.b * other.b)
    }
}

impl Mul<f64> for LinearRgb {
    type Output = Self;

    fn mul(self, factor: f64) -> Self {
        Self::new(self.r * factor, self.g * factor, self.b * factor)
    }
}

/// A colour as files and screens have it: 8 bits a component, sRGB transfer.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub struct Srgb8(pub [u8; 3]);

impl From<LinearRgb> for Srgb8 {
    /// The nearest one; what is out of range is clamped.
    fn from(colour: LinearRgb) -> Self {
        Self(colour.to_array().map(|component| Transfer::Srgb.to_u8(component)))
    }
}

impl From<Srgb8> for LinearRgb {
    fn from(colour: Srgb8) -> Self {
        colour.0.map(|code| Transfer::Srgb.decode(f64::from(code) / 255.0)).into()
    }
}

/// How linear light becomes the numbers of a picture.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash, serde::Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum Transfer {
    /// The curve of sRGB (IEC 61966-2-1): 12.92 x up to 0.0031308, then 1.055 x^(1/2.4) − 0.055.
    #[default]
    Srgb,
    /// The number itself, as the lectures do.
    Direct,
}

impl Transfer {
    /// From linear light to the coded value, by the formula: 0…1 to 0…1. Not clamped.
    pub fn encode(self, linear: f64) -> f64 {
        match self {
            Transfer::Direct => linear,
            Transfer::Srgb if linear <= 0.003_130_8 => 12.92 * linear,
            Transfer::Srgb => 1.055 * libm::pow(linear, 1.0 / 2.4) - 0.055,
        }
    }

    /// From the coded value to linear light. Not clamped.
    pub fn decode(self, coded: f64) -> f64 {
        match self {
            Transfer::Direct => coded,
            Transfer::Srgb if coded <= 0.040_45 => coded / 12.92,
            Transfer::Srgb => libm::pow((coded + 0.055) / 1.055, 2.4),
        }
    }

    /// The nearest of 256 codes: round(255 y), halves up, for y clamped to 0…1. NaN, which no checked colour has,
    /// gives 0.
    pub fn to_u8(self, linear: f64) -> u8 {
        quantise(self.encode(linear), 255.0) as u8
    }

    /// The nearest of 65 536 codes: round(65535 y), halves up, for y clamped to 0…1.
    pub fn to_u16(self, linear: f64) -> u16 {
        quantise(self.encode(linear), 65_535.0) as u16
    }

    /// [`to_u8`](Self::to_u8) for the many pixels of a picture: the same code for every `f32`, without the formula.
    #[inline]
    pub fn pixel_u8(self, linear: f32) -> u8 {
        match self {
            Transfer::Direct => nearest_u8(linear),
            Transfer::Srgb => CODES.look_up(linear),
        }
    }
}

/// round(steps · y) with halves up, for y clamped to 0…1. The product is exact for single precision.
#[inline]
fn quantise(y: f64, steps: f64) -> u32 {
    (y.clamp(0.0, 1.0) * steps + 0.5) as u32
}

/// round(255 y) for y clamped to 0…1, without a conversion, which has no vector instruction: adding 1.5 · 2⁵² leaves the nearest whole
/// number in the low bits. The product is exact. Only 0.5 is halfway between two codes, and the even one, 128, is the upper one.
#[inline]
fn nearest_u8(y: f32) -> u8 {
    let y = if y > 0.0 { y } else { 0.0 };
    let y = if y < 1.0 { y } else { 1.0 };
    (f64::from(y) * 255.0 + 6_755_399_441_055_744.0).to_bits() as u8
}

/// Buckets an octave, by the upper bits of the significand: narrow enough that no bucket meets two steps of the code.
const BUCKET_BITS: u32 = 23 - 7;

/// Where the 8-bit code of sRGB steps, so that a pixel costs two look-ups instead of a power.
struct Codes {
    /// The smallest `f32` that has each code.
    starts: [f32; 257],
    /// The code at the start of every bucket between the first step and 1.
    buckets: Vec<u8>,
    /// Number of the first bucket.
    first: u32,
}

static CODES: LazyLock<Codes> = LazyLock::new(Codes::new);

impl Codes {
    fn new() -> Self {
        let mut starts = [f32::INFINITY; 257];
        starts[0] = 0.0;
        for code in 1..=255_u8 {
            // Positive floats are ordered as their bits are: a binary search finds the first that has the code.
            let (mut below, mut above) = (0, 1.0_f32.to_bits());
            while above - below > 1 {
                let middle = u32::midpoint(below, above);
                let reached = Transfer::Srgb.to_u8(f64::from(f32::from_bits(middle))) >= code;
                if reached { above = middle } else { below = middle }
            }
            starts[usize::from(code)] = f32::from_bits(above);
        }
        let first = starts[1].to_bits() >> BUCKET_BITS;
        let last = 1.0_f32.to_bits() >> BUCKET_BITS;
        let buckets = (first..=last)
            .map(|bucket| Transfer::Srgb.to_u8(f64::from(f32::from_bits(bucket << BUCKET_BITS))))
            .collect();
        Self { starts, buckets, first }
    }

    #[inline]
    fn look_up(&self, linear: f32) -> u8 {
        // As written, NaN gives 0.
        let clamped = if linear > 0.0 { linear.min(1.0) } else { 0.0 };
        let Some(bucket) = (clamped.to_bits() >> BUCKET_BITS).checked_sub(self.first) else { return 0 };
        let code = self.buckets[bucket as usize];
        code + u8::from(clamped >= self.starts[usize::from(code) + 1])
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::num::test_numbers::Numbers;

    #[test]
    fn published_codes() {
        // reference: .5 → 188, .15 → 108, .6 → 203.
        for (linear, code) in
            [(0.0, 0), (0.15, 108), (0.5, 188), (0.6, 203), (1.0, 255), (7.0, 255), (-1.0, 0)]
        {
            assert_eq!(Transfer::Srgb.to_u8(linear), code, "{linear}");
        }
        assert_eq!(Transfer::Direct.to_u16(0.5), 32_768);
        assert_eq!(Transfer::Srgb.to_u16(1.0), 65_535);
    }

    /// Around every step of the code, and for what is no colour.
    #[test]
    fn direct_codes_of_pixels_are_those_of_the_formula() {
        let steps = (0..256).map(|code| (f64::from(code) - 0.5) / 255.0).flat_map(|step| {
            let bits = (step as f32).to_bits();
            (0..7).map(move |ulps| f32::from_bits(bits + ulps - 3))
        });
        let others =
            [0.0, -0.0, 0.5, 1.0, 2.0, -1.0, f32::INFINITY, f32::NEG_INFINITY, f32::NAN, 1e-40, 0.25];
        for linear in steps.chain(others) {
            assert_eq!(
                Transfer::Direct.pixel_u8(linear),
                Transfer::Direct.to_u8(f64::from(linear)),
                "{linear}"
            );
        }
    }

    #[test]
    fn exercise_1_6_31_rounds_to_the_nearest_of_255() {
        // (42, 53, 14): neither 255x cut off (R 41) nor 256x rounded (G 54).
        let colour = [0.164_689_217, 0.209_378_433, 0.056];
        assert_eq!(colour.map(|x| Transfer::Direct.to_u8(x)), [42, 53, 14]);
        assert_eq!(colour.map(|x| Transfer::Direct.pixel_u8(x as f32)), [42, 53, 14]);
        assert_ne!(colour.map(|x| (255.0 * x) as u8), [42, 53, 14]);
    }

    #[test]
    fn decoding_undoes_encoding() {
        for code in 0..=255_u8 {
            let linear = LinearRgb::from(Srgb8([code; 3]));
            assert_eq!(Srgb8::from(linear), Srgb8([code; 3]));
        }
        for i in 0..=1000 {
            let x = f64::from(i) / 1000.0;
            // The published constants leave a gap of 3e-8 where line and curve meet.
            assert!((Transfer::Srgb.decode(Transfer::Srgb.encode(x)) - x).abs() < 1e-8, "{x}");
        }
    }

    #[test]
    fn looking_up_gives_the_code_of_the_formula() {
        let agree =
            |x: f32| assert_eq!(Transfer::Srgb.pixel_u8(x), Transfer::Srgb.to_u8(f64::from(x)), "{x:e}");
        for start in CODES.starts {
            agree(start);
            agree(start.next_down());
            agree(start.next_up());
        }
        let mut numbers = Numbers::new(36);
        (0..300_000).for_each(|_| agree(numbers.unit() as f32));
        let special = [0.0, -0.0, 1e-40, 1.0, 1.5, -3.0, f32::INFINITY, f32::NEG_INFINITY, f32::NAN];
        special.into_iter().for_each(agree);
    }

    #[test]
    fn no_bucket_meets_two_steps() {
        for (i, pair) in CODES.buckets.windows(2).enumerate() {
            assert!(pair[1] - pair[0] <= 1, "bucket {i}: {pair:?}");
        }
    }
}
