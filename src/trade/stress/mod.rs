//! The numerical extremes: a catalogue of cases, each with an expectation.
//!
//! A case computes something with this library at the limits of floating-point numbers and compares it with the truth: face
//! normals with exact integers and a 256-bit root, everything else with the same formula in 256 bits. It states the bound
//! of the error and its source, for [`Precision::Faithful`] and, where the case concerns it, for [`Precision::Fast`]. Where
//! there is no such choice, as with light on a point, these are `f64` and `f32`. For comparison, each case also has the error
//! of the formula as it is usually written, in plain `f32`. If that formula fails in exact arithmetic too, its definition is
//! the cause, as in an octahedral code with sign(0) = 0; otherwise it is overflow or rounding.
//!
//! ```
//! use crease::trade::stress::{Group, catalogue};
//!
//! for case in catalogue().iter().filter(|case| case.group == Group::Product) {
//!     let result = case.run();
//!     assert!(result.holds() && result.plain_failure().is_some());
//! }
//! ```
//!
//! Inputs are made from fixed seeds, so that two runs give the same errors to the bit, at any number of threads. All of
//! it takes some seconds.
//!
//! [`Precision::Faithful`]: crate::normals::Precision::Faithful
//! [`Precision::Fast`]: crate::normals::Precision::Fast

// A case and its result; texts.en.ftl has the words of all cases.
mod case;
// Errors, and how many results have none.
mod measured;
// Reproducible random vectors and rotations.
mod random;
// The formulas as usually written, in f32.
mod plain;
// The names that the cases of every group use.
mod prelude;
// Products, unit vectors and corner angles.
mod arithmetic;
// Face normals against exact arithmetic.
mod face_normals;
// Vertex normals of fans against 256-bit arithmetic.
mod fans;
// Coordinates at the limits of f32, and far from the origin.
mod magnitude;
// Slivers and faces of zero area.
mod degenerate;
// Many faces at one vertex, faces that meet as in no smooth surface, and quadrics through rounded points.
mod fan_shapes;
// Dihedral angles equal to the crease angle.
mod creases;
// Normals in few bits.
mod encodings;
// Highlights: large exponents, light from behind, half-vectors of nearly no length.
mod light;
// Triangles that are hard to draw, and the pixels that they cover.
mod triangles;

pub use case::{Bound, Cause, Group, StressCase, StressResult, Unit};
pub use measured::{Measured, Worst};

/// All cases, group by group in the order of [`Group::ALL`].
pub fn catalogue() -> Vec<StressCase> {
    Group::ALL.into_iter().flat_map(cases_of).collect()
}

/// The cases of one group.
pub fn cases_of(group: Group) -> Vec<StressCase> {
    match group {
        Group::Magnitude => magnitude::magnitude_cases(),
        Group::Offset => magnitude::offset_cases(),
        Group::Needle => degenerate::sliver_cases(),
        Group::Degenerate => degenerate::zero_area_cases(),
        Group::NonFinite => degenerate::non_finite_cases(),
        Group::Valence => fan_shapes::valence_cases(),
        Group::Fan => fan_shapes::fan_cases(),
        Group::Angle => arithmetic::angle_cases(),
        Group::Crease => creases::cases(),
        Group::Unit => arithmetic::unit_vector_cases(),
        Group::Product => arithmetic::product_cases(),
        Group::Highlight => light::highlight_cases(),
        Group::Attenuation => light::attenuation_cases(),
        Group::Raster => triangles::cases(),
        Group::Encoding => encodings::cases(),
    }
}
