//! Eight numbers at a time, with the instructions that the CPU has.
//!
//! A compiler left alone with loops over arrays finds vector instructions in some builds and misses them in others, so
//! kernels name them. They do it through [`Arithmetic`]: a formula written once runs on one number or on eight, and as
//! every operation is the one of IEEE 754, it gives the same bits either way and on any CPU.

// Eight lanes in two registers of AVX.
#[cfg(target_arch = "x86_64")]
mod avx2;
// Eight lanes in one register of AVX-512.
#[cfg(target_arch = "x86_64")]
mod avx512;
// Arithmetic without any particular instructions.
mod plain;
// Exact products, with and without a fused multiply-add.
pub(in crate::num) mod product;
// Numbers and vectors for formulas, for any number of lanes.
mod scalars;
// Eight lanes of single precision in one register of AVX.
#[cfg(target_arch = "x86_64")]
mod avx_singles;
// Eight lanes in four registers of WebAssembly.
#[cfg(all(target_arch = "wasm32", target_feature = "simd128"))]
mod simd128;
// Eight lanes of single precision in two registers of WebAssembly.
#[cfg(all(target_arch = "wasm32", target_feature = "simd128"))]
mod simd128_singles;

#[cfg(target_arch = "x86_64")]
pub(super) use avx2::Avx2;
#[cfg(target_arch = "x86_64")]
pub(super) use avx512::Avx512;
pub(crate) use plain::OneLane;
pub(super) use plain::Plain;
pub(crate) use scalars::{Scalars, Truth, Vectors};
#[cfg(all(target_arch = "wasm32", target_feature = "simd128"))]
pub(super) use simd128::Simd128;

use super::real::Real;
use bytemuck::Pod;
use product::Product;

/// How many numbers a kernel works on at a time.
pub(crate) const LANES: usize = 8;

/// Arithmetic on one number or several, a token for the instructions that do it. Nothing is fused and nothing
/// approximate.
pub(crate) trait Arithmetic: Copy {
    /// The numbers.
    type Number: Copy;
    /// One yes or no for each.
    type Mask: Copy;

    /// The same number in each lane.
    fn splat(self, x: f64) -> Self::Number;
    fn add(self, a: Self::Number, b: Self::Number) -> Self::Number;
    fn sub(self, a: Self::Number, b: Self::Number) -> Self::Number;
    fn mul(self, a: Self::Number, b: Self::Number) -> Self::Number;
    fn div(self, a: Self::Number, b: Self::Number) -> Self::Number;
    fn sqrt(self, a: Self::Number) -> Self::Number;
    fn abs(self, a: Self::Number) -> Self::Number;
    /// ab − fl(ab), given fl(ab); see [`Product`].
    fn product_error(self, a: Self::Number, b: Self::Number, product: Self::Number) -> Self::Number;
    /// a < b; no for NaN.
    fn less(self, a: Self::Number, b: Self::Number) -> Self::Mask;
    fn and(self, a: Self::Mask, b: Self::Mask) -> Self::Mask;
    /// `yes` where the mask says so, elsewhere `no`.
    fn select(self, mask: Self::Mask, yes: Self::Number, no: Self::Number) -> Self::Number;

    /// a if a < b, otherwise b.
    #[inline(always)]
    fn min(self, a: Self::Number, b: Self::Number) -> Self::Number {
        self.select(self.less(a, b), a, b)
    }

    /// a if a > b, otherwise b.
    #[inline(always)]
    fn max(self, a: Self::Number, b: Self::Number) -> Self::Number {
        self.select(self.less(b, a), a, b)
    }
}

/// Methods that are one instruction of an instruction set in the token.
#[cfg(target_arch = "x86_64")]
macro_rules! instructions {
    ($set:ident: $($method:ident($($number:ident),*) = $instruction:ident),* $(,)?) => {$(
        #[inline(always)]
        fn $method(self, $($number: Self::Number),*) -> Self::Number {
            self.token.$set.$instruction($($number),*)
        }
    )*};
}
#[cfg(target_arch = "x86_64")]
use instructions;

/// Eight rows of four numbers, such as a vector and its length for each of eight faces.
#[derive(Clone, Copy)]
#[repr(align(64))]
pub(crate) struct Rows<T>(pub(crate) [[T; 4]; LANES]);

/// A number for each lane, in memory.
#[derive(Clone, Copy, Debug, PartialEq)]
#[repr(align(64))]
pub(crate) struct Eight(pub(crate) [f64; LANES]);

impl Eight {
    pub(crate) const ZERO: Self = Self([0.0; LANES]);
}

/// Eight lanes of single or double precision, and the way between them and rows in memory.
pub(crate) trait EightLanes: Arithmetic<Number: Pod> {
    /// The number in a lane.
    type Element: Real;

    /// The lane that a row becomes: where columns come from rows, any order serves as long as it is kept.
    #[inline(always)]
    fn lane(row: usize) -> usize {
        row
    }

    /// The numbers of all lanes, by lane.
    #[inline(always)]
    fn to_array(self, a: Self::Number) -> [Self::Element; LANES] {
        pulp::cast(a)
    }

