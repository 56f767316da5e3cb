//! Sums that keep their own rounding errors.

use std::ops::AddAssign;

/// `(s, e)` with s = fl(a+b) and s + e = a + b exactly (Knuth 1969).
#[inline(always)]
pub(crate) fn two_sum(a: f64, b: f64) -> (f64, f64) {
    let sum = a + b;
    let added = sum - a;
    (sum, (a - (sum - added)) + (b - added))
}

/// `(d, e)` with d = fl(a−b) and d + e = a − b exactly.
#[inline(always)]
pub(crate) fn two_difference(a: f64, b: f64) -> (f64, f64) {
    two_sum(a, -b)
}

/// A sum whose rounding errors are summed separately (Neumaier 1974; the error by Knuth's branch-free two-sum).
/// Its value is as accurate as a sum in twice the precision, rounded once.
#[derive(Clone, Copy, Debug, Default)]
pub struct CompensatedSum {
    sum: f64,
    lost: f64,
}

impl CompensatedSum {
    /// Adds something small compared with the sum, such as the rounding error of a term.
    #[inline]
    pub(crate) fn correct(&mut self, error: f64) {
        self.lost += error;
    }

    /// The sum so far.
    #[inline]
    pub fn value(self) -> f64 {
        self.sum + self.lost
    }
}

impl AddAssign<f64> for CompensatedSum {
    #[inline]
    fn add_assign(&mut self, term: f64) {
        let (sum, error) = two_sum(self.sum, term);
        self.sum = sum;
        self.lost += error;
    }
}

impl AddAssign for CompensatedSum {
    #[inline]
    fn add_assign(&mut self, other: Self) {
        *self += other.sum;
        self.lost += other.lost;
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn sums_and_differences_lose_nothing() {
        assert_eq!(two_sum(1.0, 1e-30), (1.0, 1e-30));
        assert_eq!(two_sum(1e-30, 1.0), (1.0, 1e-30));
        assert_eq!(two_difference(1e-30, 1.0), (-1.0, 1e-30));
        assert_eq!(two_difference(0.1, 0.1), (0.0, 0.0));
    }

    #[test]
    fn cancelling_terms_leave_what_is_small() {
        let terms = [1e16, 1.0, -1e16, 1e-5, 3e30, -3e30];
        let mut sum = CompensatedSum::default();
        terms.iter().for_each(|&term| sum += term);
        assert_eq!(sum.value(), 1.0 + 1e-5);
        assert_ne!(terms.iter().sum::<f64>(), 1.0 + 1e-5);

        let mut halves = [CompensatedSum::default(); 2];
        terms.iter().enumerate().for_each(|(i, &term)| halves[i / 3] += term);
        let mut joined = halves[0];
        joined += halves[1];
        assert_eq!(joined.value(), 1.0 + 1e-5);
    }
}
