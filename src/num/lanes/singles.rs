//! Eight numbers of single precision, for work that trades accuracy for speed.

use super::{Arithmetic, LANES};
#[cfg(target_arch = "x86_64")]
use pulp::x86::V3;
#[cfg(target_arch = "x86_64")]
use std::arch::x86_64::{__m256, _CMP_LT_OQ};

/// Eight lanes of single precision, and the way between them and rows in memory. Products have no error term: formulas that
/// correct for it lose the correction, nothing else.
pub(crate) trait SingleLanes: Arithmetic {
    /// The first three columns of eight rows.
    fn columns(self, rows: [&[f32; 4]; LANES]) -> [Self::Number; 3];
    /// Columns as rows.
    fn rows(self, columns: [Self::Number; 4]) -> [[f32; 4]; LANES];
    /// Whether the mask is set in every lane.
    fn all(self, mask: Self::Mask) -> bool;
    /// The numbers of all lanes.
    fn to_array(self, a: Self::Number) -> [f32; LANES];
    /// sum += row.
    fn add_row(self, sum: &mut [f32; 4], row: &[f32; 4]);
    /// sum += factor · row, rounded twice.
    fn add_scaled_row(self, sum: &mut [f32; 4], row: &[f32; 4], factor: f32);
    /// The fourth column of eight rows.
    fn last_column(self, rows: [&[f32; 4]; LANES]) -> Self::Number;
}

/// Lanes as arrays.
#[derive(Clone, Copy)]
pub(crate) struct PlainSingles;

fn each<T>(lane: impl Fn(usize) -> T) -> [T; LANES] {
    std::array::from_fn(lane)
}

impl Arithmetic for PlainSingles {
    type Number = [f32; LANES];
    type Mask = [bool; LANES];

    fn splat(self, x: f64) -> Self::Number {
        [x as f32; LANES]
    }

    fn add(self, a: Self::Number, b: Self::Number) -> Self::Number {
        each(|i| a[i] + b[i])
    }

    fn sub(self, a: Self::Number, b: Self::Number) -> Self::Number {
        each(|i| a[i] - b[i])
    }

    fn mul(self, a: Self::Number, b: Self::Number) -> Self::Number {
        each(|i| a[i] * b[i])
    }

    fn div(self, a: Self::Number, b: Self::Number) -> Self::Number {
        each(|i| a[i] / b[i])
    }

    fn sqrt(self, a: Self::Number) -> Self::Number {
        each(|i| a[i].sqrt())
    }

    fn abs(self, a: Self::Number) -> Self::Number {
        each(|i| a[i].abs())
    }

    fn product_error(self, _: Self::Number, _: Self::Number, _: Self::Number) -> Self::Number {
        [0.0; LANES]
    }

    fn less(self, a: Self::Number, b: Self::Number) -> Self::Mask {
        each(|i| a[i] < b[i])
    }

    fn differences(self, found: Self::Number, a: Self::Number, b: Self::Number) -> Self::Number {
        each(|i| f32::from_bits(found[i].to_bits() | (a[i].to_bits() ^ b[i].to_bits())))
    }

    fn and(self, a: Self::Mask, b: Self::Mask) -> Self::Mask {
        each(|i| a[i] & b[i])
    }

    fn select(self, mask: Self::Mask, yes: Self::Number, no: Self::Number) -> Self::Number {
        each(|i| if mask[i] { yes[i] } else { no[i] })
    }
}

impl SingleLanes for PlainSingles {
    fn columns(self, rows: [&[f32; 4]; LANES]) -> [Self::Number; 3] {
        std::array::from_fn(|column| each(|i| rows[i][column]))
    }

    fn rows(self, columns: [Self::Number; 4]) -> [[f32; 4]; LANES] {
        each(|i| columns.map(|column| column[i]))
    }

    fn all(self, mask: Self::Mask) -> bool {
        mask == [true; LANES]
    }

    fn to_array(self, a: Self::Number) -> [f32; LANES] {
        a
    }

