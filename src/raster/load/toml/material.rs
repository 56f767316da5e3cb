//! The materials of a scene file.

use crate::io::ReadError;
use crate::num::LinearRgb;
use crate::raster::load::toml::lights::shade_error;
use crate::raster::load::toml::source::Source;
use crate::raster::load::toml::values::{Colour, ReflectanceValue};
use crate::shade::{Material, Reflectance, Reflection};
use serde::Deserialize;
use toml::Spanned;

/// `reflection = …`
#[derive(Clone, Copy, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub(super) enum ReflectionName {
    Phong,
    Blinn,
    /// Colours of the vertices, unlit.
    Given,
}

impl ReflectionName {
    pub(super) fn reflection(self) -> Option<Reflection> {
        match self {
            Self::Phong => Some(Reflection::Phong),
            Self::Blinn => Some(Reflection::Blinn),
            Self::Given => None,
        }
    }
}

/// `[object.material]`
#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
pub(super) struct MaterialTable {
    /// The colour of ambient and diffuse reflection where only a coefficient is given.
    #[serde(alias = "color")]
    colour: Option<Colour>,
    ambient: Option<ReflectanceValue>,
    diffuse: Option<ReflectanceValue>,
    /// A coefficient is multiplied by white.
    specular: Option<ReflectanceValue>,
    exponent: Option<f64>,
    pub(super) reflection: Option<ReflectionName>,
}

impl MaterialTable {
    /// The material; `None` if the table has at most a reflection.
    pub(super) fn material(source: Source, table: &Spanned<Self>) -> Result<Option<Material>, ReadError> {
        let (span, Self { colour, ambient, diffuse, specular, exponent, .. }) =
            (table.span(), table.get_ref());
        if let (None, None, None, None, None) = (colour, ambient, diffuse, specular, exponent) {
            return Ok(None);
        }
        let colour = colour.map_or(LinearRgb::grey(0.8), |Colour(colour)| colour);
        let plain = Material::plastic(colour);
        let diffuse = diffuse.map_or(plain.diffuse, |diffuse| diffuse.of(colour));
        let ambient = ambient.map(|ambient| ambient.of(colour));
        let specular = specular.map_or(plain.specular, |specular| specular.of(LinearRgb::WHITE));
        let exponent = exponent.unwrap_or(plain.exponent);
        let material = Material { diffuse, specular, exponent, reflection: Reflection::default(), ..plain };
        // An ambient reflection that follows the diffuse one is no error of its own.
        let given = Material { ambient: ambient.unwrap_or(Reflectance::NONE), ..material };
        given.check::<f32>().map_err(|error| shade_error(source, &span, &error))?;
        let ambient = ambient.unwrap_or(Reflectance::Merged(diffuse.merged()));
        Ok(Some(Material { ambient, ..material }))
    }
}
