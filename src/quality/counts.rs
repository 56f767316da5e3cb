//! Counting occurrences, in parallel and with the same result at any number of threads.

use crate::num::parallel;
use crate::quality::catalogue::Kind;
use crate::quality::element::Severity;
use crate::quality::spot::Spot;
use crate::text::Text;
use std::ops::Range;

/// Occurrences of a lower severity, which are mentioned but not counted.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(crate) struct Milder {
    pub(crate) components: u64,
    pub(crate) count: u64,
}

impl Milder {
    pub(crate) fn add(&mut self, components: u64, count: u64) {
        self.components += components;
        self.count += count;
    }
}

/// A sentence about a finding.
#[derive(Clone, Debug)]
pub(crate) struct Remark {
    /// Of the remarks on several parts, that with the largest weight is kept.
    pub(crate) weight: f64,
    pub(crate) text: Text,
}

/// How often something was found, and the worst occurrences.
#[derive(Clone, Debug, Default)]
pub(crate) struct Tally {
    pub(crate) count: u64,
    pub(crate) area: f64,
    /// No more than were asked for, worst first.
    pub(crate) worst: Vec<Spot>,
    pub(crate) remark: Option<Remark>,
    /// Components or vertices, which the cause puts into words where there is no remark.
    pub(crate) sum: u64,
    pub(crate) milder: Milder,
    /// Where it differs from that of the catalogue.
    pub(crate) severity: Option<Severity>,
    /// Where it differs from that of the catalogue.
    pub(crate) remedy: Option<String>,
    /// The count of the part that the remedy is from.
    remedy_count: u64,
    /// It may be intended: no command is suggested.
    pub(crate) may_be_meant: bool,
    /// The least confidence, if there is a choice.
    pub(crate) confidence: Option<f64>,
    /// The angle of one rotation of all normals in degrees, reported in place of that of the worst occurrence.
    pub(crate) rotation_degrees: Option<f64>,
}

impl Tally {
    fn add(&mut self, spot: Spot, area: f64, most: usize) {
        self.count += 1;
        self.area += area;
        self.keep(spot, most);
    }

    fn keep(&mut self, spot: Spot, most: usize) {
        if most == usize::MAX {
            // All are kept, and `take` sorts them once.
            self.worst.push(spot);
            return;
        }
        if self.worst.len() >= most && self.worst.last().is_none_or(|last| last.order(&spot).is_lt()) {
            return;
        }
        let at = self.worst.partition_point(|known| known.order(&spot).is_lt());
        self.worst.insert(at, spot);
        self.worst.truncate(most);
    }

    fn merge(&mut self, other: Tally, most: usize) {
        self.count += other.count;
        self.area += other.area;
        other.worst.into_iter().for_each(|spot| self.keep(spot, most));
        let remarks = self.remark.take().into_iter().chain(other.remark);
        self.remark = remarks.reduce(|a, b| if b.weight > a.weight { b } else { a });
        self.sum += other.sum;
        self.milder.add(other.milder.components, other.milder.count);
        self.severity = self.severity.max(other.severity);
        self.remedy = self.remedy.take().or(other.remedy);
        self.may_be_meant |= other.may_be_meant;
        self.confidence = self.confidence.into_iter().chain(other.confidence).reduce(f64::min);
        self.rotation_degrees =
            self.rotation_degrees.into_iter().chain(other.rotation_degrees).reduce(f64::max);
    }

    /// Adds what another part has, of at most this severity. Only the highest severity is counted. The remedy is that of the
    /// part with the most occurrences.
    fn add_part(&mut self, mut part: Tally, highest: Severity, most: usize) {
        let severity = Some(part.severity.unwrap_or(Severity::Error).min(highest));
        if self.severity > severity {
            self.may_be_meant |= part.may_be_meant;
            self.milder.add(part.sum, part.count);
            return;
        }
        if self.count > 0 && self.severity < severity {
            self.milder.add(self.sum, self.count);
            *self = Self { milder: self.milder, may_be_meant: self.may_be_meant, ..Self::default() };
        }
        if part.count > self.remedy_count {
            (self.remedy_count, self.remedy) = (part.count, part.remedy.take());
        }
        part.remedy = None;
        part.severity = severity;
        self.merge(part, most);
    }
}

