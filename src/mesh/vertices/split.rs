//! Splitting vertices for formats that store every attribute per vertex.

use crate::mesh::columns::NONE;
use rustc_hash::FxHashMap;

/// Vertices split so that each has one value of every attribute.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct VertexSplit {
    /// The old vertex of each new one. The first `vertex_count` are the old vertices themselves, in order, referenced or
    /// not; copies follow, in the order of the corners that need them.
    pub source: Vec<u32>,
    /// A corner that has the new vertex's attributes; [`NONE`] for a vertex that no corner uses.
    pub sample: Vec<u32>,
    /// The new vertex of every corner.
    pub corners: Vec<u32>,
}

impl VertexSplit {
    /// How many vertices had to be added.
    pub fn added(&self, vertex_count: usize) -> usize {
        self.source.len() - vertex_count
    }

    /// Whether the new vertices are the old ones, in order.
    pub fn is_identity(&self, vertex_count: usize) -> bool {
        self.source.len() == vertex_count
            && self.source.iter().zip(0..).all(|(&source, vertex)| source == vertex)
    }
}

/// Gives each corner a vertex such that corners share one only if they share the old vertex and every key.
///
/// `keys` are per-corner attribute numbers (a normal's, a uv's); each has one entry a corner. The first corner
/// of a vertex, in corner order, keeps the old number. Time and memory are linear in corners.
pub fn split_vertices(vertex_count: usize, corner_vertices: &[u32], keys: &[&[u32]]) -> VertexSplit {
    assert!(keys.len() <= 3, "at most three keys a corner");
    let mut splitter = Splitter {
        keys,
        source: (0..vertex_count as u32).collect(),
        sample: vec![NONE; vertex_count],
        next: Vec::new(),
        overflow: FxHashMap::default(),
    };
    let corners = corner_vertices
        .iter()
        .enumerate()
        .map(|(corner, &vertex)| splitter.vertex_of(corner as u32, vertex))
        .collect();
    VertexSplit { source: splitter.source, sample: splitter.sample, corners }
}

struct Splitter<'a> {
    keys: &'a [&'a [u32]],
    source: Vec<u32>,
    sample: Vec<u32>,
    /// The next vertex that is split off the same old one: a chain that begins with the old one itself. Empty before the
    /// first split.
    next: Vec<u32>,
    /// The copies of a vertex whose chain is full. Each corner of a vertex with many keys (a fan of a million facets)
    /// must not cost a walk.
    overflow: FxHashMap<(u32, [u32; 3]), u32>,
}

/// The longest chain: more than the faces around nearly every vertex. Walking one is faster than hashing.
const CHAIN: usize = 12;

impl Splitter<'_> {
    fn key(&self, corner: u32) -> [u32; 3] {
        let mut key = [0; 3];
        for (part, keys) in key.iter_mut().zip(self.keys) {
            *part = keys[corner as usize];
        }
        key
    }

    fn vertex_of(&mut self, corner: u32, vertex: u32) -> u32 {
        let first = &mut self.sample[vertex as usize];
        if *first == NONE {
            *first = corner;
            return vertex;
        }
        let key = self.key(corner);
        let mut at = vertex;
        for length in 1..=CHAIN {
            if self.key(self.sample[at as usize]) == key {
                return at;
            }
            match self.next.get(at as usize).copied().unwrap_or(NONE) {
                NONE if length == CHAIN => break,
                NONE => {
                    let new = self.split_off(vertex, corner);
                    self.next[at as usize] = new;
                    return new;
                }
                next => at = next,
            }
        }
        if let Some(&known) = self.overflow.get(&(vertex, key)) {
            return known;
        }
        let new = self.split_off(vertex, corner);
        self.overflow.insert((vertex, key), new);
        new
    }

    fn split_off(&mut self, vertex: u32, corner: u32) -> u32 {
        self.source.push(vertex);
        self.sample.push(corner);
        self.next.resize(self.source.len(), NONE);
        self.source.len() as u32 - 1
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_vertex_is_split_once_per_distinct_key() {
        let split = split_vertices(3, &[0, 1, 2, 0, 2, 1, 0, 1, 2], &[&[5, 5, 5, 6, 5, 5, 6, 7, 5]]);
        assert_eq!(split.source, [0, 1, 2, 0, 1]);
        assert_eq!(split.sample, [0, 1, 2, 3, 7]);
        assert_eq!(split.corners, [0, 1, 2, 3, 2, 1, 3, 4, 2]);
        assert_eq!(split.added(3), 2);
    }

    #[test]
    fn unreferenced_vertices_stay() {
        let split = split_vertices(4, &[0, 1, 3], &[]);
        assert_eq!(split.source, [0, 1, 2, 3]);
        assert_eq!(split.sample[2], NONE);
    }

    #[test]
    fn a_vertex_of_many_keys_is_split_as_one_of_few() {
        // Each key twice, the second time in another order.
        let count = 100;
        let keys: Vec<u32> = (0..count).chain((0..count).map(|k| k * 7 % count)).collect();
        let split = split_vertices(1, &vec![0; keys.len()], &[&keys]);
        assert_eq!(split.source, vec![0; count as usize]);
        assert_eq!(split.corners, keys);
        assert_eq!(split.sample, (0..count).collect::<Vec<_>>());
    }
}
