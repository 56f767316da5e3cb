//! Distances between outlines.

use super::contour::Contour;
use super::pairs::MetricError;
use serde::Serialize;

/// Distances of an outline from the true one, in pixels.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize)]
pub struct ContourDistance {
    /// The mean of both [means](Distances::mean).
    pub mean: f64,
    /// Hausdorff's distance: the larger of both [maxima](Distances::max).
    pub hausdorff: f64,
    /// From the outline to the true one: large where the outline has additional parts.
    pub to_truth: Distances,
    /// From the true outline to the measured one: large where parts are missing.
    pub from_truth: Distances,
    /// The area within the outline over that within the true one.
    pub area_ratio: f64,
}

impl ContourDistance {
    /// The same in another unit of length, `unit` of which are a pixel: for outlines drawn larger than their picture.
    #[must_use]
    pub fn scaled(&self, unit: f64) -> Self {
        let scaled = |Distances { mean, max }| Distances { mean: unit * mean, max: unit * max };
        Self {
            mean: unit * self.mean,
            hausdorff: unit * self.hausdorff,
            to_truth: scaled(self.to_truth),
            from_truth: scaled(self.from_truth),
            area_ratio: self.area_ratio,
        }
    }
}

/// Distances from the points of one outline to the nearest point of another, in pixels.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize)]
pub struct Distances {
    /// The mean over the outline's length, by the trapezoid rule between its points.
    pub mean: f64,
    /// The largest at a point of the outline.
    pub max: f64,
}

/// Compares two outlines: for every point of one the distance to the nearest point of the other, in both directions, and
/// the ratio of areas.
///
/// An inscribed regular n-gon is R(1 − cos(π/n)) from its circle at the middle of each side and has n sin(2π/n)/(2π) of its
/// area. *Accuracy* is that of the outlines ([`Contour`]): two outlines that differ by less than a sample's distance may
/// measure 0. Only points of outlines are compared, so Hausdorff's distance may be too small by the sagitta of a pixel.
/// *Does not measure* whether corners are visible: a moving polygon half a pixel from its circle may show its angles.
///
/// Cost: each point visits the segments in rows of pixels no farther than the nearest one found.
///
/// # Errors
/// [`MetricError::Empty`] if either has no points.
pub fn contour_distance(contour: &Contour, truth: &Contour) -> Result<ContourDistance, MetricError> {
    let to_truth = distances(contour, &Rows::of(truth))?;
    let from_truth = distances(truth, &Rows::of(contour))?;
    Ok(ContourDistance {
        mean: 0.5 * (to_truth.mean + from_truth.mean),
        hausdorff: to_truth.max.max(from_truth.max),
        to_truth,
        from_truth,
        area_ratio: contour.area() / truth.area(),
    })
}

fn distances(contour: &Contour, other: &Rows) -> Result<Distances, MetricError> {
    let (mut sum, mut length, mut max) = (0.0, 0.0, 0.0_f64);
    let mut last: Option<([f64; 2], f64)> = None;
    for [a, b] in contour.segments() {
        let at_a = match last {
            Some((point, distance)) if point == a => distance,
            _ => other.nearest(a).ok_or(MetricError::Empty)?,
        };
        let at_b = other.nearest(b).ok_or(MetricError::Empty)?;
        let side = libm::hypot(b[0] - a[0], b[1] - a[1]);
        sum += 0.5 * (at_a + at_b) * side;
        length += side;
        max = max.max(at_a);
        last = Some((b, at_b));
    }
    if length > 0.0 { Ok(Distances { mean: sum / length, max }) } else { Err(MetricError::Empty) }
}

/// The segments of an outline by the rows of pixels that they begin in.
struct Rows {
    first: i64,
    rows: Vec<Vec<[[f64; 2]; 2]>>,
}

impl Rows {
    fn of(contour: &Contour) -> Self {
        let row = |[a, b]: &[[f64; 2]; 2]| a[1].min(b[1]).floor() as i64;
        let first = contour.segments().map(|segment| row(&segment)).min().unwrap_or(0);
        let mut rows: Vec<Vec<[[f64; 2]; 2]>> = Vec::new();
        for segment in contour.segments() {
            let number = (row(&segment) - first) as usize;
            if rows.len() <= number {
                rows.resize_with(number + 1, Vec::new);
            }
            rows[number].push(segment);
        }
        Self { first, rows }
    }

    fn nearest(&self, point: [f64; 2]) -> Option<f64> {
        let own = point[1].floor() as i64 - self.first;
        let row = |number: i64| usize::try_from(number).ok().and_then(|number| self.rows.get(number));
        let mut best = f64::INFINITY;
        for away in 0..=own.abs() + self.rows.len() as i64 {
            // A segment lies within a cell of one pixel, so in its own row and the next: one that begins `away` rows higher
            // is more than `away` − 2 pixels off.
            if (away - 2) as f64 > best {
                break;
            }
            let rows = [own - away, own + away].into_iter().skip(usize::from(away == 0));
            for segment in rows.filter_map(row).flatten() {
                best = best.min(to_segment(point, segment));
            }
        }
        best.is_finite().then_some(best)
    }
}

