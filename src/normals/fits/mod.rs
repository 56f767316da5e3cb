//! Fits: normals of surfaces fitted to the neighbourhood of a vertex.

// The nearest of many points.
pub(super) mod nearest;
// Least-squares quadrics.
pub(super) mod quadric;
