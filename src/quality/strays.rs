//! What stands behind a normal that is far from its rule: what the fan of faces at its vertex tells, whatever made the others.

use super::catalogue::Kind;
use super::estimate::{REPRODUCED, SAME};
use super::facts::Facts;
use super::means::pull;
use super::tally::{Gathered, Spot, Tally};
use crate::normals::Weight;
use crate::num::{Degrees, angle_between};
use glam::DVec3;

/// The longest way from a corner that is looked along: round poles of more faces what is close by has its say.
const LONGEST: usize = 32;

/// Where a normal that is far from what the rule of its mesh gives may come from.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Ground {
    /// It goes round the vertex, or there is no fan: only the rest of the mesh can tell.
    Shared,
    /// From a run of these faces: edges may have been marked sharp or smooth by hand.
    Run,
}

impl Ground {
    pub(super) const ALL: [Self; 2] = [Self::Shared, Self::Run];

    /// Of a corner with this stored unit normal; `None` if it comes from nowhere: no run of the faces round the vertex has it
    /// for its mean, and most other corners of the fan have what the rule gives, or none of them has it as well.
    pub(super) fn of(facts: &Facts<'_>, corner: usize, normal: DVec3) -> Option<Self> {
        let fan = Fan::new(facts, corner);
        let from_run = fan.nearest_run(facts, normal);
        let expected = facts.expected(corner);
        let others = || fan.others().filter_map(|corner| Some((corner, facts.stored_unit(corner)?)));
        let mates = || others().filter(|&(corner, _)| facts.expected(corner) == expected);
        let has = |normal: DVec3| move |&(_, unit): &(usize, DVec3)| degrees(unit, normal) <= SAME;
        // Beside what follows the rule a run has to fit as closely.
        if from_run <= SAME {
            Some(Self::Run)
        } else if 2 * mates().filter(has(expected)).count() > mates().count() {
            None
        } else if from_run <= REPRODUCED {
            Some(Self::Run)
        } else if mates().next().is_some() && !others().any(|other| has(normal)(&other)) {
            None
        } else {
            Some(Self::Shared)
        }
    }
}

/// Normals that are turned round, more or less.
pub(super) const AGAINST: [Kind; 2] = [Kind::Flipped, Kind::AgainstFace];

/// Normals far from the rule that wait for what the rest of the mesh tells of them, by their ground.
pub(super) struct Waiting {
    tallies: [Tally; Ground::ALL.len()],
    /// Those that are turned round or point behind their face, on either ground, in the order of [`AGAINST`].
    against: [Tally; AGAINST.len()],
    /// How many places of each are kept.
    most: usize,
}

impl Waiting {
    pub(super) fn add(&mut self, ground: Ground, spot: Spot, area: f64) {
        self.tallies[ground as usize].add(spot, area, self.most);
    }

    /// Adds one of [`AGAINST`].
    pub(super) fn add_against(&mut self, kind: Kind, spot: Spot, area: f64) {
        self.against[usize::from(kind == Kind::AgainstFace)].add(spot, area, self.most);
    }

    /// How many are turned round or point behind their face.
    pub(super) fn against(&self) -> u64 {
        self.against.iter().map(|tally| tally.count).sum()
    }

    /// Takes those out, in the order of [`AGAINST`].
    pub(super) fn take_against(&mut self) -> [Tally; AGAINST.len()] {
        std::mem::take(&mut self.against)
    }

    /// How many there are of some grounds.
    pub(super) fn count(&self, grounds: &[Ground]) -> u64 {
        grounds.iter().map(|&ground| self.tallies[ground as usize].count).sum()
    }

    /// Those of each ground, in the order of [`Ground::ALL`], and what is turned.
    pub(super) fn into_tallies(self) -> impl Iterator<Item = Tally> {
        self.tallies.into_iter().chain(self.against)
    }
}

impl Gathered for Waiting {
    fn new(most: usize) -> Self {
        Self { tallies: Default::default(), against: Default::default(), most }
    }

    fn merge(&mut self, other: Self) {
        let most = self.most;
        self.tallies.iter_mut().zip(other.tallies).for_each(|(own, other)| own.merge(other, most));
        self.against.iter_mut().zip(other.against).for_each(|(own, other)| own.merge(other, most));
    }
}

/// The angle between two directions, in degrees; a right one for a sum that cancels.
fn degrees(a: DVec3, b: DVec3) -> f64 {
    if a == DVec3::ZERO { 90.0 } else { Degrees::from(angle_between(a, b)).0 }
}

/// The other corners round the vertex of a corner, in their order each way, up to a rim or once round.
struct Fan {
    corner: u32,
    ahead: Vec<u32>,
    behind: Vec<u32>,
    is_closed: bool,
}

impl Fan {
    fn new(facts: &Facts<'_>, corner: usize) -> Self {
        let (topology, corner) = (&facts.topology, corner as u32);
        let next = |&at: &u32| topology.across(at).map(|across| topology.next(across));
        let previous = |&at: &u32| topology.across(topology.previous(at));
        let is_other = |at: &u32| *at != corner;
        let ahead = std::iter::successors(next(&corner), next).take_while(is_other).take(LONGEST);
        let behind = std::iter::successors(previous(&corner), previous).take_while(is_other).take(LONGEST);
        let [ahead, behind] = [ahead.collect::<Vec<_>>(), behind.collect()];
        let is_closed = next(ahead.last().unwrap_or(&corner)) == Some(corner);
        Self { corner, ahead, behind, is_closed }
    }

    /// The other corners.
    fn others(&self) -> impl Iterator<Item = usize> {
        // Once round, those behind are those ahead again.
        let behind = if self.is_closed { &[] } else { &self.behind[..] };
        self.ahead.iter().chain(behind).map(|&corner| corner as usize)
    }

    /// How far a normal is, in degrees, from the nearest mean of neighbouring faces, the corner's own among them, by the
    /// weighting of the mesh.
    fn nearest_run(&self, facts: &Facts<'_>, normal: DVec3) -> f64 {
        let weight = facts.estimate.map_or(Weight::Angle, |estimate| estimate.weight);
        let pulls = |way: &[u32]| way.iter().map(|&at| pull(facts, at, weight)).collect::<Vec<_>>();
        let (ahead, behind) = (pulls(&self.ahead), pulls(&self.behind));
        let mut nearest = Nearest { sum: DVec3::ZERO, closeness: f64::NEG_INFINITY, to: normal };
        let mut from = pull(facts, self.corner, weight);
        for reach in 0..=behind.len() {
            if reach > 0 {
                from += behind[reach - 1];
            }
            nearest.offer(from);
            let most = ahead.len() - if self.is_closed { reach } else { 0 };
            let mut sum = from;
            for &next in &ahead[..most] {
                sum += next;
                nearest.offer(sum);
            }
        }
        degrees(nearest.sum, normal)
    }
}

/// The sum that is nearest to a direction, of very many: one arc tangent at the end tells how near.
struct Nearest {
    to: DVec3,
    sum: DVec3,
    /// The square of the cosine, with its sign.
    closeness: f64,
}

impl Nearest {
    fn offer(&mut self, sum: DVec3) {
        let cosine = self.to.dot(sum);
        let closeness = cosine * cosine.abs() / sum.length_squared();
        // A sum that cancels is no direction: nothing compares with it.
        if closeness > self.closeness {
            (self.sum, self.closeness) = (sum, closeness);
        }
    }
}
