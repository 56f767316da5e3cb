//! Fixed-point positions on the picture.
//!
//! A position is an `i32` in 256ths of a pixel (8 sub-pixel bits, as Direct3D asks), x to the right and y down from
//! the picture's upper left corner. The guard band keeps it within ±2¹⁴ pixels of the picture's centre, so that an edge
//! is at most 2²³ units long in x and in y, and everything that is computed from edges is exact.

pub(crate) const BITS: u32 = 8;
pub(crate) const ONE: i32 = 1 << BITS;
pub(crate) const HALF: i32 = ONE / 2;
/// Half the width and height of the guard band, in pixels; also the largest size of a picture.
pub(crate) const GUARD: i32 = 1 << 14;

/// Adding 1.5 · 2⁵² leaves the nearest whole number, ties to even, in the low bits of an `f64`, faster than a cast.
const TO_INTEGER: f64 = 6_755_399_441_055_744.0;

/// A whole number of at most 31 bits.
#[inline(always)]
pub(crate) fn whole(number: f64) -> i32 {
    (number + TO_INTEGER).to_bits() as i32
}

/// The end of the range for places out of the guard band: 2²³, so that differences of any two fit into 32 bits. The
/// middle of a picture is at most 2¹³ pixels from its corner, so places in the band are below 3 · 2²¹.
const FARTHEST: f64 = (2 * GUARD * ONE) as f64;

/// The nearest fixed-point number to a place in pixels, ties to even; out of the guard band, and for NaN, an end of the range.
#[inline(always)]
pub(crate) fn snap(pixels: f64) -> i32 {
    let place = pixels * f64::from(ONE);
    // Written so that each is one instruction, which takes the second of the two where the first is NaN.
    let place = if place > -FARTHEST { place } else { -FARTHEST };
    whole(if place < FARTHEST { place } else { FARTHEST })
}

/// The first pixel with a sample, `offset` into it, at or after a place.
#[inline(always)]
pub(crate) fn first_pixel(place: i32, offset: i32) -> i32 {
    (place - offset + (ONE - 1)) >> BITS
}

/// The last pixel with a sample, `offset` into it, at or before a place.
#[inline(always)]
pub(crate) fn last_pixel(place: i32, offset: i32) -> i32 {
    (place - offset) >> BITS
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn snapping_rounds_to_the_nearest() {
        assert_eq!([0.0, 1.0, -1.0, 0.5, 16384.0].map(snap), [0, 256, -256, 128, 16384 * 256]);
        assert_eq!([0.4, 0.6, 1.5, 2.5, -0.5, -1.5].map(|x| snap(x / 256.0)), [0, 1, 2, 2, 0, -2]);
        let end = 1 << 23;
        assert_eq!(
            [1e5, -1e5, 1e300, f64::INFINITY, f64::NEG_INFINITY].map(snap),
            [end, -end, end, end, -end]
        );
        assert_eq!(snap(f64::NAN), -end);
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
