//! What becomes of colours that no screen can show.

use crate::num::Real;
use serde::Deserialize;

/// How a colour out of range is brought into it (F25; exercise 1.6.17b).
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum ToneRule {
    /// Each component is clamped to 0…1: the hue of what is too bright changes.
    #[default]
    Clamp,
    /// A colour with a component over 1 is divided by its largest: the hue stays. Then clamped at 0.
    #[serde(rename = "max")]
    DivideByMax,
}

impl ToneRule {
    /// The name used in scenes and on the command line.
    pub fn name(self) -> &'static str {
        match self {
            ToneRule::Clamp => "clamp",
            ToneRule::DivideByMax => "max",
        }
    }

    /// The colour, each component in 0…1.
    ///
    /// ```
    /// use crease::shade::ToneRule;
    ///
    /// assert_eq!(ToneRule::Clamp.apply([0.9, 1.25, 0.5]), [0.9, 1.0, 0.5]);
    /// assert_eq!(ToneRule::DivideByMax.apply([0.9, 1.25, 0.5]), [0.72, 1.0, 0.4]);
    /// ```
    #[inline(always)]
    pub fn apply<R: Real>(self, colour: [R; 3]) -> [R; 3] {
        let [r, g, b] = colour;
        let scaled = match self {
            ToneRule::Clamp => colour,
            ToneRule::DivideByMax => {
                let largest = larger(larger(r, g), larger(b, R::ONE));
                [r / largest, g / largest, b / largest]
            }
        };
        let [r, g, b] = scaled;
        [clamped(r), clamped(g), clamped(b)]
    }
}

#[inline(always)]
fn larger<R: Real>(a: R, b: R) -> R {
    if a > b { a } else { b }
}

#[inline(always)]
fn clamped<R: Real>(x: R) -> R {
    let x = if x < R::ZERO { R::ZERO } else { x };
    if x > R::ONE { R::ONE } else { x }
}
