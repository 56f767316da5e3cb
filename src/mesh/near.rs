//! Which points are connected by steps shorter than a distance.

use super::sets::DisjointSets;
use glam::DVec3;
use std::ops::Range;

/// The class of each point, by the lowest number in it. Two points are near if in every shape, a list of their positions,
/// they are closer than `epsilon`; classes are what chains of near points connect.
///
/// A tree of boxes (medians along the widest axis of any shape) is compared with itself, pair by pair of boxes: two that
/// are apart have no near points, two that lie within the distance as a whole have nothing else. So neither crowds nor
/// shapes that tell crowds apart cost the square of their size.
pub(super) fn components(shapes: &[Vec<DVec3>], epsilon: f64) -> Vec<u32> {
    let count = shapes.first().map_or(0, Vec::len);
    let mut tree = Tree {
        shapes,
        epsilon,
        items: (0..count as u32).collect(),
        nodes: Vec::new(),
        boxes: Vec::new(),
        sets: DisjointSets::new(count),
    };
    if count > 0 {
        let root = tree.build(0..count);
        tree.join_within(root);
    }
    (0..count as u32).map(|i| tree.sets.find(i)).collect()
}

/// Smallest and largest of some points, component by component.
pub(super) fn extent(points: impl Iterator<Item = DVec3>) -> (DVec3, DVec3) {
    points.fold((DVec3::INFINITY, DVec3::NEG_INFINITY), |(low, high), p| (low.min(p), high.max(p)))
}

/// Points in a leaf.
const LEAF: usize = 8;

struct Tree<'a> {
    shapes: &'a [Vec<DVec3>],
    epsilon: f64,
    /// Numbers of points; each node has some in a row.
    items: Vec<u32>,
    nodes: Vec<Node>,
    /// The boxes of each node, one a shape.
    boxes: Vec<(DVec3, DVec3)>,
    sets: DisjointSets,
}

#[derive(Clone)]
struct Node {
    items: Range<usize>,
    /// The two halves; `None` in a leaf.
    halves: Option<[usize; 2]>,
    /// Every two points are near for certain, and have been joined.
    is_crowd: bool,
}

