//! Analytic surfaces with exact normals in double precision (layer 2): the truth that meshes and pictures of them are
//! held against.
//!
//! A [`Surface`] is known by two parameters ([`Parametric`]), and some also as a zero set ([`Implicit`]), by directions
//! ([`StarShaped`]) or as heights ([`Height`]). [`Surface::tessellate`] makes meshes of it, regular and irregular, each
//! vertex with its exact normal. Rays can be cast at a [`Primitive`].
//!
//! Where surfaces stand: what turns, turns about the y axis, which is up; heights over a plane rise along z.

mod bezier;
mod catalogue;
mod catenoid;
mod chart;
mod cone;
mod cylinder;
mod dual;
mod ellipsoid;
mod error;
mod grid;
mod hash;
mod height;
mod icosphere;
mod implicit;
mod marching;
mod net;
mod patches;
mod plane;
mod polynomial;
mod primitive;
mod ray;
mod scattered;
mod sphere;
mod star;
mod superquadric;
mod teapot;
mod tessellation;
#[cfg(test)]
mod tests;
mod torus;

pub use bezier::BezierPatch;
pub use catalogue::Surface;
pub use catenoid::Catenoid;
pub use chart::{Chart, Parametric, Sample};
pub use cone::Cone;
pub use cylinder::Cylinder;
pub use ellipsoid::Ellipsoid;
pub use error::SurfaceError;
pub use hash::GridHash;
pub use height::{Height, MonkeySaddle, Wave};
pub use implicit::Implicit;
pub use plane::Plane;
pub use primitive::{Placed, Primitive};
pub use ray::{Hit, Ray};
pub use scattered::height_field;
pub use sphere::Sphere;
pub use star::StarShaped;
pub use superquadric::Superquadric;
pub use teapot::teapot;
pub use tessellation::{Pattern, Tessellation};
pub use torus::Torus;
