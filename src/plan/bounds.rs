//! A-priori bounds on the error of a change, in linear light and in steps of 1/255.
//!
//! Let I be the largest strength of a light on the objects, k_d and k_s the largest diffuse and specular reflectance, n the exponent and
//! M(n) the steepest slope of cosⁿ ([`steepest_slope`]). Angles are in radians.
//!
//! - **Directions.** If the normal is off by δ, the direction to the light by λ and that to the viewer by υ, then N·L is off by at most δ + λ.
//!   The angle between N and the half vector is off by δ + f (λ + υ) with f = 1/(2 cos(θ/2)) for the angle θ between the directions to
//!   light and viewer, that between the viewer and the mirrored ray by 2δ + λ + υ. The light changes by at most the sum of
//!   I (k_d (δ + λ) + k_s (M(n) times this angle) + J).
//! - **The cut J** of the highlight where N·L = 0: Blinn's has k_s (N·H)ⁿ there, at most k_s sinⁿ(θ/2), Phong's
//!   k_s max(0, −cos θ)ⁿ. It vanishes unless the light comes from behind.
//! - **Positions** off by s see a light, or a viewer, at the distance of D − r or more in a direction that is off by asin(s/(D − r)).
//! - **A point light taken as directional** over a ball of radius r at the distance D has λ = asin(r/D).
//! - **A strength off by ΔI** changes the light by at most ΔI (k_d + k_s).
//! - **Steps.** The transfer curve is concave and 0 at 0, so |encode(a) − encode(b)| ≤ encode(|a − b|): a difference E in linear light is at
//!   most 255 encode(E) steps.

use super::axes::Terms;
use crate::num::{Radians, Transfer, steepest_slope};
use crate::raster::{Camera, Projection, RenderSettings};
use crate::shade::{Attenuation, Guards, Light, Material, Reflection, Terminator, ToneRule};
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

