//! The small language of `--camera`, `--light` and `--material`: words `key=value`, with a kind in front of a light's.

use super::values::{colour, not_negative, number, vector};
use crease::num::{Degrees, LinearRgb, Radians};
use crease::raster::{Camera, Projection};
use crease::shade::{AreaShape, Attenuation, Cone, Light, Material, Reflectance, ShadeError};
use glam::DVec3;

/// Words `key=value` that are used up one by one.
struct Fields<'a> {
    pairs: Vec<(&'a str, &'a str)>,
    asked: Vec<&'static str>,
}

impl<'a> Fields<'a> {
    /// Those of a text that has some: an empty one is hardly meant.
    fn some(text: &'a str, such_as: &str) -> Result<Self, String> {
        match text.trim().is_empty() {
            true => Err(format!("words KEY=VALUE were expected, such as {such_as}")),
            false => Self::new(text.split_whitespace()),
        }
    }

    fn new(words: impl Iterator<Item = &'a str>) -> Result<Self, String> {
        let mut pairs: Vec<(&str, &str)> = Vec::new();
        for word in words {
            let Some((key, value)) = word.split_once('=') else {
                return Err(format!("{word:?} is not of the form KEY=VALUE"));
            };
            if pairs.iter().any(|(other, _)| *other == key) {
                return Err(format!("{key} is given twice"));
            }
            pairs.push((key, value));
        }
        Ok(Self { pairs, asked: Vec::new() })
    }

    fn take<T>(
        &mut self,
        key: &'static str,
        parse: impl Fn(&str) -> Result<T, String>,
    ) -> Result<Option<T>, String> {
        self.asked.push(key);
        let Some(at) = self.pairs.iter().position(|(other, _)| *other == key) else { return Ok(None) };
        let (_, value) = self.pairs.swap_remove(at);
        parse(value).map(Some).map_err(|reason| format!("{key}: {reason}"))
    }

    fn need<T>(&mut self, key: &'static str, parse: impl Fn(&str) -> Result<T, String>) -> Result<T, String> {
        self.take(key, parse)?.ok_or_else(|| format!("{key}= is missing"))
    }

    /// Nothing may be left.
    fn finish(self) -> Result<(), String> {
        match self.pairs.first() {
            None => Ok(()),
            Some((key, _)) => Err(format!("there is no {key}; there are {}", self.asked.join(", "))),
        }
    }
}

fn degrees(text: &str) -> Result<Radians, String> {
    number(text).map(|angle| Degrees(angle).into())
}

/// A number over 0.
fn positive(text: &str) -> Result<f64, String> {
    let number = number(text)?;
    if number > 0.0 { Ok(number) } else { Err(format!("{text:?} is not over 0")) }
}

/// The angle of a perspective.
fn opening(text: &str) -> Result<Radians, String> {
    let angle = number(text)?;
    match angle > 0.0 && angle < 180.0 {
        true => Ok(Degrees(angle).into()),
        false => Err(format!("{text:?} is not between 0 and 180 degrees")),
    }
}

/// What `--camera` changes of a camera.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct CameraChange {
    eye: Option<DVec3>,
    target: Option<DVec3>,
    up: Option<DVec3>,
    projection: Option<Projection>,
    near: Option<f64>,
}

/// The share of a distance before which nothing is drawn: depths are stored in floating point, so a near plane that is
/// close costs nothing.
const NEAR_SHARE: f64 = 1.0 / 4096.0;

impl CameraChange {
    /// Whether it names places or lengths, which are those of the scene as it is.
    pub fn has_places(&self) -> bool {
        let is_length = matches!(self.projection, Some(Projection::Orthographic(_)));
        self.eye.is_some() || self.target.is_some() || self.near.is_some() || is_length
    }

    /// A camera with what was given in place of what it had.
    ///
    /// The near distance of a camera that stood where it did to frame these `bounds` goes with the place: if that
    /// changes it is a share of the way to the target, or to the far side of what there is to see if that is nearer.
    /// Without `bounds` the camera is one that somebody has set up, and its near distance stays.
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
    let mut fields = Fields::some(text, "eye=3,2,5 target=0,0,0 angle=40")?;
    let change = CameraChange {
        eye: fields.take("eye", vector)?,
        target: fields.take("target", vector)?,
        up: fields.take("up", vector)?,
        projection: match (fields.take("angle", opening)?, fields.take("height", positive)?) {
            (Some(_), Some(_)) => return Err("angle and height exclude each other".into()),
            (Some(angle), None) => Some(Projection::Perspective(angle)),
            (None, Some(height)) => Some(Projection::Orthographic(height)),
            (None, None) => None,
        },
        near: fields.take("near", not_negative)?,
    };
    fields.finish()?;
    if change.eye.is_some() && change.eye == change.target {
        return Err("eye and target are the same point".into());
    }
    if change.up == Some(DVec3::ZERO) {
        return Err("up: a vector of length 0 points nowhere".into());
    }
    Ok(change)
}

