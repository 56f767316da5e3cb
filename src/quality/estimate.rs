//! How stored normals were made: which weighting and which crease angle reproduce them best.

use super::bends::{Bend, exact_separating_angle, separating_angle};
use super::facts::{Facts, Worth};
use super::means::{MEANS, Smoothness, Sums, sums};
use super::orbits::Orbits;
use super::rotation::{are_spread, rotation_angle, steady_turn};
use crate::mesh::Column;
use crate::normals::{Crease, Groups, NormalRecipe, Weight};
use crate::num::{Degrees, angle_between};
use glam::{DMat3, DVec3};
use rayon::prelude::*;

/// The most corners that are looked at.
pub const SAMPLE: usize = 100_000;

/// Two normals closer than this, in degrees, are taken to be one: above what 8 bits do to each of them.
pub(super) const SAME: f64 = 1.0;

/// The share of corners that a rule reproduces, if nothing else made them.
const NEARLY_ALL: f64 = 0.98;

/// A corner counts as reproduced within this many degrees.
pub(super) const REPRODUCED: f64 = 5.0;

/// The same to the letter: above what 32 bits and four decimals do, below what differs between programs.
pub(super) const LETTER: f64 = 0.1;

/// The share of corners to the letter from which on the others depart from a rule, rather than that there is none: what is
/// not all of them may be half, less what a border between two halves takes.
const NEARLY_HALF: f64 = 0.4;

/// For how many edges that look smooth beyond the crease angle one that looks sharp below it counts, where those may all be
/// the only sharp ones at their vertices.
const LONE: usize = 16;

/// How the stored normals of a part were made, as far as they tell.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Estimate {
    /// The weighting that reproduces them best, of those that are means of face normals: quadrics are not tried.
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
    pub closely: f64,
    /// The share of them that it reproduces within 0.1°.
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
    pub(super) fn is_default(&self) -> bool {
        self.weight == Weight::Angle && self.crease == Crease::DEFAULT_ANGLE
    }

    /// The bend in degrees from which on edges may be sharp: with smoothing groups any.
    pub(super) fn sharp_from(&self) -> f64 {
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
    pub(super) fn is_departed_from(&self) -> bool {
        self.is_rule() || self.exactly >= NEARLY_HALF
    }
}

impl Estimate {
    /// Whether the normals that this is of are what others, that no rule made, were before something was done to all of them.
    pub(super) fn clears_up(&self, before: &Estimate) -> bool {
        !before.is_rule() && self.fits_most() && self.median.0 < LEFT * before.median.0
    }
}

/// The share of corners that a rule reproduces at least for the normals to be made by it rather than by none, once they are
/// turned back if a turn explains them.
const MOST: f64 = 0.5;

/// How much of what the best rule is off by, or of its median, a turn of all normals may leave.
const LEFT: f64 = 0.5;

/// Estimates from a fixed sample; `None` if no corner has a usable normal. Where no rule reproduces the normals as they are,
/// they may have been turned as a whole: the turn that stands between them and what a rule gives comes second.
pub(super) fn estimate(facts: &Facts<'_>, stored: &Column<DVec3>) -> Option<(Estimate, Option<DMat3>)> {
    let corners = sample(facts);
    if corners.is_empty() {
        return None;
    }
    let unit = |&corner: &u32| facts.stored_unit(corner as usize).expect("the sample has directions");
    let normals = corners.par_iter().map(unit).collect();
    let bends = corners.par_iter().filter_map(|&corner| Bend::at(facts, stored, corner)).collect();
    let sample = Sample { facts, corners, normals, bends };
    let as_stored = sample.best(false);
    if !as_stored.estimate.is_rule() {
        let turned_back = sample.best(true);
        if are_spread(sample.normals.iter().copied()) && turned_back.explains(&as_stored) {
            return Some((turned_back.estimate, turned_back.turn));
        }
    }
    Some((as_stored.estimate, None))
}

