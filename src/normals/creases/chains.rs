//! Chains of crease edges: noise makes many short ones that end within a smooth surface, modelled creases few long ones.

use crate::mesh::{DisjointSets, PositionsRef, place_key};
use rustc_hash::FxHashMap;

/// Chains of crease edges: paths that end where another number of crease edges than two meet, and closed loops.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct CreaseChains {
    /// All chains.
    pub all: usize,
    /// Chains of one or two edges with a free end: within the surface, where no other crease edge meets.
    pub short: usize,
}

impl CreaseChains {
    /// Whether more than half of the chains are short, as on a scan. Fewer than twelve chains are too few to decide.
    pub fn are_scattered(&self) -> bool {
        const FEWEST: usize = 12;
        self.all >= FEWEST && 2 * self.short > self.all
    }

    /// The chains of crease edges on a surface with these boundary edges, each given by its two vertices. Vertices with equal
    /// positions are one.
    pub(crate) fn of(edges: &[[u32; 2]], boundary: &[[u32; 2]], positions: PositionsRef) -> Self {
        let key = |vertex: u32| place_key(positions.at(vertex));
        // How many edges meet at each position, and one of them.
        let mut ends: FxHashMap<[u64; 3], (u32, u32)> = FxHashMap::default();
        let mut chains = DisjointSets::new(edges.len());
        let numbered = || (0..).zip(edges).flat_map(|(edge, ends)| ends.map(|vertex| (edge, vertex)));
        for (edge, vertex) in numbered() {
            let (count, _) = ends.entry(key(vertex)).or_insert((0, edge));
            *count += 1;
        }
        for (edge, vertex) in numbered() {
            let (count, other) = ends[&key(vertex)];
            if count == 2 {
                chains.union(edge, other);
            }
        }
        for &vertex in boundary.as_flattened() {
            ends.remove(&key(vertex));
        }
        let mut has_free_end = vec![false; edges.len()];
        for &(_, edge) in ends.values().filter(|(count, _)| *count == 1) {
            has_free_end[chains.find(edge) as usize] = true;
        }
        let mut lengths = vec![0_usize; edges.len()];
        (0..edges.len() as u32).for_each(|edge| lengths[chains.find(edge) as usize] += 1);
        let found = || lengths.iter().zip(&has_free_end).filter(|(length, _)| **length > 0);
        Self {
            all: found().count(),
            short: found().filter(|(length, is_free)| **is_free && **length < 3).count(),
        }
    }
}

impl std::ops::Add for CreaseChains {
    type Output = Self;

    fn add(self, other: Self) -> Self {
        Self { all: self.all + other.all, short: self.short + other.short }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use glam::DVec3;

    #[test]
    fn chains_end_at_forks_and_close_in_loops() {
        let positions: Vec<DVec3> = (0..20).map(|i| DVec3::splat(i as f64)).collect();
        let chains = |edges: &[[u32; 2]]| {
            let CreaseChains { all, short } = CreaseChains::of(edges, &[], PositionsRef::F64(&positions));
            (all, short)
        };
        assert_eq!(chains(&[]), (0, 0));
        assert_eq!(chains(&[[0, 1], [1, 2]]), (1, 1));
        assert_eq!(chains(&[[0, 1], [2, 1], [2, 3]]), (1, 0));
        // A loop of three, and a path of one.
        assert_eq!(chains(&[[0, 1], [1, 2], [2, 0], [5, 6]]), (2, 1));
        // Three paths of one, two and three edges meet; the first of them also at its other end.
        assert_eq!(chains(&[[0, 1], [0, 2], [2, 3], [0, 4], [4, 5], [5, 6]]), (3, 2));
        assert_eq!(chains(&[[0, 1], [0, 2], [2, 3], [0, 4], [4, 5], [5, 6], [1, 7], [1, 8]]), (5, 3));
    }

    #[test]
    fn chains_to_the_boundary_have_no_free_end() {
        let positions: Vec<DVec3> = (0..6).map(|i| DVec3::splat(i as f64)).collect();
        let short = |boundary: &[[u32; 2]]| {
            CreaseChains::of(&[[0, 1], [2, 3]], boundary, PositionsRef::F64(&positions)).short
        };
        assert_eq!([short(&[]), short(&[[0, 4]]), short(&[[0, 4], [1, 5]])], [2, 2, 1]);
    }

    #[test]
    fn equal_positions_are_one_vertex() {
        let positions = [DVec3::X, DVec3::ZERO, DVec3::NEG_Y, -DVec3::ZERO, DVec3::Y, DVec3::Z];
        let chains = CreaseChains::of(&[[0, 1], [3, 4], [4, 5]], &[], PositionsRef::F64(&positions));
        assert_eq!(chains, CreaseChains { all: 1, short: 0 });
    }
}
