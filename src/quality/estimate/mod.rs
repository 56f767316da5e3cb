//! Which recipe made the stored normals.

// The rotation closest to a set of direction pairs.
pub(crate) mod rotation;
// Averages by every weighting.
pub(crate) mod means;
// The crease angle that separates smooth edges from sharp ones.
pub(crate) mod crease_angle;
// Normals of quadrics at sample corners.
pub(crate) mod quadrics;
// Fits of recipes to sampled normals.
pub(crate) mod fit;
// The recipe that fits best.
pub(crate) mod recipe;
