//! Errors of pictures and pages.

pub(super) type Result<T, E = ReportError> = std::result::Result<T, E>;

/// Why a picture cannot be made into a file.
#[derive(Debug, thiserror::Error)]
pub enum ReportError {
    /// The number of pixels does not match the size.
    #[error("a picture of {0} by {1} pixels has {2} of them")]
    Pixels(u32, u32, usize),
    /// A side that the format has no room for.
    #[error("a {format} picture has sides of 1 to {largest} pixels, not {width} by {height}")]
    Size {
        /// The format.
        format: &'static str,
        /// Its longest side.
        largest: u32,
        /// The picture's width.
        width: u32,
        /// Its height.
        height: u32,
    },
    /// Frames of an animation that do not match its first one.
    #[error("frame {number} is {found:?} pixels, the first one {first:?}")]
    Frame {
        /// Which frame, counted from 0.
        number: usize,
        /// Its size.
        found: [u32; 2],
        /// That of the first frame.
        first: [u32; 2],
    },
    /// Nothing to show.
    #[error("there is no picture to show")]
    Empty,
    /// Positions or nodes of a file are out of the range of numbers.
    #[error(
        "a node moves positions beyond the range of numbers, where nothing can be drawn; correct its transform"
    )]
    Range,
    /// The error of the encoder.
    #[error("could not encode the picture: {0}")]
    Encoder(String),
}
