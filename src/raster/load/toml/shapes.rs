//! The shapes of a scene file: polygons and analytic surfaces.

use crate::io::ReadError;
use crate::mesh::{Column, Columns, Faces, Mesh, MeshBuilder};
use crate::num::{LinearRgb, List, UnitVec3};
use crate::raster::load::toml::source::Source;
use crate::raster::load::toml::values::Colour;
use crate::surface::{
    Catenoid, Cone, Cylinder, Ellipsoid, MonkeySaddle, Plane, Sphere, Superquadric, Surface, SurfaceError,
    Torus, Wave,
};
use glam::DVec3;
use serde::Deserialize;
use toml::Spanned;

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
            positions: vertices.iter().map(|&vertex| vertex.into()).collect(),
            faces: face_list,
            columns: Columns { normals: normals.map(Column::per_vertex), ..Columns::default() },
            ..MeshBuilder::default()
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
