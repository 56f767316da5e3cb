//! Heights over a square of the x-y plane.

use crate::num::UnitVec3;
use crate::surface::error::{SurfaceError, length};
use crate::surface::shapes::chart::{Chart, Parametric, Sample};
use crate::surface::shapes::implicit::Implicit;
use crate::surface::shapes::plane::Plane;
use glam::{DVec2, DVec3};

/// A surface z = f(x, y) over a rectangle about the origin, facing +z.
pub trait Height: Sync {
    /// Width and height of the rectangle.
    fn extent(&self) -> DVec2;

    /// f and its two slopes.
    fn height(&self, place: DVec2) -> (f64, DVec2);

    /// The point above a place, with the normal (−∂f/∂x, −∂f/∂y, 1).
    fn above(&self, place: DVec2) -> Option<Sample> {
        let (height, slope) = self.height(place);
        Some(Sample { position: place.extend(height), normal: UnitVec3::new((-slope).extend(1.0))? })
    }
}

impl Height for Plane {
    fn extent(&self) -> DVec2 {
        self.size()
    }

    fn height(&self, _place: DVec2) -> (f64, DVec2) {
        (0.0, DVec2::ZERO)
    }
}

/// The wave z = 0.3 sin 3x cos 3y over |x|, |y| ≤ size/2; by default of size 2.
///
/// Points: x = (u − ½)·size, y = (v − ½)·size. Its [`value`](Implicit::value) is measured along z.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Wave {
    size: f64,
}

/// The monkey saddle z = x³ − 3xy² over |x|, |y| ≤ size/2; by default of size 2. It is flat to third order in the middle.
///
/// Points: x = (u − ½)·size, y = (v − ½)·size. Its [`value`](Implicit::value) is measured along z.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct MonkeySaddle {
    size: f64,
}

impl Height for Wave {
    fn extent(&self) -> DVec2 {
        DVec2::splat(self.size)
    }

    fn height(&self, DVec2 { x, y }: DVec2) -> (f64, DVec2) {
        let ((sin_x, cos_x), (sin_y, cos_y)) = (libm::sincos(3.0 * x), libm::sincos(3.0 * y));
        (0.3 * sin_x * cos_y, DVec2::new(0.9 * cos_x * cos_y, -0.9 * sin_x * sin_y))
    }
}

impl Height for MonkeySaddle {
    fn extent(&self) -> DVec2 {
        DVec2::splat(self.size)
    }

    fn height(&self, DVec2 { x, y }: DVec2) -> (f64, DVec2) {
        (x * (x * x - 3.0 * y * y), DVec2::new(3.0 * (x - y) * (x + y), -6.0 * x * y))
    }
}

macro_rules! square {
    ($($surface:ident),*) => {$(
        impl Default for $surface {
            fn default() -> Self {
                Self { size: 2.0 }
            }
        }

        impl $surface {
            /// The surface over a square of this size.
            ///
            /// # Errors
            /// [`SurfaceError::Length`].
            pub fn new(size: f64) -> Result<Self, SurfaceError> {
                Ok(Self { size: length("the size", size)? })
            }
        }

        impl Implicit for $surface {
            fn value(&self, point: DVec3) -> f64 {
                point.z - self.height(point.truncate()).0
            }

            fn normal_at(&self, point: DVec3) -> Option<UnitVec3> {
                Some(self.above(point.truncate())?.normal)
            }
        }
    )*};
}

square!(Wave, MonkeySaddle);

macro_rules! over_rectangle {
    ($($surface:ident),*) => {$(
        impl Parametric for $surface {
            fn chart(&self) -> Chart {
                Chart::SHEET
            }

            fn at(&self, u: f64, v: f64) -> Option<Sample> {
                self.above((DVec2::new(u, v) - 0.5) * self.extent())
            }
        }
    )*};
}

over_rectangle!(Plane, Wave, MonkeySaddle);
