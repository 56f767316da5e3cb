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

    /// Copies another picture into this one, its upper left corner at `at`; parts outside are omitted. Components of
    /// 8 bits become 16 bits by 257·c, which keeps black and white, and 16 bits become 8 by their upper half.
    pub fn paste(&mut self, other: &Picture, at: [u32; 2]) {
        let width = (other.size[0].min(self.size[0].saturating_sub(at[0]))) as usize;
        let rows = other.size[1].min(self.size[1].saturating_sub(at[1]));
        for row in 0..rows {
            let from = row as usize * other.size[0] as usize;
            let to = (at[1] + row) as usize * self.size[0] as usize + at[0] as usize;
            let (from, to) = (from..from + width, to..to + width);
            match (&mut self.pixels, &other.pixels) {
                (Pixels::Eight(to_list), Pixels::Eight(list)) => to_list[to].copy_from_slice(&list[from]),
                (Pixels::Sixteen(to_list), Pixels::Sixteen(list)) => to_list[to].copy_from_slice(&list[from]),
                (Pixels::Sixteen(to_list), Pixels::Eight(list)) => {
                    let wide = list[from].iter().map(|pixel| pixel.map(|c| u16::from(c) * 257));
                    to_list[to].iter_mut().zip(wide).for_each(|(to, pixel)| *to = pixel);
                }
                (Pixels::Eight(to_list), Pixels::Sixteen(list)) => {
                    let narrow = list[from].iter().map(|pixel| pixel.map(|c| (c >> 8) as u8));
                    to_list[to].iter_mut().zip(narrow).for_each(|(to, pixel)| *to = pixel);
                }
            }
        }
    }

    /// Mixes a colour (shares of the full code) into a pixel; nothing happens outside the picture.
    pub fn blend(&mut self, [x, y]: [i64; 2], colour: [f32; 3], share: f32) {
        let [width, height] = self.size.map(i64::from);
        if !(0..width).contains(&x) || !(0..height).contains(&y) {
            return;
        }
        let index = (y * width + x) as usize;
        let mix = |old: f32, new: f32| old + (new - old) * share;
        match &mut self.pixels {
            Pixels::Eight(list) => {
                for (old, new) in list[index].iter_mut().zip(colour) {
                    *old = code(mix(f32::from(*old) / 255.0, new), 255.0) as u8;
                }
            }
            Pixels::Sixteen(list) => {
                for (old, new) in list[index].iter_mut().zip(colour) {
                    *old = code(mix(f32::from(*old) / 65_535.0, new), 65_535.0) as u16;
                }
            }
        }
    }

    /// Whether there are as many pixels as the size says, and sides that a format has room for.
    pub(super) fn check(&self, format: &'static str, largest: u32) -> Result<()> {
        let [width, height] = self.size;
        if !self.size.iter().all(|side| (1..=largest).contains(side)) {
            return Err(ReportError::Size { format, largest, width, height });
        }
        let found = match &self.pixels {
            Pixels::Eight(list) => list.len(),
            Pixels::Sixteen(list) => list.len(),
        };
        let expected = width as usize * height as usize;
        if found == expected { Ok(()) } else { Err(ReportError::Pixels(width, height, found)) }
    }
}

/// The nearest code of a share, with this one as the largest.
fn code(share: f32, largest: f32) -> u32 {
    (share.clamp(0.0, 1.0) * largest + 0.5) as u32
}

/// The largest side of a PNG picture that libraries agree on.
const LARGEST: u32 = i32::MAX as u32;
const DIRECT: &str = "Codes are the computed numbers themselves: no transfer curve.";

/// A picture as a PNG file of 8 or 16 bits a component.
///
/// [`Transfer::Srgb`] marks it as sRGB. Under [`Transfer::Direct`] no curve is applied to codes, which are to be sent to the
/// screen unchanged: the file specifies no colour space, which viewers would apply, but a comment explains this. The same picture
/// gives the same bytes on any machine.
///
/// # Errors
/// Sizes that do not fit the pixels or the format.
pub fn encode_png(picture: &Picture, transfer: Transfer) -> Result<Vec<u8>> {
    png(picture, None, transfer)
}

/// As [`encode_png`], with an alpha channel.
///
/// # Errors
/// As [`encode_png`].
pub fn encode_png_cut_out(cut: &CutOut, transfer: Transfer) -> Result<Vec<u8>> {
    png(&cut.picture, Some(&cut.opacity), transfer)
}

fn png(picture: &Picture, opacity: Option<&[f32]>, transfer: Transfer) -> Result<Vec<u8>> {
    picture.check("PNG", LARGEST)?;
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
    picture.check("JPEG", LARGEST_JPEG)?;
    let mut file = Vec::new();
    encoded_by(JpegEncoder::new_with_quality(&mut file, JPEG_QUALITY), picture)?;
    Ok(file)
}

