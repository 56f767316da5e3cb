//! Cheaper lights in place of a declared one, with the light that they bring to the middle of the objects unchanged.

use super::axes::LightModel;
use crate::num::Radians;
use crate::shade::{AreaShape, Attenuation, Cone, Light};
use glam::DVec3;
use std::f64::consts::{FRAC_1_PI, FRAC_PI_2, PI};

/// The lights of a plan: one of the replacements of each declared light, by number.
pub type LightChoice = Vec<usize>;

/// The declared light and what may replace it, from expensive to cheap; the last one is no light.
///
/// `middle` is the centre of what is lit. There every replacement brings the same light as the declared one.
///
/// - An area light becomes a point with the cosine law of a surface that shines, 1/d² and the power of its area A: I·A/π.
/// - A spot becomes a point.
/// - 1/d² and its like become the factor at the middle.
/// - A point becomes a directional light.
pub fn replacements(light: &Light, middle: DVec3) -> Vec<LightModel> {
    let mut models = Vec::new();
    let mut kind = Some(*light);
    while let Some(light) = kind {
        models.push(LightModel(Some(light)));
        models.extend(constant(&light, middle).map(|light| LightModel(Some(light))));
        kind = cheaper_kind(&light, middle);
    }
    models.push(LightModel(None));
    models
}

/// A light with the attenuation at the middle everywhere.
pub(super) fn constant(light: &Light, middle: DVec3) -> Option<Light> {
    let (position, colour, attenuation) = match *light {
        Light::Point { position, colour, attenuation } => (position, colour, attenuation),
        Light::Spot { position, colour, attenuation, .. } => (position, colour, attenuation),
        _ => return None,
    };
    let factor = attenuation.factor(position.distance(middle));
    if attenuation == Attenuation::None || !(factor.is_finite() && factor > 0.0) {
        return None;
    }
    let (colour, attenuation) = (colour * factor, Attenuation::None);
    Some(match *light {
        Light::Spot { cone, .. } => Light::Spot { position, colour, attenuation, cone },
        _ => Light::Point { position, colour, attenuation },
    })
}

/// The next cheaper kind of light.
pub(super) fn cheaper_kind(light: &Light, middle: DVec3) -> Option<Light> {
    match *light {
        Light::Ambient { .. } | Light::Directional { .. } => None,
        Light::Area { shape, colour } => {
            let Emitter { centre, normal, area, .. } = emitter(&shape)?;
            let cone =
                Cone { axis: normal, cut_off: Radians(FRAC_PI_2), soft_edge: Radians(0.0), exponent: 1.0 };
            let colour = colour * (area * FRAC_1_PI);
            Some(Light::Spot { position: centre, colour, attenuation: Attenuation::InverseSquare, cone })
        }
        Light::Spot { position, colour, attenuation, cone } => {
            let factor = cone.factor(middle - position);
            let point = Light::Point { position, colour: colour * factor, attenuation };
            (factor > 0.0).then_some(point)
        }
        Light::Point { position, colour, attenuation } => {
            let towards = position - middle;
            let colour = colour * attenuation.factor(towards.length());
            (towards.length() > 0.0 && colour.is_finite()).then_some(Light::Directional { towards, colour })
        }
    }
}

/// A surface that shines.
pub(super) struct Emitter {
    pub centre: DVec3,
    /// Of length 1.
    pub normal: DVec3,
    pub area: f64,
    /// The largest distance of its points from the centre.
    pub reach: f64,
}

/// The surface of an area light; `None` without a normal.
pub(super) fn emitter(shape: &AreaShape) -> Option<Emitter> {
    /// The corners of the polygon that is computed for a disc are up to 1.0008 radii from its centre.
    const CORNERS: f64 = 1.001;
    let (centre, normal, area, reach) = match *shape {
        AreaShape::Rectangle { centre, u, v } => {
            let (wide, high) = (u.length(), v.length());
            (centre, u.cross(v), 4.0 * wide * high, libm::hypot(wide, high))
        }
        AreaShape::Disc { centre, normal, radius } => {
            (centre, normal, PI * radius * radius, CORNERS * radius)
        }
    };
    Some(Emitter { centre, normal: normal.try_normalize()?, area, reach })
}
