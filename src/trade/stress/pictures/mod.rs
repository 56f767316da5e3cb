//! Cases about lighting and drawing.

// One lit point against 256-bit arithmetic.
pub(super) mod lit;
// Extreme specular exponents.
pub(super) mod highlight;
// Light at tiny distances.
pub(super) mod attenuation;
// Which pixels a triangle covers.
pub(super) mod pixel_coverage;
// Triangles that are hard to draw.
pub(super) mod triangles;
