//! How much of a light reaches a point.

use super::hit::SurfaceHit;
use super::lamp::{Lamp, area_point, hammersley};
use super::whitted::Tracer;
use super::world::{FrameRay, Met};
use crate::num::LinearRgb;
use glam::DVec3;

/// Most surfaces of transmitting bodies between a point and a light; behind more there is no light.
const MOST_SURFACES: usize = 64;

/// How far shadow rays reach, as a share of the distance to the light: a surface that the light lies on does not hide it.
const SHORT: f64 = 1.0 - 1e-5;

impl Tracer<'_> {
    /// The share of a light that reaches a point. Opaque objects block it; a transmitting one weakens it by its `transmit` and
    /// Beer's law along the straight line: the light is not bent, so that there are no caustics.
    ///
    /// Area lights are sampled: the share is Σ w v/Σ w over points of the light, with the weights cos θ cos θ′/d² of the
    /// irradiance. It is exactly 1 if nothing is in the way.
    pub(super) fn visible(&mut self, light: usize, at: &SurfaceHit) -> LinearRgb {
        let count = self.job.settings.tracing.shadow_samples;
        let Some(&lamp) = self.scene.lamps.get(light).filter(|_| count > 0) else { return LinearRgb::WHITE };
        let start = at.off(at.shadow_position, at.facing);
        match lamp {
            Lamp::Everywhere => LinearRgb::WHITE,
            Lamp::Far(direction) => {
                self.through(&FrameRay { origin: start, direction, reach: f64::INFINITY })
            }
            Lamp::Point(position) => self.towards(start, position),
            Lamp::Area { centre, across, normal, is_disc } => {
                let surface_normal = at.normal.as_dvec3().normalize_or_zero();
                let (mut sum, mut weights, mut is_free) = (LinearRgb::BLACK, 0.0, true);
                for number in 0..count {
                    let place = hammersley(number, count, self.moved);
                    let point = area_point(centre, across, is_disc, place);
                    let away = point - start;
                    let square = away.length_squared();
                    let cosines = away.dot(surface_normal).max(0.0) * (-away.dot(normal)).max(0.0);
                    let weight = cosines / (square * square);
                    if weight > 0.0 && weight.is_finite() {
                        let share = self.towards(start, point);
                        is_free &= share == LinearRgb::WHITE;
                        sum += share * weight;
                        weights += weight;
                    }
                }
                if is_free { LinearRgb::WHITE } else { sum * (1.0 / weights) }
            }
        }
    }

    fn towards(&mut self, start: DVec3, point: DVec3) -> LinearRgb {
        let away = point - start;
        let distance = away.length();
        if distance == 0.0 || !distance.is_finite() {
            return LinearRgb::WHITE;
        }
        self.through(&FrameRay { origin: start, direction: away / distance, reach: distance * SHORT })
    }

    /// The share of light that passes along a ray.
    fn through(&mut self, ray: &FrameRay) -> LinearRgb {
        let (job, world) = (self.job, &self.scene.world);
        let transmits = |object: usize| job.objects[object].optics.transmits();
        let is_triangle_opaque = |id: u32| !transmits(job.drawn[job.owner(id)].object);
        self.rays += 1;
        let clear = self.scene.transmits;
        if world.is_blocked(ray, &mut self.stack, |hit| !clear || is_triangle_opaque(hit.id), &|object, _| {
            !clear || !transmits(object)
        }) {
            return LinearRgb::BLACK;
        }
        if !clear {
            return LinearRgb::WHITE;
        }
        let mut share = LinearRgb::WHITE;
        let mut rest = *ray;
        for _ in 0..MOST_SURFACES {
            let met =
                world.nearest(&rest, &mut self.stack, |hit| !is_triangle_opaque(hit.id), &|object, _| {
                    transmits(object)
                });
            let Some((distance, met)) = met else { return share };
            let object = match &met {
                Met::Triangle(hit) => job.drawn[job.owner(hit.id)].object,
                Met::Solid { object, .. } => *object,
            };
            let optics = &job.objects[object].optics;
            let hit = SurfaceHit::new(job, rest.direction, distance, &met);
            share = share
                * match hit.front {
                    true => optics.transmit,
                    false => optics.transmittance(distance * job.frame.unit),
                };
            let origin = hit.leave(hit.position, rest.direction);
            rest = FrameRay { origin, reach: rest.reach - distance, ..rest };
            if rest.reach <= 0.0 {
                return share;
            }
        }
        LinearRgb::BLACK
    }
}
