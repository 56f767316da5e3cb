//! Polygons to pixels (layer 3).
//!
//! [`render`] takes a [`Scene`] and [`RenderSettings`] and returns an [`Image`]. Vertices are placed on the picture and snapped,
//! triangles are clipped and sorted into tiles of 64 × 64 pixels, and each tile finds and shades the visible ones.

// Why a scene cannot be drawn.
mod error;
// Everything that changes the picture, except the scene.
mod settings;
// Objects, lights and lines.
mod scene;
// The finished picture and its statistics.
mod picture;
// From the scene to the screen: camera, projection, clipping, framing.
mod view;
// Coverage: which triangle is visible at each sample.
mod coverage;
// Shading: colours of samples.
mod shading;
// Ray tracing: shadows, reflection, refraction.
mod traced;
// Lines: wireframes and normals drawn over the picture.
mod lines;
// Frame: tiles in parallel, then the picture.
mod frame;
// The numbers behind one sample.
mod probe;
// Scenes from files.
mod load;

pub use error::RenderError;
pub use frame::empty_picture::Unseen;
pub use frame::job::depth_range;
pub(crate) use frame::render::pixel_colour;
pub use frame::render::{RenderScratch, render, render_reusing};
pub use load::{
    LoadOptions, NormalSettings, Recentring, SceneFile, SceneMesh, SceneObject, SceneShape, StoredFormat,
    default_lights, load, rotation,
};
pub(crate) use load::{is_scene, read_text};
pub use picture::{Image, Pixels, Statistics, Times};
pub use probe::{LitPoint, ProbePoint, probe};
pub use scene::{LinePath, Lines, Object, Paint, Scene, Shape, Triangles};
pub use settings::{
    Bits, Cull, FlatSample, Interpolation, LineStyle, ObjectSettings, RenderSettings, Samples, Shading, Show,
    TraceSettings,
};
pub use traced::ray_tree::{RayHit, RayNode, ShadowTest};
pub use view::camera::{Camera, CameraError, Projection};
