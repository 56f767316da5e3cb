//! Round surfaces in triangles of bad shape, whose own normals are known.

use super::super::prelude::*;
use crate::metric::{NormalDeviation, normal_deviation};
use crate::surface::{Surface, Tessellation};

/// A mesh of a surface with camera and light.
pub(super) struct LitSurface {
    mesh: Mesh,
    primitive: Primitive,
    exponent: f64,
    camera: Camera,
    light: Light,
    size: u32,
}

/// The parameters of its pictures.
pub(super) struct View {
    pub(super) size: u32,
    pub(super) light: Degrees,
    pub(super) exponent: f64,
}

/// Errors of normals in degrees.
#[derive(Clone, Copy, Debug)]
pub(super) struct Errors {
    pub(super) rms: f64,
    pub(super) max: f64,
}

impl LitSurface {
    pub(super) fn new(
        primitive: Primitive,
        surface: Surface,
        tessellation: &Tessellation,
        view: &View,
    ) -> Result<Self> {
        let mesh = surface.tessellate(tessellation)?;
        let &View { size, light, exponent } = view;
        let camera = camera(&[Object::new(Shape::Surface(primitive), shiny(exponent))]);
        Ok(Self { light: light_from(&camera, light)?, mesh, primitive, exponent, camera, size })
    }

    /// Between averaged normals and the surface's own, at the vertices.
    pub(super) fn at_vertices(&self, weight: Weight) -> Errors {
        let field = smooth(&self.mesh, weight);
        let own = self.mesh.columns().normals.as_ref().map_or(&[][..], |own| &own.values);
        let off = |(normal, &vertex): (&DVec3, &u32)| {
            Some(Degrees::from(angle_between(*normal, *own.get(vertex as usize)?)).0)
        };
        let angles: Vec<f64> = field.normals.values.iter().zip(&field.entry_vertex).filter_map(off).collect();
        let squares: f64 = angles.iter().map(|angle| angle * angle).sum();
        let rms = (squares / angles.len().max(1) as f64).sqrt();
        Errors { rms, max: angles.into_iter().fold(0.0, f64::max) }
    }

    /// Under Phong's shading with averaged normals.
    pub(super) fn picture(&self, weight: Weight) -> Result<Image> {
        let field = smooth(&self.mesh, weight);
        self.draw(object(&self.mesh, &field, shiny(self.exponent)), Show::Shaded)
    }

    /// With the surface's own normals.
    pub(super) fn truth(&self, show: Show) -> Result<Image> {
        self.draw(Object::new(Shape::Surface(self.primitive), shiny(self.exponent)), show)
    }

    /// Between interpolated normals and the surface's own, pixel by pixel.
    pub(super) fn deviation(&self, weight: Weight) -> Result<NormalDeviation> {
        let field = smooth(&self.mesh, weight);
        let picture = self.draw(object(&self.mesh, &field, shiny(self.exponent)), Show::Normals)?;
        Ok(normal_deviation(&picture, &self.truth(Show::Normals)?)?)
    }

    /// That as a map, yellow at so many degrees.
    pub(super) fn error_map(&self, weight: Weight, full: f64) -> Result<Image> {
        Ok(map([self.size; 2], &self.deviation(weight)?.angles, full))
    }

    fn draw(&self, object: Object, show: Show) -> Result<Image> {
        let settings =
            RenderSettings { show, ..settings([self.size; 2], Shading::Phong, Interpolation::Perspective) };
        draw(vec![object], std::slice::from_ref(&self.light), self.camera, &settings)
    }
}

/// Half diffuse, half highlight, which shows small angles.
fn shiny(exponent: f64) -> Material {
    Material {
        ambient: Reflectance::NONE,
        diffuse: Reflectance::Merged(LinearRgb::grey(0.5)),
        specular: Reflectance::Merged(LinearRgb::grey(0.5)),
        exponent,
        ..Material::default()
    }
}
