//! Geometry: faces, edges and vertices that spoil normals.

// Thin faces, faces without a direction, and polygons that are not plane, convex or simple.
pub(crate) mod face_shape;
// Duplicate faces and vertices.
pub(crate) mod duplicates;
// Edges of more than two faces, and folds.
pub(crate) mod edges;
// Vertices where several fans touch, poles, and fans that cancel.
pub(crate) mod vertices;
// Meshes far from the origin, or mirrored or flattened by nodes.
pub(crate) mod placement;
