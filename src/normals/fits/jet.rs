//! The osculating jet of degree 3: third order in the edge length, on surfaces without noise.

use crate::normals::fits::fitted_normals::FitFailures;
use crate::normals::fits::polynomial::Polynomial;
use crate::num::Pivoting;

/// The smallest distance of a column from the span of those before it: condition numbers above 2²⁴ are refused.
const NEAREST: f64 = 1.0 / (1 << 24) as f64;

/// The polynomial of degree 3 through a vertex that fits its neighbours best, with rows 1/d² (F. Cazals, M. Pouget, *Estimating
/// differential quantities using polynomial fitting of osculating jets*, CAGD 22(2), 2005), and that of degree 2 for where there
/// is none. Each takes at least 1.5 times as many neighbours as it has unknowns.
pub(crate) const JET: [Polynomial; 2] = [
    Polynomial { degree: 3, weighted: true, fewest: 14, nearest: NEAREST, pivoting: Pivoting::Columns },
    Polynomial { degree: 2, weighted: true, fewest: 8, nearest: NEAREST, pivoting: Pivoting::Columns },
];

/// How many normals of [`Weight::Jet`](crate::normals::Weight::Jet) are of lower order, by the reason.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, serde::Serialize)]
pub struct JetFallbacks {
    /// Without a fit of degree 3.
    pub degree_3: FitFailures,
    /// Of these, those without a fit of degree 2 as well, which are the angle mean.
    pub degree_2: FitFailures,
}