/// An angle by which normals are off, and a distance by which lit positions are.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Shift {
    pub normal: f64,
    pub position: f64,
}

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

    /// The bound on the light of normals and lit positions that are off by a shift.
    pub fn shifted(&self, material: &Material, lights: &[Light], shift: Shift) -> Option<f64> {
        let mut error = 0.0;
        for light in lights.iter().filter(|light| !matches!(light, Light::Ambient { .. })) {
            let to_light = self.direction_off(light, shift.position)?;
            let rate = diffuse(material) * (shift.normal + to_light);
            let slope = self.highlight_off(
                material,
                light,
                [shift.normal, to_light, self.viewer_off(shift.position)?],
            )?;
            error += self.strength(light)? * (rate + slope);
            error += self.strength_off(light, shift.position)? * (diffuse(material) + specular(material));
        }
        Some(error)
    }

    /// The bound on the error of single precision: a rounding of some units of 2⁻²⁴ in the cosine is n times as large in its power n.
    pub fn rounding(&self, material: &Material, lights: &[Light]) -> Option<f64> {
        const ROUNDING: f64 = 8.0 / (1 << 24) as f64;
        let reflected = diffuse(material) + specular(material) * material.exponent;
        let lights = lights.iter().filter(|light| !matches!(light, Light::Ambient { .. }));
        lights.map(|light| Some(self.strength(light)? * reflected * ROUNDING)).sum()
    }

    /// The bound on the light of terms that are omitted: the highlight, or all but ambient light. A highlight in place of another one is
    /// off by at most k_s.
    pub fn without_terms(&self, material: &Material, lights: &[Light], terms: Terms) -> Option<f64> {
        let reflected = match terms {
            Terms::Declared => return Some(0.0),
            Terms::Blinn | Terms::Diffuse => specular(material),
            Terms::Ambient => diffuse(material) + specular(material),
        };
        let lights = lights.iter().filter(|light| !matches!(light, Light::Ambient { .. }));
        lights.map(|light| Some(self.strength(light)? * reflected)).sum()
    }

    /// The bound on the light of another light in place of a point light, or of an omitted one.
    pub fn replaced(&self, material: &Material, old: &Light, new: Option<&Light>) -> Option<f64> {
        let most = self.strength(old)?;
        let Some(new) = new else {
            let reflected = match old {
                Light::Ambient { .. } => material.ambient.merged().largest(),
                _ => diffuse(material) + specular(material),
            };
            return Some(most * reflected);
        };
        let Light::Point { position, colour, attenuation } = old else { return None };
        let distance = position.distance(self.middle);
        let least = colour.largest() * attenuation.factor(distance + self.radius);
        let strength = new.colour().largest();
        let spread = (most - strength).abs().max((strength - least).abs());
        let error = spread * (diffuse(material) + specular(material));
        if !matches!(new, Light::Directional { .. }) {
            return Some(error);
        }
        let off = libm::asin(self.radius / distance);
        let highlight = self.highlight_off(material, old, [0.0, off, 0.0])?;
        Some(error + strength * (diffuse(material) * off + highlight))
    }

    /// The bound on the highlight if the normal and the directions to light and viewer are off by these angles.
    fn highlight_off(
        &self,
        material: &Material,
        light: &Light,
        [normal, to_light, to_viewer]: [f64; 3],
    ) -> Option<f64> {
        if specular(material) == 0.0 || normal + to_light + to_viewer == 0.0 {
            return Some(0.0);
        }
        let angle = self.largest_angle(light)?;
        let off = match material.reflection {
            Reflection::Phong => 2.0 * normal + to_light + to_viewer,
            Reflection::Blinn => normal + 0.5 / libm::cos(0.5 * angle) * (to_light + to_viewer),
        };
        Some(slope(material)? * off + cut(material, angle))
    }

    /// The angle by which the direction to a light is off at a position that is off by a distance.
    fn direction_off(&self, light: &Light, position: f64) -> Option<f64> {
        match light {
            _ if position == 0.0 => Some(0.0),
            Light::Point { position: place, .. } => self.angle_off(*place, position),
            Light::Directional { .. } => Some(0.0),
            _ => None,
        }
    }

    fn viewer_off(&self, position: f64) -> Option<f64> {
        let off = |camera: &Camera| match self.is_far(camera) {
            true => Some(0.0),
            false => self.angle_off(camera.eye, position),
        };
        self.cameras.iter().map(off).try_fold(0.0, |most: f64, off| Some(most.max(off?)))
    }

    /// asin(s/(D − r)) for a distance s between two positions in the ball.
    fn angle_off(&self, from: DVec3, position: f64) -> Option<f64> {
        let share = position / (from.distance(self.middle) - self.radius);
        (0.0..1.0).contains(&share).then(|| libm::asin(share))
    }

    /// How much the strength of a light varies between positions in the ball at a distance of each other.
    fn strength_off(&self, light: &Light, position: f64) -> Option<f64> {
        let Light::Point { position: place, attenuation, colour } = light else { return Some(0.0) };
        if position == 0.0 {
            return Some(0.0);
        }
        let nearest = place.distance(self.middle) - self.radius;
        let farthest = match attenuation {
            // 1/d² is steepest where it is nearest.
            Attenuation::InverseSquare => nearest + position,
            _ => nearest + 2.0 * self.radius,
        };
        let off = attenuation.factor(nearest) - attenuation.factor(farthest);
        (nearest > 0.0 && off.is_finite()).then(|| off * colour.largest())
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
            let (to_viewer, more) = match self.is_far(camera) {
                true => (camera.eye - camera.target, 0.0),
                false => (camera.eye - self.middle, turn(camera.eye)?),
            };
            let between = libm::atan2(to_light.cross(to_viewer).length(), to_light.dot(to_viewer));
            largest = largest.max(between + slack + more + self.cone.0);
        }
        Some(largest.min(PI))
    }

    /// The distance of a light in radii of the ball, and asin(r/D).
    pub fn lamp(&self, position: DVec3) -> Option<(f64, f64)> {
        let radii = position.distance(self.middle) / self.radius;
        (radii > 1.0 && radii.is_finite()).then(|| (radii, libm::asin(1.0 / radii)))
    }

    fn is_far(&self, camera: &Camera) -> bool {
        self.settings.infinite_viewer || matches!(camera.projection, Projection::Orthographic(_))
    }

    /// A bound in steps, from one in linear light.
    pub fn steps(&self, linear: f64) -> f64 {
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

    /// Light on pairs of normals, and on pairs of directions to a light or a viewer, with an angle δ between them: none differs by more than the formulas say, and
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
                let of_viewer = change([normal, light, view], [normal, light, turn * view]);
                assert!(of_viewer <= factor * slope + cut(&material, largest) + 1e-12, "{seed}");
            }
            assert!(needs_cut, "{reflection:?}");
        }
    }
}
