//! A legend below a picture: titles, scales of colours, and keys of marks.

use super::panel::{draw_text, text_width};
use super::picture::Picture;

/// A sample of what a picture shows, in front of its words. Colours are shares of the full code.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Key {
    /// A surface of this colour.
    Area([f32; 3]),
    /// A line of this colour.
    Line([f32; 3]),
    /// A dot of this colour.
    Dot([f32; 3]),
    /// A red ring.
    Ring,
}

/// Colours of a quantity, from its lowest to its highest value.
#[derive(Clone, Debug, PartialEq)]
pub struct ColourScale {
    /// The colours at equal distances, as shares of the full code: two or more.
    pub colours: Vec<[f32; 3]>,
    /// Labels, each with its share of the scale. If two would overlap, the later one is omitted.
    pub labels: Vec<(f64, String)>,
}

/// The legend of a picture.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Legend {
    /// The quantity and its unit; several lines if it is long.
    pub title: String,
    /// Scales, one below the other.
    pub scales: Vec<ColourScale>,
    /// Keys, as many in a row as fit.
    pub keys: Vec<(Key, String)>,
}

const INK: [f32; 3] = [0.1; 3];
const PAPER: [f32; 3] = [1.0; 3];

/// The measures of a legend, in pixels.
struct Layout {
    width: i64,
    margin: i64,
    /// The height of a scale, and of letters.
    bar: i64,
    text: f32,
    /// From one line of text to the next.
    line: i64,
}

impl Layout {
    fn of(size: [u32; 2]) -> Self {
        let side = i64::from(size[0].min(size[1]));
        let (bar, text) = ((side / 40).max(6), (side as f32 / 28.0).max(12.0));
        Self {
            width: i64::from(size[0]),
            margin: i64::from(size[0]) / 16,
            bar,
            text,
            line: text as i64 + bar / 2,
        }
    }

    fn lines(&self, words: &str) -> Vec<String> {
        let room = (self.width - 2 * self.margin) as f32;
        let mut lines: Vec<String> = Vec::new();
        for word in words.split_whitespace() {
            match lines.last_mut() {
                Some(line) if text_width(&format!("{line} {word}"), self.text) <= room => {
                    line.push(' ');
                    line.push_str(word);
                }
                _ => lines.push(word.to_owned()),
            }
        }
        lines
    }

    /// The positions of keys, and the height of their rows.
    fn places(&self, keys: &[(Key, String)]) -> (Vec<[i64; 2]>, i64) {
        let (mut at, mut places) = ([self.margin, 0], Vec::new());
        for (_, words) in keys {
            let wide = self.line + text_width(words, self.text) as i64 + self.line;
            if at[0] > self.margin && at[0] + wide > self.width - self.margin / 2 {
                at = [self.margin, at[1] + self.line];
            }
            places.push(at);
            at[0] += wide;
        }
        (places, if keys.is_empty() { 0 } else { at[1] + self.line })
    }
}

impl Legend {
    /// The picture with the legend below it, on white: as wide, and higher.
    pub fn below(&self, picture: &Picture) -> Picture {
        let layout = Layout::of(picture.size);
        let title = layout.lines(&self.title);
        let (places, keys) = layout.places(&self.keys);
        let scale = layout.line + 2 * layout.bar;
        let strip = title.len() as i64 * layout.line + self.scales.len() as i64 * scale + keys + layout.bar;
        let size = [picture.size[0], picture.size[1] + strip as u32];
        let mut sheet = Picture::filled(size, picture.is_sixteen(), PAPER);
        sheet.paste(picture, [0, 0]);
        let mut top = i64::from(picture.size[1]) + layout.bar / 2;
        for words in title {
            draw_text(&mut sheet, &words, [layout.margin, top], layout.text, INK);
            top += layout.line;
        }
        for colours in &self.scales {
            draw_scale(&mut sheet, colours, top, &layout);
            top += scale;
        }
        for ((key, words), [x, y]) in self.keys.iter().zip(places) {
            swatch(&mut sheet, *key, [x, top + y], layout.text as i64);
            draw_text(&mut sheet, words, [x + layout.line, top + y], layout.text, INK);
        }
        sheet
    }
}

