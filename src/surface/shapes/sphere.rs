//! A sphere.

use crate::num::UnitVec3;
use crate::surface::error::{SurfaceError, length};
use crate::surface::rays::ray::{Hit, Line, Ray};
use crate::surface::shapes::implicit::{Cast, Implicit, first_hit};
use glam::DVec3;

/// The sphere |p| = radius, facing outward. By default of radius 1.
///
/// Points: radius·(cos λ sin θ, sin λ, cos λ cos θ) with θ = 2πu round the y axis and latitude λ = π(v − ½).
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Sphere {
    radius: f64,
}

impl Default for Sphere {
    fn default() -> Self {
        Self { radius: 1.0 }
    }
}

impl Sphere {
    /// A sphere of this radius about the origin.
    ///
    /// # Errors
    /// [`SurfaceError::Length`].
    pub fn new(radius: f64) -> Result<Self, SurfaceError> {
        Ok(Self { radius: length("the radius", radius)? })
    }

    /// The radius.
    pub fn radius(&self) -> f64 {
        self.radius
    }

    /// The first hit of a ray.
    pub fn intersect(&self, ray: &Ray) -> Option<Hit> {
        first_hit(self, ray)
    }
}

impl Implicit for Sphere {
    fn value(&self, point: DVec3) -> f64 {
        point.length() - self.radius
    }

    fn normal_at(&self, point: DVec3) -> Option<UnitVec3> {
        UnitVec3::new(point)
    }
}

impl Cast for Sphere {
    fn crossings(&self, line: &Line) -> impl Iterator<Item = f64> {
        let distance = line.moment.length();
        let squared = (self.radius - distance) * (self.radius + distance);
        (squared >= 0.0).then(|| [-squared.sqrt(), squared.sqrt()]).into_iter().flatten()
    }
}
