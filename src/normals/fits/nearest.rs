//! The nearest of many points.

use glam::DVec3;
use std::cmp::Ordering;
use std::collections::BinaryHeap;

/// A point with its squared distance. Ordered by distance, then by coordinates, so that the order of a set of
/// points does not depend on how they were listed.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Neighbour {
    pub(crate) distance: f64,
    pub(crate) at: DVec3,
}

impl Neighbour {
    /// A point as seen from another; `scale` keeps the square of their distance in range.
    #[inline]
    pub(crate) fn new(at: DVec3, from: DVec3, scale: f64) -> Self {
        Self { distance: ((at - from) * scale).length_squared(), at }
    }
}

impl Ord for Neighbour {
    fn cmp(&self, other: &Self) -> Ordering {
        self.distance.total_cmp(&other.distance).then_with(|| by_coordinates(&self.at, &other.at))
    }
}

impl PartialOrd for Neighbour {
    fn partial_cmp(&self, other: &Self) -> Option<Ordering> {
        Some(self.cmp(other))
    }
}

impl PartialEq for Neighbour {
    fn eq(&self, other: &Self) -> bool {
        self.cmp(other).is_eq()
    }
}

impl Eq for Neighbour {}

/// Lexicographic order of coordinates (of which none is −0).
pub(crate) fn by_coordinates(a: &DVec3, b: &DVec3) -> Ordering {
    a.x.total_cmp(&b.x).then_with(|| a.y.total_cmp(&b.y)).then_with(|| a.z.total_cmp(&b.z))
}

/// Up to so many points are ordered by counting.
const FEW: usize = 24;

/// Appends the nearest candidates in order, at most so many.
pub(crate) fn take_nearest(candidates: &mut Vec<Neighbour>, most: usize, into: &mut Vec<DVec3>) {
    if candidates.len() > most {
        candidates.select_nth_unstable(most);
        candidates.truncate(most);
    }
    if let Some(ranks) = ranks(candidates) {
        let start = into.len();
        into.resize(start + candidates.len(), DVec3::ZERO);
        let into = &mut into[start..];
        candidates.iter().zip(ranks).for_each(|(neighbour, rank)| into[usize::from(rank)] = neighbour.at);
        return;
    }
    candidates.sort_unstable();
    into.extend(candidates.iter().map(|neighbour| neighbour.at));
}

/// How many of a few points are nearer than each of them. `None` if there are more, or two at the same distance.
///
/// It compares all with all, which takes less time than the branches of a sort that are predicted wrongly.
#[inline]
fn ranks(points: &[Neighbour]) -> Option<[u8; FEW]> {
    let (mut ranks, mut distances, count) = ([0; FEW], [0.0; FEW], points.len());
    let distances = distances.get_mut(..count)?;
    distances.iter_mut().zip(points).for_each(|(distance, point)| *distance = point.distance);
    let mut sum = 0;
    for (rank, own) in ranks.iter_mut().zip(&*distances) {
        let nearer: u64 = distances.iter().map(|other| u64::from(other < own)).sum();
        *rank = nearer as u8;
        sum += nearer as usize;
    }
    // Ranks are different if their sum is 0 + 1 + … + (count − 1).
    (2 * sum == count * count.saturating_sub(1)).then_some(ranks)
}

/// Points in a k-d tree (Bentley 1975): the middle one of each range divides it along the axis on which the range
/// is widest. Finding k of n points takes time k log n for anything like an even spread.
pub(crate) struct NearTree {
    points: Vec<DVec3>,
    axes: Vec<u8>,
}

