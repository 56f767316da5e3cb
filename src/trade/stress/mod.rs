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

mod angle;
mod attenuation;
mod case;
mod crease;
mod degenerate;
mod encoding;
mod fan;
mod fans;
mod group;
mod highlight;
mod lit;
mod magnitude;
mod needle;
mod non_finite;
mod offset;
mod plain;
mod product;
mod quadric;
mod raster;
mod scan;
mod triangles;
mod unit;
mod valence;

pub use case::{Bound, Measured, StressCase, StressResult, Unit, Worst};
pub use group::Group;

/// All cases, group by group in the order of [`Group::ALL`].
pub fn catalogue() -> Vec<StressCase> {
    Group::ALL.into_iter().flat_map(cases_of).collect()
}

/// The cases of one group.
pub fn cases_of(group: Group) -> Vec<StressCase> {
    match group {
        Group::Magnitude => magnitude::cases(),
        Group::Offset => offset::cases(),
        Group::Needle => needle::cases(),
        Group::Degenerate => degenerate::cases(),
        Group::NonFinite => non_finite::cases(),
        Group::Valence => valence::cases(),
        Group::Fan => fan::cases().into_iter().chain(quadric::cases()).collect(),
        Group::Angle => angle::cases(),
        Group::Crease => crease::cases(),
        Group::Unit => unit::cases(),
        Group::Product => product::cases(),
        Group::Highlight => highlight::cases(),
        Group::Attenuation => attenuation::cases(),
        Group::Raster => raster::cases(),
        Group::Encoding => encoding::cases(),
    }
}
