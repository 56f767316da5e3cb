//! All surfaces as one type.

use crate::surface::rays::primitive::Primitive;
use crate::surface::shapes::bezier::{BezierPatch, teapot};
use crate::surface::shapes::chart::Parametric;
use crate::surface::shapes::height::{Height, MonkeySaddle, Wave};
use crate::surface::shapes::implicit::{Implicit, Room, Shape};
use crate::surface::shapes::revolution::Catenoid;
use crate::surface::shapes::star::{StarShaped, Superquadric};
use glam::DVec3;

/// Any surface of this module.
#[derive(Clone, Debug, PartialEq)]
pub enum Surface {
    /// One that rays can be cast at.
    Primitive(Primitive),
    /// The film between two rings.
    Catenoid(Catenoid),
    /// z = 0.3 sin 3x cos 3y.
    Wave(Wave),
    /// z = x³ − 3xy².
    MonkeySaddle(MonkeySaddle),
    /// Between box, ball and octahedron.
    Superquadric(Superquadric),
    /// One bicubic patch.
    Patch(Box<BezierPatch>),
    /// Newell's.
    Teapot,
}

impl<P: Into<Primitive>> From<P> for Surface {
    fn from(primitive: P) -> Self {
        Surface::Primitive(primitive.into())
    }
}

impl Surface {
    /// The surface by its parameters: one chart, or 32 of the teapot.
    pub fn charts(&self) -> Vec<&dyn Parametric> {
        match self.shape() {
            Some(shape) => vec![shape],
            None => self.patches().iter().map(|patch| patch as &dyn Parametric).collect(),
        }
    }

    /// The bicubic patches that the surface is made of; none for other surfaces.
    pub fn patches(&self) -> &[BezierPatch] {
        match self {
            Surface::Patch(patch) => std::slice::from_ref(patch),
            Surface::Teapot => teapot(),
            _ => &[],
        }
    }

    /// The surface as the zero set of a function; `None` for patches.
    pub fn zero_set(&self) -> Option<&dyn Implicit> {
        self.shape().map(|shape| shape as &dyn Implicit)
    }

    fn shape(&self) -> Option<&dyn Shape> {
        Some(match self {
            Surface::Primitive(primitive) => primitive.shape(),
            Surface::Catenoid(catenoid) => catenoid,
            Surface::Wave(wave) => wave,
            Surface::MonkeySaddle(saddle) => saddle,
            Surface::Superquadric(superquadric) => superquadric,
            Surface::Patch(_) | Surface::Teapot => return None,
        })
    }

    /// The surface by directions from the origin, if it is a stretched sphere.
    pub fn star_shaped(&self) -> Option<&dyn StarShaped> {
        match self {
            Surface::Primitive(Primitive::Sphere(sphere)) => Some(sphere),
            Surface::Primitive(Primitive::Ellipsoid(ellipsoid)) => Some(ellipsoid),
            Surface::Superquadric(superquadric) => Some(superquadric),
            _ => None,
        }
    }

    /// The surface as heights over a rectangle, if it is that.
    pub fn heights(&self) -> Option<&dyn Height> {
        match self {
            Surface::Primitive(Primitive::Plane(plane)) => Some(plane),
            Surface::Wave(wave) => Some(wave),
            Surface::MonkeySaddle(saddle) => Some(saddle),
            _ => None,
        }
    }

    /// The box of a zero set; open surfaces end at its faces.
    pub(super) fn room(&self) -> Option<Room> {
        const OVER_RECTANGLE: [bool; 3] = [true, true, false];
        const TUBE: [bool; 3] = [false, true, false];
        let (half, ends) = match self {
            Surface::Primitive(primitive) => {
                let ends = match primitive {
                    Primitive::Plane(_) => OVER_RECTANGLE,
                    Primitive::Cylinder(_) | Primitive::Cone(_) => TUBE,
                    Primitive::Sphere(_) | Primitive::Ellipsoid(_) | Primitive::Torus(_) => [false; 3],
                };
                (primitive.half_extents(), ends)
            }
            Surface::Catenoid(catenoid) => {
                let radius = catenoid.widest();
                (DVec3::new(radius, catenoid.height() / 2.0, radius), TUBE)
            }
            Surface::Wave(wave) => ((wave.extent() / 2.0).extend(0.3), OVER_RECTANGLE),
            Surface::MonkeySaddle(saddle) => {
                let half = saddle.size() / 2.0;
                (DVec3::new(half, half, 2.0 * half * half * half), OVER_RECTANGLE)
            }
            Surface::Superquadric(superquadric) => (superquadric.semi_axes(), [false; 3]),
            Surface::Patch(_) | Surface::Teapot => return None,
        };
        Some(Room { low: -half, high: half, ends })
    }
}
