//! GIF animations, written frame by frame with one palette, so that still parts do not flicker.

use super::error::ReportError;
use super::picture::Picture;
use image::codecs::gif::{GifEncoder, Repeat};
use image::{Delay, Frame, RgbaImage};
use std::collections::BTreeSet;
use std::io::Write;

/// Most entries that a GIF palette has.
pub(super) const LARGEST: usize = 256;
const BITS: u32 = 6;
const DROPPED: u32 = 8 - BITS;

/// At most 256 colours that represent those of some pictures.
///
/// Pictures of at most 256 colours keep them exactly. Else colours are counted in cells of 4 × 4 × 4 codes, and cells
/// are put together by median cut (Heckbert 1982): the box whose pixels times squared longest side are the most is cut
/// across that side where half of its pixels lie to each side, until there are 256 boxes; a box becomes the mean of
/// its pixels. Each cell takes the nearest of these means. Ties go to the first box and the first component, so the
/// same pictures give the same palette on any machine.
#[derive(Clone, Debug)]
pub struct Palette {
    colours: Vec<[u8; 3]>,
    /// The entry of each cell; empty if every colour is an entry.
    entry_of_cell: Vec<u8>,
}

#[derive(Clone, Copy, Debug, Default)]
struct Cell {
    count: u64,
    sum: [u64; 3],
}

/// Cells that share an entry, and what decides whether they are cut.
struct Group {
    cells: Vec<u32>,
    count: u64,
    /// The component that varies most, and by how many cells.
    axis: usize,
    extent: u32,
}

/// The colours of pictures, counted one picture after the other: 8 MiB, however many there are.
#[derive(Clone, Debug)]
pub struct ColourCount {
    /// As long as they fit in a palette.
    distinct: BTreeSet<[u8; 3]>,
    cells: Vec<Cell>,
}

impl Default for ColourCount {
    fn default() -> Self {
        Self { distinct: BTreeSet::new(), cells: vec![Cell::default(); 1 << (3 * BITS)] }
    }
}

impl ColourCount {
    /// Counts the colours of a picture.
    pub fn add(&mut self, picture: &[[u8; 3]]) {
        for &colour in picture {
            if self.distinct.len() <= LARGEST {
                self.distinct.insert(colour);
            }
            let cell = &mut self.cells[cell_of(colour)];
            cell.count += 1;
            cell.sum.iter_mut().zip(colour).for_each(|(sum, c)| *sum += u64::from(c));
        }
    }
}

impl Palette {
    /// The palette of the pictures that were counted.
    pub fn new(count: ColourCount) -> Self {
        let ColourCount { distinct, cells } = count;
        if distinct.len() <= LARGEST {
            return Self { colours: distinct.into_iter().collect(), entry_of_cell: Vec::new() };
        }
        let used: Vec<u32> = (0..cells.len() as u32).filter(|&cell| cells[cell as usize].count > 0).collect();
        let groups = cut(used.clone(), &cells);
        let colours: Vec<[u8; 3]> = groups.iter().map(|group| mean(group, &cells)).collect();
        let mut entry_of_cell = vec![0; cells.len()];
        for cell in used {
            entry_of_cell[cell as usize] = nearest(&colours, mean_of(&cells[cell as usize]));
        }
        Self { colours, entry_of_cell }
    }

    /// Its entries.
    pub fn colours(&self) -> &[[u8; 3]] {
        &self.colours
    }

    /// The entry that represents a colour of the counted pictures.
    pub fn entry(&self, colour: [u8; 3]) -> [u8; 3] {
        if self.entry_of_cell.is_empty() {
            return colour;
        }
        self.colours[usize::from(self.entry_of_cell[cell_of(colour)])]
    }
}

fn cell_of(colour: [u8; 3]) -> usize {
    colour.into_iter().fold(0, |cell, c| cell << BITS | usize::from(c >> DROPPED))
}

fn component(cell: u32, axis: usize) -> u32 {
    cell >> (BITS * (2 - axis as u32)) & ((1 << BITS) - 1)
}

impl Group {
    fn new(members: Vec<u32>, cells: &[Cell]) -> Self {
        let extent = |axis: usize| {
            let values = || members.iter().map(|&cell| component(cell, axis));
            values().max().unwrap_or(0) - values().min().unwrap_or(0)
        };
        // The first of those that vary most.
        let (extent, axis) =
            (0..3).map(|axis| (extent(axis), axis)).rev().max_by_key(|&(extent, _)| extent).unwrap_or((0, 0));
        let count = members.iter().map(|&cell| cells[cell as usize].count).sum();
        Self { cells: members, count, axis, extent }
    }

    /// How much the group would gain by being cut.
    fn spread(&self) -> u64 {
        self.count * u64::from(self.extent).pow(2)
    }
}

