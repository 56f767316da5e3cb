//! Eight lanes in two registers of AVX.

use super::avx_singles::AvxSingles;
use super::{Arithmetic, EightLanes, LANES, Lanes, Rows};
use crate::num::lanes::product::{Fused, Product};
use pulp::x86::V3;
use std::arch::x86_64::{__m256, __m256d, _CMP_LT_OQ};

/// The CPU has AVX2 and FMA.
#[derive(Clone, Copy)]
pub(crate) struct Avx2 {
    pub(super) token: V3,
}

impl Avx2 {
    pub(crate) fn new() -> Option<Self> {
        V3::try_new().map(|token| Self { token })
    }

    /// The token that runs code with these instructions.
    pub(crate) fn token(self) -> V3 {
        self.token
    }

    /// Two 4×4 matrices of single precision, one in the lower and one in the upper halves, transposed; without the
    /// last column.
    #[inline(always)]
    pub(super) fn transposed_singles(self, [a, b, c, d]: [__m256d; 4]) -> [__m256; 3] {
        let avx = self.token.avx;
        let (a, b) = (avx._mm256_castpd_ps(a), avx._mm256_castpd_ps(b));
        let (c, d) = (avx._mm256_castpd_ps(c), avx._mm256_castpd_ps(d));
        let ab_xy = avx._mm256_castps_pd(avx._mm256_unpacklo_ps(a, b));
        let cd_xy = avx._mm256_castps_pd(avx._mm256_unpacklo_ps(c, d));
        let ab_z = avx._mm256_castps_pd(avx._mm256_unpackhi_ps(a, b));
        let cd_z = avx._mm256_castps_pd(avx._mm256_unpackhi_ps(c, d));
        [
            avx._mm256_castpd_ps(avx._mm256_unpacklo_pd(ab_xy, cd_xy)),
            avx._mm256_castpd_ps(avx._mm256_unpackhi_pd(ab_xy, cd_xy)),
            avx._mm256_castpd_ps(avx._mm256_unpacklo_pd(ab_z, cd_z)),
        ]
    }

    /// A 4×4 matrix transposed.
    #[inline(always)]
    fn transposed(self, [a, b, c, d]: [__m256d; 4]) -> [__m256d; 4] {
        let avx = self.token.avx;
        let (ab_even, ab_odd) = (avx._mm256_unpacklo_pd(a, b), avx._mm256_unpackhi_pd(a, b));
        let (cd_even, cd_odd) = (avx._mm256_unpacklo_pd(c, d), avx._mm256_unpackhi_pd(c, d));
        [
            avx._mm256_permute2f128_pd::<0x20>(ab_even, cd_even),
            avx._mm256_permute2f128_pd::<0x20>(ab_odd, cd_odd),
            avx._mm256_permute2f128_pd::<0x31>(ab_even, cd_even),
            avx._mm256_permute2f128_pd::<0x31>(ab_odd, cd_odd),
        ]
    }

    /// Rows `first` and `first` + 4 side by side.
    #[inline(always)]
    fn pair_of_singles(self, rows: &[&[f32; 4]; LANES], first: usize) -> __m256d {
        let avx = self.token.avx;
        let low = avx._mm256_castps128_ps256(pulp::cast(*rows[first]));
        avx._mm256_castps_pd(avx._mm256_insertf128_ps::<1>(low, pulp::cast(*rows[first + 4])))
    }

    /// All eight in double precision.
    #[inline(always)]
    fn widened(self, singles: __m256) -> [__m256d; 2] {
        let avx = self.token.avx;
        let (low, high) = (avx._mm256_castps256_ps128(singles), avx._mm256_extractf128_ps::<1>(singles));
        [avx._mm256_cvtps_pd(low), avx._mm256_cvtps_pd(high)]
    }
}

impl Product for Avx2 {
    #[inline(always)]
    fn two_product(a: f64, b: f64) -> (f64, f64) {
        Fused::two_product(a, b)
    }
}

/// Methods that are one instruction for each half.
macro_rules! halves {
    ($set:ident: $($method:ident($($number:ident),*) = $instruction:ident),* $(,)?) => {$(
        #[inline(always)]
        fn $method(self, $($number: Self::Number),*) -> Self::Number {
            [self.token.$set.$instruction($($number[0]),*), self.token.$set.$instruction($($number[1]),*)]
        }
    )*};
}

impl Arithmetic for Avx2 {
    type Number = [__m256d; 2];
    type Mask = [__m256d; 2];

    #[inline(always)]
    fn splat(self, x: f64) -> [__m256d; 2] {
        [self.token.avx._mm256_set1_pd(x); 2]
    }

    halves! {
        avx: add(a, b) = _mm256_add_pd, sub(a, b) = _mm256_sub_pd, mul(a, b) = _mm256_mul_pd,
        div(a, b) = _mm256_div_pd, and(a, b) = _mm256_and_pd, sqrt(a) = _mm256_sqrt_pd,
        min(a, b) = _mm256_min_pd, max(a, b) = _mm256_max_pd,
    }
    halves! { fma: product_error(a, b, product) = _mm256_fmsub_pd }

