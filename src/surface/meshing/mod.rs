//! Meshing: tessellations with chosen irregularity.

// The patterns, their settings and reproducible random numbers.
pub(super) mod pattern;
// Faces over samples of a surface, and their dual.
pub(super) mod net;
// Grids of parameters, and their joints.
pub(super) mod grid;
// Marching tetrahedra.
pub(super) mod marching;
// Subdivided icosahedra, and Delaunay triangulations of scattered points.
pub(super) mod gridless;
// Surfaces as meshes, by any pattern.
pub(super) mod tessellation;
