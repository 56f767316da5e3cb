//! PNG files that state the meaning of their numbers.

use super::error::ReportError;
use super::picture::Picture;
use crate::num::Transfer;
use crate::raster::Pixels;
use png::{BitDepth, ColorType, Encoder, SrgbRenderingIntent};
use std::io::Write;

/// The largest side of a PNG picture that libraries agree on.
const LARGEST: u32 = i32::MAX as u32;
const DIRECT: &str = "Codes are the computed numbers themselves: no transfer curve.";

/// A picture as a PNG file of 8 or 16 bits a component.
///
/// [`Transfer::Srgb`] marks it as sRGB. Under [`Transfer::Direct`] codes are numbers that no curve was applied to, to be
/// sent to the screen as they are: the file makes no claim about colour, which viewers would act upon, but says so in a
/// comment. The same picture gives the same bytes on any machine.
///
/// # Errors
/// Sizes that do not fit the pixels or the format.
pub fn encode_png(picture: &Picture, transfer: Transfer) -> Result<Vec<u8>, ReportError> {
    picture.check("PNG", LARGEST)?;
    let mut file = Vec::new();
    write(picture, transfer, &mut file).map_err(|error| ReportError::Encoder(error.to_string()))?;
    Ok(file)
}

fn write(picture: &Picture, transfer: Transfer, file: &mut Vec<u8>) -> Result<(), png::EncodingError> {
    let [width, height] = picture.size;
    let mut encoder = Encoder::new(file, width, height);
    encoder.set_color(ColorType::Rgb);
    encoder.set_depth(if picture.is_sixteen() { BitDepth::Sixteen } else { BitDepth::Eight });
    match transfer {
        Transfer::Srgb => encoder.set_source_srgb(SrgbRenderingIntent::Perceptual),
        Transfer::Direct => encoder.add_text_chunk("Comment".into(), DIRECT.into())?,
    }
    let mut writer = encoder.write_header()?;
    let mut stream = writer.stream_writer()?;
    match &picture.pixels {
        Pixels::Eight(list) => stream.write_all(list.as_flattened())?,
        Pixels::Sixteen(list) => {
            // Row by row: the numbers are stored with the upper byte first.
            let mut bytes = Vec::with_capacity(width as usize * 6);
            for row in list.chunks(width as usize) {
                bytes.clear();
                bytes.extend(row.as_flattened().iter().flat_map(|component| component.to_be_bytes()));
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
