//! What a wrong normal does to a picture.

// Grey levels that a deviation changes.
pub(crate) mod lost_light;
// The width of the highlights of faces.
pub(crate) mod highlight;
