//! Surfaces of revolution about the y axis: cylinder, cone, catenoid, torus.

use crate::num::UnitVec3;
use crate::surface::error::{SurfaceError, out_of_range, surface_of_lengths};
use crate::surface::rays::polynomial::roots_between;
use crate::surface::rays::ray::Line;
use crate::surface::shapes::chart::{Chart, Parametric, Sample, circle, on_circle};
use crate::surface::shapes::implicit::{Cast, Implicit};
use glam::{DVec2, DVec3};

fn across(v: DVec3) -> DVec3 {
    DVec3::new(v.x, 0.0, v.z)
}

fn axis_distance(point: DVec3) -> f64 {
    DVec2::new(point.x, point.z).length()
}

surface_of_lengths! {
    /// The tube x² + z² = radius², |y| ≤ height/2, open at both ends, facing outward. By default radius 1, height 2.
    ///
    /// Points: (radius·sin θ, (v − ½)·height, radius·cos θ) with θ = 2πu.
    Cylinder {
        /// The radius.
        radius: "the radius" = 1.0,
        /// From end to end.
        height: "the height" = 2.0,
    }
    new with Ok
}

impl Parametric for Cylinder {
    fn chart(&self) -> Chart {
        Chart::TUBE
    }

    fn at(&self, u: f64, v: f64) -> Option<Sample> {
        let normal = on_circle(u, 1.0, 0.0);
        let position = normal * self.radius + DVec3::Y * ((v - 0.5) * self.height);
        Some(Sample { position, normal: UnitVec3::new(normal)? })
    }
}

impl Implicit for Cylinder {
    fn value(&self, point: DVec3) -> f64 {
        across(point).length() - self.radius
    }

    fn normal_at(&self, point: DVec3) -> Option<UnitVec3> {
        UnitVec3::new(across(point))
    }
}

impl Cast for Cylinder {
    /// Roots of |p⊥ + s·d⊥|² = radius². By Lagrange's identity the discriminant is (radius·|d⊥|)² − (moment about the
    /// axis)², a difference of squares, which is computed as a product without cancellation.
    fn crossings(&self, line: &Line) -> impl Iterator<Item = f64> {
        let speed = across(line.direction).length();
        let (reach, moment) = (self.radius * speed, line.moment.y.abs());
        let discriminant = (reach - moment) * (reach + moment);
        let middle = -across(line.foot).dot(line.direction) / speed;
        let crossing = |sign: f64| (middle + sign * discriminant.sqrt() / speed) / speed;
        (speed > 0.0 && discriminant >= 0.0).then(|| [crossing(-1.0), crossing(1.0)]).into_iter().flatten()
    }

    fn reaches(&self, point: DVec3) -> bool {
        point.y.abs() <= self.height / 2.0
    }
}

surface_of_lengths! {
    /// The cone from the circle of a radius at y = −height/2 to its tip at y = +height/2, open at the base, facing
    /// outward. By default of radius 1 and height 2.
    ///
    /// Points: ((1 − v)·radius·sin θ, (v − ½)·height, (1 − v)·radius·cos θ) with θ = 2πu. At the tip, and on the axis,
    /// the surface has no normal; crease uses the limit of the mean over ever smaller circles, +y.
    Cone {
        /// The radius of the base.
        radius: "the radius" = 1.0,
        /// From the base to the tip.
        height: "the height" = 2.0,
    }
    new with Ok
}

impl Cone {
    /// The normal in the half-plane of (distance from the axis, y): the same for the whole generator.
    fn profile_normal(&self) -> DVec2 {
        let longest = self.radius.max(self.height);
        (DVec2::new(self.height, self.radius) / longest).normalize()
    }
}

impl Parametric for Cone {
    fn chart(&self) -> Chart {
        Chart { pole_high: true, ..Chart::TUBE }
    }

    fn at(&self, u: f64, v: f64) -> Option<Sample> {
        let position = on_circle(u, (1.0 - v) * self.radius, (v - 0.5) * self.height);
        Some(Sample { position, normal: self.normal_at(position)? })
    }
}

