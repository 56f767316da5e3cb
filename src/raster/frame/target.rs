//! Tiles written to the picture: linear colours to stored numbers.

use crate::num::{self, Kernel, Lanes, Transfer};
use crate::raster::coverage::setup::{SIDE, TILE};
use crate::raster::coverage::tile_bins::tiles;
use crate::raster::coverage::visible_triangle::{LANES, PIXELS, place};
use crate::raster::frame::job::Job;
use crate::raster::frame::tile::Finished;
use crate::raster::picture::{Image, Pixels};
use crate::raster::settings::RenderSettings;
use crate::shade::ToneRule;

/// The rows of a picture that lie in a tile.
pub(crate) struct Target<'a> {
    pub(crate) tile: [usize; 2],
    colours: TargetColours<'a>,
    coverage: Vec<&'a mut [u8]>,
    linear: Vec<&'a mut [[f32; 3]]>,
    objects: Vec<&'a mut [u32]>,
}

enum TargetColours<'a> {
    Eight(Vec<&'a mut [[u8; 3]]>),
    Sixteen(Vec<&'a mut [[u16; 3]]>),
}

pub(crate) fn targets(image: &mut Image) -> Vec<Target<'_>> {
    let size = image.size;
    let columns = tiles(size)[0];
    let colours: Vec<TargetColours> = match &mut image.pixels {
        Pixels::Eight(list) => rows_of_tiles(list, size).into_iter().map(TargetColours::Eight).collect(),
        Pixels::Sixteen(list) => rows_of_tiles(list, size).into_iter().map(TargetColours::Sixteen).collect(),
    };
    let mut linear = image.linear.as_mut().map(|list| rows_of_tiles(list, size).into_iter());
    let mut objects = image.objects.as_mut().map(|list| rows_of_tiles(list, size).into_iter());
    let coverage = rows_of_tiles(&mut image.coverage, size);
    let targets = colours.into_iter().zip(coverage).enumerate().map(|(number, (colours, coverage))| {
        let linear = linear.as_mut().and_then(Iterator::next).unwrap_or_default();
        let objects = objects.as_mut().and_then(Iterator::next).unwrap_or_default();
        Target { tile: [number % columns, number / columns], colours, coverage, linear, objects }
    });
    targets.collect()
}

/// Cuts a list of pixels into the rows of each tile, tile by tile.
fn rows_of_tiles<T>(list: &mut [T], size: [u32; 2]) -> Vec<Vec<&mut [T]>> {
    let [columns, rows] = tiles(size);
    let mut targets: Vec<Vec<&mut [T]>> = Vec::with_capacity(columns * rows);
    targets.resize_with(columns * rows, || Vec::with_capacity(TILE));
    for (y, row) in list.chunks_mut(size[0] as usize).enumerate() {
        for (x, part) in row.chunks_mut(TILE).enumerate() {
            targets[y / TILE * columns + x].push(part);
        }
    }
    targets
}

impl Target<'_> {
    pub(crate) fn write(&mut self, job: &Job, tile: Option<&Finished>) -> u64 {
        match tile {
            Some(tile) => num::dispatch(WriteTile { target: self, settings: job.settings, tile }),
            None => {
                self.fill(job);
                0
            }
        }
    }

    /// Background all over.
    fn fill(&mut self, job: &Job) {
        let RenderSettings { tone, transfer, .. } = job.settings;
        let toned = tone.apply(job.background);
        match &mut self.colours {
            TargetColours::Eight(rows) => {
                // A copy of many pixels is faster than one after the other.
                let pixels = [toned.map(|component| transfer.pixel_u8(component)); TILE];
                rows.iter_mut().for_each(|row| row.copy_from_slice(&pixels[..row.len()]));
            }
            TargetColours::Sixteen(rows) => {
                let pixel = toned.map(|component| transfer.to_u16(f64::from(component)));
                rows.iter_mut().for_each(|row| row.fill(pixel));
            }
        }
        self.coverage.iter_mut().for_each(|row| row.fill(0));
        self.objects.iter_mut().for_each(|row| row.fill(0));
        self.linear.iter_mut().for_each(|row| row.fill(job.background));
    }
}

/// Writes a tile row by row.
struct WriteTile<'a, 'b> {
    target: &'a mut Target<'b>,
    settings: &'a RenderSettings,
    tile: &'a Finished<'a>,
}

impl Kernel for WriteTile<'_, '_> {
    /// How many pixels are covered.
    type Output = u64;

