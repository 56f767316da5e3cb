//! The crease test: is the dihedral angle over the limit?

use crate::num::Degrees;
use glam::DVec3;

/// The most that is added to a crease angle, in degrees.
pub(crate) const SLACK_DEGREES: f64 = 0.01;

/// By how much a dihedral angle may exceed a crease angle before the edge is sharp, so that a chamfer modelled exactly at it
/// stays smooth when positions hold five digits or more relative to its edges: 0.01°, or a tenth of the angle if that is
/// less, so that small angles keep their meaning.
pub fn crease_slack(Degrees(angle): Degrees) -> Degrees {
    Degrees(SLACK_DEGREES.min(angle / 10.0))
}

/// Edges this close to the crease angle, in degrees, are counted in the report: a small change of the angle or
/// of the model turns them over.
const NEAR_DEGREES: f64 = 0.1;

/// Most by which the dot product of two unit normals in f64 can differ from the cosine of their angle: both are
/// rounded (3 × 2⁻⁵³ each) and so are three products and two sums; 2⁻⁴⁸ leaves room for all of it.
const DOT_ERROR: f64 = 1.0 / (1u64 << 48) as f64;

/// Compares angles between unit normals with a limit.
///
/// The verdict is that of `atan2(|a×b|, a·b)`. The dot product only serves as a filter: where it is further from
/// the limit's cosine than its own error, it settles the matter, and the arc tangent is not computed.
#[derive(Clone, Copy, Debug)]
pub(crate) struct AngleLimit {
    radians: f64,
    surely_over: f64,
    surely_under: f64,
}

impl AngleLimit {
    /// A limit in degrees.
    pub(crate) fn degrees(degrees: f64) -> Self {
        let radians = degrees.to_radians();
        let cosine = libm::cos(radians.clamp(0.0, std::f64::consts::PI));
        Self { radians, surely_over: cosine - DOT_ERROR, surely_under: cosine + DOT_ERROR }
    }

    /// Whether the angle between two unit vectors is over the limit.
    #[inline]
    pub(crate) fn exceeded(&self, a: DVec3, b: DVec3) -> bool {
        let dot = a.dot(b);
        if dot > self.surely_under {
            false
        } else if dot < self.surely_over {
            true
        } else {
            libm::atan2(a.cross(b).length(), dot) > self.radians
        }
    }

    /// Whether the filter alone shows that the angle is not over the limit.
    #[inline]
    pub(crate) fn surely_within(&self, a: DVec3, b: DVec3) -> bool {
        a.dot(b) > self.surely_under
    }

    /// Whether the angle between two vectors of any length is over the limit.
    pub(crate) fn exceeded_by_any(&self, a: DVec3, b: DVec3) -> bool {
        libm::atan2(a.cross(b).length(), a.dot(b)) > self.radians
    }
}

/// Shows of most edges, by a dot product alone, that they are smooth.
#[derive(Clone, Copy, Debug)]
pub(crate) struct AngleFilter {
    surely_under: f64,
    /// As above, for edges that are not near the crease angle either, whatever rounding does.
    cosine: f64,
}

impl AngleFilter {
    /// Whether the angle between two unit normals is surely under the limit; and, if edges near the limit matter, under what
    /// counts as near. `turn`: by how many radians rounding may have turned the two: the cosine changes by no more.
    #[inline(always)]
    pub(crate) fn is_surely_within(&self, a: DVec3, b: DVec3, turn: f64) -> bool {
        let dot = a.dot(b);
        dot > self.surely_under && (turn == 0.0 || dot > self.cosine + turn)
    }
}

/// A crease angle between 0° (every edge is hard) and 180° (none is).
#[derive(Clone, Copy, Debug)]
pub(crate) enum CreaseTest {
    /// 0°: every edge is hard.
    Every,
    /// 180°, or smoothing groups decide alone: no edge is hard for its angle.
    None,
    /// In between.
    Over {
        /// The angle with its slack.
        limit: AngleLimit,
        /// Below and above the angle by what counts as near.
        near: [AngleLimit; 2],
        /// The angle itself, in radians.
        radians: f64,
    },
}

impl CreaseTest {
    /// The test for an angle; `None` tests nothing.
    pub(crate) fn new(angle: Option<Degrees>) -> Self {
        match angle {
            None => Self::None,
            Some(Degrees(angle)) if angle <= 0.0 => Self::Every,
            Some(Degrees(angle)) if angle >= 180.0 => Self::None,
            Some(Degrees(angle)) => Self::Over {
                limit: AngleLimit::degrees(angle + crease_slack(Degrees(angle)).0),
                near: [AngleLimit::degrees(angle - NEAR_DEGREES), AngleLimit::degrees(angle + NEAR_DEGREES)],
                radians: angle.to_radians(),
            },
        }
    }

