//! Statistics of angles: mean, root mean square and percentiles.

use crate::num::{CompensatedSum, Degrees, Radians};
use serde::Serialize;

/// Statistics of angles, such as errors of normals, in degrees.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize)]
pub struct AngleErrors {
    /// How many there are.
    pub count: usize,
    /// The mean.
    pub mean: f64,
    /// The root of the mean square.
    pub rms: f64,
    /// Half of them are not larger (nearest rank).
    pub median: f64,
    /// 95 of 100 are not larger (nearest rank).
    pub p95: f64,
    /// 99 of 100 are not larger (nearest rank).
    pub p99: f64,
    /// The largest.
    pub max: f64,
}

impl AngleErrors {
    /// The statistics of angles, summed in their order, so that the same list gives the same bits. All 0 for an empty one.
    pub fn of(angles: &[Radians]) -> Self {
        let (mut sum, mut squares) = (CompensatedSum::default(), CompensatedSum::default());
        let mut degrees: Vec<f64> = angles.iter().map(|&angle| Degrees::from(angle).0).collect();
        for &angle in &degrees {
            sum += angle;
            squares += angle * angle;
        }
        let count = degrees.len();
        if count == 0 {
            return Self::default();
        }
        let rank = |share: f64| {
            let place = ((share * count as f64).ceil() as usize).clamp(1, count) - 1;
            *degrees.select_nth_unstable_by(place, f64::total_cmp).1
        };
        let [median, p95, p99, max] = [0.5, 0.95, 0.99, 1.0].map(rank);
        let mean = |sum: CompensatedSum| sum.value() / count as f64;
        Self { count, mean: mean(sum), rms: mean(squares).sqrt(), median, p95, p99, max }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn statistics_of_few_angles() {
        let angles: Vec<Radians> = [3.0, 1.0, 2.0, 10.0].map(|angle| Radians::from(Degrees(angle))).to_vec();
        let errors = AngleErrors::of(&angles);
        let close = |a: f64, b: f64| (a - b).abs() < 1e-13;
        assert!(close(errors.mean, 4.0) && close(errors.rms, (114.0_f64 / 4.0).sqrt()));
        assert!(close(errors.median, 2.0) && close(errors.p99, 10.0) && close(errors.max, 10.0));
        assert_eq!((errors.count, AngleErrors::of(&[])), (4, AngleErrors::default()));
        let hundred: Vec<Radians> = (1..=200).map(|k| Radians::from(Degrees(f64::from(k)))).collect();
        let errors = AngleErrors::of(&hundred);
        assert!(close(errors.p95, 190.0) && close(errors.p99, 198.0));
    }
}
