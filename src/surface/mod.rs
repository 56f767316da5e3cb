//! Analytic surfaces with exact normals in double precision (layer 2): the truth that meshes and pictures of them are
//! held against.
//!
//! A [`Surface`] is known by two parameters ([`Parametric`]), and some also as a zero set ([`Implicit`]), by directions
//! ([`StarShaped`]) or as heights ([`Height`]). [`Surface::tessellate`] makes meshes of it, regular and irregular, each
//! vertex with its exact normal. Rays can be cast at a [`Primitive`].
//!
//! Where surfaces stand: what turns, turns about the y axis, which is up; heights over a plane rise along z.

// What makes a surface or its tessellation impossible.
mod error;
// All surfaces as one type.
mod catalogue;
// Normals against differences of points.
#[cfg(test)]
mod tests;
// Shapes: the analytic surfaces.
mod shapes;
// Rays: intersections with the surfaces.
mod rays;
// Meshing: tessellations with chosen irregularity.
mod meshing;
pub use catalogue::Surface;
pub use error::SurfaceError;
pub use meshing::hash::GridHash;
pub use meshing::scattered::height_field;
pub use meshing::tessellation::{Pattern, Tessellation};
pub use rays::primitive::{Placed, Primitive};
pub use rays::ray::{Hit, Ray};
pub use shapes::bezier::BezierPatch;
pub use shapes::catenoid::Catenoid;
pub use shapes::chart::{Chart, Parametric, Sample};
pub use shapes::cone::Cone;
pub use shapes::cylinder::Cylinder;
pub use shapes::ellipsoid::Ellipsoid;
pub use shapes::height::{Height, MonkeySaddle, Wave};
pub use shapes::implicit::Implicit;
pub use shapes::plane::Plane;
pub use shapes::sphere::Sphere;
pub use shapes::star::StarShaped;
pub use shapes::superquadric::Superquadric;
pub use shapes::teapot::teapot;
pub use shapes::torus::Torus;
