//! Linear least squares by Householder's QR decomposition, eight systems at a time.

use super::lanes::{Eight, LANES, Lanes, Scalars};
use super::{PLAIN_SQUARES, unit_scale};

/// The most rows of a system.
pub(crate) const ROWS: usize = 64;

/// The most columns of a system, without its right side.
const COLUMNS: usize = 10;

/// Columns whose dots with a reflection are summed at the same time: additions of one sum wait for each other.
const TOGETHER: usize = 4;

/// A column of eight systems, or their right sides. With one row more than there are, columns are no multiple of 4 KiB apart: all of
/// their rows would share one set of the cache.
pub(crate) type Column = [Eight; ROWS + 1];

/// Which column is reduced next.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Pivoting {
    /// They keep their order.
    None,
    /// The one farthest from the span of those before it, if it is more than twice as far as the next: then the last of them
    /// shows the condition, and there are few swaps.
    Columns,
}

/// The solutions of eight systems.
pub(crate) struct LeastSquares {
    /// The unknowns in the order of the columns, of as many as there are.
    pub(crate) unknowns: [Eight; COLUMNS],
    /// Which systems have them, a bit for each lane.
    pub(crate) solved: u8,
}

/// The x that makes |Ax − b| smallest in each of eight systems; the last column is b.
///
/// Columns are scaled to unit length first, so the answer scales with each of them and the decision about their dependence does
/// not depend on units. Then the distance of a column from the span of those before it is at most 1, and with
/// [`Pivoting::Columns`] the reciprocal of the smallest such distance estimates the condition number of A, from below (Golub
/// & Van Loan, *Matrix Computations*, 5.4.2 and 5.5.1; algorithms 5.2.1, 5.3.2 and 5.4.1). Systems in which a distance is not above
/// `nearest` are not solved, nor those with anything that is not finite.
///
/// Overwrites its inputs. Each lane has the bits that it has in any company: sums are in row order. Rows of zeros at the end
/// change none, so systems of fewer rows than others are filled up with them. Cost: 2 rows · columns² for all eight.
#[inline(always)]
pub(crate) fn least_squares<A: Lanes>(
    arch: A,
    columns: &mut [Column],
    rows: usize,
    pivoting: Pivoting,
    nearest: f64,
) -> LeastSquares {
    let unknowns = columns.len() - 1;
    let (zero, one) = (Scalars::splat(arch, 0.0), Scalars::splat(arch, 1.0));
    let mut lengths = [Eight::ZERO; COLUMNS];
    for (column, length) in columns[..unknowns].iter_mut().zip(&mut lengths) {
        *length = scale_to_unit_length(arch, &mut column[..rows]);
    }
    let mut solved = one;
    let mut diagonal = [Eight::ZERO; COLUMNS];
    // The number of the column that has come to each place, and its squared distance from the span of those before.
    let mut order: [Eight; COLUMNS] = std::array::from_fn(|k| Eight([k as f64; LANES]));
    let mut distances = [one.store(); COLUMNS];
    for k in 0..unknowns {
        if pivoting == Pivoting::Columns {
            let farthest = farthest(arch, &distances[k..unknowns]);
            for j in k + 1..unknowns {
                let swaps = Swaps { arch, wanted: j - k, farthest };
                if swaps.any() {
                    let (before, after) = columns.split_at_mut(j);
                    swaps.all(&mut before[k][..rows], &mut after[0][..rows]);
                    let (before, after) = order.split_at_mut(j);
                    swaps.all(&mut before[k..=k], &mut after[..1]);
                    let (before, after) = distances.split_at_mut(j);
                    swaps.all(&mut before[k..=k], &mut after[..1]);
                }
            }
        }
        let (pivot, later) = columns[k..].split_first_mut().expect("k is a column");
        let pivot = &mut pivot[k..rows];
        let length = dot(arch, pivot, pivot).sqrt();
        solved = Scalars::splat(arch, nearest).less(length).select(solved, zero);
        // The reflection in the plane normal to v = x + sign(x₀)|x|e₀ takes x to a multiple of e₀. The sign of a zero
        // counts, as that of its reciprocal.
        let first = Scalars::load(arch, &pivot[0]);
        let target = (one / first).less(zero).select(length, zero - length);
        let first = first - target;
        pivot[0] = first.store();
        diagonal[k] = target.store();
        // |v|²/2, without cancellation.
        let half_square = length * first.abs();
        let (together, single) = later.as_chunks_mut::<TOGETHER>();
        for columns in together {
            reflect(pivot, half_square, columns.each_mut().map(|column| &mut column[k..rows]));
        }
        match single {
            [a, b, c] => reflect(pivot, half_square, [a, b, c].map(|column| &mut column[k..rows])),
            [a, b] => reflect(pivot, half_square, [a, b].map(|column| &mut column[k..rows])),
            [a] => reflect(pivot, half_square, [&mut a[k..rows]]),
            _ => {}
        }
        if pivoting == Pivoting::Columns {
            for (distance, column) in distances[k + 1..unknowns].iter_mut().zip(&columns[k + 1..]) {
                let taken = Scalars::load(arch, &column[k]);
                *distance = (Scalars::load(arch, distance) - taken * taken).store();
            }
        }
    }
    let (columns, right) = columns.split_at(unknowns);
    let right = &right[0][..rows];
    let mut solution = [Eight::ZERO; COLUMNS];
    for k in (0..unknowns).rev() {
        let mut known = Scalars::splat(arch, -0.0);
        for j in k + 1..unknowns {
            known = known + Scalars::load(arch, &columns[j][k]) * Scalars::load(arch, &solution[j]);
        }
        let value = (Scalars::load(arch, &right[k]) - known) / Scalars::load(arch, &diagonal[k]);
        solution[k] = value.store();
    }
    if pivoting == Pivoting::Columns {
        solution = in_order(arch, &solution, &order, unknowns);
    }
    // What is not finite times 0 is no number, and no number is equal to 0.
    let mut finite = zero;
    for (value, length) in solution.iter_mut().zip(&lengths).take(unknowns) {
        let scaled = Scalars::load(arch, value) / Scalars::load(arch, length);
        finite = finite + scaled * zero;
        *value = scaled.store();
    }
    let (solved, finite) = (solved.store(), finite.store());
    let bit = |lane: usize| u8::from(solved.0[lane] == 1.0 && finite.0[lane] == 0.0) << lane;
    LeastSquares { unknowns: solution, solved: (0..LANES).fold(0, |bits, lane| bits | bit(lane)) }
}

