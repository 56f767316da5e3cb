//! Meshing: tessellations with chosen irregularity.

// Reproducible irregularity.
pub(super) mod hash;
// Faces over samples of a surface.
pub(super) mod net;
// Grids of parameters.
pub(super) mod grid;
// Joined grids of neighbouring patches.
pub(super) mod patches;
// The dual of a triangle mesh.
pub(super) mod dual;
// Subdivided icosahedra.
pub(super) mod icosphere;
// Marching tetrahedra.
pub(super) mod marching;
// Delaunay triangulations of scattered points.
pub(super) mod scattered;
// Meshes of surfaces, of good and bad shape.
pub(super) mod tessellation;
