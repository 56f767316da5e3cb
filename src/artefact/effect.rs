//! The number that a cure changes: whether the artefact is present, and whether it is cured.

use crate::text::{Catalogue, Text, catalogue};
use serde::{Serialize, Serializer};
use std::f64::consts::PI;

pub(super) static SHARED: Catalogue = catalogue!("shared");

/// A number with the artefact and without.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Effect {
    /// What it measures.
    pub name: Text,
    /// Its unit; empty for none.
    pub unit: &'static str,
    /// With the artefact.
    pub bad: f64,
    /// The size above which there is an artefact.
    pub present: Threshold,
    /// What was done about it.
    pub cure: Text,
    /// After that.
    pub cured: f64,
    /// How many times smaller the cure has to make it.
    pub factor: f64,
}

/// A size above which something is visible.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Threshold {
    /// The size, in the unit of what is measured.
    pub value: f64,
    /// The reason for this size.
    pub why: Text,
}

impl Threshold {
    /// Half a step of light from 0 to 1 in 8 bits.
    pub const HALF_STEP: f64 = 0.5 / 255.0;
    /// Half a pixel of an outline.
    pub const HALF_PIXEL: f64 = 0.5;

    /// [`HALF_STEP`](Self::HALF_STEP) with its reason.
    pub fn half_step() -> Self {
        Self { value: Self::HALF_STEP, why: SHARED.get("half-step") }
    }

    /// [`HALF_PIXEL`](Self::HALF_PIXEL) with its reason.
    pub fn half_pixel() -> Self {
        Self { value: Self::HALF_PIXEL, why: SHARED.get("half-pixel") }
    }

    /// The angle in degrees by which a normal in light from the side changes diffuse light by half a step of 8 bits:
    /// there N·L is steepest, and changes by as much as the angle in radians.
    pub fn half_step_of_tilt() -> Self {
        Self { value: 0.5 / 255.0 * 180.0 / PI, why: SHARED.get("half-step-of-tilt") }
    }
}

impl Effect {
    /// How many times smaller it became; infinite if it vanished, 1 if there was nothing to cure.
    pub fn reduction(&self) -> f64 {
        if self.bad == 0.0 && self.cured == 0.0 { 1.0 } else { self.bad.abs() / self.cured.abs() }
    }

    /// A value as texts state it: 0 if it is less than a thousandth of the threshold. For light from 0 to 1, and for
    /// tilts in radians, that is 2·10⁻⁶, about sixteen roundings of single precision.
    pub(crate) fn reported(&self, value: f64) -> f64 {
        if value.abs() < 1e-3 * self.present.value { 0.0 } else { value }
    }

    /// Whether there is an artefact at all.
    pub fn is_present(&self) -> bool {
        self.bad.abs() > self.present.value
    }

    /// Whether the artefact is below the threshold, or smaller by the factor.
    pub fn is_cured(&self) -> bool {
        self.cured.abs() <= self.present.value || self.reduction() >= self.factor
    }
}

/// An effect as JSON, with two members more: `is_present` and `is_cured`.
pub(super) fn judged<S: Serializer>(effect: &Effect, serializer: S) -> Result<S::Ok, S::Error> {
    #[derive(Serialize)]
    struct Judged<'a> {
        #[serde(flatten)]
        effect: &'a Effect,
        is_present: bool,
        is_cured: bool,
    }
    let (is_present, is_cured) = (effect.is_present(), effect.is_cured());
    Judged { effect, is_present, is_cured }.serialize(serializer)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn roundings_are_reported_as_nothing() {
        let effect = Effect {
            name: Text::same("x"),
            unit: "",
            bad: 0.5,
            present: Threshold::half_step(),
            cure: Text::same("y"),
            cured: 0.0,
            factor: 4.0,
        };
        assert_eq!(
            [8.87e-7, -1e-7, 2e-6, 0.0019].map(|value| effect.reported(value)),
            [0.0, 0.0, 2e-6, 0.0019]
        );
    }

    #[test]
    fn what_is_seen_has_to_vanish_or_to_shrink() {
        let effect = |bad, cured| Effect {
            name: Text::same("x"),
            unit: "",
            bad,
            present: Threshold::half_pixel(),
            cure: Text::same("y"),
            cured,
            factor: 4.0,
        };
        for (bad, cured, is_present, is_cured) in [
            (0.49, 0.49, false, true),
            (-3.0, -0.7, true, true),
            (3.0, 0.8, true, false),
            (0.6, 0.4, true, true),
            (f64::NAN, f64::NAN, false, false),
        ] {
            let effect = effect(bad, cured);
            assert_eq!((effect.is_present(), effect.is_cured()), (is_present, is_cured), "{bad} {cured}");
            let json = judged(&effect, serde_json::value::Serializer).unwrap();
            assert_eq!((&json["is_present"], &json["is_cured"]), (&is_present.into(), &is_cured.into()));
        }
        assert_eq!([effect(0.0, 0.0).reduction(), effect(1.0, 0.0).reduction()], [1.0, f64::INFINITY]);
    }
}
