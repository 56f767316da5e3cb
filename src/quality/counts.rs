//! Counting findings, in parallel and with the same result at any number of threads.

use crate::mesh::NONE;
use crate::quality::catalogue::{Kind, entries};
use crate::quality::finding::Severity;
use rayon::prelude::*;
use std::ops::Range;

/// What the weight of an occurrence says besides the order of places.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Gauge {
    /// Nothing.
    Order,
    /// By how many degrees a normal is off.
    Angle,
    /// What it does to the grey value under a key light, in steps of 8 bits.
    Steps,
    /// How many of the [kind's unit](Kind::unit); less than nothing where less is worse.
    Amount,
}

/// One occurrence. What it is not about is [`NONE`].
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Spot {
    pub(super) face: u32,
    /// A corner of the mesh, not of the face.
    pub(super) corner: u32,
    pub(super) vertex: u32,
    /// Of the nodes that have the part, by their order.
    pub(super) node: u32,
    /// How bad it is: the order of places.
    pub(super) weight: f64,
    pub(super) gauge: Gauge,
}

impl Spot {
    /// A corner that is off by an angle.
    pub(super) fn corner(face: usize, corner: usize, degrees: f64) -> Self {
        Self {
            face: face as u32,
            corner: corner as u32,
            vertex: NONE,
            node: NONE,
            weight: degrees,
            gauge: Gauge::Angle,
        }
    }

    /// A face, with something that makes it worse than others.
    pub(super) fn face(face: usize, weight: f64) -> Self {
        Self { face: face as u32, corner: NONE, vertex: NONE, node: NONE, weight, gauge: Gauge::Order }
    }

    /// A vertex.
    pub(super) fn vertex(vertex: usize, weight: f64) -> Self {
        Self { face: NONE, corner: NONE, vertex: vertex as u32, node: NONE, weight, gauge: Gauge::Order }
    }

    /// A place of the mesh in the world.
    pub(super) fn node(number: usize) -> Self {
        Self { node: number as u32, ..Self::mesh() }
    }

    /// Neither face nor vertex: the mesh as a whole.
    pub(super) fn mesh() -> Self {
        Self { face: NONE, corner: NONE, vertex: NONE, node: NONE, weight: 0.0, gauge: Gauge::Order }
    }

    /// The same, with an angle for its weight.
    pub(super) fn by(self, degrees: f64) -> Self {
        Self { weight: degrees, gauge: Gauge::Angle, ..self }
    }

    /// The same, measured otherwise.
    pub(super) fn of(self, gauge: Gauge, weight: f64) -> Self {
        Self { weight, gauge, ..self }
    }

    /// Worse ones first; among equals the first of the mesh.
    fn order(&self, other: &Self) -> std::cmp::Ordering {
        let place = |spot: &Self| (spot.face, spot.corner, spot.vertex, spot.node);
        other.weight.total_cmp(&self.weight).then_with(|| place(self).cmp(&place(other)))
    }
}

/// What is milder than what a finding counts, and is told beside it.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(super) struct Milder {
    pub(super) components: u64,
    pub(super) count: u64,
}

impl Milder {
    pub(super) fn add(&mut self, components: u64, count: u64) {
        self.components += components;
        self.count += count;
    }
}

/// What else is to be said of a finding.
#[derive(Clone, Debug)]
pub(super) struct Remark {
    /// Of several parts the remark about the one with most of this is told.
    pub(super) weight: f64,
    pub(super) text: String,
}

/// Of two remarks the one with more weight; the first among equals.
pub(super) fn weightier(a: Option<Remark>, b: Option<Remark>) -> Option<Remark> {
    a.into_iter().chain(b).reduce(|a, b| if b.weight > a.weight { b } else { a })
}

/// How often something was found, and the worst places.
#[derive(Clone, Debug, Default)]
pub(super) struct Tally {
    pub(super) count: u64,
    pub(super) area: f64,
    /// At most so many as were asked for, worst first.
    pub(super) worst: Vec<Spot>,
    pub(super) remark: Option<Remark>,
    /// Vertices that could be merged away, which are told in place of a remark.
    pub(super) mergeable: usize,
    /// Components that it is of, where they are told in place of a remark.
    pub(super) components: u64,
    /// Components of a lower severity, which are not counted.
    pub(super) milder: Milder,
    /// Where it is not the catalogue's.
    pub(super) severity: Option<Severity>,
    /// Where it is not the catalogue's.
    pub(super) remedy: Option<String>,
    /// It may be meant, and nothing is suggested.
    pub(super) may_be_meant: bool,
    /// How sure it is, at least, where that is a question.
    pub(super) confidence: Option<f64>,
    /// By how many degrees one turn of all is, where that is told rather than how far the worst place is off.
    pub(super) turn: Option<f64>,
}

/// The smaller of two numbers that may not be there.
pub(super) fn least(a: Option<f64>, b: Option<f64>) -> Option<f64> {
    a.into_iter().chain(b).reduce(f64::min)
}

impl Tally {
    /// Counts an occurrence that covers so much area.
    pub(super) fn add(&mut self, spot: Spot, area: f64, most: usize) {
        self.count += 1;
        self.area += area;
        self.keep(spot, most);
    }

