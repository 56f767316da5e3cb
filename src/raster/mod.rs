//! Polygons to pixels (layer 3).
//!
//! [`render`] takes a [`Scene`] and [`RenderSettings`] and gives an [`Image`]. On the way vertices are placed on the
//! picture and snapped, triangles are clipped and sorted into tiles of 64 × 64 pixels, and tile by tile it is found out
//! what is seen; only that is shaded.

mod bins;
mod camera;
mod cast;
mod clip;
mod coverage;
mod draw;
mod error;
mod fixed;
mod framing;
mod ink;
mod interpolate;
mod job;
mod light;
mod line_ends;
mod lines;
mod list;
mod load;
mod output;
mod paint;
mod picture;
mod probe;
mod project;
mod records;
mod render;
mod samples;
mod scanline;
mod scene;
mod seen_point;
mod settings;
mod setup;
mod shape;
mod show;
mod tile;
mod triangles;
mod unseen;
mod view;

pub use camera::{Camera, CameraError, Projection};
pub use error::RenderError;
pub use load::{
    LoadOptions, Recentring, SceneFile, SceneMesh, SceneObject, SceneShape, default_lights, load, rotation,
};
pub use picture::{Image, Pixels, Statistics, Times};
pub use probe::{LitPoint, ProbePoint, probe};
pub use render::render;
pub use samples::Samples;
pub use scene::{LinePath, Lines, Object, Paint, Scene, Shape, Triangles};
pub use settings::{Bits, Cull, FlatSample, Interpolation, LineStyle, RenderSettings, Shading, Show};
pub use unseen::Unseen;
