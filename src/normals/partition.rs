//! Sharing sums out among threads so that no thread count changes a bit.
//!
//! The faces are cut into as many shares as there are *parts*. Slots (vertices or smooth groups) are owned by parts, in
//! chunks, each by the first part in whose share it is touched. A part adds up its share in ascending order, to its own
//! slots only; faces with a corner in an earlier part's slot it writes down. When all shares are done, each part adds
//! what later parts have written down for it, again in ascending order. So every sum runs in ascending face index; and
//! with faces in any sensible order little is written down, whatever the order of vertices is.

use super::finish::Output;
use super::sums::SlotState;
use crate::mesh::FacesRef;
use crate::num::{self, Kernel, Lanes};
use rayon::prelude::*;
use std::ops::Range;

/// Faces walked at a time.
pub(crate) const BLOCK_FACES: usize = 1024;
/// log2 of the slots in a chunk.
const CHUNK_BITS: usize = 9;
/// Slots in a chunk.
pub(crate) const CHUNK: usize = 1 << CHUNK_BITS;
/// A part's share of blocks is worth a task of its own from here on.
const SMALLEST_SHARE: usize = 8;
/// Numbers of parts must fit a byte.
const MOST_PARTS: usize = 128;
/// Parts for each thread, so that a thread that is held up does not hold up all.
const PARTS_PER_THREAD: usize = 2;
/// Up to this many chunks between the lowest and the highest of a block's slots are all taken as touched, without a look
/// at every corner.
const FEW_CHUNKS: usize = 16;

/// The chunk that a slot is in.
#[inline(always)]
pub(crate) fn chunk_of(slot: u32) -> usize {
    slot as usize >> CHUNK_BITS
}

/// The chunk belongs to another part; no slot of it is in reach.
const ELSEWHERE: u32 = u32::MAX - CHUNK as u32;

/// Who adds what, and who owns what.
#[derive(Default)]
pub(crate) struct Partition {
    parts: usize,
    faces: usize,
    /// The part that owns each chunk; nothing where there is one part.
    owners: Vec<u8>,
}

impl Partition {
    /// Shares slots out for the threads of the current pool. With one thread there is one part, at no cost.
    pub(crate) fn fill(&mut self, faces: FacesRef, target: &[u32], slots: usize) {
        let threads = rayon::current_num_threads();
        self.faces = faces.len();
        self.parts = if threads <= 1 {
            1
        } else {
            (threads * PARTS_PER_THREAD).min(MOST_PARTS).min(self.blocks() / SMALLEST_SHARE).max(1)
        };
        self.owners.clear();
        if self.parts == 1 {
            return;
        }
        self.owners = self.find_owners(faces, target, slots.div_ceil(CHUNK));
        // With faces in no order at all the first part owns all, and sharing out is not worth its while.
        let firsts = self.owners.iter().filter(|&&owner| owner == 0).count();
        if 2 * firsts > self.owners.len() + CHUNK / self.parts {
            self.parts = 1;
            self.owners.clear();
        }
    }

    fn find_owners(&self, faces: FacesRef, target: &[u32], chunks: usize) -> Vec<u8> {
        const NOBODY: u8 = u8::MAX;
        let seen_by = |part: usize| {
            let mut seen = vec![NOBODY; chunks];
            for block in self.share(part) {
                let block = self.block(block);
                for_each_run(&target[faces.start(block.start)..faces.start(block.end)], |chunks| {
                    let chunks = existing(chunks, seen.len());
                    seen[chunks].fill(part as u8);
                });
            }
            seen
        };
        let seen: Vec<Vec<u8>> = (0..self.parts).into_par_iter().map(seen_by).collect();
        let owner = |chunk: usize| {
            // `NOBODY` is the highest. What no face touches goes to anyone.
            let first = seen.iter().map(|seen| seen[chunk]).min().filter(|&part| part != NOBODY);
            first.unwrap_or((chunk * self.parts / chunks) as u8)
        };
        (0..chunks).map(owner).collect()
    }

    /// How many parts there are.
    pub(crate) fn parts(&self) -> usize {
        self.parts
    }

    /// How many blocks there are.
    pub(crate) fn blocks(&self) -> usize {
        self.faces.div_ceil(BLOCK_FACES)
    }

