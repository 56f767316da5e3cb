//! Values of `--camera`, `--light` and `--material`: words `key=value`, with a kind in front of a light's.

use crate::cli::common::options::{colour, not_negative, number, vector};
use crease::num::{Degrees, LinearRgb, Radians};
use crease::raster::{Camera, Projection};
use crease::shade::{AreaShape, Attenuation, Cone, Light, Material, Optics, Reflectance, ShadeError};
use glam::DVec3;

/// Words `key=value` that are used up one by one.
struct Fields<'a> {
    pairs: Vec<(&'a str, &'a str)>,
    known: Vec<&'static str>,
}

impl<'a> Fields<'a> {
    fn new(words: &'a str) -> Result<Self, String> {
        let mut pairs: Vec<(&str, &str)> = Vec::new();
        for word in words.split_whitespace() {
            let (key, value) =
                word.split_once('=').ok_or_else(|| format!("{word:?} is not of the form KEY=VALUE"))?;
            if pairs.iter().any(|(other, _)| *other == key) {
                return Err(format!("{key} is given twice"));
            }
            pairs.push((key, value));
        }
        Ok(Self { pairs, known: Vec::new() })
    }

    /// The fields of a text that has some; an empty one is an error.
    fn some(text: &'a str, such_as: &str) -> Result<Self, String> {
        match text.trim() {
            "" => Err(format!("expected words KEY=VALUE, such as {such_as}")),
            words => Self::new(words),
        }
    }

    fn take<T>(
        &mut self,
        key: &'static str,
        parse: impl Fn(&str) -> Result<T, String>,
    ) -> Result<Option<T>, String> {
        self.known.push(key);
        let Some(at) = self.pairs.iter().position(|(other, _)| *other == key) else { return Ok(None) };
        let (_, value) = self.pairs.swap_remove(at);
        parse(value).map(Some).map_err(|reason| format!("{key}: {reason}"))
    }

    fn need<T>(&mut self, key: &'static str, parse: impl Fn(&str) -> Result<T, String>) -> Result<T, String> {
        self.take(key, parse)?.ok_or_else(|| format!("{key}= is missing"))
    }

    fn take_or<T>(
        &mut self,
        key: &'static str,
        parse: impl Fn(&str) -> Result<T, String>,
        default: T,
    ) -> Result<T, String> {
        Ok(self.take(key, parse)?.unwrap_or(default))
    }

    fn colour(&mut self) -> Result<LinearRgb, String> {
        self.take_or("colour", colour, LinearRgb::WHITE)
    }

    fn attenuation(&mut self) -> Result<Attenuation, String> {
        self.take_or("attenuation", attenuation, Attenuation::None)
    }

    fn finish(self) -> Result<(), String> {
        match self.pairs.first() {
            None => Ok(()),
            Some((key, _)) => Err(format!("unknown key {key}; the keys are {}", self.known.join(", "))),
        }
    }
}

fn degrees(text: &str) -> Result<Radians, String> {
    number(text).map(|angle| Degrees(angle).into())
}

/// The parts of a camera that `--camera` changes.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct CameraChange {
    eye: Option<DVec3>,
    target: Option<DVec3>,
    up: Option<DVec3>,
    projection: Option<Projection>,
    near: Option<f64>,
}

/// The near distance as a share of the distance to the target. Depths are stored in floating point, so a near plane that is
/// close costs nothing.
const NEAR_SHARE: f64 = 1.0 / 4096.0;

impl CameraChange {
    /// Whether it contains positions or lengths, which are those of the unchanged scene.
    pub fn has_places(&self) -> bool {
        let is_length = matches!(self.projection, Some(Projection::Orthographic(_)));
        self.eye.is_some() || self.target.is_some() || self.near.is_some() || is_length
    }

