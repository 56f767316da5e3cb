//! How stored normals were made: the weighting and the crease angle that reproduce them best.

use crate::normals::{Crease, Groups, NormalRecipe, Weight};
use crate::num::{Degrees, three_digits};
use crate::quality::estimate::means::MEANS;
use crate::text::{Catalogue, Text, Value, catalogue};

static TEXTS: Catalogue = catalogue!("recipe");

/// The most corners that are sampled.
pub const SAMPLE: usize = 100_000;

/// The share of corners that a recipe reproduces if nothing else made them.
pub(crate) const NEARLY_ALL: f64 = 0.98;

/// A corner counts as reproduced within this many degrees.
pub(crate) const REPRODUCED: f64 = 5.0;

/// A corner counts as exactly reproduced within this many degrees: more than 32 bits and four decimals do, less than programs
/// differ by.
pub(crate) const EXACT: f64 = 0.1;

/// The share of exactly reproduced corners from which the others depart from a recipe: half, less a border between two halves.
const NEARLY_HALF: f64 = 0.4;

/// The share of corners that a recipe reproduces at least, once they are rotated back if a rotation explains them.
const MOST: f64 = 0.5;

/// The share of the error of the best recipe, or of its median, that a rotation of all normals may leave, and a fit in place of
/// a mean.
pub(crate) const LEFT: f64 = 0.5;

/// How the stored normals of a part were made, as far as they show it.
#[derive(Clone, Copy, Debug, PartialEq, serde::Serialize)]
pub struct Estimate {
    /// The weighting that reproduces them best. The quadric, a fit that costs more and depends on few neighbours, only if it
    /// leaves less than half of the error of the best mean, and if that error is more than 0.01° on average: finer meshes and
    /// coarser numbers show no difference.
    pub weight: Weight,
    /// The crease angle that reproduces them best: 0 if they are flat, 180 if no edge is sharp.
    pub crease: Degrees,
    /// Whether smoothing groups reproduce them better than a crease angle alone; the angle applies in addition.
    pub groups: bool,
    /// Whether all normals were rotated or reflected together: the estimate is of them rotated back.
    pub turned: bool,
    /// The number of corners in the sample.
    pub sample: usize,
    /// The share of them that it reproduces within 5°.
    pub reproduced: f64,
    /// The share of them that it reproduces within 1°.
    #[serde(skip)]
    pub closely: f64,
    /// The share of them that it reproduces within 0.1°.
    #[serde(skip)]
    pub exactly: f64,
    /// The share of the edges at them, without flat ones, that the crease angle puts on the right side.
    pub separated: f64,
    /// The median angle between stored and reproduced normals.
    pub median: Degrees,
    /// The lowest crease angle that makes the same normals, and the one from which on others result; 180 if none does.
    #[serde(skip)]
    pub creases: [Degrees; 2],
    /// Whether each of the averages fits equally well, within the tolerance that the best reaches.
    #[serde(skip)]
    pub ties: [bool; MEANS.len()],
}

impl Estimate {
    /// The recipe.
    pub fn recipe(&self) -> NormalRecipe {
        NormalRecipe {
            weight: self.weight,
            crease: Crease::Angle(self.crease),
            groups: if self.groups { Groups::Honour } else { Groups::Ignore },
            ..NormalRecipe::default()
        }
    }

