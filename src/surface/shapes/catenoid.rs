//! A catenoid.

use crate::num::UnitVec3;
use crate::surface::error::{SurfaceError, length};
use crate::surface::shapes::chart::{Chart, Parametric, Sample, circle};
use crate::surface::shapes::implicit::Implicit;
use glam::{DVec2, DVec3};

/// Tallest catenoid in waists: beyond it the ends would be 10⁴⁰ times as wide as the waist.
const TALLEST: f64 = 200.0;

/// The catenoid √(x² + z²) = waist·cosh(y/waist), |y| ≤ height/2: the film between two rings, whose mean curvature is
/// zero. Faces away from the axis. By default of waist 0.5 and height 1.5.
///
/// Points: (waist·cosh t·sin θ, waist·t, waist·cosh t·cos θ) with θ = 2πu and t = (v − ½)·height/waist. Its
/// [`value`](Implicit::value) is measured towards the axis, across which it is a little more than the distance.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Catenoid {
    waist: f64,
    height: f64,
}

impl Default for Catenoid {
    fn default() -> Self {
        Self { waist: 0.5, height: 1.5 }
    }
}

impl Catenoid {
    /// A catenoid about the y axis.
    ///
    /// # Errors
    /// [`SurfaceError::Length`], [`SurfaceError::TooTall`].
    pub fn new(waist: f64, height: f64) -> Result<Self, SurfaceError> {
        let catenoid = Self { waist: length("the waist", waist)?, height: length("the height", height)? };
        let found = height / waist;
        if found <= TALLEST { Ok(catenoid) } else { Err(SurfaceError::TooTall { found }) }
    }

    /// The smallest radius.
    pub fn waist(&self) -> f64 {
        self.waist
    }

    /// From end to end.
    pub fn height(&self) -> f64 {
        self.height
    }

    /// The radius of the rings at the ends.
    pub fn widest(&self) -> f64 {
        self.waist * libm::cosh(0.5 * self.height / self.waist)
    }
}

impl Parametric for Catenoid {
    fn chart(&self) -> Chart {
        Chart::TUBE
    }

    fn at(&self, u: f64, v: f64) -> Option<Sample> {
        let ((sin, cos), y) = (circle(u), (v - 0.5) * self.height);
        let t = y / self.waist;
        let radius = self.waist * libm::cosh(t);
        // The gradient (1, −sinh t) by cosh t: no number grows.
        let (out, up) = (1.0 / libm::cosh(t), -libm::tanh(t));
        Some(Sample {
            position: DVec3::new(radius * sin, y, radius * cos),
            normal: UnitVec3::new(DVec3::new(out * sin, up, out * cos))?,
        })
    }
}

impl Implicit for Catenoid {
    fn value(&self, point: DVec3) -> f64 {
        DVec2::new(point.x, point.z).length() - self.waist * libm::cosh(point.y / self.waist)
    }

    fn normal_at(&self, point: DVec3) -> Option<UnitVec3> {
        let across = UnitVec3::new(DVec3::new(point.x, 0.0, point.z))?;
        let t = point.y / self.waist;
        UnitVec3::new(across.get() / libm::cosh(t) - DVec3::Y * libm::tanh(t))
    }
}
