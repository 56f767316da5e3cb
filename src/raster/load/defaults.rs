//! The lights of scenes and the material of meshes that have none.

use crate::num::LinearRgb;
use crate::raster::view::camera::Camera;
use crate::shade::{Light, Material, Reflectance};
use glam::DVec3;

/// Ambient light of [`default_lights`]: dim, since files give materials an ambient colour as light as the diffuse one.
const AMBIENT: LinearRgb = LinearRgb::grey(0.15);

/// Light for a scene that has none: a white key light far away, from the left above the camera, and dim ambient light.
/// They follow the camera, so that what it sees is lit wherever it stands.
pub fn default_lights(camera: &Camera) -> [Light; 2] {
    // With a camera that cannot be used there will be no picture, whatever the light.
    let [right, up, forward] = camera.axes().unwrap_or([DVec3::X, DVec3::Y, DVec3::NEG_Z]);
    let towards = up * 0.8 - right * 0.6 - forward;
    [Light::Ambient { colour: AMBIENT }, Light::Directional { towards, colour: LinearRgb::WHITE }]
}

/// The material of meshes that have none: grey plastic that reflects ambient light as it does diffuse light.
pub(super) fn plain_material() -> Material {
    let plastic = Material::default();
    Material { ambient: Reflectance::Merged(plastic.diffuse.merged()), ..plastic }
}
