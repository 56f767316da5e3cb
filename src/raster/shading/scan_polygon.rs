//! The lectures' scanline algorithm (F19): values at the corners of a polygon, spread over its inside.
//!
//! It is that of Gouraud 1971. It uses the whole polygon, not triangles, so for four corners or more the result depends on the rotation
//! of the polygon.

use crate::raster::view::clip::{ClipVertex, Mix, NEAR, clip};
use crate::raster::view::fixed_point::{GUARD, ONE, snap};
use crate::raster::view::screen_transform::{View, ViewPoint};
use glam::DVec3;

impl Mix for DVec3 {
    fn mix(self, other: Self, [of_self, of_other]: [f64; 2], _: [f64; 2]) -> Self {
        self * of_self + other * of_other
    }
}

/// A polygon on the picture with a value at each corner.
#[derive(Clone, Debug, Default)]
pub(crate) struct ScanPolygon {
    corners: Vec<([f64; 2], DVec3)>,
}

#[derive(Clone, Copy)]
struct Crossing {
    x: f64,
    value: DVec3,
}

impl ScanPolygon {
    /// Clips a polygon to the near plane and places it on the picture, snapped like everything that covers pixels.
    pub(crate) fn new(view: &View, corners: impl Iterator<Item = (ViewPoint, DVec3)>) -> Self {
        // Out of the guard band there is no grid and no need of one.
        let reach = f64::from(2 * GUARD);
        let on_grid =
            |place: f64| if place.abs() < reach { f64::from(snap(place)) / f64::from(ONE) } else { place };
        let mut polygon = Self::unsnapped(view, corners);
        for (place, _) in &mut polygon.corners {
            *place = place.map(on_grid);
        }
        polygon
    }

    /// The same without snapping.
    pub(crate) fn unsnapped(view: &View, corners: impl Iterator<Item = (ViewPoint, DVec3)>) -> Self {
        let mut polygon: Vec<_> = corners.map(|(point, attribute)| ClipVertex { point, attribute }).collect();
        clip(view, 1 << NEAR, &mut polygon, &mut Vec::new());
        Self { corners: polygon.iter().map(|v| (view.on_picture(v.point), v.attribute)).collect() }
    }

    /// The value at a place of the picture.
    ///
    /// Edges are half-open in y, so that a scanline through a corner crosses an even number of edges; level edges are
    /// skipped. Of the spans between pairs of crossings the one that holds the place counts; if rounding excludes the
    /// place from all of them, the nearest one.
    pub(crate) fn value(&self, [x, y]: [f64; 2]) -> DVec3 {
        let next = self.corners.iter().cycle().skip(1);
        let mut crossings: Vec<Crossing> = self
            .corners
            .iter()
            .zip(next)
            .filter(|((a, _), (b, _))| (a[1] <= y) != (b[1] <= y))
            .map(|(&(a, value_a), &(b, value_b))| {
                let t = (y - a[1]) / (b[1] - a[1]);
                Crossing { x: a[0] + (b[0] - a[0]) * t, value: value_a + (value_b - value_a) * t }
            })
            .collect();
        crossings.sort_by(|a, b| a.x.total_cmp(&b.x));
        let outside = |span: &&[Crossing]| (span[0].x - x).max(x - span[1].x).max(0.0);
        let spans = crossings.chunks_exact(2);
        match spans.min_by(|a, b| outside(a).total_cmp(&outside(b))) {
            Some([left, right]) if right.x > left.x => {
                let t = ((x - left.x) / (right.x - left.x)).clamp(0.0, 1.0);
                left.value + (right.value - left.value) * t
            }
            Some(span) => span[0].value,
            // A polygon that covers the place only as its triangles do, not as a polygon: it crosses itself.
            None => self.nearest([x, y]),
        }
    }

    fn nearest(&self, [x, y]: [f64; 2]) -> DVec3 {
        let distance = |&&([a, b], _): &&([f64; 2], DVec3)| (a - x) * (a - x) + (b - y) * (b - y);
        let nearest = self.corners.iter().min_by(|a, b| distance(a).total_cmp(&distance(b)));
        nearest.map_or(DVec3::ZERO, |&(_, value)| value)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn polygon(corners: &[([f64; 2], [f64; 3])]) -> ScanPolygon {
        ScanPolygon { corners: corners.iter().map(|&(place, value)| (place, value.into())).collect() }
    }

    fn diamond(degrees: f64) -> ScanPolygon {
        // Exercise 1.6.25: v1 and v3 on the scanline through the centre, v2 and v4 on the vertical.
        let colours = [[0.0, 0.4, 0.4], [0.0, 0.2, 0.2], [0.2, 0.6, 0.6], [0.4, 0.4, 0.0]];
        let corner = |k: usize| {
            let turn = (degrees + 90.0 * k as f64).to_radians();
            ([10.0 * libm::cos(turn), 10.0 * libm::sin(turn)], colours[k])
        };
        polygon(&[0, 1, 2, 3].map(corner))
    }

    /// The closed form of reference §4.1, and the two printed values.
    #[test]
    fn the_diamond_turns_its_centre() {
        for step in 0..=18 {
            let degrees = 5.0 * f64::from(step);
            let (sin, cos) = libm::sincos(degrees.to_radians());
            let (c13, c24) = (DVec3::new(0.2, 1.0, 1.0) * 0.5, DVec3::new(0.4, 0.6, 0.2) * 0.5);
            let expected = (c13 * cos + c24 * sin) / (cos + sin);
            let got = diamond(degrees).value([0.0, 0.0]);
            assert!(got.distance(expected) < 1e-14, "{degrees}: {got} is not {expected}");
        }
        assert!(diamond(0.0).value([0.0, 0.0]).distance(DVec3::new(0.1, 0.5, 0.5)) < 1e-15);
        assert!(diamond(90.0).value([0.0, 0.0]).distance(DVec3::new(0.2, 0.3, 0.1)) < 1e-15);
    }

    /// Exercise 1.6.24 with a triangle that fits its figure: in triangles it is barycentric.
    #[test]
    fn triangles_are_barycentric() {
        let triangle = polygon(&[
            ([2.0, 1.0], [1.0, 0.0, 0.8]),
            ([6.0, 5.0], [0.6, 0.4, 0.8]),
            ([10.0, 1.0], [0.2, 0.8, 0.0]),
        ]);
        assert!(triangle.value([6.0, 3.0]).distance(DVec3::new(0.6, 0.4, 0.6)) < 1e-15);
    }

    #[test]
    fn level_edges_corners_and_dents_are_handled() {
        let value = |place: [f64; 2]| [place[0], place[1], 0.0];
        // A U: linear in the corners' places, so linear everywhere.
        let places =
            [[0.0, 0.0], [6.0, 0.0], [6.0, 4.0], [4.0, 4.0], [4.0, 2.0], [2.0, 2.0], [2.0, 4.0], [0.0, 4.0]];
        let dented = polygon(&places.map(|place| (place, value(place))));
        for [x, y] in [[1.0, 3.0], [5.0, 3.0], [3.0, 1.0], [1.0, 2.0], [0.0, 0.0], [5.5, 3.999]] {
            assert!(dented.value([x, y]).distance(DVec3::new(x, y, 0.0)) < 1e-14, "{x} {y}");
        }
        // Below the last scanline nothing crosses.
        assert_eq!(dented.value([5.9, 4.0]), DVec3::new(6.0, 4.0, 0.0));
    }
}
