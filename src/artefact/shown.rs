//! What a picture shows, by its number: role and caption follow from what was measured, so that neither can contradict it.

use super::stage::linear;
use super::{Amount, Moved, Role, Shot, Text, Threshold};
use crate::raster::Image;
use crate::text::{Catalogue, catalogue};

static TEXTS: Catalogue = catalogue!("shown");

impl Moved {
    /// A picture that is there for the artefact: `drawn` is what is drawn in it whatever came of it, `seen` what there is to see
    /// of the artefact if it is there.
    pub(super) fn bad_shot(
        &self,
        name: &'static str,
        label: Text,
        [drawn, seen]: [Text; 2],
        image: Image,
    ) -> Shot {
        let (role, reported) = match (is_lit(&image), self.is_present()) {
            (false, _) => (Role::Absent, TEXTS.get("nothing-lit-here")),
            (true, false) => (Role::Absent, TEXTS.get("nothing-artefact-measured")),
            (true, true) => (Role::Bad, seen),
        };
        self.shot(name, role, label, [drawn, reported], self.bad, image)
    }

    /// A picture that is there for the cure: `drawn` as above, `seen` what there is to see if the cure does what it has to.
    pub(super) fn cured_shot(
        &self,
        name: &'static str,
        label: Text,
        [drawn, seen]: [Text; 2],
        image: Image,
    ) -> Shot {
        let (role, reported) = match (is_lit(&image), self.is_present(), self.is_cured()) {
            (false, ..) => (Role::Absent, TEXTS.get("nothing-lit-here")),
            (true, false, _) => (Role::Absent, self.nothing_to_cure()),
            (true, true, true) => (Role::Cured, seen),
            (true, true, false) => (Role::Attempt, self.too_little()),
        };
        self.shot(name, role, label, [drawn, reported], self.cured, image)
    }

    /// A picture with its number behind its caption.
    fn shot(
        &self,
        name: &'static str,
        role: Role,
        label: Text,
        [drawn, reported]: [Text; 2],
        value: f64,
        image: Image,
    ) -> Shot {
        let caption = Text::each(|language| {
            let said = format!("{} {}", drawn.get(language), reported.get(language));
            let value = language.short(self.reported(value), self.unit);
            format!("{} ({}: {value}).", said.trim().trim_end_matches('.'), self.name.get(language))
        });
        let (name_of_measure, present) = (self.name.clone(), self.present.clone());
        let measured = Some(Amount { name: name_of_measure, unit: self.unit, value, present });
        Shot { name, role, label, caption, measured, image }
    }

    fn nothing_to_cure(&self) -> Text {
        TEXTS.with("nothing-cure-here", &[("without", self.with_unit(self.bad).into())])
    }

    fn too_little(&self) -> Text {
        TEXTS.with("does-too-little", &[("without", self.with_unit(self.bad).into())])
    }

    fn with_unit(&self, value: f64) -> Text {
        Text::each(|language| language.short(self.reported(value), self.unit))
    }
}

/// Whether anything that is covered is brighter than half a step of 8 bits.
fn is_lit(image: &Image) -> bool {
    let pixels = linear(image).iter().zip(&image.coverage);
    let brightest = |colour: &[f32; 3]| colour.iter().copied().fold(0.0, f32::max);
    pixels
        .filter(|&(_, &covered)| covered > 0)
        .any(|(colour, _)| f64::from(brightest(colour)) > Threshold::HALF_STEP.value)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::artefact::Language;
    use crate::artefact::stage::picture;

    #[test]
    fn roles_and_captions_follow_the_measure() {
        let moved = |bad: f64, cured: f64| Moved {
            name: Text::new("size of it", "tamanho disso"),
            unit: "px",
            bad,
            present: Threshold::HALF_PIXEL,
            cure: Text::same("y"),
            cured,
            factor: 4.0,
        };
        let image = |light: f32| picture([1, 1], vec![[light; 3]], vec![1]);
        let texts = || [Text::new("A box.", "Uma caixa."), Text::new("It shows.", "Aparece.")];
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
                    "A box. It does too little here, 3 px without it (size of it: 1 px).",
                ],
            ),
            (
                0.5,
                0.4,
                0.4,
                [Role::Absent; 2],
                [
                    "A box. Nothing of the artefact is measured here (size of it: 0.4 px).",
                    "A box. There was nothing to cure here, 0.4 px without it (size of it: 0.4 px).",
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
            let moved = moved(bad, cured);
            let shots = [
                moved.bad_shot("a", Text::same("a"), texts(), image(light)),
                moved.cured_shot("b", Text::same("b"), texts(), image(light)),
            ];
            assert_eq!(shots.each_ref().map(|shot| shot.role), roles);
            assert_eq!(shots.each_ref().map(|shot| shot.caption.get(Language::English)), [of_bad, of_cured]);
        }
    }
}
