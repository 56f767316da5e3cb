//! A-priori bounds on the error of cheaper models.

// The light that arrives, and that of cheaper lights.
mod lights;
// A change of light, in steps of 1/255.
mod shading;
// How much normals and positions within a face vary.
mod spread;
// The outlines of coarser spheres, in pixels.
mod outline;
// A model of an object under cheaper lights.
mod model;

pub use lights::Ball;
pub use model::ModelBounds;
pub use outline::outline_bound;
