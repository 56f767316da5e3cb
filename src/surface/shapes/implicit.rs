//! Surfaces as zero sets, and casting rays at them.

use crate::num::UnitVec3;
use crate::surface::rays::ray::{Hit, Line, Ray};
use glam::DVec3;

/// A surface that is the zero set of a function of space.
pub trait Implicit: Sync {
    /// A length that is negative inside (or behind), zero on the surface and positive outside. It is the signed
    /// distance from the surface continued without its ends, unless the surface says otherwise.
    fn value(&self, point: DVec3) -> f64;

    /// The direction in which [`value`](Self::value) grows fastest: on the surface, its exact normal, outward or to the
    /// front. `None` where there is no such direction: on the axis of a cylinder, in the centre of a sphere.
    fn normal_at(&self, point: DVec3) -> Option<UnitVec3>;
}

/// What the search for a ray's first hit asks of a surface whose [`value`](Implicit::value) is a distance.
pub(in crate::surface) trait Cast: Implicit {
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
}

/// The first hit of a ray.
pub(in crate::surface) fn first_hit(surface: &impl Cast, ray: &Ray) -> Option<Hit> {
    let centre = surface.centre();
    let line = Line::new(ray, centre);
    surface.crossings(&line).find_map(|s| {
        let t = line.parameter(s)?;
        let near = centre + line.at(s);
        if !surface.reaches(near) {
            return None;
        }
        let normal = surface.normal_at(near)?;
        let position = near - normal.get() * surface.value(near);
        Some(Hit { t, position, normal, front: line.direction.dot(normal.get()) < 0.0 })
    })
}
