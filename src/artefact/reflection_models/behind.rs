//! Light from behind the sphere, and what of it a highlight shows on the dark side.

use super::super::stage::linear;
use super::super::{ArtefactError, Measure, Moved, Shot, Text};
use super::texts::TEXTS;
use super::{WINDOW, ball};
use crate::num::{Degrees, Radians};
use crate::raster::Image;
use crate::shade::{Guards, Reflection};
use glam::DVec3;

/// Light almost behind the sphere.
const BEHIND: Degrees = Degrees(150.0);

/// The normal of the sphere at a pixel of a picture of this size.
fn normal(pixel: u32, size: u32) -> Option<DVec3> {
    let place = |k: u32| ((f64::from(k) + 0.5) / f64::from(size) - 0.5) * WINDOW;
    let (x, y) = (place(pixel % size), place(pixel / size));
    let square = 1.0 - x * x - y * y;
    (square > 0.0).then(|| DVec3::new(x, y, square.sqrt()))
}

fn light() -> DVec3 {
    let (sine, cosine) = libm::sincos(Radians::from(BEHIND).0);
    DVec3::new(sine, 0.0, cosine)
}

/// Pixels with N·L < 0, by more than single precision leaves open.
fn turned_away(size: u32) -> impl Iterator<Item = (usize, DVec3)> {
    let pixels = (0..size * size).filter_map(move |pixel| Some((pixel as usize, normal(pixel, size)?)));
    pixels.filter(|(_, normal)| normal.dot(light()) < -1e-6)
}

/// The brightest of them.
fn brightest(image: &Image) -> f64 {
    let pixels = linear(image);
    turned_away(image.size[0]).map(|(pixel, _)| f64::from(pixels[pixel][0])).fold(0.0, f64::max)
}

/// The same by the formula: Blinn's (N·H)ⁿ or Phong's (R·V)ⁿ.
fn law(reflection: Reflection, exponent: f64, size: u32) -> f64 {
    let light = light();
    let half = (light + DVec3::Z).normalize();
    let cosine = |normal: DVec3| match reflection {
        Reflection::Blinn => normal.dot(half),
        Reflection::Phong => (2.0 * normal.dot(light) * normal - light).z,
    };
    let highlight = |(_, normal): (usize, DVec3)| libm::pow(cosine(normal).max(0.0), exponent);
    turned_away(size).map(highlight).fold(0.0, f64::max)
}

/// One model's highlight under light from behind, without the guard and with it.
pub(super) struct Behind {
    reflection: Reflection,
    exponent: f64,
    unguarded: Image,
    guarded: Image,
    moved: Moved,
}

impl Behind {
    /// `moved` has what does not depend on the model.
    pub(super) fn new(
        reflection: Reflection,
        exponent: f64,
        size: u32,
        moved: &Moved,
    ) -> Result<Self, ArtefactError> {
        let on = Guards::default();
        let off = Guards { highlight: false, ..on };
        let [unguarded, guarded] = [off, on].map(|guards| ball(reflection, exponent, BEHIND, guards, size));
        let (unguarded, guarded) = (unguarded?, guarded?);
        let moved = Moved {
            name: TEXTS.get("moved-brightest-pixel-faces"),
            bad: brightest(&unguarded),
            cured: brightest(&guarded),
            ..moved.clone()
        };
        Ok(Self { reflection, exponent, unguarded, guarded, moved })
    }

    fn name(&self) -> &'static str {
        match self.reflection {
            Reflection::Phong => "Phong",
            Reflection::Blinn => "Blinn",
        }
    }

    pub(super) fn measures(&self) -> [Measure; 2] {
        let name = self.name();
        let size = self.unguarded.size[0];
        let by = match self.reflection {
            Reflection::Phong => TEXTS.get("r-v-n"),
            Reflection::Blinn => TEXTS.get("n-h-n"),
        };
        let unguarded = TEXTS.with("name-light-no", &[("name", name.into())]);
        let guarded = TEXTS.with("name-same-guard", &[("name", name.into())]);
        [
            Measure::new(unguarded, "", self.moved.bad).expect(
                law(self.reflection, self.exponent, size),
                1e-6 * (1.0 + self.exponent),
                by,
            ),
            Measure::new(guarded, "", self.moved.cured).expect(0.0, 0.0, TEXTS.get("by-nothing-behind")),
        ]
    }

    pub(super) fn shots(self) -> [Shot; 2] {
        let name = self.name();
        let names = match self.reflection {
            Reflection::Phong => ["behind-phong", "behind-phong-guarded"],
            Reflection::Blinn => ["behind", "behind-guarded"],
        };
        let label = |guard: [&str; 2]| {
            Text::made(
                format!("{name}, light behind, {}", guard[0]),
                format!("{name}, luz atrás, {}", guard[1]),
            )
        };
        let lit = TEXTS
            .with("highlight-n-exponent", &[("exponent", self.exponent.into()), ("value", BEHIND.0.into())]);
        use super::super::Language::{English, Portuguese};
        let lit = Text::made(
            format!("{name}{}", lit.get(English)),
            format!("O brilho de {name}{}", lit.get(Portuguese)),
        );
        [
            self.moved.bad_shot(
                names[0],
                label(["no guard", "sem guarda"]),
                [lit, TEXTS.get("shot-yet-highlight-spreads")],
                self.unguarded,
            ),
            self.moved.cured_shot(
                names[1],
                label(["guard", "com guarda"]),
                [TEXTS.get("shot-guard-n-l"), TEXTS.get("shot-highlight-ends-light")],
                self.guarded,
            ),
        ]
    }
}
