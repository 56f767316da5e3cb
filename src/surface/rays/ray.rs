//! Rays, their hits, and their lines.

use crate::num::{self, Split, UnitVec3, unit_scale};
use glam::DVec3;

/// Largest coordinate of a ray's origin: squares of it, times squares of a direction, stay in range.
const FURTHEST: f64 = 1e90;

/// A half-line: all points origin + t·direction with t > 0.
///
/// The direction may have any length but zero; parameters `t` are in units of that length. A linear map of ray and
/// surface does not change them.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Ray {
    origin: DVec3,
    direction: DVec3,
}

impl Ray {
    /// A ray; `None` if the direction is zero, or a coordinate is not finite or beyond 1e90.
    pub fn new(origin: DVec3, direction: DVec3) -> Option<Self> {
        let in_range = |v: DVec3| v.is_finite() && v.abs().max_element() <= FURTHEST;
        (in_range(origin) && in_range(direction) && direction != DVec3::ZERO)
            .then_some(Self { origin, direction })
    }

    /// The start of the ray.
    pub fn origin(&self) -> DVec3 {
        self.origin
    }

    /// The direction, of any length.
    pub fn direction(&self) -> DVec3 {
        self.direction
    }

    /// The ray under a linear map, which keeps the parameters of its points.
    pub(crate) fn mapped(&self, map: impl Fn(DVec3) -> DVec3) -> Self {
        Self { origin: map(self.origin), direction: map(self.direction) }
    }

    /// The point origin + t·direction.
    pub fn at(&self, t: f64) -> DVec3 {
        self.origin + self.direction * t
    }
}

/// The first point at which a ray meets a surface.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Hit {
    /// The ray's parameter, above 0.
    pub t: f64,
    /// The point, moved onto the surface: it satisfies the surface's equation better than [`ray.at(t)`](Ray::at).
    pub position: DVec3,
    /// The surface's own normal there: outward, or that of the front; not flipped towards the ray.
    pub normal: UnitVec3,
    /// Whether the ray comes from the side that the normal points to.
    pub front: bool,
}

/// The line of a ray relative to a centre, so that a far ray has no error but that of its coordinates. Its points are
/// foot + s·direction; s is a length.
pub(crate) struct Line {
    /// The point closest to the centre.
    pub(crate) foot: DVec3,
    /// A unit vector.
    pub(crate) direction: DVec3,
    /// point × direction for any point of the line: its length is the distance from the centre.
    pub(crate) moment: DVec3,
    /// The s of the ray's origin.
    start: f64,
    /// The length of the ray's direction: t = (s − start)/speed.
    speed: f64,
}

impl Line {
    /// The line of a ray, seen from a centre.
    ///
    /// The moment's products cancel if a far ray passes nearby; as exact differences of products its components keep a relative
    /// error of 2u, and so does the foot, direction × moment. (The foot of E. Haines et al., *Precision improvements
    /// for ray/sphere intersection*, Ray Tracing Gems, 2019, has an error of u times the distance.)
    pub(crate) fn new(ray: &Ray, centre: DVec3) -> Self {
        let origin = ray.origin - centre;
        // A power of two keeps all digits of the direction: dividing by its length would rotate the line a little.
        let scale = unit_scale(ray.direction.abs().max_element());
        let scaled = ray.direction * scale;
        let (direction, length) = num::direction(scaled);
        let moment = num::cross::<Split>(origin, scaled) / length;
        Self {
            foot: direction.cross(moment),
            direction,
            moment,
            start: origin.dot(scaled) / length,
            speed: length / scale,
        }
    }

    pub(crate) fn at(&self, s: f64) -> DVec3 {
        self.foot + self.direction * s
    }

    /// The ray's parameter of a point in front of its origin.
    pub(crate) fn parameter(&self, s: f64) -> Option<f64> {
        let t = (s - self.start) / self.speed;
        (t > 0.0).then_some(t)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::num::test_numbers::Numbers;

    #[test]
    fn rays_need_a_direction_and_finite_numbers() {
        assert!(Ray::new(DVec3::ZERO, DVec3::new(0.0, 1e-300, 0.0)).is_some());
        for (origin, direction) in [
            (DVec3::ZERO, DVec3::ZERO),
            (DVec3::NAN, DVec3::X),
            (DVec3::ZERO, DVec3::INFINITY),
            (DVec3::splat(1e91), DVec3::X),
        ] {
            assert_eq!(Ray::new(origin, direction), None);
        }
    }

    #[test]
    fn the_foot_of_a_far_ray_keeps_its_digits() {
        let mut numbers = Numbers::new(31);
        let mut worst_usual = 0.0;
        for _ in 0..2000 {
            let point =
                DVec3::from_array(std::array::from_fn(|_| (numbers.unit() * 1024.0).floor() / 1024.0));
            let direction =
                DVec3::from_array(std::array::from_fn(|_| (numbers.unit() * 64.0).floor() - 32.0));
            if direction.cross(point).length() < 0.1 {
                continue;
            }
            // So few bits that the far origin is exact: both rays run on the same line.
            let far = Ray::new(point - direction * libm::ldexp(1.0, 30), direction).unwrap();
            let near = Ray::new(point, direction).unwrap();
            let (far, near) = (Line::new(&far, DVec3::ZERO), Line::new(&near, DVec3::ZERO));
            // Moment and unit direction: a few roundings each of numbers up to √3.
            let error = (far.foot - near.foot).length();
            assert!(error <= 16.0 * f64::EPSILON, "{error:e}");
            let shifted = point - direction * libm::ldexp(1.0, 30);
            let usual = shifted - direction * (shifted.dot(direction) / direction.length_squared());
            worst_usual = f64::max(worst_usual, (usual - near.foot).length());
        }
        assert!(worst_usual > 1e-7, "the rays are too easy: {worst_usual:e}");
    }
}
