//! Pictures to combine and to draw on, and their PNG, JPEG and WebP files.

use super::error::{ReportError, Result};
use crate::num::Transfer;
use crate::raster::{Image, Pixels};
use image::codecs::jpeg::JpegEncoder;
use image::codecs::webp::WebPEncoder;
use image::{ExtendedColorType, ImageEncoder};
use png::{BitDepth, ColorType, Encoder, SrgbRenderingIntent};
use std::io::Write;

/// A finished picture: rows of red, green, blue from the top.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Picture {
    /// Width and height in pixels.
    pub size: [u32; 2],
    /// Its coded colours.
    pub pixels: Pixels,
}

/// A picture without its background.
#[derive(Clone, Debug, PartialEq)]
pub struct CutOut {
    /// The colours, not multiplied by the opacity.
    pub picture: Picture,
    /// The opacity of each pixel, from 0 to 1.
    pub opacity: Vec<f32>,
}

impl From<Image> for Picture {
    fn from(image: Image) -> Self {
        Self { size: image.size, pixels: image.pixels }
    }
}

impl Picture {
    /// A picture of one colour, given as shares of the full code, 0 to 1.
    pub fn filled(size: [u32; 2], sixteen_bits: bool, colour: [f32; 3]) -> Self {
        let count = size.iter().map(|&side| side as usize).product();
        let pixels = match sixteen_bits {
            false => Pixels::Eight(vec![colour.map(|c| code(c, 255.0) as u8); count]),
            true => Pixels::Sixteen(vec![colour.map(|c| code(c, 65_535.0) as u16); count]),
        };
        Self { size, pixels }
    }

    /// Whether components have 16 bits.
    pub fn is_sixteen(&self) -> bool {
        matches!(self.pixels, Pixels::Sixteen(_))
    }

    /// The largest code of a component.
    pub(super) fn full(&self) -> f32 {
        if self.is_sixteen() { 65_535.0 } else { 255.0 }
    }

    /// The codes of a pixel by its number.
    pub(super) fn codes(&self, index: usize) -> [u32; 3] {
        match &self.pixels {
            Pixels::Eight(list) => list[index].map(u32::from),
            Pixels::Sixteen(list) => list[index].map(u32::from),
        }
    }

    pub(super) fn set_codes(&mut self, index: usize, codes: [u32; 3]) {
        match &mut self.pixels {
            Pixels::Eight(list) => list[index] = codes.map(|c| c as u8),
            Pixels::Sixteen(list) => list[index] = codes.map(|c| c as u16),
        }
    }

    /// The pixels in 8 bits: of 16-bit components the upper half.
    pub(super) fn into_eight_bits(self) -> Vec<[u8; 3]> {
        match self.pixels {
            Pixels::Eight(list) => list,
            Pixels::Sixteen(list) => list.iter().map(|pixel| pixel.map(|c| (c >> 8) as u8)).collect(),
        }
    }

    /// Copies another picture into this one, its upper left corner at `at`; parts outside are omitted. Components of
    /// 8 bits become 16 bits by 257·c, which keeps black and white, and 16 bits become 8 by their upper half.
    pub fn paste(&mut self, other: &Picture, at: [u32; 2]) {
        let width = (other.size[0].min(self.size[0].saturating_sub(at[0]))) as usize;
        let rows = other.size[1].min(self.size[1].saturating_sub(at[1]));
        let convert = match (other.is_sixteen(), self.is_sixteen()) {
            (false, true) => |code: u32| code * 257,
            (true, false) => |code: u32| code >> 8,
            _ => |code: u32| code,
        };
        for row in 0..rows {
            let from = row as usize * other.size[0] as usize;
            let to = (at[1] + row) as usize * self.size[0] as usize + at[0] as usize;
            (0..width).for_each(|x| self.set_codes(to + x, other.codes(from + x).map(convert)));
        }
    }

    /// Mixes a colour (shares of the full code) into a pixel; nothing happens outside the picture.
    pub fn blend(&mut self, [x, y]: [i64; 2], colour: [f32; 3], share: f32) {
        let [width, height] = self.size.map(i64::from);
        if !(0..width).contains(&x) || !(0..height).contains(&y) {
            return;
        }
        let (index, full) = ((y * width + x) as usize, self.full());
        let mut codes = self.codes(index);
        for (old, new) in codes.iter_mut().zip(colour) {
            let before = *old as f32 / full;
            *old = code(before + (new - before) * share, full);
        }
        self.set_codes(index, codes);
    }

    /// Whether there are as many pixels and opacities as the size says, and sides that a format has room for.
    pub(super) fn check(&self, format: &'static str, largest: u32, opacity: Option<&[f32]>) -> Result<()> {
        let [width, height] = self.size;
        if !self.size.iter().all(|side| (1..=largest).contains(side)) {
            return Err(ReportError::Size { format, largest, width, height });
        }
        let found = match &self.pixels {
            Pixels::Eight(list) => list.len(),
            Pixels::Sixteen(list) => list.len(),
        };
        let expected = width as usize * height as usize;
        let mut counts = opacity.map(<[f32]>::len).into_iter().chain([found]);
        match counts.find(|&count| count != expected) {
            Some(count) => Err(ReportError::Pixels(width, height, count)),
            None => Ok(()),
        }
    }
}

