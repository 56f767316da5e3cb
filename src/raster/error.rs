//! What cannot be drawn.

use crate::raster::view::camera::CameraError;
use crate::shade::{NotFinite, ShadeError};
use glam::DVec3;

/// Why there is no picture. Objects count from 0.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum RenderError {
    /// The camera cannot be used.
    #[error(transparent)]
    Camera(#[from] CameraError),
    /// A picture without pixels, or too large.
    #[error("the picture is {0} by {1} pixels; each side must be 1 to 16384")]
    Size(u32, u32),
    /// A light, material or setting that makes no sense.
    #[error("object {object}: {error}")]
    Shade {
        /// Where it was needed.
        object: usize,
        /// What it is.
        error: ShadeError,
    },
    /// A colour that is infinite or not a number.
    #[error("object {object}: {error}")]
    NotFinite {
        /// The object.
        object: usize,
        /// Where and why.
        error: NotFinite,
    },
    /// A transform that is not finite or cannot be undone.
    #[error("object {0}: its transform flattens space or is not finite; normals have no direction then")]
    Singular(usize),
    /// [`Shading::Exact`](crate::raster::Shading::Exact) of an object without an analytic surface.
    #[error(
        "object {0}: exact shading needs an analytic surface, but this is a mesh; choose another shading"
    )]
    NoSurface(usize),
    /// Colours of vertices where none are: of an analytic surface that rays are cast at.
    #[error(
        "object {0}: an analytic surface has no vertex colours; use a material, or a mesh with another shading"
    )]
    Uncoloured(usize),
    /// A list of an object that is not as long as it must be.
    #[error("object {object}: {found} {what}, but {expected} {per}")]
    Count {
        /// The object.
        object: usize,
        /// What there are too few or too many of.
        what: &'static str,
        /// How many there are.
        found: usize,
        /// What they belong to.
        per: &'static str,
        /// How many of those there are.
        expected: usize,
    },
    /// A triangle or line that names a point that is not there.
    #[error("{what} {number} refers to point {index}, but there are only {count}")]
    Index {
        /// `triangle` or `line`.
        what: &'static str,
        /// Which one, counted from 0.
        number: usize,
        /// What it refers to, counted from 0.
        index: u32,
        /// How many there are.
        count: usize,
    },
    /// Lines along an object that is not there, or is an analytic surface.
    #[error("lines {lines} run along object {object}, which has no vertices")]
    NoVertices {
        /// Which of the scene's sets of lines.
        lines: usize,
        /// The object.
        object: usize,
    },
    /// A position so far out that its place on the picture overflows, or that is not finite itself.
    #[error("object {object}: vertex {vertex} at {position} has no finite place in front of the camera")]
    OutOfRange {
        /// The object.
        object: usize,
        /// The vertex, counted from 0.
        vertex: usize,
        /// Where it is, in the object's space.
        position: DVec3,
    },
    /// A colour, width or end of a line, or the background, that makes no sense.
    #[error("{what} is {found}; it must be {expected}")]
    Number {
        /// What.
        what: &'static str,
        /// What it is.
        found: String,
        /// What it should be.
        expected: &'static str,
    },
    /// More triangles than have distinct numbers.
    #[error("the scene has {0} triangles; 2147483647 is the most")]
    TooManyTriangles(usize),
}