fn draw_scale(picture: &mut Picture, scale: &ColourScale, top: i64, layout: &Layout) {
    let &Layout { width, margin: left, bar, text, .. } = layout;
    let (right, below) = (width - left, top + text as i64 + 2);
    for x in left..right {
        let place = (x - left) as f32 / (right - left - 1).max(1) as f32 * (scale.colours.len() - 1) as f32;
        let index = (place as usize).min(scale.colours.len().saturating_sub(2));
        let (low, high) = (scale.colours[index], scale.colours[index + 1]);
        let share = place - index as f32;
        let colour = std::array::from_fn(|k| low[k] + (high[k] - low[k]) * share);
        (below..below + bar).for_each(|y| picture.blend([x, y], colour, 1.0));
    }
    let mut taken: Vec<[i64; 2]> = Vec::new();
    for (share, label) in &scale.labels {
        let wide = text_width(label, text).ceil() as i64;
        let edge = left / 2;
        let at = left + (share * (right - left) as f64) as i64;
        let x = (at - wide / 2).clamp(edge, (width - edge - wide).max(edge));
        if taken.iter().all(|&[from, to]| x + wide + edge <= from || x >= to + edge) {
            draw_text(picture, label, [x, top], text, INK);
            taken.push([x, x + wide]);
        }
    }
}

fn swatch(picture: &mut Picture, key: Key, [x, y]: [i64; 2], side: i64) {
    let middle = y + side / 2;
    let (colour, columns, rows) = match key {
        Key::Area(colour) => (colour, x..x + side, y + side / 6..y + side - side / 6),
        Key::Line(colour) => (colour, x..x + side, middle - 1..middle + 1),
        Key::Dot(colour) => {
            let width = (side / 4).max(2);
            let left = x + (side - width) / 2;
            (colour, left..left + width, middle - width / 2..middle - width / 2 + width)
        }
        Key::Ring => {
            let at = [x + side / 2, middle].map(|it| it as f64);
            return ring(picture, at, side as f64 / 3.0);
        }
    };
    rows.for_each(|y| columns.clone().for_each(|x| picture.blend([x, y], colour, 1.0)));
}

/// Draws a red ring around a point of a picture.
pub(super) fn ring(picture: &mut Picture, [x, y]: [f64; 2], radius: f64) {
    let reach = radius as i64 + 3;
    for dy in -reach..=reach {
        for dx in -reach..=reach {
            let [px, py] = [x as i64 + dx, y as i64 + dy];
            let distance = libm::hypot(px as f64 + 0.5 - x, py as f64 + 0.5 - y);
            let share = (1.5 - (distance - radius).abs()).clamp(0.0, 1.0);
            picture.blend([px, py], [0.9, 0.1, 0.1], share as f32);
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::raster::Pixels;

    fn pixels(picture: &Picture) -> &[[u8; 3]] {
        let Pixels::Eight(pixels) = &picture.pixels else { panic!("8 bits") };
        pixels
    }

    /// Nothing lies on the picture, every colour is there, and no label leaves the sheet.
    #[test]
    fn a_legend_is_below_its_picture_and_whole() {
        let label = |share: f64, words: &str| (share, words.to_owned());
        let scale = ColourScale {
            colours: vec![[0.0, 0.0, 1.0], [1.0, 1.0, 0.0]],
            labels: vec![
                label(1.0, "180° and more"),
                label(0.0, "0°"),
                label(0.5, "a middle label that is much too long"),
            ],
        };
        let keys =
            [Key::Area([1.0, 0.0, 0.0]), Key::Line([0.0, 1.0, 0.0]), Key::Dot([0.0, 1.0, 1.0]), Key::Ring];
        let legend = Legend {
            title: "angle between the stored normal and the expected one, in degrees".into(),
            scales: vec![scale],
            keys: keys.map(|key| (key, "inverted-normals".to_owned())).to_vec(),
        };
        for side in [160, 320, 1024] {
            let sheet = legend.below(&Picture::filled([side; 2], false, [0.0; 3]));
            let (above, below) = pixels(&sheet).split_at((side * side) as usize);
            assert!(above.iter().all(|pixel| *pixel == [0; 3]), "{side}");
            for colour in [[255, 0, 0], [0, 255, 0], [0, 255, 255], [0, 0, 255], [255, 255, 0]] {
                assert!(below.contains(&colour), "{side}: {colour:?}");
            }
            let is_free = |column: u32| {
                below.iter().skip(column as usize).step_by(side as usize).all(|p| *p == [255; 3])
            };
            assert!(is_free(0) && is_free(side - 1), "{side}");
        }
        let plain = Legend::default().below(&Picture::filled([64; 2], true, [0.0; 3]));
        assert!(plain.is_sixteen() && plain.size == [64, 70]);
    }
}