#[inline(always)]
fn dot<A: Lanes>(arch: A, a: &[Eight], b: &[Eight]) -> Scalars<A> {
    let mut sum = Scalars::splat(arch, -0.0);
    for (a, b) in a.iter().zip(b) {
        sum = sum + Scalars::load(arch, a) * Scalars::load(arch, b);
    }
    sum
}

/// Reflects columns in the plane normal to v, given |v|²/2.
#[inline(always)]
fn reflect<A: Lanes, const N: usize>(v: &[Eight], half_square: Scalars<A>, mut columns: [&mut [Eight]; N]) {
    let arch = half_square.arch;
    let rows = v.len();
    // One check of each length instead of one a row.
    columns = columns.map(|column| &mut column[..rows]);
    let mut sums = [Scalars::splat(arch, -0.0); N];
    for (row, v) in v.iter().enumerate() {
        let v = Scalars::load(arch, v);
        for (sum, column) in sums.iter_mut().zip(&columns) {
            *sum = *sum + v * Scalars::load(arch, &column[row]);
        }
    }
    for sum in &mut sums {
        *sum = *sum / half_square;
    }
    for (row, v) in v.iter().enumerate() {
        let v = Scalars::load(arch, v);
        for (&factor, column) in sums.iter().zip(&mut columns) {
            column[row] = (Scalars::load(arch, &column[row]) - factor * v).store();
        }
    }
}

