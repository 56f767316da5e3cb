//! Area lights: the irradiance of a polygon in closed form, and where its highlight comes from.

use super::formula::unit;
use super::light::AreaShape;
use super::settings::Frame;
use crate::num::corner_angle;
use glam::DVec3;
use std::f64::consts::{PI, TAU};

/// Corners of the polygon that approximates a disc.
///
/// It has the disc's area. On the axis of a disc of radius R, at the distance h, the irradiance is below R²/(R²+h²) by
/// a relative error of at most 1.3e-7, at h = R.
const DISC_CORNERS: usize = 64;

/// Cutting a convex polygon by a plane adds one corner at the most.
const MOST_CORNERS: usize = DISC_CORNERS + 1;

#[derive(Clone, Debug)]
pub(super) struct AreaSource {
    /// Counter-clockwise as seen from the side that it shines to.
    corners: Vec<DVec3>,
    shape: AreaShape,
    normal: DVec3,
}

impl AreaSource {
    pub(super) fn new(shape: &AreaShape, frame: &Frame) -> Self {
        match *shape {
            AreaShape::Rectangle { centre, u, v } => {
                let (centre, u, v) = (frame.to_local(centre), u / frame.unit, v / frame.unit);
                Self {
                    corners: vec![centre - u - v, centre + u - v, centre + u + v, centre - u + v],
                    shape: AreaShape::Rectangle { centre, u, v },
                    normal: unit(unit(u).cross(unit(v))),
                }
            }
            AreaShape::Disc { centre, normal, radius } => {
                let (centre, normal) = (frame.to_local(centre), unit(normal));
                let radius = radius / frame.unit;
                let (u, v) = normal.any_orthonormal_pair();
                let step = TAU / DISC_CORNERS as f64;
                // n/2 ρ² sin(2π/n) = πR²
                let corner_radius = radius * (step / libm::sin(step)).sqrt();
                let corner = |k: usize| {
                    let angle = step * k as f64;
                    centre + (u * libm::cos(angle) + v * libm::sin(angle)) * corner_radius
                };
                Self {
                    corners: (0..DISC_CORNERS).map(corner).collect(),
                    shape: AreaShape::Disc { centre, normal, radius },
                    normal,
                }
            }
        }
    }

    /// The diffuse irradiance at a point with this normal, as a share of that of a surface surrounded by the light.
    pub(super) fn irradiance(&self, point: DVec3, normal: DVec3) -> f64 {
        let Some(polygon) = self.seen_from(point) else { return 0.0 };
        let polygon = &polygon[..self.corners.len()];
        let heights = polygon.iter().map(|corner| corner.dot(normal));
        let (lowest, highest) =
            heights.fold((f64::INFINITY, f64::NEG_INFINITY), |(l, h), x| (l.min(x), h.max(x)));
        if highest <= 0.0 {
            0.0
        } else if lowest < 0.0 {
            let mut above = [DVec3::ZERO; MOST_CORNERS];
            let count = clip_at_horizon(polygon, normal, &mut above);
            vector_irradiance(&above[..count]).dot(normal)
        } else {
            vector_irradiance(polygon).dot(normal)
        }
    }

    /// The irradiance of a surface at this point that faces the light: the factor of its highlight.
    pub(super) fn facing(&self, point: DVec3) -> f64 {
        self.seen_from(point)
            .map_or(0.0, |polygon| vector_irradiance(&polygon[..self.corners.len()]).length())
    }

    /// The unit vector to the representative point for this normal and direction to the viewer, and its distance.
    pub(super) fn towards(&self, point: DVec3, normal: DVec3, view: DVec3) -> (DVec3, f64) {
        let mirrored = normal * (2.0 * normal.dot(view)) - view;
        let way = self.representative(point, mirrored) - point;
        let distance = way.length();
        (way / distance, distance)
    }

    /// The corners as seen from a point on the side that it shines to.
    fn seen_from(&self, point: DVec3) -> Option<[DVec3; MOST_CORNERS]> {
        if (point - self.corners[0]).dot(self.normal) <= 0.0 {
            return None;
        }
        let mut polygon = [DVec3::ZERO; MOST_CORNERS];
        for (seen, corner) in polygon.iter_mut().zip(&self.corners) {
            *seen = *corner - point;
        }
        Some(polygon)
    }