    /// The recipes that fit equally well and the share of corners that they reproduce: `stored normals fit crease 28° to 60°; angle
    /// and max fit equally well (100 % of corners within 5°)`.
    pub fn in_words(&self) -> Text {
        if !self.fits_most() {
            return TEXTS.get("no-recipe");
        }
        let degrees = |angle: f64| Value::digits(&angle.to_string());
        let exactly = |angle: f64| TEXTS.with("crease", &[("low", degrees(angle))]);
        // Every angle with one decimal that is printed fits: the upper end itself does not.
        let [low, high] = self.creases.map(|angle| (angle.0 * 10.0).ceil());
        let mut crease = match [low / 10.0, (high - 1.0) / 10.0] {
            [0.0, _] if high >= 1800.0 => TEXTS.get("any-crease"),
            [180.0, _] => exactly(180.0),
            [low, _] if high >= 1800.0 => TEXTS.with("crease-from", &[("low", degrees(low))]),
            [low, high] if low < high => {
                TEXTS.with("crease-range", &[("low", degrees(low)), ("high", degrees(high))])
            }
            [low, high] if low == high => exactly(low),
            _ => exactly(self.crease.0),
        };
        if self.groups {
            crease = TEXTS.with("crease-and-groups", &[("crease", crease.into())]);
        }
        let ties = MEANS.into_iter().zip(self.ties).filter(|&(weight, fits)| fits && weight != self.weight);
        let mut names = vec![self.weight.name()];
        names.extend(ties.map(|(weight, _)| weight.name()));
        let weights = match names.split_last() {
            Some((weight, [])) => TEXTS.with("one-weight", &[("weight", (*weight).into())]),
            Some((last, others)) if others.len() + 1 < MEANS.len() => {
                TEXTS.with("equal-weights", &[("names", others.join(", ").into()), ("last", (*last).into())])
            }
            _ => TEXTS.get("any-weight"),
        };
        let (tolerance, share) = self.tolerance();
        let values = [
            ("crease", crease.into()),
            ("weights", weights.into()),
            ("share", Value::digits(&three_digits(100.0 * share))),
            ("tolerance", degrees(tolerance)),
        ];
        TEXTS.with(if self.turned { "fits-rotated" } else { "fits" }, &values)
    }

    /// The tolerance in degrees within which recipes are compared, and the share of corners within it: 0.1° if the best recipe
    /// made nearly all normals that it reproduces, 5° if it only approximates them.
    pub(crate) fn tolerance(&self) -> (f64, f64) {
        match self.exactly >= NEARLY_ALL * self.reproduced {
            true => (EXACT, self.exactly),
            false => (REPRODUCED, self.reproduced),
        }
    }

    /// The recipe as options of `crease normals`, for a mesh with or without smoothing groups.
    pub fn options(&self, has_groups: bool) -> String {
        let mut options = match self.weight {
            Weight::Angle => String::new(),
            weight => format!("--weight {} ", weight.name()),
        };
        options.push_str(&format!("--crease {}", self.crease.0));
        options.push_str(if has_groups && !self.groups { " --groups ignore" } else { "" });
        options
    }

    /// Whether the recipe is the default one of a mesh without smoothing groups.
    pub(crate) fn is_default(&self) -> bool {
        self.weight == Weight::Angle && self.crease == Crease::DEFAULT_ANGLE
    }

    /// The dihedral angle in degrees from which edges may be sharp: with smoothing groups any.
    pub(crate) fn sharp_from(&self) -> f64 {
        if self.groups { 0.0 } else { self.crease.0 }
    }

    /// Whether it reproduces half of the normals or more; if not, no recipe is reported.
    pub fn fits_most(&self) -> bool {
        self.reproduced >= MOST
    }

    /// Whether the normals follow the recipe closely enough for exceptions to be faults: nearly all do, or most do closely and the
    /// others not at all.
    pub fn is_rule(&self) -> bool {
        self.reproduced >= NEARLY_ALL || (self.closely >= 0.85 && self.is_clear_cut())
    }

    /// Whether hardly any normals follow the recipe only roughly.
    pub(crate) fn is_clear_cut(&self) -> bool {
        self.reproduced - self.closely <= 0.01
    }

    /// Whether the normals follow the recipe, or so many follow it exactly that the others depart from it, by whatever angle.
    pub(crate) fn is_departed_from(&self) -> bool {
        self.is_rule() || self.exactly >= NEARLY_HALF
    }

    /// Whether these normals are those of `before`, which follow no recipe, with a change to all of them undone.
    pub(crate) fn clears_up(&self, before: &Estimate) -> bool {
        !before.is_rule() && self.fits_most() && self.median.0 < LEFT * before.median.0
    }
}
