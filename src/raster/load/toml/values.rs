//! Values of scene files: numbers that are finite, colours, reflectances, transforms.

use crate::num::{LinearRgb, Srgb8};
use crate::raster::load::rotation;
use crate::shade::Reflectance;
use glam::{DMat4, DVec3};
use serde::de::value::{MapAccessDeserializer, SeqAccessDeserializer};
use serde::de::{Deserialize, Deserializer, Error, IntoDeserializer, MapAccess, SeqAccess, Visitor};
use std::fmt;

/// A finite number, whole or not.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Number(pub(super) f64);

/// Three finite numbers.
#[derive(Clone, Copy, Debug, PartialEq, serde::Deserialize)]
pub(super) struct Vector([Number; 3]);

impl Vector {
    pub(super) fn get(self) -> DVec3 {
        DVec3::from(self.0.map(|Number(x)| x))
    }
}

/// A colour: three linear components, one for a grey, or `"#rrggbb"` as screens have it.
#[derive(Clone, Copy, Debug, PartialEq, serde::Deserialize)]
#[serde(try_from = "Loose")]
pub(super) struct Colour(pub(super) LinearRgb);

/// How much light is returned: k, to go with the colour of the material; K as a colour; or both apart.
#[derive(Clone, Copy, Debug, PartialEq, serde::Deserialize)]
#[serde(try_from = "Loose")]
pub(super) enum Reflects {
    Coefficient(f64),
    Whole(Reflectance),
}

/// A factor for all axes, or one for each.
#[derive(Clone, Copy, Debug, PartialEq, serde::Deserialize)]
#[serde(try_from = "Loose")]
pub(super) struct Scale(DVec3);

/// One step of a transform.
#[derive(Clone, Copy, Debug, PartialEq, serde::Deserialize)]
#[serde(rename_all = "kebab-case")]
pub(super) enum Step {
    Scale(Scale),
    /// Degrees about x, then y, then z.
    Rotate(Vector),
    Translate(Vector),
    /// Rows of an affine map.
    Matrix([[Number; 4]; 3]),
}

impl Step {
    pub(super) fn matrix(self) -> DMat4 {
        match self {
            Step::Scale(Scale(factors)) => DMat4::from_scale(factors),
            Step::Rotate(degrees) => rotation(degrees.get()),
            Step::Translate(by) => DMat4::from_translation(by.get()),
            Step::Matrix(rows) => {
                let [x, y, z] = rows.map(|row| row.map(|Number(x)| x));
                DMat4::from_cols_array_2d(&[x, y, z, [0.0, 0.0, 0.0, 1.0]]).transpose()
            }
        }
    }
}

impl<'de> Deserialize<'de> for Number {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        // By hand, for only what is said inside gets the number's own line in a list of many.
        struct Finite;
        impl Visitor<'_> for Finite {
            type Value = Number;

            fn expecting(&self, f: &mut fmt::Formatter) -> fmt::Result {
                f.write_str("a finite number")
            }

            fn visit_i64<E: Error>(self, number: i64) -> Result<Number, E> {
                Ok(Number(number as f64))
            }

            fn visit_f64<E: Error>(self, number: f64) -> Result<Number, E> {
                match number.is_finite() {
                    true => Ok(Number(number)),
                    false => Err(E::custom(format!("{number} is not a finite number"))),
                }
            }
        }
        deserializer.deserialize_any(Finite)
    }
}

/// What stands for a colour, a reflectance or a scale, before it is known to.
enum Loose {
    Number(f64),
    Text(String),
    List(Vec<Number>),
    Table(Region),
}

/// A coefficient and a colour.
#[derive(serde::Deserialize)]
#[serde(deny_unknown_fields)]
struct Region {
    k: Number,
    #[serde(alias = "color")]
    colour: Colour,
}

impl<'de> Deserialize<'de> for Loose {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        struct Any;
        impl<'de> Visitor<'de> for Any {
            type Value = Loose;

