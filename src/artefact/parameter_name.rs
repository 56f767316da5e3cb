//! The names and ranges of the parameters of experiments.

use serde::Serialize;
use std::ops::RangeInclusive;

/// The range of segments; some experiments have a smaller one.
pub(super) const SEGMENTS: RangeInclusive<u32> = 3..=1024;

/// A parameter of experiments. Not every experiment has all of them.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, Serialize)]
#[serde(rename_all = "kebab-case")]
pub enum ParameterName {
    /// [`Parameters::size`](super::Parameters::size).
    Size,
    /// [`Parameters::segments`](super::Parameters::segments).
    Segments,
    /// [`Parameters::light`](super::Parameters::light).
    Light,
    /// [`Parameters::exponent`](super::Parameters::exponent).
    Exponent,
    /// [`Parameters::weight`](super::Parameters::weight).
    Weight,
    /// [`Parameters::crease`](super::Parameters::crease).
    Crease,
    /// [`Parameters::interpolation`](super::Parameters::interpolation).
    Interpolation,
    /// [`Setup::mesh`](super::Setup::mesh).
    Mesh,
}

impl ParameterName {
    /// All parameters.
    pub const ALL: [ParameterName; 8] = [
        ParameterName::Size,
        ParameterName::Segments,
        ParameterName::Light,
        ParameterName::Exponent,
        ParameterName::Weight,
        ParameterName::Crease,
        ParameterName::Interpolation,
        ParameterName::Mesh,
    ];

    /// The range of a number; `None` for parameters that are not numbers. An experiment may have a smaller range, see
    /// [`Experiment::range`](super::Experiment::range).
    pub fn range(self) -> Option<RangeInclusive<f64>> {
        match self {
            ParameterName::Size => Some(32.0..=1024.0),
            ParameterName::Segments => Some(f64::from(*SEGMENTS.start())..=f64::from(*SEGMENTS.end())),
            ParameterName::Light => Some(-180.0..=180.0),
            ParameterName::Exponent => Some(0.0..=1e6),
            ParameterName::Crease => Some(0.0..=180.0),
            ParameterName::Weight | ParameterName::Interpolation | ParameterName::Mesh => None,
        }
    }

    /// Its name, which is also that of the command-line option.
    pub fn name(self) -> &'static str {
        match self {
            ParameterName::Size => "size",
            ParameterName::Segments => "segments",
            ParameterName::Light => "light",
            ParameterName::Exponent => "exponent",
            ParameterName::Weight => "weight",
            ParameterName::Crease => "crease",
            ParameterName::Interpolation => "interpolation",
            ParameterName::Mesh => "mesh",
        }
    }
}
