//! What stands behind a normal that is far from its rule: what the fan of faces at its vertex tells, whatever made the others.

use crate::mesh::Link;
use crate::normals::Weight;
use crate::num::{Degrees, angle_between};
use crate::quality::catalogue::Kind;
use crate::quality::counts::{Gathered, Spot, Tally};
use crate::quality::estimate::means::{pull, pull_uncut};
use crate::quality::estimate::recipe::{REPRODUCED, SAME};
use crate::quality::facts::Facts;
use glam::DVec3;

/// The longest way from a corner that is looked along: round poles of more faces what is close by has its say.
const LONGEST: usize = 32;

/// Where a normal that is far from what the rule of its mesh gives may come from.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(in crate::quality) enum Ground {
    /// It goes round the vertex, or there is no fan: only the rest of the mesh can tell.
    Shared,
    /// From a run of these faces: edges may have been marked sharp or smooth by hand.
    Run,
}

impl Ground {
    pub(in crate::quality) const ALL: [Self; 2] = [Self::Shared, Self::Run];

    /// Of a corner with this stored unit normal; `None` if it comes from nowhere: no run of the faces round the vertex has it
    /// for its mean, and most other corners of the fan have what the rule gives, or none of them has it as well nor has its face.
    pub(in crate::quality) fn of(facts: &Facts<'_>, corner: usize, normal: DVec3) -> Option<Self> {
        let fan = Fan::new(facts, corner, Reach::OneWay);
        let nearest = [Reading::AsIs, Reading::Uncut].map(|reading| fan.nearest_run(facts, normal, reading));
        Self::within(facts, &fan, normal, nearest[0].min(nearest[1]))
    }

    /// Of a corner beside faces that run against its own, or on one: means over these as well, as they are and turned back; and
    /// where its own face may be the one that is turned, their opposites.
    pub(in crate::quality) fn near_reoriented(
        facts: &Facts<'_>,
        corner: usize,
        normal: DVec3,
        is_turned: bool,
    ) -> Option<Self> {
        let fan = Fan::new(facts, corner, Reach::BothWays);
        let readings = [Reading::AsIs, Reading::TurnedBack, Reading::Opposite, Reading::OppositeTurnedBack];
        let possible = &readings[..if is_turned { 4 } else { 2 }];
        let nearest = possible.iter().map(|&reading| fan.nearest_run(facts, normal, reading));
        Self::within(facts, &fan, normal, nearest.fold(f64::INFINITY, f64::min))
    }

    fn within(facts: &Facts<'_>, fan: &Fan, normal: DVec3, from_run: f64) -> Option<Self> {
        let expected = facts.expected(fan.corner as usize);
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
        } else if mates().next().is_some()
            && !others().any(|other| has(normal)(&other))
            && !is_flat(facts, fan.corner, normal)
        {
            None
        } else {
            Some(Self::Shared)
        }
    }
}

/// Whether the other corners of a corner's face have its normal as well: not a single one then, but that of a flat face.
fn is_flat(facts: &Facts<'_>, corner: u32, normal: DVec3) -> bool {
    let mut face = facts.mesh.faces().range(facts.topology.face_of(corner) as usize);
    face.all(|other| facts.stored_unit(other).is_some_and(|unit| degrees(unit, normal) <= SAME))
}

/// Normals that are turned round, more or less.
pub(in crate::quality) const AGAINST: [Kind; 2] = [Kind::Flipped, Kind::AgainstFace];

/// Normals far from the rule that wait for what the rest of the mesh tells of them, by their ground.
pub(in crate::quality) struct Waiting {
    tallies: [Tally; Ground::ALL.len()],
    /// Those that are turned round or point behind their face, on either ground, in the order of [`AGAINST`].
    against: [Tally; AGAINST.len()],
    /// Those on either ground that are the very opposite of what the rule gives.
    opposite: Tally,
    /// How many places of each are kept.
    most: usize,
}

impl Waiting {
    pub(in crate::quality) fn add(&mut self, ground: Ground, spot: Spot, area: f64) {
        self.tallies[ground as usize].add(spot, area, self.most);
    }

