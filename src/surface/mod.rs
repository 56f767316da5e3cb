//! Analytic surfaces with exact normals in double precision (layer 2): the truth that meshes and pictures of them are
//! compared with.
//!
//! A [`Surface`] is given by two parameters ([`Parametric`]), and some also as a zero set ([`Implicit`]), by directions
//! ([`StarShaped`]) or as heights ([`Height`]). [`Surface::tessellate`] makes meshes of it, regular and irregular, each
//! vertex with its exact normal. Rays can be cast at a [`Primitive`].
//!
//! Surfaces of revolution turn about the y axis, which is up; heights over a plane rise along z.

// Limits and errors.
mod error;
// The analytic surfaces.
mod shapes;
// Rays and their hits.
mod rays;
// All surfaces as one type.
mod catalogue;
// Meshes of surfaces, regular and irregular.
mod meshing;
// Normals against differences of points.
#[cfg(test)]
mod tests;

pub use catalogue::Surface;
pub use error::SurfaceError;
pub use meshing::pattern::GridHash;
pub use meshing::pattern::{Pattern, Tessellation};
pub use rays::primitive::{Placed, Primitive};
pub use rays::ray::{Hit, Ray};
pub use shapes::bezier::{BezierPatch, teapot};
pub use shapes::chart::{Chart, Parametric, Sample};
pub use shapes::height::{Height, MonkeySaddle, Plane, Wave};
pub use shapes::implicit::Implicit;
pub use shapes::revolution::{Catenoid, Cone, Cylinder, Torus};
pub use shapes::star::{Ellipsoid, Sphere, StarShaped, Superquadric};
