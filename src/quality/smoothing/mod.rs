//! Smoothing: what stored normals do across edges.

// Consecutive corners that share a normal.
pub(super) mod equal_normals;
// The crease angle that separates smooth edges from sharp ones.
pub(super) mod crease_angle;
// Flat normals on smooth shapes and smooth normals on sharp ones.
pub(super) mod facets;
// Findings about edges.
pub(super) mod smoothing_findings;
