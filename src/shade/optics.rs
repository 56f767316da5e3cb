//! Reflection and refraction at a smooth surface (F2, F29).
//!
//! Refractive indices are positive; angles of incidence are measured from the normal, 0 to 90°.

use super::error::{Place, ShadeError};
use crate::num::{LinearRgb, Radians};
use glam::DVec3;

/// A surface that reflects like a mirror or transmits light, for rays that are traced.
///
/// Outside, the surface adds `reflect` times the light from the mirrored direction to its local colour, and `transmit`
/// times the light through a smooth surface: Fresnel's share from the mirrored direction, the rest from the refracted one.
/// Inside, it has no colour of its own and reflects Fresnel's share without any loss.
///
/// ```
/// use crease::num::LinearRgb;
/// use crease::shade::Optics;
///
/// let glass = Optics { transmit: LinearRgb::WHITE, ior: 1.5, ..Optics::NONE };
/// assert!(glass.transmits() && glass.check().is_ok());
/// assert!(Optics { ior: 0.5, ..glass }.check().is_err());
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Optics {
    /// The share of mirrored light, 0 or more.
    pub reflect: LinearRgb,
    /// The share of light that passes through the body once, 0 or more, without absorption.
    pub transmit: LinearRgb,
    /// The refractive index relative to air, 1 or more.
    pub ior: f64,
    /// a, 0 or more for each unit of length in the scene: after a distance d inside, e^(−a d) is left (Beer's law).
    pub absorb: LinearRgb,
}

impl Default for Optics {
    fn default() -> Self {
        Self::NONE
    }
}

impl Optics {
    /// Neither mirrored nor transmitted light; the index is that of glass.
    pub const NONE: Self = Self {
        reflect: LinearRgb::BLACK,
        transmit: LinearRgb::BLACK,
        ior: Self::GLASS,
        absorb: LinearRgb::BLACK,
    };

    /// The refractive index where none is given, as in glTF.
    pub const GLASS: f64 = 1.5;

    /// Whether light passes through.
    pub fn transmits(&self) -> bool {
        self.transmit != LinearRgb::BLACK
    }

    /// Whether rays that meet the surface go on.
    pub fn continues(&self) -> bool {
        self.transmits() || self.reflect != LinearRgb::BLACK
    }

    /// The share of light that is neither mirrored nor transmitted, in the component with the most of both; at least 0.
    pub fn opaque_share(&self) -> f64 {
        (1.0 - (self.reflect + self.transmit).largest()).max(0.0)
    }

    /// The share of light that is left after a distance inside.
    pub fn transmittance(&self, distance: f64) -> LinearRgb {
        LinearRgb::from(self.absorb.to_array().map(|a| if a == 0.0 { 1.0 } else { libm::exp(-a * distance) }))
    }

    /// Whether every number is valid.
    ///
    /// # Errors
    /// A share or absorption that is negative or not finite, and an index below 1 or not finite.
    pub fn check(&self) -> Result<(), ShadeError> {
        let place = Place::Material;
        place.colour("reflect", self.reflect)?;
        place.colour("transmit", self.transmit)?;
        place.colour("absorb", self.absorb)?;
        match self.ior >= 1.0 && self.ior.is_finite() {
            true => Ok(()),
            false => {
                Err(place.error("ior", self.ior.to_string(), "a refractive index, 1 or more and finite"))
            }
        }
    }
}

/// R = 2N(N·L) − L: the mirror direction of L at a surface with the unit normal N (F5). L and R have the same angle to
/// N and lie in one plane with it (F2).
///
/// ```
/// use crease::shade::reflect;
/// use glam::DVec3;
///
/// assert_eq!(reflect(DVec3::Y, DVec3::new(-0.8, 0.6, 0.0)), DVec3::new(0.8, 0.6, 0.0));
/// ```
pub fn reflect(normal: DVec3, towards: DVec3) -> DVec3 {
    normal * (2.0 * normal.dot(towards)) - towards
}