/// The nearest code of a share, with this one as the largest.
fn code(share: f32, largest: f32) -> u32 {
    (share.clamp(0.0, 1.0) * largest + 0.5) as u32
}

/// The largest side of a PNG picture that libraries agree on.
const LARGEST: u32 = i32::MAX as u32;
const DIRECT: &str = "Codes are the computed numbers themselves: no transfer curve.";

/// A picture as a PNG file of 8 or 16 bits a component, with an alpha channel if there are opacities.
///
/// [`Transfer::Srgb`] marks it as sRGB. Under [`Transfer::Direct`] no curve is applied to codes, which are to be sent to the
/// screen unchanged: the file specifies no colour space, which viewers would apply, but a comment explains this. The same picture
/// gives the same bytes on any machine.
///
/// # Errors
/// Sizes that do not fit the pixels or the format.
pub fn encode_png(picture: &Picture, opacity: Option<&[f32]>, transfer: Transfer) -> Result<Vec<u8>> {
    picture.check("PNG", LARGEST, opacity)?;
    let mut file = Vec::new();
    write(picture, opacity, transfer, &mut file).map_err(|error| ReportError::Encoder(error.to_string()))?;
    Ok(file)
}

/// The largest sides of JPEG and WebP pictures.
const LARGEST_JPEG: u32 = 65_535;
const LARGEST_WEBP: u32 = 16_384;
/// Errors of some steps of 255, mostly at edges.
const JPEG_QUALITY: u8 = 92;

/// A picture as a JPEG file of quality 92, which loses detail. Of 16-bit components the upper half is taken. Viewers take the codes
/// as sRGB.
///
/// # Errors
/// Sizes that do not fit the pixels or the format.
pub fn encode_jpeg(picture: &Picture) -> Result<Vec<u8>> {
    picture.check("JPEG", LARGEST_JPEG, None)?;
    let mut file = Vec::new();
    let encoder = JpegEncoder::new_with_quality(&mut file, JPEG_QUALITY);
    encode_by(encoder, picture, picture.clone().into_eight_bits().as_flattened(), ExtendedColorType::Rgb8)?;
    Ok(file)
}

/// A picture as a WebP file without loss, with an alpha channel if there are opacities. Of 16-bit components the upper half is taken.
/// Viewers take the codes as sRGB.
///
/// # Errors
/// Sizes that do not fit the pixels or the format.
pub fn encode_webp(picture: &Picture, opacity: Option<&[f32]>) -> Result<Vec<u8>> {
    picture.check("WebP", LARGEST_WEBP, opacity)?;
    let mut file = Vec::new();
    let (encoder, pixels) = (WebPEncoder::new_lossless(&mut file), picture.clone().into_eight_bits());
    match opacity {
        None => encode_by(encoder, picture, pixels.as_flattened(), ExtendedColorType::Rgb8)?,
        Some(opacity) => {
            let with_alpha = |([r, g, b], &opacity): ([u8; 3], &f32)| [r, g, b, code(opacity, 255.0) as u8];
            let pixels: Vec<[u8; 4]> = pixels.into_iter().zip(opacity).map(with_alpha).collect();
            encode_by(encoder, picture, pixels.as_flattened(), ExtendedColorType::Rgba8)?;
        }
    }
    Ok(file)
}

fn encode_by(
    encoder: impl ImageEncoder,
    picture: &Picture,
    bytes: &[u8],
    kind: ExtendedColorType,
) -> Result<()> {
    let [width, height] = picture.size;
    let written = encoder.write_image(bytes, width, height, kind);
    written.map_err(|error| ReportError::Encoder(error.to_string()))
}

fn write(
    picture: &Picture,
    opacity: Option<&[f32]>,
    transfer: Transfer,
    file: &mut Vec<u8>,
) -> Result<(), png::EncodingError> {
    let [width, height] = picture.size;
    let mut encoder = Encoder::new(file, width, height);
    encoder.set_color(if opacity.is_some() { ColorType::Rgba } else { ColorType::Rgb });
    encoder.set_depth(if picture.is_sixteen() { BitDepth::Sixteen } else { BitDepth::Eight });
    match transfer {
        Transfer::Srgb => encoder.set_source_srgb(SrgbRenderingIntent::Perceptual),
        Transfer::Direct => encoder.add_text_chunk("Comment".into(), DIRECT.into())?,
    }
    let mut writer = encoder.write_header()?;
    let mut stream = writer.stream_writer()?;
    let (count, full) = (width as usize * height as usize, picture.full());
    let mut bytes = Vec::with_capacity(8);
    match (&picture.pixels, opacity) {
        (Pixels::Eight(list), None) => stream.write_all(list.as_flattened())?,
        _ => {
            for index in 0..count {
                let alpha = opacity.map(|opacity| code(opacity[index], full));
                bytes.clear();
                for code in picture.codes(index).into_iter().chain(alpha) {
                    // The upper byte comes first.
                    let [.., upper, lower] = code.to_be_bytes();
                    bytes.extend(picture.is_sixteen().then_some(upper).into_iter().chain([lower]));
                }
                stream.write_all(&bytes)?;
            }
        }
    }
    stream.finish()?;
    writer.finish()
}

