//! A cone.

use crate::num::UnitVec3;
use crate::surface::error::{SurfaceError, length};
use crate::surface::rays::ray::{Hit, Line, Ray};
use crate::surface::shapes::chart::{Chart, Parametric, Sample, circle};
use crate::surface::shapes::implicit::{Cast, Implicit, first_hit};
use glam::{DVec2, DVec3};

/// The cone whose base is the circle of a radius at y = −height/2 and whose tip is at y = +height/2; open at the base
/// and facing outward. By default of radius 1 and height 2.
///
/// Points: ((1 − v)·radius·sin θ, (v − ½)·height, (1 − v)·radius·cos θ) with θ = 2πu. At the tip the surface has no normal; what
/// is given there, and on all of the axis, is the limit of the mean over ever smaller circles: +y.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Cone {
    radius: f64,
    height: f64,
}

impl Default for Cone {
    fn default() -> Self {
        Self { radius: 1.0, height: 2.0 }
    }
}

impl Cone {
    /// A cone about the y axis.
    ///
    /// # Errors
    /// [`SurfaceError::Length`].
    pub fn new(radius: f64, height: f64) -> Result<Self, SurfaceError> {
        Ok(Self { radius: length("the radius", radius)?, height: length("the height", height)? })
    }

    /// The radius of the base.
    pub fn radius(&self) -> f64 {
        self.radius
    }

    /// From the base to the tip.
    pub fn height(&self) -> f64 {
        self.height
    }

    /// The first hit of a ray, on the outside or the inside.
    pub fn intersect(&self, ray: &Ray) -> Option<Hit> {
        first_hit(self, ray)
    }

    /// The normal in the half-plane of (distance from the axis, y): the same for the whole generator.
    fn profile_normal(&self) -> DVec2 {
        let longest = self.radius.max(self.height);
        (DVec2::new(self.height, self.radius) / longest).normalize()
    }
}

impl Parametric for Cone {
    fn chart(&self) -> Chart {
        Chart { pole_high: true, ..Chart::TUBE }
    }

    fn at(&self, u: f64, v: f64) -> Option<Sample> {
        let ((sin, cos), y) = (circle(u), (v - 0.5) * self.height);
        let radius = (1.0 - v) * self.radius;
        let position = DVec3::new(radius * sin, y, radius * cos);
        Some(Sample { position, normal: self.normal_at(position)? })
    }
}

impl Implicit for Cone {
    fn value(&self, point: DVec3) -> f64 {
        let (rho, y) = (DVec2::new(point.x, point.z).length(), point.y - self.height / 2.0);
        self.profile_normal().dot(DVec2::new(rho, y))
    }

    fn normal_at(&self, point: DVec3) -> Option<UnitVec3> {
        let Some(across) = UnitVec3::new(DVec3::new(point.x, 0.0, point.z)) else {
            return UnitVec3::new(DVec3::Y);
        };
        let profile = self.profile_normal();
        UnitVec3::new(across.get() * profile.x + DVec3::Y * profile.y)
    }
}

impl Cast for Cone {
    /// The tip, in which the cone's equation has no linear and no constant term.
    fn centre(&self) -> DVec3 {
        DVec3::Y * (self.height / 2.0)
    }

    /// Roots of h²(x² + z²) − r²y² = 0 with slopes h and r as a unit vector. The discriminant B² − AC is
    /// r²h²(Lx² + Lz²) − h⁴Ly² in terms of the line's moment L: a difference of squares again.
    fn crossings(&self, line: &Line) -> impl Iterator<Item = f64> {
        let DVec2 { x: h, y: r } = self.profile_normal();
        let form = |p: DVec3, q: DVec3| h * h * (p.x * q.x + p.z * q.z) - r * r * (p.y * q.y);
        let (foot, direction, moment) = (line.foot, line.direction, line.moment);
        let (a, b, c) = (form(direction, direction), form(foot, direction), form(foot, foot));
        let (tilted, turned) = (r * DVec2::new(moment.x, moment.z).length(), h * moment.y.abs());
        let root = h * ((tilted - turned) * (tilted + turned)).sqrt();
        // The larger root has no cancellation; the other one follows from their product. The cone has one crossing
        // only with a line along a generator, and with one through the tip.
        let sum = -(b + root.copysign(b));
        let [one, other] = [sum / a, if sum == 0.0 { 0.0 } else { c / sum }];
        let crossings = [one.min(other), one.max(other)];
        crossings.into_iter().filter(|s| s.is_finite())
    }

    fn reaches(&self, point: DVec3) -> bool {
        point.y.abs() <= self.height / 2.0
    }
}
