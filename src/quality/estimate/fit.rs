//! Fits of rules to a sample of stored normals: which edges are smooth, by which weighting, and how far off that is.

use crate::mesh::Column;
use crate::normals::{Crease, Weight};
use crate::num::{Degrees, angle_between};
use crate::quality::estimate::means::{MEANS, Smoothness, Sums, sums};
use crate::quality::estimate::quadrics::Patch;
use crate::quality::estimate::recipe::{Estimate, LEFT, LETTER, NEARLY_ALL, REPRODUCED, SAME, SAMPLE};
use crate::quality::estimate::rotation::{are_spread, rotation_angle, steady_turn};
use crate::quality::facts::{Facts, Significance};
use crate::quality::smoothing::crease_angle::{Bend, exact_separating_angle, separating_angle};
use crate::quality::stored::vertex_fans::VertexFans;
use glam::{DMat3, DVec3};
use rayon::prelude::*;

/// The most corners that quadrics are fitted at.
const FITTED: usize = 2048;

/// Means off by no more than this on average, in degrees, are not improved on: what rounding to four decimals leaves.
const FINE: f64 = 0.01;

/// For how many edges that look smooth beyond the crease angle one that looks sharp below it counts, where those may all be
/// the only sharp ones at their vertices.
const LONE: usize = 16;

/// The corners that are looked at, and the edges at them.
pub(in crate::quality) struct Sample<'a> {
    facts: &'a Facts<'a>,
    corners: Vec<u32>,
    /// The stored normals, as unit vectors.
    normals: Vec<DVec3>,
    bends: Vec<Bend>,
}

/// What a rule about edges makes of a sample, with the weighting that does best with it.
pub(in crate::quality) struct Fit {
    pub(in crate::quality) estimate: Estimate,
    /// By how much it is off in all, in degrees, as [`cost`] has it.
    cost: f64,
    /// By how many degrees it is off at each corner, ascending.
    errors: Vec<f64>,
    /// What all normals were turned by before, if that was asked for.
    pub(in crate::quality) turn: Option<DMat3>,
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

impl<'a> Sample<'a> {
    /// `None` if no corner has a usable normal.
    pub(in crate::quality) fn of(facts: &'a Facts<'a>, stored: &Column<DVec3>) -> Option<Self> {
        let corners = corners(facts);
        let unit = |&corner: &u32| facts.stored_unit(corner as usize).expect("the sample has directions");
        let normals = corners.par_iter().map(unit).collect();
        let bends = corners.par_iter().filter_map(|&corner| Bend::at(facts, stored, corner)).collect();
        (!corners.is_empty()).then_some(Self { facts, corners, normals, bends })
    }

    /// The rule that fits best.
    pub(in crate::quality) fn best(&self) -> Fit {
        let by_means = self.best_mean(false);
        self.by_quadrics(&by_means).unwrap_or(by_means)
    }

    /// The one that fits best to the normals turned back as a whole, if that explains what others leave.
    pub(in crate::quality) fn best_turned_back(&self, as_stored: &Fit) -> Option<Fit> {
        let turned_back = self.best_mean(true);
        let explains = are_spread(self.normals.iter().copied()) && turned_back.explains(as_stored);
        explains.then_some(turned_back)
    }

    /// The rule about edges and the mean that fit best, to the normals as they are or turned back as a whole.
    fn best_mean(&self, turned_back: bool) -> Fit {
        let sharp_from = |crease| Smoothness::new(crease, None);
        let separating = separating_angle(&self.bends, 1);
        let mut plain = self.by_rule(sharp_from(separating), turned_back);
        // A sharp edge that is the only one at its vertex splits nothing, and looks smooth: what separates best need not be
        // what the normals were made with. Edges that look sharp are what they seem.
        if plain.estimate.reproduced < 1.0 {
            let known = [separating];
            // Many single faults at the ends of edges shift what separates best.
            for other in candidates(&self.bends, &known).into_iter().chain(next_to(separating)) {
                let other = self.by_rule(sharp_from(other), turned_back);
                plain = if other.cost < plain.cost { other } else { plain };
            }
        }
        let groups = self.facts.mesh.columns().smoothing.as_ref();
        if let Some(groups) = groups.filter(|_| plain.estimate.reproduced < NEARLY_ALL) {
            let left = self.in_one_group();
            let separating = separating_angle(&left, 1);
            let known = [Crease::DEFAULT_ANGLE, plain.estimate.crease, separating, Degrees(180.0)];
            for crease in known.into_iter().chain(candidates(&left, &known)) {
                let other = self.by_rule(Smoothness::new(crease, Some(&groups.of_face)), turned_back);
                plain = if other.estimate.reproduced > plain.estimate.reproduced { other } else { plain };
            }
        }
        plain
    }