    /// The point of the light that the mirrored ray meets or comes closest to (Karis, *Real shading in Unreal Engine 4*,
    /// SIGGRAPH 2013 course).
    fn representative(&self, point: DVec3, ray: DVec3) -> DVec3 {
        let (AreaShape::Rectangle { centre, .. } | AreaShape::Disc { centre, .. }) = self.shape;
        let below = (centre - point).dot(self.normal);
        let speed = ray.dot(self.normal);
        // The point where the ray meets the plane, relative to the centre; without one the ray comes closest at the rim.
        let meets = below / speed > 0.0;
        let from_centre =
            if meets { point + ray * (below / speed) - centre } else { ray - self.normal * speed };
        match self.shape {
            AreaShape::Rectangle { centre, u, v } => {
                let along = |side: DVec3| {
                    let length = side.length();
                    let part = from_centre.dot(side / length) / length;
                    if meets { part.clamp(-1.0, 1.0) } else { sign(part) }
                };
                centre + u * along(u) + v * along(v)
            }
            AreaShape::Disc { centre, radius, .. } => {
                let length = from_centre.length();
                let reach = if meets { length.min(radius) } else { radius };
                if length > 0.0 { centre + from_centre * (reach / length) } else { centre }
            }
        }
    }
}

/// −1, 0 or 1.
fn sign(x: f64) -> f64 {
    if x == 0.0 { 0.0 } else { x.signum() }
}

/// Lambert's formula: (1/2π) Σ Θ Γ over the edges of a polygon seen from the origin, Θ the angle of an edge and Γ the unit
/// normal of the plane through it and the origin; edges without such a plane add nothing. Its product with a normal is the
/// diffuse irradiance from a polygon above the horizon (Lambert 1760; Baum, Rushmeier & Winget, SIGGRAPH 1989).
fn vector_irradiance(polygon: &[DVec3]) -> DVec3 {
    let mut sum = DVec3::ZERO;
    let mut from = polygon.last().copied().unwrap_or_default();
    for &to in polygon {
        // Clockwise seen from the lit side is counter-clockwise seen from the light.
        let cross = to.cross(from);
        let length = cross.length();
        if length > 0.0 {
            sum += cross * (corner_angle(length, from.dot(to)) / length);
        }
        from = to;
    }
    sum / (2.0 * PI)
}

