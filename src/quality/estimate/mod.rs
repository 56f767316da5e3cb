//! Estimate: which recipe made the stored normals.

// The rotation closest to a set of direction pairs.
pub(super) mod rotation;
// Averages as other programs compute them.
pub(super) mod other_programs;
// Averages by every weighting.
pub(super) mod means;
// Normals of quadrics at sample corners.
pub(super) mod quadrics;
// Fits of recipes to sampled normals.
pub(super) mod fit;
// The recipe that fits best.
pub(super) mod recipe;
