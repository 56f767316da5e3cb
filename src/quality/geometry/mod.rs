//! Geometry: faces, edges and vertices that spoil normals.

// Comparison of angles by their cosine.
pub(super) mod angle_limit;
// Long and thin faces.
pub(super) mod slenderness;
// Whether polygons are plane, convex and simple.
pub(super) mod polygons;
// Duplicate faces and vertices.
pub(super) mod duplicates;
// Findings about geometry.
pub(super) mod geometry_findings;
