//! Eight lanes in four registers of WebAssembly's SIMD128.

use super::simd128_singles::Simd128Singles;
use super::{Arithmetic, EightLanes, LANES, Lanes, Rows};
use crate::num::lanes::product::{Product, Split};
use pulp::wasm::Simd128 as Token;
use std::arch::wasm32::v128;

/// The machine has SIMD128, which is known when the program is compiled.
#[derive(Clone, Copy)]
pub(crate) struct Simd128 {
    pub(super) token: Token,
}

impl Simd128 {
    pub(crate) fn new() -> Option<Self> {
        Token::try_new().map(|token| Self { token })
    }

    /// Two rows of two numbers as columns.
    #[inline(always)]
    fn pair(self, a: v128, b: v128) -> [v128; 2] {
        let simd = self.token.simd128;
        [simd.i64x2_shuffle::<0, 2>(a, b), simd.i64x2_shuffle::<1, 3>(a, b)]
    }
}

impl Product for Simd128 {
    #[inline(always)]
    fn two_product(a: f64, b: f64) -> (f64, f64) {
        Split::two_product(a, b)
    }
}

/// Methods that are one instruction for each register.
macro_rules! registers {
    ($($method:ident($($number:ident),*) = $instruction:ident),* $(,)?) => {$(
        #[inline(always)]
        fn $method(self, $($number: Self::Number),*) -> Self::Number {
            std::array::from_fn(|i| self.token.simd128.$instruction($($number[i]),*))
        }
    )*};
}

impl Arithmetic for Simd128 {
    type Number = [v128; 4];
    type Mask = [v128; 4];

    #[inline(always)]
    fn splat(self, x: f64) -> [v128; 4] {
        [self.token.simd128.f64x2_splat(x); 4]
    }

    registers! {
        add(a, b) = f64x2_add, sub(a, b) = f64x2_sub, mul(a, b) = f64x2_mul, div(a, b) = f64x2_div, and(a, b) = v128_and,
        less(a, b) = f64x2_lt, sqrt(a) = f64x2_sqrt, abs(a) = f64x2_abs,
    }

    /// By [`Split`], in the same order: SIMD128 has no fused multiply-add with defined rounding.
    #[inline(always)]
    fn product_error(self, a: [v128; 4], b: [v128; 4], product: [v128; 4]) -> [v128; 4] {
        let factor = self.splat(134_217_729.0);
        let split = |a: [v128; 4]| {
            let c = self.mul(factor, a);
            let high = self.sub(c, self.sub(c, a));
            (high, self.sub(a, high))
        };
        let ((ah, al), (bh, bl)) = (split(a), split(b));
        let rest = self.sub(product, self.mul(ah, bh));
        let rest = self.sub(self.sub(rest, self.mul(al, bh)), self.mul(ah, bl));
        self.sub(self.mul(al, bl), rest)
    }

    #[inline(always)]
    fn select(self, mask: [v128; 4], yes: [v128; 4], no: [v128; 4]) -> [v128; 4] {
        std::array::from_fn(|i| self.token.simd128.v128_bitselect(yes[i], no[i], mask[i]))
    }
}

impl EightLanes for Simd128 {
    type Element = f64;

    #[inline(always)]
    fn bits(self, mask: [v128; 4]) -> u8 {
        let simd = self.token.simd128;
        let [a, b, c, d] = mask.map(|mask| simd.i64x2_bitmask(mask));
        a | b << 2 | c << 4 | d << 6
    }

    #[inline(always)]
    fn columns(self, rows: [&[f64; 4]; LANES]) -> [[v128; 4]; 4] {
        let halves = rows.map(|row| pulp::cast::<_, [v128; 2]>(*row));
        let pairs: [[v128; 4]; 4] = std::array::from_fn(|i| {
            let [x, y] = self.pair(halves[2 * i][0], halves[2 * i + 1][0]);
            let [z, w] = self.pair(halves[2 * i][1], halves[2 * i + 1][1]);
            [x, y, z, w]
        });
        std::array::from_fn(|column| pairs.map(|pair| pair[column]))
    }

    #[inline(always)]
    fn rows(self, [a, b, c, d]: [[v128; 4]; 4]) -> Rows<f64> {
        let two_rows = |i: usize| {
            let ([ab, ab_next], [cd, cd_next]) = (self.pair(a[i], b[i]), self.pair(c[i], d[i]));
            [ab, cd, ab_next, cd_next]
        };
        Rows(pulp::cast([two_rows(0), two_rows(1), two_rows(2), two_rows(3)]))
    }

    #[inline(always)]
    fn add_row(self, sum: &mut [f64; 4], row: &[f64; 4]) {
        let simd = self.token.simd128;
        let (own, row): ([v128; 2], [v128; 2]) = (pulp::cast(*sum), pulp::cast(*row));
        *sum = pulp::cast([simd.f64x2_add(own[0], row[0]), simd.f64x2_add(own[1], row[1])]);
    }

    #[inline(always)]
    fn add_scaled_row(self, sum: &mut [f64; 4], row: &[f64; 4], factor: f64) {
        let term = self.scaled_row(row, factor);
        self.add_row(sum, &term);
    }
}

impl Lanes for Simd128 {
    type Singles = Simd128Singles;

    #[inline(always)]
    fn singles(self) -> Simd128Singles {
        Simd128Singles { token: self.token }
    }

    #[inline(always)]
    fn differences(self, found: [v128; 4], a: [v128; 4], b: [v128; 4]) -> [v128; 4] {
        let simd = self.token.simd128;
        std::array::from_fn(|i| simd.v128_or(found[i], simd.v128_xor(a[i], b[i])))
    }

    #[inline(always)]
    fn equal_bits(self, numbers: &[u32; LANES], number: u32) -> u8 {
        let simd = self.token.simd128;
        let wanted = simd.u32x4_splat(number);
        let [low, high] = pulp::cast::<_, [v128; 2]>(*numbers)
            .map(|numbers| simd.i32x4_bitmask(simd.i32x4_eq(numbers, wanted)));
        low | high << 4
    }

    #[inline(always)]
    fn columns_of_singles(self, rows: [&[f32; 4]; LANES]) -> [[v128; 4]; 3] {
        let simd = self.token.simd128;
        let columns = self.singles().columns(rows);
        std::array::from_fn(|column| {
            let [low, high] = columns[column];
            let upper = |half: v128| simd.f64x2_promote_low_f32x4(simd.i64x2_shuffle::<1, 1>(half, half));
            let lower = |half: v128| simd.f64x2_promote_low_f32x4(half);
            [lower(low), upper(low), lower(high), upper(high)]
        })
    }

    #[inline(always)]
    fn scaled_row(self, row: &[f64; 4], factor: f64) -> [f64; 4] {
        let simd = self.token.simd128;
        let factor = simd.f64x2_splat(factor);
        pulp::cast(pulp::cast::<_, [v128; 2]>(*row).map(|half| simd.f64x2_mul(half, factor)))
    }

    #[inline(always)]
    fn scaled_row_of_singles(self, row: &[f64; 4], factor: f64) -> [f32; 4] {
        let simd = self.token.simd128;
        let [low, high] = pulp::cast::<_, [v128; 2]>(self.scaled_row(row, factor))
            .map(|half| simd.f32x4_demote_f64x2_zero(half));
        pulp::cast(simd.i64x2_shuffle::<0, 2>(low, high))
    }
}
