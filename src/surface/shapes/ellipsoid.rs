//! An ellipsoid.

use crate::num::UnitVec3;
use crate::surface::error::{SurfaceError, length};
use crate::surface::rays::ray::{Hit, Ray};
use crate::surface::shapes::implicit::Implicit;
use crate::surface::shapes::sphere::Sphere;
use glam::DVec3;

/// The ellipsoid (x/a)² + (y/b)² + (z/c)² = 1, facing outward. By default (a, b, c) = (1, 0.6, 0.4).
///
/// Points: those of the unit [`Sphere`], times (a, b, c). Its [`value`](Implicit::value) is not the distance but
/// never more than it: what the unit sphere has at p/(a, b, c), times the shortest semi-axis.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Ellipsoid {
    semi_axes: DVec3,
}

impl Default for Ellipsoid {
    fn default() -> Self {
        Self { semi_axes: DVec3::new(1.0, 0.6, 0.4) }
    }
}

impl Ellipsoid {
    /// An ellipsoid with these semi-axes along x, y and z.
    ///
    /// # Errors
    /// [`SurfaceError::Length`].
    pub fn new(semi_axes: DVec3) -> Result<Self, SurfaceError> {
        for axis in semi_axes.to_array() {
            length("a semi-axis", axis)?;
        }
        Ok(Self { semi_axes })
    }

    /// The semi-axes along x, y and z.
    pub fn semi_axes(&self) -> DVec3 {
        self.semi_axes
    }

    /// The first hit of a ray: that of the unit sphere and the ray, both divided by the semi-axes, which leaves the
    /// ray's parameter what it is.
    pub fn intersect(&self, ray: &Ray) -> Option<Hit> {
        let scaled = ray.mapped(|v| v / self.semi_axes);
        let hit = Sphere::default().intersect(&scaled)?;
        let position = hit.position * self.semi_axes;
        Some(Hit { position, normal: self.normal_at(position)?, ..hit })
    }
}

impl Implicit for Ellipsoid {
    fn value(&self, point: DVec3) -> f64 {
        Sphere::default().value(point / self.semi_axes) * self.semi_axes.min_element()
    }

    fn normal_at(&self, point: DVec3) -> Option<UnitVec3> {
        // By the shortest axis first: squares of extreme axes would leave the range.
        let relative = self.semi_axes / self.semi_axes.min_element();
        UnitVec3::new(point / relative / relative)
    }
}
