//! Slices: the same kernels for the caller's own arrays.

// Face and vertex normals of slices.
pub(super) mod vertex_normals;
// Corner normals of slices, split at creases.
pub(super) mod corner_normals;
