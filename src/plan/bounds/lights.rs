//! Bounds on the light that arrives at the points of a ball: its strength, its direction, and how both change with the point and with a
//! cheaper light.
//!
//! The ball has the radius r, and the light is at the distance D of its middle. An area light of area A reaches up to ρ from its centre.
//! Each of its points y brings (A/π) cos θ_y/d² to a surface at the distance d, where θ_y is the angle to the normal of the light. It is seen
//! within a cone of half the opening σ = asin(ρ/(D − r)), so that the sum over y is at most 2 (1 − cos σ): its solid angle over π.
//!
//! Two points of the ball at a distance s see y in directions that differ by a = asin(s/n), n = D − r − ρ. So the sum differs by at most
//! (A/π) ((1 + a)/n² − 1/(n + s)²). A spot in the centre, with A/π and the same law, differs from the sum by at most (A/π) ((1 + σ)/n² −
//! 1/(n + ρ)²). What arrives from different directions adds up as vectors for the highlight, whose factor differs by (A/π) σ/n² more.

use crate::num::angle_between;
use crate::plan::lights::{Emitter, cheaper_kind, constant, emitter};
use crate::shade::{Attenuation, Cone, Light};
use glam::DVec3;
use std::f64::consts::{FRAC_1_PI, PI};

/// A ball around all that is lit.
#[derive(Clone, Copy, Debug)]
pub struct Ball {
    pub middle: DVec3,
    pub radius: f64,
}

/// What another light in place of one is off by.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Replacement {
    /// The strength of diffuse light and of the highlight.
    pub strength: [f64; 2],
    /// The direction, in radians.
    pub direction: f64,
    /// The light that takes its place.
    pub light: Light,
}

impl Ball {
    /// The largest strength of a light at a point of the ball; `None` without a bound.
    pub fn strength(&self, light: &Light) -> Option<f64> {
        let colour = light.colour().largest();
        match light {
            Light::Ambient { .. } | Light::Directional { .. } => Some(colour),
            Light::Point { .. } | Light::Spot { .. } => Some(colour * self.factors(light)?[1]),
            Light::Area { shape, .. } => {
                Some(colour * 2.0 * (1.0 - libm::cos(self.half_angle(&emitter(shape)?)?)))
            }
        }
    }

    /// How much the strength of diffuse light and that of the highlight differ between points of the ball at a distance.
    pub fn strength_off(&self, light: &Light, between: f64) -> Option<[f64; 2]> {
        let colour = light.colour().largest();
        match light {
            _ if between == 0.0 => Some([0.0; 2]),
            Light::Ambient { .. } | Light::Directional { .. } => Some([0.0; 2]),
            Light::Point { position, attenuation, .. } | Light::Spot { position, attenuation, .. } => {
                let [nearest, _] = self.distances(*position)?;
                let farthest = match attenuation {
                    // 1/d² is steepest where it is nearest.
                    Attenuation::InverseSquare => nearest + between,
                    _ => nearest + 2.0 * self.radius,
                };
                let most = finite(attenuation.factor(nearest))?;
                let [least_of_cone, most_of_cone] = self.cone_factors(light);
                let off = (most - attenuation.factor(farthest)) * most_of_cone;
                Some([colour * (off + most * (most_of_cone - least_of_cone)); 2])
            }
            Light::Area { shape, .. } => {
                let it = emitter(shape)?;
                let nearest = self.nearest(&it)?;
                let share = colour * it.area * FRAC_1_PI;
                let turn = self.direction_off(light, between)?;
                let diffuse = share * ((1.0 + turn) / square(nearest) - 1.0 / square(nearest + between));
                Some([diffuse, diffuse + self.strength(light)? * turn])
            }
        }
    }

    /// The angle between the directions from two points of the ball at a distance to a point of the light.
    pub fn direction_off(&self, light: &Light, between: f64) -> Option<f64> {
        let nearest = match light {
            _ if between == 0.0 => return Some(0.0),
            Light::Ambient { .. } | Light::Directional { .. } => return Some(0.0),
            Light::Point { position, .. } | Light::Spot { position, .. } => self.distances(*position)?[0],
            Light::Area { shape, .. } => self.nearest(&emitter(shape)?)?,
        };
        (between < nearest).then(|| libm::asin(between / nearest))
    }

    /// The direction from the middle to a light, and the largest angle between it and that from a point of the ball to a point of the light.
    pub fn directions(&self, light: &Light) -> Option<(DVec3, f64)> {
        let (place, reach) = match light {
            Light::Ambient { .. } => return None,
            Light::Directional { towards, .. } => return Some((*towards, 0.0)),
            Light::Point { position, .. } | Light::Spot { position, .. } => (*position, 0.0),
            Light::Area { shape, .. } => emitter(shape).map(|it| (it.centre, it.reach))?,
        };
        let share = (self.radius + reach) / place.distance(self.middle);
        (share < 1.0).then(|| (place - self.middle, libm::asin(share)))
    }

    /// The angle between the directions from one point of the ball to two points of the light.
    pub fn width(&self, light: &Light) -> Option<f64> {
        let Light::Area { shape, .. } = light else { return Some(0.0) };
        Some(2.0 * self.half_angle(&emitter(shape)?)?)
    }

