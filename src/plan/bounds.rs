//! A-priori bounds on the error of a change, in steps of 1/255.
//!
//! Let I be the largest strength of a light on the objects, k_d and k_s the largest diffuse and specular reflectance, n the exponent and
//! M(n) the steepest slope of cosⁿ ([`steepest_slope`]). Angles are in radians.
//!
//! - **A normal off by δ.** The cosine of an angle changes by at most δ if the angle does, and cosⁿ by at most M(n) δ. The angle to the half
//!   vector changes by δ, that to the mirrored ray by 2δ. So the light changes by at most Σ I ((k_d + k_s M(n)) δ + J) with Blinn's
//!   highlight, Σ I ((k_d + 2 k_s M(n)) δ + J) with Phong's.
//! - **The cut J** of the highlight where N·L = 0: Blinn's has k_s (N·H)ⁿ there, at most k_s sinⁿ(θ/2) for the angle θ between the directions
//!   to light and viewer, Phong's k_s max(0, −cos θ)ⁿ. It vanishes unless the light comes from behind.
//! - **Interpolated normals.** Normals of corners that are off by δ are 2 sin(δ/2) from the right ones, and so is their weighted mean, which
//!   is at least ℓ long. Its direction is off by at most asin(2 sin(δ/2) / ℓ).
//! - **A direction of light off by δ** turns the half vector by at most δ / (2 cos(θ/2)), the mirrored ray by δ. For a ball of radius r at the
//!   distance D, δ = asin(r/D).
//! - **A strength off by ΔI** changes the light by at most ΔI (k_d + k_s).
//! - **Steps.** The transfer curve is concave and 0 at 0, so |encode(a) − encode(b)| ≤ encode(|a − b|): a difference E in linear light is at
//!   most 255 encode(E) steps.

use crate::num::{Radians, Transfer, steepest_slope};
use crate::raster::{Camera, Projection, RenderSettings};
use crate::shade::{Guards, Light, Material, Reflection, Terminator, ToneRule};
use glam::DVec3;
use std::f64::consts::PI;

/// What is lit and seen: objects within a ball, and the settings and cameras of their pictures.
pub struct Setting<'a> {
    settings: &'a RenderSettings,
    cameras: Vec<Camera>,
    middle: DVec3,
    radius: f64,
    /// The angle by which lights may turn around the middle.
    cone: Radians,
}

/// Steps by which single precision and the step of 10⁻⁷ where the pieces of the curve of sRGB meet can add to a difference: some ten
/// roundings of 2⁻²⁴ at its steepest slope, 255 · 12.92 · 10 · 2⁻²⁴.
const ROUNDING: f64 = 2e-3;

impl<'a> Setting<'a> {
    /// `None` where the bounds do not hold: with a tone rule that divides, without guards, with a terminator that depends on faces, with depth
    /// cueing, or with a camera among the objects.
    pub fn new(
        settings: &'a RenderSettings,
        cameras: Vec<Camera>,
        (middle, radius): (DVec3, f64),
        cone: Radians,
    ) -> Option<Self> {
        let is_plain = settings.tone == ToneRule::Clamp
            && settings.guards == Guards::default()
            && settings.terminator == Terminator::Smooth
            && settings.depth_cue.is_none();
        let is_outside = cameras.iter().all(|camera| camera.eye.distance(middle) > radius);
        (is_plain && is_outside).then_some(Self { settings, cameras, middle, radius, cone })
    }

    /// The bound on an error of all normals by up to `angle`, for corner normals whose weighted means are at least `shortest` long.
    pub fn normals(&self, material: &Material, lights: &[Light], angle: f64, shortest: f64) -> Option<f64> {
        let off = 2.0 * libm::sin(0.5 * angle);
        let angle = (off < shortest).then(|| libm::asin(off / shortest))?;
        let factor = if material.reflection == Reflection::Phong { 2.0 } else { 1.0 };
        let rate = diffuse(material) + factor * slope(material)?;
        let mut error = 0.0;
        for light in lights.iter().filter(|light| !matches!(light, Light::Ambient { .. })) {
            let cut = cut(material, self.largest_angle(light)?);
            error += self.strength(light)? * (rate * angle + cut);
        }
        Some(self.steps(error))
    }

    /// The bound on the error of a light in place of a point light, or of an omitted one.
    pub fn light(&self, material: &Material, old: &Light, new: Option<&Light>) -> Option<f64> {
        let most = self.strength(old)?;
        let Some(new) = new else {
            let reflected = match old {
                Light::Ambient { .. } => material.ambient.merged().largest(),
                _ => diffuse(material) + specular(material),
            };
            return Some(self.steps(most * reflected));
        };
        let Light::Point { position, colour, attenuation } = old else { return None };
        let distance = position.distance(self.middle);
        let least = colour.largest() * attenuation.factor(distance + self.radius);
        let strength = new.colour().largest();
        let spread = (most - strength).abs().max((strength - least).abs());
        let mut error = spread * (diffuse(material) + specular(material));
        if matches!(new, Light::Directional { .. }) {
            let angle = self.largest_angle(old)?;
            let factor = match material.reflection {
                Reflection::Phong => 1.0,
                Reflection::Blinn => 0.5 / libm::cos(0.5 * angle),
            };
            let off = libm::asin(self.radius / distance);
            error +=
                strength * ((diffuse(material) + factor * slope(material)?) * off + cut(material, angle));
        }
        Some(self.steps(error))
    }

