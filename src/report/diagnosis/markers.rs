//! The colours of deviations, and markers over a heat map: lines along creases, dots on single corners, rings around worst positions.

use super::texts::Texts;
use crate::num::{Degrees, LinearRgb, Srgb8, three_digits, viridis};
use crate::quality::Survey;
use crate::raster::{Camera, LinePath, LineStyle, Lines, Projection, Scene};
use crate::report::overlay::{Overlay, overlay};
use crate::text::Value;
use glam::{DMat4, DVec3};

/// The colour of corners without a valid stored normal; not on the scale.
pub(super) const ABSENT: Srgb8 = Srgb8([240, 80, 200]);

#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct HeatScale {
    /// The deviation at the light end.
    pub(super) full: Degrees,
    /// The largest deviation, if it is above that.
    beyond: Option<Degrees>,
    /// Some corners have a deviation.
    pub(super) is_used: bool,
    /// Some corners have none.
    pub(super) is_absent: bool,
}

/// Round angles that scales end at. Deviations below the first are not visible in a picture.
const ENDS: [f64; 11] = [1.0, 2.0, 5.0, 10.0, 15.0, 20.0, 30.0, 45.0, 60.0, 90.0, 180.0];

/// The first round angle that is no smaller, in degrees.
pub(in crate::report) fn end_above(degrees: f64) -> f64 {
    ENDS.into_iter().find(|&end| end >= degrees).unwrap_or(180.0)
}

impl HeatScale {
    /// The first round angle that at most one deviation in two hundred exceeds, so that single faults do not compress the
    /// colours of all others.
    pub(super) fn of<'a>(surveys: impl Iterator<Item = &'a Survey>) -> Self {
        let corners: Vec<Option<f64>> = surveys.flat_map(|survey| &survey.deviations).copied().collect();
        let mut all: Vec<f64> = corners.iter().copied().flatten().collect();
        all.sort_unstable_by(f64::total_cmp);
        let nearly_all = all.iter().rev().nth(all.len() / 200).copied().unwrap_or_default();
        let full = end_above(nearly_all);
        // Labels have three digits: 90.0004° is not beyond 90°.
        let is_beyond = |largest: &&f64| **largest > full && three_digits(**largest) != three_digits(full);
        Self {
            full: Degrees(full),
            beyond: all.last().filter(is_beyond).map(|&largest| Degrees(largest)),
            is_used: !all.is_empty(),
            is_absent: all.len() < corners.len(),
        }
    }

    pub(super) fn colour(self, deviation: Option<f64>) -> LinearRgb {
        deviation.map_or(LinearRgb::from(ABSENT), |degrees| viridis(degrees / self.full.0))
    }

    /// The labels at the light end and in the middle.
    pub(super) fn labels(self, texts: Texts) -> [String; 2] {
        let full = |degrees: f64| ("full", Value::digits(&degrees.to_string()));
        let end = match self.beyond {
            None => texts.with("scale-end", &[full(self.full.0)]),
            Some(largest) => {
                let largest = ("largest", Value::digits(&three_digits(largest.0)));
                texts.with("scale-end-beyond", &[full(self.full.0), largest])
            }
        };
        [end, texts.with("scale-end", &[full(self.full.0 / 2.0)])]
    }

    /// The same in words, for those who cannot see it.
    pub(super) fn words(self, texts: Texts) -> String {
        let [end, _] = self.labels(texts);
        let scale = texts.with("scale", &[("end", end.into())]);
        match (self.is_used, self.is_absent) {
            (true, true) => texts.with("scale-and-absent", &[("scale", scale.into())]),
            (false, true) => texts.get("scale-absent"),
            _ => scale,
        }
    }
}

/// The deviation of a corner as a colour to be interpolated: degrees, and 1 in green for a deviation or in blue for none.
pub(super) fn encode(deviation: Option<f64>) -> LinearRgb {
    deviation.map_or(LinearRgb::new(0.0, 0.0, 1.0), |degrees| LinearRgb::new(degrees, 1.0, 0.0))
}

/// The brightness of lines along edges: darker than all colours except those of correct normals, lighter than these.
pub(super) const LINE: f64 = 0.3;

/// The share of a picture that lines may cover; beyond it, those of short edges are omitted.
const MOST_INK: f64 = 0.1;

/// Pixels below which an edge is short: lines a pixel wide would cover much of the faces between them.
const SHORT: f64 = 8.0;

/// The width of the dots that mark single corners, in a picture of 480 pixels.
const DOT: f64 = 2.5;

/// The share of the scale above which corners are marked.
const MARKED: f64 = 0.5;

/// The share of the scale by which they exceed their surroundings: where all deviations are large, that is visible anyway.
const CONTRAST: f64 = 0.25;

