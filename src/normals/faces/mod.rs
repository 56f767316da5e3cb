//! Faces: positions as the kernels read them, direction and area, slivers.

// Positions of a mesh or of a caller's slice, in single or double precision.
pub(super) mod positions;
// The number types of the caller's positions and normals.
pub(super) mod component;
// Faces whose height is below the rounding of their coordinates.
pub(super) mod sliver;
// Direction and area of one face, exact where needed.
pub(super) mod shape;
// Normals of all faces.
pub(super) mod face_normals;