    fn add_row(self, sum: &mut [f32; 4], row: &[f32; 4]) {
        *sum = std::array::from_fn(|i| sum[i] + row[i]);
    }

    fn add_scaled_row(self, sum: &mut [f32; 4], row: &[f32; 4], factor: f32) {
        *sum = std::array::from_fn(|i| sum[i] + row[i] * factor);
    }

    fn last_column(self, rows: [&[f32; 4]; LANES]) -> Self::Number {
        each(|i| rows[i][3])
    }
}

/// Lanes in one register of AVX.
#[cfg(target_arch = "x86_64")]
#[derive(Clone, Copy)]
pub(crate) struct AvxSingles(pub(super) V3);

#[cfg(target_arch = "x86_64")]
impl AvxSingles {
    /// Two 4×4 matrices, one in the lower and one in the upper halves, transposed.
    #[inline(always)]
    fn transposed(self, [a, b, c, d]: [__m256; 4]) -> [__m256; 4] {
        let avx = self.0.avx;
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
        let low = self.0.avx._mm256_castps128_ps256(pulp::cast(*low));
        self.0.avx._mm256_insertf128_ps::<1>(low, pulp::cast(*high))
    }

    #[inline(always)]
    fn all_columns(self, rows: [&[f32; 4]; LANES]) -> [__m256; 4] {
        let [a, b, c, d, e, f, g, h] = rows;
        self.transposed([self.pair(a, e), self.pair(b, f), self.pair(c, g), self.pair(d, h)])
    }
}

#[cfg(target_arch = "x86_64")]
impl Arithmetic for AvxSingles {
    type Number = __m256;
    type Mask = __m256;

    #[inline(always)]
    fn splat(self, x: f64) -> __m256 {
        self.0.avx._mm256_set1_ps(x as f32)
    }

    #[inline(always)]
    fn add(self, a: __m256, b: __m256) -> __m256 {
        self.0.avx._mm256_add_ps(a, b)
    }

    #[inline(always)]
    fn sub(self, a: __m256, b: __m256) -> __m256 {
        self.0.avx._mm256_sub_ps(a, b)
    }

    #[inline(always)]
    fn mul(self, a: __m256, b: __m256) -> __m256 {
        self.0.avx._mm256_mul_ps(a, b)
    }

    #[inline(always)]
    fn div(self, a: __m256, b: __m256) -> __m256 {
        self.0.avx._mm256_div_ps(a, b)
    }

    #[inline(always)]
    fn sqrt(self, a: __m256) -> __m256 {
        self.0.avx._mm256_sqrt_ps(a)
    }

    #[inline(always)]
    fn abs(self, a: __m256) -> __m256 {
        self.0.avx._mm256_andnot_ps(self.0.avx._mm256_set1_ps(-0.0), a)
    }

    #[inline(always)]
    fn product_error(self, _: __m256, _: __m256, _: __m256) -> __m256 {
        self.0.avx._mm256_setzero_ps()
    }

    #[inline(always)]
    fn less(self, a: __m256, b: __m256) -> __m256 {
        self.0.avx._mm256_cmp_ps::<_CMP_LT_OQ>(a, b)
    }

    #[inline(always)]
    fn differences(self, found: __m256, a: __m256, b: __m256) -> __m256 {
        self.0.avx._mm256_or_ps(found, self.0.avx._mm256_xor_ps(a, b))
    }

    #[inline(always)]
    fn and(self, a: __m256, b: __m256) -> __m256 {
        self.0.avx._mm256_and_ps(a, b)
    }

    #[inline(always)]
    fn select(self, mask: __m256, yes: __m256, no: __m256) -> __m256 {
        self.0.avx._mm256_blendv_ps(no, yes, mask)
    }
}

#[cfg(target_arch = "x86_64")]
impl SingleLanes for AvxSingles {
    #[inline(always)]
    fn columns(self, rows: [&[f32; 4]; LANES]) -> [__m256; 3] {
        let [x, y, z, _] = self.all_columns(rows);
        [x, y, z]
    }

