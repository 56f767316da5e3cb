//! The weights of the experiment, with the keys of their names.

/// The weights that are means over triangles.
use super::super::prelude::*;

pub(super) const MEANS: [(Weight, &str); 6] = [
    (Weight::Uniform, "equal-weights"),
    (Weight::Area, "area-weights"),
    (Weight::Angle, "angle-weights"),
    (Weight::AngleArea, "angle-area-weights"),
    (Weight::Max, "max-weights"),
    (Weight::Edge, "edge-weights"),
];

/// The weights that do not change when flat faces are cut, and those that are exact on spheres.
pub(super) const FLAT: Weight = Weight::Angle;
pub(super) const ROUND: Weight = Weight::Max;

/// The name of a weight.
pub(super) fn name(weight: Weight, out: &Recorder) -> Value {
    let known = MEANS.iter().find(|(known, _)| *known == weight);
    known.map_or_else(|| weight.name().into(), |(_, key)| out.text(key).into())
}
