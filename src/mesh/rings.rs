//! The corners at each vertex, in compressed rows.

use rayon::prelude::*;
use std::sync::atomic::{AtomicU32, Ordering::Relaxed};

/// For each vertex its corners, ascending. Anything else that corners are sorted by will do as well.
#[derive(Clone, Debug, Default)]
pub(crate) struct Rings {
    offsets: Vec<u32>,
    corners: Vec<u32>,
}

impl Rings {
    /// Counting sort of corners by vertex.
    pub(crate) fn build(corner_vertices: &[u32], vertex_count: usize) -> Self {
        let threads = rayon::current_num_threads();
        if threads > 1 && corner_vertices.len() > 1 << 16 {
            return Self::build_parallel(corner_vertices, vertex_count, threads);
        }
        let mut offsets = vec![0u32; vertex_count + 1];
        for &vertex in corner_vertices {
            offsets[vertex as usize + 1] += 1;
        }
        accumulate(&mut offsets);
        let mut corners = vec![0u32; corner_vertices.len()];
        let mut cursor = offsets[..vertex_count].to_vec();
        for (corner, &vertex) in corner_vertices.iter().enumerate() {
            let slot = &mut cursor[vertex as usize];
            corners[*slot as usize] = corner as u32;
            *slot += 1;
        }
        Self { offsets, corners }
    }

    /// Each thread sorts the corners of its own range of vertices, so nothing is shared and corners stay
    /// ascending. Most meshes number neighbours alike: blocks of corners that miss a range are skipped whole.
    fn build_parallel(corner_vertices: &[u32], vertex_count: usize, threads: usize) -> Self {
        const BLOCK: usize = 3 * 1024;
        let spans: Vec<(u32, u32)> = corner_vertices
            .par_chunks(BLOCK)
            .map(|block| block.iter().fold((u32::MAX, 0), |(low, high), &v| (low.min(v), high.max(v))))
            .collect();
        let blocks_of = |range: std::ops::Range<u32>| {
            let (spans, range) = (&spans, range);
            corner_vertices.chunks(BLOCK).enumerate().filter_map(move |(i, block)| {
                let (low, high) = spans[i];
                (low < range.end && high >= range.start).then_some((i * BLOCK, block))
            })
        };
        let step = vertex_count.div_ceil(threads).max(1);
        let mut offsets = vec![0u32; vertex_count + 1];
        offsets[1..].par_chunks_mut(step).enumerate().for_each(|(part, counts)| {
            let start = (part * step) as u32;
            for (_, block) in blocks_of(start..start + counts.len() as u32) {
                for &vertex in block {
                    if let Some(count) = counts.get_mut(vertex.wrapping_sub(start) as usize) {
                        *count += 1;
                    }
                }
            }
        });
        accumulate(&mut offsets);
        let mut corners = vec![0u32; corner_vertices.len()];
        let mut parts = Vec::with_capacity(threads);
        let mut rest = corners.as_mut_slice();
        for start in (0..vertex_count).step_by(step) {
            let end = (start + step).min(vertex_count);
            let (own, tail) = rest.split_at_mut((offsets[end] - offsets[start]) as usize);
            rest = tail;
            parts.push((start, end, own));
        }
        parts.into_par_iter().for_each(|(start, end, own)| {
            let base = offsets[start];
            let mut cursor: Vec<u32> = offsets[start..end].iter().map(|&offset| offset - base).collect();
            for (first, block) in blocks_of(start as u32..end as u32) {
                for (i, &vertex) in block.iter().enumerate() {
                    if let Some(slot) = cursor.get_mut(vertex.wrapping_sub(start as u32) as usize) {
                        own[*slot as usize] = (first + i) as u32;
                        *slot += 1;
                    }
                }
            }
        });
        Self { offsets, corners }
    }

    /// The corners at a vertex, ascending.
    #[inline]
    pub(super) fn at(&self, vertex: usize) -> &[u32] {
        &self.corners[self.offsets[vertex] as usize..self.offsets[vertex + 1] as usize]
    }

    /// Where the corners of each vertex start, with the total at the end, and the corners.
    pub(crate) fn into_rows(self) -> (Vec<u32>, Vec<u32>) {
        (self.offsets, self.corners)
    }

    /// The number of vertices.
    pub(super) fn len(&self) -> usize {
        self.offsets.len() - 1
    }
}

/// Running totals in place.
fn accumulate(counts: &mut [u32]) {
    let mut total = 0;
    for count in counts {
        total += *count;
        *count = total;
    }
}

/// Numbers that several threads write at once, each to places of its own, though not in one piece.
///
/// A relaxed atomic access is a plain load or store; it only tells the compiler that threads share the memory.
#[derive(Debug)]
pub(crate) struct Scatter(Vec<AtomicU32>);

impl Scatter {
    pub(crate) fn new(len: usize, value: u32) -> Self {
        Self((0..len).into_par_iter().map(|_| AtomicU32::new(value)).collect())
    }

    #[inline]
    pub(crate) fn set(&self, index: u32, value: u32) {
        self.0[index as usize].store(value, Relaxed);
    }

    #[inline]
    pub(crate) fn get(&self, index: u32) -> u32 {
        self.0[index as usize].load(Relaxed)
    }
}

impl Clone for Scatter {
    fn clone(&self) -> Self {
        Self(self.0.iter().map(|value| AtomicU32::new(value.load(Relaxed))).collect())
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn parallel_rings_equal_sequential_ones() {
        let mut state = 1u32;
        let vertices: Vec<u32> = (0..200_000)
            .map(|i| {
                state = state.wrapping_mul(747_796_405).wrapping_add(2_891_336_453);
                if i % 5 == 0 { state % 30_011 } else { (i / 7) % 30_011 }
            })
            .collect();
        let one = Rings::build(&vertices[..60_000], 30_011);
        let same = Rings::build_parallel(&vertices[..60_000], 30_011, 3);
        assert_eq!((one.offsets, one.corners), (same.offsets, same.corners));
        let whole = Rings::build_parallel(&vertices, 30_011, 2);
        for vertex in 0..whole.len() {
            assert!(whole.at(vertex).is_sorted());
            assert!(whole.at(vertex).iter().all(|&c| vertices[c as usize] as usize == vertex));
        }
        assert_eq!((0..whole.len()).map(|v| whole.at(v).len()).sum::<usize>(), vertices.len());
    }
}
