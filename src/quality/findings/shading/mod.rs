//! Shading: what even correct normals show.

// Terminators, lost highlights, Mach bands and outlines.
pub(crate) mod interpolation;
