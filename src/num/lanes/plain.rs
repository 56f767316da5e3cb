//! Arithmetic without any particular instructions.

use super::singles::PlainSingles;
use super::{Arithmetic, LANES, Lanes, Rows};
use crate::num::product::Product;
use std::marker::PhantomData;

/// One number at a time: formulas for lanes, for those who have a single number.
#[derive(Clone, Copy)]
pub(crate) struct OneLane<P>(PhantomData<P>);

impl<P> OneLane<P> {
    pub(crate) fn new() -> Self {
        Self(PhantomData)
    }
}

impl<P: Product> Arithmetic for OneLane<P> {
    type Number = f64;
    type Mask = bool;

    #[inline(always)]
    fn splat(self, x: f64) -> f64 {
        x
    }

    #[inline(always)]
    fn add(self, a: f64, b: f64) -> f64 {
        a + b
    }

    #[inline(always)]
    fn sub(self, a: f64, b: f64) -> f64 {
        a - b
    }

    #[inline(always)]
    fn mul(self, a: f64, b: f64) -> f64 {
        a * b
    }

    #[inline(always)]
    fn div(self, a: f64, b: f64) -> f64 {
        a / b
    }

    #[inline(always)]
    fn sqrt(self, a: f64) -> f64 {
        a.sqrt()
    }

    #[inline(always)]
    fn abs(self, a: f64) -> f64 {
        a.abs()
    }

    #[inline(always)]
    fn product_error(self, a: f64, b: f64, _: f64) -> f64 {
        P::two_product(a, b).1
    }

    #[inline(always)]
    fn less(self, a: f64, b: f64) -> bool {
        a < b
    }

    #[inline(always)]
    fn differences(self, found: f64, a: f64, b: f64) -> f64 {
        f64::from_bits(found.to_bits() | (a.to_bits() ^ b.to_bits()))
    }

    #[inline(always)]
    fn and(self, a: bool, b: bool) -> bool {
        a & b
    }

    #[inline(always)]
    fn select(self, mask: bool, yes: f64, no: f64) -> f64 {
        if mask { yes } else { no }
    }
}

/// Eight lanes as arrays, for CPUs whose vector instructions are not written out here.
#[derive(Clone, Copy)]
pub(crate) struct Plain<P>(OneLane<P>);

impl<P> Plain<P> {
    pub(crate) fn new() -> Self {
        Self(OneLane::new())
    }
}

impl<P: Product> Product for Plain<P> {
    #[inline(always)]
    fn two_product(a: f64, b: f64) -> (f64, f64) {
        P::two_product(a, b)
    }
}

impl<P: Product> Arithmetic for Plain<P> {
    type Number = [f64; LANES];
    type Mask = [bool; LANES];

    #[inline(always)]
    fn splat(self, x: f64) -> Self::Number {
        [x; LANES]
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
    fn differences(self, found: Self::Number, a: Self::Number, b: Self::Number) -> Self::Number {
        P::each(|i| self.0.differences(found[i], a[i], b[i]))
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

impl<P: Product> Lanes for Plain<P> {
    type Singles = PlainSingles;

    #[inline(always)]
    fn singles(self) -> PlainSingles {
        PlainSingles
    }

    #[inline(always)]
    fn lane(row: usize) -> usize {
        row
    }

    #[inline(always)]
    fn to_array(self, a: Self::Number) -> [f64; LANES] {
        a
    }

    #[inline(always)]
    fn bits(self, mask: Self::Mask) -> u8 {
        mask.into_iter().enumerate().fold(0, |bits, (lane, yes)| bits | u8::from(yes) << lane)
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
    fn columns(self, rows: [&[f64; 4]; LANES]) -> [Self::Number; 4] {
        std::array::from_fn(|column| P::each(|i| rows[i][column]))
    }

    #[inline(always)]
    fn rows(self, columns: [Self::Number; 4]) -> Rows {
        Rows(P::each(|i| columns.map(|column| column[i])))
    }

    #[inline(always)]
    fn add_row(self, sum: &mut [f64; 4], row: &[f64; 4]) {
        *sum = std::array::from_fn(|i| sum[i] + row[i]);
    }

    #[inline(always)]
    fn add_scaled_row(self, sum: &mut [f64; 4], row: &[f64; 4], factor: f64) {
        *sum = std::array::from_fn(|i| sum[i] + row[i] * factor);
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