fn cut(used: Vec<u32>, cells: &[Cell]) -> Vec<Group> {
    let mut groups = vec![Group::new(used, cells)];
    while groups.len() < LARGEST {
        let widest = (0..groups.len()).rev().max_by_key(|&group| groups[group].spread());
        let Some(widest) = widest.filter(|&group| groups[group].extent > 0) else { break };
        let Group { cells: mut members, count, axis, .. } = groups.swap_remove(widest);
        members.sort_by_key(|&cell| component(cell, axis));
        let mut before = 0;
        let half = members.iter().position(|&cell| {
            before += cells[cell as usize].count;
            2 * before >= count
        });
        // The cut runs between two values of the component, both sides not empty.
        let value = component(members[half.unwrap_or(0)], axis);
        let mut at = members.partition_point(|&cell| component(cell, axis) <= value);
        if at == members.len() {
            at = members.partition_point(|&cell| component(cell, axis) < value);
        }
        let upper = members.split_off(at);
        groups.push(Group::new(members, cells));
        groups.push(Group::new(upper, cells));
    }
    groups
}

fn mean(group: &Group, cells: &[Cell]) -> [u8; 3] {
    let total = group.cells.iter().fold(Cell::default(), |total, &cell| {
        let cell = cells[cell as usize];
        Cell { count: total.count + cell.count, sum: [0, 1, 2].map(|axis| total.sum[axis] + cell.sum[axis]) }
    });
    mean_of(&total)
}

fn mean_of(cell: &Cell) -> [u8; 3] {
    cell.sum.map(|sum| ((sum + cell.count / 2) / cell.count) as u8)
}

fn nearest(colours: &[[u8; 3]], colour: [u8; 3]) -> u8 {
    let distance = |entry: &[u8; 3]| -> u32 {
        entry.iter().zip(colour).map(|(&a, b)| u32::from(a.abs_diff(b)).pow(2)).sum()
    };
    let best = (0..colours.len()).min_by_key(|&entry| distance(&colours[entry]));
    best.unwrap_or(0) as u8
}

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

    /// A single picture.
    pub const STILL: Animation = Animation { frames: 1, hundredths: 0 };

    /// How often a frame of this size is drawn in all: each once, and those that are not kept once more.
    pub fn drawings(&self, size: [u32; 2]) -> usize {
        let bytes = size.iter().map(|&side| side as usize).product::<usize>() * size_of::<[u8; 3]>();
        2 * self.frames - (Self::KEPT / bytes.max(1)).min(self.frames)
    }

    /// Writes the animation as a GIF file. `draw` returns the frame of a number, the same at each call; of 16-bit components the
    /// upper half is taken. GIF cannot specify the meaning of its numbers; viewers take them as sRGB.
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
            picture.check("GIF", Self::LARGEST, None)?;
            let (found, first) = (picture.size, *first.get_or_insert(picture.size));
            if found != first {
                return Err(ReportError::Frame { number, found, first }.into());
            }
            let pixels = picture.into_eight_bits();
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
            let pixels = kept.next().map_or_else(|| draw(number).map(Picture::into_eight_bits), Ok)?;
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

#[cfg(test)]
mod tests {
    use super::*;
    use crate::raster::Pixels;
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
        assert!(matches!(gif(2, other), Err(ReportError::Frame { number: 1, .. })));
    }

    fn palette(pictures: &[&[[u8; 3]]]) -> Palette {
        let mut count = ColourCount::default();
        pictures.iter().for_each(|picture| count.add(picture));
        Palette::new(count)
    }

    #[test]
    fn few_colours_stay() {
        let picture: Vec<[u8; 3]> = (0..=255).map(|i| [i, 7, 255 - i]).collect();
        let palette = palette(&[&picture, &picture[..40]]);
        assert_eq!(palette.colours().len(), 256);
        assert!(picture.iter().all(|&colour| palette.entry(colour) == colour));
    }

    #[test]
    fn many_colours_are_near_their_entries() {
        let picture: Vec<[u8; 3]> = (0..4096_u32)
            .map(|i| [(i % 64) as u8 * 4, (i / 64) as u8 * 4, (i % 64 + i / 64) as u8 * 2])
            .collect();
        let palette = palette(&[&picture]);
        assert_eq!(palette.colours().len(), 256);
        let error = |colour: [u8; 3]| {
            let entry = palette.entry(colour);
            (0..3).map(|k| entry[k].abs_diff(colour[k])).max().unwrap()
        };
        let worst = picture.iter().map(|&colour| error(colour)).max().unwrap();
        // A plane of 4096 colours on 256 entries: squares of 4 by 4 of them, 16 codes wide. From the middle: 8 or 9.
        assert!((4..=10).contains(&worst), "{worst}");
    }

    /// A rare colour far from all others has an entry of its own.
    #[test]
    fn rare_colours_are_kept() {
        let mut picture: Vec<[u8; 3]> =
            (0..100_000_u32).map(|i| [(i % 256) as u8, (i % 253) as u8, 0]).collect();
        picture.extend([[0, 0, 255]; 40]);
        assert_eq!(palette(&[&picture]).entry([0, 0, 255]), [0, 0, 255]);
    }

    #[test]
    fn nothing_has_no_colours() {
        assert!(palette(&[]).colours().is_empty());
    }
}
