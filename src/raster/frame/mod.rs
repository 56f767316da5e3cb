//! Frame: tiles in parallel, then the picture.

// A scene and settings, checked and prepared.
pub(super) mod job;
// One tile: visibility, colours, lines.
pub(super) mod tile;
// Why a picture is empty.
pub(super) mod empty_picture;
// Tiles written to the picture.
mod target;
// From a scene to a picture.
pub(super) mod render;
// Times of the stages.
mod stopwatch;
