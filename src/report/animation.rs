//! GIF animations, written frame by frame.

use super::error::ReportError;
use super::palette::{ColourCount, Palette};
use super::picture::Picture;
use crate::raster::Pixels;
use image::codecs::gif::{GifEncoder, Repeat};
use image::{Delay, Frame, RgbaImage};
use std::io::Write;

/// Pictures shown one after the other, without end.
///
/// All frames share one [`Palette`], so that still parts do not flicker; it is known when the last frame has been
/// seen. Frames are kept until then as far as they take no more than [`KEPT`](Self::KEPT) bytes; the others are drawn again.
/// So an animation takes no more memory than a picture, however long it is.
#[derive(Clone, Copy, Debug)]
pub struct Animation {
    /// How many frames there are, 1 or more.
    pub frames: usize,
    /// How long each is shown, in hundredths of a second.
    pub hundredths: u16,
}

impl Animation {
    /// The largest side of a GIF picture.
    pub const LARGEST: u32 = 65_535;
    /// Bytes of frames that are kept.
    pub const KEPT: usize = 32 << 20;

    /// One picture that stands still.
    pub const STILL: Animation = Animation { frames: 1, hundredths: 0 };

    /// How many times a frame of this size is asked for: each once, and those that are not kept once more.
    pub fn drawings(&self, size: [u32; 2]) -> usize {
        let bytes = size.iter().map(|&side| side as usize).product::<usize>() * size_of::<[u8; 3]>();
        2 * self.frames - (Self::KEPT / bytes.max(1)).min(self.frames)
    }

    /// Writes the animation as a GIF file. `draw` gives the frame of a number, the same whenever it is asked; of 16-bit
    /// components the upper half is taken. GIF has no way to say what its numbers mean; viewers take them as sRGB.
    ///
    /// # Errors
    /// Those of drawing. If there is no frame, one has not the size of the first, or no size that a GIF can have, and if the
    /// file cannot be written.
    pub fn write_gif<E: From<ReportError>>(
        &self,
        out: impl Write,
        mut draw: impl FnMut(usize) -> Result<Picture, E>,
    ) -> Result<(), E> {
        let (mut first, mut count, mut kept, mut room) =
            (None, ColourCount::default(), Vec::new(), Self::KEPT);
        for number in 0..self.frames {
            let picture = draw(number)?;
            picture.check("GIF", Self::LARGEST)?;
            let (found, first) = (picture.size, *first.get_or_insert(picture.size));
            if found != first {
                return Err(ReportError::Frame { number: number + 1, found, first }.into());
            }
            let pixels = eight_bits(picture);
            count.add(&pixels);
            // Only the first ones: the numbers of those that are kept have no gap.
            if kept.len() == number && room >= size_of_val(&pixels[..]) {
                room -= size_of_val(&pixels[..]);
                kept.push(pixels);
            }
        }
        let [width, height] = first.ok_or(ReportError::Empty)?;
        let palette = Palette::new(count);
        let failed = |error: image::ImageError| ReportError::Encoder(error.to_string());
        // Frames of at most 256 colours, which these are, are stored as they are, whatever the encoder's speed.
        let mut encoder = GifEncoder::new_with_speed(out, 10);
        encoder.set_repeat(Repeat::Infinite).map_err(failed)?;
        let delay = Delay::from_numer_denom_ms(u32::from(self.hundredths) * 10, 1);
        let mut kept = kept.into_iter();
        for number in 0..self.frames {
            let pixels = kept.next().map_or_else(|| draw(number).map(eight_bits), Ok)?;
            let rgba = pixels.iter().flat_map(|&colour| {
                let [r, g, b] = palette.entry(colour);
                [r, g, b, u8::MAX]
            });
            let frame = RgbaImage::from_raw(width, height, rgba.collect()).ok_or(ReportError::Empty)?;
            encoder.encode_frame(Frame::from_parts(frame, 0, 0, delay)).map_err(failed)?;
        }
        Ok(())
    }
}

fn eight_bits(picture: Picture) -> Vec<[u8; 3]> {
    match picture.pixels {
        Pixels::Eight(list) => list,
        Pixels::Sixteen(list) => list.iter().map(|pixel| pixel.map(|c| (c >> 8) as u8)).collect(),
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

    fn gif(frames: usize, mut draw: impl FnMut(usize) -> Picture) -> Result<Vec<u8>, ReportError> {
        let mut file = Vec::new();
        let animation = Animation { frames, hundredths: 7 };
        animation.write_gif(&mut file, |number| Ok::<_, ReportError>(draw(number)))?;
        Ok(file)
    }

    #[test]
    fn frames_come_out_as_they_went_in() {
        let file = gif(3, |number| frame(80 * number as u8)).unwrap();
        assert_eq!(file, gif(3, |number| frame(80 * number as u8)).unwrap(), "the same bytes again");
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

    /// 2048 × 2048 pixels of three bytes are 12 MiB: two frames are kept, and the others drawn twice.
    #[test]
    fn frames_beyond_what_is_kept_are_redrawn() {
        let size = [2048, 2048];
        let mut asked = Vec::new();
        let file = gif(4, |number| {
            asked.push(number);
            Picture::filled(size, false, [number as f32 / 3.0, 0.0, 0.0])
        });
        assert_eq!(asked, [0, 1, 2, 3, 2, 3]);
        assert_eq!(Animation { frames: 4, hundredths: 7 }.drawings(size), 6);
        assert_eq!(Animation { frames: 720, hundredths: 7 }.drawings([8, 8]), 720);
        let decoder = GifDecoder::new(Cursor::new(file.unwrap())).unwrap();
        let last = decoder.into_frames().collect_frames().unwrap().pop().unwrap();
        assert_eq!(last.buffer().get_pixel(2047, 0).0, [255, 0, 0, 255]);
    }

    #[test]
    fn what_does_not_fit_is_refused() {
        assert!(matches!(gif(0, |_| frame(0)), Err(ReportError::Empty)));
        let other = |number: usize| match number {
            0 => frame(0),
            _ => Picture::filled([7, 8], true, [0.0; 3]),
        };
        assert!(matches!(gif(2, other), Err(ReportError::Frame { number: 2, .. })));
    }
}
