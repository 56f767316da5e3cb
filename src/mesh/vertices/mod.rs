//! Vertices split where corners differ, and merged where they agree.

// Vertices split by attributes of their corners.
pub(super) mod split;
// Vertices merged by position and attributes.
pub(super) mod merge;
// Vertices moved to others nearby.
pub(super) mod near;
