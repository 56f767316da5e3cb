//! A superellipsoid.

use crate::num::UnitVec3;
use crate::surface::error::{SurfaceError, length};
use crate::surface::shapes::chart::Sample;
use crate::surface::shapes::implicit::Implicit;
use crate::surface::shapes::star::StarShaped;
use glam::DVec3;
use std::ops::RangeInclusive;

/// Exponents of roundness that leave a surface with a normal everywhere and numbers to compute it with.
pub(in crate::surface) const ROUNDNESS: RangeInclusive<f64> = 0.1..=1.9;

/// The superellipsoid (|x/a|^(2/e) + |z/c|^(2/e))^(e/n) + |y/b|^(2/n) = 1, with roundness n from north to south and e from
/// east to west: below 1 towards a box, 1 an ellipsoid, above 1 towards an octahedron (A. H. Barr, *Superquadrics and
/// angle-preserving transformations*, IEEE CG&A 1(1), 1981). By default (a, b, c) = (1, 1, 1) and n = e = 0.5.
///
/// Points lie on rays from the middle, in the direction that the unit [`Sphere`](crate::surface::Sphere) has there: more evenly
/// than by Barr's own parameters. Where an exponent is below 1, six flat spots lie on the axes; where it is above 1, the
/// curvature there has no bound, though the normal has a limit. The [`value`](Implicit::value) is not a distance: it is
/// how much longer the radius is than that of the surface, times the shortest semi-axis.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Superquadric {
    semi_axes: DVec3,
    north: f64,
    east: f64,
}

impl Default for Superquadric {
    fn default() -> Self {
        Self { semi_axes: DVec3::ONE, north: 0.5, east: 0.5 }
    }
}

impl Superquadric {
    /// A superellipsoid by its semi-axes and its two exponents of roundness, each from 0.1 to 1.9.
    ///
    /// # Errors
    /// [`SurfaceError::Length`], [`SurfaceError::Roundness`].
    pub fn new(semi_axes: DVec3, north: f64, east: f64) -> Result<Self, SurfaceError> {
        for axis in semi_axes.to_array() {
            length("a semi-axis", axis)?;
        }
        match [north, east].into_iter().find(|exponent| !ROUNDNESS.contains(exponent)) {
            Some(found) => Err(SurfaceError::Roundness { found }),
            None => Ok(Self { semi_axes, north, east }),
        }
    }

    /// The semi-axes along x, y and z.
    pub fn semi_axes(&self) -> DVec3 {
        self.semi_axes
    }

    /// The roundness from north to south and that from east to west.
    pub fn roundness(&self) -> [f64; 2] {
        [self.north, self.east]
    }

    /// |p| in the norm whose unit ball the surface bounds before stretching, and the gradient of that norm but for a
    /// positive factor. A norm of a norm: first over x and z, then over that and y.
    fn norm(&self, p: DVec3) -> (f64, DVec3) {
        let (flat, slope) = power_norm(p.x, p.z, 2.0 / self.east);
        let (norm, outer) = power_norm(flat, p.y, 2.0 / self.north);
        (norm, DVec3::new(outer.0 * slope.0, outer.1, outer.0 * slope.1))
    }
}

/// (|x|^k + |y|^k)^(1/k) and its gradient, in terms of quotients, so that nothing leaves the range of numbers. At the
/// origin 0 and no gradient.
fn power_norm(x: f64, y: f64, k: f64) -> (f64, (f64, f64)) {
    let largest = x.abs().max(y.abs());
    if largest == 0.0 {
        return (0.0, (0.0, 0.0));
    }
    let (x, y) = (x / largest, y / largest);
    let norm = libm::pow(libm::pow(x.abs(), k) + libm::pow(y.abs(), k), 1.0 / k);
    let slope = |x: f64| libm::pow(x.abs() / norm, k - 1.0).copysign(x);
    (largest * norm, (slope(x), slope(y)))
}

impl Implicit for Superquadric {
    fn value(&self, point: DVec3) -> f64 {
        (self.norm(point / self.semi_axes).0 - 1.0) * self.semi_axes.min_element()
    }

    fn normal_at(&self, point: DVec3) -> Option<UnitVec3> {
        let relative = self.semi_axes / self.semi_axes.min_element();
        UnitVec3::new(self.norm(point / self.semi_axes).1 / relative)
    }
}

impl StarShaped for Superquadric {
    fn along(&self, direction: DVec3) -> Option<Sample> {
        let unit = UnitVec3::new(direction)?.get();
        let position = unit / self.norm(unit).0 * self.semi_axes;
        Some(Sample { position, normal: self.normal_at(position)? })
    }
}
