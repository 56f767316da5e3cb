//! What cannot be drawn.

use crate::raster::view::camera::CameraError;
use crate::shade::{NotFinite, ShadeError};

pub(super) type Result<T, E = RenderError> = std::result::Result<T, E>;

/// Why there is no picture. Objects, vertices, triangles and lines count from 0.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum RenderError {
    /// The camera cannot be used.
    #[error(transparent)]
    Camera(#[from] CameraError),
    /// An invalid light, material or setting.
    #[error("object {object}: {error}")]
    Shade {
        /// The object that needs it.
        object: usize,
        /// Which number is invalid.
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
    /// An object that lacks what its shading or paint needs: an analytic surface, or vertex colours.
    #[error("object {object}: {lack}")]
    Lacks {
        /// The object.
        object: usize,
        /// What it lacks, and what to do.
        lack: &'static str,
    },
    /// An invalid colour, width or end of a line, background, or place to probe.
    #[error("{what} is {found}; it must be {expected}")]
    Number {
        /// What it is for.
        what: &'static str,
        /// What it is.
        found: String,
        /// What it should be.
        expected: &'static str,
    },
    /// An invalid size, list, index, transform or position.
    #[error("{0}")]
    Invalid(String),
}

impl RenderError {
    /// A transform that is not finite or cannot be inverted.
    pub(super) fn singular(object: usize) -> Self {
        let fact = "its transform flattens space or is not finite; normals have no direction then";
        Self::Invalid(format!("object {object}: {fact}"))
    }

    /// A triangle or line that refers to a point that does not exist.
    pub(super) fn index(what: &str, number: usize, index: u32, count: usize) -> Self {
        Self::Invalid(format!("{what} {number} refers to point {index}, but there are only {count}"))
    }
}