impl Implicit for Cone {
    fn value(&self, point: DVec3) -> f64 {
        self.profile_normal().dot(DVec2::new(axis_distance(point), point.y - self.height / 2.0))
    }

    fn normal_at(&self, point: DVec3) -> Option<UnitVec3> {
        let Some(across) = UnitVec3::new(across(point)) else {
            return UnitVec3::new(DVec3::Y);
        };
        let profile = self.profile_normal();
        UnitVec3::new(across.get() * profile.x + DVec3::Y * profile.y)
    }
}

impl Cast for Cone {
    /// The tip, in which the cone's equation has no linear and no constant term.
    fn centre(&self) -> DVec3 {
        DVec3::Y * (self.height / 2.0)
    }

    /// Roots of h²(x² + z²) − r²y² = 0 with slopes h and r as a unit vector. The discriminant B² − AC is r²h²(Lx² + Lz²) − h⁴Ly² in
    /// terms of the line's moment L.
    fn crossings(&self, line: &Line) -> impl Iterator<Item = f64> {
        let DVec2 { x: h, y: r } = self.profile_normal();
        let form = |p: DVec3, q: DVec3| h * h * (p.x * q.x + p.z * q.z) - r * r * (p.y * q.y);
        let (foot, direction, moment) = (line.foot, line.direction, line.moment);
        let (a, b, c) = (form(direction, direction), form(foot, direction), form(foot, foot));
        let (tilted, turned) = (r * axis_distance(moment), h * moment.y.abs());
        let root = h * ((tilted - turned) * (tilted + turned)).sqrt();
        // The larger root has no cancellation; the other one follows from their product. A line along a
        // generator has only one root, and so has a line through the tip.
        let sum = -(b + root.copysign(b));
        let [one, other] = [sum / a, if sum == 0.0 { 0.0 } else { c / sum }];
        let crossings = [one.min(other), one.max(other)];
        crossings.into_iter().filter(|s| s.is_finite())
    }

    fn reaches(&self, point: DVec3) -> bool {
        point.y.abs() <= self.height / 2.0
    }
}

surface_of_lengths! {
    /// The catenoid √(x² + z²) = waist·cosh(y/waist), |y| ≤ height/2: the film between two rings, of mean curvature zero, facing
    /// away from the axis. By default of waist 0.5 and height 1.5.
    ///
    /// Points: (waist·cosh t·sin θ, waist·t, waist·cosh t·cos θ) with θ = 2πu and t = (v − ½)·height/waist. Its
    /// [`value`](Implicit::value) is measured towards the axis, so it is a little more than the distance. The height
    /// may be at most 200 waists: beyond that the ends would be 10⁴³ times as wide as the waist.
    Catenoid {
        /// The smallest radius.
        waist: "the waist" = 0.5,
        /// From end to end.
        height: "the height" = 1.5,
    }
    new with |catenoid: Self| {
        let found = catenoid.height / catenoid.waist;
        let error = || out_of_range("the height", format!("{found} waists"), "200 at most");
        if found <= 200.0 { Ok(catenoid) } else { Err(error()) }
    }
}

impl Catenoid {
    /// The radius of the rings at the ends.
    pub fn widest(&self) -> f64 {
        self.waist * libm::cosh(0.5 * self.height / self.waist)
    }
}

impl Parametric for Catenoid {
    fn chart(&self) -> Chart {
        Chart::TUBE
    }

    fn at(&self, u: f64, v: f64) -> Option<Sample> {
        let y = (v - 0.5) * self.height;
        let t = y / self.waist;
        let position = on_circle(u, self.waist * libm::cosh(t), y);
        // The gradient (1, −sinh t) by cosh t: no number grows.
        let normal = UnitVec3::new(on_circle(u, 1.0 / libm::cosh(t), -libm::tanh(t)))?;
        Some(Sample { position, normal })
    }
}

