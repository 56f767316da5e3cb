//! Lines: wireframes and normals drawn over the picture.

// Straight lines with a width and hidden parts.
pub(super) mod draw_lines;
// End points of lines along an object.
pub(super) mod segments;
