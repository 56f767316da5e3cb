//! What decides which options a drawing reads: its objects, as they were and as they are.

use super::args::{RenderArgs, Variant};
use super::option_effects::LIGHT;
use crease::num::LinearRgb;
use crease::raster::{
    Camera, Interpolation, RenderSettings, SceneFile, SceneObject, SceneShape, Shading, Show, default_lights,
};
use crease::report::Overlay;
use crease::shade::{Light, Material};
use std::borrow::Cow;

/// What a scene had that options may change.
pub struct Before {
    pub shading: Shading,
    interpolation: Interpolation,
    /// Whether each object's vertices give its colours.
    given: Vec<bool>,
}

impl Before {
    /// Before any option changes it.
    pub fn of(file: &SceneFile) -> Self {
        Self {
            shading: file.settings.shading,
            interpolation: file.settings.interpolation,
            given: file.objects.iter().map(|object| object.given).collect(),
        }
    }
}

/// A changed scene.
pub struct Stage<'a> {
    pub args: &'a RenderArgs,
    pub file: &'a SceneFile,
    pub before: &'a Before,
    camera: Camera,
    lights: Cow<'a, [Light]>,
}

/// One object in the picture, or in one of its panels.
pub struct Case<'a> {
    pub args: &'a RenderArgs,
    pub settings: RenderSettings,
    pub background: LinearRgb,
    pub camera: Camera,
    pub object: &'a SceneObject,
    /// Whether its colours were given before options changed that.
    pub was_given: bool,
    interpolation_before: Interpolation,
    lights: &'a [Light],
}

impl<'a> Stage<'a> {
    pub fn new(args: &'a RenderArgs, file: &'a SceneFile, before: &'a Before) -> Self {
        let camera = file.camera.unwrap_or_else(|| file.scene().camera);
        let lights = match &file.lights {
            Some(lights) => Cow::Borrowed(&lights[..]),
            None => Cow::Owned(default_lights(&camera).to_vec()),
        };
        Self { args, file, before, camera, lights }
    }

    /// The objects of the scene, in each panel if there are several.
    pub fn cases(&self) -> Vec<Case<'_>> {
        let Self { args, file, before, camera, ref lights } = *self;
        let panels = match &args.output.compare[..] {
            [] => vec![file.settings],
            variants => variants.iter().map(|variant: &Variant| variant.settings(&file.settings)).collect(),
        };
        let case = |(settings, (object, &was_given))| Case {
            args,
            settings,
            background: file.background,
            camera,
            object,
            was_given,
            interpolation_before: before.interpolation,
            lights,
        };
        let objects = || file.objects.iter().zip(&before.given);
        let of_panel = |settings| objects().map(move |object| (settings, object));
        panels.into_iter().flat_map(of_panel).map(case).collect()
    }
}

impl Case<'_> {
    /// Whether light falls on it.
    pub fn is_lit(&self) -> bool {
        LIGHT.iter().all(|condition| (condition.holds)(self))
    }

    /// Whether it is drawn by casting rays, whatever the shading.
    pub fn is_solid(&self) -> bool {
        is_solid(self.object)
    }

    /// Whether what is shown is nothing that corners carry.
    pub fn shows_no_values(&self) -> bool {
        shows_no_values(self.settings.show)
    }

    /// Whether the numbers behind a pixel are told.
    pub fn probes(&self) -> bool {
        self.args.output.probe.is_some()
    }

    /// Whether there is a light like this.
    pub fn has_light(&self, like: impl Fn(&Light) -> bool) -> bool {
        self.lights.iter().any(like)
    }

    /// What it is made of.
    pub fn material(&self) -> &Material {
        &self.object.material
    }

    /// Whether it returns diffuse light of a light's colour.
    pub fn scatters(&self, light: &Light) -> bool {
        light.colour() * self.material().diffuse.merged() != LinearRgb::BLACK
    }

    /// Whether a highlight.
    pub fn shines(&self, light: &Light) -> bool {
        light.colour() * self.material().specular.merged() != LinearRgb::BLACK
    }

    /// How values spread over faces, and how they did before an option changed it.
    pub fn interpolations(&self) -> [Interpolation; 2] {
        [self.settings.interpolation, self.interpolation_before]
    }

    /// Whether values of corners are spread over faces.
    pub fn interpolates(&self) -> bool {
        match self.settings.shading {
            Shading::Gouraud | Shading::Phong => true,
            // What is shown in place of light are normals, which a wireframe interpolates as well.
            Shading::Wireframe => self.settings.show != Show::Shaded,
            Shading::Flat | Shading::Exact => false,
        }
    }

    /// Whether normals of corners are told, or drawn as lines.
    pub fn reports_normals(&self) -> bool {
        let draws = |overlay: &Overlay| matches!(overlay, Overlay::VertexNormals | Overlay::Creases);
        self.probes() || self.args.shading.overlay.iter().any(draws)
    }
}

/// Whether an object is drawn by casting rays, whatever the shading.
pub fn is_solid(object: &SceneObject) -> bool {
    matches!(object.shape, SceneShape::Surface(_))
}

/// Whether what is shown is nothing that corners carry.
pub fn shows_no_values(show: Show) -> bool {
    matches!(show, Show::Facing | Show::Depth | Show::FaceId)
}
