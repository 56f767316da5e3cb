//! What makes a surface or its tessellation impossible.

use std::ops::RangeInclusive;

/// Lengths that surfaces may be made of, in any unit. Their fourth powers, which the torus needs, stay far from the
/// ends of the range of a double.
pub(super) const LENGTHS: RangeInclusive<f64> = 1e-60..=1e60;

/// Why a surface cannot be made, or not be tessellated as asked.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum SurfaceError {
    /// A length that is not positive and of a size that can be computed with.
    #[error("{what} is {found:e}; a length from 1e-60 to 1e60 was expected")]
    Length {
        /// Which length.
        what: &'static str,
        /// What it is.
        found: f64,
    },
    /// A torus whose tube would run through itself.
    #[error("the tube's radius {minor} is not smaller than the ring's radius {major}")]
    SelfCrossing {
        /// From the axis to the middle of the tube.
        major: f64,
        /// Of the tube.
        minor: f64,
    },
    /// A map that flattens space, or that is not finite.
    #[error("the transform is singular or not finite, so the surface has no normals under it")]
    Singular,
}

/// A length, if it is one.
pub(super) fn length(what: &'static str, found: f64) -> Result<f64, SurfaceError> {
    if LENGTHS.contains(&found) { Ok(found) } else { Err(SurfaceError::Length { what, found }) }
}
