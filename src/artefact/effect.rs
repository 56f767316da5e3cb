//! The number that a cure changes: whether the artefact is present and whether it is cured, and the pictures that show it.

use super::drawing::{linear, map};
use crate::raster::Image;
use crate::text::{Catalogue, Text, Value, catalogue};
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
    /// The number with the artefact.
    pub bad: f64,
    /// The size above which there is an artefact.
    pub present: Threshold,
    /// How the artefact is removed.
    pub cure: Text,
    /// The number after that.
    pub cured: f64,
    /// The factor by which the cure has to reduce the number.
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

/// What a picture shows.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
#[serde(rename_all = "kebab-case")]
pub enum Role {
    /// The artefact.
    Bad,
    /// The same without the artefact, or with little of it.
    Cured,
    /// A cure that does too little.
    Attempt,
    /// No artefact with these parameters, and nothing to cure.
    Absent,
    /// The difference of two pictures, or a map of an error.
    Difference,
    /// The surface itself.
    Truth,
    /// An artefact so faint that maps next to the picture show it.
    Seen,
}

/// The amount of the artefact in a picture.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Amount {
    /// What it measures.
    pub name: Text,
    /// Its unit; empty for none.
    pub unit: &'static str,
    /// The measured value.
    pub value: f64,
    /// The size above which it is visible.
    pub present: Threshold,
}

/// The scale of a map: from 0, violet, to the full value, yellow.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct MapScale {
    /// The value of the last colour.
    pub full: f64,
    /// Its unit; empty for linear luminance and other numbers without one.
    pub unit: &'static str,
}

/// A picture.
#[derive(Clone, Debug, Serialize)]
pub struct Shot {
    /// Its name within the experiment: lower-case letters, digits and hyphens.
    pub name: &'static str,
    /// What it shows.
    pub role: Role,
    /// The label below it, in a few words.
    pub label: Text,
    /// What it shows, in a sentence: its alternative text.
    pub caption: Text,
    /// The amount that determines its role; `None` for differences and for the surface itself.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub measured: Option<Amount>,
    /// The scale of its colours, if it is a map.
    #[serde(skip)]
    pub map: Option<MapScale>,
    /// The picture, with its linear samples.
    #[serde(rename = "size", serialize_with = "size")]
    pub image: Image,
}

impl Shot {
    /// The largest difference of the components' 8-bit codes, pixel by pixel, between the first picture of the artefact in a series
    /// ([`Outcome::series`](super::Outcome::series)) and the first without it that has the same size. `None` if there are no such
    /// pictures, or if the series has a difference already.
    pub fn difference(series: &[Shot]) -> Option<Shot> {
        let first =
            |roles: &[Role]| series.iter().find(|shot| roles.contains(&shot.role)).map(|shot| &shot.image);
        let [bad, cured] = [first(&[Role::Bad])?, first(&[Role::Cured, Role::Attempt])?];
        if bad.size != cured.size || first(&[Role::Difference]).is_some() {
            return None;
        }
        let [width, height] = bad.size;
        let pixels = (0..height).flat_map(|y| (0..width).map(move |x| (x, y)));
        let steps = pixels.map(|(x, y)| {
            let (a, b) = (bad.pixel(x, y)?, cured.pixel(x, y)?);
            a.into_iter().zip(b).map(|(a, b)| a.abs_diff(b)).max()
        });
        let covered = bad.coverage.iter().zip(&cured.coverage).map(|(a, b)| a | b > 0);
        let values: Vec<Option<f64>> = steps
            .zip(covered)
            .map(|(steps, is_covered)| steps.filter(|_| is_covered).map(f64::from))
            .collect();
        let full = values.iter().flatten().copied().fold(1.0, f64::max);
        let text = |key: &str| SHARED.with(key, &[("full", full.into())]);
        Some(Shot {
            name: "difference",
            role: Role::Difference,
            label: text("difference-title"),
            caption: text("difference-caption"),
            measured: None,
            map: Some(MapScale { full, unit: "" }),
            image: map(bad.size, &values, full),
        })
    }
}

fn size<S: Serializer>(image: &Image, serializer: S) -> Result<S::Ok, S::Error> {
    image.size.serialize(serializer)
}

/// The label of a picture, what is drawn in it whatever was measured, and what it shows if the artefact is present or cured.
pub(super) struct Caption {
    pub(super) label: Text,
    pub(super) drawn: Text,
    pub(super) seen: Option<Text>,
}

