//! Why there is no number.

/// Why pictures cannot be measured or compared.
#[derive(Clone, Copy, Debug, PartialEq, thiserror::Error)]
pub enum MetricError {
    /// They are not of one size.
    #[error("the pictures are {} by {} and {} by {} pixels; draw both at the same size", .0[0], .0[1], .1[0], .1[1])]
    Sizes([u32; 2], [u32; 2]),
    /// One has quantised colours only.
    #[error("a picture has no linear colours; draw it with RenderSettings::keep_linear")]
    NoLinear,
    /// Nothing is drawn in one of them.
    #[error("a picture shows nothing that could be measured; check its camera and its objects")]
    Empty,
    /// A row that the picture does not have.
    #[error("row {row} of a picture of {height} rows; rows count from 0 at the top")]
    Row {
        /// The row asked for.
        row: u32,
        /// How many there are.
        height: u32,
    },
    /// Standard deviations that make no centre and surround.
    #[error("Gaussians of {} and {} pixels; give finite widths above 0, the centre's smaller", .0[0], .0[1])]
    Widths([f64; 2]),
    /// Too few pixels for a slope.
    #[error("a slope from {0} pixels; take at least 3")]
    Reach(u32),
}
