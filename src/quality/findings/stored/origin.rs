//! Where a normal that deviates from the recipe may come from: the means of runs of faces around its vertex.

use crate::mesh::Link;
use crate::normals::Weight;
use crate::quality::estimate::means::{term, term_of_quadrilateral};
use crate::quality::estimate::recipe::REPRODUCED;
use crate::quality::findings::prelude::*;
use glam::DVec3;

/// The most corners on either side that belong to a fan: around poles of more faces only those close by count.
const LONGEST: usize = 32;

/// Where a normal that is far from the expected one may come from.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Origin {
    /// Other corners of the vertex have it too, or there is no fan: only the rest of the mesh can decide.
    Shared,
    /// It is the mean of a run of faces: edges may have been marked as sharp or smooth.
    Run,
}

/// How the faces of a fan are read when they are averaged.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
struct Reading {
    /// All faces are reversed.
    is_opposite: bool,
    /// Faces that run against the first are reversed back.
    is_repaired: bool,
    /// The two triangles of a quadrilateral have its normal.
    is_uncut: bool,
}

impl Origin {
    /// The origin of the stored unit normal of a corner; `None` if there is none: it is the mean of no run of faces around the
    /// vertex, and most other corners of the fan have the expected normal, or none of them has this one, nor its face.
    pub(crate) fn of(facts: &Facts<'_>, corner: usize, normal: DVec3) -> Option<Self> {
        let uncut = Reading { is_uncut: true, ..Reading::default() };
        Self::find(facts, &Fan::new(facts, corner, false), normal, &[Reading::default(), uncut])
    }

    /// The same next to faces that run against the corner's own, or on such a face: the means also extend over these, as they
    /// are and repaired. If the corner's own face may be reversed, their opposites count too.
    pub(crate) fn of_disputed(
        facts: &Facts<'_>,
        corner: usize,
        normal: DVec3,
        is_reversed: bool,
    ) -> Option<Self> {
        let reading = |is_opposite, is_repaired| Reading { is_opposite, is_repaired, is_uncut: false };
        let readings =
            [reading(false, false), reading(false, true), reading(true, false), reading(true, true)];
        let possible = if is_reversed { &readings[..] } else { &readings[..2] };
        Self::find(facts, &Fan::new(facts, corner, true), normal, possible)
    }

    fn find(facts: &Facts<'_>, fan: &Fan, normal: DVec3, readings: &[Reading]) -> Option<Self> {
        let from_run = readings.iter().map(|&reading| fan.nearest_run(facts, normal, reading));
        let from_run = from_run.fold(f64::INFINITY, f64::min);
        let corner = fan.first.corner as usize;
        let expected = facts.expected(corner);
        let others = || fan.others().filter_map(|other| Some((other, facts.stored_unit(other)?)));
        let of_group = || others().filter(|&(other, _)| facts.expected(other) == expected);
        let has = |normal: DVec3| move |&(_, unit): &(usize, DVec3)| degrees(unit, normal) <= SAME;
        // Next to corners that follow the recipe a run has to fit as closely.
        if from_run <= SAME {
            Some(Self::Run)
        } else if 2 * of_group().filter(has(expected)).count() > of_group().count() {
            None
        } else if from_run <= REPRODUCED {
            Some(Self::Run)
        } else if of_group().next().is_some()
            && !others().any(|other| has(normal)(&other))
            && !is_flat(facts, corner, normal)
        {
            None
        } else {
            Some(Self::Shared)
        }
    }
}

/// Whether all corners of a corner's face have its normal: that of a flat face, not a single one.
fn is_flat(facts: &Facts<'_>, corner: usize, normal: DVec3) -> bool {
    let mut face = facts.corners_of(facts.face_of(corner));
    face.all(|other| facts.stored_unit(other).is_some_and(|unit| degrees(unit, normal) <= SAME))
}

/// The angle between two directions, in degrees; a right angle for a sum that cancels.
fn degrees(a: DVec3, b: DVec3) -> f64 {
    if a == DVec3::ZERO { 90.0 } else { degrees_between(a, b) }
}

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
struct FanCorner {
    corner: u32,
    /// Whether its face runs against that of the first corner.
    is_reversed: bool,
}