/// The direction of a light ray after refraction: n1 sin θ = n2 sin θ″ (Snell).
///
/// `normal` is the unit normal. `towards` is the unit vector from the surface to the light, on the side of the normal,
/// in the medium of index n1. The result is a unit vector that points into the medium of index n2, behind the surface.
/// `None` for total reflection, and if `towards` points below the surface.
pub fn refract(normal: DVec3, towards: DVec3, n1: f64, n2: f64) -> Option<DVec3> {
    let cosine = normal.dot(towards);
    if cosine.is_nan() || cosine < 0.0 {
        return None;
    }
    let ratio = n1 / n2;
    // The component along the surface determines that along the normal.
    let along = (normal * cosine - towards) * ratio;
    let left = 1.0 - along.length_squared();
    (left >= 0.0).then(|| along - normal * left.sqrt())
}

/// The angle of refraction θ″ with n1 sin θ = n2 sin θ″. `None` for total reflection, and outside 0 to 90°.
///
/// ```
/// use crease::num::{Degrees, Radians};
/// use crease::shade::refraction_angle;
///
/// let into_glass = refraction_angle(1.0, 1.5, Radians::from(Degrees(30.0))).unwrap();
/// assert!((Degrees::from(into_glass).0 - 19.471_220_634).abs() < 1e-9);
/// assert_eq!(refraction_angle(1.5, 1.0, Radians::from(Degrees(42.0))), None);
/// ```
pub fn refraction_angle(n1: f64, n2: f64, incidence: Radians) -> Option<Radians> {
    let (sine, cosine) = refracted(n1, n2, incidence)?;
    Some(Radians(libm::atan2(sine, cosine)))
}

/// The smallest angle of incidence from which all light is reflected: sin θ = n2/n1. `None` unless n1 > n2.
/// From 1.5 to 1: 41.8103°.
pub fn critical_angle(n1: f64, n2: f64) -> Option<Radians> {
    (n1 > n2).then(|| Radians(libm::atan2(n2, ((n1 - n2) * (n1 + n2)).sqrt())))
}

/// The angle of incidence at which no light polarised in the plane of incidence is reflected: tan θ = n2/n1.
/// From 1 to 1.5: 56.3099°.
pub fn brewster_angle(n1: f64, n2: f64) -> Radians {
    Radians(libm::atan2(n2, n1))
}

/// The reflected share of light, by polarisation.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Fresnel {
    /// Polarised at right angles to the plane of incidence.
    pub s: f64,
    /// Polarised in it.
    pub p: f64,
}

impl Fresnel {
    /// R of unpolarised light: the mean.
    pub fn reflected(self) -> f64 {
        0.5 * (self.s + self.p)
    }

    /// T = 1 − R: the rest is transmitted (F1 without absorption).
    pub fn transmitted(self) -> f64 {
        1.0 - self.reflected()
    }
}

/// Fresnel's reflectance of a smooth surface between two transparent media, R = f(n1, n2, θ):
/// s = ((n1 cos θ − n2 cos θ″)/(n1 cos θ + n2 cos θ″))², p = ((n1 cos θ″ − n2 cos θ)/(n1 cos θ″ + n2 cos θ))².
/// Everything is reflected beyond the critical angle. Outside 0 to 90° the answer is NaN.
///
/// ```
/// use crease::num::Radians;
/// use crease::shade::fresnel;
///
/// // R0 of glass.
/// assert!((fresnel(1.0, 1.5, Radians(0.0)).reflected() - 0.04).abs() < 1e-16);
/// ```
pub fn fresnel(n1: f64, n2: f64, incidence: Radians) -> Fresnel {
    if !is_incidence(incidence) {
        return Fresnel { s: f64::NAN, p: f64::NAN };
    }
    if n1 == n2 {
        // No surface: at 90° the quotients are 0/0.
        return Fresnel { s: 0.0, p: 0.0 };
    }
    let Some((_, refracted)) = refracted(n1, n2, incidence) else { return Fresnel { s: 1.0, p: 1.0 } };
    let cosine = libm::cos(incidence.0);
    let part = |a: f64, b: f64| ((a - b) / (a + b)) * ((a - b) / (a + b));
    Fresnel { s: part(n1 * cosine, n2 * refracted), p: part(n1 * refracted, n2 * cosine) }
}

