//! Before and after: two files of one shape.

// The corners of a file.
mod side;
// Corners that two files share.
mod matching;
// What changed at these.
pub(crate) mod changes;
