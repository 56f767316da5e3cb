//! The colours of a heat map, its lines and marks, and the legend that explains them.

use super::pictures::ring;
use crate::num::viridis;
use crate::num::{Degrees, LinearRgb, Srgb8, three_digits};
use crate::quality::Survey;
use crate::raster::{LinePath, LineStyle, Lines, Scene};
use crate::report::label::{draw_text, text_width};
use crate::report::{Overlay, Picture, overlay};
use glam::DVec3;

/// The colour of corners without a stored normal that has a direction: none of the scale's.
pub(super) const ABSENT: Srgb8 = Srgb8([240, 80, 200]);

/// The brightness of lines along edges: darker than all colours but those of right normals, lighter than these.
const LINE: f64 = 0.3;

/// The share of a picture that lines may cover; where there are more, those of short edges are left out.
const MOST_INK: f64 = 0.1;

/// Pixels below which an edge is short: lines a pixel wide would cover a good part of the faces between them.
const SHORT: f64 = 8.0;

/// Which deviation has the light end of the colours.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct HeatScale {
    pub(super) full: Degrees,
    /// The largest deviation, if it is above that.
    beyond: Option<Degrees>,
    /// Some corners have a deviation.
    pub(super) is_used: bool,
    /// Some corners have none.
    is_absent: bool,
}

impl HeatScale {
    /// Round angles that scales end at. Below the first, a picture shows nothing of it.
    const ENDS: [f64; 11] = [1.0, 2.0, 5.0, 10.0, 15.0, 20.0, 30.0, 45.0, 60.0, 90.0, 180.0];

    /// The first round angle that no more than one deviation in two hundred is above: single faults do not make all others
    /// look alike.
    pub(super) fn of<'a>(surveys: impl Iterator<Item = &'a Survey>) -> Self {
        let corners: Vec<Option<f64>> = surveys.flat_map(|survey| &survey.deviations).copied().collect();
        let mut all: Vec<f64> = corners.iter().copied().flatten().collect();
        all.sort_unstable_by(f64::total_cmp);
        let nearly_all = all.iter().rev().nth(all.len() / 200).copied().unwrap_or_default();
        let full = Self::ENDS.into_iter().find(|&end| end >= nearly_all).unwrap_or(180.0);
        // What is told is told in three digits: 90.0004° is no more than 90°.
        let is_beyond = |largest: &&f64| **largest > full && three_digits(**largest) != three_digits(full);
        Self {
            full: Degrees(full),
            beyond: all.last().filter(is_beyond).map(|&largest| Degrees(largest)),
            is_used: !all.is_empty(),
            is_absent: all.len() < corners.len(),
        }
    }

    /// The colour of a deviation.
    pub(super) fn colour(self, deviation: Option<f64>) -> LinearRgb {
        deviation.map_or(LinearRgb::from(ABSENT), |degrees| viridis(degrees / self.full.0))
    }

    /// What stands at the light end, and in the middle.
    fn labels(self) -> [String; 2] {
        let more = |it: Degrees| format!(" and more, up to {}°", three_digits(it.0));
        [
            format!("{}°{}", self.full.0, self.beyond.map_or(String::new(), more)),
            format!("{}°", self.full.0 / 2.0),
        ]
    }

    /// The same for those who do not see it.
    pub(super) fn words(self) -> String {
        let scale = format!("from violet, 0°, to yellow, {}", self.labels()[0]);
        match (self.is_used, self.is_absent) {
            (true, true) => format!("{scale}; pink where no normal is stored that has a direction"),
            (false, true) => "pink all over: no normal is stored that has a direction".into(),
            _ => scale,
        }
    }
}

/// Lines that show the form of what has its colours from elsewhere: its creases. Where they would hide the colours, as those
/// of a fine mesh that is flat all over, those along short edges are left out.
pub(super) fn form(scene: &Scene<'_>, side: u32) -> Vec<Lines> {
    let mut lines = overlay(scene, [side; 2], Overlay::Creases);
    for Lines { style, .. } in &mut lines {
        // Thinner than where they are what is shown.
        *style = LineStyle { colour: LinearRgb::grey(LINE), width: 0.5 * style.width, ..*style };
    }
    let length = |[a, b]: [DVec3; 2]| {
        let at = |point| scene.camera.on_picture([side; 2], point).ok().flatten();
        at(a).zip(at(b)).map_or(0.0, |(a, b)| libm::hypot(a[0] - b[0], a[1] - b[1]))
    };
    let lengths = |lines: &Lines| -> Vec<f64> {
        match &lines.path {
            LinePath::Edges { object, edges } => {
                let object = &scene.objects[*object];
                let place = |vertex| object.transform.transform_point3(object.shape.point(vertex));
                edges.iter().map(|edge| length(edge.map(place))).collect()
            }
            LinePath::Points { points, segments } => {
                segments.iter().map(|ends| length(ends.map(|end| points[end as usize]))).collect()
            }
            _ => Vec::new(),
        }
    };
    let all: Vec<Vec<f64>> = lines.iter().map(lengths).collect();
    let ink: f64 =
        lines.iter().zip(&all).map(|(lines, all)| lines.style.width * all.iter().sum::<f64>()).sum();
    if ink > MOST_INK * f64::from(side) * f64::from(side) {
        for (lines, lengths) in lines.iter_mut().zip(&all) {
            let mut is_long = lengths.iter().map(|&length| length >= SHORT);
            match &mut lines.path {
                LinePath::Edges { edges, .. } => edges.retain(|_| is_long.next() == Some(true)),
                LinePath::Points { segments, .. } => segments.retain(|_| is_long.next() == Some(true)),
                _ => {}
            }
        }
    }
    lines.retain(|lines| match &lines.path {
        LinePath::Edges { edges, .. } => !edges.is_empty(),
        LinePath::Points { segments, .. } => !segments.is_empty(),
        _ => false,
    });
    lines
}

