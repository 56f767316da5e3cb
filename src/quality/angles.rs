//! Angles in degrees, and comparisons with a limit that need no arc tangent where the cosine decides.

use crate::num::{Degrees, angle_between};
use glam::DVec3;

/// The angle between two directions, in degrees.
pub(crate) fn degrees_between(a: DVec3, b: DVec3) -> f64 {
    Degrees::from(angle_between(a, b)).0
}

/// Two normals closer than this, in degrees, count as the same: more than 8 bits do to each of them.
pub(crate) const SAME: f64 = 1.0;

/// Cosines of unit vectors are right to a few 10⁻¹⁶; this is far above.
const MARGIN: f64 = 1e-12;

/// An angle that very many others are compared with.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Limit {
    degrees: f64,
    /// Above it the angle is certainly smaller.
    cosine: f64,
}

impl Limit {
    pub(crate) fn new(degrees: f64) -> Self {
        let cosine = if degrees < 180.0 { libm::cos(degrees.to_radians()) + MARGIN } else { -2.0 };
        Self { degrees, cosine }
    }

    /// The angle in degrees between two unit vectors if it is above the limit.
    pub(crate) fn exceeded(self, a: DVec3, b: DVec3) -> Option<f64> {
        if a.dot(b) > self.cosine {
            return None;
        }
        Some(degrees_between(a, b)).filter(|&degrees| degrees > self.degrees)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn cosines_and_arc_tangents_agree() {
        for limit in [0.0, 1e-6, 0.3, 15.0, 90.0, 170.0, 180.0] {
            for step in [-1e-7, 1e-7] {
                let degrees: f64 = limit + step;
                let (sine, cosine) = libm::sincos(degrees.to_radians());
                let (limit, other) = (Limit::new(limit), DVec3::new(cosine, sine, 0.0));
                let found = limit.exceeded(DVec3::X, other);
                let is_above = degrees.abs() > limit.degrees && degrees < 180.0;
                assert_eq!(found.is_some(), is_above, "{degrees} against {}", limit.degrees);
                assert!(found.is_none_or(|it| (it - degrees.abs()).abs() < 1e-12));
            }
        }
    }
}
