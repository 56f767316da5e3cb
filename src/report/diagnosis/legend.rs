//! The legend of a heat map.

use super::markers::{ABSENT, HeatScale};
use super::markers::{LINE, ring};
use crate::num::{LinearRgb, Srgb8, viridis};
use crate::report::panel::{draw_text, text_width};
use crate::report::picture::Picture;

#[derive(Clone, Copy, PartialEq, Eq)]
enum Key {
    Absent,
    Line,
    Dot,
    Ring,
}

/// The marks that are drawn over the colours.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub(super) struct Marks {
    /// Lines along edges with two normals.
    pub(super) lines: bool,
    /// Dots on corners whose faces are too small to be seen.
    pub(super) dots: bool,
    /// Rings round worst positions.
    pub(super) rings: bool,
    /// Some worst positions are not visible, and have no ring.
    pub(super) hidden: bool,
}

impl Marks {
    fn of_rings(self) -> &'static str {
        match (self.rings, self.hidden) {
            (_, false) => "worst position",
            (true, true) => "worst position (others are hidden)",
            (false, true) => "worst position: hidden by other faces",
        }
    }
}

/// A picture with a legend of its colours and marks below it.
pub(super) fn with_legend(picture: &Picture, scale: HeatScale, marks: Marks) -> Picture {
    let [width, height] = picture.size.map(i64::from);
    let (bar, text) = ((height / 40).max(6), (height as f32 / 28.0).max(12.0));
    let (margin, line) = (width / 16, text as i64 + bar / 2);
    let keys = [
        (Key::Absent, "no valid normal", scale.is_absent),
        (Key::Line, "edge with two normals", marks.lines),
        (Key::Dot, "large deviation on a small face", marks.dots),
        (Key::Ring, marks.of_rings(), marks.rings || marks.hidden),
    ];
    // As many in a row as fit.
    let (mut at, mut places) = ([margin, 0], Vec::new());
    for (key, words, _) in keys.into_iter().filter(|(.., is_there)| *is_there) {
        let wide = line + text_width(words, text) as i64 + line;
        if at[0] > margin && at[0] + wide > width - margin / 2 {
            at = [margin, at[1] + line];
        }
        places.push((key, words, at));
        at[0] += wide;
    }
    let scale_height = if scale.is_used { line + 2 * bar } else { 0 };
    let keys_height = if places.is_empty() { 0 } else { at[1] + line };
    let strip = scale_height + keys_height + bar;
    let size = [picture.size[0], picture.size[1] + strip as u32];
    let mut sheet = Picture::filled(size, picture.is_sixteen(), [1.0; 3]);
    sheet.paste(picture, [0, 0]);
    if scale.is_used {
        draw_scale(&mut sheet, scale, [margin, height], (bar, text));
    }
    for (key, words, [x, y]) in places {
        let top = height + scale_height + y;
        swatch(&mut sheet, key, [x, top], text as i64);
        draw_text(&mut sheet, words, [x + line, top], text, INK);
    }
    sheet
}

const INK: [f32; 3] = [0.1; 3];

fn draw_scale(picture: &mut Picture, scale: HeatScale, [left, top]: [i64; 2], (bar, text): (i64, f32)) {
    let width = i64::from(picture.size[0]);
    let (right, below) = (width - left, top + text as i64 + 2);
    for x in left..right {
        let colour = coded(viridis((x - left) as f64 / (right - left - 1) as f64));
        (below..below + bar).for_each(|y| picture.blend([x, y], colour, 1.0));
    }
    let [full, half] = scale.labels();
    let mut free = width;
    // From the right: the middle label is omitted if the one at the end is long.
    for (label, at) in [(&*full, right), ("0°", left), (&half, (left + right) / 2)] {
        let wide = text_width(label, text).ceil() as i64;
        let edge = left / 2;
        let x = (at - wide / 2).clamp(edge, (width - edge - wide).max(edge));
        if x + wide <= free {
            draw_text(picture, label, [x, top], text, INK);
        }
        if at == right {
            free = x - edge;
        }
    }
}

