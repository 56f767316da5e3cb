//! Linear least squares by Householder's QR decomposition.

use super::unit_scale;

/// Columns of unit length count as dependent if one is closer than this to the span of those before it: some
/// millions of roundings, yet far below the angles between the columns of any stretched mesh.
const DEPENDENT: f64 = 1.0 / (1 << 30) as f64;

/// The x that makes |Ax − b| smallest, for a matrix A of `N` columns and as many rows as `right` has.
///
/// Columns are scaled to unit length first, so the answer scales with each of them and the decision about their
/// dependence does not depend on units. Overwrites its inputs. Deterministic: no pivoting, sums in row order.
///
/// `None` if there are fewer rows than columns, if the columns are dependent (see [`DEPENDENT`]) or if anything
/// is not finite. Golub & Van Loan, *Matrix Computations*, algorithms 5.2.1 and 5.3.2. Cost: 2 rows·N².
pub(crate) fn least_squares<const N: usize>(
    columns: &mut [&mut [f64]; N],
    right: &mut [f64],
) -> Option<[f64; N]> {
    if right.len() < N {
        return None;
    }
    let mut lengths = [0.0; N];
    for (column, length) in columns.iter_mut().zip(&mut lengths) {
        *length = length_of(column);
        if !(*length > 0.0 && length.is_finite()) {
            return None;
        }
        column.iter_mut().for_each(|x| *x /= *length);
    }
    let mut diagonal = [0.0; N];
    for k in 0..N {
        let (column, later) = columns[k..].split_first_mut().expect("k is below N");
        let pivot = &mut column[k..];
        let length = dot(pivot, pivot).sqrt();
        if length.is_nan() || length <= DEPENDENT {
            return None;
        }
        // The reflection in the plane normal to v = x + sign(x₀)|x|e₀ takes x to a multiple of e₀.
        let target = -length.copysign(pivot[0]);
        pivot[0] -= target;
        // |v|²/2, without cancellation.
        let half_square = length * pivot[0].abs();
        for other in later.iter_mut().map(|column| &mut **column).chain([&mut *right]) {
            let factor = dot(pivot, &other[k..]) / half_square;
            other[k..].iter_mut().zip(&*pivot).for_each(|(x, v)| *x -= factor * v);
        }
        diagonal[k] = target;
    }
    let mut solution = [0.0; N];
    for k in (0..N).rev() {
        let known: f64 = (k + 1..N).map(|j| columns[j][k] * solution[j]).sum();
        solution[k] = (right[k] - known) / diagonal[k];
    }
    solution.iter_mut().zip(lengths).for_each(|(x, length)| *x /= length);
    solution.iter().all(|x| x.is_finite()).then_some(solution)
}

fn dot(a: &[f64], b: &[f64]) -> f64 {
    a.iter().zip(b).map(|(x, y)| x * y).sum()
}

/// The length of a column of any scale.
fn length_of(column: &[f64]) -> f64 {
    let scale = unit_scale(column.iter().fold(0.0, |largest, x| x.abs().max(largest)));
    column.iter().map(|x| (x * scale) * (x * scale)).sum::<f64>().sqrt() / scale
}

#[cfg(test)]
mod tests {
    use super::*;

    fn solve<const N: usize>(mut columns: [Vec<f64>; N], mut right: Vec<f64>) -> Option<[f64; N]> {
        least_squares(&mut columns.each_mut().map(Vec::as_mut_slice), &mut right)
    }

    #[test]
    fn a_line_through_points_by_the_textbook() {
        // y = 1, 2, 2, 4 at x = 0, 1, 2, 3: the normal equations give 0.9 + 0.9 x.
        let x: Vec<f64> = (0..4).map(f64::from).collect();
        let [offset, slope] = solve([vec![1.0; 4], x], vec![1.0, 2.0, 2.0, 4.0]).unwrap();
        assert!((offset - 0.9).abs() < 1e-14 && (slope - 0.9).abs() < 1e-14, "{offset} {slope}");
    }

    #[test]
    fn dependence_is_judged_without_units() {
        let x: Vec<f64> = (0..9).map(f64::from).collect();
        let nearly = |off: f64| (0..9).map(|i| f64::from(i) + off * f64::from(i % 2)).collect::<Vec<f64>>();
        for unit in [1e-300, 1e-20, 1.0, 1e150] {
            let scaled = |column: Vec<f64>| column.into_iter().map(|x| x * unit).collect::<Vec<f64>>();
            assert_eq!(solve([x.clone(), scaled(nearly(0.0))], x.clone()), None);
            assert_eq!(solve([x.clone(), scaled(nearly(1e-9))], x.clone()), None);
            let [a, b] = solve([x.clone(), scaled(nearly(1e-3))], x.clone()).unwrap();
            assert!((a - 1.0).abs() < 1e-9 && (b * unit).abs() < 1e-9);
        }
        assert_eq!(solve([vec![1.0]; 1], vec![]), None, "too few rows");
        assert_eq!(solve([vec![0.0; 3]], vec![1.0; 3]), None);
        assert_eq!(solve([vec![f64::NAN; 3]], vec![1.0; 3]), None);
        assert_eq!(solve([vec![1.0; 3]], vec![f64::INFINITY; 3]), None);
    }
}
