//! Meshes coloured by the errors of their normals.

use crate::mesh::Mesh;
use crate::normals::{NormalField, NormalRecipe, Weight};
use crate::num::viridis;
use crate::num::{Degrees, LinearRgb, Radians, unit_scale};
use crate::raster::{Camera, Object, Paint, RenderSettings, Samples, Scene, Shape, render};
use crate::report::{Picture, ReportError};
use crate::shade::Material;
use crate::trade::{Subject, Tiling, error_map, estimate_map};
use glam::{DMat4, DVec3};
use std::borrow::Cow;

/// The errors at the ends of the colours, in degrees, as powers of ten.
const ENDS: [f64; 2] = [-2.0, 1.0];
/// What the colours mean.
pub(super) const KEY: &str = "Dark violet is an error of 0.01° or less, blue-green 0.3°, yellow 10° or more, in even steps of the logarithm.";

/// Of vertices whose error nobody knows.
const UNKNOWN: LinearRgb = LinearRgb::grey(0.5);

/// A mesh and what its vertices are coloured by.
pub(super) struct Coloured<'a> {
    mesh: Cow<'a, Mesh>,
    field: NormalField,
    errors: Vec<Option<Radians>>,
}

impl<'a> Coloured<'a> {
    /// A surface cut one way with the errors of a weight's normals; `None` if it cannot be cut like this.
    pub(super) fn surface(subject: &Subject, tiling: Tiling, weight: Weight) -> Option<Self> {
        let (mesh, field, angles) = error_map(subject, tiling, weight)?;
        Some(Self { mesh: Cow::Owned(mesh), field, errors: angles.into_iter().map(Some).collect() })
    }

    /// Somebody's own mesh with the angles of a weight's normals to the quadric's.
    pub(super) fn own(mesh: &'a Mesh, recipe: &NormalRecipe, weight: Weight) -> Self {
        let (field, errors) = estimate_map(mesh, recipe, weight);
        Self { mesh: Cow::Borrowed(mesh), field, errors }
    }

    /// Each vertex in the colour of its error; `None` if there is nothing to see.
    pub(super) fn draw(&self, size: u32) -> Result<Option<Picture>, ReportError> {
        let Some((low, high)) = self.mesh.bounds() else { return Ok(None) };
        // In the middle and of about unit size, whatever it was.
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