fn is_incidence(Radians(angle): Radians) -> bool {
    (0.0..=std::f64::consts::FRAC_PI_2).contains(&angle)
}

/// Sine and cosine of the angle of refraction.
fn refracted(n1: f64, n2: f64, incidence: Radians) -> Option<(f64, f64)> {
    if !is_incidence(incidence) {
        return None;
    }
    let sine = n1 / n2 * libm::sin(incidence.0);
    (sine <= 1.0).then(|| (sine, ((1.0 - sine) * (1.0 + sine)).sqrt()))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::num::test_numbers::Numbers;
    use crate::num::{Degrees, UnitVec3};

    fn degrees(angle: Radians) -> f64 {
        Degrees::from(angle).0
    }

    fn at(angle: f64) -> Radians {
        Degrees(angle).into()
    }

    #[test]
    fn published_figures_of_glass() {
        assert!((degrees(brewster_angle(1.0, 1.5)) - 56.309_932_474).abs() < 1e-9);
        assert!((degrees(critical_angle(1.5, 1.0).unwrap()) - 41.810_314_896).abs() < 1e-9);
        assert_eq!(critical_angle(1.0, 1.5), None);
        let at_brewster = fresnel(1.0, 1.5, brewster_angle(1.0, 1.5));
        // s = ((n²−1)/(n²+1))² there.
        assert!(at_brewster.p < 1e-30 && (at_brewster.s - (1.25_f64 / 3.25) * (1.25 / 3.25)).abs() < 1e-15);
        // cos 90° is 6e-17.
        assert!((fresnel(1.0, 1.5, at(90.0)).reflected() - 1.0).abs() < 1e-15);
        assert_eq!(fresnel(1.5, 1.0, at(41.9)), Fresnel { s: 1.0, p: 1.0 });
        assert!(fresnel(1.5, 1.0, at(41.8)).transmitted() > 0.1);
        assert_eq!(fresnel(1.3, 1.3, at(90.0)).transmitted(), 1.0);
        assert!(fresnel(1.0, 1.5, at(91.0)).reflected().is_nan());
    }

    #[test]
    fn directions_keep_the_plane_and_the_laws() {
        let mut numbers = Numbers::new(41);
        for _ in 0..2000 {
            let mut unit = || {
                let [x, y, z] = [(); 3].map(|()| numbers.unit() * 2.0 - 1.0);
                UnitVec3::new(DVec3::new(x, y, z)).unwrap().get()
            };
            let normal = unit();
            let towards = unit();
            let towards = if towards.dot(normal) < 0.0 { -towards } else { towards };
            let mirrored = reflect(normal, towards);
            let plane = normal.cross(towards);
            // Some ten roundings of numbers below 2.
            assert!((mirrored.dot(normal) - towards.dot(normal)).abs() < 3e-15);
            assert!(mirrored.dot(plane).abs() < 3e-15 && (mirrored.length() - 1.0).abs() < 3e-15);
            let onwards = refract(normal, towards, 1.0, 1.5).unwrap();
            assert!((onwards.length() - 1.0).abs() < 3e-15 && onwards.dot(plane).abs() < 3e-15);
            assert!((onwards.cross(normal).length() * 1.5 - plane.length()).abs() < 3e-15);
            let incidence = Radians(libm::atan2(plane.length(), towards.dot(normal)));
            let angle = refraction_angle(1.0, 1.5, incidence).unwrap();
            let between = libm::atan2(onwards.cross(-normal).length(), onwards.dot(-normal));
            assert!((angle.0 - between).abs() < 1e-14);
            // The way back is the same way, with the same reflectance.
            let back = refract(-normal, -onwards, 1.5, 1.0);
            assert!(back.is_none_or(|back| back.distance(-towards) < 1e-7));
            let (there, returned) = (fresnel(1.0, 1.5, incidence), fresnel(1.5, 1.0, angle));
            assert!((there.s - returned.s).abs() < 1e-7 && (there.p - returned.p).abs() < 1e-7);
        }
        assert_eq!(refract(DVec3::Z, DVec3::NEG_Z, 1.0, 1.5), None);
    }
}
