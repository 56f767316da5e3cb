//! The lights of a scene file.

use crate::io::ReadError;
use crate::num::{Degrees, LinearRgb, Radians};
use crate::raster::load::toml::keys::{AttenuationKeys, LightKeys, PointKeys, SpotKeys};
use crate::raster::load::toml::place::Source;
use crate::raster::load::toml::values::Number;
use crate::shade::{AreaShape, Attenuation, Cone, Light, ShadeError};
use glam::DVec4;
use std::f64::consts::PI;
use std::ops::Range;

/// All lights in the order of the file; `None` if it has none.
pub(super) fn lights(source: Source, keys: &LightKeys) -> Result<Option<Vec<Light>>, ReadError> {
    let mut found: Vec<(Range<usize>, Light)> = Vec::new();
    for light in &keys.ambient {
        found.push((light.span(), Light::Ambient { colour: light.get_ref().colour.0 }));
    }
    for light in &keys.directional {
        let (towards, colour) = (light.get_ref().towards.get(), light.get_ref().colour.0);
        found.push((light.span(), Light::Directional { towards, colour }));
    }
    for light in &keys.point {
        found.push((light.span(), point(source, light.get_ref(), &light.span())?));
    }
    for light in &keys.spot {
        found.push((light.span(), spot(light.get_ref())));
    }
    for light in &keys.rectangle {
        let keys = light.get_ref();
        let shape = AreaShape::Rectangle { centre: keys.centre.get(), u: keys.u.get(), v: keys.v.get() };
        found.push((light.span(), Light::Area { shape, colour: keys.colour.0 }));
    }
    for light in &keys.disc {
        let keys = light.get_ref();
        let Number(radius) = keys.radius;
        let shape = AreaShape::Disc { centre: keys.centre.get(), normal: keys.normal.get(), radius };
        found.push((light.span(), Light::Area { shape, colour: keys.colour.0 }));
    }
    found.sort_by_key(|(span, _)| span.start);
    for (number, (span, light)) in found.iter().enumerate() {
        light.check(number).map_err(|error| wrong(source, span, &error))?;
    }
    let lights: Vec<Light> = found.into_iter().map(|(_, light)| light).collect();
    Ok((!lights.is_empty()).then_some(lights))
}

/// A number that `shade` refuses, at its key.
pub(super) fn wrong(source: Source, span: &Range<usize>, error: &ShadeError) -> ReadError {
    let keys: &[&str] = match error.field {
        "colour" => &["colour", "color"],
        "direction" => &["towards", "position"],
        "range" | "k" | "kc" | "kl" | "kq" | "kc + kl + kq" => &["attenuation"],
        "cut-off" => &["cut-off"],
        "soft edge" => &["soft-edge"],
        "spot exponent" => &["exponent"],
        "side u" => &["u"],
        "side v" | "pair of sides" => &["v"],
        "ambient reflection" => &["ambient"],
        "diffuse reflection" => &["diffuse"],
        "specular reflection" => &["specular"],
        field => &[field],
    };
    let found = format!("{} is {}", error.field, error.found);
    source.error(&source.member(span, keys), &found, &format!("it must be {}", error.expected))
}

fn point(source: Source, keys: &PointKeys, span: &Range<usize>) -> Result<Light, ReadError> {
    let position = match keys.position[..] {
        [Number(x), Number(y), Number(z)] => DVec4::new(x, y, z, 1.0),
        [Number(x), Number(y), Number(z), Number(w)] if w >= 0.0 => DVec4::new(x, y, z, w),
        [.., Number(w)] if keys.position.len() == 4 => {
            let advice = "w is 1 for a point, 0 for a light infinitely far away";
            return Err(source.error(&source.member(span, &["position"]), &format!("w is {w}"), advice));
        }
        _ => {
            let found = format!("{} numbers", keys.position.len());
            let advice = "a position has 3, or 4 with w: 1 for a point, 0 for a light infinitely far away";
            return Err(source.error(&source.member(span, &["position"]), &found, advice));
        }
    };
    Ok(Light::at(position, keys.colour.0, attenuation(keys.attenuation)))
}

/// Without a cut-off and an exponent it is the lectures' spot.
fn spot(keys: &SpotKeys) -> Light {
    let radians = |angle: Option<Number>, default: f64| match angle {
        // 180 degrees stand for no cut-off, which is π to the bit.
        Some(Number(180.0)) => Radians(PI),
        Some(Number(degrees)) => Degrees(degrees).into(),
        None => Radians(default),
    };
    let lectures = Cone::of_lectures(keys.axis.get());
    let cone = Cone {
        cut_off: radians(keys.cut_off, PI),
        soft_edge: radians(keys.soft_edge, 0.0),
        exponent: keys.exponent.map_or(lectures.exponent, |Number(exponent)| exponent),
        ..lectures
    };
    let (position, colour): (_, LinearRgb) = (keys.position.get(), keys.colour.0);
    Light::Spot { position, colour, attenuation: attenuation(keys.attenuation), cone }
}

fn attenuation(keys: AttenuationKeys) -> Attenuation {
    match keys {
        AttenuationKeys::None => Attenuation::None,
        AttenuationKeys::InverseSquare => Attenuation::InverseSquare,
        AttenuationKeys::InverseSquareWithin(Number(range)) => Attenuation::InverseSquareWithin { range },
        AttenuationKeys::Offset(Number(k)) => Attenuation::Offset { k },
        AttenuationKeys::Quadratic([Number(constant), Number(linear), Number(quadratic)]) => {
            Attenuation::Quadratic { constant, linear, quadratic }
        }
    }
}