/// Divides columns by their lengths, which it returns. Not a number for those that are zero or not finite.
#[inline(always)]
fn scale_to_unit_length<A: Lanes>(arch: A, column: &mut [Eight]) -> Eight {
    let squares = dot(arch, column, column);
    let mut length = squares.sqrt();
    // Divisions take several times as long as products.
    let mut factor = Scalars::splat(arch, 1.0) / length;
    if !squares.store().0.iter().all(is_plain) {
        let other = divide_by_lengths_of_any_scale(squares.store(), column);
        let keep = |own: Scalars<A>, other: [f64; LANES]| {
            let own = own.store().0;
            let lane = |lane: usize| if is_plain(&squares.store().0[lane]) { own[lane] } else { other[lane] };
            Scalars::load(arch, &Eight(std::array::from_fn(lane)))
        };
        (length, factor) = (keep(length, other), keep(factor, [1.0; LANES]));
    }
    for x in column.iter_mut() {
        *x = (Scalars::load(arch, x) * factor).store();
    }
    length.store()
}

/// Whether a sum of squares has no term that is out of the range of numbers.
fn is_plain(square: &f64) -> bool {
    (PLAIN_SQUARES.0..=PLAIN_SQUARES.1).contains(square)
}

/// Divides columns with sums of `squares` that are out of range by their lengths, which it returns.
#[cold]
#[inline(never)]
fn divide_by_lengths_of_any_scale(squares: Eight, column: &mut [Eight]) -> [f64; LANES] {
    std::array::from_fn(|lane| {
        if is_plain(&squares.0[lane]) {
            return 1.0;
        }
        let scale = unit_scale(column.iter().fold(0.0, |largest: f64, x| x.0[lane].abs().max(largest)));
        let scaled = column.iter().map(|x| (x.0[lane] * scale) * (x.0[lane] * scale));
        let length = scaled.sum::<f64>().sqrt() / scale;
        column.iter_mut().for_each(|x| x.0[lane] /= length);
        length
    })
}

/// The place in each lane of the farthest column: the first unless another is more than twice as far. Distances are squared.
#[inline(always)]
fn farthest<A: Lanes>(arch: A, distances: &[Eight]) -> Scalars<A> {
    let mut best = Scalars::splat(arch, 0.0);
    let mut largest = Scalars::load(arch, &distances[0]) * Scalars::splat(arch, 4.0);
    for (place, distance) in distances.iter().enumerate().skip(1) {
        let distance = Scalars::load(arch, distance);
        let is_larger = largest.less(distance);
        best = is_larger.select(Scalars::splat(arch, place as f64), best);
        largest = is_larger.select(distance, largest);
    }
    best
}

/// Swaps numbers in those lanes whose farthest column is at a certain place.
#[derive(Clone, Copy)]
struct Swaps<A: Lanes> {
    arch: A,
    wanted: usize,
    farthest: Scalars<A>,
}

impl<A: Lanes> Swaps<A> {
    /// |farthest − wanted| < ½ for whole numbers.
    #[inline(always)]
    fn any(self) -> bool {
        let wanted = self.wanted as f64;
        self.farthest.store().0.contains(&wanted)
    }

    #[inline(always)]
    fn all(self, a: &mut [Eight], b: &mut [Eight]) {
        let arch = self.arch;
        let is_wanted = (self.farthest - Scalars::splat(arch, self.wanted as f64)).abs();
        let is_wanted = is_wanted.less(Scalars::splat(arch, 0.5));
        for (a, b) in a.iter_mut().zip(b) {
            let (old_a, old_b) = (Scalars::load(arch, a), Scalars::load(arch, b));
            *a = is_wanted.select(old_b, old_a).store();
            *b = is_wanted.select(old_a, old_b).store();
        }
    }
}

