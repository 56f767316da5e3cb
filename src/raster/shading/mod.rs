//! Shading: colours of samples.

// The colour inputs of an object.
pub(super) mod surface_colour;
// Light at corners and faces.
pub(super) mod lighting;
// Corner values interpolated to samples.
pub(super) mod interpolate;
// The lectures' scanline algorithm.
pub(super) mod scan_polygon;
// Analytic surfaces by one ray a sample.
pub(super) mod ray_cast;
// Normals, depth, faces and deviation as colours.
pub(super) mod false_colour;
// Colours of the visible samples.
pub(super) mod shade_samples;