/// What a line of the legend explains.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Key {
    Absent,
    Line,
    Dot,
    Ring,
}

/// What is drawn over the colours.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub(super) struct Marks {
    /// Lines along edges with two normals.
    pub(super) lines: bool,
    /// Dots on corners whose faces are too small to be seen.
    pub(super) dots: bool,
    /// Rings round worst places.
    pub(super) rings: bool,
    /// Some worst places lie behind what is seen, and have no ring.
    pub(super) hidden: bool,
}

impl Marks {
    /// What the legend says of rings.
    fn of_rings(self) -> &'static str {
        match (self.rings, self.hidden) {
            (_, false) => "worst place",
            (true, true) => "worst place (others lie behind)",
            (false, true) => "worst place: lies behind",
        }
    }
}

/// A picture with what its colours and marks mean below it.
pub(super) fn with_legend(picture: &Picture, scale: HeatScale, marks: Marks) -> Picture {
    let [width, height] = picture.size.map(i64::from);
    let (bar, text) = ((height / 40).max(6), (height as f32 / 28.0).max(12.0));
    let (margin, line) = (width / 16, text as i64 + bar / 2);
    let keys = [
        (Key::Absent, "no valid normal", scale.is_absent),
        (Key::Line, "edge with two normals", marks.lines),
        (Key::Dot, "far off on a small face", marks.dots),
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

/// The colour of words.
const INK: [f32; 3] = [0.1; 3];

/// A bar of the colours with angles above it.
fn draw_scale(picture: &mut Picture, scale: HeatScale, [left, top]: [i64; 2], (bar, text): (i64, f32)) {
    let width = i64::from(picture.size[0]);
    let (right, below) = (width - left, top + text as i64 + 2);
    for x in left..right {
        let colour = coded(viridis((x - left) as f64 / (right - left - 1) as f64));
        (below..below + bar).for_each(|y| picture.blend([x, y], colour, 1.0));
    }
    let [full, half] = scale.labels();
    let mut free = width;
    // From the right: the middle gives way to a long label at the end.
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

/// A picture of what a key stands for, in a square.
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

    #[test]
    fn scales_end_where_the_data_does() {
        let scale = |deviations: Vec<f64>| {
            let deviations = deviations.into_iter().map(Some).collect();
            HeatScale::of([Survey { deviations, ..Survey::default() }].iter())
        };
        assert_eq!(scale(vec![]).labels(), ["1°", "0.5°"]);
        assert_eq!(scale(vec![0.0, 3.0]).labels(), ["5°", "2.5°"]);
        assert_eq!(scale(vec![30.0; 7]).labels(), ["30°", "15°"]);
        // One in two hundred is left out, two are not.
        let with = |count: usize| [vec![0.0; 200 - count], vec![180.0; count]].concat();
        assert_eq!(scale(with(1)).words(), "from violet, 0°, to yellow, 1° and more, up to 180°");
        let rounded = [vec![90.0; 400], vec![90.0 + 1e-9]].concat();
        assert_eq!(scale(rounded).words(), "from violet, 0°, to yellow, 90°");
        assert_eq!(scale(with(2)).words(), "from violet, 0°, to yellow, 180°");
    }

    #[test]
    fn what_has_no_deviation_has_a_colour_of_its_own() {
        let of =
            |deviations: Vec<Option<f64>>| HeatScale::of([Survey { deviations, ..Survey::default() }].iter());
        let scale = of(vec![Some(3.0), None]);
        assert_eq!(scale.colour(None), LinearRgb::from(ABSENT));
        assert_eq!(
            scale.words(),
            "from violet, 0°, to yellow, 5°; pink where no normal is stored that has a direction"
        );
        assert_eq!(of(vec![None]).words(), "pink all over: no normal is stored that has a direction");
    }

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