/// The corners that are looked at, and the edges at them.
struct Sample<'a> {
    facts: &'a Facts<'a>,
    corners: Vec<u32>,
    /// The stored normals, as unit vectors.
    normals: Vec<DVec3>,
    bends: Vec<Bend>,
}

/// What a rule about edges makes of a sample, with the weighting that does best with it.
struct Fit {
    estimate: Estimate,
    /// By how much it is off in all, in degrees, as [`cost`] has it.
    cost: f64,
    /// By how many degrees it is off at each corner, ascending.
    errors: Vec<f64>,
    /// What all normals were turned by before, if that was asked for.
    turn: Option<DMat3>,
}

impl Fit {
    /// Whether turning all normals back explains what is wrong with them as they are. What turning single ones round explains
    /// as well is no turn of all: on a box with some sides' normals reversed half a turn does. Where a rule reproduces the
    /// normals, many may be turned by little, so the sum tells; where none quite does, the median.
    fn explains(&self, as_stored: &Fit) -> bool {
        let mut either_way: Vec<f64> =
            as_stored.errors.iter().map(|error| error.min(180.0 - error)).collect();
        either_way.sort_unstable_by(f64::total_cmp);
        self.turn.is_some_and(|turn| rotation_angle(turn) > SAME)
            && self.estimate.fits_most()
            && (self.cost < LEFT * cost(&either_way) || median(&self.errors) < LEFT * median(&either_way))
    }
}

/// The sum of errors. Far-off corners are faults, not evidence: all beyond the bound count alike.
fn cost(errors: &[f64]) -> f64 {
    errors.iter().map(|error| error.min(REPRODUCED)).sum()
}

fn median(ascending: &[f64]) -> f64 {
    ascending[ascending.len() / 2]
}

impl Sample<'_> {
    /// The rule that fits best, to the normals as they are or turned back as a whole.
    fn best(&self, turned_back: bool) -> Fit {
        let sharp_from = |crease| Smoothness::new(crease, None);
        let separating = separating_angle(&self.bends, 1);
        let mut plain = self.by_rule(sharp_from(separating), turned_back);
        // A sharp edge that is the only one at its vertex splits nothing, and looks smooth: what separates best need not be
        // what the normals were made with. Edges that look sharp are what they seem.
        if plain.estimate.reproduced < 1.0 {
            for other in candidates(&self.bends, &[separating]) {
                let other = self.by_rule(sharp_from(other), turned_back);
                plain = if other.cost < plain.cost { other } else { plain };
            }
        }
        let groups = self.facts.mesh.columns().smoothing.as_ref();
        if let Some(groups) = groups.filter(|_| plain.estimate.reproduced < NEARLY_ALL) {
            let left: Vec<Bend> = self.bends.iter().copied().filter(|bend| bend.in_one_group).collect();
            let known = [plain.estimate.crease, separating_angle(&left, 1), Degrees(180.0)];
            for crease in known.into_iter().chain(candidates(&left, &known)) {
                let other = self.by_rule(Smoothness::new(crease, Some(&groups.of_face)), turned_back);
                plain = if other.estimate.reproduced > plain.estimate.reproduced { other } else { plain };
            }
        }
        plain
    }

    fn by_rule(&self, rule: Smoothness<'_>, turned_back: bool) -> Fit {
        let crease = rule.crease;
        let poles = Orbits::default();
        let sums = |&corner: &u32| sums(self.facts, corner, rule, &poles);
        let sums: Vec<Sums> = self.corners.par_iter().map(sums).collect();
        let turn = |weight| if turned_back { steady_turn(&self.pairs(&sums, weight)) } else { None };
        // Weightings differ by little and to all sides: any of them tells what all are turned by.
        let about = turn(0);
        let costs: Vec<f64> =
            (0..MEANS.len()).map(|weight| cost(&self.errors(&sums, weight, about))).collect();
        // Where all do alike, as on flat shapes, the first one is as good as any.
        let best = (1..MEANS.len())
            .fold(0, |best, i| if costs[i] < costs[best] * (1.0 - 1e-3) - 1e-9 { i } else { best });
        let turn = turn(best);
        let mut errors = self.errors(&sums, best, turn);
        let cost = cost(&errors);
        errors.sort_unstable_by(f64::total_cmp);
        let count = errors.len() as f64;
        let within = |most: f64| errors.partition_point(|&error| error <= most) as f64 / count;
        let separated = self.bends.iter().filter(|bend| (bend.degrees < crease.0) == bend.smooth).count();
        let reproduced = within(REPRODUCED);
        let estimate = Estimate {
            weight: MEANS[best],
            crease,
            groups: rule.groups.is_some(),
            turned: turn.is_some(),
            sample: errors.len(),
            reproduced,
            closely: within(SAME),
            exactly: within(LETTER),
            separated: match (rule.groups, self.bends.len()) {
                (None, 1..) => separated as f64 / self.bends.len() as f64,
                (None, 0) => 1.0,
                // Groups say which edges are sharp, not the angle.
                (Some(_), _) => reproduced,
            },
            median: Degrees(median(&errors)),
        };
        Fit { estimate, cost, errors, turn }
    }

    /// Stored normals and the means by a weighting, as unit vectors.
    fn pairs(&self, sums: &[Sums], weight: usize) -> Vec<(DVec3, DVec3)> {
        let mean = |sums: &Sums| sums[weight].normalize_or_zero();
        self.normals.par_iter().zip(sums).map(|(&normal, sums)| (normal, mean(sums))).collect()
    }

    /// The angle in degrees between each stored normal and the mean by a weighting, turned.
    fn errors(&self, sums: &[Sums], weight: usize, turn: Option<DMat3>) -> Vec<f64> {
        let mean = |sums: &Sums| turn.map_or(sums[weight], |turn| turn * sums[weight]);
        // A sum that cancels is no direction, and reproduces nothing.
        let error = |(&normal, sums): (&DVec3, &Sums)| match mean(sums) {
            DVec3::ZERO => 180.0,
            mean => Degrees::from(angle_between(normal, mean)).0,
        };
        self.normals.par_iter().zip(sums).map(error).collect()
    }
}

