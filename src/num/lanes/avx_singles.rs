//! Eight lanes of single precision in one register of AVX, for work that trades accuracy for speed.

use super::{Arithmetic, EightLanes, LANES, Rows, instructions};
use pulp::x86::V3;
use std::arch::x86_64::{__m256, _CMP_LT_OQ};

/// The CPU has AVX2 and FMA.
#[derive(Clone, Copy)]
pub(crate) struct AvxSingles {
    pub(super) token: V3,
}

impl AvxSingles {
    /// Two 4×4 matrices, one in the lower and one in the upper halves, transposed.
    #[inline(always)]
    fn transposed(self, [a, b, c, d]: [__m256; 4]) -> [__m256; 4] {
        let avx = self.token.avx;
        let ab_xy = avx._mm256_castps_pd(avx._mm256_unpacklo_ps(a, b));
        let ab_zw = avx._mm256_castps_pd(avx._mm256_unpackhi_ps(a, b));
        let cd_xy = avx._mm256_castps_pd(avx._mm256_unpacklo_ps(c, d));
        let cd_zw = avx._mm256_castps_pd(avx._mm256_unpackhi_ps(c, d));
        [
            avx._mm256_castpd_ps(avx._mm256_unpacklo_pd(ab_xy, cd_xy)),
            avx._mm256_castpd_ps(avx._mm256_unpackhi_pd(ab_xy, cd_xy)),
            avx._mm256_castpd_ps(avx._mm256_unpacklo_pd(ab_zw, cd_zw)),
            avx._mm256_castpd_ps(avx._mm256_unpackhi_pd(ab_zw, cd_zw)),
        ]
    }

    /// Two rows side by side.
    #[inline(always)]
    fn pair(self, low: &[f32; 4], high: &[f32; 4]) -> __m256 {
        let low = self.token.avx._mm256_castps128_ps256(pulp::cast(*low));
        self.token.avx._mm256_insertf128_ps::<1>(low, pulp::cast(*high))
    }
}

impl Arithmetic for AvxSingles {
    type Number = __m256;
    type Mask = __m256;

    #[inline(always)]
    fn splat(self, x: f64) -> __m256 {
        self.token.avx._mm256_set1_ps(x as f32)
    }

    instructions! {
        avx: add(a, b) = _mm256_add_ps, sub(a, b) = _mm256_sub_ps, mul(a, b) = _mm256_mul_ps,
        div(a, b) = _mm256_div_ps, and(a, b) = _mm256_and_ps, sqrt(a) = _mm256_sqrt_ps,
        min(a, b) = _mm256_min_ps, max(a, b) = _mm256_max_ps,
    }

    #[inline(always)]
    fn abs(self, a: __m256) -> __m256 {
        self.token.avx._mm256_andnot_ps(self.token.avx._mm256_set1_ps(-0.0), a)
    }

    #[inline(always)]
    fn product_error(self, _: __m256, _: __m256, _: __m256) -> __m256 {
        self.token.avx._mm256_setzero_ps()
    }

    #[inline(always)]
    fn less(self, a: __m256, b: __m256) -> __m256 {
        self.token.avx._mm256_cmp_ps::<_CMP_LT_OQ>(a, b)
    }

    #[inline(always)]
    fn select(self, mask: __m256, yes: __m256, no: __m256) -> __m256 {
        self.token.avx._mm256_blendv_ps(no, yes, mask)
    }
}

impl EightLanes for AvxSingles {
    type Element = f32;

    #[inline(always)]
    fn columns(self, [a, b, c, d, e, f, g, h]: [&[f32; 4]; LANES]) -> [__m256; 4] {
        self.transposed([self.pair(a, e), self.pair(b, f), self.pair(c, g), self.pair(d, h)])
    }

    #[inline(always)]
    fn rows(self, columns: [__m256; 4]) -> Rows<f32> {
        let avx = self.token.avx;
        let halves = self.transposed(columns);
        let low = halves.map(|half| pulp::cast::<_, [f32; 4]>(avx._mm256_castps256_ps128(half)));
        let high = halves.map(|half| pulp::cast::<_, [f32; 4]>(avx._mm256_extractf128_ps::<1>(half)));
        Rows(pulp::cast([low, high]))
    }

    #[inline(always)]
    fn bits(self, mask: __m256) -> u8 {
        self.token.avx._mm256_movemask_ps(mask) as u8
    }

    #[inline(always)]
    fn add_row(self, sum: &mut [f32; 4], row: &[f32; 4]) {
        *sum = pulp::cast(self.token.sse._mm_add_ps(pulp::cast(*sum), pulp::cast(*row)));
    }

    #[inline(always)]
    fn add_scaled_row(self, sum: &mut [f32; 4], row: &[f32; 4], factor: f32) {
        let sse = self.token.sse;
        let term = sse._mm_mul_ps(pulp::cast(*row), sse._mm_set1_ps(factor));
        *sum = pulp::cast(sse._mm_add_ps(pulp::cast(*sum), term));
    }

    #[inline(always)]
    fn add_bounded_row(self, sum: &mut [f32; 4], row: &[f32; 4], factor: f32, least: f32) {
        let sse = self.token.sse;
        let none = f32::NEG_INFINITY;
        let term = sse._mm_mul_ps(pulp::cast(*row), sse._mm_set1_ps(factor));
        let term = sse._mm_max_ps(term, pulp::cast([none, none, none, least]));
        *sum = pulp::cast(sse._mm_add_ps(pulp::cast(*sum), term));
    }
}
