//! What is behind a picture: found by drawing it before black and before white.
//!
//! Both pictures are c + (1 − α)·b in linear light, with the background b of 0 or 1. So α = 1 − (white − black), which is exact for
//! edges, lines and glass alike.

use super::picture::{CutOut, Picture};
use crate::num::{LinearRgb, Transfer};

/// The picture that two pictures of the same size show before black and before white.
///
/// Pixels that are equal in both are opaque and keep their codes.
///
/// # Panics
/// If the second picture is smaller than the first.
pub fn cut_out(on_black: Picture, on_white: &Picture, transfer: Transfer) -> CutOut {
    let (mut picture, mut opacity) = (on_black, Vec::new());
    let full = f64::from(picture.full());
    let mut cut = |black: [u32; 3], white: [u32; 3]| {
        if black == white {
            opacity.push(1.0);
            return black;
        }
        let [black, white] =
            [black, white].map(|codes| codes.map(|code| transfer.decode(f64::from(code) / full)));
        let behind: f64 = white.iter().zip(black).map(|(white, black)| white - black).sum::<f64>() / 3.0;
        let share = (1.0 - behind).clamp(0.0, 1.0);
        opacity.push(share as f32);
        black.map(|light| if share > 0.0 { coded(light / share, transfer, full) } else { 0 })
    };
    for index in 0..picture.size.iter().map(|&side| side as usize).product() {
        picture.set_codes(index, cut(picture.codes(index), on_white.codes(index)));
    }
    CutOut { picture, opacity }
}

impl CutOut {
    /// The picture before a colour that changes linearly from the top to the bottom.
    pub fn over(self, [top, bottom]: [LinearRgb; 2], transfer: Transfer) -> Picture {
        let Self { mut picture, opacity } = self;
        let [width, height] = picture.size.map(|side| side as usize);
        let full = f64::from(picture.full());
        for (index, &share) in opacity.iter().enumerate().filter(|(_, share)| **share != 1.0) {
            let down = ((index / width) as f64 + 0.5) / height as f64;
            let behind = (top * (1.0 - down) + bottom * down).to_array();
            let (share, codes) = (f64::from(share), picture.codes(index));
            let mixed = std::array::from_fn(|k| {
                let light = transfer.decode(f64::from(codes[k]) / full);
                coded(light * share + behind[k] * (1.0 - share), transfer, full)
            });
            picture.set_codes(index, mixed);
        }
        picture
    }
}

fn coded(light: f64, transfer: Transfer, full: f64) -> u32 {
    (transfer.encode(light.clamp(0.0, 1.0)) * full + 0.5) as u32
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::raster::Pixels;

    /// Half of a pixel of light 0.5, nothing, and an opaque pixel.
    #[test]
    fn colours_and_opacity_are_recovered() {
        for transfer in [Transfer::Srgb, Transfer::Direct] {
            let code = |light: f64| [coded(light, transfer, 65_535.0) as u16; 3];
            let on = |behind: f64| Picture {
                size: [1, 3],
                pixels: Pixels::Sixteen(vec![code(0.25 + 0.5 * behind), code(behind), code(0.7)]),
            };
            let cut = cut_out(on(0.0), &on(1.0), transfer);
            let off = |found: f32, expected: f32| (found - expected).abs();
            assert!(off(cut.opacity[0], 0.5) < 1e-4 && cut.opacity[1..] == [0.0, 1.0], "{:?}", cut.opacity);
            let Pixels::Sixteen(pixels) = &cut.picture.pixels else { panic!("16 bits") };
            assert!(pixels[0][0].abs_diff(code(0.5)[0]) <= 8 && pixels[2] == code(0.7), "{pixels:?}");
            // Before a grey that is the same everywhere: as if it were drawn there.
            let Pixels::Sixteen(over) = cut.over([LinearRgb::grey(0.4); 2], transfer).pixels else {
                panic!("16 bits")
            };
            for (found, light) in over.into_iter().zip([0.45, 0.4, 0.7]) {
                assert!(found[1].abs_diff(code(light)[1]) <= 8, "{found:?} is not {light}");
            }
        }
    }

    #[test]
    fn a_gradient_runs_from_the_top_to_the_bottom() {
        let filled = |share: f32| Picture::filled([2, 40], false, [share; 3]);
        let over = cut_out(filled(0.0), &filled(1.0), Transfer::Direct)
            .over([LinearRgb::WHITE, LinearRgb::grey(0.5)], Transfer::Direct);
        let Pixels::Eight(pixels) = over.pixels else { panic!("8 bits") };
        assert!(pixels.windows(2).all(|pair| pair[1][0] <= pair[0][0]));
        assert!(pixels[0][0] >= 252 && pixels[79][0].abs_diff(129) <= 2, "{:?} {:?}", pixels[0], pixels[79]);
    }
}
