//! Storage: the precision in which normals are stored.

// Grids to which formats round normals.
pub(super) mod grid;
// The grid of the stored normals.
pub(super) mod quantisation;
