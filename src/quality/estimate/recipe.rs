//! How stored normals were made: which weighting and which crease angle reproduce them best.

use crate::mesh::Column;
use crate::normals::{Crease, Groups, NormalRecipe, Weight};
use crate::num::Degrees;
use crate::quality::estimate::fit::Sample;
use crate::quality::facts::Facts;
use glam::{DMat3, DVec3};

/// The most corners that are looked at.
pub const SAMPLE: usize = 100_000;

/// Two normals closer than this, in degrees, are taken to be one: above what 8 bits do to each of them.
pub(in crate::quality) const SAME: f64 = 1.0;

/// The share of corners that a rule reproduces, if nothing else made them.
pub(in crate::quality) const NEARLY_ALL: f64 = 0.98;

/// A corner counts as reproduced within this many degrees.
pub(in crate::quality) const REPRODUCED: f64 = 5.0;

/// The same to the letter: above what 32 bits and four decimals do, below what differs between programs.
pub(in crate::quality) const LETTER: f64 = 0.1;

/// The share of corners to the letter from which on the others depart from a rule, rather than that there is none: what is
/// not all of them may be half, less what a border between two halves takes.
const NEARLY_HALF: f64 = 0.4;

/// The share of corners that a rule reproduces at least for the normals to be made by it rather than by none, once they are
/// turned back if a turn explains them.
const MOST: f64 = 0.5;

/// How much of what the best rule is off by, or of its median, a turn of all normals may leave, and a fit in place of a mean.
pub(in crate::quality) const LEFT: f64 = 0.5;

/// How the stored normals of a part were made, as far as they tell.
#[derive(Clone, Copy, Debug, PartialEq, serde::Serialize)]
pub struct Estimate {
    /// The weighting that reproduces them best. The quadric, a fit that costs more and is at the mercy of few neighbours, only where
    /// it leaves less than half of what the best mean of face normals is off by, and that is off by more than 0.01° on average:
    /// finer meshes and coarser numbers tell no difference.
    pub weight: Weight,
    /// The crease angle that reproduces them best: 0 if they are flat, 180 if no edge is sharp.
    pub crease: Degrees,
    /// Whether smoothing groups reproduce them better than a crease angle alone; the angle then applies beside them.
    pub groups: bool,
    /// Whether all normals were turned or mirrored together: what is told here is of them turned back.
    pub turned: bool,
    /// Corners looked at.
    pub sample: usize,
    /// The share of them that it reproduces within 5°.
    pub reproduced: f64,
    /// The share of them that it reproduces within 1°.
    #[serde(skip)]
    pub closely: f64,
    /// The share of them that it reproduces within 0.1°.
    #[serde(skip)]
    pub exactly: f64,
    /// The share of the edges at them, of those that bend at all, that the crease angle puts on the right side.
    pub separated: f64,
    /// The median angle between stored and reproduced normals.
    pub median: Degrees,
}

impl Estimate {
    /// The recipe that it stands for.
    pub fn recipe(&self) -> NormalRecipe {
        NormalRecipe {
            weight: self.weight,
            crease: Crease::Angle(self.crease),
            groups: if self.groups { Groups::Honour } else { Groups::Ignore },
            ..NormalRecipe::default()
        }
    }

    /// The same as options of `crease normals`.
    pub fn options(&self) -> String {
        let mut options = match self.weight {
            Weight::Angle => String::new(),
            weight => format!("--weight {} ", weight.name()),
        };
        options.push_str(&format!("--crease {}", self.crease.0));
        options.push_str(if self.groups { "" } else { " --groups ignore" });
        options
    }

    /// Whether the recipe is what is computed without being asked for, on a mesh without smoothing groups.
    pub(in crate::quality) fn is_default(&self) -> bool {
        self.weight == Weight::Angle && self.crease == Crease::DEFAULT_ANGLE
    }

    /// The bend in degrees from which on edges may be sharp: with smoothing groups any.
    pub(in crate::quality) fn sharp_from(&self) -> f64 {
        if self.groups { 0.0 } else { self.crease.0 }
    }

    /// Whether it reproduces half of the normals or more; where it does not, no rule is told.
    pub fn fits_most(&self) -> bool {
        self.reproduced >= MOST
    }

    /// Whether the normals follow a rule closely enough for exceptions to be faults: nearly all do, or most do to the letter
    /// and the others not at all.
    pub fn is_rule(&self) -> bool {
        self.reproduced >= NEARLY_ALL || (self.closely >= 0.85 && self.reproduced - self.closely <= 0.01)
    }
}

impl Estimate {
    /// Whether the normals follow a rule, or those that do follow it to the letter and are so many that the others depart from
    /// it: however far they do.
    pub(in crate::quality) fn is_departed_from(&self) -> bool {
        self.is_rule() || self.exactly >= NEARLY_HALF
    }
}

impl Estimate {
    /// Whether the normals that this is of are what others, that no rule made, were before something was done to all of them.
    pub(in crate::quality) fn clears_up(&self, before: &Estimate) -> bool {
        !before.is_rule() && self.fits_most() && self.median.0 < LEFT * before.median.0
    }
}

/// Estimates from a fixed sample; `None` if no corner has a usable normal. Where no rule reproduces the normals as they are,
/// they may have been turned as a whole: the turn that stands between them and what a rule gives comes second.
pub(in crate::quality) fn estimate(
    facts: &Facts<'_>,
    stored: &Column<DVec3>,
) -> Option<(Estimate, Option<DMat3>)> {
    let sample = Sample::of(facts, stored)?;
    let as_stored = sample.best();
    if !as_stored.estimate.is_rule()
        && let Some(turned_back) = sample.best_turned_back(&as_stored)
    {
        return Some((turned_back.estimate, turned_back.turn));
    }
    Some((as_stored.estimate, None))
}