fn swatch(picture: &mut Picture, key: Key, [x, y]: [i64; 2], side: i64) {
    let middle = y + side / 2;
    let rows = match key {
        Key::Absent => y + side / 6..y + side - side / 6,
        Key::Dot => {
            let (width, colour) = ((side / 4).max(2), coded(viridis(1.0)));
            let [left, top] = [x + (side - width) / 2, middle - width / 2];
            (top..top + width)
                .for_each(|y| (left..left + width).for_each(|x| picture.blend([x, y], colour, 1.0)));
            return;
        }
        Key::Line => middle - 1..middle + 1,
        Key::Ring => {
            let at = [x + side / 2, middle].map(|it| it as f64);
            return ring(picture, at, side as f64 / 3.0);
        }
    };
    let colour =
        if key == Key::Absent { coded(LinearRgb::from(ABSENT)) } else { coded(LinearRgb::grey(LINE)) };
    rows.for_each(|y| (x..x + side).for_each(|x| picture.blend([x, y], colour, 1.0)));
}

/// A colour as shares of the full code.
fn coded(colour: LinearRgb) -> [f32; 3] {
    Srgb8::from(colour).0.map(|c| f32::from(c) / 255.0)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::quality::Survey;

    /// The longest label, in pictures of few pixels and many, ends before the picture does, and lies on no other.
    #[test]
    fn labels_stay_inside() {
        let deviations: Vec<Option<f64>> =
            [vec![0.0; 400], vec![123.4]].concat().into_iter().map(Some).collect();
        let scale = HeatScale::of([Survey { deviations, ..Survey::default() }].iter());
        assert_eq!(scale.labels()[0], "1° and more, up to 123°");
        for side in [240, 320, 480, 1024] {
            let sheet = with_legend(&Picture::filled([side; 2], false, [1.0; 3]), scale, Marks::default());
            let crate::raster::Pixels::Eight(pixels) = &sheet.pixels else { panic!("8 bits") };
            let at = |i: usize| i % side as usize;
            let ink = (0..pixels.len()).filter(|&i| pixels[i] != [255; 3]).map(at);
            let margin = side as usize / 32;
            assert!(ink.clone().min() >= Some(margin - 2), "{side}");
            assert!(ink.max() <= Some(side as usize - margin + 1), "{side}");
        }
    }

    #[test]
    fn legends_stand_below_the_picture_and_have_what_there_is() {
        let picture = Picture::filled([320, 320], false, [0.0; 3]);
        let scale =
            |deviations: Vec<Option<f64>>| HeatScale::of([Survey { deviations, ..Survey::default() }].iter());
        let height = |marks| with_legend(&picture, scale(vec![Some(1.0)]), marks).size[1];
        let plain = height(Marks::default());
        let all = Marks { lines: true, dots: true, rings: true, hidden: true };
        assert!(plain > 320 && height(all) > plain);
        let none = Marks::default();
        for one in [
            Marks { lines: true, ..none },
            Marks { dots: true, ..none },
            Marks { rings: true, ..none },
            Marks { hidden: true, ..none },
        ] {
            assert!(height(one) > plain, "{one:?}");
        }
        let sheet = with_legend(&picture, scale(vec![Some(1.0), None]), all);
        let crate::raster::Pixels::Eight(pixels) = &sheet.pixels else { panic!("8 bits") };
        assert!(pixels[..320 * 320].iter().all(|pixel| *pixel == [0; 3]), "nothing lies on the picture");
        for colour in [ABSENT.0, Srgb8::from(LinearRgb::grey(LINE)).0, Srgb8::from(viridis(1.0)).0] {
            assert!(pixels[320 * 320..].contains(&colour), "{colour:?}");
        }
    }
}
