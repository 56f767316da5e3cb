//! The numerical extremes: a catalogue of cases, each with an expectation.
//!
//! A case computes something with this library at the end of what numbers can hold, and compares it with the truth: face
//! normals with exact integers and a 256-bit root, everything else with the same formula in 256 bits. It states the bound
//! that the error has to keep to and where the bound comes from, for [`Precision::Faithful`] and, where it concerns it, for
//! [`Precision::Fast`]; where there is no such choice, as with light on a point, these are `f64` and `f32`. Beside it stands
//! what the formula gives as it is usually written, in plain `f32`.
//!
//! ```
//! use crease::trade::stress::{Group, catalogue};
//!
//! for case in catalogue().iter().filter(|case| case.group == Group::Product) {
//!     let result = case.run();
//!     assert!(result.holds() && result.plain_fails());
//! }
//! ```
//!
//! Inputs are made from fixed seeds, so that two runs give the same errors to the bit, at any number of threads. All of
//! it takes some seconds.
//!
//! [`Precision::Faithful`]: crate::normals::Precision::Faithful
//! [`Precision::Fast`]: crate::normals::Precision::Fast

// The groups of cases.
mod group;
// A case and its outcome.
mod case;
// Cases about normals.
mod normals;
// Cases about lighting and drawing.
mod pictures;
pub use case::{Bound, Measured, StressCase, StressResult, Unit, Worst};
pub use group::Group;

/// All cases, group by group in the order of [`Group::ALL`].
pub fn catalogue() -> Vec<StressCase> {
    Group::ALL.into_iter().flat_map(cases_of).collect()
}

/// The cases of one group.
pub fn cases_of(group: Group) -> Vec<StressCase> {
    match group {
        Group::Magnitude => normals::magnitude::cases(),
        Group::Offset => normals::offset::cases(),
        Group::Needle => normals::sliver::cases(),
        Group::Degenerate => normals::degenerate::cases(),
        Group::NonFinite => normals::non_finite::cases(),
        Group::Valence => normals::valence::cases(),
        Group::Fan => normals::fan::cases().into_iter().chain(normals::quadric::cases()).collect(),
        Group::Angle => normals::angle::cases(),
        Group::Crease => normals::crease::cases(),
        Group::Unit => normals::unit::cases(),
        Group::Product => normals::product::cases(),
        Group::Highlight => pictures::highlight::cases(),
        Group::Attenuation => pictures::attenuation::cases(),
        Group::Raster => pictures::triangles::cases(),
        Group::Encoding => normals::encoding::cases(),
    }
}
