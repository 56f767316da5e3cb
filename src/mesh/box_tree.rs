//! Axis-aligned boxes, and a tree of them for queries that concern few of many items.

use crate::num::parallel;
use glam::DVec3;
use rayon::prelude::*;
use std::ops::Range;

/// An axis-aligned box.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Bounds {
    pub(crate) low: DVec3,
    pub(crate) high: DVec3,
}

impl Bounds {
    /// The box of no points.
    pub(crate) const EMPTY: Self = Self { low: DVec3::INFINITY, high: DVec3::NEG_INFINITY };

    /// The smallest box around some points.
    pub(crate) fn of(points: impl Iterator<Item = DVec3>) -> Self {
        points.fold(Self::EMPTY, |all, p| all.union(Self { low: p, high: p }))
    }

    pub(crate) fn union(self, other: Self) -> Self {
        Self { low: self.low.min(other.low), high: self.high.max(other.high) }
    }

    /// The centre, without overflow.
    pub(crate) fn middle(self) -> DVec3 {
        0.5 * self.low + 0.5 * self.high
    }

    pub(crate) fn contains(self, other: Self) -> bool {
        self.low.cmple(other.low).all() && self.high.cmpge(other.high).all()
    }

    pub(crate) fn overlaps(self, other: Self) -> bool {
        self.low.cmple(other.high).all() && self.high.cmpge(other.low).all()
    }
}

/// Items in the order of a Morton curve through the middles of their boxes, and above them a complete tree of
/// the boxes of [`BRANCH`] neighbours each. Linear in memory, balanced whatever the input.
pub(crate) struct BoxTree {
    items: Vec<u32>,
    /// Boxes of runs of items, then of runs of those, and so on; the last level has one box at most.
    levels: Vec<Vec<Bounds>>,
}

/// How many boxes make one of the next level.
const BRANCH: usize = 4;

impl BoxTree {
    /// A tree of the items 0..count.
    pub(crate) fn build(count: usize, bounds: &(dyn Fn(u32) -> Bounds + Sync)) -> Self {
        let union =
            |items: Range<usize>| items.map(|item| bounds(item as u32)).fold(Bounds::EMPTY, Bounds::union);
        let all = parallel::ranges(count, union).into_iter().fold(Bounds::EMPTY, Bounds::union);
        let size = all.high - all.low;
        let mut order = parallel::map(count, |item| {
            let item = item as u32;
            (morton((bounds(item).middle() - all.low) / size), item)
        });
        order.par_sort_unstable();
        let items: Vec<u32> = order.into_iter().map(|(_, item)| item).collect();
        let run = |run: Range<usize>| {
            items[run].iter().map(|&item| bounds(item)).fold(Bounds::EMPTY, Bounds::union)
        };
        let mut levels: Vec<Vec<Bounds>> = vec![parallel::blocks(count, BRANCH, run)];
        while let Some(below) = levels.last().filter(|level| level.len() > 1) {
            let run = |run: Range<usize>| below[run].iter().copied().fold(Bounds::EMPTY, Bounds::union);
            let level = parallel::blocks(below.len(), BRANCH, run);
            levels.push(level);
        }
        Self { items, levels }
    }

    /// Offers every item of every run whose boxes all `enter`, until one does not `go_on`. Each box and each item costs one
    /// unit of the budget. Returns whether that was enough.
    pub(crate) fn visit(
        &self,
        budget: &mut usize,
        enter: impl Fn(Bounds) -> bool,
        mut go_on: impl FnMut(u32) -> bool,
    ) -> bool {
        let top = self.levels.len() - 1;
        let mut open: Vec<(usize, usize)> = (0..self.levels[top].len()).map(|i| (top, i)).collect();
        while let Some((level, i)) = open.pop() {
            let Some(rest) = budget.checked_sub(1) else { return false };
            *budget = rest;
            if !enter(self.levels[level][i]) {
                continue;
            }
            let below = if level == 0 { self.items.len() } else { self.levels[level - 1].len() };
            let children = BRANCH * i..(BRANCH * (i + 1)).min(below);
            if level > 0 {
                open.extend(children.map(|child| (level - 1, child)));
                continue;
            }
            for &item in &self.items[children] {
                *budget = budget.saturating_sub(1);
                if !go_on(item) {
                    return true;
                }
            }
        }
        true
    }
}

/// Interleaves 21 bits of each coordinate; coordinates are in 0..=1 (what is not a number counts as 0).
fn morton(place: DVec3) -> u64 {
    let spread = |x: f64| {
        let mut bits = ((x * f64::from(1 << 21)) as u64).min((1 << 21) - 1);
        for (shift, mask) in [
            (32, 0x001f_0000_0000_ffff),
            (16, 0x001f_0000_ff00_00ff),
            (8, 0x100f_00f0_0f00_f00f),
            (4, 0x10c3_0c30_c30c_30c3),
            (2, 0x1249_2492_4924_9249),
        ] {
            bits = (bits | bits << shift) & mask;
        }
        bits
    };
    spread(place.x) | spread(place.y) << 1 | spread(place.z) << 2
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_visit_finds_what_a_scan_finds() {
        let mut state = 7u32;
        let mut random = || {
            state = state.wrapping_mul(747_796_405).wrapping_add(2_891_336_453);
            f64::from(state >> 8) / f64::from(1 << 24)
        };
        for count in [0usize, 1, 3, 4, 5, 17, 1000] {
            let boxes: Vec<Bounds> = (0..count)
                .map(|_| {
                    let low = DVec3::new(random(), random(), random());
                    Bounds { low, high: low + 0.1 * DVec3::new(random(), random(), random()) }
                })
                .collect();
            let tree = BoxTree::build(count, &|i| boxes[i as usize]);
            let probe = Bounds { low: DVec3::splat(0.4), high: DVec3::splat(0.6) };
            let scan: Vec<u32> = (0..count as u32).filter(|&i| boxes[i as usize].overlaps(probe)).collect();
            let mut found = Vec::new();
            let (mut plenty, mut little) = (10_000, 1);
            let enough = tree.visit(
                &mut plenty,
                |bounds| bounds.overlaps(probe),
                |item| {
                    found.extend(boxes[item as usize].overlaps(probe).then_some(item));
                    true
                },
            );
            found.sort_unstable();
            assert!(enough);
            assert_eq!(found, scan);
            let enough = tree.visit(&mut little, |_| true, |_| true);
            assert_eq!(enough, count <= BRANCH, "{count}");
        }
    }

    #[test]
    fn morton_codes_interleave() {
        let bit = |bit: u32| f64::from(1 << bit) / f64::from(1 << 21);
        for i in 0..21 {
            assert_eq!(morton(DVec3::new(bit(i), 0.0, 0.0)), 1 << (3 * i));
            assert_eq!(morton(DVec3::new(0.0, f64::NAN, bit(i))), 1 << (3 * i + 2));
        }
        assert_eq!(morton(DVec3::ONE), (1 << 63) - 1);
    }
}
