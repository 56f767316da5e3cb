//! Limits of surfaces and tessellations, and the errors for what is beyond them.

use std::fmt::Display;
use std::ops::RangeInclusive;

pub(super) type Result<T, E = SurfaceError> = std::result::Result<T, E>;

/// Lengths of surfaces, in any unit. Their fourth powers, which the torus needs, stay in range.
pub(super) const LENGTHS: RangeInclusive<f64> = 1e-60..=1e60;

/// Most cells of a tessellation: a mesh of some gigabytes.
pub(super) const MOST_CELLS: u64 = 1 << 24;

/// Why a surface cannot be made or tessellated.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum SurfaceError {
    /// A number of a shape or of a tessellation that is out of its range.
    #[error("{0}")]
    OutOfRange(String),
    /// Fewer or more cells, levels or points than the pattern needs or allows on this surface.
    #[error("{0}")]
    Segments(String),
    /// A pattern that is not possible on this surface.
    #[error("{0}")]
    Pattern(String),
    /// Radii, points or a map that make no surface.
    #[error("{0}")]
    Invalid(String),
}

impl SurfaceError {
    /// A pattern that is not possible, with the reason.
    pub(super) fn pattern(pattern: &str, reason: &str) -> Self {
        Self::Pattern(format!("{pattern} is not possible here: {reason}"))
    }
}

pub(super) fn check_count(what: &str, found: impl Into<u64>, limits: RangeInclusive<u64>) -> Result<()> {
    let found = found.into();
    let limit = found.clamp(*limits.start(), *limits.end());
    let bound = if found < limit { "at least" } else { "at most" };
    let error = || SurfaceError::Segments(format!("{found} {what}; {bound} {limit} expected"));
    if found == limit { Ok(()) } else { Err(error()) }
}

pub(super) fn length(what: &str, found: f64) -> Result<f64> {
    let error =
        || out_of_range(what, format!("{found:?}").trim_end_matches(".0"), "a length from 1e-60 to 1e60");
    if LENGTHS.contains(&found) { Ok(found) } else { Err(error()) }
}

pub(super) fn out_of_range(what: &str, found: impl Display, expected: &str) -> SurfaceError {
    SurfaceError::OutOfRange(format!("{what} is {found}; {expected} was expected"))
}

/// Declares a surface of lengths: type, defaults, a checked constructor, getters. `$check` gets a surface of valid lengths.
macro_rules! surface_of_lengths {
    (
        $(#[$doc:meta])* $surface:ident { $($(#[$about:meta])* $length:ident: $name:literal = $default:literal,)+ }
        new with $check:expr
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
            /// A surface of these lengths.
            ///
            /// # Errors
            /// [`SurfaceError`] for lengths that are out of range or make no such surface.
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
