//! Surfaces that every ray from the origin meets once.

use crate::num::UnitVec3;
use crate::surface::shapes::chart::{Chart, Parametric, Sample, on_sphere};
use crate::surface::shapes::ellipsoid::Ellipsoid;
use crate::surface::shapes::sphere::Sphere;
use crate::surface::shapes::superquadric::Superquadric;
use glam::DVec3;

/// A closed surface that each ray from the origin meets once: what is known of the sphere of directions carries over.
pub trait StarShaped: Sync {
    /// Where the surface is in a direction of any length but zero. For stretched surfaces the direction counts before
    /// stretching.
    fn along(&self, direction: DVec3) -> Option<Sample>;
}

impl StarShaped for Sphere {
    fn along(&self, direction: DVec3) -> Option<Sample> {
        let normal = UnitVec3::new(direction)?;
        Some(Sample { position: normal.get() * self.radius(), normal })
    }
}

impl StarShaped for Ellipsoid {
    fn along(&self, direction: DVec3) -> Option<Sample> {
        let unit = UnitVec3::new(direction)?.get();
        let relative = self.semi_axes() / self.semi_axes().min_element();
        Some(Sample { position: unit * self.semi_axes(), normal: UnitVec3::new(unit / relative)? })
    }
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
