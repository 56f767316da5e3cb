//! Meshes coloured by the errors of their normals.

use crate::mesh::Mesh;
use crate::normals::{NormalField, NormalRecipe, Weight};
use crate::num::{Degrees, LinearRgb, Radians, unit_scale, viridis};
use crate::raster::{Camera, Object, Paint, RenderSettings, Samples, Scene, Shape, render};
use crate::report::error::ReportError;
use crate::report::picture::Picture;
use crate::shade::Material;
use crate::trade::{NamedSurface, Tiling, error_map, estimate_map};
use glam::{DMat4, DVec3};
use std::borrow::Cow;

/// The errors at the ends of the colours, in degrees, as powers of ten.
const ENDS: [f64; 2] = [-2.0, 1.0];
/// The colour of vertices without a known error.
const UNKNOWN: LinearRgb = LinearRgb::grey(0.5);

/// A mesh and the errors of its normals.
pub(super) struct ErrorPicture<'a> {
    mesh: Cow<'a, Mesh>,
    field: NormalField,
    errors: Vec<Option<Radians>>,
}

impl<'a> ErrorPicture<'a> {
    /// A surface cut one way with the errors of a weight's normals; `None` if it cannot be cut like this.
    pub(super) fn surface(surface: &NamedSurface, tiling: Tiling, weight: Weight) -> Option<Self> {
        let (mesh, field, angles) = error_map(surface, tiling, weight)?;
        Some(Self { mesh: Cow::Owned(mesh), field, errors: angles.into_iter().map(Some).collect() })
    }

    /// A user mesh with the angles of a weight's normals to the quadric's.
    pub(super) fn own(mesh: &'a Mesh, recipe: &NormalRecipe, weight: Weight) -> Self {
        let (field, errors) = estimate_map(mesh, recipe, weight);
        Self { mesh: Cow::Borrowed(mesh), field, errors }
    }

    /// The mesh with each vertex in the colour of its error; `None` for an empty mesh.
    pub(super) fn draw(&self, size: u32) -> Result<Option<Picture>, ReportError> {
        let Some((low, high)) = self.mesh.bounds() else { return Ok(None) };
        // Scaled to about unit size around the origin.
        let (centre, half) = (low * 0.5 + high * 0.5, high * 0.5 - low * 0.5);
        let scale = unit_scale(half.max_element());
        let colours = self.errors.iter().map(|error| error.map_or(UNKNOWN, colour)).collect();
        let shape = Shape::Mesh { mesh: &self.mesh, normals: &self.field };
        let scene = Scene {
            objects: vec![Object {
                paint: Paint::Given(Cow::Owned(colours)),
                transform: DMat4::from_scale(DVec3::splat(scale)) * DMat4::from_translation(-centre),
                ..Object::new(shape, Material::default())
            }],
            lines: Vec::new(),
            lights: Vec::new(),
            camera: Camera::framing((-half * scale, half * scale), 1.0),
            background: LinearRgb::WHITE,
        };
        let settings =
            RenderSettings { size: [size; 2], samples: Samples::Four, ..RenderSettings::default() };
        let drawn = render(&scene, &settings).map_err(|error| ReportError::Encoder(error.to_string()))?;
        Ok(Some(drawn.into()))
    }
}

fn colour(angle: Radians) -> LinearRgb {
    let [low, high] = ENDS;
    let share = (libm::log10(Degrees::from(angle).0) - low) / (high - low);
    // The logarithm of 0 is −∞: the first colour.
    viridis(share)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn colours_grow_lighter_with_the_error() {
        let luminance = |degrees: f64| colour(Degrees(degrees).into()).luminance();
        let errors = [0.0, 0.01, 0.03, 0.1, 0.5, 2.0, 10.0, 90.0].map(luminance);
        assert!(errors.is_sorted() && errors[0] == errors[1] && errors[6] == errors[7], "{errors:?}");
        assert_eq!(colour(Radians(0.0)), viridis(0.0));
    }
}