/// A picture as a WebP file without loss. Of 16-bit components the upper half is taken. Viewers take the codes as sRGB.
///
/// # Errors
/// Sizes that do not fit the pixels or the format.
pub fn encode_webp(picture: &Picture) -> Result<Vec<u8>> {
    picture.check("WebP", LARGEST_WEBP)?;
    let mut file = Vec::new();
    encoded_by(WebPEncoder::new_lossless(&mut file), picture)?;
    Ok(file)
}

/// As [`encode_webp`], with an alpha channel.
///
/// # Errors
/// As [`encode_webp`].
pub fn encode_webp_cut_out(CutOut { picture, opacity }: &CutOut) -> Result<Vec<u8>> {
    picture.check("WebP", LARGEST_WEBP)?;
    let [width, height] = picture.size;
    let with_alpha = |([r, g, b], &opacity): ([u8; 3], &f32)| [r, g, b, code(opacity, 255.0) as u8];
    let bytes: Vec<[u8; 4]> = eight_bits(picture).into_iter().zip(opacity).map(with_alpha).collect();
    let mut file = Vec::new();
    let written = WebPEncoder::new_lossless(&mut file).write_image(
        bytes.as_flattened(),
        width,
        height,
        ExtendedColorType::Rgba8,
    );
    written.map_err(|error| ReportError::Encoder(error.to_string()))?;
    Ok(file)
}

fn eight_bits(picture: &Picture) -> Vec<[u8; 3]> {
    match &picture.pixels {
        Pixels::Eight(list) => list.clone(),
        Pixels::Sixteen(list) => {
            list.iter().map(|pixel| pixel.map(|component| (component >> 8) as u8)).collect()
        }
    }
}

fn encoded_by(encoder: impl ImageEncoder, picture: &Picture) -> Result<()> {
    let [width, height] = picture.size;
    let bytes = eight_bits(picture);
    let written = encoder.write_image(bytes.as_flattened(), width, height, ExtendedColorType::Rgb8);
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
    let alpha = |index: usize, full: f32| opacity.map(|opacity| code(opacity[index], full));
    let mut bytes = Vec::with_capacity(width as usize * 8);
    match &picture.pixels {
        Pixels::Eight(list) if opacity.is_none() => stream.write_all(list.as_flattened())?,
        Pixels::Eight(list) => {
            for (index, pixel) in list.iter().enumerate() {
                bytes.clear();
                bytes.extend(pixel);
                bytes.extend(alpha(index, 255.0).map(|alpha| alpha as u8));
                stream.write_all(&bytes)?;
            }
        }
        Pixels::Sixteen(list) => {
            // The numbers are stored with the upper byte first.
            for (index, pixel) in list.iter().enumerate() {
                bytes.clear();
                bytes.extend(pixel.iter().flat_map(|component| component.to_be_bytes()));
                bytes.extend(alpha(index, 65_535.0).iter().flat_map(|&alpha| (alpha as u16).to_be_bytes()));
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
        assert!(matches!(picture.check("PNG", 100), Err(ReportError::Pixels(2, 2, 3))));
        let wide = Picture::filled([7, 1], false, [0.0; 3]);
        assert!(matches!(wide.check("GIF", 6), Err(ReportError::Size { .. })));
        assert!(wide.check("GIF", 7).is_ok());
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
            let decoded = image::load_from_memory(&encode_png(&picture, Transfer::Srgb).unwrap()).unwrap();
            assert_eq!([decoded.width(), decoded.height()], picture.size);
            match &picture.pixels {
                Pixels::Eight(list) => assert_eq!(decoded.into_rgb8().as_raw(), list.as_flattened()),
                Pixels::Sixteen(list) => assert_eq!(decoded.into_rgb16().as_raw(), list.as_flattened()),
            }
        }
    }

    #[test]
    fn the_transfer_is_marked() {
        let srgb = encode_png(&sample(false), Transfer::Srgb).unwrap();
        assert!(has_chunk(&srgb, b"sRGB"));
        let direct = encode_png(&sample(false), Transfer::Direct).unwrap();
        for claim in [b"sRGB", b"gAMA", b"cHRM", b"iCCP"] {
            assert!(!has_chunk(&direct, claim));
        }
        assert!(has_chunk(&direct, b"tEXt"));
        assert!(!has_chunk(&srgb, b"tEXt"));
    }

    #[test]
    fn wrong_sizes_are_refused() {
        let empty = Picture { size: [0, 4], pixels: Pixels::Eight(Vec::new()) };
        assert!(matches!(encode_png(&empty, Transfer::Srgb), Err(ReportError::Size { .. })));
    }
}
