//! Histograms of angles between normals, and orders of convergence.

use crate::num::{Degrees, Radians};
use serde::Serialize;

pub use crate::num::{AngleErrors, angle_between};

/// The distribution of errors: shares of all, in quarters of a decade from 10⁻⁸ to 10² degrees.
#[derive(Clone, Debug, Default, PartialEq, Serialize)]
pub struct Histogram {
    /// The share of errors in each bin; the first one includes smaller errors, the last one larger ones.
    pub shares: Vec<f64>,
}

impl Histogram {
    const BINS: usize = 40;
    const LOWEST: f64 = -8.0;

    /// Sorts angles into bins.
    pub fn of(angles: &[Radians]) -> Self {
        let mut counts = vec![0_u32; Self::BINS];
        for &angle in angles {
            let place = 4.0 * (libm::log10(Degrees::from(angle).0) - Self::LOWEST);
            // The logarithm of 0 is −∞: the first bin.
            counts[(place.max(0.0) as usize).min(Self::BINS - 1)] += 1;
        }
        let all = angles.len().max(1) as f64;
        Self { shares: counts.into_iter().map(|count| f64::from(count) / all).collect() }
    }

    /// The edges of the bins, in degrees.
    pub fn edges() -> impl Iterator<Item = f64> {
        (0..=Self::BINS).map(|bin| libm::exp10(Self::LOWEST + bin as f64 / 4.0))
    }
}

/// The middle one, or the mean of the two in the middle; `None` for an empty list.
pub(super) fn median(mut numbers: Vec<f64>) -> Option<f64> {
    numbers.sort_by(f64::total_cmp);
    let middle = numbers.len() / 2;
    let upper = *numbers.get(middle)?;
    Some(if numbers.len() % 2 == 1 { upper } else { f64::midpoint(numbers[middle - 1], upper) })
}

/// The order of convergence: minus the slope of log₂ error over the number of halvings, by least squares. `None` for fewer
/// than four meshes (three halvings), and where there is no error to speak of (below 10⁻⁹).
pub fn order_of_convergence(errors: &[f64]) -> Option<f64> {
    const NOTHING: f64 = 1e-9;
    if errors.len() < 4 || errors.iter().any(|&error| !(error > NOTHING && error.is_finite())) {
        return None;
    }
    let middle = (errors.len() - 1) as f64 / 2.0;
    let (mut slope, mut spread) = (0.0, 0.0);
    for (halvings, &error) in errors.iter().enumerate() {
        let from_middle = halvings as f64 - middle;
        slope += from_middle * libm::log2(error);
        spread += from_middle * from_middle;
    }
    Some(-slope / spread)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn bins_take_every_angle() {
        let angles = [0.0, 1e-12, 0.5, 0.5, 179.0].map(|angle| Radians::from(Degrees(angle)));
        let shares = Histogram::of(&angles).shares;
        let edges: Vec<f64> = Histogram::edges().collect();
        assert_eq!((shares.len(), edges.len()), (40, 41));
        assert_eq!((shares[0], shares[39]), (0.4, 0.2));
        let bin = shares.iter().position(|&share| share == 0.4 && share != shares[39]).unwrap();
        assert_eq!(bin, 0);
        let half = (1..39).find(|&bin| shares[bin] > 0.0).unwrap();
        assert!((edges[half]..edges[half + 1]).contains(&0.5));
    }

    #[test]
    fn orders_are_those_of_powers() {
        let falling = |order: i32| (0..4).map(|k| 3.0 * libm::ldexp(1.0, -order * k)).collect::<Vec<_>>();
        for order in 0..4 {
            assert_eq!(order_of_convergence(&falling(order)), Some(f64::from(order)));
        }
        assert_eq!(order_of_convergence(&falling(1)[..3]), None);
        assert_eq!(order_of_convergence(&[1e-14; 4]), None);
    }

    #[test]
    fn medians_are_in_the_middle() {
        assert_eq!(median(vec![5.0, 1.0, 2.0]), Some(2.0));
        assert_eq!(median(vec![4.0, 1.0, 2.0, 9.0]), Some(3.0));
        assert_eq!(median(Vec::new()), None);
    }
}