    /// The steps from a light to a cheaper one that may replace it, from kind to kind; `None` if one of them has no bound.
    pub fn replacements(&self, old: &Light, new: &Light) -> Option<Vec<Replacement>> {
        let (mut at, mut steps) = (*old, Vec::new());
        while at != *new {
            let next = match constant(&at, self.middle) {
                Some(constant) if constant == *new => constant,
                _ => cheaper_kind(&at, self.middle)?,
            };
            steps.push(self.replacement(&at, next)?);
            at = next;
        }
        Some(steps)
    }

    /// One step.
    fn replacement(&self, old: &Light, new: Light) -> Option<Replacement> {
        let colour = old.colour().largest();
        let (strength, direction) = match (old, &new) {
            (Light::Area { shape, .. }, Light::Spot { .. }) => {
                let it = emitter(shape)?;
                let (nearest, turn) = (self.nearest(&it)?, self.half_angle(&it)?);
                let share = colour * it.area * FRAC_1_PI;
                let diffuse = share * ((1.0 + turn) / square(nearest) - 1.0 / square(nearest + it.reach));
                ([diffuse, diffuse + share * turn / square(nearest)], turn)
            }
            (Light::Spot { position, attenuation, .. }, Light::Point { attenuation: other, .. })
                if attenuation == other =>
            {
                let kept = new.colour().largest() / colour;
                let [least, most] = self.cone_factors(old);
                let factor = finite(attenuation.factor(self.distances(*position)?[0]))?;
                ([colour * factor * (most - kept).max(kept - least).max(0.0); 2], 0.0)
            }
            (Light::Spot { .. }, Light::Spot { .. }) => {
                // The cone is the same, and the factor of the distance that in the middle.
                let [_, most] = self.cone_factors(old);
                ([most * self.off_constant(old, &new)?; 2], 0.0)
            }
            (Light::Point { .. }, Light::Point { .. }) => ([self.off_constant(old, &new)?; 2], 0.0),
            (Light::Point { .. }, Light::Directional { .. }) => {
                ([self.off_constant(old, &new)?; 2], self.directions(old)?.1)
            }
            _ => return None,
        };
        Some(Replacement { strength, direction, light: new })
    }

    /// How far the attenuated strength of a light is from the constant one of another.
    fn off_constant(&self, old: &Light, new: &Light) -> Option<f64> {
        let (Light::Point { position, attenuation, .. } | Light::Spot { position, attenuation, .. }) = old
        else {
            return None;
        };
        let colour = old.colour().largest();
        let ends = self.distances(*position)?.map(|distance| colour * attenuation.factor(distance));
        let constant = new.colour().largest();
        finite((ends[0] - constant).abs().max((constant - ends[1]).abs()))
    }

    /// The smallest and the largest factor of distance and cone of a light that comes from a point.
    fn factors(&self, light: &Light) -> Option<[f64; 2]> {
        let (Light::Point { position, attenuation, .. } | Light::Spot { position, attenuation, .. }) = light
        else {
            return None;
        };
        let [nearest, farthest] = self.distances(*position)?;
        let [least, most] = self.cone_factors(light);
        Some([attenuation.factor(farthest) * least, finite(attenuation.factor(nearest) * most)?])
    }

    /// The smallest and the largest factor of a spot's cone on the ball: it falls with the angle to the axis. 1 for others.
    fn cone_factors(&self, light: &Light) -> [f64; 2] {
        /// Radians by which rounding may move the edge of a cone.
        const ROUNDING: f64 = 1e-6;
        let Light::Spot { position, cone, .. } = light else { return [1.0; 2] };
        let way = self.middle - *position;
        let (turn, angle) = match self.radius < way.length() {
            true => (libm::asin(self.radius / way.length()), angle_between(cone.axis, way).0),
            false => (PI, 0.0),
        };
        let at = |angle: f64| factor_at(cone, angle.clamp(0.0, PI));
        [at(angle + turn + ROUNDING), at(angle - turn - ROUNDING)]
    }

    /// The smallest and the largest distance of a position from a point of the ball; `None` for positions in it.
    fn distances(&self, position: DVec3) -> Option<[f64; 2]> {
        let distance = position.distance(self.middle);
        (distance > self.radius).then_some([distance - self.radius, distance + self.radius])
    }

    /// The smallest distance between a point of the ball and one of the light; `None` if they may meet.
    fn nearest(&self, emitter: &Emitter) -> Option<f64> {
        let nearest = self.distances(emitter.centre)?[0] - emitter.reach;
        (nearest > 0.0).then_some(nearest)
    }

    /// Half the angle at which a point of the ball sees an area light.
    fn half_angle(&self, emitter: &Emitter) -> Option<f64> {
        Some(libm::asin(emitter.reach / (self.nearest(emitter)? + emitter.reach)))
    }
}

/// The factor of a cone at an angle to its axis.
fn factor_at(cone: &Cone, angle: f64) -> f64 {
    let axis = cone.axis.normalize_or_zero();
    let (sine, cosine) = libm::sincos(angle);
    cone.factor(axis * cosine + axis.any_orthonormal_vector() * sine)
}

fn square(x: f64) -> f64 {
    x * x
}

fn finite(x: f64) -> Option<f64> {
    x.is_finite().then_some(x)
}