fn to_segment(p: [f64; 2], [a, b]: &[[f64; 2]; 2]) -> f64 {
    let (along, from) = ([b[0] - a[0], b[1] - a[1]], [p[0] - a[0], p[1] - a[1]]);
    let square = along[0] * along[0] + along[1] * along[1];
    let dot = along[0] * from[0] + along[1] * from[1];
    let t = if square > 0.0 { (dot / square).clamp(0.0, 1.0) } else { 0.0 };
    libm::hypot(from[0] - t * along[0], from[1] - t * along[1])
}

#[cfg(test)]
mod tests {
    use super::super::pictures_tests::shape;
    use super::*;
    use crate::raster::Samples;
    use std::f64::consts::PI;

    const RADIUS: f64 = 60.0;

    /// A regular polygon about the middle of a picture of 128 pixels; the circle for 0 sides.
    fn polygon(sides: u32, samples: Samples) -> Contour {
        let half = PI / f64::from(sides.max(1));
        let inside = |x: f64, y: f64| {
            let [x, y] = [x - 64.0, y - 64.0];
            let radius = libm::hypot(x, y);
            if sides == 0 {
                return radius < RADIUS;
            }
            // The angle from the middle of the nearest side.
            let sector = 2.0 * half;
            let angle = libm::atan2(y, x);
            let off = angle - sector * (angle / sector).floor() - half;
            radius * libm::cos(off) < RADIUS * libm::cos(half)
        };
        Contour::of(&shape([128, 128], samples, inside), samples)
    }

    /// The closed forms of inscribed polygons.
    #[test]
    fn polygons_are_as_far_from_circles_as_they_are() {
        let circle = polygon(0, Samples::Sixteen);
        assert!((circle.area() / (PI * RADIUS * RADIUS) - 1.0).abs() < 2e-4);
        for sides in [6, 8, 16, 32] {
            let half = PI / f64::from(sides);
            let measured = contour_distance(&polygon(sides, Samples::Sixteen), &circle).unwrap();
            let sagitta = RADIUS * (1.0 - libm::cos(half));
            // Each outline is right to 0.0858 of a pixel and its samples to 1/16: twice that, were both at their worst.
            assert!(
                (measured.hausdorff - sagitta).abs() < 2.0 * (0.0858 + 1.0 / 16.0),
                "{sides}: {measured:?}, {sagitta}"
            );
            // From a point x along a side to the circle: R − √(apothem² + x²); from a point of the circle to its side:
            // R cos φ − apothem. Means over x and φ; edges are off to both sides, which leaves less than their worst.
            let (apothem, side) = (RADIUS * libm::cos(half), RADIUS * libm::sin(half));
            let to_circle = RADIUS - 0.5 * (RADIUS + apothem * apothem / side * libm::asinh(side / apothem));
            assert!((measured.to_truth.mean - to_circle).abs() < 0.04, "{sides}: {measured:?} {to_circle}");
            let to_side = side / half - apothem;
            assert!((measured.from_truth.mean - to_side).abs() < 0.04, "{sides}: {measured:?} {to_side}");
            assert_eq!(measured.mean, 0.5 * (measured.to_truth.mean + measured.from_truth.mean));
            let ratio = libm::sin(2.0 * half) / (2.0 * half);
            assert!((measured.area_ratio - ratio).abs() < 3e-4, "{sides}: {}", measured.area_ratio);
        }
    }

    #[test]
    fn single_samples_tell_whole_pixels() {
        let circle = polygon(0, Samples::One);
        let measured = contour_distance(&polygon(8, Samples::One), &circle).unwrap();
        assert!((measured.hausdorff - RADIUS * (1.0 - libm::cos(PI / 8.0))).abs() < 1.0, "{measured:?}");
        assert_eq!(contour_distance(&circle, &circle).unwrap().hausdorff, 0.0);
        assert_eq!(contour_distance(&circle, &Contour::default()), Err(MetricError::Empty));
    }

    /// Something added is far from the truth, but the truth is near everywhere.
    #[test]
    fn sides_are_distinguished() {
        let square = |x: f64, y: f64| x > 10.0 && x < 30.0 && y > 10.0 && y < 30.0;
        let dot = |x: f64, y: f64| x > 40.0 && x < 42.0 && y > 19.0 && y < 21.0;
        let truth = Contour::of(&shape([50, 40], Samples::One, square), Samples::One);
        let more = shape([50, 40], Samples::One, |x, y| square(x, y) || dot(x, y));
        let measured = contour_distance(&Contour::of(&more, Samples::One), &truth).unwrap();
        assert_eq!(measured.from_truth, Distances::default());
        assert_eq!((measured.to_truth.max, measured.hausdorff), (12.0, 12.0));
    }
}