/// The part of a convex polygon above the horizon (Sutherland & Hodgman 1974). Returns its number of corners.
fn clip_at_horizon(polygon: &[DVec3], normal: DVec3, above: &mut [DVec3; MOST_CORNERS]) -> usize {
    let mut count = 0;
    let mut push = |corner| {
        above[count] = corner;
        count += 1;
    };
    let mut from = polygon[polygon.len() - 1];
    let mut from_height = from.dot(normal);
    for &to in polygon {
        let to_height = to.dot(normal);
        if (from_height > 0.0) != (to_height > 0.0) {
            push(from + (to - from) * (from_height / (from_height - to_height)));
        }
        if to_height > 0.0 {
            push(to);
        }
        (from, from_height) = (to, to_height);
    }
    count
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::num::test_numbers::Numbers;

    /// Two units wide, looking down from a height of 0 at what lies below it.
    fn square() -> AreaSource {
        let shape = AreaShape::Rectangle { centre: DVec3::ZERO, u: DVec3::X, v: DVec3::NEG_Y };
        AreaSource::new(&shape, &Frame::default())
    }

    fn below(source: &AreaSource, h: f64) -> f64 {
        source.irradiance(DVec3::new(0.0, 0.0, -h), DVec3::Z)
    }

    #[test]
    fn a_square_overhead_has_its_closed_form() {
        // Four times the corner formula (1/π) A/√(1+A²) atan(A/√(1+A²)), A = 1/h, in twice the precision.
        // The point light of the same power is off by (4/3)/h² in the end.
        let published = [
            (1.0, 0.554_126_423_979_572, 1.297_741_976_6),
            (2.0, 0.239_456_470_460_773_54, 0.329_301_670_5),
            (5.0, 0.048_357_023_469_828_51, 0.053_199_269_4),
            (10.0, 0.012_564_972_493_732_682, 0.013_324_577_8),
            (20.0, 0.003_172_525_532_555_426_3, 0.003_332_779_9),
        ];
        for (h, factor, point_error) in published {
            let got = below(&square(), h);
            // Four edges, each a few roundings of numbers up to 1/4, cancel to no more than they are.
            assert!((got - factor).abs() < 1e-15, "h = {h}: {got}");
            let point = 4.0 / (PI * h * h);
            assert!((point / got - 1.0 - point_error).abs() < 1e-10, "h = {h}: {}", point / got - 1.0);
        }
    }

    #[test]
    fn a_disc_overhead_is_as_close_to_the_round_one_as_promised() {
        let shape = AreaShape::Disc { centre: DVec3::ZERO, normal: DVec3::NEG_Z, radius: 1.0 };
        let disc = AreaSource::new(&shape, &Frame::default());
        let worst = (1..400)
            .map(|i| f64::from(i) / 50.0)
            .map(|h| 1.0 - below(&disc, h) * (1.0 + h * h))
            .fold(0.0, |worst: f64, error| worst.max(error.abs()));
        assert!((1.2e-7..=1.3e-7).contains(&worst), "{worst:e}");
    }

    /// (1/π) ∫ cos θ cos θ' / d² over the square, by the midpoint rule: another way to the same number.
    fn by_summing(source: &AreaSource, point: DVec3, normal: DVec3, n: i32) -> f64 {
        let mut sum = 0.0;
        for i in 0..n {
            for j in 0..n {
                let at = |k: i32| (f64::from(k) + 0.5) / f64::from(n) * 2.0 - 1.0;
                let towards = DVec3::new(at(i), at(j), 0.0) - point;
                let square = towards.length_squared();
                let cosines = towards.dot(normal).max(0.0) * (-towards.dot(source.normal)).max(0.0);
                sum += cosines / (square * square);
            }
        }
        sum * 4.0 / f64::from(n * n) / PI
    }

    #[test]
    fn tilted_and_clipped_squares_agree_with_summing_over_the_light() {
        let source = square();
        let mut numbers = Numbers::new(40);
        let mut clipped = 0;
        for _ in 0..200 {
            let mut within = |a: f64, b: f64| a + (b - a) * numbers.unit();
            let point = DVec3::new(within(-2.0, 2.0), within(-2.0, 2.0), within(-3.0, -0.5));
            let normal = DVec3::new(within(-1.0, 1.0), within(-1.0, 1.0), within(-1.0, 1.0)).normalize();
            let (got, facing) = (source.irradiance(point, normal), source.facing(point));
            let expected = by_summing(&source, point, normal, 200);
            // The midpoint rule's own error where the horizon cuts cells of 1/100.
            assert!((got - expected).abs() < 2e-4, "{point} {normal}: {got}, not {expected}");
            assert!(got <= 1.0 && facing <= 1.0);
            let heights = source.corners.iter().map(|corner| (corner - point).dot(normal));
            let above = heights.filter(|&height| height > 0.0).count();
            clipped += usize::from((1..4).contains(&above));
        }
        assert!(clipped > 30, "{clipped}");
    }

    #[test]
    fn it_shines_to_one_side_and_a_surface_turned_away_gets_nothing() {
        assert_eq!(below(&square(), -1.0), 0.0);
        assert_eq!(square().irradiance(DVec3::NEG_Z, DVec3::NEG_Z), 0.0);
        assert!(square().irradiance(DVec3::NEG_Z, DVec3::X) > 0.05);
    }

    #[test]
    fn the_representative_point_is_where_the_mirrored_ray_meets_the_light() {
        let source = square();
        let point = DVec3::new(0.0, 0.0, -2.0);
        assert_eq!(source.representative(point, DVec3::Z), DVec3::ZERO);
        assert_eq!(source.representative(point, DVec3::new(0.25, 0.0, 1.0)), DVec3::new(0.5, 0.0, 0.0));
        assert_eq!(source.representative(point, DVec3::new(9.0, 0.0, 1.0)), DVec3::X);
        // Away from the light: the rim in the ray's direction.
        assert_eq!(source.representative(point, DVec3::new(0.0, 1.0, -1.0)), DVec3::Y);
        let shape = AreaShape::Disc { centre: DVec3::ZERO, normal: DVec3::NEG_Z, radius: 2.0 };
        let disc = AreaSource::new(&shape, &Frame::default());
        assert_eq!(disc.representative(point, DVec3::new(3.0, 0.0, 1.0)), DVec3::new(2.0, 0.0, 0.0));
        assert_eq!(disc.representative(point, DVec3::NEG_Z), DVec3::ZERO);
    }
}
