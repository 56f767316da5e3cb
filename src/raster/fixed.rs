//! Fixed-point positions on the picture.
//!
//! A position is an `i32` in 256ths of a pixel (8 sub-pixel bits, as Direct3D asks), x to the right and y down from
//! the picture's upper left corner. The guard band keeps it within ±2¹⁴ pixels of the picture's centre, so that an edge
//! is at most 2²³ units long in x and in y, and everything that is computed from edges is exact.

/// Bits below the pixel.
pub(super) const BITS: u32 = 8;
/// One pixel.
pub(super) const ONE: i32 = 1 << BITS;
/// Half a pixel.
pub(super) const HALF: i32 = ONE / 2;
/// Half the width and height of the guard band, in pixels; also the largest size of a picture.
pub(super) const GUARD: i32 = 1 << 14;

/// Adding 1.5 · 2⁵² leaves the nearest whole number, ties to even, in the low bits of an `f64`: in one instruction, where
/// a cast has to look for what is out of range.
const TO_INTEGER: f64 = 6_755_399_441_055_744.0;

/// A whole number of at most 31 bits.
#[inline(always)]
pub(super) fn whole(number: f64) -> i32 {
    (number + TO_INTEGER).to_bits() as i32
}

/// The nearest fixed-point number to a place in pixels, ties to even; any number if it is out of the guard band.
#[inline(always)]
pub(super) fn snap(pixels: f64) -> i32 {
    whole(pixels * f64::from(ONE))
}

/// The first pixel with a sample, `offset` into it, at or after a place.
#[inline(always)]
pub(super) fn first_pixel(place: i32, offset: i32) -> i32 {
    (place - offset + (ONE - 1)) >> BITS
}

/// The last pixel with a sample, `offset` into it, at or before a place.
#[inline(always)]
pub(super) fn last_pixel(place: i32, offset: i32) -> i32 {
    (place - offset) >> BITS
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn snapping_rounds_to_the_nearest() {
        assert_eq!([0.0, 1.0, -1.0, 0.5, 16384.0].map(snap), [0, 256, -256, 128, 16384 * 256]);
        assert_eq!([0.4, 0.6, 1.5, 2.5, -0.5, -1.5].map(|x| snap(x / 256.0)), [0, 1, 2, 2, 0, -2]);
    }

    #[test]
    fn pixels_are_those_whose_sample_lies_within() {
        for place in -1000..1000 {
            for offset in [0, HALF, ONE - 1] {
                let (first, last) = (first_pixel(place, offset), last_pixel(place, offset));
                assert!(first * ONE + offset >= place && (first - 1) * ONE + offset < place);
                assert!(last * ONE + offset <= place && (last + 1) * ONE + offset > place);
            }
        }
    }
}