    /// Adds one of [`AGAINST`].
    pub(in crate::quality) fn add_against(&mut self, kind: Kind, spot: Spot, area: f64) {
        self.against[usize::from(kind == Kind::AgainstFace)].add(spot, area, self.most);
    }

    /// Adds one that is the very opposite of what the rule gives.
    pub(in crate::quality) fn add_opposite(&mut self, spot: Spot, area: f64) {
        self.opposite.add(spot, area, self.most);
    }

    /// How many are turned round or point behind their face.
    pub(in crate::quality) fn against(&self) -> u64 {
        self.against.iter().chain([&self.opposite]).map(|tally| tally.count).sum()
    }

    /// Takes those out that are no more than against their face, in the order of [`AGAINST`], and those that are the very opposite.
    pub(in crate::quality) fn take_against(&mut self) -> ([Tally; AGAINST.len()], Tally) {
        (std::mem::take(&mut self.against), std::mem::take(&mut self.opposite))
    }

    /// How many there are of some grounds.
    pub(in crate::quality) fn count(&self, grounds: &[Ground]) -> u64 {
        grounds.iter().map(|&ground| self.tallies[ground as usize].count).sum()
    }

    /// Those of each ground, in the order of [`Ground::ALL`], and what is turned.
    pub(in crate::quality) fn into_tallies(self) -> impl Iterator<Item = Tally> {
        self.tallies.into_iter().chain(self.against).chain([self.opposite])
    }
}

impl Gathered for Waiting {
    fn new(most: usize) -> Self {
        Self { tallies: Default::default(), against: Default::default(), opposite: Tally::default(), most }
    }

    fn merge(&mut self, other: Self) {
        let most = self.most;
        self.tallies.iter_mut().zip(other.tallies).for_each(|(own, other)| own.merge(other, most));
        self.against.iter_mut().zip(other.against).for_each(|(own, other)| own.merge(other, most));
        self.opposite.merge(other.opposite, most);
    }
}

/// The angle between two directions, in degrees; a right one for a sum that cancels.
fn degrees(a: DVec3, b: DVec3) -> f64 {
    if a == DVec3::ZERO { 90.0 } else { Degrees::from(angle_between(a, b)).0 }
}

/// How far a fan goes.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Reach {
    /// Over faces that run the same way.
    OneWay,
    /// Over edges that both faces run the same way as well: one of them is turned round.
    BothWays,
}

/// What the faces of a fan are taken for.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Reading {
    AsIs,
    /// Those that run against the first are turned back.
    TurnedBack,
    /// All are turned.
    Opposite,
    /// All but those that run against the first are turned.
    OppositeTurnedBack,
    /// Halves of quadrilaterals are these.
    Uncut,
}

/// A corner of a fan.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
struct Member {
    corner: u32,
    /// Whether its face runs against that of the corner that the fan began at.
    is_turned: bool,
}

impl Member {
    /// The next one round the vertex.
    fn ahead(self, facts: &Facts<'_>, reach: Reach) -> Option<Self> {
        self.beyond(facts, reach, self.is_turned)
    }

    /// The one before.
    fn behind(self, facts: &Facts<'_>, reach: Reach) -> Option<Self> {
        self.beyond(facts, reach, !self.is_turned)
    }

    /// Over the edge that ends at the corner, or that which begins there.
    fn beyond(self, facts: &Facts<'_>, reach: Reach, over_end: bool) -> Option<Self> {
        let topology = &facts.topology;
        let edge = if over_end { topology.previous(self.corner) } else { self.corner };
        match topology.link(edge) {
            Link::Twin(across) | Link::Welded(across) => {
                let corner = if over_end { across } else { topology.next(across) };
                Some(Self { corner, ..self })
            }
            Link::Inconsistent(along) if reach == Reach::BothWays => {
                let corner = if over_end { topology.next(along) } else { along };
                Some(Self { corner, is_turned: !self.is_turned })
            }
            _ => None,
        }
    }