    #[inline(always)]
    fn abs(self, a: [__m256d; 2]) -> [__m256d; 2] {
        let sign = self.token.avx._mm256_set1_pd(-0.0);
        [self.token.avx._mm256_andnot_pd(sign, a[0]), self.token.avx._mm256_andnot_pd(sign, a[1])]
    }

    #[inline(always)]
    fn less(self, a: [__m256d; 2], b: [__m256d; 2]) -> [__m256d; 2] {
        let avx = self.token.avx;
        [avx._mm256_cmp_pd::<_CMP_LT_OQ>(a[0], b[0]), avx._mm256_cmp_pd::<_CMP_LT_OQ>(a[1], b[1])]
    }

    #[inline(always)]
    fn select(self, mask: [__m256d; 2], yes: [__m256d; 2], no: [__m256d; 2]) -> [__m256d; 2] {
        let avx = self.token.avx;
        [avx._mm256_blendv_pd(no[0], yes[0], mask[0]), avx._mm256_blendv_pd(no[1], yes[1], mask[1])]
    }
}

impl EightLanes for Avx2 {
    type Element = f64;

    #[inline(always)]
    fn bits(self, mask: [__m256d; 2]) -> u8 {
        let avx = self.token.avx;
        (avx._mm256_movemask_pd(mask[0]) | avx._mm256_movemask_pd(mask[1]) << 4) as u8
    }

    #[inline(always)]
    fn columns(self, [a, b, c, d, e, f, g, h]: [&[f64; 4]; LANES]) -> [[__m256d; 2]; 4] {
        let low = self.transposed([pulp::cast(*a), pulp::cast(*b), pulp::cast(*c), pulp::cast(*d)]);
        let high = self.transposed([pulp::cast(*e), pulp::cast(*f), pulp::cast(*g), pulp::cast(*h)]);
        [[low[0], high[0]], [low[1], high[1]], [low[2], high[2]], [low[3], high[3]]]
    }

    #[inline(always)]
    fn rows(self, [a, b, c, d]: [[__m256d; 2]; 4]) -> Rows<f64> {
        let low = self.transposed([a[0], b[0], c[0], d[0]]);
        let high = self.transposed([a[1], b[1], c[1], d[1]]);
        Rows(pulp::cast([low, high]))
    }

    #[inline(always)]
    fn add_row(self, sum: &mut [f64; 4], row: &[f64; 4]) {
        *sum = pulp::cast(self.token.avx._mm256_add_pd(pulp::cast(*sum), pulp::cast(*row)));
    }

    #[inline(always)]
    fn add_scaled_row(self, sum: &mut [f64; 4], row: &[f64; 4], factor: f64) {
        let avx = self.token.avx;
        let term = avx._mm256_mul_pd(pulp::cast(*row), avx._mm256_set1_pd(factor));
        *sum = pulp::cast(avx._mm256_add_pd(pulp::cast(*sum), term));
    }
}

impl Lanes for Avx2 {
    type Singles = AvxSingles;

    #[inline(always)]
    fn singles(self) -> AvxSingles {
        AvxSingles { token: self.token }
    }

    #[inline(always)]
    fn differences(self, found: [__m256d; 2], a: [__m256d; 2], b: [__m256d; 2]) -> [__m256d; 2] {
        let avx = self.token.avx;
        [
            avx._mm256_or_pd(found[0], avx._mm256_xor_pd(a[0], b[0])),
            avx._mm256_or_pd(found[1], avx._mm256_xor_pd(a[1], b[1])),
        ]
    }

    #[inline(always)]
    fn equal_bits(self, numbers: &[u32; LANES], number: u32) -> u8 {
        let (avx, avx2) = (self.token.avx, self.token.avx2);
        let equal = avx2._mm256_cmpeq_epi32(pulp::cast(*numbers), avx._mm256_set1_epi32(number as i32));
        avx._mm256_movemask_ps(avx._mm256_castsi256_ps(equal)) as u8
    }

    #[inline(always)]
    fn columns_of_singles(self, rows: [&[f32; 4]; LANES]) -> [[__m256d; 2]; 3] {
        let [x, y, z] = self.transposed_singles([
            self.pair_of_singles(&rows, 0),
            self.pair_of_singles(&rows, 1),
            self.pair_of_singles(&rows, 2),
            self.pair_of_singles(&rows, 3),
        ]);
        [self.widened(x), self.widened(y), self.widened(z)]
    }

    #[inline(always)]
    fn scaled_row(self, row: &[f64; 4], factor: f64) -> [f64; 4] {
        let avx = self.token.avx;
        pulp::cast(avx._mm256_mul_pd(pulp::cast(*row), avx._mm256_set1_pd(factor)))
    }

    #[inline(always)]
    fn scaled_row_of_singles(self, row: &[f64; 4], factor: f64) -> [f32; 4] {
        let avx = self.token.avx;
        let scaled = avx._mm256_mul_pd(pulp::cast(*row), avx._mm256_set1_pd(factor));
        pulp::cast(avx._mm256_cvtpd_ps(scaled))
    }
}