impl NearTree {
    pub(crate) fn build(mut points: Vec<DVec3>) -> Self {
        let mut axes = vec![0; points.len()];
        let mut open: Vec<_> = std::iter::once(0..points.len()).collect();
        while let Some(range) = open.pop() {
            if range.len() < 2 {
                continue;
            }
            let part = &mut points[range.clone()];
            let (low, high) = part.iter().fold((part[0], part[0]), |(l, h), p| (l.min(*p), h.max(*p)));
            let axis = (high * 0.5 - low * 0.5).max_position();
            let middle = range.len() / 2;
            part.select_nth_unstable_by(middle, |a, b| {
                a[axis].total_cmp(&b[axis]).then(by_coordinates(a, b))
            });
            let middle = range.start + middle;
            axes[middle] = axis as u8;
            open.extend([range.start..middle, middle + 1..range.end]);
        }
        Self { points, axes }
    }

    /// Appends the `count` points nearest to one, in any order.
    pub(crate) fn nearest(&self, from: DVec3, scale: f64, count: usize, into: &mut Vec<DVec3>) {
        let mut best: BinaryHeap<Neighbour> = BinaryHeap::with_capacity(count + 1);
        // Ranges that may hold a nearer point, with a bound on their squared distance.
        let mut open = vec![(0..self.points.len(), 0.0)];
        while let Some((range, bound)) = open.pop() {
            let full = best.len() == count;
            if range.is_empty() || full && best.peek().is_some_and(|worst| bound > worst.distance) {
                continue;
            }
            let middle = range.start + range.len() / 2;
            best.push(Neighbour::new(self.points[middle], from, scale));
            if full {
                best.pop();
            }
            let axis = usize::from(self.axes[middle]);
            let beyond = (from[axis] - self.points[middle][axis]) * scale;
            let (below, above) = (range.start..middle, middle + 1..range.end);
            let (near, far) = if beyond < 0.0 { (below, above) } else { (above, below) };
            open.extend([(far, bound.max(beyond * beyond)), (near, bound)]);
        }
        into.extend(best.into_iter().map(|neighbour| neighbour.at));
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::num::test_numbers::Numbers;

    #[test]
    fn the_nearest_are_in_order() {
        let mut numbers = Numbers::new(7);
        let mut counted = 0;
        for size in 0..2 * FEW {
            // Without ties, and on a coarse grid with many.
            for grid in [0.0, 4.0] {
                let coordinate = |x: f64| if grid == 0.0 { x } else { (grid * x).floor() };
                let mut point = || DVec3::from(std::array::from_fn(|_| coordinate(numbers.unit())));
                let candidates: Vec<_> =
                    (0..size).map(|_| Neighbour::new(point(), DVec3::ZERO, 0.5)).collect();
                counted += usize::from(ranks(&candidates).is_some());
                let mut expected = candidates.clone();
                expected.sort();
                for most in [size / 2, size] {
                    let mut found = vec![DVec3::ONE];
                    take_nearest(&mut candidates.clone(), most, &mut found);
                    assert!(found[1..].iter().eq(expected[..most].iter().map(|it| &it.at)), "{size}");
                }
            }
        }
        assert!(counted > FEW, "{counted}");
    }

    #[test]
    fn the_tree_finds_what_sorting_finds() {
        let mut numbers = Numbers::new(11);
        for size in [0usize, 1, 2, 3, 50, 1000] {
            // A coarse grid: many equal coordinates, many equal distances.
            let mut points: Vec<DVec3> = (0..size)
                .map(|_| DVec3::from(std::array::from_fn(|_| (8.0 * numbers.unit()).floor())))
                .collect();
            points.sort_by(by_coordinates);
            points.dedup();
            let tree = NearTree::build(points.clone());
            for count in [1, 7, 64] {
                for from in [DVec3::splat(2.0), DVec3::new(7.3, 0.1, -4.0)] {
                    let sorted = |points: &[DVec3]| {
                        let mut all: Vec<_> = points.iter().map(|&p| Neighbour::new(p, from, 0.5)).collect();
                        all.sort_unstable();
                        all
                    };
                    let mut found = Vec::new();
                    tree.nearest(from, 0.5, count, &mut found);
                    let expected = sorted(&points);
                    assert_eq!(sorted(&found), expected[..count.min(expected.len())]);
                }
            }
        }
    }
}
