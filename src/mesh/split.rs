//! Splitting vertices for formats that store every attribute per vertex.

use super::NONE;

/// Vertices split so that each has one value of every attribute.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct VertexSplit {
    /// The old vertex behind each new one. The first `vertex_count` are the old vertices themselves, in order,
    /// referenced or not; copies follow, in the order in which corners ask for them.
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
}

/// Gives each corner a vertex such that corners share one only if they share the old vertex and every key.
///
/// `keys` are per-corner attribute numbers (a normal's, a uv's); each has one entry a corner. The first corner
/// of a vertex, in corner order, keeps the old number. Time and memory are linear in corners.
pub fn split_vertices(vertex_count: usize, corner_vertices: &[u32], keys: &[&[u32]]) -> VertexSplit {
    let mut source: Vec<u32> = (0..vertex_count as u32).collect();
    let mut sample = vec![NONE; vertex_count];
    // A vertex that is asked for with many key tuples (a fan of a million facets) must not cost a scan each:
    // copies are found by hash, only the first tuple of a vertex directly.
    let mut copies: rustc_hash::FxHashMap<(u32, [u32; 3]), u32> = rustc_hash::FxHashMap::default();
    assert!(keys.len() <= 3, "at most three keys a corner");
    let tuple = |corner: usize| {
        let mut tuple = [0; 3];
        for (slot, key) in tuple.iter_mut().zip(keys) {
            *slot = key[corner];
        }
        tuple
    };
    let corners = corner_vertices
        .iter()
        .enumerate()
        .map(|(corner, &vertex)| {
            let first = &mut sample[vertex as usize];
            if *first == NONE {
                *first = corner as u32;
                return vertex;
            }
            if tuple(*first as usize) == tuple(corner) {
                return vertex;
            }
            *copies.entry((vertex, tuple(corner))).or_insert_with(|| {
                source.push(vertex);
                sample.push(corner as u32);
                source.len() as u32 - 1
            })
        })
        .collect();
    VertexSplit { source, sample, corners }
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
}
