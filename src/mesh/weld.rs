//! Joining boundary edges at coincident positions, for smoothing only.
//!
//! Vertices, texture coordinates and everything else stay apart; only the faces on the two sides of a seam learn
//! of each other.

use super::Faces;
use super::edges::is_collapsed;
use super::topology::Link;
use glam::DVec3;
use rayon::prelude::*;
use rustc_hash::FxHashMap;

/// Which coincident edges are joined for smoothing.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub enum Weld {
    /// Those whose ends have the same coordinates to the bit, with −0 = +0.
    #[default]
    Exact,
    /// None.
    Off,
    /// Those whose ends are closer than this fraction of the bounding box's diagonal, chains included.
    Relative(f64),
}

/// What welding found.
pub(super) struct Joined {
    /// New links of half-edges that were boundary.
    pub(super) links: Vec<(u32, Link)>,
    /// Clusters wider than twice the welding distance.
    pub(super) wide_clusters: usize,
    /// Places where several coincident edges could be joined, and none was.
    pub(super) ambiguous: usize,
}

/// Pairs the open half-edges whose ends coincide.
pub(super) fn join(
    faces: &Faces,
    owners: &[u32],
    open: &[u32],
    positions: &[DVec3],
    shapes: &[&[DVec3]],
    weld: Weld,
) -> Joined {
    let face_of = |half_edge: u32| match owners {
        [] => half_edge as usize / 3,
        owners => owners[half_edge as usize] as usize,
    };
    let ends = |half_edge: u32| {
        let range = faces.range(face_of(half_edge));
        let next = if half_edge as usize + 1 == range.end { range.start } else { half_edge as usize + 1 };
        (faces.corners()[half_edge as usize], faces.corners()[next])
    };
    let mut rim: Vec<u32> = open.iter().flat_map(|&h| <[u32; 2]>::from(ends(h))).collect();
    rim.par_sort_unstable();
    rim.dedup();
    let Classes { of_rim, wide_clusters } = match weld {
        Weld::Off => return Joined { links: Vec::new(), wide_clusters: 0, ambiguous: 0 },
        Weld::Exact => exact_classes(&rim, positions, shapes),
        Weld::Relative(fraction) => near_classes(&rim, positions, shapes, fraction),
    };
    let class = |vertex: u32| of_rim[rim.binary_search(&vertex).expect("a rim vertex")];

    // (lower class, higher class, whether it runs downwards, half-edge)
    let mut edges: Vec<(u32, u32, bool, u32)> = open
        .par_iter()
        .filter_map(|&h| {
            let (a, b) = ends(h);
            let (a, b) = (class(a), class(b));
            // An edge of no length, and the edges of a face that has only two places left, join nothing: such a
            // face must not stand between its neighbours.
            let face = faces.face(face_of(h));
            let places = || face.iter().map(|v| rim.binary_search(v).map_or(u32::MAX - v, |i| of_rim[i]));
            let flat = a == b || face.len() == 3 && is_collapsed(places());
            (!flat).then_some((a.min(b), a.max(b), a > b, h))
        })
        .collect();
    edges.par_sort_unstable();
    let (mut links, mut ambiguous) = (Vec::new(), 0);
    for edge in edges.chunk_by(|x, y| (x.0, x.1) == (y.0, y.1)) {
        match *edge {
            [_] => {}
            [x, y] if x.2 != y.2 => links.extend([(x.3, Link::Welded(y.3)), (y.3, Link::Welded(x.3))]),
            [x, y] => links.extend([(x.3, Link::Inconsistent(y.3)), (y.3, Link::Inconsistent(x.3))]),
            _ => {
                ambiguous += 1;
                links.extend(edge.iter().map(|x| (x.3, Link::Ambiguous)));
            }
        }
    }
    Joined { links, wide_clusters, ambiguous }
}

/// Which rim vertices coincide: one class number for each, in the order of the rim.
struct Classes {
    of_rim: Vec<u32>,
    wide_clusters: usize,
}

/// The bits of a position, with −0 taken as +0.
fn key(p: DVec3) -> [u64; 3] {
    (p + DVec3::ZERO).to_array().map(f64::to_bits)
}

fn exact_classes(rim: &[u32], positions: &[DVec3], shapes: &[&[DVec3]]) -> Classes {
    let mut first: FxHashMap<[u64; 3], u32> = FxHashMap::default();
    let mut of_rim: Vec<u32> = Vec::with_capacity(rim.len());
    for &vertex in rim {
        let fresh = first.len() as u32;
        of_rim.push(*first.entry(key(positions[vertex as usize])).or_insert(fresh));
    }
    // Each morph target refines the classes: two vertices stay together only if it moves them alike.
    for shape in shapes {
        let mut finer: FxHashMap<(u32, [u64; 3]), u32> = FxHashMap::default();
        for (class, &vertex) in of_rim.iter_mut().zip(rim) {
            let fresh = finer.len() as u32;
            *class = *finer.entry((*class, key(shape[vertex as usize]))).or_insert(fresh);
        }
    }
    Classes { of_rim, wide_clusters: 0 }
}

