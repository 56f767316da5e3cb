//! Numbers without meshes (layer 0).

// Angles that carry their unit.
mod angle;
// Statistics of angles: mean, root mean square and percentiles.
mod angle_statistics;
// Colour: linear light, the sRGB transfer and the rules that make whole numbers of it.
mod colour;
// The angle of a corner, without the platform's arc tangent.
mod corner_angle;
// Numbers as text for people.
mod digits;
// Running a kernel with the instructions that the CPU has.
mod dispatch;
// Sums without any rounding error.
mod exact;
// Eight numbers at a time, with the instructions that the CPU has.
mod lanes;
// Linear least squares by Householder's QR decomposition, eight at a time.
mod least_squares;
// Names of the variants of enumerations.
mod names;
// Reproducible numbers to test with.
#[cfg(any(test, feature = "stress"))]
pub(crate) mod numbers;
// Lists of a fixed length in files.
mod list;
// Loops on all threads, compiled once.
pub(crate) mod parallel;
// xⁿ by arithmetic alone: no call in the loop, the same bits on every machine, many at once.
mod power;
// The two precisions of generic formulas.
mod real;
// Powers of two that bring numbers to a size at which products neither overflow nor vanish.
mod scale;
// How much a highlight amplifies a small error of an angle.
mod steepness;
// Sums that keep their own rounding errors.
mod sum;
// Vectors of length 1.
mod unit;
// Colours for quantities, in order of lightness, so that they differ in grey.
mod viridis;

pub use angle::{Degrees, Radians, angle_between};
pub use angle_statistics::AngleErrors;
pub use colour::{LinearRgb, Srgb8, Transfer};
pub use digits::{powers_of_ten, significant_digits, six_digits, three_digits};
pub use power::{Power, Underflow, exp2, log2};
pub use real::Real;
pub use scale::unit_scale;
pub use steepness::{largest_exponent, steepest_slope};
pub use sum::CompensatedSum;
pub use unit::UnitVec3;
pub use viridis::viridis;

pub(crate) use corner_angle::{corner_angle, triangle_angles};
pub(crate) use digits::{Nine, NineEach, superscript};
pub(crate) use dispatch::{Kernel, dispatch};
pub(crate) use exact::ExactSum;
#[cfg(feature = "stress")]
pub(crate) use lanes::product::difference_of_products;
pub(crate) use lanes::product::{Product, Split, cross};
pub(crate) use lanes::{Arithmetic, Eight, EightLanes, LANES, Lanes, OneLane, Scalars, Truth, Vectors};
pub(crate) use least_squares::{Column, LeastSquares, Pivoting, ROWS, least_squares};
pub(crate) use list::{List, list};
pub(crate) use names::names;
#[cfg(test)]
pub(crate) use numbers as test_numbers;
pub(crate) use sum::two_difference;
pub(crate) use unit::{PLAIN_SQUARES, direction, exponent, power_of_two, scale, squared_length};