    /// The filter of the test; `None` where no edge is hard for its angle.
    pub(crate) fn filter(&self, with_near: bool) -> Option<AngleFilter> {
        let Self::Over { limit, near: [low, _], radians } = self else { return None };
        let lower = if with_near { low } else { limit };
        Some(AngleFilter { surely_under: lower.surely_under, cosine: libm::cos(*radians) + DOT_ERROR })
    }

    /// Whether an edge between faces of these unit normals is over the crease angle.
    pub(crate) fn is_over(&self, a: DVec3, b: DVec3) -> bool {
        match self {
            Self::Every => true,
            Self::None => false,
            Self::Over { limit, .. } => limit.exceeded(a, b),
        }
    }

    /// Whether an edge between faces of these unit normals is near the crease angle.
    pub(crate) fn is_near(&self, a: DVec3, b: DVec3) -> bool {
        matches!(self, Self::Over { near: [low, high], .. } if low.exceeded(a, b) && !high.exceeded(a, b))
    }

    /// Whether it is near, or could be at the angle if the two normals were turned by so many radians in all.
    pub(crate) fn is_near_if_turned(&self, a: DVec3, b: DVec3, turned: f64) -> bool {
        let Self::Over { radians, .. } = self else { return false };
        let could_be = || (libm::atan2(a.cross(b).length(), a.dot(b)) - radians).abs() <= turned;
        self.is_near(a, b) || could_be()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The filter must never contradict the arc tangent, close to the limit above all.
    #[test]
    fn the_filter_agrees_with_the_arc_tangent() {
        for degrees in [1e-6, 0.01, 0.5, 40.01, 90.0, 179.0, 179.9999] {
            let limit = AngleLimit::degrees(degrees);
            let at = f64::to_radians(degrees);
            for step in -2000..2000 {
                let angle = at + f64::from(step) * f64::from(step).abs() * 1e-19 * (1.0 + at);
                let b = DVec3::new(libm::cos(angle), libm::sin(angle), 0.0);
                let expected = libm::atan2(DVec3::X.cross(b).length(), DVec3::X.dot(b)) > at;
                assert_eq!(limit.exceeded(DVec3::X, b), expected, "{degrees} {step}");
            }
        }
    }

    #[test]
    fn what_rounding_may_have_turned_is_near() {
        let test = CreaseTest::new(Some(Degrees(40.0)));
        let at = |degrees: f64| {
            let angle = degrees.to_radians();
            DVec3::new(libm::cos(angle), libm::sin(angle), 0.0)
        };
        for (degrees, turned, is_near) in
            [(40.05, 0.0, true), (40.5, 0.4, false), (40.5, 0.6, true), (39.5, 0.6, true), (39.5, 0.4, false)]
        {
            assert_eq!(
                test.is_near_if_turned(DVec3::X, at(degrees), f64::to_radians(turned)),
                is_near,
                "{degrees} {turned}"
            );
        }
        assert!(!CreaseTest::new(None).is_near_if_turned(DVec3::X, at(40.0), 1.0));
    }

    #[test]
    fn a_chamfer_at_the_angle_stays_smooth() {
        let test = CreaseTest::new(Some(Degrees(45.0)));
        let CreaseTest::Over { limit, .. } = test else { panic!("45° is tested") };
        let chamfer = |degrees: f64| {
            let angle = degrees.to_radians();
            DVec3::new(libm::cos(angle), libm::sin(angle), 0.0)
        };
        assert!(!limit.exceeded(DVec3::X, chamfer(45.009)));
        // A small angle has little slack: 0.005° is five times over 0.001°.
        let small = CreaseTest::new(Some(Degrees(0.001)));
        assert!(small.is_over(DVec3::X, chamfer(0.005)) && small.is_over(DVec3::X, chamfer(0.00111)));
        assert!(!small.is_over(DVec3::X, chamfer(0.00109)));
        assert!(limit.exceeded(DVec3::X, chamfer(45.011)));
        assert!(test.is_near(DVec3::X, chamfer(44.95)) && test.is_near(DVec3::X, chamfer(45.05)));
        assert!(!test.is_near(DVec3::X, chamfer(44.85)) && !test.is_near(DVec3::X, chamfer(45.15)));
    }
}
