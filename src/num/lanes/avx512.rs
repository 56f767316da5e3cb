//! Eight lanes in one register of AVX-512.

use super::avx_singles::AvxSingles;
use super::{Arithmetic, Avx2, EightLanes, LANES, Lanes, Rows, instructions};
use crate::num::lanes::product::{Fused, Product};
use pulp::x86::V4;
use std::arch::x86_64::{__m256, __m512d, __m512i, _CMP_LT_OQ};

/// The CPU has AVX-512 (F, VL, BW, CD and DQ).
#[derive(Clone, Copy)]
pub(crate) struct Avx512 {
    token: V4,
    narrower: Avx2,
}

/// Elements of two registers, by halves: the lower two of each half, and the upper two.
const LOWER: [u64; LANES] = [0, 1, 8, 9, 4, 5, 12, 13];
const UPPER: [u64; LANES] = [2, 3, 10, 11, 6, 7, 14, 15];

impl Avx512 {
    pub(crate) fn new() -> Option<Self> {
        V4::try_new().map(|token| Self { token, narrower: Avx2 { token: *token } })
    }

    /// The token that runs code with these instructions.
    pub(crate) fn token(self) -> V4 {
        self.token
    }

    /// Two rows side by side.
    #[inline(always)]
    fn pair_of_singles(self, low: &[f32; 4], high: &[f32; 4]) -> __m256 {
        let low = self.token.avx._mm256_castps128_ps256(pulp::cast(*low));
        self.token.avx._mm256_insertf128_ps::<1>(low, pulp::cast(*high))
    }

    #[inline(always)]
    fn pair(self, low: &[f64; 4], high: &[f64; 4]) -> __m512d {
        let low = self.token.avx512f._mm512_castpd256_pd512(pulp::cast(*low));
        self.token.avx512f._mm512_insertf64x4::<1>(low, pulp::cast(*high))
    }

    /// Two 4×4 matrices, one in the lower and one in the upper halves, transposed.
    #[inline(always)]
    fn transposed(self, [a, b, c, d]: [__m512d; 4]) -> [__m512d; 4] {
        let f = self.token.avx512f;
        let (lower, upper): (__m512i, __m512i) = (pulp::cast(LOWER), pulp::cast(UPPER));
        let (ab_even, ab_odd) = (f._mm512_unpacklo_pd(a, b), f._mm512_unpackhi_pd(a, b));
        let (cd_even, cd_odd) = (f._mm512_unpacklo_pd(c, d), f._mm512_unpackhi_pd(c, d));
        [
            f._mm512_permutex2var_pd(ab_even, lower, cd_even),
            f._mm512_permutex2var_pd(ab_odd, lower, cd_odd),
            f._mm512_permutex2var_pd(ab_even, upper, cd_even),
            f._mm512_permutex2var_pd(ab_odd, upper, cd_odd),
        ]
    }
}

impl Product for Avx512 {
    #[inline(always)]
    fn two_product(a: f64, b: f64) -> (f64, f64) {
        Fused::two_product(a, b)
    }
}

impl Arithmetic for Avx512 {
    type Number = __m512d;
    type Mask = u8;

    #[inline(always)]
    fn splat(self, x: f64) -> __m512d {
        self.token.avx512f._mm512_set1_pd(x)
    }

    instructions! {
        avx512f: add(a, b) = _mm512_add_pd, sub(a, b) = _mm512_sub_pd, mul(a, b) = _mm512_mul_pd,
        div(a, b) = _mm512_div_pd, sqrt(a) = _mm512_sqrt_pd, abs(a) = _mm512_abs_pd,
        min(a, b) = _mm512_min_pd, max(a, b) = _mm512_max_pd,
        product_error(a, b, product) = _mm512_fmsub_pd,
    }

    #[inline(always)]
    fn less(self, a: __m512d, b: __m512d) -> u8 {
        self.token.avx512f._mm512_cmp_pd_mask::<_CMP_LT_OQ>(a, b)
    }

    #[inline(always)]
    fn and(self, a: u8, b: u8) -> u8 {
        a & b
    }

    #[inline(always)]
    fn select(self, mask: u8, yes: __m512d, no: __m512d) -> __m512d {
        self.token.avx512f._mm512_mask_blend_pd(mask, no, yes)
    }
}

impl EightLanes for Avx512 {
    type Element = f64;

    /// Rows 0, 2, 4, 6 and then 1, 3, 5, 7: so transposed registers hold rows that are neighbours in memory.
    #[inline(always)]
    fn lane(row: usize) -> usize {
        row / 2 + row % 2 * 4
    }

    #[inline(always)]
    fn bits(self, mask: u8) -> u8 {
        mask
    }

    #[inline(always)]
    fn columns(self, rows: [&[f64; 4]; LANES]) -> [__m512d; 4] {
        self.transposed([
            self.pair(rows[0], rows[1]),
            self.pair(rows[2], rows[3]),
            self.pair(rows[4], rows[5]),
            self.pair(rows[6], rows[7]),
        ])
    }

    #[inline(always)]
    fn rows(self, columns: [__m512d; 4]) -> Rows<f64> {
        Rows(pulp::cast(self.transposed(columns)))
    }

    #[inline(always)]
    fn add_row(self, sum: &mut [f64; 4], row: &[f64; 4]) {
        self.narrower.add_row(sum, row);
    }

    #[inline(always)]
    fn add_scaled_row(self, sum: &mut [f64; 4], row: &[f64; 4], factor: f64) {
        self.narrower.add_scaled_row(sum, row, factor);
    }
}

impl Lanes for Avx512 {
    type Singles = AvxSingles;

    #[inline(always)]
    fn singles(self) -> AvxSingles {
        self.narrower.singles()
    }

    #[inline(always)]
    fn differences(self, found: __m512d, a: __m512d, b: __m512d) -> __m512d {
        let dq = self.token.avx512dq;
        dq._mm512_or_pd(found, dq._mm512_xor_pd(a, b))
    }

    #[inline(always)]
    fn equal_bits(self, numbers: &[u32; LANES], number: u32) -> u8 {
        self.narrower.equal_bits(numbers, number)
    }

    #[inline(always)]
    fn columns_of_singles(self, rows: [&[f32; 4]; LANES]) -> [__m512d; 3] {
        let (avx, f) = (self.token.avx, self.token.avx512f);
        let a = avx._mm256_castps_pd(self.pair_of_singles(rows[0], rows[1]));
        let b = avx._mm256_castps_pd(self.pair_of_singles(rows[2], rows[3]));
        let c = avx._mm256_castps_pd(self.pair_of_singles(rows[4], rows[5]));
        let d = avx._mm256_castps_pd(self.pair_of_singles(rows[6], rows[7]));
        let [x, y, z] = self.narrower.transposed_singles([a, b, c, d]);
        [f._mm512_cvtps_pd(x), f._mm512_cvtps_pd(y), f._mm512_cvtps_pd(z)]
    }

    #[inline(always)]
    fn scaled_row(self, row: &[f64; 4], factor: f64) -> [f64; 4] {
        self.narrower.scaled_row(row, factor)
    }

    #[inline(always)]
    fn scaled_row_of_singles(self, row: &[f64; 4], factor: f64) -> [f32; 4] {
        self.narrower.scaled_row_of_singles(row, factor)
    }
}
