//! Surfaces coloured by the errors of their normals.

use crate::normals::Weight;
use crate::num::{Degrees, LinearRgb, Radians};
use crate::raster::{Camera, Object, Paint, RenderError, RenderSettings, Samples, Scene, Shape, render};
use crate::report::Picture;
use crate::report::viridis::viridis;
use crate::shade::Material;
use crate::trade::{Subject, Tiling, error_map};
use std::borrow::Cow;

/// The errors at the ends of the colours, in degrees, as powers of ten.
const ENDS: [f64; 2] = [-2.0, 1.0];
/// What the colours mean.
pub(super) const KEY: &str = "Dark violet is an error of 0.01° or less, blue-green 0.3°, yellow 10° or more, in even steps of the logarithm.";

/// A surface cut one way, each vertex in the colour of its normal's error; `None` if it cannot be cut like this.
pub(super) fn error_picture(
    subject: &Subject,
    tiling: Tiling,
    weight: Weight,
    size: u32,
) -> Result<Option<Picture>, RenderError> {
    let Some((mesh, field, angles)) = error_map(subject, tiling, weight) else { return Ok(None) };
    let colours = angles.iter().map(|&angle| colour(angle)).collect();
    let Some(bounds) = mesh.bounds() else { return Ok(None) };
    let shape = Shape::Mesh { mesh: &mesh, normals: &field };
    let scene = Scene {
        objects: vec![Object {
            paint: Paint::Given(Cow::Owned(colours)),
            ..Object::new(shape, Material::default())
        }],
        lines: Vec::new(),
        lights: Vec::new(),
        camera: Camera::framing(bounds, 1.0),
        background: LinearRgb::WHITE,
    };
    let settings = RenderSettings { size: [size; 2], samples: Samples::Four, ..RenderSettings::default() };
    Ok(Some(render(&scene, &settings)?.into()))
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