    fn keep(&mut self, spot: Spot, most: usize) {
        if self.worst.len() >= most && self.worst.last().is_none_or(|last| last.order(&spot).is_lt()) {
            return;
        }
        let at = self.worst.partition_point(|known| known.order(&spot).is_lt());
        self.worst.insert(at, spot);
        self.worst.truncate(most);
    }

    pub(super) fn merge(&mut self, other: Tally, most: usize) {
        self.count += other.count;
        self.area += other.area;
        other.worst.into_iter().for_each(|spot| self.keep(spot, most));
        self.remark = weightier(self.remark.take(), other.remark);
        self.mergeable += other.mergeable;
        self.components += other.components;
        self.milder.add(other.milder.components, other.milder.count);
        self.severity = self.severity.max(other.severity);
        self.remedy = self.remedy.take().or(other.remedy);
        self.may_be_meant |= other.may_be_meant;
        self.confidence = least(self.confidence, other.confidence);
        self.turn = self.turn.into_iter().chain(other.turn).reduce(f64::max);
    }
}

/// One tally for every kind of finding.
#[derive(Clone, Debug)]
pub(super) struct Tallies {
    tallies: Vec<Tally>,
    /// How many places of each finding are kept.
    most: usize,
}

/// What is gathered block by block.
pub(super) trait Gathered: Send {
    /// Nothing yet, with room for so many places of each finding.
    fn new(most: usize) -> Self;

    /// Adds what a later block has.
    fn merge(&mut self, other: Self);
}

impl Gathered for Tallies {
    fn new(most: usize) -> Self {
        Tallies::new(most)
    }

    fn merge(&mut self, other: Self) {
        self.merge(other);
    }
}

impl Tallies {
    pub(super) fn new(most: usize) -> Self {
        Self { tallies: vec![Tally::default(); Kind::COUNT], most }
    }

    pub(super) fn merge(&mut self, other: Self) {
        let most = self.most;
        self.tallies.iter_mut().zip(other.tallies).for_each(|(own, other)| own.merge(other, most));
    }

    /// An option that every command needs here.
    pub(super) fn add_to_remedies(&mut self, option: &str) {
        for entry in entries() {
            let tally = self.tally(entry.kind);
            let own = tally.remedy.take().or_else(|| entry.remedy.map(str::to_owned));
            tally.remedy =
                own.map(|own| if own.is_empty() { option.to_owned() } else { format!("{own} {option}") });
        }
    }

    pub(super) fn get(&self, kind: Kind) -> &Tally {
        &self.tallies[kind as usize]
    }

    pub(super) fn tally(&mut self, kind: Kind) -> &mut Tally {
        &mut self.tallies[kind as usize]
    }

    pub(super) fn take(&mut self, kind: Kind) -> Tally {
        std::mem::take(&mut self.tallies[kind as usize])
    }

    /// Counts an occurrence that covers so much area.
    pub(super) fn add(&mut self, kind: Kind, spot: Spot, area: f64) {
        let most = self.most;
        self.tally(kind).add(spot, area, most);
    }

    /// Counts a whole mesh, with places where it shows.
    pub(super) fn add_mesh(&mut self, kind: Kind, area: f64, worst: Vec<Spot>) {
        let most = self.most;
        let tally = self.tally(kind);
        tally.count += 1;
        tally.area += area;
        worst.into_iter().for_each(|spot| tally.keep(spot, most));
    }

    /// What one kind has goes over to another.
    pub(super) fn rename(&mut self, from: Kind, to: Kind) {
        let tally = self.take(from);
        self.absorb(to, tally);
    }

    /// What was counted elsewhere turns out to be of a kind.
    pub(super) fn absorb(&mut self, kind: Kind, tally: Tally) {
        let most = self.most;
        self.tally(kind).merge(tally, most);
    }
}

/// Looks at all of so many things, in parallel, and counts what is found.
pub(super) fn scan(count: usize, most: usize, look: impl Fn(Range<usize>, &mut Tallies) + Sync) -> Tallies {
    gather(count, most, look)
}

/// Looks at all of so many things, in parallel, block by block. Blocks have a fixed length and are added up in their
/// order, so that sums do not depend on the number of threads.
pub(super) fn gather<T: Gathered>(
    count: usize,
    most: usize,
    look: impl Fn(Range<usize>, &mut T) + Sync,
) -> T {
    const BLOCK: usize = 1 << 14;
    let blocks: Vec<T> = (0..count.div_ceil(BLOCK))
        .into_par_iter()
        .map(|block| {
            let mut found = T::new(most);
            look(block * BLOCK..((block + 1) * BLOCK).min(count), &mut found);
            found
        })
        .collect();
    let mut all = T::new(most);
    blocks.into_iter().for_each(|found| all.merge(found));
    all
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_worst_places_are_kept_in_order() {
        let weight = |i: usize| ((i * 7919) % 1000) as f64;
        let found = scan(100_000, 10, |range, found| {
            range.for_each(|i| found.add(Kind::Needles, Spot::face(i, weight(i)), 0.5));
        });
        let tally = found.get(Kind::Needles);
        assert_eq!((tally.count, tally.area), (100_000, 50_000.0));
        let mut all: Vec<Spot> = (0..100_000).map(|i| Spot::face(i, weight(i))).collect();
        all.sort_by(Spot::order);
        assert_eq!(tally.worst, all[..10]);
        assert!(tally.worst.iter().all(|spot| spot.weight == 999.0));
    }
}
