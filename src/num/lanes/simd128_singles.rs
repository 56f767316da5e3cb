//! Eight lanes of single precision in two registers of WebAssembly's SIMD128.

use super::{Arithmetic, EightLanes, LANES, Rows};
use pulp::wasm::Simd128 as Token;
use std::arch::wasm32::v128;

/// The machine has SIMD128.
#[derive(Clone, Copy)]
pub(crate) struct Simd128Singles {
    pub(super) token: Token,
}

impl Simd128Singles {
    /// A 4×4 matrix transposed.
    #[inline(always)]
    fn transposed(self, [a, b, c, d]: [v128; 4]) -> [v128; 4] {
        let simd = self.token.simd128;
        let (ab_low, ab_high) =
            (simd.i32x4_shuffle::<0, 4, 1, 5>(a, b), simd.i32x4_shuffle::<2, 6, 3, 7>(a, b));
        let (cd_low, cd_high) =
            (simd.i32x4_shuffle::<0, 4, 1, 5>(c, d), simd.i32x4_shuffle::<2, 6, 3, 7>(c, d));
        [
            simd.i64x2_shuffle::<0, 2>(ab_low, cd_low),
            simd.i64x2_shuffle::<1, 3>(ab_low, cd_low),
            simd.i64x2_shuffle::<0, 2>(ab_high, cd_high),
            simd.i64x2_shuffle::<1, 3>(ab_high, cd_high),
        ]
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

impl Arithmetic for Simd128Singles {
    type Number = [v128; 2];
    type Mask = [v128; 2];

    #[inline(always)]
    fn splat(self, x: f64) -> [v128; 2] {
        [self.token.simd128.f32x4_splat(x as f32); 2]
    }

    registers! {
        add(a, b) = f32x4_add, sub(a, b) = f32x4_sub, mul(a, b) = f32x4_mul, div(a, b) = f32x4_div, and(a, b) = v128_and,
        less(a, b) = f32x4_lt, sqrt(a) = f32x4_sqrt, abs(a) = f32x4_abs,
    }

    #[inline(always)]
    fn product_error(self, _: [v128; 2], _: [v128; 2], _: [v128; 2]) -> [v128; 2] {
        self.splat(0.0)
    }

    #[inline(always)]
    fn select(self, mask: [v128; 2], yes: [v128; 2], no: [v128; 2]) -> [v128; 2] {
        std::array::from_fn(|i| self.token.simd128.v128_bitselect(yes[i], no[i], mask[i]))
    }
}

impl EightLanes for Simd128Singles {
    type Element = f32;

    #[inline(always)]
    fn bits(self, mask: [v128; 2]) -> u8 {
        let [low, high] = mask.map(|mask| self.token.simd128.i32x4_bitmask(mask));
        low | high << 4
    }

    #[inline(always)]
    fn columns(self, rows: [&[f32; 4]; LANES]) -> [[v128; 2]; 4] {
        let [a, b, c, d, e, f, g, h] = rows.map(|row| pulp::cast::<_, v128>(*row));
        let (low, high) = (self.transposed([a, b, c, d]), self.transposed([e, f, g, h]));
        std::array::from_fn(|column| [low[column], high[column]])
    }

    #[inline(always)]
    fn rows(self, [a, b, c, d]: [[v128; 2]; 4]) -> Rows<f32> {
        let half = |i: usize| self.transposed([a[i], b[i], c[i], d[i]]);
        Rows(pulp::cast([half(0), half(1)]))
    }

    #[inline(always)]
    fn add_row(self, sum: &mut [f32; 4], row: &[f32; 4]) {
        *sum = pulp::cast(self.token.simd128.f32x4_add(pulp::cast(*sum), pulp::cast(*row)));
    }

    #[inline(always)]
    fn add_scaled_row(self, sum: &mut [f32; 4], row: &[f32; 4], factor: f32) {
        let simd = self.token.simd128;
        let term = simd.f32x4_mul(pulp::cast(*row), simd.f32x4_splat(factor));
        *sum = pulp::cast(simd.f32x4_add(pulp::cast(*sum), term));
    }

    #[inline(always)]
    fn add_bounded_row(self, sum: &mut [f32; 4], row: &[f32; 4], factor: f32, least: f32) {
        let simd = self.token.simd128;
        let none = f32::NEG_INFINITY;
        let term = simd.f32x4_mul(pulp::cast(*row), simd.f32x4_splat(factor));
        let term = simd.f32x4_max(term, pulp::cast([none, none, none, least]));
        *sum = pulp::cast(simd.f32x4_add(pulp::cast(*sum), term));
    }
}