impl Tree<'_> {
    fn build(&mut self, items: Range<usize>) -> usize {
        let number = self.nodes.len();
        let (mut widest, mut is_crowd) = ((0.0, 0, 0), true);
        for (shape, points) in self.shapes.iter().enumerate() {
            let (low, high) = extent(self.items[items.clone()].iter().map(|&i| points[i as usize]));
            self.boxes.push((low, high));
            is_crowd &= (high - low).length() < self.epsilon;
            for (axis, width) in (high - low).to_array().into_iter().enumerate() {
                if width > widest.0 {
                    widest = (width, shape, axis);
                }
            }
        }
        if is_crowd {
            let members = &self.items[items.clone()];
            members.iter().for_each(|&i| self.sets.union(members[0], i));
        }
        let (width, shape, axis) = widest;
        // Points at one place are told apart by nothing: one speaks for all.
        let alike = if width == 0.0 { items.start..items.start + 1 } else { items.clone() };
        self.nodes.push(Node { items: alike.clone(), halves: None, is_crowd });
        if alike.len() > LEAF {
            let points = &self.shapes[shape];
            let middle = items.len() / 2;
            let along = |&i: &u32| points[i as usize][axis];
            self.items[items.clone()].select_nth_unstable_by(middle, |i, j| along(i).total_cmp(&along(j)));
            let middle = items.start + middle;
            self.nodes[number].halves =
                Some([self.build(items.start..middle), self.build(middle..items.end)]);
        }
        number
    }

    /// Joins what is near among the points of a node.
    fn join_within(&mut self, node: usize) {
        if self.nodes[node].is_crowd {
            return;
        }
        match self.nodes[node].halves {
            Some([left, right]) => {
                self.join_within(left);
                self.join_within(right);
                self.join(left, right);
            }
            None => self.compare(node, node),
        }
    }

    /// Joins what is near between two nodes.
    fn join(&mut self, a: usize, b: usize) {
        let mut all_near = true;
        for shape in 0..self.shapes.len() {
            let (low, high) = self.boxes[a * self.shapes.len() + shape];
            let (other_low, other_high) = self.boxes[b * self.shapes.len() + shape];
            // Rounding is monotonic: these bounds hold for each pair of points as it would be computed.
            let gap = (other_low - high).max(low - other_high).max(DVec3::ZERO);
            if gap.length() >= self.epsilon {
                return;
            }
            all_near &= (other_high - low).max(high - other_low).length() < self.epsilon;
        }
        let (first, second) = (&self.nodes[a], &self.nodes[b]);
        let of = |node: &Node| self.items[node.items.start];
        let (member, other) = (of(first), of(second));
        if first.is_crowd && second.is_crowd && (all_near || self.sets.find(member) == self.sets.find(other))
        {
            return self.sets.union(member, other);
        }
        // The longer list is halved; a crowd is one set, but may reach too far to be near as a whole.
        match (first.halves, second.halves) {
            (Some(halves), _) if first.items.len() >= second.items.len() || second.halves.is_none() => {
                halves.into_iter().for_each(|half| self.join(half, b));
            }
            (_, Some(halves)) => halves.into_iter().for_each(|half| self.join(a, half)),
            _ => self.compare(a, b),
        }
    }

    fn compare(&mut self, a: usize, b: usize) {
        for i in self.nodes[a].items.clone() {
            for j in self.nodes[b].items.clone() {
                let (i, j) = (self.items[i], self.items[j]);
                if self.sets.find(i) != self.sets.find(j) && self.are_near(i, j) {
                    self.sets.union(i, j);
                }
            }
        }
    }

    fn are_near(&self, i: u32, j: u32) -> bool {
        let near = |points: &Vec<DVec3>| (points[i as usize] - points[j as usize]).length() < self.epsilon;
        self.shapes.iter().all(near)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::num::test_numbers::Numbers;

    fn points(count: usize, spread: f64, numbers: &mut Numbers) -> Vec<DVec3> {
        (0..count).map(|_| DVec3::new(numbers.unit(), numbers.unit(), numbers.unit()) * spread).collect()
    }

    fn by_brute_force(shapes: &[Vec<DVec3>], epsilon: f64) -> Vec<u32> {
        let count = shapes[0].len();
        let mut sets = DisjointSets::new(count);
        for i in 0..count {
            for j in 0..i {
                if shapes.iter().all(|points| (points[i] - points[j]).length() < epsilon) {
                    sets.union(i as u32, j as u32);
                }
            }
        }
        (0..count as u32).map(|i| sets.find(i)).collect()
    }

    #[test]
    fn boxes_find_what_comparing_all_with_all_finds() {
        let mut numbers = Numbers::new(77);
        for epsilon in [1e-4, 0.01, 0.03, 0.06, 0.1, 0.4] {
            for spread in [0.0, 0.02, 0.2] {
                let mut all = points(700, 1.0, &mut numbers);
                // A crowd, and points at one place.
                for i in 0..200 {
                    all[i] = all[500] + all[i] * 0.003;
                    all[200 + i / 4] = all[300 + i / 2];
                    all[300 + i / 2] = all[300];
                }
                let moved = points(700, spread, &mut numbers);
                for shapes in [vec![all.clone()], vec![all, moved]] {
                    let found = components(&shapes, epsilon);
                    assert_eq!(found, by_brute_force(&shapes, epsilon), "{epsilon} {spread}");
                }
            }
        }
    }

    /// Would take hours if crowds were compared all with all.
    #[test]
    fn crowds_are_no_burden() {
        let mut numbers = Numbers::new(78);
        let crowd = points(200_000, 1e-6, &mut numbers);
        let moved = points(200_000, 1.0, &mut numbers);
        let mut distinct = components(&[crowd.clone(), moved], 1e-4);
        distinct.sort_unstable();
        distinct.dedup();
        assert!(distinct.len() > 190_000, "{}", distinct.len());

        let mut two = crowd;
        two[100_000..].iter_mut().for_each(|p| p.x += 1.005e-4);
        let classes = components(&[two], 1e-4);
        assert!(classes.iter().all(|&class| class == 0), "they reach each other");
        assert!(components(&[], 1.0).is_empty());
    }
}
