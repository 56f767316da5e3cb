//! Pictures side by side with captions.

use super::error::ReportError;
use super::label::{draw_text, text_width};
use super::picture::Picture;

/// A picture and what stands below it.
#[derive(Clone, Debug)]
pub struct Panel {
    /// One line of text.
    pub caption: String,
    /// The picture.
    pub picture: Picture,
}

/// Most panels in a row.
const COLUMNS: usize = 4;
/// The sheet and its text, as shares of the full code.
const PAPER: [f32; 3] = [0.13; 3];
const INK: [f32; 3] = [0.93; 3];
/// Text is this share of a panel's height, within limits: below the smaller one letters of the font run together.
const TEXT_SHARE: f32 = 1.0 / 18.0;
const TEXT_RANGE: [f32; 2] = [14.0, 56.0];

/// Puts pictures side by side, in rows of at most four, with a gap between them and a caption below each.
///
/// The text's height follows the pictures', and a caption that is wider than its picture widens the column. The sheet has
/// 16 bits if a picture has.
///
/// # Errors
/// If there is no picture.
pub fn panels(panels: &[Panel]) -> Result<Picture, ReportError> {
    if panels.is_empty() {
        return Err(ReportError::Empty);
    }
    let rows = panels.len().div_ceil(COLUMNS);
    let columns = panels.len().div_ceil(rows);
    let largest = |axis: usize| panels.iter().map(|panel| panel.picture.size[axis]).max().unwrap_or(0);
    let text = (largest(1) as f32 * TEXT_SHARE).clamp(TEXT_RANGE[0], TEXT_RANGE[1]).round();
    let gap = (0.75 * text).round() as u32;
    let widest = panels.iter().map(|panel| text_width(&panel.caption, text).ceil() as u32).max();
    let cell = [largest(0).max(widest.unwrap_or(0)), largest(1) + gap / 2 + text as u32];
    let side = |count: usize, side: u32| gap + count as u32 * (side + gap);
    let is_sixteen = panels.iter().any(|panel| panel.picture.is_sixteen());
    let mut sheet = Picture::filled([side(columns, cell[0]), side(rows, cell[1])], is_sixteen, PAPER);
    for (number, Panel { caption, picture }) in panels.iter().enumerate() {
        let place = [number % columns, number / columns];
        let [left, top] = [0, 1].map(|axis| side(place[axis], cell[axis]));
        let [width, height] = picture.size;
        sheet.paste(picture, [left + (cell[0] - width) / 2, top]);
        let free = cell[0] as f32 - text_width(caption, text);
        let at = [i64::from(left) + (0.5 * free) as i64, i64::from(top + height + gap / 2)];
        draw_text(&mut sheet, caption, at, text, INK);
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
    fn panels_stand_apart_with_captions() {
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
}
