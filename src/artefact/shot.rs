//! Pictures with captions. The role and caption of a picture follow from its measure.

use super::drawing::linear;
use super::effect::{Effect, SHARED, Threshold};
use crate::raster::Image;
use crate::text::{Text, Value};
use serde::{Serialize, Serializer};

/// What a picture shows.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
#[serde(rename_all = "kebab-case")]
pub enum Role {
    /// The artefact.
    Bad,
    /// The same without, or with little of it.
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
    /// What was found.
    pub value: f64,
    /// From what size on it is seen.
    pub present: Threshold,
}

/// A picture.
#[derive(Clone, Debug, Serialize)]
pub struct Shot {
    /// Its name within the experiment: lower-case letters, digits and hyphens.
    pub name: &'static str,
    /// What it shows.
    pub role: Role,
    /// What stands below it, in a few words.
    pub label: Text,
    /// What there is to see in it, in a sentence: also for those who cannot see it.
    pub caption: Text,
    /// What its role follows from; none of differences and of the surface itself.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub measured: Option<Amount>,
    /// The picture, with its linear samples.
    #[serde(rename = "size", serialize_with = "size")]
    pub image: Image,
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
        Shot { name, role, label, caption, measured: Some(measured), image }
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
