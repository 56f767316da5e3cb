//! The corners at each vertex, in compressed rows.

use rayon::prelude::*;
use std::sync::atomic::{AtomicU32, Ordering::Relaxed};

/// The corners of each vertex, ascending; or of any other number that corners are grouped by.
#[derive(Clone, Debug, Default)]
pub(crate) struct Rings {
    pub(crate) offsets: Vec<u32>,
    pub(crate) corners: Vec<u32>,
}

impl Rings {
    /// Counting sort of corners by vertex.
    pub(crate) fn build(corner_vertices: &[u32], vertex_count: usize) -> Self {
        let mut rings = Self::default();
        rings.fill(corner_vertices, vertex_count);
        rings
    }

    /// As [`build`](Self::build), in reused memory.
    pub(crate) fn fill(&mut self, corner_vertices: &[u32], vertex_count: usize) {
        let threads = rayon::current_num_threads();
        let parts = if corner_vertices.len() > 1 << 16 { threads } else { 1 };
        // Old values are overwritten, so only new memory needs to be initialised, which the system does page by page.
        if self.corners.capacity() < corner_vertices.len() {
            self.corners = vec![0; corner_vertices.len()];
        }
        self.corners.resize(corner_vertices.len(), 0);
        self.offsets.clear();
        if self.offsets.capacity() <= vertex_count {
            self.offsets = vec![0; vertex_count + 1];
        }
        self.offsets.resize(vertex_count + 1, 0);
        if parts > 1 {
            self.sort_by_parts(corner_vertices, vertex_count, parts);
        } else {
            self.sort(corner_vertices);
        }
    }

    /// `offsets[v + 1]` is the index of the next corner of v, and ends up as the start of those of v + 1.
    fn sort(&mut self, corner_vertices: &[u32]) {
        let Self { offsets, corners } = self;
        for &vertex in corner_vertices {
            offsets[vertex as usize + 1] += 1;
        }
        start_from_counts(&mut offsets[1..], 0);
        for (corner, &vertex) in corner_vertices.iter().enumerate() {
            let slot = &mut offsets[vertex as usize + 1];
            corners[*slot as usize] = corner as u32;
            *slot += 1;
        }
    }

    /// Each thread sorts the corners of its own range of vertices, so nothing is shared and corners stay
    /// ascending. Most meshes number neighbours alike: blocks of corners that miss a range are skipped whole.
    fn sort_by_parts(&mut self, corner_vertices: &[u32], vertex_count: usize, parts: usize) {
        const BLOCK: usize = 3 * 1024;
        let Self { offsets, corners } = self;
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
        let step = vertex_count.div_ceil(parts).max(1);
        let totals: Vec<u32> = offsets[1..]
            .par_chunks_mut(step)
            .enumerate()
            .map(|(part, counts)| {
                let start = (part * step) as u32;
                for (_, block) in blocks_of(start..start + counts.len() as u32) {
                    for &vertex in block {
                        if let Some(count) = counts.get_mut(vertex.wrapping_sub(start) as usize) {
                            *count += 1;
                        }
                    }
                }
                counts.iter().sum()
            })
            .collect();
        let (mut rest, mut first) = (corners.as_mut_slice(), 0);
        let of_part = |&total: &u32| {
            let own = rest.split_off_mut(..total as usize).expect("one a corner");
            first += total;
            (first - total, own)
        };
        let own: Vec<(u32, &mut [u32])> = totals.iter().map(of_part).collect();
        offsets[1..].par_chunks_mut(step).zip(own).enumerate().for_each(|(part, (slots, (base, own)))| {
            let start = (part * step) as u32;
            start_from_counts(slots, base);
            for (first, block) in blocks_of(start..start + slots.len() as u32) {
                for (i, &vertex) in block.iter().enumerate() {
                    if let Some(slot) = slots.get_mut(vertex.wrapping_sub(start) as usize) {
                        own[(*slot - base) as usize] = (first + i) as u32;
                        *slot += 1;
                    }
                }
            }
        });
    }

    /// The corners at a vertex, ascending.
    #[inline]
    pub(crate) fn at(&self, vertex: usize) -> &[u32] {
        &self.corners[self.offsets[vertex] as usize..self.offsets[vertex + 1] as usize]
    }

    /// The number of vertices.
    pub(super) fn len(&self) -> usize {
        self.offsets.len() - 1
    }
}

/// Turns counts into where each run starts, the first at `total`.
fn start_from_counts(counts: &mut [u32], mut total: u32) {
    for count in counts {
        total += std::mem::replace(count, total);
    }
}

/// Numbers that several threads write at once, each to scattered indices of its own.
///
/// A relaxed atomic access is a plain load or store; it only informs the compiler that threads share the memory.
#[derive(Debug, Default)]
pub(crate) struct Scatter(Vec<AtomicU32>);

impl Scatter {
    pub(crate) fn new(len: usize, value: u32) -> Self {
        Self((0..len).into_par_iter().map(|_| AtomicU32::new(value)).collect())
    }

    /// Makes room for so many numbers, with unspecified values. Pages that nothing is written to are never given memory.
    pub(crate) fn reserve(&mut self, len: usize) {
        if self.0.len() < len {
            *self = Self(bytemuck::zeroed_vec(len));
        }
    }

    /// The numbers.
    pub(super) fn into_values(self) -> Vec<u32> {
        self.0.into_par_iter().map(AtomicU32::into_inner).collect()
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
        let with_parts = |vertices: &[u32], parts| {
            let mut rings = Rings { offsets: vec![0; 30_012], corners: vec![0; vertices.len()] };
            rings.sort_by_parts(vertices, 30_011, parts);
            rings
        };
        let same = with_parts(&vertices[..60_000], 3);
        assert_eq!((&one.offsets, &one.corners), (&same.offsets, &same.corners));
        let mut whole = with_parts(&vertices, 2);
        for vertex in 0..whole.len() {
            assert!(whole.at(vertex).is_sorted());
            assert!(whole.at(vertex).iter().all(|&c| vertices[c as usize] as usize == vertex));
        }
        assert_eq!((0..whole.len()).map(|v| whole.at(v).len()).sum::<usize>(), vertices.len());
        whole.fill(&vertices[..60_000], 30_011);
        assert_eq!(whole.corners, same.corners, "what was there before leaves no trace");
    }
}