    #[inline(always)]
    fn run<A: Lanes>(self, _: A) -> u64 {
        let Self { target, settings, tile } = self;
        let Target { colours, coverage, linear, objects, .. } = target;
        for first in (0..PIXELS).step_by(GROUP) {
            let at = first..first + GROUP;
            let lanes = tile.colours.each_ref().map(|row| row[at.clone()].first_chunk().expect("a group"));
            if !objects.is_empty() {
                write_blocks(objects, first, tile.objects[at.clone()].first_chunk().expect("a group"));
            }
            write_blocks(coverage, first, tile.covered[at.clone()].first_chunk().expect("a group"));
            if !linear.is_empty() {
                write_blocks(linear, first, &pixels(&lanes.map(|row| *row)));
            }
            let toned = toned(settings.tone, lanes);
            match colours {
                TargetColours::Eight(rows) => {
                    let codes = codes(settings.transfer, &toned);
                    write_codes(rows, first, &codes);
                }
                TargetColours::Sixteen(rows) => {
                    let code = |colour: [f32; 3]| colour.map(|c| settings.transfer.to_u16(f64::from(c)));
                    write_blocks(rows, first, &pixels(&toned).map(code));
                }
            }
        }
        match tile.edged {
            None => coverage.iter().flat_map(|row| row.iter()).map(|&samples| u64::from(samples > 0)).sum(),
            Some(edged) => {
                let inside = |[x, y]: [usize; 2]| coverage.get(y).is_some_and(|row| x < row.len());
                let counts = |&(pixel, &edged): &(usize, &bool)| edged && inside(place(pixel));
                edged.iter().enumerate().filter(counts).count() as u64
            }
        }
    }
}

/// Pixels of a tile that are written at a time: four blocks side by side.
const GROUP: usize = 4 * LANES;
/// Pixels of a group in a row of the picture.
const WIDTH: usize = 4 * SIDE;

/// Writes pixels, from this number on, to the rows of the picture as far as they reach.
#[inline(always)]
fn write_blocks<T: Copy>(rows: &mut [&mut [T]], first: usize, pixels: &[T; GROUP]) {
    let [x, y] = place(first);
    for (line, row) in rows.iter_mut().skip(y).take(SIDE).enumerate() {
        write_line(row, x, &line_of_blocks(pixels, line));
    }
}

/// Writes colours of which each is in the lower three bytes of a number, like [`write_blocks`].
#[inline(always)]
fn write_codes(rows: &mut [&mut [[u8; 3]]], first: usize, codes: &[u32; GROUP]) {
    let [x, y] = place(first);
    for (line, row) in rows.iter_mut().skip(y).take(SIDE).enumerate() {
        let mut words = [[[0; 4]; 3]; WIDTH / 4];
        for (words, four) in words.iter_mut().zip(line_of_blocks(codes, line).as_chunks::<4>().0) {
            let [a, b, c, d] = *four;
            *words = [a | b << 24, b >> 8 | c << 16, c >> 16 | d << 8].map(u32::to_le_bytes);
        }
        let bytes: &[[u8; 3]; WIDTH] =
            words.as_flattened().as_flattened().as_chunks().0.first_chunk().expect("a line");
        write_line(row, x, bytes);
    }
}

/// One of the four rows of pixels of a group.
#[inline(always)]
fn line_of_blocks<T: Copy>(pixels: &[T; GROUP], line: usize) -> [T; WIDTH] {
    std::array::from_fn(|x| pixels[x / SIDE * LANES + line * SIDE + x % SIDE])
}

/// Writes the pixels of a line that the row has room for.
#[inline(always)]
fn write_line<T: Copy>(row: &mut [T], x: usize, pixels: &[T; WIDTH]) {
    match row.get_mut(x..).and_then(|row| row.first_chunk_mut()) {
        Some(row) => *row = *pixels,
        None => row.iter_mut().skip(x).zip(pixels).for_each(|(out, &pixel)| *out = pixel),
    }
}

/// The pixels of three rows of components.
#[inline(always)]
fn pixels(rows: &[[f32; GROUP]; 3]) -> [[f32; 3]; GROUP] {
    std::array::from_fn(|pixel| [rows[0][pixel], rows[1][pixel], rows[2][pixel]])
}

/// Colours after the tone rule; the choice is made outside the loop.
#[inline(always)]
fn toned(tone: ToneRule, [red, green, blue]: [&[f32; GROUP]; 3]) -> [[f32; GROUP]; 3] {
    let mut toned = [[0.0; GROUP]; 3];
    let mut apply = |tone: ToneRule| {
        for pixel in 0..GROUP {
            [toned[0][pixel], toned[1][pixel], toned[2][pixel]] =
                tone.apply([red[pixel], green[pixel], blue[pixel]]);
        }
    };
    match tone {
        ToneRule::Clamp => apply(ToneRule::Clamp),
        ToneRule::DivideByMax => apply(ToneRule::DivideByMax),
    }
    toned
}

/// The 8-bit numbers of colours, red in the lowest byte.
#[inline(always)]
fn codes(transfer: Transfer, rows: &[[f32; GROUP]; 3]) -> [u32; GROUP] {
    let mut codes = [0; GROUP];
    for (component, row) in rows.iter().enumerate() {
        match transfer {
            Transfer::Direct => {
                for pixel in 0..GROUP {
                    codes[pixel] |= u32::from(Transfer::Direct.pixel_u8(row[pixel])) << (8 * component);
                }
            }
            Transfer::Srgb => {
                for pixel in 0..GROUP {
                    codes[pixel] |= u32::from(Transfer::Srgb.pixel_u8(row[pixel])) << (8 * component);
                }
            }
        }
    }
    codes
}