impl Effect {
    /// A picture of the artefact, or of the cure, with its number at the end of its caption. A state that contradicts the caption
    /// has a sentence of its own.
    pub(super) fn shot(&self, name: &'static str, is_cure: bool, caption: Caption, image: Image) -> Shot {
        let (role, state) = match (is_lit(&image), self.is_present(), is_cure) {
            (false, ..) => (Role::Absent, Some("not-lit")),
            (true, false, false) => (Role::Absent, Some("no-artefact")),
            (true, false, true) => (Role::Absent, Some("nothing-to-cure")),
            (true, true, false) => (Role::Bad, None),
            (true, true, true) if self.is_cured() => (Role::Cured, None),
            (true, true, true) => (Role::Attempt, Some("too-little")),
        };
        let value = if is_cure { self.cured } else { self.bad };
        let Caption { label, drawn, seen } = caption;
        let number = |value: f64| Value::quantity(self.reported(value), self.unit);
        let seen = state.map(|key| SHARED.with(key, &[("without", number(self.bad))])).or(seen);
        let sentences = Text::each(|language| {
            let seen = seen.as_ref().map_or("", |text| text.get(language));
            format!("{} {seen}", drawn.get(language)).trim().trim_end_matches('.').to_owned()
        });
        let values = [("drawn", sentences.into()), ("name", (&self.name).into()), ("value", number(value))];
        let caption = SHARED.with("caption", &values);
        let measured =
            Amount { name: self.name.clone(), unit: self.unit, value, present: self.present.clone() };
        Shot { name, role, label, caption, measured: Some(measured), map: None, image }
    }
}

/// Whether anything that is covered is brighter than half a step of 8 bits.
fn is_lit(image: &Image) -> bool {
    let pixels = linear(image).iter().zip(&image.coverage);
    let brightest = |colour: &[f32; 3]| colour.iter().copied().fold(0.0, f32::max);
    pixels
        .filter(|&(_, &covered)| covered > 0)
        .any(|(colour, _)| f64::from(brightest(colour)) > Threshold::HALF_STEP)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::artefact::drawing::picture;
    use crate::text::Language;

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

    #[test]
    fn roles_and_captions_follow_the_measure() {
        let effect = |bad: f64, cured: f64| Effect {
            name: Text::same("size of it"),
            unit: "px",
            bad,
            present: Threshold::half_pixel(),
            cure: Text::same("y"),
            cured,
            factor: 4.0,
        };
        let image = |light: f32| picture([1, 1], vec![[light; 3]], vec![1]);
        let caption = || Caption {
            label: Text::same("a"),
            drawn: Text::same("A box."),
            seen: Some(Text::same("It shows.")),
        };
        for (light, bad, cured, roles, [of_bad, of_cured]) in [
            (
                0.5,
                3.0,
                0.25,
                [Role::Bad, Role::Cured],
                ["A box. It shows (size of it: 3 px).", "A box. It shows (size of it: 0.25 px)."],
            ),
            (
                0.5,
                3.0,
                1e-9,
                [Role::Bad, Role::Cured],
                ["A box. It shows (size of it: 3 px).", "A box. It shows (size of it: 0 px)."],
            ),
            (
                0.5,
                3.0,
                1.0,
                [Role::Bad, Role::Attempt],
                [
                    "A box. It shows (size of it: 3 px).",
                    "A box. The cure does too little here: 3 px without it (size of it: 1 px).",
                ],
            ),
            (
                0.5,
                0.4,
                0.4,
                [Role::Absent; 2],
                [
                    "A box. No artefact is measured here (size of it: 0.4 px).",
                    "A box. There is no artefact to cure here: 0.4 px without the cure (size of it: 0.4 px).",
                ],
            ),
            (
                0.001,
                3.0,
                0.25,
                [Role::Absent; 2],
                [
                    "A box. Nothing is lit here (size of it: 3 px).",
                    "A box. Nothing is lit here (size of it: 0.25 px).",
                ],
            ),
        ] {
            let effect = effect(bad, cured);
            let shots = [
                effect.shot("a", false, caption(), image(light)),
                effect.shot("b", true, caption(), image(light)),
            ];
            assert_eq!(shots.each_ref().map(|shot| shot.role), roles);
            assert_eq!(shots.each_ref().map(|shot| shot.caption.get(Language::English)), [of_bad, of_cured]);
        }
    }
}