    /// Lanes of these numbers.
    #[inline(always)]
    fn load(self, lanes: &[Self::Element; LANES]) -> Self::Number {
        pulp::cast(*lanes)
    }

    /// The mask, one bit a lane.
    fn bits(self, mask: Self::Mask) -> u8;
    /// The columns of eight rows.
    fn columns(self, rows: [&[Self::Element; 4]; LANES]) -> [Self::Number; 4];
    /// Columns as rows.
    fn rows(self, columns: [Self::Number; 4]) -> Rows<Self::Element>;
    /// sum += row.
    fn add_row(self, sum: &mut [Self::Element; 4], row: &[Self::Element; 4]);
    /// sum += factor · row, rounded twice.
    fn add_scaled_row(self, sum: &mut [Self::Element; 4], row: &[Self::Element; 4], factor: Self::Element);

    /// sum += factor · row, rounded twice, except that the last number of the term is at least `least`.
    #[inline(always)]
    fn add_bounded_row(
        self,
        sum: &mut [Self::Element; 4],
        row: &[Self::Element; 4],
        factor: Self::Element,
        least: Self::Element,
    ) {
        let [x, y, z, last] = row.map(|x| x * factor);
        let last = if last > least { last } else { least };
        self.add_row(sum, &[x, y, z, last]);
    }

    /// The mask, one bit a row.
    #[inline(always)]
    fn row_bits(self, mask: Self::Mask) -> u8 {
        let bits = self.bits(mask);
        // Almost always all are set.
        if bits == u8::MAX {
            return bits;
        }
        (0..LANES).fold(0, |rows, row| rows | (bits >> Self::lane(row) & 1) << row)
    }
}

/// Eight lanes of double precision, and what kernels need with them.
pub(crate) trait Lanes: EightLanes<Element = f64> + Product {
    /// Eight lanes of single precision. Products have no error term there: formulas that correct for it lose the
    /// correction, nothing else.
    type Singles: EightLanes<Element = f32>;

    /// Those that the same CPU has.
    fn singles(self) -> Self::Singles;
    /// Bits that `found` has or in which a and b differ, as a number.
    fn differences(self, found: Self::Number, a: Self::Number, b: Self::Number) -> Self::Number;
    /// Which of some whole numbers equal another, one bit each in their order.
    fn equal_bits(self, numbers: &[u32; LANES], number: u32) -> u8;
    /// The first three columns of eight rows.
    fn columns_of_singles(self, rows: [&[f32; 4]; LANES]) -> [Self::Number; 3];
    /// factor · row.
    fn scaled_row(self, row: &[f64; 4], factor: f64) -> [f64; 4];
    /// factor · row, rounded once more to single precision.
    fn scaled_row_of_singles(self, row: &[f64; 4], factor: f64) -> [f32; 4];
}

#[cfg(test)]
mod tests {
    use super::super::dispatch::{Kernel, dispatch};
    use super::super::test_numbers::Numbers;
    use super::product::Split;
    use super::*;

