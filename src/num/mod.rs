//! Numbers without meshes (layer 0).

mod angle;
mod colour;
mod corner_angle;
mod digits;
mod dispatch;
mod exact;
mod lanes;
mod least_squares;
#[cfg(any(test, feature = "stress"))]
pub(crate) mod numbers;
mod power;
mod product;
mod real;
mod scale;
mod steepness;
mod sum;
mod unit;
mod viridis;

pub use angle::{Degrees, Radians, angle_between};
pub use colour::{LinearRgb, Srgb8, Transfer};
pub use digits::{powers_of_ten, significant_digits, three_digits};
pub use power::{Power, Underflow, exp2, log2};
pub use real::Real;
pub use scale::unit_scale;
pub use steepness::{largest_exponent, steepest_slope};
pub use sum::CompensatedSum;
pub use unit::UnitVec3;

pub(crate) use corner_angle::{corner_angle, triangle_angles};
pub(crate) use digits::{Nine, NineEach, superscript};
pub(crate) use dispatch::{Kernel, dispatch};
pub(crate) use exact::ExactSum;
pub(crate) use lanes::{Arithmetic, LANES, Lanes, OneLane, Rows, Scalars, Truth, Vectors};
pub(crate) use least_squares::least_squares;
#[cfg(test)]
pub(crate) use numbers as test_numbers;
#[cfg(feature = "stress")]
pub(crate) use product::difference_of_products;
pub(crate) use product::{Product, Split, cross};
pub(crate) use sum::two_difference;
pub(crate) use unit::{PLAIN_SQUARES, direction, exponent, power_of_two, scale, squared_length};
pub(crate) use viridis::viridis;
