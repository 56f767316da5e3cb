//! A rectangle.

use crate::num::UnitVec3;
use crate::surface::error::{SurfaceError, length};
use crate::surface::rays::ray::{Hit, Line, Ray};
use crate::surface::shapes::implicit::{Cast, Implicit, first_hit};
use glam::{DVec2, DVec3};

/// The rectangle z = 0, |x| ≤ width/2, |y| ≤ height/2, whose front is +z. By default 2 × 2.
///
/// Points: ((u − ½)·width, (v − ½)·height, 0).
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Plane {
    size: DVec2,
}

impl Default for Plane {
    fn default() -> Self {
        Self { size: DVec2::splat(2.0) }
    }
}

impl Plane {
    /// A rectangle of this width (along x) and height (along y).
    ///
    /// # Errors
    /// [`SurfaceError::Length`].
    pub fn new(width: f64, height: f64) -> Result<Self, SurfaceError> {
        Ok(Self { size: DVec2::new(length("the width", width)?, length("the height", height)?) })
    }

    /// Width and height.
    pub fn size(&self) -> DVec2 {
        self.size
    }

    /// The first hit of a ray; rays within the plane have none.
    pub fn intersect(&self, ray: &Ray) -> Option<Hit> {
        first_hit(self, ray)
    }
}

impl Implicit for Plane {
    fn value(&self, point: DVec3) -> f64 {
        point.z
    }

    fn normal_at(&self, _point: DVec3) -> Option<UnitVec3> {
        UnitVec3::new(DVec3::Z)
    }
}

impl Cast for Plane {
    fn crossings(&self, line: &Line) -> impl Iterator<Item = f64> {
        (line.direction.z != 0.0).then(|| -line.foot.z / line.direction.z).into_iter()
    }

    fn reaches(&self, point: DVec3) -> bool {
        point.truncate().abs().cmple(self.size / 2.0).all()
    }
}
