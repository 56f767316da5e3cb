//! What a wrong normal does to a picture, in steps of 8 bits.

use crate::num::Transfer;

/// The angle between the right normal and the key light, in degrees: where photographers put it.
const KEY_LIGHT: f64 = 45.0;

/// Steps of 8 bits, sRGB-coded, between a white matte surface lit by a key light 45° from its normal and the same with a
/// normal that is off by this many degrees, away from the light: |sRGB(cos 45°) − sRGB(max(0, cos(45° + δ)))| · 255.
///
/// A statement about any mesh in any light would need a scene; this one needs an angle only. One degree is 1.7 steps,
/// and 45° and more are black.
///
/// ```
/// use crease::quality::key_light_steps;
///
/// assert!((key_light_steps(1.0) - 1.717).abs() < 1e-3);
/// assert_eq!(key_light_steps(45.0), key_light_steps(180.0));
/// ```
pub fn key_light_steps(degrees: f64) -> f64 {
    let grey = |degrees: f64| {
        let cosine = if degrees >= 90.0 { 0.0 } else { libm::cos(degrees.to_radians()) };
        Transfer::Srgb.encode(cosine)
    };
    (grey(KEY_LIGHT) - grey(KEY_LIGHT + degrees)) * 255.0
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn steps_grow_with_the_angle() {
        assert_eq!(key_light_steps(0.0), 0.0);
        let steps: Vec<f64> = (0..=45).map(|degrees| key_light_steps(f64::from(degrees))).collect();
        assert!(steps.is_sorted_by(|a, b| a < b), "{steps:?}");
        // sRGB(√½) = 1.055 · 0.5^(1/4.8) − 0.055 = 0.8577.
        let coded = 1.055 * libm::pow(0.5, 1.0 / 4.8) - 0.055;
        assert!((steps[45] - 255.0 * coded).abs() < 1e-9, "{}", steps[45]);
    }
}
