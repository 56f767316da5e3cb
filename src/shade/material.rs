//! Materials: what a surface does with light.

use super::error::{Place, Result};
use crate::num::{LinearRgb, Real};

/// The share of light that a surface returns by one kind of reflection (F15).
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Reflectance {
    /// A coefficient k and a colour O.
    Split {
        /// k.
        k: f64,
        /// O.
        colour: LinearRgb,
    },
    /// Coefficient and colour in one, K = k·O.
    Merged(LinearRgb),
}

impl Reflectance {
    /// No reflection.
    pub const NONE: Reflectance = Reflectance::Merged(LinearRgb::BLACK);

    /// A coefficient and a colour.
    pub const fn new(k: f64, colour: LinearRgb) -> Self {
        Reflectance::Split { k, colour }
    }

    /// K = k·O.
    pub fn merged(self) -> LinearRgb {
        match self {
            Reflectance::Split { k, colour } => colour * k,
            Reflectance::Merged(colour) => colour,
        }
    }

    fn check<R: Real>(self, field: &'static str) -> Result<()> {
        if let Reflectance::Split { k, .. } = self {
            Place::Material.not_negative(field, k)?;
        }
        let (Reflectance::Split { colour, .. } | Reflectance::Merged(colour)) = self;
        Place::Material.colour(field, colour)?;
        Place::Material.in_range::<R>(field, self.merged())
    }
}

/// Highlight model.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub enum Reflection {
    /// (V·R)ⁿ with the mirrored ray R = 2N(N·L) − L (Phong 1973; F4, F5).
    Phong,
    /// (N·H)ⁿ with the half-vector H = (L+V)/‖L+V‖ (Blinn 1977; F6).
    #[default]
    Blinn,
}

/// A surface's answer to light: I = Σ I_a K_a + Σ f I_i [K_d (N·L) + K_s cosⁿ] (F8, F15, F16).
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Material {
    /// Of ambient light.
    pub ambient: Reflectance,
    /// Of light from lamps, in all directions alike.
    pub diffuse: Reflectance,
    /// Of highlights. The colour O_s is white for plastic, and the diffuse colour for metal.
    pub specular: Reflectance,
    /// n, 0 or more: the larger it is, the smaller is the highlight.
    pub exponent: f64,
    /// The highlight model.
    pub reflection: Reflection,
}

impl Default for Material {
    /// Grey plastic: k_a = 0.1, k_d = 0.7, k_s = 0.2, n = 32.
    fn default() -> Self {
        Material::plastic(LinearRgb::grey(0.8))
    }
}

impl Material {
    /// A colour with a small white highlight: k_a = 0.1, k_d = 0.7, k_s = 0.2, n = 32 by Blinn.
    pub fn plastic(colour: LinearRgb) -> Self {
        Self {
            ambient: Reflectance::new(0.1, colour),
            diffuse: Reflectance::new(0.7, colour),
            specular: Reflectance::new(0.2, LinearRgb::WHITE),
            exponent: 32.0,
            reflection: Reflection::Blinn,
        }
    }

    /// No highlight at all: k_a = 0.1, k_d = 0.9.
    pub fn matte(colour: LinearRgb) -> Self {
        Self {
            ambient: Reflectance::new(0.1, colour),
            diffuse: Reflectance::new(0.9, colour),
            specular: Reflectance::NONE,
            exponent: 1.0,
            reflection: Reflection::Blinn,
        }
    }

    /// A warning if K_d + K_s is above 1 in a component: the surface then reflects more light than it receives (F1).
    /// It is not an error, because exercise 1.6.19 of the lectures has such a material.
    pub fn gain(&self) -> Option<EnergyGain> {
        let sum = self.diffuse.merged() + self.specular.merged();
        // A sum of two rounded numbers that are 1 together is not a gain.
        (sum.largest() > 1.0 + 4.0 * f64::EPSILON).then_some(EnergyGain { sum })
    }

    pub(crate) fn check<R: Real>(&self) -> Result<()> {
        for (field, reflectance) in [
            ("ambient reflection", self.ambient),
            ("diffuse reflection", self.diffuse),
            ("specular reflection", self.specular),
        ] {
            reflectance.check::<R>(field)?;
        }
        Place::Material.not_negative("exponent", self.exponent)
    }
}

/// A material that reflects more light than it receives.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct EnergyGain {
    /// K_d + K_s = k_d·O_d + k_s·O_s; a component is over 1.
    pub sum: LinearRgb,
}

impl std::fmt::Display for EnergyGain {
    fn fmt(&self, f: &mut std::fmt::Formatter) -> std::fmt::Result {
        // Rounded up, so that a sum over 1 is not written as 1.
        let reported = |sum: f64| match sum {
            _ if sum >= 1e4 => format!("{sum:.3e}"),
            _ if sum > 1.0 => format!("{:.3}", (1e3 * sum).ceil() / 1e3),
            _ => format!("{sum:.3}"),
        };
        let [red, green, blue] = self.sum.to_array().map(reported);
        write!(f, "the material reflects more light than it receives: diffuse + specular is ")?;
        write!(f, "{red} in red, {green} in green, {blue} in blue (limit 1)")
    }
}

/// The exponent that gives Blinn's highlight the size of Phong's: 4n.
///
/// With V in the plane of L and N, the angle of N·H is half that of V·R, and cos⁴ⁿ(φ/2) ≈ cosⁿ φ. The largest difference is
/// 0.25 for n = 1, 0.0301 for 5 and 0.00273 for 50 (Fisher & Woo, *R·E versus N·H specular highlights*, Graphics Gems IV, 1994).
pub fn blinn_exponent(phong: f64) -> f64 {
    4.0 * phong
}

/// The exponent that gives Phong's highlight the size of Blinn's: n/4. See [`blinn_exponent`].
pub fn phong_exponent(blinn: f64) -> f64 {
    blinn / 4.0
}

/// The exponent of Blinn's highlight for a roughness of glTF, from 0 for a mirror to 1: n = 2/α² − 2 with α = roughness², at
/// least 1 and at most 10⁴ (B. Walter et al., *Microfacet models for refraction through rough surfaces*, EGSR 2007,
/// §5.2).
///
/// An exponent of 0 would make a step where N·L is 0. Above 10⁴ the highlight is smaller than the pixels of a picture.
///
/// ```
/// use crease::shade::roughness_exponent;
///
/// assert_eq!([0.0, 0.5, 1.0].map(roughness_exponent), [1e4, 30.0, 1.0]);
/// ```
pub fn roughness_exponent(roughness: f64) -> f64 {
    let alpha = roughness * roughness;
    (2.0 / (alpha * alpha) - 2.0).clamp(1.0, 1e4)
}
