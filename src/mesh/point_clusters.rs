//! Clusters of points that are connected by steps shorter than a distance, by a k-d tree.

use super::box_tree::Bounds;
use super::disjoint_sets::DisjointSets;
use glam::DVec3;
use std::ops::Range;

/// The cluster of each point, by its lowest point. Two points are near if they are closer than `epsilon` in every shape, a
/// list of positions; clusters are connected by chains of near points.
///
/// A k-d tree (medians along the widest axis of any shape) is compared with itself, pair by pair of boxes: boxes farther
/// apart have no near points; in boxes that lie within the distance as a whole all points are near. So neither dense
/// clusters nor shapes that separate them cost the square of their size.
pub(super) fn clusters(shapes: &[Vec<DVec3>], epsilon: f64) -> Vec<u32> {
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
        tree.join(root, root);
    }
    (0..count as u32).map(|i| tree.sets.find(i)).collect()
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
    boxes: Vec<Bounds>,
    sets: DisjointSets,
}

struct Node {
    items: Range<usize>,
    /// The two halves; `None` in a leaf.
    halves: Option<[usize; 2]>,
    /// All pairs of points are near, and have been joined.
    is_crowd: bool,
}

impl Tree<'_> {
    fn build(&mut self, items: Range<usize>) -> usize {
        let number = self.nodes.len();
        let (mut widest, mut is_crowd) = ((0.0, 0, 0), true);
        for (shape, points) in self.shapes.iter().enumerate() {
            let bounds = Bounds::of(self.items[items.clone()].iter().map(|&i| points[i as usize]));
            self.boxes.push(bounds);
            let size = bounds.high - bounds.low;
            is_crowd &= size.length() < self.epsilon;
            for (axis, width) in size.to_array().into_iter().enumerate() {
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
        // Coincident points are equivalent: one represents all.
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

    /// Joins near points of two nodes, or of one with itself.
    fn join(&mut self, a: usize, b: usize) {
        let mut all_near = true;
        for shape in 0..self.shapes.len() {
            let [one, other] = [a, b].map(|node| self.boxes[node * self.shapes.len() + shape]);
            // Rounding is monotonic: these bounds hold for each pair of points as it would be computed.
            let gap = (other.low - one.high).max(one.low - other.high).max(DVec3::ZERO);
            if gap.length() >= self.epsilon {
                return;
            }
            all_near &= (other.high - one.low).max(one.high - other.low).length() < self.epsilon;
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
            (Some([left, right]), _) if a == b => {
                self.join(left, left);
                self.join(right, right);
                self.join(left, right);
            }
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
                let is_near =
                    |points: &Vec<DVec3>| (points[i as usize] - points[j as usize]).length() < self.epsilon;
                if self.sets.find(i) != self.sets.find(j) && self.shapes.iter().all(is_near) {
                    self.sets.union(i, j);
                }
            }
        }
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
                    let found = clusters(&shapes, epsilon);
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
        let mut distinct = clusters(&[crowd.clone(), moved], 1e-4);
        distinct.sort_unstable();
        distinct.dedup();
        assert!(distinct.len() > 190_000, "{}", distinct.len());

        let mut two = crowd;
        two[100_000..].iter_mut().for_each(|p| p.x += 1.005e-4);
        let classes = clusters(&[two], 1e-4);
        assert!(classes.iter().all(|&class| class == 0), "they reach each other");
        assert!(clusters(&[], 1.0).is_empty());
    }
}
