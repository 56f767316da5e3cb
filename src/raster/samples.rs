//! Where in a pixel it is looked at.

use crate::raster::view::fixed_point::{HALF, ONE};

/// How many places of each pixel are drawn; the pixel is their mean. Each is shaded by itself.
///
/// The places, in 256ths of a pixel from its upper left corner: one sample is the centre; 4, 8 and 16 are the standard
/// patterns of Direct3D 11 (`D3D11_STANDARD_MULTISAMPLE_PATTERN`), in which no two samples share a row or a column.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub enum Samples {
    /// The centre.
    #[default]
    One,
    /// Four, as a rotated square.
    Four,
    /// Eight.
    Eight,
    /// Sixteen.
    Sixteen,
}

/// Sixteenths of a pixel from its centre.
type Pattern = &'static [[i32; 2]];

const ONE_SAMPLE: Pattern = &[[0, 0]];
const FOUR: Pattern = &[[-2, -6], [6, -2], [-6, 2], [2, 6]];
const EIGHT: Pattern = &[[1, -3], [-1, 3], [5, 1], [-3, -5], [-5, 5], [-7, -1], [3, 7], [7, -7]];
const SIXTEEN: Pattern = &[
    [1, 1],
    [-1, -3],
    [-3, 2],
    [4, -1],
    [-5, -2],
    [2, 5],
    [5, 3],
    [3, -5],
    [-2, 6],
    [0, -7],
    [-4, -6],
    [-6, 4],
    [-8, 0],
    [7, -4],
    [6, 7],
    [-7, -8],
];

impl Samples {
    /// The pattern with this many samples: 1, 4, 8 or 16.
    pub fn new(count: usize) -> Option<Self> {
        [Self::One, Self::Four, Self::Eight, Self::Sixteen]
            .into_iter()
            .find(|samples| samples.count() == count)
    }

    /// How many samples a pixel has.
    pub fn count(self) -> usize {
        self.pattern().len()
    }

    /// The places, in pixels from a pixel's upper left corner.
    pub fn places(self) -> impl ExactSizeIterator<Item = [f64; 2]> {
        self.offsets().map(|place| place.map(|x| f64::from(x) / f64::from(ONE)))
    }

    /// The same, in 256ths of a pixel.
    pub(super) fn offsets(self) -> impl ExactSizeIterator<Item = [i32; 2]> {
        self.pattern().iter().map(|place| place.map(|x| HALF + x * ONE / 16))
    }

    fn pattern(self) -> Pattern {
        match self {
            Self::One => ONE_SAMPLE,
            Self::Four => FOUR,
            Self::Eight => EIGHT,
            Self::Sixteen => SIXTEEN,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn no_two_samples_share_a_row_or_column() {
        for (samples, count) in
            [(Samples::One, 1), (Samples::Four, 4), (Samples::Eight, 8), (Samples::Sixteen, 16)]
        {
            assert_eq!(Samples::new(count), Some(samples));
            for axis in 0..2 {
                let mut places: Vec<i32> = samples.offsets().map(|place| place[axis]).collect();
                places.sort_unstable();
                places.dedup();
                assert_eq!(places.len(), count);
                assert!(places.iter().all(|place| (0..ONE).contains(place)));
            }
        }
        assert_eq!(Samples::new(2), None);
        assert_eq!(Samples::One.places().next(), Some([0.5, 0.5]));
    }
}
