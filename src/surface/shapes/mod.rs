//! Shapes: the analytic surfaces.

// Surfaces of two parameters.
pub(super) mod chart;
// Heights over a square.
pub(super) mod height;
// Surfaces as zero sets.
pub(super) mod implicit;
// Surfaces that every ray from the origin meets once.
pub(super) mod star;
// A rectangle.
pub(super) mod plane;
// A sphere.
pub(super) mod sphere;
// An ellipsoid.
pub(super) mod ellipsoid;
// A tube.
pub(super) mod cylinder;
// A cone.
pub(super) mod cone;
// A torus.
pub(super) mod torus;
// A catenoid.
pub(super) mod catenoid;
// A superellipsoid.
pub(super) mod superquadric;
// A bicubic Bézier patch.
pub(super) mod bezier;
// Newell's teapot.
pub(super) mod teapot;