/// Colours of dots from there to the end of the scale: within a hundredth of the scale of their deviation, or two at its end.
const SHADES: usize = 25;

/// The creases of a scene as lines that show its form. Where they would hide the colours, as on a fine faceted mesh, those
/// along short edges are omitted.
pub(super) fn crease_lines(scene: &Scene<'_>, side: u32) -> Vec<Lines> {
    let mut lines = overlay(scene, [side; 2], Overlay::Creases);
    for Lines { style, .. } in &mut lines {
        // Thinner than in the picture of the creases.
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
    lines.retain(|lines| !is_empty(lines));
    lines
}

fn is_empty(lines: &Lines) -> bool {
    match &lines.path {
        LinePath::Edges { edges, .. } => edges.is_empty(),
        LinePath::Points { segments, .. } => segments.is_empty(),
        _ => true,
    }
}

impl HeatScale {
    /// The number of the shade of dots that a far corner is marked with. Larger deviations are drawn later, corners without one
    /// last.
    fn shade(self, deviation: Option<f64>) -> usize {
        let is_at_least = |degrees: f64, at: usize| degrees >= marked_share(at as f64) * self.full.0;
        let shade = |degrees| (0..SHADES).rev().find(|&at| is_at_least(degrees, at)).unwrap_or(0);
        deviation.map_or(SHADES, shade)
    }

    /// Whether a corner with this deviation may be marked.
    pub(super) fn is_far(self, deviation: Option<f64>) -> bool {
        deviation.is_none_or(|degrees| degrees >= self.full.0 * MARKED)
    }
}

pub(super) struct Corner {
    /// Where it is in the world.
    pub(super) position: DVec3,
    pub(super) deviation: Option<f64>,
    /// The length of the longer edge of its face there.
    pub(super) edge: f64,
    /// The smallest deviation at the positions of its face's corners; `None` without one.
    pub(super) around: Option<f64>,
}

/// Dots on corners with a large deviation, larger than that of their surroundings, on faces too small to be visible: a pixel
/// shows the mean of what it covers, in which single faults among many faces vanish.
pub(super) fn dots(
    corners: impl Iterator<Item = Corner>,
    scale: HeatScale,
    camera: &Camera,
    side: u32,
) -> Vec<Lines> {
    let is_small = |corner: &Corner| is_small(corner.edge, corner.position, camera, side);
    let is_far = |corner: &Corner| {
        let stands_out = match (corner.deviation, corner.around) {
            (Some(degrees), Some(around)) => degrees - around >= scale.full.0 * CONTRAST,
            (deviation, around) => deviation.is_some() != around.is_some(),
        };
        stands_out && scale.is_far(corner.deviation)
    };
    let all: Vec<Corner> =
        corners.filter(|corner| scale.is_used && is_far(corner) && is_small(corner)).collect();
    let lines = (0..=SHADES).filter_map(|shade| {
        let marked = all.iter().filter(|corner| scale.shade(corner.deviation) == shade);
        dot_lines(marked.map(|corner| corner.position).collect(), shade_colour(shade), camera, side)
    });
    lines.collect()
}

/// The share of the scale at a shade of dots.
fn marked_share(shade: f64) -> f64 {
    MARKED + (1.0 - MARKED) * shade / SHADES as f64
}

fn shade_colour(shade: usize) -> LinearRgb {
    match shade {
        SHADES => LinearRgb::from(ABSENT),
        // Those beyond the scale have the colour of its end.
        _ if shade + 1 == SHADES => viridis(1.0),
        _ => viridis(marked_share(shade as f64 + 0.5)),
    }
}

fn dot_width(side: u32) -> f64 {
    DOT * (f64::from(side) / 480.0).max(1.0)
}

/// Whether an edge at a position is so short that a dot shows more of it.
pub(super) fn is_small(edge: f64, position: DVec3, camera: &Camera, side: u32) -> bool {
    edge < 2.0 * dot_width(side) * pixel(camera, side, position)
}

/// Dots of a colour at some points; `None` for none.
pub(super) fn dot_lines(at: Vec<DVec3>, colour: LinearRgb, camera: &Camera, side: u32) -> Option<Lines> {
    let [right, _, forward] = camera.axes().ok()?;
    let width = dot_width(side);
    let ends = |position: DVec3| {
        let pixel = pixel(camera, side, position);
        // Towards the eye, or the surrounding surface would hide parts of it.
        let at = position - forward * width * pixel;
        [at - right * 0.5 * pixel, at + right * 0.5 * pixel]
    };
    let points: Vec<DVec3> = at.into_iter().flat_map(ends).collect();
    let segments = (0..points.len() as u32 / 2).map(|dot| [2 * dot, 2 * dot + 1]).collect();
    let style = LineStyle { colour, width, hide: true };
    let lines = Lines { path: LinePath::Points { points, segments }, style };
    (!is_empty(&lines)).then_some(lines)
}

/// The size of a pixel in the world, at a point.
fn pixel(camera: &Camera, side: u32, point: DVec3) -> f64 {
    let height = match camera.projection {
        Projection::Orthographic(height) => height,
        Projection::Perspective(angle) => 2.0 * camera.eye.distance(point) * libm::tan(0.5 * angle.0),
    };
    height / f64::from(side)
}

/// The longest of the edges that a corner of a face has, in the world.
pub(super) fn longest_edge(place: DMat4, [before, here, after]: [DVec3; 3]) -> f64 {
    [before, after].map(|end| place.transform_vector3(end - here).length()).into_iter().fold(0.0, f64::max)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::quality::Survey;
    use crate::text::Language;

    const ENGLISH: Texts = Texts(Language::English);

    /// Deviations from half of the scale on are marked, half a shade off at most, but for the last, which has the colour of the end.
    #[test]
    fn marks_share_the_upper_half() {
        let deviations = vec![Some(90.0)];
        let scale = HeatScale::of([Survey { deviations, ..Survey::default() }].iter());
        for degrees in (0..=180).map(f64::from) {
            assert_eq!(scale.is_far(Some(degrees)), degrees >= 45.0, "{degrees}°");
            let colour = shade_colour(scale.shade(Some(degrees)));
            let off = |share: &f64| {
                let shown = viridis(*share).to_array().into_iter().zip(colour.to_array());
                shown.map(|(a, b)| (a - b).abs()).sum::<f64>()
            };
            let shares = (0..=1000).map(|share| f64::from(share) / 1000.0);
            let shown = shares.min_by(|a, b| off(a).total_cmp(&off(b))).unwrap();
            let own = (degrees / 90.0).min(1.0);
            assert!(degrees < 45.0 || (shown - own).abs() <= 0.0201, "{degrees}°: {shown}");
        }
        assert!(scale.is_far(None) && shade_colour(scale.shade(None)) == LinearRgb::from(ABSENT));
    }

    /// Where all round a corner is as far off, or nearly, pixels have that colour anyway.
    #[test]
    fn only_what_stands_out_is_marked() {
        let deviations = [vec![Some(0.0); 9], vec![Some(90.0); 9], vec![None]].concat();
        let scale = HeatScale::of([Survey { deviations, ..Survey::default() }].iter());
        let camera = Camera::framing((DVec3::ZERO, DVec3::ONE), 1.0);
        for (deviation, around, is_marked) in [
            (Some(90.0), Some(0.0), true),
            (Some(90.0), Some(67.0), true),
            (Some(90.0), Some(70.0), false),
            (Some(44.0), Some(0.0), false),
            (None, Some(0.0), true),
            (None, None, false),
        ] {
            let corner = Corner { position: DVec3::splat(0.5), deviation, edge: 1e-4, around };
            let lines = dots([corner].into_iter(), scale, &camera, 480);
            assert_eq!(lines.len(), usize::from(is_marked), "{deviation:?} next to {around:?}");
        }
    }

    #[test]
    fn scales_end_where_the_data_does() {
        let scale = |deviations: Vec<f64>| {
            let deviations = deviations.into_iter().map(Some).collect();
            HeatScale::of([Survey { deviations, ..Survey::default() }].iter())
        };
        assert_eq!(scale(vec![]).labels(ENGLISH), ["1°", "0.5°"]);
        assert_eq!(scale(vec![0.0, 3.0]).labels(ENGLISH), ["5°", "2.5°"]);
        assert_eq!(scale(vec![30.0; 7]).labels(ENGLISH), ["30°", "15°"]);
        // One in two hundred is ignored, two are not.
        let with = |count: usize| [vec![0.0; 200 - count], vec![180.0; count]].concat();
        assert_eq!(scale(with(1)).words(ENGLISH), "from violet, 0°, to yellow, 1° and more, up to 180°");
        let rounded = [vec![90.0; 400], vec![90.0 + 1e-9]].concat();
        assert_eq!(scale(rounded).words(ENGLISH), "from violet, 0°, to yellow, 90°");
        assert_eq!(scale(with(2)).words(ENGLISH), "from violet, 0°, to yellow, 180°");
    }

    #[test]
    fn what_has_no_deviation_has_a_colour_of_its_own() {
        let of =
            |deviations: Vec<Option<f64>>| HeatScale::of([Survey { deviations, ..Survey::default() }].iter());
        let scale = of(vec![Some(3.0), None]);
        assert_eq!(scale.colour(None), LinearRgb::from(ABSENT));
        assert_eq!(
            scale.words(ENGLISH),
            "from violet, 0°, to yellow, 5°; pink where no valid normal is stored"
        );
        assert_eq!(of(vec![None]).words(ENGLISH), "pink everywhere: no valid normal is stored");
    }
}
