//! Analytic surfaces with exact normals in double precision (layer 2): the truth that meshes and pictures of them are
//! held against.
//!
//! [`Primitive`]s can be hit by rays.
//!
//! Where surfaces stand: what turns, turns about the y axis, which is up; heights over a plane rise along z.

mod cone;
mod cylinder;
mod ellipsoid;
mod error;
mod implicit;
mod plane;
mod polynomial;
mod primitive;
mod ray;
mod sphere;
mod torus;

pub use cone::Cone;
pub use cylinder::Cylinder;
pub use ellipsoid::Ellipsoid;
pub use error::SurfaceError;
pub use implicit::Implicit;
pub use plane::Plane;
pub use primitive::{Placed, Primitive};
pub use ray::{Hit, Ray};
pub use sphere::Sphere;
pub use torus::Torus;