    /// The changed camera.
    ///
    /// `bounds` are those of the objects if the camera was placed to frame them. If it moves then, its near distance
    /// becomes a share of the distance to the target, or to the far side of the bounds if that is nearer. The near
    /// distance of an authored camera (no `bounds`) stays.
    pub fn apply(&self, camera: &Camera, bounds: Option<(DVec3, DVec3)>) -> Camera {
        let (eye, target) = (self.eye.unwrap_or(camera.eye), self.target.unwrap_or(camera.target));
        let moved = bounds.filter(|_| self.eye.is_some() || self.target.is_some()).map(|(low, high)| {
            let reach = (eye - low).abs().max((eye - high).abs()).length();
            eye.distance(target).min(reach) * NEAR_SHARE
        });
        Camera {
            eye,
            target,
            up: self.up.unwrap_or(camera.up),
            projection: self.projection.unwrap_or(camera.projection),
            near: self.near.or(moved).unwrap_or(camera.near),
        }
    }
}

pub fn camera(text: &str) -> Result<CameraChange, String> {
    let opening = |text: &str| match number(text)? {
        angle if angle > 0.0 && angle < 180.0 => Ok(Projection::Perspective(Degrees(angle).into())),
        _ => Err(format!("{text:?} is not between 0 and 180 degrees")),
    };
    let height = |text: &str| match number(text)? {
        height if height > 0.0 => Ok(Projection::Orthographic(height)),
        _ => Err(format!("{text:?} is not above 0")),
    };
    let mut fields = Fields::some(text, "eye=3,2,5 target=0,0,0 angle=40")?;
    let (eye, target, up) =
        (fields.take("eye", vector)?, fields.take("target", vector)?, fields.take("up", vector)?);
    let projections = (fields.take("angle", opening)?, fields.take("height", height)?);
    let near = fields.take("near", not_negative)?;
    fields.finish()?;
    match projections {
        (Some(_), Some(_)) => Err("angle and height exclude each other".into()),
        _ if eye.is_some() && eye == target => Err("eye and target are the same point".into()),
        _ if up == Some(DVec3::ZERO) => Err("up: a vector of length 0 points nowhere".into()),
        (angle, height) => Ok(CameraChange { eye, target, up, projection: angle.or(height), near }),
    }
}

pub fn light(text: &str) -> Result<Light, String> {
    let text = text.trim_start();
    let (kind, words) = text.split_once(char::is_whitespace).unwrap_or((text, ""));
    let mut fields = Fields::new(words)?;
    let light = match kind {
        "directional" => {
            Light::Directional { towards: fields.need("towards", vector)?, colour: fields.colour()? }
        }
        "point" => Light::Point {
            position: fields.need("position", vector)?,
            colour: fields.colour()?,
            attenuation: fields.attenuation()?,
        },
        "spot" => Light::Spot {
            position: fields.need("position", vector)?,
            colour: fields.colour()?,
            attenuation: fields.attenuation()?,
            cone: cone(&mut fields)?,
        },
        "rectangle" => Light::Area {
            shape: AreaShape::Rectangle {
                centre: fields.need("centre", vector)?,
                u: fields.need("u", vector)?,
                v: fields.need("v", vector)?,
            },
            colour: fields.colour()?,
        },
        "disc" => Light::Area {
            shape: AreaShape::Disc {
                centre: fields.need("centre", vector)?,
                normal: fields.need("normal", vector)?,
                radius: fields.need("radius", number)?,
            },
            colour: fields.colour()?,
        },
        _ => {
            return Err(
                "expected directional, point, spot, rectangle or disc first; for ambient light use --ambient"
                    .into(),
            );
        }
    };
    fields.finish()?;
    light.check(0).map_err(|ShadeError { field, found, expected, .. }| {
        format!("{field} is {found}; it must be {expected}")
    })?;
    Ok(light)
}

fn cone(fields: &mut Fields) -> Result<Cone, String> {
    let plain = Cone::of_lectures(fields.need("axis", vector)?);
    Ok(Cone {
        cut_off: fields.take_or("cut-off", degrees, plain.cut_off)?,
        soft_edge: fields.take_or("soft-edge", degrees, plain.soft_edge)?,
        exponent: fields.take_or("exponent", number, plain.exponent)?,
        ..plain
    })
}

