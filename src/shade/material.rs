//! Materials: what a surface does with light.

use super::error::{Check, Place, ShadeError};
use crate::num::{LinearRgb, Real};

/// How much of the light a surface returns, of one kind of reflection (F15).
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Reflectance {
    /// A coefficient k and a colour O apart.
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
    /// None at all.
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

    fn check(self, field: &'static str) -> Result<(), ShadeError> {
        let check = Check(Place::Material);
        if let Reflectance::Split { k, .. } = self {
            check.not_negative(field, k)?;
        }
        let colour = match self {
            Reflectance::Split { colour, .. } | Reflectance::Merged(colour) => colour,
        };
        check.colour(field, colour)
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
    /// To all sides alike.
    pub diffuse: Reflectance,
    /// Mirror-like. Its colour O_s is its own: white for plastic, the diffuse colour for metal.
    pub specular: Reflectance,
    /// n, 0 or more: the larger, the smaller the highlight.
    pub exponent: f64,
    /// What the highlight is computed from.
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

    /// More light out than in (F1: what comes in is reflected, transmitted or absorbed, so K_d + K_s ≤ 1 in each
    /// component). Exercise 1.6.19 of the lectures does it, so it is a warning, not an error.
    pub fn gain(&self) -> Option<EnergyGain> {
        let sum = self.diffuse.merged() + self.specular.merged();
        // A sum of two rounded numbers that are 1 together is not a gain.
        (sum.largest() > 1.0 + 4.0 * f64::EPSILON).then_some(EnergyGain { sum })
    }

    /// Whether every number makes sense.
    pub(crate) fn check(&self) -> Result<(), ShadeError> {
        self.reflectances().into_iter().try_for_each(|(field, reflectance)| reflectance.check(field))?;
        Check(Place::Material).not_negative("exponent", self.exponent)
    }

    /// Whether the precision of `R` has them.
    pub(crate) fn check_range<R: Real>(&self) -> Result<(), ShadeError> {
        let merged = self.reflectances().map(|(field, reflectance)| (field, reflectance.merged()));
        merged.into_iter().try_for_each(|(field, colour)| Check(Place::Material).in_range::<R>(field, colour))
    }

    fn reflectances(&self) -> [(&'static str, Reflectance); 3] {
        [
            ("ambient reflection", self.ambient),
            ("diffuse reflection", self.diffuse),
            ("specular reflection", self.specular),
        ]
    }
}

/// A material that reflects more than it gets.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct EnergyGain {
    /// K_d + K_s = k_d·O_d + k_s·O_s, of which some component is over 1.
    pub sum: LinearRgb,
}

impl std::fmt::Display for EnergyGain {
    fn fmt(&self, f: &mut std::fmt::Formatter) -> std::fmt::Result {
        // Rounded up, so that what is over 1 does not read as 1.
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
/// With V in the plane of L and N, the angle of N·H is half that of V·R, and cos⁴ⁿ(φ/2) ≈ cosⁿ φ. The largest difference of
/// the two is 0.25 for n = 1, 0.0902 for 2, 0.0301 for 5, 0.01425 for 10, 0.00273 for 50 and 0.00068 for 200; with the same
/// n it would be up to 0.71. (Fisher & Woo, *R·E versus N·H specular highlights*, Graphics Gems IV, 1994.)
pub fn blinn_exponent(phong: f64) -> f64 {
    4.0 * phong
}

/// The exponent that gives Phong's highlight the size of Blinn's: n/4. See [`blinn_exponent`].
pub fn phong_exponent(blinn: f64) -> f64 {
    blinn / 4.0
}

/// The exponent of Blinn's highlight that is about as wide as that of a surface of this roughness, from 0 for a mirror to 1,
/// as glTF counts it: n = 2/α² − 2 with α = roughness² (B. Walter et al., *Microfacet models for refraction through rough
/// surfaces*, EGSR 2007, §5.2).
///
/// It is from 1 for the roughest surfaces, never 0, which would be a step where N·L is 0, to 10⁴ for the smoothest, whose
/// highlights become no smaller than the steps of a picture can show.
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
