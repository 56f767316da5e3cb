//! Geometry: faces, edges and vertices that spoil normals.

// Long and thin faces, and faces without a direction.
pub(crate) mod slivers;
// Polygons that are not plane, convex or simple.
pub(crate) mod polygons;
// Duplicate faces and vertices.
pub(crate) mod duplicates;
// Edges of more than two faces, and folds.
pub(crate) mod edges;
// Vertices where several fans touch, poles, and fans that cancel.
pub(crate) mod vertices;
// Positions too far from the origin for their precision.
pub(crate) mod far_from_origin;
// Nodes whose matrices mirror or flatten a mesh, and files without faces.
pub(crate) mod nodes;
