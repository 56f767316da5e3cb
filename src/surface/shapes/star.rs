//! Closed surfaces that every ray from the origin meets once: sphere, ellipsoid, superellipsoid.

use crate::num::UnitVec3;
use crate::surface::error::{Result, SurfaceError, length, out_of_range, surface_of_lengths};
use crate::surface::rays::ray::{Hit, Line, Ray};
use crate::surface::shapes::chart::{Chart, Parametric, Sample, on_sphere};
use crate::surface::shapes::implicit::{Cast, Implicit};
use glam::DVec3;

/// A closed surface that each ray from the origin meets once: directions map to its points.
pub trait StarShaped: Sync {
    /// The point of the surface in a direction of any length but zero. For a stretched surface it is the direction
    /// before stretching.
    fn along(&self, direction: DVec3) -> Option<Sample>;
}

surface_of_lengths! {
    /// The sphere |p| = radius, facing outward. By default of radius 1.
    ///
    /// Points: radius·(cos λ sin θ, sin λ, cos λ cos θ) with θ = 2πu around the y axis and latitude λ = π(v − ½).
    Sphere {
        /// The radius.
        radius: "the radius" = 1.0,
    }
    new with Ok
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

impl StarShaped for Sphere {
    fn along(&self, direction: DVec3) -> Option<Sample> {
        let normal = UnitVec3::new(direction)?;
        Some(Sample { position: normal.get() * self.radius, normal })
    }
}

/// The ellipsoid (x/a)² + (y/b)² + (z/c)² = 1, facing outward. By default (a, b, c) = (1, 0.6, 0.4).
///
/// Points: those of the unit [`Sphere`], times (a, b, c). Its [`value`](Implicit::value), a lower bound of the distance, is that
/// of the unit sphere at p/(a, b, c), times the shortest semi-axis.
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
    /// [`SurfaceError::OutOfRange`].
    pub fn new(semi_axes: DVec3) -> Result<Self> {
        Ok(Self { semi_axes: checked(semi_axes)? })
    }

    /// The semi-axes along x, y and z.
    pub fn semi_axes(&self) -> DVec3 {
        self.semi_axes
    }

    /// The first hit of a ray: that of the unit sphere with the ray divided by the semi-axes, at the same parameter.
    pub(crate) fn first_hit(&self, ray: &Ray) -> Option<Hit> {
        let hit = Sphere::default().first_hit(&ray.mapped(|v| v / self.semi_axes))?;
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

impl StarShaped for Ellipsoid {
    fn along(&self, direction: DVec3) -> Option<Sample> {
        let unit = UnitVec3::new(direction)?.get();
        let relative = self.semi_axes / self.semi_axes.min_element();
        Some(Sample { position: unit * self.semi_axes, normal: UnitVec3::new(unit / relative)? })
    }
}

/// The superellipsoid (|x/a|^(2/e) + |z/c|^(2/e))^(e/n) + |y/b|^(2/n) = 1, with roundness n from north to south and e from
/// east to west: below 1 towards a box, 1 an ellipsoid, above 1 towards an octahedron (A. H. Barr, *Superquadrics and
/// angle-preserving transformations*, IEEE CG&A 1(1), 1981). By default (a, b, c) = (1, 1, 1) and n = e = 0.5.
///
/// Points lie on rays from the origin, in the directions of the unit [`Sphere`], which spaces them more evenly than
/// Barr's parameters. If an exponent is below 1, the surface has six flat spots, on the axes. If it is above 1, the
/// curvature there is unbounded, but the normal has a limit. The [`value`](Implicit::value) is not a distance: it is
/// the ratio of the point's radius to that of the surface in the same direction, less 1, times the shortest semi-axis.
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
    /// A superellipsoid by its semi-axes and its two exponents of roundness, each from 0.1 to 1.9. In this range the
    /// surface has a normal everywhere; at 0 it would be a box and at 2 an octahedron, which have edges.
    ///
    /// # Errors
    /// [`SurfaceError::OutOfRange`].
    pub fn new(semi_axes: DVec3, north: f64, east: f64) -> Result<Self> {
        let semi_axes = checked(semi_axes)?;
        match [north, east].into_iter().find(|exponent| !(0.1..=1.9).contains(exponent)) {
            Some(found) => Err(out_of_range("the roundness", found, "a number from 0.1 to 1.9")),
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

    /// The norm of p with the unstretched surface as unit sphere, and its gradient but for a positive factor. It is a
    /// norm of a norm: first over x and z, then over the result and y.
    fn norm(&self, p: DVec3) -> (f64, DVec3) {
        let (flat, slope) = power_norm(p.x, p.z, 2.0 / self.east);
        let (norm, outer) = power_norm(flat, p.y, 2.0 / self.north);
        (norm, DVec3::new(outer.0 * slope.0, outer.1, outer.0 * slope.1))
    }
}

/// (|x|^k + |y|^k)^(1/k) and its gradient, by quotients that stay in range; 0 and no gradient at the origin.
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

fn checked(semi_axes: DVec3) -> Result<DVec3> {
    semi_axes.to_array().into_iter().try_for_each(|axis| length("a semi-axis", axis).map(drop))?;
    Ok(semi_axes)
}

macro_rules! by_direction {
    ($($surface:ident),*) => {$(
        impl Parametric for $surface {
            fn chart(&self) -> Chart {
                Chart::BALL
            }

            fn at(&self, u: f64, v: f64) -> Option<Sample> {
                self.along(on_sphere(u, v))
            }
        }
    )*};
}

by_direction!(Sphere, Ellipsoid, Superquadric);