    /// The faces of a block.
    pub(crate) fn block(&self, block: usize) -> Range<usize> {
        block * BLOCK_FACES..((block + 1) * BLOCK_FACES).min(self.faces)
    }

    /// The blocks that are a part's share.
    pub(crate) fn share(&self, part: usize) -> Range<usize> {
        part * self.blocks() / self.parts..(part + 1) * self.blocks() / self.parts
    }

    /// The places for the results of each part's slots, ascending.
    pub(crate) fn outputs<'a, O>(
        &self,
        unit: &'a mut [O],
        state: &'a mut [SlotState],
    ) -> Vec<Vec<Output<'a, O>>> {
        let mut outputs: Vec<_> = (0..self.parts).map(|_| Vec::new()).collect();
        for (chunk, (unit, state)) in unit.chunks_mut(CHUNK).zip(state.chunks_mut(CHUNK)).enumerate() {
            outputs[usize::from(self.owners[chunk])].push(Output {
                first: (chunk * CHUNK) as u32,
                unit,
                state,
            });
        }
        outputs
    }

    /// Writes down where each chunk's slots begin among a part's own, and gives how many those are.
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

/// How a part numbers its slots.
#[derive(Clone, Copy)]
pub(crate) enum Numbering<'a> {
    /// The only part: as they are.
    Alone,
    /// Chunk after chunk; this is where the slots of each chunk begin.
    Chunked(&'a [u32]),
}

impl Numbering<'_> {
    /// What to subtract from each slot between these two, if the part owns them all.
    #[inline(always)]
    pub(crate) fn offset(self, (low, high): (u32, u32)) -> Option<u32> {
        let Numbering::Chunked(starts) = self else { return Some(0) };
        let (first, last) = (chunk_of(low), chunk_of(high));
        let (start, end) = (*starts.get(first)?, *starts.get(last)?);
        // Own chunks are numbered without gaps.
        let all_own = start != ELSEWHERE && end.wrapping_sub(start) as usize == (last - first) * CHUNK;
        all_own.then(|| ((first * CHUNK) as u32).wrapping_sub(start))
    }

    /// The number of a slot among the part's own; beyond their count for the slots of others and for
    /// [`NONE`](crate::mesh::NONE).
    #[inline(always)]
    pub(crate) fn local(self, slot: u32) -> usize {
        match self {
            Numbering::Alone => slot as usize,
            Numbering::Chunked(starts) => {
                let start = starts.get(chunk_of(slot)).copied().unwrap_or(ELSEWHERE);
                start as usize + (slot as usize & (CHUNK - 1))
            }
        }
    }
}

/// Calls back with runs of chunks, first and last, that cover all slots of a block: one run if the block's lowest and
/// highest slot are not far apart, else the same for small pieces of it.
fn for_each_run(slots: &[u32], mut visit: impl FnMut((usize, usize))) {
    const PIECE: usize = 48;
    let run = |slots: &[u32]| {
        let (low, high) = num::dispatch(Bounds(slots));
        (chunk_of(low), chunk_of(high))
    };
    let is_short = |(low, high): (usize, usize)| high.saturating_sub(low) < FEW_CHUNKS;
    let whole = run(slots);
    if is_short(whole) {
        return visit(whole);
    }
    for piece in slots.chunks(PIECE) {
        let run = run(piece);
        if is_short(run) {
            visit(run);
        } else {
            piece.iter().for_each(|&slot| visit((chunk_of(slot), chunk_of(slot))));
        }
    }
}

/// Those of some chunks, first and last given, that there are.
fn existing((first, last): (usize, usize), count: usize) -> Range<usize> {
    let end = count.min(last + 1);
    first.min(end)..end
}

/// Lowest and highest of some slots.
#[inline(always)]
pub(crate) fn bounds(slots: &[u32]) -> (u32, u32) {
    slots.iter().fold((u32::MAX, 0), |(low, high), &slot| (low.min(slot), high.max(slot)))
}

/// The same; a kernel so that it is compiled with the widest instructions.
pub(crate) struct Bounds<'a>(pub(crate) &'a [u32]);

impl Kernel for Bounds<'_> {
    type Output = (u32, u32);

    #[inline(always)]
    fn run<A: Lanes>(self, _: A) -> (u32, u32) {
        bounds(self.0)
    }
}
