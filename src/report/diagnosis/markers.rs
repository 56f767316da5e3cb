//! Markers over a heat map: lines along creases, dots on single corners, rings around worst places.

use super::heat_scale::{ABSENT, HeatScale};
use crate::num::{LinearRgb, viridis};
use crate::raster::{Camera, LinePath, LineStyle, Lines, Projection, Scene};
use crate::report::overlay::{Overlay, overlay};
use crate::report::picture::Picture;
use glam::{DMat4, DVec3};

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
    fn marks(self) -> Vec<(LinearRgb, impl Fn(Option<f64>) -> bool)> {
        let absent = (LinearRgb::from(ABSENT), None, None);
        let share = |at: f64| MARKED + (1.0 - MARKED) * at / SHADES as f64;
        // Larger deviations are drawn last; those beyond the scale have the colour of its end.
        let above = |at: usize| {
            let is_last = at + 1 == SHADES;
            let next = (!is_last).then(|| share(at as f64 + 1.0) * self.full.0);
            let colour = if is_last { 1.0 } else { share(at as f64 + 0.5) };
            (viridis(colour), Some(share(at as f64) * self.full.0), next)
        };
        let all = (0..SHADES).map(above).chain([absent]);
        let is_marked = |least: Option<f64>, below: Option<f64>| {
            move |deviation: Option<f64>| match (deviation, least) {
                (Some(degrees), Some(least)) => degrees >= least && below.is_none_or(|below| degrees < below),
                (None, None) => true,
                _ => false,
            }
        };
        all.map(|(colour, least, below)| (colour, is_marked(least, below))).collect()
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
    let (Ok([right, _, forward]), width) = (camera.axes(), DOT * (f64::from(side) / 480.0).max(1.0)) else {
        return Vec::new();
    };
    let is_small = |corner: &Corner| corner.edge < 2.0 * width * pixel(camera, side, corner.position);
    let is_far = |corner: &Corner| {
        let stands_out = match (corner.deviation, corner.around) {
            (Some(degrees), Some(around)) => degrees - around >= scale.full.0 * CONTRAST,
            (deviation, around) => deviation.is_some() != around.is_some(),
        };
        stands_out && scale.is_far(corner.deviation)
    };
    let all: Vec<Corner> =
        corners.filter(|corner| scale.is_used && is_far(corner) && is_small(corner)).collect();
    let marks = scale.marks().into_iter().map(|(colour, is_marked)| {
        let marked = all.iter().filter(|corner| is_marked(corner.deviation));
        let points = marked.flat_map(|corner| {
            let pixel = pixel(camera, side, corner.position);
            // Towards the eye, or the surrounding surface would hide parts of it.
            let at = corner.position - forward * width * pixel;
            [at - right * 0.5 * pixel, at + right * 0.5 * pixel]
        });
        let points: Vec<DVec3> = points.collect();
        let segments = (0..points.len() as u32 / 2).map(|dot| [2 * dot, 2 * dot + 1]).collect();
        let style = LineStyle { colour, width, hide: true };
        Lines { path: LinePath::Points { points, segments }, style }
    });
    marks.filter(|lines| !is_empty(lines)).collect()
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
    use crate::quality::Survey;

    /// Every deviation from half of the scale on is marked once, and nothing below.
    #[test]
    fn marks_share_the_upper_half() {
        let deviations = vec![Some(90.0)];
        let scale = HeatScale::of([Survey { deviations, ..Survey::default() }].iter());
        let marks = |deviation| scale.marks().iter().filter(|(_, is_marked)| is_marked(deviation)).count();
        for degrees in 0..=180 {
            assert_eq!(marks(Some(f64::from(degrees))), usize::from(degrees >= 45), "{degrees}°");
            // Half a shade off at most, but for the last one, which has the colour of the end.
            for (colour, _) in scale.marks().iter().filter(|(_, is)| is(Some(f64::from(degrees)))) {
                let off = |share: &f64| {
                    let shown = viridis(*share).to_array().into_iter().zip(colour.to_array());
                    shown.map(|(a, b)| (a - b).abs()).sum::<f64>()
                };
                let shares = (0..=1000).map(|share| f64::from(share) / 1000.0);
                let shown = shares.min_by(|a, b| off(a).total_cmp(&off(b))).unwrap();
                let own = (f64::from(degrees) / 90.0).min(1.0);
                assert!((shown - own).abs() <= 0.0201, "{degrees}°: {shown}");
            }
        }
        assert_eq!(marks(None), 1);
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
            assert_eq!(lines.len(), usize::from(is_marked), "{deviation:?} beside {around:?}");
        }
    }
}
