//! From the scene to the screen: camera, projection, clipping, framing.

// The camera.
pub(super) mod camera;
// The transform from the scene to the screen.
pub(super) mod screen_transform;
// Fixed-point screen positions.
pub(super) mod fixed_point;
// Vertices on the screen.
pub(super) mod project;
// Clipping at the near plane and the guard band.
pub(super) mod clip;
// A camera that shows the whole scene.
pub(super) mod framing;
