//! Tests of several files, and meshes for tests of kernels.

// Face normals against exact arithmetic.
mod exact;
// Meshes, and a number of threads.
pub(super) mod meshes;
