//! Adding the terms of a block to the sums of its corners.

use crate::normals::sums::partition::BLOCK;
use crate::num::{EightLanes, Kernel, Lanes, Real};

/// What the triangles of a block add to sums.
#[repr(align(64))]
pub(crate) struct BlockTerms<T> {
    /// Each triangle's vector and its length. Where every corner counts by area alone, the latter may be only an upper bound.
    pub(crate) vectors: [[T; 4]; BLOCK],
    /// The weights of each triangle's corners. Where every corner counts the same, nothing.
    pub(crate) weights: [[T; 4]; BLOCK],
}

impl<T: Real> BlockTerms<T> {
    pub(crate) fn zero() -> Self {
        Self { vectors: [[T::ZERO; 4]; BLOCK], weights: [[T::ZERO; 4]; BLOCK] }
    }
}

/// The number of faces of each slot, modulo 256.
#[derive(Default)]
pub(crate) struct FaceCounts {
    of_slots: Vec<u8>,
    /// Whether a slot has 256 faces or more.
    pub(crate) is_exceeded: bool,
}

impl FaceCounts {
    /// No faces yet.
    pub(crate) fn reset(&mut self, slots: usize) {
        self.of_slots.clear();
        self.of_slots.resize(slots, 0);
        self.is_exceeded = false;
    }

    /// The counts of the slots from one on. There are none if nothing is counted.
    pub(crate) fn starting_at(&mut self, first: usize) -> &mut [u8] {
        self.of_slots.get_mut(first..).unwrap_or_default()
    }
}

/// The number type of sums.
pub(crate) trait SumNumber: Real + bytemuck::Pod {
    /// Whether the faces of each sum are counted: the rounding of single precision limits their number.
    const COUNTS_FACES: bool;

    /// sum += row.
    fn add_row<A: Lanes>(arch: A, sum: &mut [Self; 4], row: &[Self; 4]);

    /// sum += factor · row, rounded twice.
    fn add_scaled_row<A: Lanes>(arch: A, sum: &mut [Self; 4], row: &[Self; 4], factor: Self);
}

impl SumNumber for f64 {
    const COUNTS_FACES: bool = false;

    #[inline(always)]
    fn add_row<A: Lanes>(arch: A, sum: &mut [f64; 4], row: &[f64; 4]) {
        arch.add_row(sum, row);
    }

    #[inline(always)]
    fn add_scaled_row<A: Lanes>(arch: A, sum: &mut [f64; 4], row: &[f64; 4], factor: f64) {
        arch.add_scaled_row(sum, row, factor);
    }
}

impl SumNumber for f32 {
    const COUNTS_FACES: bool = true;

    #[inline(always)]
    fn add_row<A: Lanes>(arch: A, sum: &mut [f32; 4], row: &[f32; 4]) {
        arch.singles().add_row(sum, row);
    }

    #[inline(always)]
    fn add_scaled_row<A: Lanes>(arch: A, sum: &mut [f32; 4], row: &[f32; 4], factor: f32) {
        arch.singles().add_scaled_row(sum, row, factor);
    }
}

/// Adds triangles to the sums of their corners, those of slots from the first one on. Other slots are skipped.
pub(crate) struct Scatter<'a, T> {
    pub(crate) terms: &'a BlockTerms<T>,
    /// Whether every corner counts the same.
    pub(crate) is_equal: bool,
    /// The slots of each triangle's corners.
    pub(crate) slots: &'a [[u32; 3]],
    pub(crate) sums: &'a mut [[T; 4]],
    pub(crate) counts: &'a mut [u8],
    pub(crate) first_slot: u32,
}

impl<T: SumNumber> Kernel for Scatter<'_, T> {
    /// Whether a count begins again.
    type Output = bool;

    #[inline(always)]
    fn run<A: Lanes>(self, arch: A) -> bool {
        let Self { terms: BlockTerms { vectors, weights }, is_equal, slots, sums, counts, first_slot } = self;
        // One comparison for both ends: slots before the first one become the highest.
        let at = |slot: u32| slot.wrapping_sub(first_slot) as usize;
        // As long as the sums, so that one comparison is for both.
        let counts = if T::COUNTS_FACES { &mut counts[..sums.len()] } else { counts };
        let mut is_exceeded = false;
        if is_equal {
            for (slots, vector) in slots.iter().zip(vectors) {
                for &slot in slots {
                    let Some(sum) = sums.get_mut(at(slot)) else {
                        skipped();
                        continue;
                    };
                    T::add_row(arch, sum, vector);
                    is_exceeded |= T::COUNTS_FACES && add_to_count(counts, at(slot));
                }
            }
        } else {
            for ((slots, vector), weights) in slots.iter().zip(vectors).zip(weights) {
                for (&slot, &weight) in slots.iter().zip(weights) {
                    let Some(sum) = sums.get_mut(at(slot)) else {
                        skipped();
                        continue;
                    };
                    T::add_scaled_row(arch, sum, vector, weight);
                    is_exceeded |= T::COUNTS_FACES && add_to_count(counts, at(slot));
                }
            }
        }
        is_exceeded
    }
}

/// Counts one more face of a slot, and returns whether the count begins again.
#[inline(always)]
fn add_to_count(counts: &mut [u8], slot: usize) -> bool {
    let Some(count) = counts.get_mut(slot) else { return false };
    *count = count.wrapping_add(1);
    *count == 0
}

/// Marks a path that is rarely taken.
#[cold]
#[inline(always)]
fn skipped() {}