/// `none`, `inverse-square`, `inverse-square:RANGE`, `offset:K` or `KC,KL,KQ`.
fn attenuation(text: &str) -> Result<Attenuation, String> {
    match text.split_once(':') {
        None if text == "none" => Ok(Attenuation::None),
        None if text == "inverse-square" => Ok(Attenuation::InverseSquare),
        Some(("inverse-square", range)) => Ok(Attenuation::InverseSquareWithin(number(range)?)),
        Some(("offset", k)) => Ok(Attenuation::Offset(number(k)?)),
        _ => match vector(text) {
            Ok(coefficients) => Ok(Attenuation::Quadratic(coefficients.to_array())),
            Err(_) => Err("expected none, inverse-square, inverse-square:RANGE, offset:K or KC,KL,KQ".into()),
        },
    }
}

/// A material with its reflection and transmission of rays.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct TypedMaterial {
    pub material: Material,
    pub optics: Optics,
}

/// A refractive index.
fn index(text: &str) -> Result<f64, String> {
    match number(text)? {
        index if index >= 1.0 => Ok(index),
        _ => Err(format!("{text:?} is below 1; a refractive index is 1 or more")),
    }
}

pub fn material(text: &str) -> Result<TypedMaterial, String> {
    let mut fields = Fields::some(text, "colour=#c08040 ks=0.3 exponent=60")?;
    let own = fields.take_or("colour", colour, LinearRgb::grey(0.8))?;
    let plastic = Material::plastic(own);
    let highlight = fields.take_or("highlight", colour, LinearRgb::WHITE)?;
    let optics = Optics {
        reflect: fields.take_or("reflect", colour, LinearRgb::BLACK)?,
        transmit: fields.take_or("transmit", colour, LinearRgb::BLACK)?,
        ior: fields.take_or("ior", index, Optics::NONE.ior)?,
        absorb: fields.take_or("absorb", colour, LinearRgb::BLACK)?,
    };
    let kd = 0.7 * optics.opaque_share();
    let mut reflectance =
        |key, colour, k| Ok::<_, String>(Reflectance::new(fields.take_or(key, not_negative, k)?, colour));
    let material = Material {
        ambient: reflectance("ka", own, kd)?,
        diffuse: reflectance("kd", own, kd)?,
        specular: reflectance("ks", highlight, 0.2)?,
        exponent: fields.take_or("exponent", not_negative, plastic.exponent)?,
        reflection: plastic.reflection,
    };
    fields.finish()?;
    Ok(TypedMaterial { material, optics })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn lights_are_kinds_with_fields() {
        let sun = Light::Directional { towards: DVec3::new(1.0, 2.0, 3.0), colour: LinearRgb::WHITE };
        assert_eq!(light("directional towards=1,2,3"), Ok(sun));
        let lamp = Light::Point {
            position: DVec3::Y,
            colour: LinearRgb::grey(2.0),
            attenuation: Attenuation::Quadratic([1.0, 0.5, 0.25]),
        };
        assert_eq!(light("point colour=2 attenuation=1,0.5,0.25 position=0,1,0"), Ok(lamp));
        for (text, kind) in [
            ("spot position=0,2,0 axis=0,-1,0 cut-off=30 soft-edge=5 exponent=2", "spot"),
            ("rectangle centre=0,2,0 u=1,0,0 v=0,0,1 colour=#ffeedd", "rectangle"),
            ("disc centre=0,2,0 normal=0,-1,0 radius=0.5", "disc"),
        ] {
            assert_eq!(light(text).unwrap().kind(), kind);
        }
        let wrong = [
            ("", "expected directional, point, spot, rectangle or disc first"),
            ("ambient colour=1", "for ambient light use --ambient"),
            ("point", "position= is missing"),
            ("point position=1,2", "three numbers"),
            ("point position=1,2,3 colour", "KEY=VALUE"),
            ("point position=1,2,3 position=1,2,3", "twice"),
            (
                "point position=1,2,3 radius=1",
                "unknown key radius; the keys are position, colour, attenuation",
            ),
            ("point position=1,2,3 attenuation=some", "inverse-square:RANGE"),
            ("disc centre=0,0,0 normal=0,1,0 radius=0", "radius is 0; it must be"),
            ("directional towards=0,0,0", "direction is"),
            ("spot position=0,0,0 axis=0,0,-1 cut-off=200", "cut-off is 200°"),
            ("spot position=0,0,0 axis=0,0,-1 exponent=-1", "exponent is -1"),
            ("point position=1,2,3 attenuation=0,0,0", "kc + kl + kq"),
            ("disc centre=0,0,0 normal=0,1,0 radius=wide", "radius: \"wide\" is not a finite number"),
        ];
        for (text, expected) in wrong {
            let message = light(text).unwrap_err();
            assert!(message.contains(expected), "{text}: {message}");
        }
    }

    #[test]
    fn cameras_change_what_is_given() {
        let base = Camera::framing((DVec3::ZERO, DVec3::ONE), 1.0);
        let bounds = Some((DVec3::NEG_ONE, DVec3::ONE));
        assert_eq!(CameraChange::default().apply(&base, bounds), base);
        let moved = camera("eye=0,0,4096 target=0,0,0 height=3").unwrap();
        let framed = moved.apply(&base, bounds);
        assert_eq!((framed.near, framed.projection), (1.0, Projection::Orthographic(3.0)));
        assert_eq!(framed.up, base.up);
        // A near distance that somebody has chosen stays.
        assert_eq!(moved.apply(&base, None).near, base.near);
        assert_eq!(camera("near=0.5").unwrap().apply(&base, bounds), Camera { near: 0.5, ..base });
        // A target far beyond what is seen cuts nothing of it off.
        let far = camera("eye=0,0,5 target=0,0,-30000").unwrap().apply(&base, bounds);
        assert!(far.near < 0.002, "{far:?}");
        assert!(camera("angle=30 height=2").unwrap_err().contains("exclude"));
        let wrong = [
            ("angle=180", "angle: \"180\" is not between 0 and 180 degrees"),
            ("height=0", "height: \"0\" is not above 0"),
            ("near=-1", "near: \"-1\""),
            ("eye=1,2,3 target=1,2,3", "same point"),
            ("up=0,0,0", "points nowhere"),
        ];
        for (text, expected) in wrong {
            let message = camera(text).unwrap_err();
            assert!(message.contains(expected), "{text}: {message}");
        }
        assert!(camera("zoom=2").unwrap_err().contains("eye, target, up, angle, height, near"));
    }

    #[test]
    fn materials_are_plastic_unless_specified() {
        let red = material("colour=1,0,0 ks=0 exponent=5").unwrap().material;
        assert_eq!(red.diffuse.merged(), LinearRgb::new(0.7, 0.0, 0.0));
        assert_eq!((red.specular.merged(), red.exponent), (LinearRgb::BLACK, 5.0));
        let metal = material("highlight=1,0.5,0 ks=0.5").unwrap().material;
        assert_eq!(metal.specular.merged(), LinearRgb::new(0.5, 0.25, 0.0));
        let glass = material("transmit=1 ior=1.33 absorb=0.5,0,0").unwrap();
        assert_eq!(glass.material.diffuse.merged(), LinearRgb::BLACK);
        assert_eq!((glass.optics.ior, glass.optics.absorb), (1.33, LinearRgb::new(0.5, 0.0, 0.0)));
        assert!(material("ior=0.5").unwrap_err().contains("below 1"));
        assert!(material("ior=inf").unwrap_err().contains("ior"));
        assert!(material("kd=-1").unwrap_err().contains("0 or more"));
        assert!(material("shiny=1").unwrap_err().contains("ka, kd, ks"));
    }
}
