//! What a picture of a mesh shows: normals, view, lamp, material. All of it is in the link of the page.

use crease::normals::{Crease, CreaseRule, Groups, NormalRecipe, Weight};
use crease::num::{Degrees, LinearRgb, Radians};
use crease::raster::{Camera, RenderSettings, Shading};
use crease::shade::{Light, Material, Reflectance, Reflection};
use glam::DVec3;
use serde::Deserialize;

/// The state of a room that shows a mesh.
#[derive(Clone, Debug, PartialEq, Deserialize)]
#[serde(default, deny_unknown_fields)]
pub(crate) struct View {
    /// The name of a built-in mesh, or `file`.
    pub subject: String,
    /// Segments of an analytic surface.
    pub segments: u32,
    pub weight: Weight,
    /// In degrees; 180 for none.
    pub crease: f64,
    /// Whether hard edges cut fans, or each corner has a cone of its own.
    pub cone: bool,
    /// Whether smoothing groups of a file count.
    pub groups: bool,
    /// Turn to the right and tilt upwards of the viewer, in degrees.
    pub turn: f64,
    pub tilt: f64,
    /// 1 shows the whole mesh at any turn.
    pub zoom: f64,
    /// Where the lamp is in the picture, from the middle: a unit is half a ball that fills it.
    pub lamp: [f64; 2],
    pub ambient: f64,
    pub diffuse: f64,
    pub specular: f64,
    pub exponent: f64,
    /// Phong's highlight instead of Blinn's.
    pub phong: bool,
    pub size: [u32; 2],
    /// Edges that are hard, normals, all edges.
    pub creases: bool,
    pub hairs: bool,
    pub wire: bool,
    /// What deviations are measured from: `exact`, `stored`, or the name of a weight.
    pub against: String,
    /// The deviation in degrees that has the lightest colour.
    pub most: f64,
}

impl Default for View {
    fn default() -> Self {
        Self {
            subject: "sphere".to_owned(),
            segments: 16,
            weight: Weight::Angle,
            crease: 40.0,
            cone: false,
            groups: true,
            turn: 25.0,
            tilt: 20.0,
            zoom: 1.0,
            lamp: [-0.5, 0.5],
            ambient: 0.1,
            diffuse: 0.7,
            specular: 0.3,
            exponent: 32.0,
            phong: false,
            size: [320, 320],
            creases: false,
            hairs: false,
            wire: false,
            against: "exact".to_owned(),
            most: 10.0,
        }
    }
}

/// The colour of the mesh.
const COLOUR: LinearRgb = LinearRgb::new(0.62, 0.72, 0.85);

impl View {
    pub(crate) fn recipe(&self) -> NormalRecipe {
        NormalRecipe {
            weight: self.weight,
            crease: Crease::Angle(Degrees(self.crease.clamp(0.0, 180.0))),
            rule: if self.cone { CreaseRule::Cone } else { CreaseRule::Fan },
            groups: if self.groups { Groups::Honour } else { Groups::Ignore },
            ..NormalRecipe::default()
        }
    }

    pub(crate) fn material(&self) -> Material {
        Material {
            ambient: Reflectance::new(self.ambient, COLOUR),
            diffuse: Reflectance::new(self.diffuse, COLOUR),
            specular: Reflectance::new(self.specular, LinearRgb::WHITE),
            exponent: self.exponent,
            reflection: if self.phong { Reflection::Phong } else { Reflection::Blinn },
        }
    }

    /// The direction from the mesh to the viewer.
    pub(crate) fn towards_viewer(&self) -> DVec3 {
        let (turn_sine, turn_cosine) = libm::sincos(Radians::from(Degrees(self.turn)).0);
        let (tilt_sine, tilt_cosine) = libm::sincos(Radians::from(Degrees(self.tilt.clamp(-89.0, 89.0))).0);
        DVec3::new(turn_sine * tilt_cosine, tilt_sine, turn_cosine * tilt_cosine)
    }

    /// A camera that sees a ball of this centre and radius whole.
    pub(crate) fn camera(&self, centre: DVec3, radius: f64) -> Camera {
        // The half diagonal of this cube is the radius.
        let half = DVec3::splat(radius / libm::sqrt(3.0));
        let aspect = f64::from(self.size[0].max(1)) / f64::from(self.size[1].max(1));
        let framed = Camera::framing((centre - half, centre + half), aspect);
        let distance = framed.eye.distance(framed.target) / self.zoom.clamp(0.25, 40.0);
        let eye = centre + self.towards_viewer() * distance;
        Camera { eye, near: framed.near / self.zoom.max(1.0) / 16.0, ..framed }
    }

    /// Ambient light and the lamp, which is far away and turns with the viewer.
    pub(crate) fn lights(&self, camera: &Camera) -> [Light; 2] {
        let [right, up, forward] = camera.axes().unwrap_or([DVec3::X, DVec3::Y, DVec3::NEG_Z]);
        let [x, y] = self.lamp;
        let depth = libm::sqrt((1.0 - x * x - y * y).max(0.0));
        let towards = right * x + up * y - forward * depth;
        let towards = if towards.length() > 0.0 { towards } else { -forward };
        [
            Light::Ambient { colour: LinearRgb::WHITE },
            Light::Directional { towards, colour: LinearRgb::WHITE },
        ]
    }

    pub(crate) fn settings(&self, shading: Shading) -> RenderSettings {
        RenderSettings { size: self.size, shading, two_sided: true, ..RenderSettings::default() }
    }
}