    fn by_rule(&self, rule: Smoothness<'_>, turned_back: bool) -> Fit {
        let poles = VertexFans::default();
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
        let errors = self.errors(&sums, best, turn);
        self.fit(MEANS[best], rule, errors, turn)
    }

    /// What a rule makes of the sample, from by how many degrees it is off at each corner.
    fn fit(&self, weight: Weight, rule: Smoothness<'_>, mut errors: Vec<f64>, turn: Option<DMat3>) -> Fit {
        let crease = rule.crease;
        let cost = cost(&errors);
        errors.sort_unstable_by(f64::total_cmp);
        let count = errors.len() as f64;
        let within = |most: f64| errors.partition_point(|&error| error <= most) as f64 / count;
        let separated = self.bends.iter().filter(|bend| (bend.degrees < crease.0) == bend.smooth).count();
        let reproduced = within(REPRODUCED);
        let estimate = Estimate {
            weight,
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

    /// The same by quadrics, if they are what the normals were made by rather than means.
    fn by_quadrics(&self, by_means: &Fit) -> Option<Fit> {
        let (means, count) = (&by_means.estimate, self.corners.len());
        if by_means.cost <= FINE * count as f64 {
            return None;
        }
        let few: Vec<usize> = (0..count.min(FITTED)).map(|i| i * count / count.min(FITTED)).collect();
        let corners: Vec<u32> = few.iter().map(|&i| self.corners[i]).collect();
        let patch = Patch::around(self.facts, &corners);
        let reported = || patch.places().map(|place| few[place]);
        let few = Sample {
            facts: self.facts,
            corners: reported().map(|i| self.corners[i]).collect(),
            normals: reported().map(|i| self.normals[i]).collect(),
            bends: self.bends.clone(),
        };
        if few.corners.is_empty() {
            return None;
        }
        let groups = self.facts.mesh.columns().smoothing.as_ref().filter(|_| means.groups);
        let rule = |crease| Smoothness::new(crease, groups.map(|groups| groups.of_face.as_slice()));
        let by_quadric = |crease| few.by_quadric(rule(crease), &patch.normals(crease, means.groups));
        let mut best = by_quadric(means.crease);
        // Where a fit is far from all means, what splits these says little of what splits it.
        for known in [Crease::DEFAULT_ANGLE, Degrees(180.0)] {
            if best.estimate.exactly < 1.0 && known != means.crease {
                let other = by_quadric(known);
                best = if other.cost < best.cost { other } else { best };
            }
        }
        if best.cost >= LEFT * few.by_rule(rule(means.crease), false).cost {
            return None;
        }
        // A single edge next to the angle may show on neither.
        if best.estimate.exactly < 1.0 {
            let bends = if means.groups { self.in_one_group() } else { self.bends.clone() };
            let known = [means.crease, Crease::DEFAULT_ANGLE, Degrees(180.0)];
            for other in candidates(&bends, &known).into_iter().chain(next_to(means.crease)) {
                let other = by_quadric(other);
                best = if other.cost < best.cost { other } else { best };
            }
        }
        Some(best)
    }

    fn by_quadric(&self, rule: Smoothness<'_>, quadrics: &[DVec3]) -> Fit {
        let error = |(&stored, &fitted): (&DVec3, &DVec3)| Degrees::from(angle_between(stored, fitted)).0;
        let errors = self.normals.iter().zip(quadrics).map(error).collect();
        self.fit(Weight::Quadric, rule, errors, None)
    }

    /// The edges that smoothing groups leave to the angle.
    fn in_one_group(&self) -> Vec<Bend> {
        self.bends.iter().copied().filter(|bend| bend.in_one_group).collect()
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

/// The crease angles one degree less and more.
fn next_to(crease: Degrees) -> [Degrees; 2] {
    [-1.0, 1.0].map(|by| Degrees((crease.0 + by).clamp(0.0, 180.0)))
}

/// Corners with a direction on sound faces; if there are too many, those that a fixed generator picks.
fn corners(facts: &Facts<'_>) -> Vec<u32> {
    let count = facts.mesh.faces().corner_count();
    let is_usable = |&corner: &u32| {
        let face = facts.topology.face_of(corner) as usize;
        facts.worth[face] == Significance::Sound && facts.stored_unit(corner as usize).is_some()
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
