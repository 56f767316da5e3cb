//! The lights and materials of a scene file.

use crate::io::ReadError;
use crate::num::{Degrees, LinearRgb, List, Radians};
use crate::raster::load::toml::source::Source;
use crate::raster::load::toml::values::{Colour, ReflectanceValue};
use crate::shade::{
    AreaShape, Attenuation, Cone, Light, Material, Optics, Reflectance, Reflection, ShadeError,
};
use glam::{DVec3, DVec4};
use serde::Deserialize;
use std::f64::consts::PI;
use std::ops::Range;
use toml::Spanned;

/// `plan = "keep"`: `crease plan` leaves the object or light unchanged.
#[derive(Clone, Copy, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub(super) enum PlanName {
    Keep,
}

/// `[[light.…]]`, by kind.
#[derive(Default, Deserialize)]
#[serde(deny_unknown_fields, default)]
pub(super) struct LightTables {
    ambient: Vec<Spanned<AmbientTable>>,
    directional: Vec<Spanned<DirectionalTable>>,
    point: Vec<Spanned<PointTable>>,
    spot: Vec<Spanned<SpotTable>>,
    rectangle: Vec<Spanned<RectangleTable>>,
    disc: Vec<Spanned<DiscTable>>,
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct AmbientTable {
    plan: Option<PlanName>,
    #[serde(alias = "color")]
    colour: Colour,
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct DirectionalTable {
    plan: Option<PlanName>,
    towards: List<f64, 3>,
    #[serde(alias = "color", default = "white")]
    colour: Colour,
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct PointTable {
    plan: Option<PlanName>,
    position: Position,
    #[serde(alias = "color", default = "white")]
    colour: Colour,
    #[serde(default)]
    attenuation: Attenuation,
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields, rename_all = "kebab-case")]
struct SpotTable {
    plan: Option<PlanName>,
    position: List<f64, 3>,
    #[serde(alias = "color", default = "white")]
    colour: Colour,
    #[serde(default)]
    attenuation: Attenuation,
    axis: List<f64, 3>,
    /// Degrees; 180 for none.
    cut_off: Option<f64>,
    /// Degrees.
    soft_edge: Option<f64>,
    exponent: Option<f64>,
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct RectangleTable {
    plan: Option<PlanName>,
    centre: List<f64, 3>,
    u: List<f64, 3>,
    v: List<f64, 3>,
    #[serde(alias = "color", default = "white")]
    colour: Colour,
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct DiscTable {
    plan: Option<PlanName>,
    centre: List<f64, 3>,
    normal: List<f64, 3>,
    radius: f64,
    #[serde(alias = "color", default = "white")]
    colour: Colour,
}

fn white() -> Colour {
    Colour(LinearRgb::WHITE)
}

/// x, y, z, or homogeneous with w: 0 for a light that is infinitely far away.
#[derive(Deserialize)]
#[serde(try_from = "Vec<f64>")]
struct Position(DVec4);

impl TryFrom<Vec<f64>> for Position {
    type Error = String;

    fn try_from(numbers: Vec<f64>) -> Result<Self, String> {
        match numbers[..] {
            [x, y, z] => Ok(Self(DVec4::new(x, y, z, 1.0))),
            [x, y, z, w] if w >= 0.0 && w.is_finite() => Ok(Self(DVec4::new(x, y, z, w))),
            [_, _, _, w] => Err(format!("w is {w}; it is 1 for a point, 0 for a light infinitely far away")),
            _ => Err(format!("{} numbers; a position has 3, or 4 with w", numbers.len())),
        }
    }
}

impl From<SpotTable> for Light {
    /// Without a cut-off and an exponent it is the lectures' spot.
    fn from(table: SpotTable) -> Self {
        let radians = |degrees: f64| match degrees {
            // 180 degrees mean no cut-off, which is π to the bit.
            180.0 => Radians(PI),
            degrees => Degrees(degrees).into(),
        };
        let lectures = Cone::of_lectures(table.axis.into());
        let cone = Cone {
            cut_off: table.cut_off.map_or(lectures.cut_off, radians),
            soft_edge: table.soft_edge.map_or(lectures.soft_edge, radians),
            exponent: table.exponent.unwrap_or(lectures.exponent),
            ..lectures
        };
        let SpotTable { position, colour, attenuation, .. } = table;
        Light::Spot { position: position.into(), colour: colour.0, attenuation, cone }
    }
}

/// A light, and whether plans leave it unchanged.
type Marked = (Option<PlanName>, Light);

/// All lights in the order of the file, `None` if it has none, and the numbers of those that plans leave unchanged.
pub(super) fn lights(
    source: Source,
    tables: LightTables,
) -> Result<(Option<Vec<Light>>, Vec<usize>), ReadError> {
    let ambient = |AmbientTable { plan, colour }| (plan, Light::Ambient { colour: colour.0 });
    let directional = |DirectionalTable { plan, towards, colour }| {
        (plan, Light::Directional { towards: towards.into(), colour: colour.0 })
    };
    let point = |PointTable { plan, position, colour, attenuation }| {
        (plan, Light::at(position.0, colour.0, attenuation))
    };
    let spot = |table: SpotTable| (table.plan, Light::from(table));
    let area = |plan, shape, colour: Colour| (plan, Light::Area { shape, colour: colour.0 });
    let rectangle = |RectangleTable { plan, centre, u, v, colour }| {
        let [centre, u, v] = [centre, u, v].map(DVec3::from);
        area(plan, AreaShape::Rectangle { centre, u, v }, colour)
    };
    let disc = |DiscTable { plan, centre, normal, radius, colour }| {
        area(plan, AreaShape::Disc { centre: centre.into(), normal: normal.into(), radius }, colour)
    };
    let mut found: Vec<(Range<usize>, Marked)> = with_spans(tables.ambient, ambient)
        .chain(with_spans(tables.directional, directional))
        .chain(with_spans(tables.point, point))
        .chain(with_spans(tables.spot, spot))
        .chain(with_spans(tables.rectangle, rectangle))
        .chain(with_spans(tables.disc, disc))
        .collect();
    found.sort_by_key(|(span, _)| span.start);
    let mut kept = Vec::new();
    for (number, (span, (plan, light))) in found.iter().enumerate() {
        light.check(number).map_err(|error| shade_error(source, span, &error))?;
        kept.extend(plan.map(|PlanName::Keep| number));
    }
    let lights: Vec<Light> = found.into_iter().map(|(_, (_, light))| light).collect();
    Ok(((!lights.is_empty()).then_some(lights), kept))
}

fn with_spans<T, U>(
    tables: Vec<Spanned<T>>,
    light: impl Fn(T) -> U,
) -> impl Iterator<Item = (Range<usize>, U)> {
    tables.into_iter().map(move |table| (table.span(), light(table.into_inner())))
}

/// An error of `shade` about a light or material, at its key in the table at `span`.
pub(super) fn shade_error(source: Source, span: &Range<usize>, error: &ShadeError) -> ReadError {
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
    /// The share of mirrored light.
    reflect: Option<Colour>,
    /// The share of light that passes through.
    transmit: Option<Colour>,
    ior: Option<f64>,
    /// For each unit of length.
    absorb: Option<Colour>,
}

impl MaterialTable {
    /// What the table states about rays; `None` if it states nothing.
    pub(super) fn optics(source: Source, table: &Spanned<Self>) -> Result<Option<Optics>, ReadError> {
        let (span, Self { reflect, transmit, ior, absorb, .. }) = (table.span(), table.get_ref());
        if let (None, None, None, None) = (reflect, transmit, ior, absorb) {
            return Ok(None);
        }
        let colour = |colour: &Option<Colour>| colour.map_or(LinearRgb::BLACK, |Colour(colour)| colour);
        let optics = Optics {
            reflect: colour(reflect),
            transmit: colour(transmit),
            ior: ior.unwrap_or(Optics::NONE.ior),
            absorb: colour(absorb),
        };
        optics.check().map(|()| Some(optics)).map_err(|error| shade_error(source, &span, &error))
    }

    /// The material; `None` if the table has at most a reflection. Without a diffuse reflectance its default is a share of
    /// what the surface neither mirrors nor transmits.
    pub(super) fn material(source: Source, table: &Spanned<Self>) -> Result<Option<Material>, ReadError> {
        let optics = Self::optics(source, table)?;
        let (span, Self { colour, ambient, diffuse, specular, exponent, .. }) =
            (table.span(), table.get_ref());
        if let (None, None, None, None, None, None) = (colour, ambient, diffuse, specular, exponent, optics) {
            return Ok(None);
        }
        let colour = colour.map_or(LinearRgb::grey(0.8), |Colour(colour)| colour);
        let mut plain = Material::plastic(colour);
        if let (Some(optics), Reflectance::Split { k, colour }) = (optics, plain.diffuse) {
            plain.diffuse = Reflectance::new(k * optics.opaque_share(), colour);
        }
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
