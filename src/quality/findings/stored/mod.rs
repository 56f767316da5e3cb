//! Stored: the normals of the file, corner by corner.

// Normals that are missing, without a direction or not of unit length; tangents, and morph targets.
pub(crate) mod values;
// Where a normal that deviates may come from.
pub(crate) mod origin;
// Regions whose normals were made in another way.
pub(crate) mod regions;
// Normals that are constant, or rotated or reflected as a whole.
pub(crate) mod rotated;
// Normals in another space of the node tree.
pub(crate) mod coordinate_space;
// Normals that deviate from the recipe.
pub(crate) mod deviations;