impl Implicit for Catenoid {
    fn value(&self, point: DVec3) -> f64 {
        axis_distance(point) - self.waist * libm::cosh(point.y / self.waist)
    }

    fn normal_at(&self, point: DVec3) -> Option<UnitVec3> {
        let across = UnitVec3::new(across(point))?;
        let t = point.y / self.waist;
        UnitVec3::new(across.get() / libm::cosh(t) - DVec3::Y * libm::tanh(t))
    }
}

surface_of_lengths! {
    /// The ring torus (√(x² + z²) − R)² + y² = r² about the y axis, facing outward. By default R = 1, r = 0.4.
    ///
    /// Points: ((R + r cos φ) sin θ, r sin φ, (R + r cos φ) cos θ) with θ = 2πu around the axis and φ = 2πv around the
    /// tube. R must be larger than r.
    ///
    /// A ray's crossings are the roots of a quartic, made as exact as the surface's equation by Newton steps on the
    /// signed distance. No crossing is missed or invented unless a ray grazes the surface within about 10⁻¹⁵·R²/r.
    Torus {
        /// From the axis to the middle of the tube.
        major: "the ring's radius" = 1.0,
        /// The radius of the tube.
        minor: "the tube's radius" = 0.4,
    }
    new with |torus: Self| {
        let Self { major, minor } = torus;
        let error = || format!("the tube's radius {minor} is not smaller than the ring's radius {major}");
        if minor < major { Ok(torus) } else { Err(SurfaceError::Invalid(error())) }
    }
}

impl Torus {
    /// A crossing to full accuracy: the quartic's coefficients have the errors of R⁴, the distance those of R.
    fn polish(&self, line: &Line, mut s: f64) -> f64 {
        let mut value = self.value(line.at(s));
        for _ in 0..3 {
            let Some(normal) = self.normal_at(line.at(s)) else { break };
            let next = s - value / normal.get().dot(line.direction);
            let better = self.value(line.at(next));
            if better.abs() >= value.abs() {
                break;
            }
            (s, value) = (next, better);
        }
        s
    }
}

impl Parametric for Torus {
    fn chart(&self) -> Chart {
        Chart::RING
    }

    fn at(&self, u: f64, v: f64) -> Option<Sample> {
        let (up, out) = circle(v);
        let position = on_circle(u, self.major + self.minor * out, self.minor * up);
        Some(Sample { position, normal: UnitVec3::new(on_circle(u, out, up))? })
    }
}

impl Implicit for Torus {
    fn value(&self, point: DVec3) -> f64 {
        DVec2::new(axis_distance(point) - self.major, point.y).length() - self.minor
    }

    fn normal_at(&self, point: DVec3) -> Option<UnitVec3> {
        // From the closest point of the tube's middle circle; there is none on the axis.
        let across = UnitVec3::new(across(point))?;
        UnitVec3::new(point - across.get() * self.major)
    }
}

impl Cast for Torus {
    /// With k = |p|² + R² − r² on a line p + s·d whose foot p is perpendicular to d, the torus (|x|² + R² − r²)² =
    /// 4R²(x² + z²) becomes (s² + k)² − 4R²(a s² + 2b s + c) = 0: a quartic in s without a cubic term.
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
    use crate::surface::rays::ray::Ray;

    /// Such a line crosses the tube where the search for roots begins and ends.
    #[test]
    fn lines_through_the_centre_hit_the_outer_rim_first() {
        for (major, minor) in [(2.0, 0.5), (1.0, 0.1), (3.0, 2.9), (0.7, 0.3)] {
            let torus = Torus::new(major, minor).unwrap();
            for step in 0..100 {
                let direction = circle(f64::from(step) / 100.0);
                let towards = DVec3::new(direction.0, 0.0, direction.1).normalize();
                let hit = torus.first_hit(&Ray::new(towards * -1e3, towards).unwrap()).unwrap();
                assert!(hit.front && (hit.position.length() - (major + minor)).abs() < 1e-14, "{hit:?}");
            }
        }
    }
}
