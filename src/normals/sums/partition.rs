//! Sharing sums out among threads so that no thread count changes a bit.
//!
//! The faces are cut into as many shares as there are *parts*, and each part adds up its share to sums of its own, all
//! slots (vertices or smooth groups) in reach. Then slots are *owned*: the first part owns those up to the highest that it
//! has touched, the next part what it has touched beyond, and so on. What a part has added to the slots of earlier parts
//! is thrown away, and those faces are added once more, to their owner's sums, in ascending order. So every sum runs in
//! ascending face index; and as long as vertices are numbered in about the order of the faces that use them, all parts
//! are busy with slots of their own.

use crate::mesh::FacesRef;
use crate::num::{self, Kernel, Lanes};
use std::ops::Range;

/// Faces that are computed before they are added: enough to fill the pipeline, few enough to stay at hand.
pub(crate) const BLOCK: usize = 64;
/// A share of fewer faces costs more as a task of its own than it saves.
const SMALLEST_SHARE: usize = 8192;

/// Which faces are whose.
#[derive(Clone, Copy)]
pub(crate) struct Partition {
    parts: usize,
    faces: usize,
}

impl Partition {
    /// One part for each thread of the current pool; only one if faces come in no order.
    pub(crate) fn new(faces: FacesRef, target: &[u32]) -> Self {
        let parts = rayon::current_num_threads().min(faces.len() / SMALLEST_SHARE).max(1);
        let shared = Self { parts, faces: faces.len() };
        if shared.ascends(faces, target) { shared } else { Self { parts: 1, ..shared } }
    }

    /// Whether most slots that a share begins with lie beyond those that the share before it begins with.
    fn ascends(self, faces: FacesRef, target: &[u32]) -> bool {
        let beginning = |part: usize| {
            let first = self.share(part).start;
            &target[faces.start(first)..faces.start((first + BLOCK).min(self.faces))]
        };
        (1..self.parts).all(|part| {
            let end = num::dispatch(Reach(beginning(part - 1))).end;
            let slots = beginning(part);
            2 * slots.iter().filter(|&&slot| slot >= end).count() > slots.len()
        })
    }

    /// How many parts there are.
    pub(crate) fn parts(self) -> usize {
        self.parts
    }

    /// The faces that are a part's share: whole blocks, but for the last.
    pub(crate) fn share(self, part: usize) -> Range<usize> {
        let blocks = self.faces.div_ceil(BLOCK);
        let start = |part: usize| (part * blocks / self.parts * BLOCK).min(self.faces);
        start(part)..start(part + 1)
    }
}

/// The slots that a share of faces touches.
#[derive(Default)]
pub(crate) struct Touched {
    /// The lowest slot of each block.
    lowest: Vec<u32>,
    /// Beyond the highest.
    end: u32,
}

impl Touched {
    pub(crate) fn clear(&mut self) {
        self.lowest.clear();
        self.end = 0;
    }

    /// Takes down the slots of the next block.
    pub(crate) fn note(&mut self, slots: &[u32]) {
        let Range { start, end } = num::dispatch(Reach(slots));
        self.lowest.push(start);
        self.end = self.end.max(end);
    }

    pub(crate) fn end(&self) -> usize {
        self.end as usize
    }

    /// Those faces of the share that touch slots below `own`.
    pub(crate) fn outside_range(
        &self,
        share: Range<usize>,
        own: usize,
        faces: FacesRef,
        target: &[u32],
    ) -> Vec<u32> {
        let blocks = share.clone().step_by(BLOCK).zip(&self.lowest);
        blocks
            .filter(|&(_, &lowest)| (lowest as usize) < own)
            .flat_map(|(first, _)| first..(first + BLOCK).min(share.end))
            .filter(|&face| target[faces.range(face)].iter().any(|&slot| (slot as usize) < own))
            .map(|face| face as u32)
            .collect()
    }
}

/// From the lowest of some slots to beyond the highest. [`NONE`](crate::mesh::NONE) is the highest number: it lowers no
/// minimum, and one more is nothing.
struct Reach<'a>(&'a [u32]);

impl Kernel for Reach<'_> {
    type Output = Range<u32>;

    #[inline(always)]
    fn run<A: Lanes>(self, _: A) -> Range<u32> {
        let (mut start, mut end) = (u32::MAX, 0);
        for &slot in self.0 {
            (start, end) = (start.min(slot), end.max(slot.wrapping_add(1)));
        }
        start..end
    }
}

/// Lowest and highest of some slots; a kernel so that it is compiled with the widest instructions.
pub(crate) struct Bounds<'a>(pub(crate) &'a [u32]);

impl Kernel for Bounds<'_> {
    type Output = (u32, u32);

    #[inline(always)]
    fn run<A: Lanes>(self, _: A) -> (u32, u32) {
        self.0.iter().fold((u32::MAX, 0), |(low, high), &slot| (low.min(slot), high.max(slot)))
    }
}
