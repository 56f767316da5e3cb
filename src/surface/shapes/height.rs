//! Heights over a rectangle of the x-y plane: plane, wave, monkey saddle.

use crate::num::UnitVec3;
use crate::surface::error::{Result, SurfaceError, length, surface_of_lengths};
use crate::surface::rays::ray::Line;
use crate::surface::shapes::chart::{Chart, Parametric, Sample};
use crate::surface::shapes::implicit::{Cast, Implicit};
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
    /// [`SurfaceError::OutOfRange`].
    pub fn new(width: f64, height: f64) -> Result<Self> {
        Ok(Self { size: DVec2::new(length("the width", width)?, length("the height", height)?) })
    }

    /// Width and height.
    pub fn size(&self) -> DVec2 {
        self.size
    }
}

impl Height for Plane {
    fn extent(&self) -> DVec2 {
        self.size
    }

    fn height(&self, _place: DVec2) -> (f64, DVec2) {
        (0.0, DVec2::ZERO)
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

surface_of_lengths! {
    /// The wave z = 0.3 sin 3x cos 3y over |x|, |y| ≤ size/2; by default of size 2.
    ///
    /// Points: x = (u − ½)·size, y = (v − ½)·size. Its [`value`](Implicit::value) is measured along z.
    Wave {
        /// The side of the square.
        size: "the size" = 2.0,
    }
    new with Ok
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

surface_of_lengths! {
    /// The monkey saddle z = x³ − 3xy² over |x|, |y| ≤ size/2; by default of size 2. It is flat to third order in the middle.
    ///
    /// Points: x = (u − ½)·size, y = (v − ½)·size. Its [`value`](Implicit::value) is measured along z.
    MonkeySaddle {
        /// The side of the square.
        size: "the size" = 2.0,
    }
    new with Ok
}

impl Height for MonkeySaddle {
    fn extent(&self) -> DVec2 {
        DVec2::splat(self.size)
    }

    fn height(&self, DVec2 { x, y }: DVec2) -> (f64, DVec2) {
        (x * (x * x - 3.0 * y * y), DVec2::new(3.0 * (x - y) * (x + y), -6.0 * x * y))
    }
}

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

macro_rules! implicit_height {
    ($($surface:ident),*) => {$(
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

implicit_height!(Wave, MonkeySaddle);