    #[inline(always)]
    fn rows(self, columns: [__m256; 4]) -> [[f32; 4]; LANES] {
        let avx = self.0.avx;
        let [a, b, c, d] = self.transposed(columns);
        [
            pulp::cast(avx._mm256_castps256_ps128(a)),
            pulp::cast(avx._mm256_castps256_ps128(b)),
            pulp::cast(avx._mm256_castps256_ps128(c)),
            pulp::cast(avx._mm256_castps256_ps128(d)),
            pulp::cast(avx._mm256_extractf128_ps::<1>(a)),
            pulp::cast(avx._mm256_extractf128_ps::<1>(b)),
            pulp::cast(avx._mm256_extractf128_ps::<1>(c)),
            pulp::cast(avx._mm256_extractf128_ps::<1>(d)),
        ]
    }

    #[inline(always)]
    fn all(self, mask: __m256) -> bool {
        self.0.avx._mm256_movemask_ps(mask) == 0xff
    }

    #[inline(always)]
    fn to_array(self, a: __m256) -> [f32; LANES] {
        pulp::cast(a)
    }

    #[inline(always)]
    fn add_row(self, sum: &mut [f32; 4], row: &[f32; 4]) {
        *sum = pulp::cast(self.0.sse._mm_add_ps(pulp::cast(*sum), pulp::cast(*row)));
    }

    #[inline(always)]
    fn add_scaled_row(self, sum: &mut [f32; 4], row: &[f32; 4], factor: f32) {
        let sse = self.0.sse;
        let term = sse._mm_mul_ps(pulp::cast(*row), sse._mm_set1_ps(factor));
        *sum = pulp::cast(sse._mm_add_ps(pulp::cast(*sum), term));
    }

    #[inline(always)]
    fn last_column(self, rows: [&[f32; 4]; LANES]) -> __m256 {
        self.all_columns(rows)[3]
    }
}

#[cfg(all(test, target_arch = "x86_64"))]
mod tests {
    use super::*;
    use crate::num::test_numbers::Numbers;

    /// Everything that lanes can do, as bits.
    fn everything<A: SingleLanes>(arch: A, rows: [&[f32; 4]; LANES]) -> Vec<u32> {
        let ([a, b, c], d) = (arch.columns(rows), arch.last_column(rows));
        let (first, second) = (arch.less(a, b), arch.less(c, d));
        let numbers = [
            arch.add(a, b),
            arch.sub(a, b),
            arch.mul(a, b),
            arch.div(a, b),
            arch.abs(a),
            arch.sqrt(arch.abs(c)),
            arch.differences(a, b, c),
            arch.product_error(a, b, arch.mul(a, b)),
            arch.select(first, c, d),
            arch.select(arch.and(first, second), c, arch.splat(0.5)),
        ];
        let mut found: Vec<f32> = numbers.into_iter().flat_map(|x| arch.to_array(x)).collect();
        found.extend(arch.rows([d, a, c, b]).as_flattened());
        found.push(f32::from(u8::from(arch.all(first))));
        let mut sum = *rows[0];
        arch.add_row(&mut sum, rows[1]);
        arch.add_scaled_row(&mut sum, rows[2], rows[3][0]);
        found.extend(sum);
        found.into_iter().map(f32::to_bits).collect()
    }

    #[test]
    fn the_cpus_instructions_do_what_plain_arithmetic_does() {
        let Some(token) = V3::try_new() else { return };
        let mut numbers = Numbers::new(13);
        for _ in 0..20_000 {
            let mut rows = [[(); 4]; LANES].map(|row| row.map(|()| numbers.spread(20) as f32));
            if numbers.below(4) == 0 {
                rows.iter_mut().for_each(|row| row[0] = row[1] - 1.0);
            }
            assert_eq!(
                everything(AvxSingles(token), rows.each_ref()),
                everything(PlainSingles, rows.each_ref()),
                "{rows:?}"
            );
        }
    }
}
