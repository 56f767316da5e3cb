//! What is behind a picture: found by drawing it before black and before white.
//!
//! Both pictures are c + (1 − α)·b in linear light, with the background b of 0 or 1. So α = 1 − (white − black), which is exact for
//! edges, lines and glass alike.

use super::picture::{CutOut, Picture};
use crate::num::{LinearRgb, Transfer};
use crate::raster::Pixels;

/// The picture that two pictures of the same size show before black and before white.
///
/// Pixels that are equal in both are opaque and keep their codes.
pub fn cut_out(on_black: Picture, on_white: &Picture, transfer: Transfer) -> CutOut {
    let mut opacity = Vec::new();
    let mut cut = |black: [u32; 3], white: [u32; 3], full: f64| {
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
    let pixels = match (on_black.pixels, &on_white.pixels) {
        (Pixels::Sixteen(black), Pixels::Sixteen(white)) => {
            let pairs = black.into_iter().zip(white);
            Pixels::Sixteen(
                pairs
                    .map(|(a, b)| cut(a.map(u32::from), b.map(u32::from), 65_535.0).map(|c| c as u16))
                    .collect(),
            )
        }
        (Pixels::Eight(black), Pixels::Eight(white)) => {
            let pairs = black.into_iter().zip(white);
            Pixels::Eight(
                pairs.map(|(a, b)| cut(a.map(u32::from), b.map(u32::from), 255.0).map(|c| c as u8)).collect(),
            )
        }
        // Both are drawn with the same settings.
        (pixels, _) => pixels,
    };
    CutOut { picture: Picture { size: on_black.size, pixels }, opacity }
}

impl CutOut {
    /// The picture before a colour that changes linearly from the top to the bottom.
    pub fn over(self, [top, bottom]: [LinearRgb; 2], transfer: Transfer) -> Picture {
        let Self { mut picture, opacity } = self;
        let [width, height] = picture.size.map(|side| side as usize);
        let behind = |index: usize| {
            let share = ((index / width) as f64 + 0.5) / height as f64;
            (top * (1.0 - share) + bottom * share).to_array()
        };
        let mix = |index: usize, codes: [u32; 3], full: f64| {
            let share = f64::from(opacity[index]);
            if share == 1.0 {
                return codes;
            }
            let behind = behind(index);
            std::array::from_fn(|k| {
                let light = transfer.decode(f64::from(codes[k]) / full);
                coded(light * share + behind[k] * (1.0 - share), transfer, full)
            })
        };
        match &mut picture.pixels {
            Pixels::Eight(list) => list
                .iter_mut()
                .enumerate()
                .for_each(|(index, pixel)| *pixel = mix(index, pixel.map(u32::from), 255.0).map(|c| c as u8)),
            Pixels::Sixteen(list) => list.iter_mut().enumerate().for_each(|(index, pixel)| {
                *pixel = mix(index, pixel.map(u32::from), 65_535.0).map(|c| c as u16)
            }),
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