/// Connected components of "closer than ε".
fn near_classes(rim: &[u32], positions: &[DVec3], shapes: &[&[DVec3]], fraction: f64) -> Classes {
    let (low, high) = extent(positions.iter().copied());
    // Everything is measured in units of the largest extent, so no square can leave the range of a double.
    let unit = (high - low).max_element();
    if unit.is_nan() || unit <= 0.0 || fraction <= 0.0 {
        return exact_classes(rim, positions, shapes);
    }
    let epsilon = fraction * ((high - low) / unit).length();
    let place = |vertex: u32| (positions[vertex as usize] - low) / unit;
    let mut join = NearJoin {
        epsilon,
        shapes: shapes.len() + 1,
        at: |i: u32, shape: usize| match shape {
            0 => place(rim[i as usize]),
            shape => shapes[shape - 1][rim[i as usize] as usize] / unit,
        },
        sets: DisjointSets::new(rim.len()),
    };
    join.within(&mut (0..rim.len() as u32).collect::<Vec<_>>());
    let mut sets = join.sets;
    let of_rim: Vec<u32> = (0..rim.len() as u32).map(|i| sets.find(i)).collect();
    let mut boxes: FxHashMap<u32, (DVec3, DVec3)> = FxHashMap::default();
    for (&class, &vertex) in of_rim.iter().zip(rim) {
        let p = place(vertex);
        let span = boxes.entry(class).or_insert((p, p));
        *span = (span.0.min(p), span.1.max(p));
    }
    let wide_clusters = boxes.values().filter(|(low, high)| (*high - *low).length() > 2.0 * epsilon).count();
    Classes { of_rim, wide_clusters }
}

fn extent(points: impl Iterator<Item = DVec3>) -> (DVec3, DVec3) {
    points.fold((DVec3::INFINITY, DVec3::NEG_INFINITY), |(low, high), p| (low.min(p), high.max(p)))
}

/// Joins points closer than ε in every shape, by halving them again and again until two halves are too far apart to
/// touch, or so close that all of them do. So neither crowds nor shapes that tell crowds apart cost the square of
/// their size.
///
/// Rounding is monotonic: what the boxes of two halves say holds for each of their points as [`are_near`](Self::are_near)
/// computes it.
struct NearJoin<F> {
    epsilon: f64,
    /// How many shapes there are; 0 is the mesh's own.
    shapes: usize,
    /// The position of an item in a shape.
    at: F,
    sets: DisjointSets,
}

/// Up to this many pairs are compared one by one.
const FEW_PAIRS: usize = 32;

impl<F: Fn(u32, usize) -> DVec3> NearJoin<F> {
    /// Joins what is near among some items.
    fn within(&mut self, items: &mut [u32]) {
        if self.is_crowd(items) {
            return self.unite(items, items[0]);
        }
        if items.len() * items.len() <= FEW_PAIRS {
            return self.compare(items, items);
        }
        let (left, right) = self.halves(items);
        self.within(left);
        self.within(right);
        self.between(left, right);
    }

    /// Joins what is near between two lists, each joined within itself before.
    fn between(&mut self, a: &mut [u32], b: &mut [u32]) {
        let mut all_near = true;
        for shape in 0..self.shapes {
            let ((low, high), (other_low, other_high)) = (self.bounds(a, shape), self.bounds(b, shape));
            let gap = (other_low - high).max(low - other_high).max(DVec3::ZERO);
            if gap.length() >= self.epsilon {
                return;
            }
            all_near &= (other_high - low).max(high - other_low).length() < self.epsilon;
        }
        if all_near {
            let first = a[0];
            self.unite(a, first);
            return self.unite(b, first);
        }
        // Crowds are single sets by now; one near pair says all.
        if self.is_crowd(a) && self.is_crowd(b) && self.sets.find(a[0]) == self.sets.find(b[0]) {
            return;
        }
        if a.len() * b.len() <= FEW_PAIRS {
            return self.compare(a, b);
        }
        let (halved, whole) = if a.len() >= b.len() { (a, b) } else { (b, a) };
        let (left, right) = self.halves(halved);
        self.between(left, whole);
        self.between(right, whole);
    }

    /// Whether every two of some items are near for certain.
    fn is_crowd(&self, items: &[u32]) -> bool {
        (0..self.shapes).all(|shape| {
            let (low, high) = self.bounds(items, shape);
            items.len() < 2 || (high - low).length() < self.epsilon
        }) && !items.is_empty()
    }

