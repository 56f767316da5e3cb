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

/// The number type of sums.
pub(crate) trait SumNumber: Real + bytemuck::Pod {
    /// sum += row.
    fn add_row<A: Lanes>(arch: A, sum: &mut [Self; 4], row: &[Self; 4]);

    /// sum += factor · row, rounded twice. In single precision the weight of the term is at least `least`.
    fn add_scaled_row<A: Lanes>(arch: A, sum: &mut [Self; 4], row: &[Self; 4], factor: Self, least: Self);
}

impl SumNumber for f64 {
    #[inline(always)]
    fn add_row<A: Lanes>(arch: A, sum: &mut [f64; 4], row: &[f64; 4]) {
        arch.add_row(sum, row);
    }

    #[inline(always)]
    fn add_scaled_row<A: Lanes>(arch: A, sum: &mut [f64; 4], row: &[f64; 4], factor: f64, _: f64) {
        arch.add_scaled_row(sum, row, factor);
    }
}

impl SumNumber for f32 {
    #[inline(always)]
    fn add_row<A: Lanes>(arch: A, sum: &mut [f32; 4], row: &[f32; 4]) {
        arch.singles().add_row(sum, row);
    }

    #[inline(always)]
    fn add_scaled_row<A: Lanes>(arch: A, sum: &mut [f32; 4], row: &[f32; 4], factor: f32, least: f32) {
        arch.singles().add_bounded_row(sum, row, factor, least);
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
    pub(crate) first_slot: u32,
    /// Least weight of a term in single precision, where corners count differently.
    pub(crate) least_weight: T,
}

impl<T: SumNumber> Kernel for Scatter<'_, T> {
    type Output = ();

    #[inline(always)]
    fn run<A: Lanes>(self, arch: A) {
        let Self { terms: BlockTerms { vectors, weights }, is_equal, slots, sums, first_slot, least_weight } =
            self;
        // One comparison for both ends: slots before the first one become the highest.
        let at = |slot: u32| slot.wrapping_sub(first_slot) as usize;
        if is_equal {
            for (slots, vector) in slots.iter().zip(vectors) {
                for &slot in slots {
                    match sums.get_mut(at(slot)) {
                        Some(sum) => T::add_row(arch, sum, vector),
                        None => skipped(),
                    }
                }
            }
        } else {
            for ((slots, vector), weights) in slots.iter().zip(vectors).zip(weights) {
                for (&slot, &weight) in slots.iter().zip(weights) {
                    match sums.get_mut(at(slot)) {
                        Some(sum) => T::add_scaled_row(arch, sum, vector, weight, least_weight),
                        None => skipped(),
                    }
                }
            }
        }
    }
}

/// Marks a path that is rarely taken.
#[cold]
#[inline(always)]
fn skipped() {}
