//! A torus.

use crate::num::UnitVec3;
use crate::surface::error::{SurfaceError, length};
use crate::surface::rays::polynomial::roots_between;
use crate::surface::rays::ray::{Hit, Line, Ray};
use crate::surface::shapes::chart::{Chart, Parametric, Sample, circle};
use crate::surface::shapes::implicit::{Cast, Implicit, first_hit};
use glam::{DVec2, DVec3};

/// The ring torus (√(x² + z²) − R)² + y² = r² about the y axis, facing outward. By default R = 1, r = 0.4.
///
/// Points: ((R + r cos φ) sin θ, r sin φ, (R + r cos φ) cos θ) with θ = 2πu round the axis and φ = 2πv round the tube.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Torus {
    major: f64,
    minor: f64,
}

impl Default for Torus {
    fn default() -> Self {
        Self { major: 1.0, minor: 0.4 }
    }
}

impl Torus {
    /// A torus by the radius of the ring, from the axis to the middle of the tube, and the smaller one of the tube.
    ///
    /// # Errors
    /// [`SurfaceError::Length`], [`SurfaceError::SelfCrossing`].
    pub fn new(major: f64, minor: f64) -> Result<Self, SurfaceError> {
        let torus =
            Self { major: length("the ring's radius", major)?, minor: length("the tube's radius", minor)? };
        if minor < major { Ok(torus) } else { Err(SurfaceError::SelfCrossing { major, minor }) }
    }

    /// From the axis to the middle of the tube.
    pub fn major(&self) -> f64 {
        self.major
    }

    /// The radius of the tube.
    pub fn minor(&self) -> f64 {
        self.minor
    }

    /// The first hit of a ray.
    ///
    /// The crossings are the roots of a quartic, separated by the roots of its derivatives and found in between by
    /// bracketed Newton steps, which neither misses nor invents one unless a ray grazes the surface within about
    /// 10⁻¹⁵·R²/r; then Newton steps on the signed distance make them as exact as the surface's own equation.
    pub fn intersect(&self, ray: &Ray) -> Option<Hit> {
        first_hit(self, ray)
    }

    /// What leads here from the closest point of the tube's middle circle; `None` on the axis.
    fn across_tube(&self, point: DVec3) -> Option<DVec3> {
        let across = UnitVec3::new(DVec3::new(point.x, 0.0, point.z))?;
        Some(point - across.get() * self.major)
    }

    /// A crossing to full accuracy: the quartic's coefficients have the errors of R⁴, the distance those of R.
    fn polish(&self, line: &Line, mut s: f64) -> f64 {
        let mut value = self.value(line.at(s));
        for _ in 0..3 {
            let Some(normal) = self.normal_at(line.at(s)) else { break };
            let next = s - value / normal.get().dot(line.direction);
            let better = self.value(line.at(next));
            if better.abs() < value.abs() {
                (s, value) = (next, better);
            } else {
                break;
            }
        }
        s
    }
}

impl Parametric for Torus {
    fn chart(&self) -> Chart {
        Chart::RING
    }

    fn at(&self, u: f64, v: f64) -> Option<Sample> {
        let ((sin, cos), (up, out)) = (circle(u), circle(v));
        let radius = self.major + self.minor * out;
        let normal = UnitVec3::new(DVec3::new(out * sin, up, out * cos))?;
        Some(Sample { position: DVec3::new(radius * sin, self.minor * up, radius * cos), normal })
    }
}

impl Implicit for Torus {
    fn value(&self, point: DVec3) -> f64 {
        let ring = DVec2::new(point.x, point.z).length() - self.major;
        DVec2::new(ring, point.y).length() - self.minor
    }

    fn normal_at(&self, point: DVec3) -> Option<UnitVec3> {
        UnitVec3::new(self.across_tube(point)?)
    }
}

impl Cast for Torus {
    /// With k = |p|² + R² − r² on a line p + s·d whose foot p is perpendicular to d, the torus
    /// (|x|² + R² − r²)² = 4R²(x² + z²) becomes (s² + k)² − 4R²(a s² + 2b s + c) = 0: a quartic in s without a cubic
    /// term.
    fn crossings(&self, line: &Line) -> impl Iterator<Item = f64> {
        let (major, minor) = (self.major, self.minor);
        // In units of the outer radius no power leaves the range.
        let outer = major + minor;
        let (ring, tube) = (major / outer, minor / outer);
        let (foot, direction) = (line.foot / outer, line.direction);
        let distance = foot.length();
        // The ball around the torus, and a little more: a root at its very rim must show as a change of sign.
        let reach = 1.0 + 1e-6;
        let half = ((reach - distance) * (reach + distance)).sqrt();
        let flat = |p: DVec3, q: DVec3| p.x * q.x + p.z * q.z;
        let (a, b, c) = (flat(direction, direction), flat(foot, direction), flat(foot, foot));
        let k = distance * distance + (ring - tube) * (ring + tube);
        let gap = c.sqrt() - ring;
        // k² − 4R²c by its factors, the first of which is the equation of the torus at the foot.
        let constant = (gap * gap + (foot.y - tube) * (foot.y + tube)) * (k + 2.0 * ring * c.sqrt());
        let square = 2.0 * (k - 2.0 * ring * ring * a);
        let quartic = [constant, -8.0 * ring * ring * b, square, 0.0, 1.0];
        // A line that misses the ball around the torus has no half: NaN, and no roots.
        let roots = roots_between(&quartic, -half, half);
        roots.into_iter().map(move |s| self.polish(line, s * outer))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Such a line crosses the tube where the search for roots begins and ends.
    #[test]
    fn lines_through_the_centre_hit_the_outer_rim_first() {
        for (major, minor) in [(2.0, 0.5), (1.0, 0.1), (3.0, 2.9), (0.7, 0.3)] {
            let torus = Torus::new(major, minor).unwrap();
            for step in 0..100 {
                let direction = circle(f64::from(step) / 100.0);
                let towards = DVec3::new(direction.0, 0.0, direction.1).normalize();
                let hit = torus.intersect(&Ray::new(towards * -1e3, towards).unwrap()).unwrap();
                assert!(hit.front && (hit.position.length() - (major + minor)).abs() < 1e-14, "{hit:?}");
            }
        }
    }
}
