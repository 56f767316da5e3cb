//! GIF animations.

use super::error::ReportError;
use super::palette::Palette;
use super::picture::Picture;
use crate::raster::Pixels;
use image::codecs::gif::{GifEncoder, Repeat};
use image::{Delay, Frame, RgbaImage};

/// Pictures shown one after the other, without end.
#[derive(Clone, Debug, Default)]
pub struct Animation {
    size: [u32; 2],
    frames: Vec<Vec<[u8; 3]>>,
}

impl Animation {
    /// The largest side of a GIF picture.
    pub const LARGEST: u32 = 65_535;

    /// Appends a frame; of 16-bit components the upper half is taken.
    ///
    /// # Errors
    /// If it has not the size of the first frame, or no size that a GIF can have.
    pub fn push(&mut self, frame: Picture) -> Result<(), ReportError> {
        frame.check("GIF", Self::LARGEST)?;
        if self.frames.is_empty() {
            self.size = frame.size;
        } else if frame.size != self.size {
            let number = self.frames.len() + 1;
            return Err(ReportError::Frame { number, found: frame.size, first: self.size });
        }
        self.frames.push(match frame.pixels {
            Pixels::Eight(list) => list,
            Pixels::Sixteen(list) => list.iter().map(|pixel| pixel.map(|c| (c >> 8) as u8)).collect(),
        });
        Ok(())
    }

    /// How many frames there are.
    pub fn len(&self) -> usize {
        self.frames.len()
    }

    /// Whether there is none.
    pub fn is_empty(&self) -> bool {
        self.frames.is_empty()
    }

    /// The animation as a GIF file: each frame is shown for `hundredths` of a second, and all share one [`Palette`]. GIF
    /// has no way to say what its numbers mean; viewers take them as sRGB.
    ///
    /// # Errors
    /// If there is no frame.
    pub fn encode_gif(&self, hundredths: u16) -> Result<Vec<u8>, ReportError> {
        if self.is_empty() {
            return Err(ReportError::Empty);
        }
        let palette = Palette::of(self.frames.iter().map(Vec::as_slice));
        let [width, height] = self.size;
        let delay = Delay::from_numer_denom_ms(u32::from(hundredths) * 10, 1);
        let mut file = Vec::new();
        // Frames of at most 256 colours, which these are, are stored as they are, whatever the encoder's speed.
        let mut encoder = GifEncoder::new_with_speed(&mut file, 10);
        let failed = |error: image::ImageError| ReportError::Encoder(error.to_string());
        encoder.set_repeat(Repeat::Infinite).map_err(failed)?;
        for frame in &self.frames {
            let rgba = frame.iter().flat_map(|&colour| {
                let [r, g, b] = palette.entry(colour);
                [r, g, b, u8::MAX]
            });
            let frame = RgbaImage::from_raw(width, height, rgba.collect()).ok_or(ReportError::Empty)?;
            encoder.encode_frame(Frame::from_parts(frame, 0, 0, delay)).map_err(failed)?;
        }
        drop(encoder);
        Ok(file)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use image::AnimationDecoder;
    use image::codecs::gif::GifDecoder;
    use std::io::Cursor;

    fn frame(shift: u8) -> Picture {
        let pixels = (0..64_u8).map(|i| [i * 4, shift, 255 - i]).collect();
        Picture { size: [8, 8], pixels: Pixels::Eight(pixels) }
    }

    #[test]
    fn frames_come_out_as_they_went_in() {
        let mut animation = Animation::default();
        for shift in [0, 80, 160] {
            animation.push(frame(shift)).unwrap();
        }
        let file = animation.encode_gif(7).unwrap();
        assert_eq!(file, animation.encode_gif(7).unwrap(), "the same bytes again");
        let decoder = GifDecoder::new(Cursor::new(&file)).unwrap();
        let decoded = decoder.into_frames().collect_frames().unwrap();
        assert_eq!(decoded.len(), 3);
        for (decoded, shift) in decoded.into_iter().zip([0, 80, 160]) {
            assert_eq!(decoded.delay().numer_denom_ms(), (70, 1));
            let found: Vec<[u8; 3]> = decoded.buffer().pixels().map(|p| [p.0[0], p.0[1], p.0[2]]).collect();
            assert_eq!(Pixels::Eight(found), frame(shift).pixels);
        }
        assert!(file.windows(11).any(|window| window == b"NETSCAPE2.0"), "it starts again");
    }

    #[test]
    fn what_does_not_fit_is_refused() {
        assert!(matches!(Animation::default().encode_gif(5), Err(ReportError::Empty)));
        let mut animation = Animation::default();
        animation.push(frame(0)).unwrap();
        let other = Picture::filled([7, 8], true, [0.0; 3]);
        assert!(matches!(animation.push(other), Err(ReportError::Frame { number: 2, .. })));
    }
}