impl FanCorner {
    /// The next corner around the vertex, or the one before. Fans end at edges that both faces run the same way, unless these
    /// are crossed.
    fn next(self, facts: &Facts<'_>, is_ahead: bool, crosses_reversed: bool) -> Option<Self> {
        let topology = &facts.topology;
        let over_end = is_ahead == self.is_reversed;
        let edge = if over_end { topology.previous(self.corner) } else { self.corner };
        match topology.link(edge) {
            Link::Twin(across) | Link::Welded(across) => {
                let corner = if over_end { across } else { topology.next(across) };
                Some(Self { corner, ..self })
            }
            Link::Inconsistent(along) if crosses_reversed => {
                let corner = if over_end { topology.next(along) } else { along };
                Some(Self { corner, is_reversed: !self.is_reversed })
            }
            _ => None,
        }
    }

    /// What its face adds to a sum.
    fn term(self, facts: &Facts<'_>, weight: Weight, reading: Reading) -> DVec3 {
        if reading.is_uncut {
            return term_of_quadrilateral(facts, self.corner, weight);
        }
        let term = term(facts, self.corner, weight);
        if reading.is_opposite != (reading.is_repaired && self.is_reversed) { -term } else { term }
    }
}

/// The corners around the vertex of a corner, in their order each way, up to a rim or once around.
struct Fan {
    first: FanCorner,
    ahead: Vec<FanCorner>,
    behind: Vec<FanCorner>,
    is_closed: bool,
}

impl Fan {
    fn new(facts: &Facts<'_>, corner: usize, crosses_reversed: bool) -> Self {
        let first = FanCorner { corner: corner as u32, is_reversed: false };
        let next = |is_ahead| move |at: &FanCorner| at.next(facts, is_ahead, crosses_reversed);
        let [ahead, behind] = [true, false].map(|is_ahead| {
            let corners = std::iter::successors(next(is_ahead)(&first), next(is_ahead));
            corners.take_while(|at| at.corner != first.corner).take(LONGEST).collect::<Vec<_>>()
        });
        let is_closed =
            next(true)(ahead.last().unwrap_or(&first)).is_some_and(|it| it.corner == first.corner);
        Self { first, ahead, behind, is_closed }
    }

    fn others(&self) -> impl Iterator<Item = usize> {
        // In a closed fan, those behind are the same as those ahead.
        let behind = if self.is_closed { &[] } else { &self.behind[..] };
        self.ahead.iter().chain(behind).map(|at| at.corner as usize)
    }

    /// The smallest angle in degrees between a normal and the mean of a run of faces that the corner's own is in, by the
    /// weighting of the mesh. A run counts if no fewer of its other corners have this normal than have another one in common.
    fn nearest_run(&self, facts: &Facts<'_>, normal: DVec3, reading: Reading) -> f64 {
        let weight = facts.estimate.map_or(Weight::Angle, |estimate| estimate.weight);
        let unit = |at: &FanCorner| facts.stored_unit(at.corner as usize);
        let is_same = |a: Option<DVec3>, b: Option<DVec3>| matches!((a, b), (Some(a), Some(b)) if degrees(a, b) <= SAME);
        let steps = |way: &[FanCorner]| {
            let units: Vec<Option<DVec3>> = way.iter().map(unit).collect();
            let ties: Vec<bool> = units.windows(2).map(|pair| is_same(pair[0], pair[1])).collect();
            let vote = |at: usize| {
                let has_company = (at > 0 && ties[at - 1]) || ties.get(at).is_some_and(|&tie| tie);
                if is_same(units[at], Some(normal)) { 1 } else { -i32::from(has_company) }
            };
            let terms = way.iter().map(|at| at.term(facts, weight, reading));
            terms.zip((0..way.len()).map(vote)).collect::<Vec<_>>()
        };
        let (ahead, behind) = (steps(&self.ahead), steps(&self.behind));
        // The nearest sum by the square of the cosine, with its sign: one arc tangent at the end is enough.
        let (mut nearest, mut closest) = (DVec3::ZERO, f64::NEG_INFINITY);
        let mut offer = |sum: DVec3, votes: i32| {
            let cosine = normal.dot(sum);
            let closeness = cosine * cosine.abs() / sum.length_squared();
            // A sum that cancels compares with nothing.
            if votes >= 0 && closeness > closest {
                (nearest, closest) = (sum, closeness);
            }
        };
        let (mut from, mut from_votes) = (self.first.term(facts, weight, reading), 0);
        for reach in 0..=behind.len() {
            if reach > 0 {
                from += behind[reach - 1].0;
                from_votes += behind[reach - 1].1;
            }
            offer(from, from_votes);
            let most = ahead.len() - if self.is_closed { reach } else { 0 };
            let (mut sum, mut votes) = (from, from_votes);
            for &(term, vote) in &ahead[..most] {
                sum += term;
                votes += vote;
                offer(sum, votes);
            }
        }
        degrees(nearest, normal)
    }
}