    /// Divides items in two along the widest axis of any shape.
    fn halves<'b>(&self, items: &'b mut [u32]) -> (&'b mut [u32], &'b mut [u32]) {
        let widths = (0..self.shapes).flat_map(|shape| {
            let (low, high) = self.bounds(items, shape);
            (high - low).to_array().into_iter().enumerate().map(move |(axis, width)| (width, shape, axis))
        });
        let widest = widths.max_by(|a, b| a.0.total_cmp(&b.0));
        let (_, shape, axis) = widest.expect("there is a shape");
        let middle = items.len() / 2;
        let along = |&i: &u32| (self.at)(i, shape)[axis];
        items.select_nth_unstable_by(middle, |i, j| along(i).total_cmp(&along(j)));
        items.split_at_mut(middle)
    }

    fn bounds(&self, items: &[u32], shape: usize) -> (DVec3, DVec3) {
        extent(items.iter().map(|&i| (self.at)(i, shape)))
    }

    fn unite(&mut self, items: &[u32], with: u32) {
        items.iter().for_each(|&i| self.sets.union(with, i));
    }

    fn compare(&mut self, a: &[u32], b: &[u32]) {
        for &i in a {
            for &j in b {
                if self.sets.find(i) != self.sets.find(j) && self.are_near(i, j) {
                    self.sets.union(i, j);
                }
            }
        }
    }

    fn are_near(&self, i: u32, j: u32) -> bool {
        (0..self.shapes).all(|shape| ((self.at)(i, shape) - (self.at)(j, shape)).length() < self.epsilon)
    }
}

/// Union-find in which the lowest member stands for its set, so that the order of unions does not show.
pub(crate) struct DisjointSets(Vec<u32>);

impl DisjointSets {
    pub(crate) fn new(len: usize) -> Self {
        Self((0..len as u32).collect())
    }

    pub(crate) fn find(&mut self, mut item: u32) -> u32 {
        while self.0[item as usize] != item {
            let up = self.0[self.0[item as usize] as usize];
            self.0[item as usize] = up;
            item = up;
        }
        item
    }

    pub(crate) fn union(&mut self, a: u32, b: u32) {
        let (a, b) = (self.find(a), self.find(b));
        self.0[a.max(b) as usize] = a.min(b);
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::num::test_numbers::Numbers;

    fn points(count: usize, spread: f64, numbers: &mut Numbers) -> Vec<DVec3> {
        (0..count).map(|_| DVec3::new(numbers.unit(), numbers.unit(), numbers.unit()) * spread).collect()
    }

    /// Classes by comparing all with all.
    fn by_brute_force(all: &[DVec3], shapes: &[&[DVec3]], fraction: f64) -> Vec<u32> {
        let (low, high) = extent(all.iter().copied());
        let unit = (high - low).max_element();
        let epsilon = fraction * ((high - low) / unit).length();
        let mut sets = DisjointSets::new(all.len());
        for i in 0..all.len() {
            for j in 0..i {
                let near_here = ((all[i] - low) / unit - (all[j] - low) / unit).length() < epsilon;
                if near_here && shapes.iter().all(|s| (s[i] / unit - s[j] / unit).length() < epsilon) {
                    sets.union(i as u32, j as u32);
                }
            }
        }
        (0..all.len() as u32).map(|i| sets.find(i)).collect()
    }

    #[test]
    fn halving_finds_what_comparing_all_with_all_finds() {
        let mut numbers = Numbers::new(77);
        for fraction in [1e-4, 0.01, 0.03, 0.06, 0.1, 0.4] {
            for spread in [0.0, 0.02, 0.2] {
                let mut all = points(700, 1.0, &mut numbers);
                // A crowd and doubles among them.
                for i in 0..200 {
                    all[i] = all[500] + all[i] * 0.003;
                    all[200 + i / 4] = all[300 + i / 2];
                }
                let moved = points(700, spread, &mut numbers);
                let rim: Vec<u32> = (0..700).collect();
                for shapes in [&[][..], &[&moved[..]]] {
                    let classes = near_classes(&rim, &all, shapes, fraction);
                    assert_eq!(classes.of_rim, by_brute_force(&all, shapes, fraction), "{fraction} {spread}");
                }
            }
        }
    }

    /// Would take hours if crowds were compared all with all.
    #[test]
    fn crowds_told_apart_by_a_shape_are_no_burden() {
        let mut numbers = Numbers::new(78);
        let mut all = points(200_000, 1e-6, &mut numbers);
        all[0] = DVec3::ONE;
        let moved = points(200_000, 1.0, &mut numbers);
        let rim: Vec<u32> = (0..200_000).collect();
        let classes = near_classes(&rim, &all, &[&moved], 1e-4);
        let mut distinct = classes.of_rim;
        distinct.sort_unstable();
        distinct.dedup();
        assert!(distinct.len() > 190_000, "{}", distinct.len());
    }
}
