//! The record that each pixel of a tile shows.

use crate::num::{self, Kernel, Lanes};
use crate::raster::coverage::visible_triangle::{BLOCKS, LANES, NOTHING, PIXELS};
use std::ops::Range;

/// The visible owners of a tile's pixels, numbered through; keeps its memory.
pub(crate) struct Shown {
    /// The number of the record that each pixel shows, or [`NOTHING`].
    pub(crate) records: Box<[u32; PIXELS]>,
    /// The owner of each record, ascending.
    pub(crate) owners: Vec<u32>,
    /// The record of each owner, [`NOTHING`] for those that are not visible; and one place more, for no owner.
    record_of: Vec<u32>,
}

/// A block of 4 × 4 pixels of a tile, and which of these show an object, a bit each.
#[derive(Clone, Copy, Debug, Default)]
pub(crate) struct Block {
    pub(crate) number: u16,
    pub(crate) lanes: u16,
}

impl Block {
    /// The number of its first pixel in the tile.
    #[inline(always)]
    pub(crate) fn start(self) -> usize {
        usize::from(self.number) % (PIXELS / LANES) * LANES
    }

    /// The lane itself if it shows the object, else the first that does.
    #[inline(always)]
    pub(crate) fn lane_or_first(self, lane: usize) -> usize {
        if self.lanes >> lane & 1 == 1 { lane } else { self.lanes.trailing_zeros() as usize % LANES }
    }

    #[inline(always)]
    pub(crate) fn is_full(self) -> bool {
        self.lanes == u16::MAX
    }

    /// The lanes that show the object.
    pub(crate) fn shown(self) -> impl Iterator<Item = usize> {
        (0..LANES).filter(move |lane| self.lanes >> lane & 1 == 1)
    }
}

impl Shown {
    pub(crate) fn new() -> Self {
        Self { records: Box::new([NOTHING; PIXELS]), owners: Vec::new(), record_of: Vec::new() }
    }

    /// Numbers those of so many owners that a pixel shows.
    pub(crate) fn number(&mut self, owner_of: &[u32; PIXELS], count: usize) {
        num::dispatch(NumberOwners { owner_of, count, shown: self });
    }

    /// The blocks that show some of these records.
    pub(crate) fn blocks(&self, records: Range<usize>, blocks: &mut Vec<Block>) {
        num::dispatch(FindBlocks { shown: &self.records, records, blocks });
    }
}

/// First all owners are marked, then marked ones are numbered, then pixels take the numbers, without branches that a predictor
/// cannot foresee in a dense mesh.
struct NumberOwners<'a> {
    owner_of: &'a [u32; PIXELS],
    count: usize,
    shown: &'a mut Shown,
}

impl Kernel for NumberOwners<'_> {
    type Output = ();

    #[inline(always)]
    fn run<A: Lanes>(self, _: A) {
        let Self { owner_of, count, shown: Shown { records, owners, record_of } } = self;
        record_of.clear();
        record_of.resize(count + 1, NOTHING);
        owners.clear();
        owners.resize(count + 1, 0);
        let record_of = &mut record_of[..];
        let last = record_of.len() - 1;
        for &owner in owner_of {
            record_of[(owner as usize).min(last)] = 0;
        }
        let mut visible = 0;
        for (owner, record) in record_of[..last].iter_mut().enumerate() {
            owners[visible] = owner as u32;
            let is_seen = *record == 0;
            *record = visible as u32;
            visible += usize::from(is_seen);
        }
        owners.truncate(visible);
        record_of[last] = NOTHING;
        for (record, &owner) in records.iter_mut().zip(owner_of) {
            *record = record_of[(owner as usize).min(last)];
        }
    }
}

struct FindBlocks<'a> {
    shown: &'a [u32; PIXELS],
    records: Range<usize>,
    blocks: &'a mut Vec<Block>,
}

impl Kernel for FindBlocks<'_> {
    type Output = ();

    #[inline(always)]
    fn run<A: Lanes>(self, _: A) {
        let Self { shown, records, blocks } = self;
        let (start, count) = (records.start as u32, records.len() as u32);
        blocks.clear();
        blocks.resize(BLOCKS * BLOCKS + 1, Block::default());
        let mut found = 0;
        for (number, shown) in shown.as_chunks::<LANES>().0.iter().enumerate() {
            let mut bits = [0; LANES];
            for lane in 0..LANES {
                bits[lane] = u32::from(shown[lane].wrapping_sub(start) < count) << lane;
            }
            let lanes = bits.iter().fold(0, |lanes, bit| lanes | bit) as u16;
            blocks[found] = Block { number: number as u16, lanes };
            found += usize::from(lanes != 0);
        }
        blocks.truncate(found);
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn visible_owners_are_numbered_in_order() {
        let mut owner_of = [NOTHING; PIXELS];
        for (pixel, owner) in [(3, 5), (4, 2), (5, 5), (LANES * 7, 9), (PIXELS - 1, 0)] {
            owner_of[pixel] = owner;
        }
        let mut shown = Shown::new();
        for _ in 0..2 {
            shown.number(&owner_of, 10);
            assert_eq!(shown.owners, [0, 2, 5, 9]);
            let of = [3, 4, 5, LANES * 7, PIXELS - 1, 0].map(|pixel| shown.records[pixel]);
            assert_eq!(of, [2, 1, 2, 3, 0, NOTHING]);
        }
        let mut blocks = Vec::new();
        shown.blocks(1..3, &mut blocks);
        assert_eq!(
            blocks.iter().map(|block| (block.number, block.lanes)).collect::<Vec<_>>(),
            [(0, 0b11_1000)]
        );
        assert_eq!([2, 3, 4, 9].map(|lane| blocks[0].lane_or_first(lane)), [3, 3, 4, 3]);
        shown.blocks(0..4, &mut blocks);
        assert_eq!(blocks.iter().map(|block| block.number).collect::<Vec<_>>(), [0, 7, 255]);
        assert_eq!(blocks[2].shown().collect::<Vec<_>>(), [LANES - 1]);
    }
}