/// Unknowns in the order of their columns.
#[inline(always)]
fn in_order<A: Lanes>(
    arch: A,
    unknowns: &[Eight; COLUMNS],
    order: &[Eight; COLUMNS],
    count: usize,
) -> [Eight; COLUMNS] {
    let mut sorted = [Eight::ZERO; COLUMNS];
    for (column, sorted) in sorted.iter_mut().enumerate().take(count) {
        let mut found = Scalars::splat(arch, 0.0);
        for (value, place) in unknowns.iter().zip(order).take(count) {
            let off = (Scalars::load(arch, place) - Scalars::splat(arch, column as f64)).abs();
            let is_it = off.less(Scalars::splat(arch, 0.5));
            found = is_it.select(Scalars::load(arch, value), found);
        }
        *sorted = found.store();
    }
    sorted
}

#[cfg(test)]
mod tests {
    use super::super::dispatch::{Kernel, dispatch};
    use super::super::lanes::Plain;
    use super::super::lanes::product::Split;
    use super::super::test_numbers::Numbers;
    use super::*;

    const NEAREST: f64 = 1.0 / (1 << 30) as f64;

    #[derive(Clone)]
    struct Systems {
        columns: Vec<Column>,
        rows: usize,
        pivoting: Pivoting,
    }

    impl Kernel for Systems {
        type Output = LeastSquares;

        fn run<A: Lanes>(mut self, arch: A) -> LeastSquares {
            least_squares(arch, &mut self.columns, self.rows, self.pivoting, NEAREST)
        }
    }

    /// One system in all lanes.
    fn system(columns: &[Vec<f64>], pivoting: Pivoting) -> Systems {
        let column = |from: &Vec<f64>| {
            let mut column = [Eight::ZERO; ROWS + 1];
            from.iter().zip(&mut column).for_each(|(&x, row)| *row = Eight([x; LANES]));
            column
        };
        Systems { columns: columns.iter().map(column).collect(), rows: columns[0].len(), pivoting }
    }

    fn solve(columns: &[Vec<f64>], pivoting: Pivoting) -> Option<Vec<f64>> {
        let found = dispatch(system(columns, pivoting));
        assert!(found.solved == 0 || found.solved == u8::MAX);
        (found.solved != 0).then(|| found.unknowns[..columns.len() - 1].iter().map(|it| it.0[3]).collect())
    }

    const BOTH: [Pivoting; 2] = [Pivoting::None, Pivoting::Columns];

    #[test]
    fn a_line_through_points_by_the_textbook() {
        // y = 1, 2, 2, 4 at x = 0, 1, 2, 3: the normal equations give 0.9 + 0.9 x.
        let columns = [vec![1.0; 4], (0..4).map(f64::from).collect(), vec![1.0, 2.0, 2.0, 4.0]];
        for pivoting in BOTH {
            let [offset, slope] = solve(&columns, pivoting).unwrap()[..] else { panic!("two unknowns") };
            assert!((offset - 0.9).abs() < 1e-14 && (slope - 0.9).abs() < 1e-14, "{offset} {slope}");
        }
    }

