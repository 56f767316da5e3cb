//! A plot as a picture of pixels, for sheets of pictures.

use super::axis::Fitted;
use super::draw::kept;
use super::series::{Mark, Plot, Series, SeriesStyle, series_styles};
use crate::report::panel::{draw_text, text_width};
use crate::report::picture::Picture;

const PAPER: [f32; 3] = [1.0; 3];
const INK: [f32; 3] = [0.2; 3];
const GRID: [f32; 3] = [0.87; 3];
/// The height of text as a share of the picture's, and the least: below it letters of the font run together.
const TEXT_SHARE: f32 = 1.0 / 24.0;
const LEAST_TEXT: f32 = 12.0;

/// The field of a plot in pixels.
struct Field {
    left: f64,
    top: f64,
    width: f64,
    height: f64,
    axes: [Fitted; 2],
}

impl Field {
    fn place(&self, [x, y]: [f64; 2]) -> [f64; 2] {
        let [along, up] = [self.axes[0].share(x), self.axes[1].share(y)];
        [self.left + along * self.width, self.top + (1.0 - up) * self.height]
    }
}

impl Plot {
    /// The plot as a picture: axes with their labels, curves as lines, other points as dots, and the names of series at the bottom.
    pub fn picture(&self, size: [u32; 2]) -> Picture {
        let mut picture = Picture::filled(size, false, PAPER);
        let [width, height] = size.map(f64::from);
        let text = (height as f32 * TEXT_SHARE).max(LEAST_TEXT).round();
        let (line, gap) = (f64::from(text) * 1.25, f64::from(text) * 0.5);
        let axes = self.fitted();
        let labels = axes[1].ticks();
        let widest = labels.iter().map(|(_, label)| f64::from(text_width(label, text))).fold(0.0, f64::max);
        let styles = series_styles(&self.series);
        let named: Vec<_> = self.series.iter().zip(&styles).filter(|(it, _)| !it.name.is_empty()).collect();
        let wide = |name: &str| f64::from(text_width(name, text)) + 3.0 * line;
        let (mut rows, mut at) = (Vec::new(), [gap, 0.0]);
        for (series, style) in named {
            if at[0] > gap && at[0] + wide(&series.name) > width {
                at = [gap, at[1] + line];
            }
            rows.push((series, style, at));
            at[0] += wide(&series.name);
        }
        let (left, top) = (gap + widest + gap, gap + line + gap);
        // Ticks, the label of the axis and the names are below the field.
        let below = 2.0 * line + gap + at[1] + line + gap;
        let field = Field { left, top, width: width - left - 2.0 * gap, height: height - top - below, axes };
        let write = |picture: &mut Picture, words: &str, [x, y]: [f64; 2]| {
            draw_text(picture, &without_subscripts(words), [x as i64, y as i64], text, INK);
        };
        let [right, bottom] = [field.left + field.width, field.top + field.height];
        let mut taken = 0.0;
        for (at, label) in field.axes[0].ticks() {
            let [x, _] = field.place([at, 1.0]);
            segment(&mut picture, [[x, top], [x, bottom]], 1.0, GRID);
            let label = self.written(label);
            let wide = f64::from(text_width(&label, text));
            if x - 0.5 * wide >= taken && x + 0.5 * wide <= width {
                write(&mut picture, &label, [x - 0.5 * wide, bottom + 0.5 * gap]);
                taken = x + 0.5 * wide + gap;
            }
        }
        for (at, label) in labels {
            let [_, y] = field.place([1.0, at]);
            segment(&mut picture, [[left, y], [right, y]], 1.0, GRID);
            let label = self.written(label);
            let wide = f64::from(text_width(&label, text));
            write(&mut picture, &label, [left - 0.5 * gap - wide, y - 0.55 * f64::from(text)]);
        }
        segment(&mut picture, [[left, top], [left, bottom]], 1.0, INK);
        segment(&mut picture, [[left, bottom], [right, bottom]], 1.0, INK);
        write(&mut picture, &self.y.label, [gap, 0.5 * gap]);
        write(&mut picture, &self.x.label, [left, bottom + 0.5 * gap + line]);
        let stroke = (height / 220.0).max(1.6);
        let draw = |picture: &mut Picture, style: &SeriesStyle, places: &[[f64; 2]], are_dots: bool| {
            let colour = shares(style.colour);
            if are_dots {
                places.iter().for_each(|&at| segment(picture, [at, at], 3.0 * stroke, colour));
            } else {
                places.windows(2).for_each(|ends| segment(picture, [ends[0], ends[1]], stroke, colour));
            }
        };
        let are_dots = |series: &Series| matches!(series.mark, Mark::Points | Mark::Hollow);
        for (series, style) in self.series.iter().zip(&styles) {
            let places: Vec<[f64; 2]> = kept(self, series).map(|point| field.place(point)).collect();
            draw(&mut picture, style, &places, are_dots(series));
        }
        for (series, style, [x, y]) in rows {
            let y = bottom + 0.5 * gap + 2.0 * line + gap + y;
            let middle = y + 0.55 * f64::from(text);
            let sample = [[x, middle], [x + 0.5 * line, middle], [x + line, middle]];
            let places = if are_dots(series) { &sample[1..2] } else { &sample };
            draw(&mut picture, style, places, are_dots(series));
            write(&mut picture, &series.name, [x + line + gap, y]);
        }
        picture
    }
}