pub(crate) type Found = Tallies<Kind>;

/// Tallies by key, usually the kind of a finding. There are few, so a search is faster than a map.
#[derive(Clone, Debug)]
pub(crate) struct Tallies<K> {
    tallies: Vec<(K, Tally)>,
    /// How many occurrences are kept for each key.
    most: usize,
}

impl<K: Copy + PartialEq> Tallies<K> {
    pub(crate) fn new(most: usize) -> Self {
        Self { tallies: Vec::new(), most }
    }

    pub(crate) fn merge(&mut self, other: Self) {
        other.tallies.into_iter().for_each(|(key, tally)| self.absorb(key, tally));
    }

    pub(crate) fn count(&self, key: K) -> u64 {
        self.tallies.iter().find(|known| known.0 == key).map_or(0, |known| known.1.count)
    }

    /// The tally of a key; empty if nothing was counted.
    pub(crate) fn tally(&mut self, key: K) -> &mut Tally {
        let known = self.tallies.iter().position(|known| known.0 == key);
        let at = known.unwrap_or_else(|| {
            self.tallies.push((key, Tally::default()));
            self.tallies.len() - 1
        });
        &mut self.tallies[at].1
    }

    pub(crate) fn take(&mut self, key: K) -> Tally {
        let mut tally = std::mem::take(self.tally(key));
        if self.most == usize::MAX {
            tally.worst.sort_unstable_by(Spot::order);
        }
        tally
    }

    pub(crate) fn add(&mut self, key: K, spot: Spot, area: f64) {
        let most = self.most;
        self.tally(key).add(spot, area, most);
    }

    /// Counts a whole mesh, with the positions where it shows.
    pub(crate) fn add_mesh(&mut self, key: K, area: f64, worst: Vec<Spot>) {
        self.absorb(key, Tally { count: 1, area, worst, ..Tally::default() });
    }

    pub(crate) fn add_part(&mut self, key: K, part: Tally, highest: Severity) {
        let most = self.most;
        self.tally(key).add_part(part, highest, most);
    }

    pub(crate) fn absorb(&mut self, key: K, tally: Tally) {
        let most = self.most;
        self.tally(key).merge(tally, most);
    }

    pub(crate) fn iter_mut(&mut self) -> impl Iterator<Item = (K, &mut Tally)> {
        self.tallies.iter_mut().filter(|(_, tally)| tally.count > 0).map(|(key, tally)| (*key, tally))
    }
}

/// Searches `count` items in parallel. Blocks have a fixed length and are added up in their order, so that sums do not depend
/// on the number of threads.
pub(crate) fn scan<K: Copy + PartialEq + Send>(
    count: usize,
    most: usize,
    search: impl Fn(Range<usize>, &mut Tallies<K>) + Sync,
) -> Tallies<K> {
    const BLOCK: usize = 1 << 14;
    let blocks = parallel::blocks(count, BLOCK, |block| {
        let mut found = Tallies::new(most);
        search(block, &mut found);
        found
    });
    let mut all = Tallies::new(most);
    blocks.into_iter().for_each(|found| all.merge(found));
    all
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_worst_places_are_kept_in_order() {
        let spot = |i: usize| Spot::face(i).by(((i * 7919) % 1000) as f64);
        let mut found = scan(100_000, 10, |range, found| range.for_each(|i| found.add((), spot(i), 0.5)));
        let tally = found.take(());
        assert_eq!((tally.count, tally.area), (100_000, 50_000.0));
        let mut all: Vec<Spot> = (0..100_000).map(spot).collect();
        all.sort_by(Spot::order);
        assert_eq!(tally.worst, all[..10]);
        assert!(tally.worst.iter().all(|spot| spot.weight == 999.0));
        let add =
            |range: Range<usize>, found: &mut Tallies<()>| range.for_each(|i| found.add((), spot(i), 0.5));
        assert_eq!(scan(100_000, usize::MAX, add).take(()).worst, all);
    }
}
