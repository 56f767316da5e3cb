//! The materials of a scene file.

use crate::io::ReadError;
use crate::num::LinearRgb;
use crate::raster::load::toml::choose;
use crate::raster::load::toml::keys::MaterialKeys;
use crate::raster::load::toml::lights::wrong;
use crate::raster::load::toml::place::Source;
use crate::raster::load::toml::values::{Number, Reflects};
use crate::shade::{Material, Reflectance, Reflection};
use toml::Spanned;

/// What colours come from: a material under light, or the vertices.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Colouring {
    Lit(Reflection),
    Given,
}

impl Colouring {
    /// The one of this name.
    pub(super) fn named(source: Source, name: &Spanned<String>) -> Result<Self, ReadError> {
        let choices = [
            ("phong", Colouring::Lit(Reflection::Phong)),
            ("blinn", Colouring::Lit(Reflection::Blinn)),
            ("given", Colouring::Given),
        ];
        choose(source, name, &choices)
    }
}

/// The material, if any of it is given, and the colouring, if that is.
pub(super) fn material(
    source: Source,
    keys: &Spanned<MaterialKeys>,
) -> Result<(Option<Material>, Option<Colouring>), ReadError> {
    let (span, keys) = (keys.span(), keys.get_ref());
    let colouring = keys.reflection.as_ref().map(|name| Colouring::named(source, name)).transpose()?;
    let parts = [keys.ambient, keys.diffuse, keys.specular];
    if keys.colour.is_none() && keys.exponent.is_none() && parts.iter().all(Option::is_none) {
        return Ok((None, colouring));
    }
    let plain = Material::plastic(keys.colour.map_or(LinearRgb::grey(0.8), |colour| colour.0));
    let reflectance = |given: Option<Reflects>, plain: Reflectance| match (given, plain) {
        (Some(Reflects::Coefficient(k)), Reflectance::Split { colour, .. }) => Reflectance::new(k, colour),
        (Some(Reflects::Coefficient(k)), Reflectance::Merged(colour)) => Reflectance::new(k, colour),
        (Some(Reflects::Whole(whole)), _) => whole,
        (None, plain) => plain,
    };
    let diffuse = reflectance(keys.diffuse, plain.diffuse);
    let material = Material {
        ambient: match keys.ambient {
            Some(_) => reflectance(keys.ambient, plain.ambient),
            None => Reflectance::Merged(diffuse.merged()),
        },
        diffuse,
        specular: reflectance(keys.specular, plain.specular),
        exponent: keys.exponent.map_or(plain.exponent, |Number(exponent)| exponent),
        reflection: Reflection::default(),
    };
    // An ambient reflection that is that of diffuse light is none to complain about.
    let given =
        Material { ambient: keys.ambient.map_or(Reflectance::NONE, |_| material.ambient), ..material };
    given.check().map_err(|error| wrong(source, &span, &error))?;
    Ok((Some(material), colouring))
}