    #[test]
    fn dependence_is_judged_without_units() {
        let x: Vec<f64> = (0..9).map(f64::from).collect();
        let nearly = |off: f64| (0..9).map(|i| f64::from(i) + off * f64::from(i % 2)).collect::<Vec<f64>>();
        for (unit, pivoting) in
            [1e-300, 1e-20, 1.0, 1e150].into_iter().flat_map(|unit| BOTH.map(|it| (unit, it)))
        {
            let scaled = |column: Vec<f64>| column.into_iter().map(|x| x * unit).collect::<Vec<f64>>();
            assert_eq!(solve(&[x.clone(), scaled(nearly(0.0)), x.clone()], pivoting), None);
            assert_eq!(solve(&[x.clone(), scaled(nearly(1e-9)), x.clone()], pivoting), None);
            let found = solve(&[x.clone(), scaled(nearly(1e-3)), x.clone()], pivoting).unwrap();
            assert!((found[0] - 1.0).abs() < 1e-9 && (found[1] * unit).abs() < 1e-9);
        }
        for pivoting in BOTH {
            assert_eq!(solve(&[vec![0.0; 3], vec![1.0; 3]], pivoting), None);
            assert_eq!(solve(&[vec![f64::NAN; 3], vec![1.0; 3]], pivoting), None);
            assert_eq!(solve(&[vec![1.0; 3], vec![f64::INFINITY; 3]], pivoting), None);
        }
    }

    /// Two columns that are nearly parallel, and random systems.
    #[test]
    fn pivoting_changes_solutions_by_rounding_only() {
        let columns = [vec![1.0, 0.0, 0.0], vec![1.0, 1e-3, 0.0], vec![0.0, 0.0, 1.0], vec![3.0, 1e-3, 5.0]];
        let found = solve(&columns, Pivoting::Columns).unwrap();
        assert!([2.0, 1.0, 5.0].iter().zip(&found).all(|(a, b)| (a - b).abs() < 1e-11), "{found:?}");
        let mut numbers = Numbers::new(4);
        for _ in 0..200 {
            let mut column = || (0..20).map(|_| 2.0 * numbers.unit() - 1.0).collect::<Vec<f64>>();
            let columns: Vec<Vec<f64>> = (0..6).map(|_| column()).collect();
            let [plain, pivoted] = BOTH.map(|pivoting| solve(&columns, pivoting).unwrap());
            assert!(plain.iter().zip(&pivoted).all(|(a, b)| (a - b).abs() < 1e-13), "{plain:?} {pivoted:?}");
        }
    }

    /// The same bits from any instructions, in any lane, next to any systems, with any number of rows of zeros.
    #[test]
    fn every_lane_has_the_bits_that_it_has_alone() {
        let mut numbers = Numbers::new(21);
        for round in 0..300 {
            let pivoting = BOTH[round % 2];
            let mut systems = Systems { columns: vec![[Eight::ZERO; ROWS + 1]; 7], rows: 20, pivoting };
            let counts: [usize; LANES] = std::array::from_fn(|_| 8 + numbers.below(12));
            for column in &mut systems.columns {
                for (row, at) in column.iter_mut().enumerate() {
                    for (lane, &count) in at.0.iter_mut().zip(&counts) {
                        let x = if numbers.below(5) == 0 { -0.0 } else { 2.0 * numbers.unit() - 1.0 };
                        *lane = if row < count { x } else { 0.0 };
                    }
                }
            }
            let bits = |found: &LeastSquares, lane: usize| {
                let unknowns: Vec<u64> = found.unknowns[..6].iter().map(|it| it.0[lane].to_bits()).collect();
                (unknowns, found.solved >> lane & 1)
            };
            let found = dispatch(systems.clone());
            assert_eq!(found.solved, u8::MAX);
            let plain = systems.clone().run(Plain::<f64, Split>::new());
            for (lane, &rows) in counts.iter().enumerate() {
                let mut alone = Systems { rows, ..systems.clone() };
                for row in alone.columns.iter_mut().flatten() {
                    *row = Eight([row.0[lane]; LANES]);
                }
                assert_eq!(bits(&found, lane), bits(&plain, lane));
                assert_eq!(bits(&found, lane), bits(&dispatch(alone), 7 - lane));
            }
            #[cfg(target_arch = "x86_64")]
            if let Some(avx2) = super::super::lanes::Avx2::new() {
                let narrow = systems.run(avx2);
                assert!((0..LANES).all(|lane| bits(&found, lane) == bits(&narrow, lane)));
            }
        }
    }
}
