//! Shapes: the analytic surfaces.

// Surfaces by two parameters.
pub(super) mod chart;
// Surfaces as zero sets, and rays on them.
pub(super) mod implicit;
// Heights over a rectangle: plane, wave, monkey saddle.
pub(super) mod height;
// Surfaces that every ray from the origin meets once: sphere, ellipsoid, superellipsoid.
pub(super) mod star;
// Surfaces of revolution: cylinder, cone, catenoid, torus.
pub(super) mod revolution;
// Bicubic Bézier patches and the teapot.
pub(super) mod bezier;