/// Words with plain digits for subscripts, which the font lacks.
fn without_subscripts(words: &str) -> String {
    let plain = |c: char| match c {
        '₀'..='₉' => char::from(b'0' + (c as u32 - '₀' as u32) as u8),
        c => c,
    };
    words.chars().map(plain).collect()
}

/// A colour in the notation of SVG as shares of the full code.
fn shares(colour: &str) -> [f32; 3] {
    let code = u32::from_str_radix(colour.trim_start_matches('#'), 16).unwrap_or(0);
    [16, 8, 0].map(|shift| (code >> shift & 0xff) as f32 / 255.0)
}

/// A straight line with round ends; a dot if both ends are the same.
fn segment(picture: &mut Picture, [[x0, y0], [x1, y1]]: [[f64; 2]; 2], width: f64, colour: [f32; 3]) {
    let (dx, dy) = (x1 - x0, y1 - y0);
    let squared = dx * dx + dy * dy;
    let reach = 0.5 * width + 1.0;
    let range = |a: f64, b: f64| (a.min(b) - reach).floor() as i64..=(a.max(b) + reach).ceil() as i64;
    for y in range(y0, y1) {
        for x in range(x0, x1) {
            let (px, py) = (x as f64 + 0.5 - x0, y as f64 + 0.5 - y0);
            let along = if squared > 0.0 { ((px * dx + py * dy) / squared).clamp(0.0, 1.0) } else { 0.0 };
            let distance = libm::hypot(px - along * dx, py - along * dy);
            picture.blend([x, y], colour, (0.5 * width + 0.5 - distance).clamp(0.0, 1.0) as f32);
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::raster::Pixels;
    use crate::report::plot::{Axis, Series};

    /// The curve falls from the upper left to the lower right of the field, and text is around it.
    #[test]
    fn a_curve_is_where_its_points_are() {
        let falling = Series::new(
            "falling",
            (0..=20).map(|k| [f64::from(k), 20.0 - f64::from(k)]).collect(),
            Mark::Curve,
        );
        let plot =
            Plot { x: Axis::linear("x"), y: Axis::linear("y"), series: vec![falling], ..Plot::default() };
        let picture = plot.picture([320, 240]);
        let Pixels::Eight(pixels) = &picture.pixels else { panic!("8 bits") };
        // The first colour of series, and not the legend.
        let blue = |index: &usize| pixels[*index] == [0x00, 0x72, 0xb2] && index / 320 < 180;
        let columns: Vec<(usize, usize)> =
            (0..pixels.len()).filter(blue).map(|index| (index % 320, index / 320)).collect();
        let (first, last) = (columns.iter().min().unwrap(), columns.iter().max().unwrap());
        assert!(last.0 - first.0 > 200 && last.1 > first.1 + 100, "{first:?} {last:?}");
        assert!(pixels.iter().filter(|pixel| pixel[0] < 90).count() > 300, "text and axes");
    }
}
