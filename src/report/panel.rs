//! Text in pictures, and pictures side by side with captions.

use super::error::{ReportError, Result};
use super::picture::Picture;
use ab_glyph::{Font, FontRef, GlyphId, PxScale, ScaleFont, point};
use std::sync::LazyLock;

static FONT: LazyLock<FontRef<'static>> = LazyLock::new(|| {
    let font = FontRef::try_from_slice(include_bytes!("font/DejaVuSans-subset.ttf"));
    font.expect("the font that the crate carries can be read")
});

/// The replacement of characters that the font lacks.
const REPLACEMENT: char = '?';

/// The width of a line of text in pixels, at a height from the top of the tallest to the bottom of the lowest letter.
pub fn text_width(text: &str, height: f32) -> f32 {
    let font = FONT.as_scaled(PxScale::from(height));
    text.chars().map(|c| font.h_advance(glyph(c))).sum()
}

/// Draws a line of text, its upper left corner at `at`, in a colour given as shares of the full code.
///
/// Edges are anti-aliased by mixing codes. Characters that the font lacks become question marks: it has ASCII, accented
/// letters of Portuguese, and a few signs such as ° · × µ → θ.
pub fn draw_text(picture: &mut Picture, text: &str, at: [i64; 2], height: f32, colour: [f32; 3]) {
    let scale = PxScale::from(height);
    let font = FONT.as_scaled(scale);
    // Whole pixels: the strokes of all letters then have the same sharpness.
    let baseline = font.ascent().round();
    let mut x = 0.0;
    for c in text.chars() {
        let id = glyph(c);
        let placed = id.with_scale_and_position(scale, point(x, baseline));
        if let Some(outline) = FONT.outline_glyph(placed) {
            let bounds = outline.px_bounds();
            let corner = [at[0] + bounds.min.x as i64, at[1] + bounds.min.y as i64];
            outline.draw(|x, y, share| {
                let pixel = [corner[0] + i64::from(x), corner[1] + i64::from(y)];
                picture.blend(pixel, colour, share.min(1.0));
            });
        }
        x += font.h_advance(id);
    }
}

/// Whether the font has all letters of a text.
#[cfg(test)]
pub(super) fn has_letters(text: &str) -> bool {
    text.chars().all(|c| FONT.glyph_id(c) != GlyphId(0))
}

fn glyph(c: char) -> GlyphId {
    match FONT.glyph_id(c) {
        GlyphId(0) => FONT.glyph_id(REPLACEMENT),
        id => id,
    }
}

/// A picture and its caption.
#[derive(Clone, Debug)]
pub struct Panel {
    /// One line of text.
    pub caption: String,
    /// The picture.
    pub picture: Picture,
}

const COLUMNS: usize = 4;
/// The sheet and its text, as shares of the full code.
const PAPER: [f32; 3] = [1.0; 3];
const INK: [f32; 3] = [0.1; 3];
/// Text is this share of a panel's height, within limits: below the smaller one letters of the font run together.
const TEXT_SHARE: f32 = 1.0 / 18.0;
const TEXT_RANGE: [f32; 2] = [14.0, 56.0];

/// The largest side of a sheet, as of any picture that is drawn.
const LARGEST: u32 = 16_384;

struct Layout {
    columns: usize,
    /// How many panels there are.
    count: usize,
    /// Height of the text.
    text: f32,
    gap: u32,
    /// A picture with its caption.
    cell: [u32; 2],
    sheet: [u32; 2],
}

impl Layout {
    /// Of panels whose largest sides are these.
    fn new<'a>(
        captions: impl ExactSizeIterator<Item = &'a str>,
        largest: [u32; 2],
        most_columns: usize,
    ) -> Result<Self> {
        let count = captions.len();
        if count == 0 {
            return Err(ReportError::Empty);
        }
        let rows = count.div_ceil(most_columns);
        let columns = count.div_ceil(rows);
        let text = (largest[1] as f32 * TEXT_SHARE).clamp(TEXT_RANGE[0], TEXT_RANGE[1]).round();
        let gap = (0.75 * text).round() as u32;
        let widest = captions.map(|caption| text_width(caption, text).ceil() as u32).max();
        let cell = [largest[0].max(widest.unwrap_or(0)), largest[1].saturating_add(gap / 2 + text as u32)];
        let side = |count: usize, side: u32| {
            let all = u64::from(gap) + count as u64 * (u64::from(side) + u64::from(gap));
            u32::try_from(all).unwrap_or(u32::MAX)
        };
        let sheet @ [width, height] = [side(columns, cell[0]), side(rows, cell[1])];
        if width.max(height) > LARGEST {
            let format = "panel";
            return Err(ReportError::Size { format, largest: LARGEST, width, height });
        }
        Ok(Self { columns, count, text, gap, cell, sheet })
    }

    /// The upper left corner of a cell. A last row with fewer cells is in the middle.
    fn corner(&self, number: usize) -> [u32; 2] {
        let row = number / self.columns;
        let free = self.columns - (self.count - row * self.columns).min(self.columns);
        let at = |count: usize, axis: usize| self.gap + count as u32 * (self.cell[axis] + self.gap);
        let aside = free as u32 * (self.cell[0] + self.gap) / 2;
        [at(number % self.columns, 0) + aside, at(row, 1)]
    }
}

