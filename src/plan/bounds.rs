//! A-priori bounds on the error of a change, in steps of 1/255.
//!
//! Let I be the largest strength of a light at the object, k_d and k_s the largest diffuse and specular reflectance, n the exponent and M(n)
//! the steepest slope of cosⁿ ([`steepest_slope`]). A normal or a direction of light that is off by δ changes the reflected light by at most
//!
//! E = Σ I (k_d + k_s M(n)) δ with Blinn's highlight, Σ I (k_d + 2 k_s M(n)) δ with Phong's,
//!
//! and a strength that is off by a share s changes it by at most Σ s I (k_d + k_s). The transfer curve is concave and 0 at 0, so
//! |encode(a) − encode(b)| ≤ encode(|a − b|): a difference E in linear light is at most 255 encode(E) steps.

use crate::num::{Transfer, steepest_slope};
use crate::raster::RenderSettings;
use crate::shade::{Light, Material, Reflection, ToneRule};
use glam::DVec3;

/// A difference of linear light in steps; `None` under a tone rule that divides.
pub fn steps(linear: f64, settings: &RenderSettings) -> Option<f64> {
    // The pieces of the curve of sRGB meet with a step of 10⁻⁷.
    let slack = if settings.transfer == Transfer::Srgb { 1e-4 } else { 0.0 };
    (settings.tone == ToneRule::Clamp)
        .then(|| (255.0 * settings.transfer.encode(linear.clamp(0.0, 1.0)) + slack).min(255.0))
}

/// The largest change of reflected light for each radian of a wrong normal or direction under a light of strength 1.
pub fn for_each_radian(material: &Material) -> f64 {
    let factor = if material.reflection == Reflection::Phong { 2.0 } else { 1.0 };
    let specular = material.specular.merged().largest();
    material.diffuse.merged().largest() + factor * specular * steepest_slope(material.exponent.max(1.0))
}

/// The largest strength of a light on a ball of a radius around a middle; `None` without a bound.
pub fn strength(light: &Light, middle: DVec3, radius: f64) -> Option<f64> {
    let colour = light.colour().largest();
    match *light {
        Light::Ambient { .. } | Light::Directional { .. } => Some(colour),
        Light::Point { position, attenuation, .. } | Light::Spot { position, attenuation, .. } => {
            let nearest = position.distance(middle) - radius;
            let factor = attenuation.factor(nearest.max(0.0));
            (nearest > 0.0 && factor.is_finite()).then_some(colour * factor)
        }
        Light::Area { .. } => None,
    }
}

/// The error of storing normals that are off by up to `angle`, in linear light, under lights of these strengths.
pub fn of_normals(
    material: &Material,
    lights: &[Light],
    angle: f64,
    middle: DVec3,
    radius: f64,
) -> Option<f64> {
    let lit = lights.iter().filter(|light| !matches!(light, Light::Ambient { .. }));
    let total = lit.map(|light| strength(light, middle, radius)).sum::<Option<f64>>()?;
    Some(total * for_each_radian(material) * angle)
}

/// The error of a light that replaces another: a point or spot that becomes directional or is no longer attenuated, or a light that is
/// omitted. For a ball of radius r at distance d the direction to the light is off by at most asin(r/d).
pub fn of_light(
    material: &Material,
    old: &Light,
    new: Option<&Light>,
    middle: DVec3,
    radius: f64,
) -> Option<f64> {
    let reflected = match old {
        Light::Ambient { .. } => material.ambient.merged().largest(),
        _ => material.diffuse.merged().largest() + material.specular.merged().largest(),
    };
    let most = strength(old, middle, radius)?;
    match (old, new) {
        (_, None) => Some(most * reflected),
        (Light::Point { position, attenuation, .. }, Some(new)) => {
            let distance = position.distance(middle);
            if radius >= distance {
                return None;
            }
            let middle_strength = new.colour().largest();
            let spread = (most - middle_strength).abs().max(
                (middle_strength - old.colour().largest() * attenuation.factor(distance + radius)).abs(),
            );
            let turned = match new {
                Light::Directional { .. } => libm::asin(radius / distance),
                _ => 0.0,
            };
            Some(spread * reflected + most * for_each_radian(material) * turned)
        }
        _ => None,
    }
}
