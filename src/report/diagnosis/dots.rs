//! Dots on a heat map where single corners are far off that no pixel would show.

use super::heat::{ABSENT, HeatScale};
use crate::num::{LinearRgb, viridis};
use crate::raster::{Camera, LinePath, LineStyle, Lines, Projection};
use glam::{DMat4, DVec3};

/// The width of the dots that mark single corners, in a picture of 480 pixels.
const DOT: f64 = 2.5;

/// The share of the scale from which on corners are marked.
const MARKED: f64 = 0.5;

/// The share of the scale by which they are further off than what is round them: where all is far off, that is seen anyway.
const CONTRAST: f64 = 0.25;

/// Colours that marks have from there to the end of the scale: a hundredth of the scale from what they mark, or two at its end.
const SHADES: usize = 25;

impl HeatScale {
    /// The colours that mark corners, each with the deviations that it marks.
    fn marks(self) -> Vec<(LinearRgb, impl Fn(Option<f64>) -> bool)> {
        let absent = (LinearRgb::from(ABSENT), None, None);
        let share = |at: f64| MARKED + (1.0 - MARKED) * at / SHADES as f64;
        // Higher ones lie above lower ones; what is beyond the scale has the colour of its end.
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

    /// Whether a corner of such a deviation may be marked.
    pub(super) fn is_far(self, deviation: Option<f64>) -> bool {
        deviation.is_none_or(|degrees| degrees >= self.full.0 * MARKED)
    }
}

/// A corner that may be marked.
pub(super) struct Corner {
    /// Where it is in the world.
    pub(super) position: DVec3,
    pub(super) deviation: Option<f64>,
    /// The length of the longest edge of its face there.
    pub(super) edge: f64,
    /// The least deviation of corners at the places of its face's corners, `None` if none has one.
    pub(super) around: Option<f64>,
}

/// Dots on corners that are far off, more than what is round them, and whose faces are too small to be seen: a pixel shows the mean
/// of what it covers, and of single faults among many faces that would be nothing.
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
            // Towards the eye, or the surface round it would hide what bends away.
            let at = corner.position - forward * width * pixel;
            [at - right * 0.5 * pixel, at + right * 0.5 * pixel]
        });
        let points: Vec<DVec3> = points.collect();
        let segments = (0..points.len() as u32 / 2).map(|dot| [2 * dot, 2 * dot + 1]).collect();
        let style = LineStyle { colour, width, hide: true };
        Lines { path: LinePath::Points { points, segments }, style }
    });
    marks
        .filter(|lines| !matches!(&lines.path, LinePath::Points { segments, .. } if segments.is_empty()))
        .collect()
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
