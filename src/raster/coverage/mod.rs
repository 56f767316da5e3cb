//! Coverage: which triangle is visible at each sample.

// Edge functions and depth plane of a triangle.
pub(super) mod setup;
// The visible triangle at each sample of a tile.
pub(super) mod visible_triangle;
// The record that each pixel of a tile shows.
pub(super) mod shown;
// Distribution of triangles over tiles.
pub(super) mod tile_bins;
// The triangles of one tile: collected, drawn, and records of the visible ones.
pub(super) mod tile_list;
// Attributes of the visible triangles.
pub(super) mod records;
// Objects made of triangles.
pub(super) mod triangles;