            fn expecting(&self, f: &mut fmt::Formatter) -> fmt::Result {
                f.write_str(
                    "a finite number, a list of 3, a colour as \"#rrggbb\", or a table of k and colour",
                )
            }

            fn visit_i64<E: Error>(self, number: i64) -> Result<Loose, E> {
                Ok(Loose::Number(number as f64))
            }

            fn visit_f64<E: Error>(self, number: f64) -> Result<Loose, E> {
                Number::deserialize(number.into_deserializer()).map(|Number(number)| Loose::Number(number))
            }

            fn visit_str<E: Error>(self, text: &str) -> Result<Loose, E> {
                Ok(Loose::Text(text.to_owned()))
            }

            fn visit_seq<A: SeqAccess<'de>>(self, list: A) -> Result<Loose, A::Error> {
                Vec::deserialize(SeqAccessDeserializer::new(list)).map(Loose::List)
            }

            fn visit_map<A: MapAccess<'de>>(self, map: A) -> Result<Loose, A::Error> {
                Region::deserialize(MapAccessDeserializer::new(map)).map(Loose::Table)
            }
        }
        deserializer.deserialize_any(Any)
    }
}

impl Loose {
    fn three(&self) -> Option<[f64; 3]> {
        match self {
            Loose::Number(number) => Some([*number; 3]),
            Loose::List(list) => match list[..] {
                [Number(x), Number(y), Number(z)] => Some([x, y, z]),
                _ => None,
            },
            Loose::Text(_) | Loose::Table(_) => None,
        }
    }

    fn hex_colour(&self) -> Option<LinearRgb> {
        let Loose::Text(text) = self else { return None };
        let digits = text.strip_prefix('#').filter(|digits| digits.len() == 6 && digits.is_ascii())?;
        let [_, r, g, b] = u32::from_str_radix(digits, 16).ok()?.to_be_bytes();
        Some(Srgb8([r, g, b]).into())
    }
}

impl TryFrom<Loose> for Colour {
    type Error = &'static str;

    fn try_from(loose: Loose) -> Result<Self, Self::Error> {
        let colour = loose.three().map(LinearRgb::from).or_else(|| loose.hex_colour());
        let colour = colour.ok_or("a colour is 3 linear components, 1 number for a grey, or \"#rrggbb\"")?;
        match colour.to_array().iter().all(|&component| component >= 0.0) {
            true => drawable(colour).map(Colour),
            false => Err("no component of a colour is negative"),
        }
    }
}

/// A colour that single precision has, in which it is drawn.
fn drawable(colour: LinearRgb) -> Result<LinearRgb, &'static str> {
    match colour.largest() <= f64::from(f32::MAX) {
        true => Ok(colour),
        false => Err("no colour or coefficient is above 3.4e38, which is as much as single precision has"),
    }
}

impl TryFrom<Loose> for Reflects {
    type Error = &'static str;

    fn try_from(loose: Loose) -> Result<Self, Self::Error> {
        match loose {
            Loose::Number(k) => drawable(LinearRgb::grey(k)).map(|_| Reflects::Coefficient(k)),
            Loose::Table(Region { k: Number(k), colour: Colour(colour) }) => {
                drawable(colour * k).map(|_| Reflects::Whole(Reflectance::new(k, colour)))
            }
            loose => {
                let colour = loose.three().map(LinearRgb::from).or_else(|| loose.hex_colour());
                let colour = colour.ok_or("a coefficient k, a colour K = k·O, or { k = …, colour = … }")?;
                drawable(colour).map(|colour| Reflects::Whole(Reflectance::Merged(colour)))
            }
        }
    }
}

impl TryFrom<Loose> for Scale {
    type Error = &'static str;

    fn try_from(loose: Loose) -> Result<Self, Self::Error> {
        loose.three().map(|factors| Scale(factors.into())).ok_or("a scale is one factor for all axes, or 3")
    }
}
