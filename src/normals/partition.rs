//! Sharing sums out among threads so that no thread count changes a bit.
//!
//! Slots (vertices or smooth groups) are owned by *parts*, in chunks. Each part walks the blocks of faces that touch
//! its chunks in ascending order and adds only to its own slots, so every sum runs in ascending face index. Chunks
//! go to the part in whose share of the faces they are first seen: with faces in any sensible order few blocks are
//! walked twice, whatever the vertex order is.

use crate::mesh::FacesRef;
use crate::num::{self, Kernel, Product};
use rayon::prelude::*;

/// Faces walked at a time.
pub(crate) const BLOCK_FACES: usize = 1024;
/// log2 of the slots in a chunk.
const CHUNK_BITS: usize = 10;
/// Slots in a chunk.
pub(crate) const CHUNK: usize = 1 << CHUNK_BITS;
/// A part's share of blocks is worth a task of its own from here on.
const SMALLEST_SHARE: usize = 8;
/// Parts are bits of a mask.
const MOST_PARTS: usize = 64;
/// Parts for each thread, so that a thread that is held up does not hold up all.
const PARTS_PER_THREAD: usize = 2;
/// One face in this many is looked at to find the owners of chunks.
const SAMPLING: usize = 32;
/// The chunk belongs to another part; no slot of it is in reach.
const ELSEWHERE: u32 = u32::MAX - CHUNK as u32;

/// Who owns and who walks what.
#[derive(Default)]
pub(crate) struct Partition {
    parts: usize,
    blocks: usize,
    /// The part that owns each chunk.
    owners: Vec<u8>,
    /// The parts that each block of faces touches, as bits.
    touched: Vec<u64>,
}

impl Partition {
    /// Shares `slots` slots out, for the threads of the current pool. One thread gets one part, at no cost.
    pub(crate) fn fill(&mut self, faces: FacesRef, target: &[u32], slots: usize) {
        let threads = rayon::current_num_threads();
        self.blocks = faces.len().div_ceil(BLOCK_FACES);
        self.parts = if threads <= 1 {
            1
        } else {
            (threads * PARTS_PER_THREAD).min(MOST_PARTS).min(self.blocks / SMALLEST_SHARE).max(1)
        };
        self.owners.clear();
        self.touched.clear();
        if self.parts == 1 {
            return;
        }
        self.find_owners(faces, target, slots.div_ceil(CHUNK));
        let owners = &self.owners;
        (0..self.blocks)
            .into_par_iter()
            .with_min_len(16)
            .map(|block| {
                let corners = faces.start(block * BLOCK_FACES)..faces.start(end_of(block, faces));
                touched(owners, &target[corners])
            })
            .collect_into_vec(&mut self.touched);
    }

    fn find_owners(&mut self, faces: FacesRef, target: &[u32], chunks: usize) {
        const NOBODY: u8 = u8::MAX;
        self.owners.resize(chunks, NOBODY);
        for face in (0..faces.len()).step_by(SAMPLING) {
            let home = self.home(face / BLOCK_FACES) as u8;
            for &slot in &target[faces.range(face)] {
                if let Some(owner) = self.owners.get_mut(slot as usize >> CHUNK_BITS)
                    && *owner == NOBODY
                {
                    *owner = home;
                }
            }
        }
        for (chunk, owner) in self.owners.iter_mut().enumerate() {
            if *owner == NOBODY {
                *owner = (chunk * self.parts / chunks) as u8;
            }
        }
    }

    /// How many parts there are.
    pub(crate) fn parts(&self) -> usize {
        self.parts
    }

    /// The part that owns a chunk of slots.
    pub(crate) fn owner(&self, chunk: usize) -> usize {
        self.owners.get(chunk).map_or(0, |&owner| usize::from(owner))
    }

    /// The part whose share of the faces a block is, whoever else walks it.
    pub(crate) fn home(&self, block: usize) -> usize {
        block * self.parts / self.blocks.max(1)
    }

    /// The blocks that a part walks, as ranges of faces.
    pub(crate) fn walk(&self, part: usize, faces: FacesRef) -> impl Iterator<Item = (usize, usize)> + '_ {
        let count = faces.len();
        (0..self.blocks)
            .filter(move |&block| self.parts == 1 || self.touched[block] >> part & 1 == 1)
            .map(move |block| (block * BLOCK_FACES, ((block + 1) * BLOCK_FACES).min(count)))
    }

    /// Writes down where each chunk's slots begin among a part's own, and how many those are.
    pub(crate) fn number(&self, part: usize, slots: usize, starts: &mut Vec<u32>) -> usize {
        starts.clear();
        if self.parts == 1 {
            return slots;
        }
        let mut own = 0;
        starts.extend(self.owners.iter().enumerate().map(|(chunk, &owner)| {
            if usize::from(owner) != part {
                return ELSEWHERE;
            }
            let start = own;
            own += CHUNK.min(slots - chunk * CHUNK);
            start as u32
        }));
        own
    }
}

/// Chunks between the lowest and the highest of a block's slots that are all taken as touched.
const MANY_CHUNKS: usize = 64;

/// The parts that own some of these slots, as bits; perhaps a few more where that is quicker to tell.
fn touched(owners: &[u8], slots: &[u32]) -> u64 {
    let bits = |touched: u64, owner: &u8| touched | 1 << owner;
    let (low, high) = num::dispatch(Bounds(slots));
    let chunks = low as usize >> CHUNK_BITS..(high as usize >> CHUNK_BITS) + 1;
    match owners.get(chunks.clone()) {
        Some(owners) if chunks.len() <= MANY_CHUNKS => owners.iter().fold(0, bits),
        _ => slots.iter().filter_map(|&slot| owners.get(slot as usize >> CHUNK_BITS)).fold(0, bits),
    }
}

/// Lowest and highest slot; a kernel so that it is compiled with the widest instructions.
struct Bounds<'a>(&'a [u32]);

impl Kernel for Bounds<'_> {
    type Output = (u32, u32);

    #[inline(always)]
    fn run<P: Product>(self) -> (u32, u32) {
        bounds(self.0)
    }
}

/// Lowest and highest slot.
#[inline(always)]
pub(crate) fn bounds(slots: &[u32]) -> (u32, u32) {
    let (mut low, mut high) = (u32::MAX, 0);
    for &slot in slots {
        low = low.min(slot);
        high = high.max(slot);
    }
    (low, high)
}

fn end_of(block: usize, faces: FacesRef) -> usize {
    ((block + 1) * BLOCK_FACES).min(faces.len())
}

/// How a part numbers its slots.
#[derive(Clone, Copy)]
pub(crate) enum Numbering<'a> {
    /// The only part: as they are.
    Alone,
    /// Chunk after chunk; this is where the slots of each chunk begin.
    Chunked(&'a [u32]),
}

impl Numbering<'_> {
    /// The number of a slot among the part's own; beyond their count for the slots of others and for
    /// [`NONE`](crate::mesh::NONE).
    #[inline(always)]
    pub(crate) fn local(self, slot: u32) -> usize {
        match self {
            Numbering::Alone => slot as usize,
            Numbering::Chunked(starts) => {
                let start = starts.get(slot as usize >> CHUNK_BITS).copied().unwrap_or(ELSEWHERE);
                start as usize + (slot as usize & (CHUNK - 1))
            }
        }
    }
}
