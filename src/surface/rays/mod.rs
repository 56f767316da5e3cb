//! Rays: intersections with the surfaces.

// Real roots of polynomials.
pub(super) mod polynomial;
// Rays and hits.
pub(super) mod ray;
// Surfaces placed in a scene.
pub(super) mod primitive;
