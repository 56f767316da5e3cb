//! Surfaces as zero sets, and the first hits of rays on them.

use crate::num::UnitVec3;
use crate::surface::rays::ray::{Hit, Line, Ray};
use crate::surface::shapes::chart::Parametric;
use glam::DVec3;

/// A surface that is the zero set of a function of space.
pub trait Implicit: Sync {
    /// A length: negative inside or behind, zero on the surface, positive outside. It is the signed distance from the
    /// surface continued without its ends, unless the documentation of the surface says otherwise.
    fn value(&self, point: DVec3) -> f64;

    /// The direction in which [`value`](Self::value) grows fastest: on the surface, its exact normal, outward or to the
    /// front. `None` where there is no such direction: on the axis of a cylinder, in the centre of a sphere.
    fn normal_at(&self, point: DVec3) -> Option<UnitVec3>;
}

/// A zero set that also has parameters.
pub(crate) trait Shape: Parametric + Implicit {}

impl<S: Parametric + Implicit> Shape for S {}

/// The box that a zero set fills.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Room {
    pub(crate) low: DVec3,
    pub(crate) high: DVec3,
    /// The axes along which the surface ends at the box, open; else it closes within.
    pub(crate) ends: [bool; 3],
}

/// A surface whose [`value`](Implicit::value) is a distance and whose crossings with a line are known.
pub(crate) trait Cast: Implicit {
    /// The point that lines are described from.
    fn centre(&self) -> DVec3 {
        DVec3::ZERO
    }

    /// Where a line meets the surface continued without its ends, ascending.
    fn crossings(&self, line: &Line) -> impl Iterator<Item = f64>;

    /// Whether the surface itself reaches this point of its continuation.
    fn reaches(&self, _point: DVec3) -> bool {
        true
    }

    /// The first hit of a ray, on either side.
    fn first_hit(&self, ray: &Ray) -> Option<Hit> {
        let centre = self.centre();
        let line = Line::new(ray, centre);
        self.crossings(&line).find_map(|s| {
            let t = line.parameter(s)?;
            let near = centre + line.at(s);
            if !self.reaches(near) {
                return None;
            }
            let normal = self.normal_at(near)?;
            let position = near - normal.get() * self.value(near);
            Some(Hit { t, position, normal, front: line.direction.dot(normal.get()) < 0.0 })
        })
    }
}