    /// Everything that lanes can do to some rows, as bits.
    struct Everything<'a>(&'a [[f64; 4]; LANES]);

    impl Kernel for Everything<'_> {
        type Output = Vec<u64>;

        fn run<A: Lanes>(self, arch: A) -> Vec<u64> {
            let rows = self.0;
            let [a, b, c, d] = arch.columns(rows.each_ref());
            let mut found: Vec<f64> = Vec::new();
            let mut take = |x: A::Number| {
                let lanes = arch.to_array(x);
                found.extend((0..LANES).map(|row| lanes[A::lane(row)]));
            };
            [a, b, c, d].into_iter().for_each(&mut take);
            for x in [arch.add(a, b), arch.sub(a, b), arch.mul(a, b), arch.div(a, b), arch.abs(a)] {
                take(x);
            }
            let (zero, nan) = (arch.splat(0.0), arch.splat(f64::NAN));
            for (a, b) in [(a, b), (a, nan), (nan, b), (zero, arch.splat(-0.0)), (arch.splat(-0.0), zero)] {
                take(arch.min(a, b));
                take(arch.max(a, b));
            }
            take(arch.sqrt(arch.abs(c)));
            take(arch.product_error(a, b, arch.mul(a, b)));
            take(arch.differences(a, b, c));
            take(arch.mul(d, arch.load(&arch.to_array(a))));
            let (first, second) = (arch.less(a, b), arch.less(c, d));
            take(arch.select(first, c, d));
            take(arch.select(arch.and(first, second), c, arch.splat(0.5)));
            found.extend([first, second].map(|mask| f64::from(arch.row_bits(mask))));
            found.extend(arch.rows([d, a, c, b]).0.as_flattened());
            let singles = rows.map(|row| row.map(|x| x as f32));
            arch.columns_of_singles(singles.each_ref()).into_iter().for_each(|x| {
                let lanes = arch.to_array(x);
                found.extend((0..LANES).map(|row| lanes[A::lane(row)]));
            });
            let mut sum = rows[0];
            arch.add_row(&mut sum, &rows[1]);
            found.extend(sum);
            arch.add_scaled_row(&mut sum, &rows[2], rows[3][0]);
            found.extend(sum);
            found.extend(arch.scaled_row(&sum, rows[4][1]));
            found.extend(arch.scaled_row_of_singles(&sum, rows[5][2]).map(f64::from));
            found.into_iter().map(f64::to_bits).collect()
        }
    }

    #[test]
    fn the_cpus_instructions_do_what_plain_arithmetic_does() {
        let mut numbers = Numbers::new(12);
        for round in 0..20_000 {
            let rows = [[(); 4]; LANES].map(|row| row.map(|()| numbers.spread([2, 100][round % 2])));
            let truth = Everything(&rows).run(Plain::<f64, Split>::new());
            assert_eq!(dispatch(Everything(&rows)), truth, "{rows:?}");
            #[cfg(target_arch = "x86_64")]
            if let Some(avx2) = Avx2::new() {
                assert_eq!(Everything(&rows).run(avx2), truth, "{rows:?}");
            }
        }
    }

    struct Equal<'a>(&'a [u32; LANES], u32);

    impl Kernel for Equal<'_> {
        type Output = u8;

        fn run<A: Lanes>(self, arch: A) -> u8 {
            arch.equal_bits(self.0, self.1)
        }
    }

    #[test]
    fn equal_numbers_give_their_places() {
        for (numbers, number, places) in [
            ([0, 1, 2, 3, 4, 5, 6, 7], 5, 1 << 5),
            ([9, 7, 9, u32::MAX, 9, 1 << 31, 0, 9], 9, 0b1001_0101),
            ([u32::MAX; LANES], u32::MAX, 0xff),
            ([0x100, 0x1_0000, 1 << 24, 2, 3, 4, 5, 6], 1, 0),
        ] {
            assert_eq!(dispatch(Equal(&numbers, number)), places);
            assert_eq!(Equal(&numbers, number).run(Plain::<f64, Split>::new()), places);
            #[cfg(target_arch = "x86_64")]
            if let Some(avx2) = Avx2::new() {
                assert_eq!(Equal(&numbers, number).run(avx2), places);
            }
        }
    }

    #[test]
    fn plain_lanes_come_from_rows_in_order() {
        let arch = Plain::<f64, Split>::new();
        let rows = std::array::from_fn(|row| std::array::from_fn(|column| (10 * row + column) as f64));
        let columns = arch.columns(std::array::from_fn(|row| &rows[row]));
        assert_eq!(columns[2], [2.0, 12.0, 22.0, 32.0, 42.0, 52.0, 62.0, 72.0]);
        assert_eq!(arch.rows(columns).0, rows);
        let low = arch.less(columns[0], arch.splat(25.0));
        assert_eq!(arch.row_bits(low), 0b111);
        assert_eq!(arch.select(low, columns[0], columns[1])[2..4], [20.0, 31.0]);
    }

    /// Everything that lanes of single precision can do, as bits.
    fn everything<A: EightLanes<Element = f32>>(arch: A, rows: [&[f32; 4]; LANES]) -> Vec<u32> {
        let [a, b, c, d] = arch.columns(rows);
        let (first, second) = (arch.less(a, b), arch.less(c, d));
        let numbers = [
            arch.add(a, b),
            arch.sub(a, b),
            arch.mul(a, b),
            arch.div(a, b),
            arch.abs(a),
            arch.min(a, b),
            arch.max(c, d),
            arch.sqrt(arch.abs(c)),
            arch.product_error(a, b, arch.mul(a, b)),
            arch.select(first, c, d),
            arch.select(arch.and(first, second), c, arch.splat(0.5)),
            arch.mul(d, arch.load(&arch.to_array(a))),
        ];
        let mut found: Vec<f32> = numbers.into_iter().flat_map(|x| arch.to_array(x)).collect();
        found.extend(arch.rows([d, a, c, b]).0.as_flattened());
        found.push(f32::from(arch.bits(first)));
        let mut sum = *rows[0];
        arch.add_row(&mut sum, rows[1]);
        arch.add_scaled_row(&mut sum, rows[2], rows[3][0]);
        arch.add_bounded_row(&mut sum, rows[4], rows[5][0], rows[6][0]);
        found.extend(sum);
        found.into_iter().map(f32::to_bits).collect()
    }

    #[test]
    #[cfg(target_arch = "x86_64")]
    fn singles_do_what_plain_arithmetic_does() {
        let Some(avx2) = Avx2::new() else { return };
        let mut numbers = Numbers::new(13);
        for _ in 0..20_000 {
            let mut rows = [[(); 4]; LANES].map(|row| row.map(|()| numbers.spread(20) as f32));
            if numbers.below(4) == 0 {
                rows.iter_mut().for_each(|row| row[0] = row[1] - 1.0);
            }
            let plain = Plain::<f64, Split>::new().singles();
            assert_eq!(
                everything(avx2.singles(), rows.each_ref()),
                everything(plain, rows.each_ref()),
                "{rows:?}"
            );
        }
    }
}
