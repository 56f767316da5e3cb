//! A scene that owns its meshes, with the light and material of those that have none.

use crate::io::{Note, ReadOptions};
use crate::mesh::Mesh;
use crate::normals::{NormalField, NormalRecipe, When};
use crate::num::LinearRgb;
use crate::raster::scene::{Object, Paint, Scene, Shape};
use crate::raster::settings::RenderSettings;
use crate::raster::view::camera::Camera;
use crate::shade::{Light, Material, Reflectance};
use crate::surface::Primitive;
use glam::{DMat4, DVec3};
use std::borrow::Cow;

/// How scenes are read.
#[derive(Clone, Debug, Default)]
pub struct LoadOptions {
    /// What determines the normals of meshes.
    pub recipe: NormalRecipe,
    /// Which stored normals are replaced. What is drawn is what [`pipeline::revise`](crate::pipeline::revise) with the
    /// same recipe would write. `None` leaves it to what scenes say; where they say nothing, those of mesh files are always
    /// replaced, and those that a scene gives its own polygons and surfaces are kept.
    pub when: Option<When>,
    /// What readers may do and how much they may take.
    pub read: ReadOptions,
    /// Whether pictures are taken with another camera, so that an unusable camera of a mesh file is skipped with a
    /// note and is no error.
    pub from_elsewhere: bool,
}

/// Most corners of faces that a file may place by showing the same meshes in many places: drawing takes some gigabytes
/// for them. Faces that are shown once are not limited here.
pub(super) const MOST_PLACED_CORNERS: u64 = 1 << 28;

/// Most objects.
pub(super) const MOST_OBJECTS: usize = 1 << 17;

/// A scene as it was read, to be changed at will before [`scene`](Self::scene) shows it.
#[derive(Clone, Debug)]
pub struct SceneFile {
    /// The meshes that objects show, each once.
    pub meshes: Vec<SceneMesh>,
    /// What is seen.
    pub objects: Vec<SceneObject>,
    /// What lights them; `None` for [`default_lights`], which follow the camera.
    pub lights: Option<Vec<Light>>,
    /// Where they are seen from; `None` for a camera that frames all of them.
    pub camera: Option<Camera>,
    /// What is seen where there is nothing.
    pub background: LinearRgb,
    /// How it is drawn.
    pub settings: RenderSettings,
    /// What was repaired, skipped or could not be shown.
    pub notes: Vec<Note>,
}

/// A mesh with its normals.
///
/// A mesh whose faces have several materials becomes one mesh a material; normals are those of the whole.
#[derive(Clone, Debug, PartialEq)]
pub struct SceneMesh {
    /// The polygons.
    pub mesh: Mesh,
    /// Their normals, as they would be written.
    pub normals: NormalField,
    /// The colour of each vertex, if the file gives any.
    pub colours: Option<Vec<LinearRgb>>,
    /// The number in its file of each face, counted from 0 within its part, where that is not its number here.
    pub source_faces: Option<Vec<u32>>,
}

/// An object of a scene that owns its meshes.
#[derive(Clone, Debug, PartialEq)]
pub struct SceneObject {
    /// Its name, possibly empty.
    pub name: String,
    /// Its form.
    pub shape: SceneShape,
    /// From its own space to the scene's.
    pub transform: DMat4,
    /// What it does with light.
    pub material: Material,
    /// Show the colours of its vertices instead, unlit.
    pub given: bool,
    /// The analytic surface that a mesh approximates.
    pub surface: Option<Primitive>,
}

impl SceneObject {
    /// A shape without a name and a transform, in the default material.
    pub(super) fn new(shape: SceneShape) -> Self {
        Self {
            name: String::new(),
            shape,
            transform: DMat4::IDENTITY,
            material: plain_material(),
            given: false,
            surface: None,
        }
    }
}

/// The form of an object of a scene that owns its meshes.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum SceneShape {
    /// One of [`SceneFile::meshes`].
    Mesh(usize),
    /// An analytic surface, drawn exactly.
    Surface(Primitive),
}

impl SceneFile {
    /// What [`render`](crate::raster::render) and [`probe`](crate::raster::probe()) take. The camera that frames the
    /// objects goes by the picture's size in [`settings`](Self::settings).
    pub fn scene(&self) -> Scene<'_> {
        let mut scene = self.unframed();
        let [width, height] = self.settings.size.map(|side| f64::from(side.max(1)));
        let camera = self.camera.or_else(|| scene.framing(width / height));
        scene.camera = camera.unwrap_or(scene.camera);
        scene.lights = self.lights.clone().unwrap_or_else(|| default_lights(&scene.camera).to_vec());
        scene
    }

    /// What there is to see, without lights and with a camera anywhere.
    pub(super) fn unframed(&self) -> Scene<'_> {
        Scene {
            objects: self.objects.iter().map(|object| self.object(object)).collect(),
            lines: Vec::new(),
            lights: Vec::new(),
            camera: Camera::framing((DVec3::ZERO, DVec3::ZERO), 1.0),
            background: self.background,
        }
    }

    /// The mesh of an object, by its number; `None` for analytic surfaces and beyond the last object.
    pub fn mesh_of(&self, object: usize) -> Option<&SceneMesh> {
        match self.objects.get(object)?.shape {
            SceneShape::Mesh(mesh) => self.meshes.get(mesh),
            SceneShape::Surface(_) => None,
        }
    }

    fn object<'a>(&'a self, object: &SceneObject) -> Object<'a> {
        let (shape, colours) = match object.shape {
            SceneShape::Mesh(number) => {
                let SceneMesh { mesh, normals, colours, .. } = &self.meshes[number];
                (Shape::Mesh { mesh, normals }, colours.as_deref())
            }
            SceneShape::Surface(primitive) => (Shape::Surface(primitive), None),
        };
        let paint = match object.given {
            true => Paint::Given(Cow::Borrowed(colours.unwrap_or_default())),
            false => Paint::Lit(object.material),
        };
        Object { shape, transform: object.transform, paint, surface: object.surface }
    }
}

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
