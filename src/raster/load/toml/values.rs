//! Values of scene files: colours, reflectances, transforms, and the shapes of objects.

use crate::io::ReadError;
use crate::mesh::{Column, Columns, Faces, Mesh, MeshBuilder};
use crate::num::{LinearRgb, List, Srgb8, UnitVec3};
use crate::raster::load::rotation::rotation;
use crate::raster::load::toml::source::Source;
use crate::shade::Reflectance;
use crate::surface::{
    Catenoid, Cone, Cylinder, Ellipsoid, MonkeySaddle, Plane, Sphere, Superquadric, Surface, SurfaceError,
    Torus, Wave,
};
use glam::{DMat4, DVec3};
use serde::Deserialize;
use toml::Spanned;

/// A colour: three linear components, one for a grey, or `"#rrggbb"` in sRGB.
#[derive(Clone, Copy, Debug, PartialEq, Deserialize)]
#[serde(try_from = "ColourValue")]
pub(super) struct Colour(pub(super) LinearRgb);

#[derive(Deserialize)]
#[serde(untagged, expecting = "expected 3 linear components, 1 number for a grey, or \"#rrggbb\"")]
enum ColourValue {
    Grey(f64),
    Linear(List<f64, 3>),
    Code(String),
}

impl TryFrom<ColourValue> for Colour {
    type Error = &'static str;

    fn try_from(value: ColourValue) -> Result<Self, Self::Error> {
        let colour = match value {
            ColourValue::Grey(grey) => LinearRgb::grey(grey),
            ColourValue::Linear(components) => LinearRgb::from(components.0),
            ColourValue::Code(code) => {
                srgb(&code).ok_or("expected a colour: `[r, g, b]`, one number for a grey, or \"#80ff00\"")?
            }
        };
        // It is drawn in single precision.
        let is_allowed = |component| (0.0..=f64::from(f32::MAX)).contains(&component);
        match colour.to_array().into_iter().all(is_allowed) {
            true => Ok(Colour(colour)),
            false => Err("expected components that are not negative and at most 3.4e38"),
        }
    }
}

/// `#rrggbb`
fn srgb(code: &str) -> Option<LinearRgb> {
    let digits = code.strip_prefix('#').filter(|digits| digits.len() == 6 && digits.is_ascii())?;
    let [_, r, g, b] = u32::from_str_radix(digits, 16).ok()?.to_be_bytes();
    Some(Srgb8([r, g, b]).into())
}

/// A reflectance: a coefficient k of the material's colour, a colour K, or k and a colour.
#[derive(Clone, Copy, Debug, PartialEq, Deserialize)]
#[serde(
    untagged,
    deny_unknown_fields,
    expecting = "expected a coefficient k, a colour K = k·O, none of its components negative, or `{ k = …, colour = … }`"
)]
pub(super) enum ReflectanceValue {
    Coefficient(f64),
    Merged(Colour),
    Split {
        k: f64,
        #[serde(alias = "color")]
        colour: Colour,
    },
}

impl ReflectanceValue {
    pub(super) fn of(self, colour: LinearRgb) -> Reflectance {
        match self {
            Self::Coefficient(k) => Reflectance::new(k, colour),
            Self::Merged(Colour(colour)) => Reflectance::Merged(colour),
            Self::Split { k, colour: Colour(colour) } => Reflectance::new(k, colour),
        }
    }
}

#[derive(Clone, Copy, Debug, PartialEq, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub(super) enum Step {
    Scale(Scale),
    /// Degrees about x, then y, then z.
    Rotate(List<f64, 3>),
    Translate(List<f64, 3>),
    /// Rows of an affine map.
    Matrix(List<List<f64, 4>, 3>),
}

/// A factor for all axes, or one for each.
#[derive(Clone, Copy, Debug, PartialEq, Deserialize)]
#[serde(untagged, expecting = "expected one factor for all axes, or 3")]
pub(super) enum Scale {
    Uniform(f64),
    Axes(List<f64, 3>),
}

