//! Pictures side by side with captions.

use super::error::ReportError;
use super::label::{draw_text, text_width};
use super::picture::Picture;

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
const PAPER: [f32; 3] = [0.13; 3];
const INK: [f32; 3] = [0.93; 3];
/// Text is this share of a panel's height, within limits: below the smaller one letters of the font run together.
const TEXT_SHARE: f32 = 1.0 / 18.0;
const TEXT_RANGE: [f32; 2] = [14.0, 56.0];

/// The largest side of a sheet, as of any picture that is drawn.
const LARGEST: u32 = 16_384;

struct Layout {
    columns: usize,
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
    ) -> Result<Self, ReportError> {
        let count = captions.len();
        if count == 0 {
            return Err(ReportError::Empty);
        }
        let rows = count.div_ceil(COLUMNS);
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
        Ok(Self { columns, text, gap, cell, sheet })
    }

    /// The upper left corner of a cell.
    fn corner(&self, number: usize) -> [u32; 2] {
        let at = |count: usize, axis: usize| self.gap + count as u32 * (self.cell[axis] + self.gap);
        [at(number % self.columns, 0), at(number / self.columns, 1)]
    }
}

/// The size of the sheet that [`panels`] makes of pictures of this size.
///
/// # Errors
/// As [`panels`], without a picture having been drawn.
pub fn panels_size(captions: &[&str], size: [u32; 2]) -> Result<[u32; 2], ReportError> {
    Layout::new(captions.iter().copied(), size).map(|layout| layout.sheet)
}

/// Puts pictures side by side, in rows of at most four, with a gap between them and a caption below each.
///
/// The text's height follows the pictures', and a caption that is wider than its picture widens the column. The sheet has
/// 16 bits if a picture has.
///
/// # Errors
/// If there is no picture, or the sheet would be wider or higher than 16384 pixels.
pub fn panels(panels: &[Panel]) -> Result<Picture, ReportError> {
    let largest = |axis: usize| panels.iter().map(|panel| panel.picture.size[axis]).max().unwrap_or(0);
    let captions = panels.iter().map(|panel| &*panel.caption);
    let layout = Layout::new(captions, [largest(0), largest(1)])?;
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
        let sheet = panels(&[panel("flat", [96, 96], 1.0), panel("Gouraud", [96, 96], 0.0)]).unwrap();
        // Gaps of 11 (0.75 of 14 pixels of text, rounded half up), captions of 14 and half a gap above them.
        assert_eq!(sheet.size, [11 + 2 * (96 + 11), 11 + (96 + 5 + 14) + 11]);
        assert_eq!(columns_of(&sheet, [255; 3]), (11..107).collect::<Vec<_>>());
        assert_eq!(columns_of(&sheet, [0; 3]), (118..214).collect::<Vec<_>>());
        let Pixels::Eight(list) = &sheet.pixels else { panic!("8 bits") };
        let below = &list[(11 + 96) * sheet.size[0] as usize..];
        assert!(below.iter().filter(|pixel| pixel[0] > 150).count() > 50, "there is text");
    }

    #[test]
    fn many_panels_take_rows_and_long_captions_room() {
        let many: Vec<Panel> = (0..5).map(|_| panel("x", [40, 30], 0.5)).collect();
        let sheet = panels(&many).unwrap();
        assert_eq!(sheet.size, [11 + 3 * 51, 11 + 2 * (30 + 5 + 14 + 11)]);
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
}
