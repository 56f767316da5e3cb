//! Limits of surfaces and tessellations, and the errors for what is beyond them.

use std::ops::RangeInclusive;

/// Lengths that surfaces may be made of, in any unit. Their fourth powers, which the torus needs, stay far from the
/// ends of the range of a double.
pub(super) const LENGTHS: RangeInclusive<f64> = 1e-60..=1e60;

/// Most cells of a tessellation: a mesh of some gigabytes.
pub(super) const MOST_CELLS: u64 = 1 << 24;

/// Why a surface cannot be made or tessellated.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum SurfaceError {
    /// A torus whose tube would run through itself.
    #[error("the tube's radius {minor} is not smaller than the ring's radius {major}")]
    SelfCrossing {
        /// From the axis to the middle of the tube.
        major: f64,
        /// Of the tube.
        minor: f64,
    },
    /// A control point that is not finite, or beyond 1e60.
    #[error("the control point in row {row}, column {column} is not finite or beyond 1e60")]
    ControlPoint {
        /// Counted from 0.
        row: usize,
        /// Counted from 0.
        column: usize,
    },
    /// Fewer or more cells than the pattern needs or allows on this surface.
    #[error("{found} {what} are {}; {limit} is the limit", if found < limit { "too few" } else { "too many" })]
    Segments {
        /// Segments of what, or what else is counted.
        what: &'static str,
        /// How many were requested.
        found: u64,
        /// How many there must or may be.
        limit: u64,
    },
    /// A number of a shape or of a tessellation that is out of its range.
    #[error("{what} is {found}; {expected} was expected")]
    OutOfRange {
        /// Which number.
        what: &'static str,
        /// The number.
        found: String,
        /// The range.
        expected: &'static str,
    },
    /// A pattern that is not possible on this surface.
    #[error("{pattern} is not possible here: {reason}")]
    Pattern {
        /// Which pattern.
        pattern: &'static str,
        /// Why not.
        reason: &'static str,
    },
    /// A point at which a surface has no normal.
    #[error("the surface has no normal at u = {u}, v = {v}")]
    NoNormal {
        /// The first parameter.
        u: f64,
        /// The second one.
        v: f64,
    },
    /// Scattered points that make no surface.
    #[error("point {point}: {reason}")]
    Scattered {
        /// Which point, counted from 0.
        point: usize,
        /// What is wrong with it.
        reason: &'static str,
    },
    /// A map that flattens space, or that is not finite.
    #[error("the transform is singular or not finite, so the surface has no normals under it")]
    Singular,
}

/// Checks a number of cells or the like.
pub(super) fn check_count(
    what: &'static str,
    found: impl Into<u64>,
    limits: RangeInclusive<u64>,
) -> Result<(), SurfaceError> {
    let found = found.into();
    let limit = found.clamp(*limits.start(), *limits.end());
    if found == limit { Ok(()) } else { Err(SurfaceError::Segments { what, found, limit }) }
}

/// A length, if it is valid.
pub(super) fn length(what: &'static str, found: f64) -> Result<f64, SurfaceError> {
    let error = || out_of_range(what, format!("{found:?}"), "a length from 1e-60 to 1e60");
    if LENGTHS.contains(&found) { Ok(found) } else { Err(error()) }
}

pub(super) fn out_of_range(what: &'static str, found: impl ToString, expected: &'static str) -> SurfaceError {
    SurfaceError::OutOfRange { what, found: found.to_string(), expected }
}

/// Declares a surface that is determined by lengths: the type, its default lengths, the constructor that checks them, and
/// a getter for each. `$check` is called with a surface whose lengths are valid.
macro_rules! surface_of_lengths {
    (
        $(#[$doc:meta])* $surface:ident { $($(#[$about:meta])* $length:ident: $name:literal = $default:literal,)+ }
        $(#[$constructor:meta])* new with $check:expr
    ) => {
        $(#[$doc])*
        #[derive(Clone, Copy, Debug, PartialEq)]
        pub struct $surface {
            $($length: f64,)+
        }

        impl Default for $surface {
            fn default() -> Self {
                Self { $($length: $default,)+ }
            }
        }

        impl $surface {
            $(#[$constructor])*
            pub fn new($($length: f64),+) -> Result<Self, SurfaceError> {
                $check(Self { $($length: $crate::surface::error::length($name, $length)?,)+ })
            }

            $($(#[$about])*
            pub fn $length(&self) -> f64 {
                self.$length
            })+
        }
    };
}
pub(super) use surface_of_lengths;
