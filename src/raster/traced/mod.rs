//! Whitted's ray tracing of the scenes that the rasterizer draws.

// Trees of boxes: nodes of eight children, leaves of eight triangles.
pub(super) mod tree;
// Building a tree by the surface area heuristic.
mod build;
// A ray through a tree: the watertight test of boxes and triangles.
pub(super) mod traverse;
// Neighbouring rays that begin below the root.
mod bundle;
// Triangles and analytic surfaces of a scene in one frame.
pub(super) mod world;
// What a ray meets: position, normals, sides.
pub(super) mod hit;
// Lights as shadow rays see them.
pub(super) mod lamp;
// How much of a light reaches a point.
mod shadow;
// The bodies that a ray is inside of.
mod media;
// The light along a ray: local light, reflection, refraction.
pub(super) mod whitted;
// The rays of the camera, tile by tile.
pub(super) mod camera_rays;
// The tree of rays of a pixel.
pub(super) mod ray_tree;