/// The size of the sheet that [`panels`] makes of pictures of this size.
///
/// # Errors
/// As [`panels`], without a picture having been drawn.
pub fn panels_size(captions: &[&str], size: [u32; 2]) -> Result<[u32; 2]> {
    Layout::new(captions.iter().copied(), size, COLUMNS).map(|layout| layout.sheet)
}

/// Puts pictures side by side, in rows of at most four, with a gap between them and a caption below each.
///
/// The text's height follows the pictures', and a caption that is wider than its picture widens the column. The sheet has
/// 16 bits if a picture has.
///
/// # Errors
/// If there is no picture, or the sheet would be wider or higher than 16384 pixels.
pub fn panels(panels: &[Panel]) -> Result<Picture> {
    panels_in(panels, COLUMNS)
}

/// As [`panels`], in rows of at most so many.
pub(super) fn panels_in(panels: &[Panel], most_columns: usize) -> Result<Picture> {
    let largest = |axis: usize| panels.iter().map(|panel| panel.picture.size[axis]).max().unwrap_or(0);
    let captions = panels.iter().map(|panel| &*panel.caption);
    let layout = Layout::new(captions, [largest(0), largest(1)], most_columns)?;
    let is_sixteen = panels.iter().any(|panel| panel.picture.is_sixteen());
    let mut sheet = Picture::filled(layout.sheet, is_sixteen, PAPER);
    for (number, Panel { caption, picture }) in panels.iter().enumerate() {
        let [left, top] = layout.corner(number);
        let [width, height] = picture.size;
        sheet.paste(picture, [left + (layout.cell[0] - width) / 2, top]);
        let free = layout.cell[0] as f32 - text_width(caption, layout.text);
        let at = [i64::from(left) + (0.5 * free) as i64, i64::from(top + height + layout.gap / 2)];
        draw_text(&mut sheet, caption, at, layout.text, INK);
    }
    Ok(sheet)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::raster::Pixels;

    fn panel(caption: &str, size: [u32; 2], share: f32) -> Panel {
        Panel { caption: caption.into(), picture: Picture::filled(size, false, [share; 3]) }
    }

    /// Whether a colour is anywhere in a picture, and in which columns.
    fn columns_of(picture: &Picture, colour: [u8; 3]) -> Vec<usize> {
        let Pixels::Eight(list) = &picture.pixels else { panic!("8 bits") };
        let mut columns: Vec<usize> =
            (0..list.len()).filter(|&i| list[i] == colour).map(|i| i % picture.size[0] as usize).collect();
        columns.sort_unstable();
        columns.dedup();
        columns
    }

    #[test]
    fn panels_are_separate_with_captions() {
        let sheet = panels(&[panel("flat", [96, 96], 0.5), panel("Gouraud", [96, 96], 0.0)]).unwrap();
        // Gaps of 11 (0.75 of 14 pixels of text, rounded half up), captions of 14 and half a gap above them.
        assert_eq!(sheet.size, [11 + 2 * (96 + 11), 11 + (96 + 5 + 14) + 11]);
        assert_eq!(columns_of(&sheet, [128; 3]), (11..107).collect::<Vec<_>>());
        assert_eq!(columns_of(&sheet, [0; 3]), (118..214).collect::<Vec<_>>());
        let Pixels::Eight(list) = &sheet.pixels else { panic!("8 bits") };
        let below = &list[(11 + 96) * sheet.size[0] as usize..];
        assert!(below.iter().filter(|pixel| pixel[0] < 100).count() > 50, "there is text");
    }

    #[test]
    fn many_panels_take_rows_and_long_captions_room() {
        let many: Vec<Panel> = (0..5).map(|_| panel("x", [40, 30], 0.5)).collect();
        let sheet = panels(&many).unwrap();
        assert_eq!(sheet.size, [11 + 3 * 51, 11 + 2 * (30 + 5 + 14 + 11)]);
        // Three, and two in the middle below them.
        let Pixels::Eight(list) = &sheet.pixels else { panic!("8 bits") };
        let columns = |top: usize| -> Vec<usize> {
            let row = &list[top * sheet.size[0] as usize..][..sheet.size[0] as usize];
            (0..row.len()).filter(|&x| row[x] == [128; 3] && (x == 0 || row[x - 1] != [128; 3])).collect()
        };
        assert_eq!([columns(11), columns(11 + 60)], [vec![11, 62, 113], vec![36, 87]]);
        let long = panel("a caption much wider than its picture", [20, 20], 1.0);
        assert!(panels(&[long]).unwrap().size[0] > 200);
        assert!(matches!(panels(&[]), Err(ReportError::Empty)));
    }

    #[test]
    fn a_sheet_is_no_larger_than_any_picture() {
        let [width, height] = panels_size(&["flat", "phong"], [640, 480]).unwrap();
        let sheet = panels(&[panel("flat", [640, 480], 0.5), panel("phong", [640, 480], 0.5)]).unwrap();
        assert_eq!(sheet.size, [width, height]);
        for size in [[8192, 16], [16, 16_384], [u32::MAX, u32::MAX]] {
            let error = panels_size(&["flat", "phong"], size).unwrap_err().to_string();
            assert!(error.contains("1 to 16384"), "{error}");
        }
    }

    fn drawn(text: &str, height: f32) -> Picture {
        let width = text_width(text, height).ceil() as u32;
        let mut picture = Picture::filled([width, height as u32 + 1], false, [0.0; 3]);
        draw_text(&mut picture, text, [0, 0], height, [1.0; 3]);
        picture
    }

    fn rows(picture: &Picture) -> Vec<String> {
        let Pixels::Eight(list) = &picture.pixels else { panic!("8 bits") };
        let row = |row: &[[u8; 3]]| row.iter().map(|p| if p[0] > 127 { '#' } else { '.' }).collect();
        list.chunks(picture.size[0] as usize).map(row).collect()
    }

    #[test]
    fn letters_have_their_shapes() {
        let rows = rows(&drawn("L", 24.0));
        let dark = |row: &&String| row.contains('#');
        let shape: Vec<&String> = rows.iter().filter(dark).collect();
        assert!(shape.len() >= 14, "an L of 24 pixels is as high as a capital letter: {rows:#?}");
        let width = |row: &str| row.matches('#').count();
        let (foot, stem) = (width(shape[shape.len() - 1]), width(shape[1]));
        assert!(foot >= 3 * stem && stem >= 1, "{rows:#?}");
    }

    #[test]
    fn text_stays_within_its_width_and_height() {
        let (text, height) = ("Gouraud, 40° × gjpq", 16.0);
        let width = text_width(text, height);
        let mut picture = Picture::filled([width as u32 + 40, 56], false, [0.0; 3]);
        draw_text(&mut picture, text, [20, 20], height, [1.0; 3]);
        let Pixels::Eight(list) = &picture.pixels else { panic!("8 bits") };
        let lit = |i: &usize| list[*i] != [0; 3];
        let places =
            (0..list.len()).filter(lit).map(|i| (i % picture.size[0] as usize, i / picture.size[0] as usize));
        let (columns, lines): (Vec<usize>, Vec<usize>) = places.unzip();
        // One pixel of anti-aliasing and side bearing around.
        assert!(
            *columns.iter().min().unwrap() >= 19 && *columns.iter().max().unwrap() <= 21 + width as usize
        );
        assert!(*lines.iter().min().unwrap() >= 19 && *lines.iter().max().unwrap() <= 37);
    }

    #[test]
    fn every_promised_character_is_there() {
        for c in (' '..='~').chain("áàâãçéêíóôõúÁÉÇ°·×µ→θαφσπ–".chars()) {
            assert_ne!(FONT.glyph_id(c), GlyphId(0), "{c}");
        }
        assert_eq!(drawn("\u{4e2d}", 20.0), drawn("?", 20.0));
    }

    #[test]
    fn text_outside_the_picture_is_left_out() {
        let mut picture = Picture::filled([4, 4], false, [0.0; 3]);
        draw_text(&mut picture, "much too long", [-30, -6], 16.0, [1.0; 3]);
        draw_text(&mut picture, "below", [0, 4000], 16.0, [1.0; 3]);
    }
}
