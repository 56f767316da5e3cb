//! Arithmetic without any particular instructions.

use super::{Arithmetic, EightLanes, LANES, Lanes, Rows};
use crate::num::lanes::product::{Product, Uncorrected};
use crate::num::real::Real;
use std::marker::PhantomData;

/// Lanes as arrays: eight for CPUs whose vector instructions are not written out here, one for those who have a single number.
#[derive(Clone, Copy)]
pub(crate) struct Plain<R, P, const N: usize = LANES>(PhantomData<(R, P)>);

/// A single number, for formulas without cross products.
pub(crate) type OneLane = Plain<f64, Uncorrected, 1>;

impl<R, P, const N: usize> Plain<R, P, N> {
    pub(crate) fn new() -> Self {
        Self(PhantomData)
    }
}

impl<P: Product> Product for Plain<f64, P> {
    #[inline(always)]
    fn two_product(a: f64, b: f64) -> (f64, f64) {
        P::two_product(a, b)
    }
}

impl<R: Real, P: Product<R>, const N: usize> Arithmetic for Plain<R, P, N> {
    type Number = [R; N];
    type Mask = [bool; N];

    #[inline(always)]
    fn splat(self, x: f64) -> Self::Number {
        [R::of(x); N]
    }

    #[inline(always)]
    fn add(self, a: Self::Number, b: Self::Number) -> Self::Number {
        P::each(|i| a[i] + b[i])
    }

    #[inline(always)]
    fn sub(self, a: Self::Number, b: Self::Number) -> Self::Number {
        P::each(|i| a[i] - b[i])
    }

    #[inline(always)]
    fn mul(self, a: Self::Number, b: Self::Number) -> Self::Number {
        P::each(|i| a[i] * b[i])
    }

    #[inline(always)]
    fn div(self, a: Self::Number, b: Self::Number) -> Self::Number {
        P::each(|i| a[i] / b[i])
    }

    #[inline(always)]
    fn sqrt(self, a: Self::Number) -> Self::Number {
        P::each(|i| a[i].sqrt())
    }

    #[inline(always)]
    fn abs(self, a: Self::Number) -> Self::Number {
        P::each(|i| a[i].abs())
    }

    #[inline(always)]
    fn product_error(self, a: Self::Number, b: Self::Number, _: Self::Number) -> Self::Number {
        P::each(|i| P::two_product(a[i], b[i]).1)
    }

    #[inline(always)]
    fn less(self, a: Self::Number, b: Self::Number) -> Self::Mask {
        P::each(|i| a[i] < b[i])
    }

    #[inline(always)]
    fn and(self, a: Self::Mask, b: Self::Mask) -> Self::Mask {
        P::each(|i| a[i] & b[i])
    }

    #[inline(always)]
    fn select(self, mask: Self::Mask, yes: Self::Number, no: Self::Number) -> Self::Number {
        P::each(|i| if mask[i] { yes[i] } else { no[i] })
    }
}

impl<R: Real, P: Product<R>> EightLanes for Plain<R, P> {
    type Element = R;

    #[inline(always)]
    fn bits(self, mask: Self::Mask) -> u8 {
        mask.into_iter().enumerate().fold(0, |bits, (lane, yes)| bits | u8::from(yes) << lane)
    }

    #[inline(always)]
    fn columns(self, rows: [&[R; 4]; LANES]) -> [Self::Number; 4] {
        std::array::from_fn(|column| P::each(|i| rows[i][column]))
    }

    #[inline(always)]
    fn rows(self, columns: [Self::Number; 4]) -> Rows<R> {
        Rows(P::each(|i| columns.map(|column| column[i])))
    }

    #[inline(always)]
    fn add_row(self, sum: &mut [R; 4], row: &[R; 4]) {
        *sum = std::array::from_fn(|i| sum[i] + row[i]);
    }

    #[inline(always)]
    fn add_scaled_row(self, sum: &mut [R; 4], row: &[R; 4], factor: R) {
        *sum = std::array::from_fn(|i| sum[i] + row[i] * factor);
    }
}

impl<P: Product> Lanes for Plain<f64, P> {
    type Singles = Plain<f32, Uncorrected>;

    #[inline(always)]
    fn singles(self) -> Self::Singles {
        Plain::new()
    }

    #[inline(always)]
    fn differences(self, found: Self::Number, a: Self::Number, b: Self::Number) -> Self::Number {
        P::each(|i| f64::from_bits(found[i].to_bits() | (a[i].to_bits() ^ b[i].to_bits())))
    }

    #[inline(always)]
    fn equal_bits(self, numbers: &[u32; LANES], number: u32) -> u8 {
        let bit = |(place, &x): (usize, &u32)| u8::from(x == number) << place;
        numbers.iter().enumerate().map(bit).sum()
    }

    #[inline(always)]
    fn columns_of_singles(self, rows: [&[f32; 4]; LANES]) -> [Self::Number; 3] {
        std::array::from_fn(|column| P::each(|i| f64::from(rows[i][column])))
    }

    #[inline(always)]
    fn scaled_row(self, row: &[f64; 4], factor: f64) -> [f64; 4] {
        row.map(|x| x * factor)
    }

    #[inline(always)]
    fn scaled_row_of_singles(self, row: &[f64; 4], factor: f64) -> [f32; 4] {
        row.map(|x| (x * factor) as f32)
    }
}
