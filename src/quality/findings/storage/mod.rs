//! Storage: the precision in which normals are stored.

// The grids to which formats round normals.
pub(crate) mod grid;
// The grid of the stored normals, and what it is good for.
pub(crate) mod quantisation;
