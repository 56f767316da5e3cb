//! Colours for quantities, in order of lightness, so that they differ in grey.

use super::{LinearRgb, Srgb8};
use std::sync::LazyLock;

/// Five of the colours of viridis (S. van der Walt & N. Smith, matplotlib 2015).
const COLOURS: [[u8; 3]; 5] = [[68, 1, 84], [59, 82, 139], [33, 145, 140], [94, 201, 98], [253, 231, 37]];

/// The same in linear light: pictures ask for each of their pixels.
static LINEAR: LazyLock<[LinearRgb; 5]> = LazyLock::new(|| COLOURS.map(|colour| Srgb8(colour).into()));

/// The colour of a share from 0, dark violet, over blue-green to 1, yellow. What is beyond has the colour of the end.
pub fn viridis(share: f64) -> LinearRgb {
    let place = share.clamp(0.0, 1.0) * (COLOURS.len() - 1) as f64;
    let below = (place as usize).min(COLOURS.len() - 2);
    let part = place - below as f64;
    LINEAR[below] * (1.0 - part) + LINEAR[below + 1] * part
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn colours_grow_lighter() {
        let lightness: Vec<f64> = (0..=100).map(|i| viridis(f64::from(i) / 100.0).luminance()).collect();
        assert!(lightness.is_sorted_by(|a, b| a < b), "{lightness:?}");
        assert_eq!(Srgb8::from(viridis(-1.0)), Srgb8(COLOURS[0]));
        assert_eq!(Srgb8::from(viridis(2.0)), Srgb8(COLOURS[4]));
    }
}