#[cfg(test)]
mod tests {
    use super::*;

    fn eight(picture: &Picture) -> &[[u8; 3]] {
        let Pixels::Eight(list) = &picture.pixels else { panic!("8 bits") };
        list
    }

    #[test]
    fn pasting_keeps_to_the_picture() {
        let mut sheet = Picture::filled([3, 2], false, [0.0; 3]);
        let white = Picture::filled([2, 2], true, [1.0; 3]);
        sheet.paste(&white, [2, 1]);
        sheet.paste(&white, [7, 7]);
        let white_at: Vec<usize> = (0..6).filter(|&i| eight(&sheet)[i] == [255; 3]).collect();
        assert_eq!(white_at, [5]);
        let mut wide = Picture::filled([1, 1], true, [0.0; 3]);
        wide.paste(&Picture::filled([1, 1], false, [1.0, 0.0, 128.0 / 255.0]), [0, 0]);
        assert_eq!(wide.pixels, Pixels::Sixteen(vec![[65_535, 0, 128 * 257]]));
    }

    #[test]
    fn blending_mixes_codes() {
        let mut picture = Picture::filled([1, 1], false, [0.0, 1.0, 0.2]);
        picture.blend([0, 0], [1.0, 0.0, 0.2], 0.25);
        picture.blend([-1, 0], [1.0; 3], 1.0);
        picture.blend([0, 1], [1.0; 3], 1.0);
        assert_eq!(eight(&picture), [[64, 191, 51]]);
    }

    #[test]
    fn sizes_are_checked() {
        let picture = Picture { size: [2, 2], pixels: Pixels::Eight(vec![[0; 3]; 3]) };
        assert!(matches!(picture.check("PNG", 100, None), Err(ReportError::Pixels(2, 2, 3))));
        let wide = Picture::filled([7, 1], false, [0.0; 3]);
        assert!(matches!(wide.check("GIF", 6, None), Err(ReportError::Size { .. })));
        assert!(wide.check("GIF", 7, None).is_ok());
    }

    fn has_chunk(file: &[u8], name: &[u8; 4]) -> bool {
        file.windows(4).any(|window| window == name)
    }

    fn sample(sixteen: bool) -> Picture {
        let pixels = match sixteen {
            false => Pixels::Eight((0..=255).map(|i| [i, 255 - i, i / 2]).collect()),
            true => Pixels::Sixteen((0..256).map(|i| [i * 257, i * 3, 65_535 - i]).collect()),
        };
        Picture { size: [16, 16], pixels }
    }

    #[test]
    fn what_goes_in_comes_out() {
        for sixteen in [false, true] {
            let picture = sample(sixteen);
            let decoded =
                image::load_from_memory(&encode_png(&picture, None, Transfer::Srgb).unwrap()).unwrap();
            assert_eq!([decoded.width(), decoded.height()], picture.size);
            match &picture.pixels {
                Pixels::Eight(list) => assert_eq!(decoded.into_rgb8().as_raw(), list.as_flattened()),
                Pixels::Sixteen(list) => assert_eq!(decoded.into_rgb16().as_raw(), list.as_flattened()),
            }
        }
    }

    #[test]
    fn the_transfer_is_marked() {
        let srgb = encode_png(&sample(false), None, Transfer::Srgb).unwrap();
        assert!(has_chunk(&srgb, b"sRGB"));
        let direct = encode_png(&sample(false), None, Transfer::Direct).unwrap();
        for claim in [b"sRGB", b"gAMA", b"cHRM", b"iCCP"] {
            assert!(!has_chunk(&direct, claim));
        }
        assert!(has_chunk(&direct, b"tEXt"));
        assert!(!has_chunk(&srgb, b"tEXt"));
    }

    #[test]
    fn wrong_sizes_are_refused() {
        let empty = Picture { size: [0, 4], pixels: Pixels::Eight(Vec::new()) };
        assert!(matches!(encode_png(&empty, None, Transfer::Srgb), Err(ReportError::Size { .. })));
        let few = Some(&[1.0][..]);
        let refused = [encode_png(&sample(false), few, Transfer::Srgb), encode_webp(&sample(true), few)];
        assert!(refused.iter().all(|file| matches!(file, Err(ReportError::Pixels(.., 1)))));
    }
}