    /// What its face adds to a sum.
    fn pull(self, facts: &Facts<'_>, weight: Weight, reading: Reading) -> DVec3 {
        match reading {
            Reading::Uncut => pull_uncut(facts, self.corner, weight),
            Reading::TurnedBack if self.is_turned => -pull(facts, self.corner, weight),
            Reading::Opposite => -pull(facts, self.corner, weight),
            Reading::OppositeTurnedBack if !self.is_turned => -pull(facts, self.corner, weight),
            _ => pull(facts, self.corner, weight),
        }
    }
}

/// The other corners round the vertex of a corner, in their order each way, up to a rim or once round.
struct Fan {
    corner: u32,
    ahead: Vec<Member>,
    behind: Vec<Member>,
    is_closed: bool,
}

impl Fan {
    fn new(facts: &Facts<'_>, corner: usize, reach: Reach) -> Self {
        let start = Member { corner: corner as u32, is_turned: false };
        let next = |at: &Member| at.ahead(facts, reach);
        let previous = |at: &Member| at.behind(facts, reach);
        let is_other = |at: &Member| at.corner != start.corner;
        let ahead = std::iter::successors(next(&start), next).take_while(is_other).take(LONGEST);
        let behind = std::iter::successors(previous(&start), previous).take_while(is_other).take(LONGEST);
        let [ahead, behind] = [ahead.collect::<Vec<_>>(), behind.collect()];
        let is_closed = next(ahead.last().unwrap_or(&start)).is_some_and(|next| next.corner == start.corner);
        Self { corner: start.corner, ahead, behind, is_closed }
    }

    /// The other corners.
    fn others(&self) -> impl Iterator<Item = usize> {
        // Once round, those behind are those ahead again.
        let behind = if self.is_closed { &[] } else { &self.behind[..] };
        self.ahead.iter().chain(behind).map(|member| member.corner as usize)
    }

    /// How far a normal is, in degrees, from the nearest mean of neighbouring faces, the corner's own among them, by the
    /// weighting of the mesh. A mean counts if no fewer of the others have it as well than have another together.
    fn nearest_run(&self, facts: &Facts<'_>, normal: DVec3, reading: Reading) -> f64 {
        let weight = facts.estimate.map_or(Weight::Angle, |estimate| estimate.weight);
        let unit = |at: &Member| facts.stored_unit(at.corner as usize);
        let is_one = |a: Option<DVec3>, b: Option<DVec3>| matches!((a, b), (Some(a), Some(b)) if degrees(a, b) <= SAME);
        let steps = |way: &[Member]| {
            let units: Vec<Option<DVec3>> = way.iter().map(unit).collect();
            let ties: Vec<bool> = units.windows(2).map(|pair| is_one(pair[0], pair[1])).collect();
            let vote = |at: usize| {
                let has_company = (at > 0 && ties[at - 1]) || ties.get(at).is_some_and(|&tie| tie);
                if is_one(units[at], Some(normal)) { 1 } else { -i32::from(has_company) }
            };
            let votes = (0..way.len()).map(vote);
            let pulls = way.iter().map(|at| at.pull(facts, weight, reading));
            pulls.zip(votes).collect::<Vec<_>>()
        };
        let (ahead, behind) = (steps(&self.ahead), steps(&self.behind));
        let mut nearest = Nearest { sum: DVec3::ZERO, closeness: f64::NEG_INFINITY, to: normal };
        let first = Member { corner: self.corner, is_turned: false };
        let mut from = (first.pull(facts, weight, reading), 0);
        let add = |sum: &mut (DVec3, i32), step: (DVec3, i32)| *sum = (sum.0 + step.0, sum.1 + step.1);
        for reach in 0..=behind.len() {
            if reach > 0 {
                add(&mut from, behind[reach - 1]);
            }
            nearest.offer(from);
            let most = ahead.len() - if self.is_closed { reach } else { 0 };
            let mut sum = from;
            for &next in &ahead[..most] {
                add(&mut sum, next);
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
    fn offer(&mut self, (sum, votes): (DVec3, i32)) {
        if votes < 0 {
            return;
        }
        let cosine = self.to.dot(sum);
        let closeness = cosine * cosine.abs() / sum.length_squared();
        // A sum that cancels is no direction: nothing compares with it.
        if closeness > self.closeness {
            (self.sum, self.closeness) = (sum, closeness);
        }
    }
}
