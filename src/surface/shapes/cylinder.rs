//! A tube.

use crate::num::UnitVec3;
use crate::surface::error::{SurfaceError, length};
use crate::surface::rays::ray::{Hit, Line, Ray};
use crate::surface::shapes::chart::{Chart, Parametric, Sample, circle};
use crate::surface::shapes::implicit::{Cast, Implicit, first_hit};
use glam::DVec3;

/// The tube x² + z² = radius², |y| ≤ height/2, open at both ends and facing outward. By default of radius 1 and
/// height 2.
///
/// Points: (radius·sin θ, (v − ½)·height, radius·cos θ) with θ = 2πu.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Cylinder {
    radius: f64,
    height: f64,
}

impl Default for Cylinder {
    fn default() -> Self {
        Self { radius: 1.0, height: 2.0 }
    }
}

impl Cylinder {
    /// A tube about the y axis.
    ///
    /// # Errors
    /// [`SurfaceError::Length`].
    pub fn new(radius: f64, height: f64) -> Result<Self, SurfaceError> {
        Ok(Self { radius: length("the radius", radius)?, height: length("the height", height)? })
    }

    /// The radius.
    pub fn radius(&self) -> f64 {
        self.radius
    }

    /// From end to end.
    pub fn height(&self) -> f64 {
        self.height
    }

    /// The first hit of a ray, on the outside or the inside; rays along the axis have none.
    pub fn intersect(&self, ray: &Ray) -> Option<Hit> {
        first_hit(self, ray)
    }
}

impl Parametric for Cylinder {
    fn chart(&self) -> Chart {
        Chart::TUBE
    }

    fn at(&self, u: f64, v: f64) -> Option<Sample> {
        let (sin, cos) = circle(u);
        let normal = DVec3::new(sin, 0.0, cos);
        let position = normal * self.radius + DVec3::Y * ((v - 0.5) * self.height);
        Some(Sample { position, normal: UnitVec3::new(normal)? })
    }
}

impl Implicit for Cylinder {
    fn value(&self, point: DVec3) -> f64 {
        across(point).length() - self.radius
    }

    fn normal_at(&self, point: DVec3) -> Option<UnitVec3> {
        UnitVec3::new(across(point))
    }
}

impl Cast for Cylinder {
    /// Roots of |p⊥ + s·d⊥|² = radius². By Lagrange's identity the discriminant is (radius·|d⊥|)² − (moment about
    /// the axis)², a difference of squares.
    fn crossings(&self, line: &Line) -> impl Iterator<Item = f64> {
        let speed = across(line.direction).length();
        let (reach, moment) = (self.radius * speed, line.moment.y.abs());
        let discriminant = (reach - moment) * (reach + moment);
        let middle = -across(line.foot).dot(line.direction) / speed;
        let crossing = |sign: f64| (middle + sign * discriminant.sqrt() / speed) / speed;
        (speed > 0.0 && discriminant >= 0.0).then(|| [crossing(-1.0), crossing(1.0)]).into_iter().flatten()
    }

    fn reaches(&self, point: DVec3) -> bool {
        point.y.abs() <= self.height / 2.0
    }
}

/// The part of a vector across the axis.
fn across(v: DVec3) -> DVec3 {
    DVec3::new(v.x, 0.0, v.z)
}
