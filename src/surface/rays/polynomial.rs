//! Real roots of polynomials of low degree.

/// Up to four numbers, ascending.
#[derive(Clone, Copy, Default)]
pub(crate) struct Roots {
    values: [f64; 4],
    count: usize,
}

impl Roots {
    fn push(&mut self, root: f64) {
        self.values[self.count] = root;
        self.count += 1;
    }

    pub(crate) fn into_iter(self) -> impl Iterator<Item = f64> {
        self.values.into_iter().take(self.count)
    }
}

/// The numbers in [low, high] at which a polynomial of degree 1 to 4 changes its sign or is zero at a turning point, ascending;
/// coefficients from the constant up, the leading one not 0. No roots if a bound is NaN.
///
/// Between the roots of its derivative a polynomial is monotone and has at most one root, which bracketed Newton steps find
/// (C. Yuksel, *High-performance polynomial root finding for graphics*, Proc. ACM Comput. Graph. Interact. Tech. 5(3),
/// 2022). No root is missed or found twice, except pairs closer than the rounding of the polynomial's value.
pub(crate) fn roots_between(polynomial: &[f64], low: f64, high: f64) -> Roots {
    let mut found = Roots::default();
    let degree = polynomial.len() - 1;
    if low.is_nan() || high.is_nan() || degree == 0 {
        return found;
    }
    let mut derivative = [0.0; 4];
    for power in 1..=degree {
        derivative[power - 1] = power as f64 * polynomial[power];
    }
    let turns = roots_between(&derivative[..degree], low, high);
    let value = |x: f64| evaluate(polynomial, x).0;
    let mut start = (low, value(low));
    for end in turns.into_iter().chain([high]) {
        let end = (end, value(end));
        if start.1 == 0.0 {
            found.push(start.0);
        } else if (start.1 < 0.0) != (end.1 < 0.0) && end.1 != 0.0 {
            found.push(solve(polynomial, start, end));
        }
        start = end;
    }
    if start.1 == 0.0 && found.count < degree {
        found.push(start.0);
    }
    found
}

/// The root between two points, with values of different signs, of a monotone polynomial.
fn solve(polynomial: &[f64], low: (f64, f64), high: (f64, f64)) -> f64 {
    // Bisection alone needs 53 steps to the last bit of numbers of the bracket's size.
    const MOST_STEPS: usize = 64;
    let rising = high.1 > 0.0;
    let (mut low, mut high) = (low.0, high.0);
    let mut x = f64::midpoint(low, high);
    for _ in 0..MOST_STEPS {
        let (value, slope) = evaluate(polynomial, x);
        if value == 0.0 {
            break;
        }
        if (value > 0.0) == rising {
            high = x
        } else {
            low = x
        }
        let newton = x - value / slope;
        let next = if low < newton && newton < high { newton } else { f64::midpoint(low, high) };
        if next == x {
            break;
        }
        x = next;
    }
    x
}

/// Value and slope, by Horner's scheme.
fn evaluate(polynomial: &[f64], x: f64) -> (f64, f64) {
    polynomial.iter().rev().fold((0.0, 0.0), |(value, slope), &c| (value * x + c, slope * x + value))
}
