//! Frame: tiles in parallel, then the picture.

// A scene and settings, checked and prepared.
pub(super) mod job;
// One tile: visibility, colours, lines.
pub(super) mod tile;
// Why a picture is empty.
pub(super) mod empty_picture;
// From a scene to a picture of stored numbers.
pub(super) mod render;
// Times of the stages.
mod stopwatch;