pub fn light(text: &str) -> Result<Light, String> {
    let mut words = text.split_whitespace();
    let kind = words.next().unwrap_or_default();
    let mut fields = Fields::new(words)?;
    let white =
        |fields: &mut Fields| Ok::<_, String>(fields.take("colour", colour)?.unwrap_or(LinearRgb::WHITE));
    let fading = |fields: &mut Fields| {
        Ok::<_, String>(fields.take("attenuation", attenuation)?.unwrap_or(Attenuation::None))
    };
    let light = match kind {
        "directional" => {
            Light::Directional { towards: fields.need("towards", vector)?, colour: white(&mut fields)? }
        }
        "point" => Light::Point {
            position: fields.need("position", vector)?,
            colour: white(&mut fields)?,
            attenuation: fading(&mut fields)?,
        },
        "spot" => Light::Spot {
            position: fields.need("position", vector)?,
            colour: white(&mut fields)?,
            attenuation: fading(&mut fields)?,
            cone: cone(&mut fields)?,
        },
        "rectangle" => Light::Area {
            shape: AreaShape::Rectangle {
                centre: fields.need("centre", vector)?,
                u: fields.need("u", vector)?,
                v: fields.need("v", vector)?,
            },
            colour: white(&mut fields)?,
        },
        "disc" => Light::Area {
            shape: AreaShape::Disc {
                centre: fields.need("centre", vector)?,
                normal: fields.need("normal", vector)?,
                radius: fields.need("radius", number)?,
            },
            colour: white(&mut fields)?,
        },
        _ => {
            return Err("directional, point, spot, rectangle or disc was expected first; ambient light has an option \
                        of its own"
                .into());
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
        cut_off: fields.take("cut-off", degrees)?.unwrap_or(plain.cut_off),
        soft_edge: fields.take("soft-edge", degrees)?.unwrap_or(plain.soft_edge),
        exponent: fields.take("exponent", number)?.unwrap_or(plain.exponent),
        ..plain
    })
}

/// `none`, `inverse-square`, `inverse-square:RANGE`, `offset:K` or `KC,KL,KQ`.
fn attenuation(text: &str) -> Result<Attenuation, String> {
    match text.split_once(':') {
        None if text == "none" => Ok(Attenuation::None),
        None if text == "inverse-square" => Ok(Attenuation::InverseSquare),
        Some(("inverse-square", range)) => Ok(Attenuation::InverseSquareWithin { range: number(range)? }),
        Some(("offset", k)) => Ok(Attenuation::Offset { k: number(k)? }),
        _ => match vector(text) {
            Ok(DVec3 { x: constant, y: linear, z: quadratic }) => {
                Ok(Attenuation::Quadratic { constant, linear, quadratic })
            }
            Err(_) => {
                Err("none, inverse-square, inverse-square:RANGE, offset:K or KC,KL,KQ was expected".into())
            }
        },
    }
}

pub fn material(text: &str) -> Result<Material, String> {
    let mut fields = Fields::some(text, "colour=#c08040 ks=0.3 exponent=60")?;
    let own = fields.take("colour", colour)?.unwrap_or(LinearRgb::grey(0.8));
    let plastic = Material::plastic(own);
    let highlight = fields.take("highlight", colour)?.unwrap_or(LinearRgb::WHITE);
    let mut coefficient = |key, colour, plain| {
        let k = fields.take(key, not_negative)?;
        Ok::<_, String>(k.map_or(plain, |k| Reflectance::new(k, colour)))
    };
    let lit = |k: f64| Reflectance::new(k, own);
    let material = Material {
        ambient: coefficient("ka", own, lit(0.7))?,
        diffuse: coefficient("kd", own, lit(0.7))?,
        specular: coefficient("ks", highlight, Reflectance::new(0.2, highlight))?,
        exponent: fields.take("exponent", not_negative)?.unwrap_or(plastic.exponent),
        reflection: plastic.reflection,
    };
    fields.finish()?;
    Ok(material)
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
            attenuation: Attenuation::Quadratic { constant: 1.0, linear: 0.5, quadratic: 0.25 },
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
            ("", "was expected first"),
            ("ambient colour=1", "an option of its own"),
            ("point", "position= is missing"),
            ("point position=1,2", "three numbers"),
            ("point position=1,2,3 colour", "KEY=VALUE"),
            ("point position=1,2,3 position=1,2,3", "twice"),
            ("point position=1,2,3 radius=1", "there is no radius; there are position, colour, attenuation"),
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
            ("height=0", "height: \"0\" is not over 0"),
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
        let red = material("colour=1,0,0 ks=0 exponent=5").unwrap();
        assert_eq!(red.diffuse.merged(), LinearRgb::new(0.7, 0.0, 0.0));
        assert_eq!((red.specular.merged(), red.exponent), (LinearRgb::BLACK, 5.0));
        let metal = material("highlight=1,0.5,0 ks=0.5").unwrap();
        assert_eq!(metal.specular.merged(), LinearRgb::new(0.5, 0.25, 0.0));
        assert!(material("kd=-1").unwrap_err().contains("0 or more"));
        assert!(material("shiny=1").unwrap_err().contains("ka, kd, ks"));
    }
}
