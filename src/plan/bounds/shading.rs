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
//! - **Positions** off by s see a viewer at the distance of D − r or more in a direction that is off by asin(s/(D − r)).
//! - **A strength off by ΔI** changes the light by at most ΔI (k_d + k_s). The module `lights` has I, ΔI and λ of each light.
//! - **The highlight of an area light** comes from one of its points, which may be any other one for another normal or position: λ is the
//!   angle at which the light is seen.
//! - **Steps.** The transfer curve is concave and 0 at 0, so |encode(a) − encode(b)| ≤ encode(|a − b|): a difference E in linear light is at
//!   most 255 encode(E) steps.

use super::lights::Ball;
use crate::num::{Radians, Transfer, steepest_slope};
use crate::plan::axes::Terms;
use crate::raster::{Camera, Projection, RenderSettings};
use crate::shade::{Guards, Light, Material, Reflection, Terminator, ToneRule};
use glam::DVec3;
use std::f64::consts::PI;

/// What is lit and seen: objects within a ball, and the settings and cameras of their pictures.
pub struct Setting<'a> {
    settings: &'a RenderSettings,
    cameras: Vec<Camera>,
    ball: Ball,
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
        ball: Ball,
        cone: Radians,
    ) -> Option<Self> {
        let is_plain = settings.tone == ToneRule::Clamp
            && settings.guards == Guards::default()
            && settings.terminator == Terminator::Smooth
            && settings.depth_cue.is_none();
        let is_outside = cameras.iter().all(|camera| camera.eye.distance(ball.middle) > ball.radius);
        (is_plain && is_outside).then_some(Self { settings, cameras, ball, cone })
    }

    /// The bound on the light of normals and lit positions that are off by a shift.
    pub fn shifted(&self, material: &Material, lights: &[Light], shift: Shift) -> Option<f64> {
        let mut error = 0.0;
        for light in lights.iter().filter(|light| !matches!(light, Light::Ambient { .. })) {
            let to_light = self.ball.direction_off(light, shift.position)?;
            let rate = diffuse(material) * (shift.normal + to_light);
            let is_shifted = shift.normal + shift.position > 0.0;
            let to_highlight = to_light.max(if is_shifted { self.ball.width(light)? } else { 0.0 });
            let slope = self.highlight_off(
                material,
                light,
                [shift.normal, to_highlight, self.viewer_off(shift.position)?],
            )?;
            error += self.ball.strength(light)? * (rate + slope);
            let [of_diffuse, of_highlight] = self.ball.strength_off(light, shift.position)?;
            error += of_diffuse * diffuse(material) + of_highlight * specular(material);
        }
        Some(error)
    }

    /// The bound on the error of single precision: a rounding of some units of 2⁻²⁴ in the cosine is n times as large in its power n.
    pub fn rounding(&self, material: &Material, lights: &[Light]) -> Option<f64> {
        const ROUNDING: f64 = 8.0 / (1 << 24) as f64;
        let reflected = diffuse(material) + specular(material) * material.exponent;
        let lights = lights.iter().filter(|light| !matches!(light, Light::Ambient { .. }));
        lights.map(|light| Some(self.ball.strength(light)? * reflected * ROUNDING)).sum()
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
        lights.map(|light| Some(self.ball.strength(light)? * reflected)).sum()
    }

    /// The bound on the light of a cheaper light in place of another one, or of an omitted one.
    pub fn replaced(&self, material: &Material, old: &Light, new: Option<&Light>) -> Option<f64> {
        let Some(new) = new else {
            let reflected = match old {
                Light::Ambient { .. } => material.ambient.merged().largest(),
                _ => diffuse(material) + specular(material),
            };
            return Some(self.ball.strength(old)? * reflected);
        };
        let (mut error, mut at) = (0.0, *old);
        for step in self.ball.replacements(old, new)? {
            let off = step.direction;
            let highlight = self.highlight_off(material, &at, [0.0, off, 0.0])?;
            error += self.ball.strength(&step.light)? * (diffuse(material) * off + highlight);
            error += step.strength[0] * diffuse(material) + step.strength[1] * specular(material);
            at = step.light;
        }
        Some(error)
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

    fn viewer_off(&self, position: f64) -> Option<f64> {
        let off = |camera: &Camera| match self.is_far(camera) {
            true => Some(0.0),
            false => self.angle_off(camera.eye, position),
        };
        self.cameras.iter().map(off).try_fold(0.0, |most: f64, off| Some(most.max(off?)))
    }

    /// asin(s/(D − r)) for a distance s between two positions in the ball.
    fn angle_off(&self, from: DVec3, position: f64) -> Option<f64> {
        let share = position / (from.distance(self.ball.middle) - self.ball.radius);
        (0.0..1.0).contains(&share).then(|| libm::asin(share))
    }

    /// The largest angle between the directions to a light and to the viewer, over the ball and all cameras; `None` for lights in it.
    fn largest_angle(&self, light: &Light) -> Option<f64> {
        let (to_light, slack) = self.ball.directions(light)?;
        let Ball { middle, radius } = self.ball;
        let mut largest = 0.0_f64;
        for camera in &self.cameras {
            let (to_viewer, more) = match self.is_far(camera) {
                true => (camera.eye - camera.target, 0.0),
                false => (camera.eye - middle, libm::asin((radius / camera.eye.distance(middle)).min(1.0))),
            };
            let between = libm::atan2(to_light.cross(to_viewer).length(), to_light.dot(to_viewer));
            largest = largest.max(between + slack + more + self.cone.0);
        }
        Some(largest.min(PI))
    }

    /// The distance of a light in radii of the ball, and the largest angle between directions to it and that from the middle.
    pub fn lamp(&self, light: &Light) -> Option<(f64, f64)> {
        let (way, angle) = self.ball.directions(light)?;
        let radii = way.length() / self.ball.radius;
        (!matches!(light, Light::Directional { .. }) && radii.is_finite()).then_some((radii, angle))
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
    use crate::plan::axes::LightModel;
    use crate::plan::lights::replacements;
    use crate::shade::{
        AreaShape, Attenuation, Cone, Reflectance, ShadeSettings, Shader, SurfacePoint, Viewer,
    };
    use crate::trade::direction;
    use glam::DQuat;

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

    /// A light around the unit ball, of every kind that a plan replaces.
    fn lamp(seed: u32) -> Light {
        let share = |k: u32| direction(8 * seed + k).z.abs();
        let position = direction(8 * seed) * (2.0 + 8.0 * share(1));
        let (towards, colour) = (direction(8 * seed + 2), LinearRgb::grey(0.3 * position.length_squared()));
        // It shines towards the ball, more or less.
        let axis = (towards - position).normalize();
        let attenuation = [Attenuation::InverseSquare, Attenuation::Offset(1.0)][seed as usize / 4 % 2];
        match seed % 4 {
            0 => Light::Point { position, colour, attenuation },
            1 => {
                let (cut_off, soft_edge) = (Radians(0.3 + share(3)), Radians(0.3 * share(4)));
                let cone = Cone { axis, cut_off, soft_edge, exponent: 4.0 * share(5) };
                Light::Spot { position, colour, attenuation, cone }
            }
            2 => {
                let (u, v) = axis.any_orthonormal_pair();
                // u × v is the axis.
                let shape = AreaShape::Rectangle { centre: position, u: u * share(3), v: v * share(4) };
                Light::Area { shape, colour }
            }
            _ => Light::Area {
                shape: AreaShape::Disc { centre: position, normal: axis, radius: share(3) },
                colour,
            },
        }
    }

    /// Light of lamps around a ball at points, normals and viewers, near the highlight and away from it: neither a cheaper lamp nor another point
    /// changes it by more than the bounds, for diffuse light and for highlights.
    #[test]
    fn no_point_exceeds_the_bounds_of_lights() {
        let settings = RenderSettings::default();
        let mut closest = [[0.0_f64; 3]; 4];
        for seed in 0..400 {
            let light = lamp(seed);
            let grey = |k: f64| Reflectance::Merged(LinearRgb::grey(k));
            let material = material([Reflection::Blinn, Reflection::Phong][seed as usize / 4 % 2]);
            let material = match seed / 8 % 2 {
                0 => Material { specular: grey(0.0), ..material },
                _ => Material { diffuse: grey(0.0), exponent: 400.0, ..material },
            };
            let camera =
                Camera { eye: direction(seed) * 6.0, ..Camera::framing((DVec3::NEG_ONE, DVec3::ONE), 1.0) };
            let ball = Ball { middle: DVec3::ZERO, radius: 1.0 };
            let setting = Setting::new(&settings, vec![camera], ball, Radians(0.0)).unwrap();
            // No bound holds for area lights that may meet the ball.
            let Some((towards, _)) = ball.directions(&light) else { continue };
            let viewer = ShadeSettings { viewer: Viewer::At(camera.eye), ..ShadeSettings::default() };
            let lit = |light: &Light, position: DVec3, normal: DVec3| {
                let shader = Shader::<f64>::new(std::slice::from_ref(light), &material, &viewer).unwrap();
                let point = SurfacePoint { position: position.to_array(), normal: normal.to_array() };
                shader.shade(&point).unwrap()[0]
            };
            let shift = Shift { normal: 0.005, position: 0.02 };
            let of_shift = setting.shifted(&material, &[light], shift);
            let models = replacements(&light, DVec3::ZERO);
            for number in 0..150 {
                let [point, normal, aside] = [1, 2, 3].map(|k| direction(450 * (seed + 1) + 3 * number + k));
                let point = point * (1.0 - shift.position);
                let half = (towards - point).normalize() + (camera.eye - point).normalize();
                let normal = (half.normalize() + normal * [1.5, 0.2, 0.05][number as usize % 3]).normalize();
                let turned = DQuat::from_axis_angle(normal.cross(aside).normalize(), shift.normal) * normal;
                let one = lit(&light, point, normal);
                let mut compare = |which: usize, bound: Option<f64>, other: f64| {
                    let Some(bound) = bound else { return };
                    let off = (one - other).abs();
                    assert!(off <= bound + 1e-9, "{light:?} {which}: {off}, bound {bound}");
                    let closest = &mut closest[seed as usize % 4][which];
                    *closest = closest.max(off / bound);
                };
                compare(0, of_shift, lit(&light, point + aside * shift.position, turned));
                compare(0, of_shift, lit(&light, point, turned));
                for LightModel(new) in &models[1..] {
                    let other = new.map_or(0.0, |new| lit(&new, point, normal));
                    let which = if new.is_some() { 1 } else { 2 };
                    compare(which, setting.replaced(&material, &light, new.as_ref()), other);
                }
            }
        }
        // Of point, spot, rectangle and disc: another point, another lamp, no lamp.
        assert!(closest.iter().flatten().all(|&share| share > 0.3), "{closest:.2?}");
    }
}