    /// The largest strength of a light on the ball; `None` without a bound.
    fn strength(&self, light: &Light) -> Option<f64> {
        let colour = light.colour().largest();
        match *light {
            Light::Ambient { .. } | Light::Directional { .. } => Some(colour),
            Light::Point { position, attenuation, .. } | Light::Spot { position, attenuation, .. } => {
                let nearest = position.distance(self.middle) - self.radius;
                let factor = attenuation.factor(nearest.max(0.0));
                (nearest > 0.0 && factor.is_finite()).then_some(colour * factor)
            }
            Light::Area { .. } => None,
        }
    }

    /// The largest angle between the directions to a light and to the viewer, over the ball and all cameras; `None` for lights in it.
    fn largest_angle(&self, light: &Light) -> Option<f64> {
        let turn = |place: DVec3| {
            let share = self.radius / place.distance(self.middle);
            (share < 1.0).then(|| libm::asin(share))
        };
        let (to_light, slack) = match *light {
            Light::Directional { towards, .. } => (towards, 0.0),
            Light::Point { position, .. } | Light::Spot { position, .. } => {
                (position - self.middle, turn(position)?)
            }
            Light::Ambient { .. } | Light::Area { .. } => return None,
        };
        let mut largest = 0.0_f64;
        for camera in &self.cameras {
            let is_far =
                self.settings.infinite_viewer || matches!(camera.projection, Projection::Orthographic(_));
            let (to_viewer, more) = match is_far {
                true => (camera.eye - camera.target, 0.0),
                false => (camera.eye - self.middle, turn(camera.eye)?),
            };
            let between = libm::atan2(to_light.cross(to_viewer).length(), to_light.dot(to_viewer));
            largest = largest.max(between + slack + more + self.cone.0);
        }
        Some(largest.min(PI))
    }

    fn steps(&self, linear: f64) -> f64 {
        let transfer: Transfer = self.settings.transfer;
        (255.0 * transfer.encode(linear.clamp(0.0, 1.0)) + ROUNDING).min(255.0)
    }
}

fn diffuse(material: &Material) -> f64 {
    material.diffuse.merged().largest()
}

fn specular(material: &Material) -> f64 {
    material.specular.merged().largest()
}

/// k_s M(n); `None` below n = 1, where the slope of cosⁿ has no bound.
fn slope(material: &Material) -> Option<f64> {
    let specular = specular(material);
    (specular == 0.0 || material.exponent >= 1.0)
        .then(|| if specular == 0.0 { 0.0 } else { specular * steepest_slope(material.exponent) })
}

/// The largest highlight where N·L = 0, for an angle of up to `angle` between the directions to light and viewer.
fn cut(material: &Material, angle: f64) -> f64 {
    let cosine = match material.reflection {
        Reflection::Blinn => libm::sin(0.5 * angle),
        Reflection::Phong => (-libm::cos(angle)).max(0.0),
    };
    specular(material) * libm::pow(cosine, material.exponent)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::num::LinearRgb;
    use crate::shade::Reflectance;
    use crate::trade::direction;

    fn material(reflection: Reflection) -> Material {
        let grey = |k: f64| Reflectance::Merged(LinearRgb::grey(k));
        Material { ambient: grey(0.1), diffuse: grey(0.5), specular: grey(0.4), exponent: 20.0, reflection }
    }

    fn highlight(material: &Material, [normal, light, view]: [DVec3; 3]) -> f64 {
        let cosine = match material.reflection {
            Reflection::Blinn => normal.dot((light + view).normalize()),
            Reflection::Phong => view.dot(2.0 * normal * normal.dot(light) - light),
        };
        let is_lit = normal.dot(light) > 0.0;
        0.4 * if is_lit { libm::pow(cosine.max(0.0), 20.0) } else { 0.0 }
    }

    /// Light on pairs of normals, and on pairs of directions of light, an angle δ apart: none differs by more than the formulas say, and
    /// some differ by more than without the cut.
    #[test]
    fn no_pair_of_directions_exceeds_the_bound() {
        let delta = 0.02;
        for reflection in [Reflection::Blinn, Reflection::Phong] {
            let material = material(reflection);
            let factor = if reflection == Reflection::Phong { 2.0 } else { 1.0 };
            let mut needs_cut = false;
            for seed in 0..40_000 {
                let [normal, light, view] = [1, 2, 3].map(|k| direction(4 * seed + k));
                if normal.dot(view) <= 0.0 {
                    continue;
                }
                let turn = glam::DQuat::from_axis_angle(direction(4 * seed), delta);
                let angle = libm::acos(light.dot(view).clamp(-1.0, 1.0));
                let change = |a, b| f64::abs(highlight(&material, a) - highlight(&material, b));
                let of_normal = change([normal, light, view], [turn * normal, light, view]);
                let slope = slope(&material).unwrap() * delta;
                assert!(of_normal <= factor * slope + cut(&material, angle) + 1e-12, "{seed}");
                needs_cut |= of_normal > factor * slope;
                let largest = (angle + delta).min(PI);
                let factor = match reflection {
                    Reflection::Phong => 1.0,
                    Reflection::Blinn => 0.5 / libm::cos(0.5 * largest),
                };
                let of_light = change([normal, light, view], [normal, turn * light, view]);
                assert!(of_light <= factor * slope + cut(&material, largest) + 1e-12, "{seed}");
            }
            assert!(needs_cut, "{reflection:?}");
        }
    }
}