impl Step {
    pub(super) fn matrix(self) -> DMat4 {
        match self {
            Step::Scale(Scale::Uniform(factor)) => DMat4::from_scale(DVec3::splat(factor)),
            Step::Scale(Scale::Axes(factors)) => DMat4::from_scale(factors.into()),
            Step::Rotate(degrees) => rotation(degrees.into()),
            Step::Translate(by) => DMat4::from_translation(by.into()),
            Step::Matrix(List([x, y, z])) => {
                DMat4::from_cols_array_2d(&[x.0, y.0, z.0, [0.0, 0.0, 0.0, 1.0]]).transpose()
            }
        }
    }
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
pub(super) struct PolygonTable {
    vertices: Vec<List<f64, 3>>,
    faces: Vec<Vec<u32>>,
    /// One per vertex.
    normals: Option<Vec<List<f64, 3>>>,
    /// One per vertex.
    #[serde(alias = "colors")]
    colours: Option<Vec<Colour>>,
}

impl PolygonTable {
    /// The mesh, and the colours of its vertices if there are any.
    pub(super) fn mesh(
        source: Source,
        table: &Spanned<Self>,
    ) -> Result<(Mesh, Option<Vec<LinearRgb>>), ReadError> {
        let (span, Self { vertices, faces, normals, colours }) = (table.span(), table.get_ref());
        let error = |key: &str, found: &str| source.error(&source.member(&span, &[key, "colors"]), found, "");
        if faces.is_empty() {
            return Err(error("faces", "there are no faces to draw"));
        }
        if let Some(vertex) = vertices.iter().position(|vertex| !DVec3::from(*vertex).is_finite()) {
            return Err(error("vertices", &format!("vertex {vertex} is {:?}", vertices[vertex].0)));
        }
        let counts =
            [("normals", normals.as_ref().map(Vec::len)), ("colours", colours.as_ref().map(Vec::len))];
        for (key, count) in counts {
            if let Some(count) = count.filter(|&count| count != vertices.len()) {
                return Err(error(key, &format!("{count} {key} for {} vertices", vertices.len())));
            }
        }
        let unit = |(vertex, &normal): (usize, &List<f64, 3>)| {
            let unit = UnitVec3::new(normal.into()).map(UnitVec3::get);
            unit.ok_or_else(|| error("normals", &format!("normal {vertex} is {:?}", normal.0)))
        };
        let normals = normals.as_ref().map(|list| list.iter().enumerate().map(unit).collect()).transpose()?;
        let mut face_list = Faces::new();
        faces.iter().for_each(|face| face_list.push(face));
        let builder = MeshBuilder {
            positions: vertices.iter().map(|&vertex| DVec3::from(vertex)).collect(),
            faces: face_list,
            columns: Columns { normals: normals.map(Column::per_vertex), ..Columns::default() },
        };
        let mesh = builder.build().map_err(|fault| error("faces", &fault.to_string()))?;
        Ok((mesh, colours.as_ref().map(|colours| colours.iter().map(|&Colour(colour)| colour).collect())))
    }
}

/// `surface = { sphere = { radius = 1 } }`
#[derive(Clone, Copy, Deserialize)]
#[serde(deny_unknown_fields, rename_all = "kebab-case", rename_all_fields = "kebab-case")]
pub(super) enum SurfaceTable {
    Plane { width: f64, height: f64 },
    Sphere { radius: f64 },
    Ellipsoid { semi_axes: List<f64, 3> },
    Cylinder { radius: f64, height: f64 },
    Cone { radius: f64, height: f64 },
    Torus { major: f64, minor: f64 },
    Catenoid { waist: f64, height: f64 },
    Wave { size: f64 },
    MonkeySaddle { size: f64 },
    Superquadric { semi_axes: List<f64, 3>, roundness: List<f64, 2> },
    Teapot {},
}

impl SurfaceTable {
    pub(super) fn surface(self) -> Result<Surface, SurfaceError> {
        Ok(match self {
            Self::Plane { width, height } => Plane::new(width, height)?.into(),
            Self::Sphere { radius } => Sphere::new(radius)?.into(),
            Self::Ellipsoid { semi_axes } => Ellipsoid::new(semi_axes.into())?.into(),
            Self::Cylinder { radius, height } => Cylinder::new(radius, height)?.into(),
            Self::Cone { radius, height } => Cone::new(radius, height)?.into(),
            Self::Torus { major, minor } => Torus::new(major, minor)?.into(),
            Self::Catenoid { waist, height } => Surface::Catenoid(Catenoid::new(waist, height)?),
            Self::Wave { size } => Surface::Wave(Wave::new(size)?),
            Self::MonkeySaddle { size } => Surface::MonkeySaddle(MonkeySaddle::new(size)?),
            Self::Superquadric { semi_axes, roundness: List([north, east]) } => {
                Surface::Superquadric(Superquadric::new(semi_axes.into(), north, east)?)
            }
            Self::Teapot {} => Surface::Teapot,
        })
    }
}
