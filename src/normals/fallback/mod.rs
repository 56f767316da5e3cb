//! Fallback: normals for corners whose sum has no direction, and the choice between stored and computed normals.

// Fallback normals from neighbouring faces, without topology.
pub(super) mod neighbours;
// Fallback normals of a mesh, by one documented chain.
pub(super) mod fallback_normals;
// Replacement of single stored normals.
pub(super) mod replace;
// The choice between stored and computed normals.
pub(super) mod select;