/// Crease angles worth trying beside the one that separates best by whole degrees, and those known already left out.
fn candidates(bends: &[Bend], known: &[Degrees]) -> Vec<Degrees> {
    let exact = exact_separating_angle(bends, LONE);
    // What people type is whole.
    let all = [Crease::DEFAULT_ANGLE, separating_angle(bends, LONE), Degrees(exact.0.round()), exact];
    let mut found: Vec<Degrees> = Vec::new();
    for angle in all {
        if !known.contains(&angle) && !found.contains(&angle) {
            found.push(angle);
        }
    }
    found
}

/// Corners with a direction on sound faces; if there are too many, those that a fixed generator picks.
fn sample(facts: &Facts<'_>) -> Vec<u32> {
    let count = facts.mesh.faces().corner_count();
    let is_usable = |&corner: &u32| {
        let face = facts.topology.face_of(corner) as usize;
        facts.worth[face] == Worth::Sound && facts.stored_unit(corner as usize).is_some()
    };
    if count <= SAMPLE {
        return (0..count as u32).filter(is_usable).collect();
    }
    // One corner of each stretch of equal length, so that all of the mesh has its say.
    let pick = |stretch: usize| {
        let (from, to) = (stretch * count / SAMPLE, (stretch + 1) * count / SAMPLE);
        (from + (mixed(stretch as u64) % (to - from) as u64) as usize) as u32
    };
    (0..SAMPLE).into_par_iter().map(pick).filter(is_usable).collect()
}

/// The output function of splitmix64.
fn mixed(seed: u64) -> u64 {
    let z = seed.wrapping_add(1).wrapping_mul(0x9e37_79b9_7f4a_7c15);
    let z = (z ^ (z >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
    let z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
    z ^ (z >> 31)
}
