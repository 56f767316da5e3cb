//! A scene that owns its meshes, read from a file.

use crate::io::{self, Format, Limits, Note, Place, Problem, ReadError, ReadOptions};
use crate::mesh::Mesh;
use crate::normals::{NormalField, NormalRecipe, When};
use crate::num::LinearRgb;
use crate::raster::load::normal_settings::NormalSettings;
use crate::raster::scene::{Object, Paint, Scene, Shape};
use crate::raster::settings::{ObjectSettings, RenderSettings};
use crate::raster::view::camera::Camera;
use crate::shade::{Light, Material, Optics, Reflectance};
use crate::surface::Primitive;
use glam::{DMat4, DVec3};
use std::borrow::Cow;
use std::path::Path;

/// How scenes are read.
#[derive(Clone, Debug, Default)]
pub struct LoadOptions {
    /// What determines the normals of meshes, unless the scene states something else.
    pub recipe: NormalRecipe,
    /// What overrides the scene.
    pub normals: NormalSettings,
    /// Which stored normals are replaced, as by [`pipeline::revise`](crate::pipeline::revise). `None` leaves it to scene files; by
    /// default normals of mesh files are replaced, and those of polygons and surfaces of a scene are kept.
    pub when: Option<When>,
    /// The options and limits of readers.
    pub read: ReadOptions,
    /// Whether another camera is used, so that an invalid camera of a mesh file is only noted.
    pub from_elsewhere: bool,
}

/// Most corners of faces, counting each instance: drawing takes some gigabytes for them.
pub(super) const MOST_PLACED_CORNERS: u64 = 1 << 28;

pub(super) const MOST_OBJECTS: usize = 1 << 17;

/// A scene as it was read, to be changed at will before [`scene`](Self::scene) shows it.
#[derive(Clone, Debug, Default)]
pub struct SceneFile {
    /// The meshes that objects show, each once.
    pub meshes: Vec<SceneMesh>,
    /// The objects.
    pub objects: Vec<SceneObject>,
    /// The lights; `None` for [`default_lights`], which follow the camera.
    pub lights: Option<Vec<Light>>,
    /// The numbers of lights that plans leave unchanged.
    pub kept_lights: Vec<usize>,
    /// The camera; `None` for one that frames all objects.
    pub camera: Option<Camera>,
    /// The colour where no object is visible.
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
    /// The material.
    pub material: Material,
    /// Reflection and transmission, for [`Shading::Traced`](crate::raster::Shading::Traced) only.
    pub optics: Optics,
    /// Show the colours of its vertices instead, unlit.
    pub given: bool,
    /// The analytic surface that a mesh approximates.
    pub surface: Option<Primitive>,
    /// Settings of its own.
    pub settings: ObjectSettings,
    /// What the scene states about its normals.
    pub normals: NormalSettings,
    /// Whether it keeps stored normals.
    pub keeps_normals: bool,
    /// Whether plans leave it unchanged.
    pub is_kept: bool,
}

impl SceneObject {
    /// A shape without a name and a transform, in the default material.
    pub(super) fn new(shape: SceneShape) -> Self {
        Self {
            name: String::new(),
            shape,
            transform: DMat4::IDENTITY,
            material: plain_material(),
            optics: Optics::NONE,
            given: false,
            surface: None,
            settings: ObjectSettings::default(),
            normals: NormalSettings::default(),
            keeps_normals: false,
            is_kept: false,
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
    /// The scene to [`render`](crate::raster::render), framed by the picture's size in [`settings`](Self::settings).
    pub fn scene(&self) -> Scene<'_> {
        let mut scene = self.unframed();
        let [width, height] = self.settings.size.map(|side| f64::from(side.max(1)));
        let camera = self.camera.or_else(|| scene.framing(width / height));
        scene.camera = camera.unwrap_or(scene.camera);
        scene.lights = self.lights.clone().unwrap_or_else(|| default_lights(&scene.camera).to_vec());
        scene
    }

    /// What there is to see, without lights and with a camera anywhere.
    pub(crate) fn unframed(&self) -> Scene<'_> {
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
        Object {
            shape,
            transform: object.transform,
            paint,
            surface: object.surface,
            optics: object.optics,
            settings: object.settings,
        }
    }
}

/// Ambient light of [`default_lights`]: dim, since files give materials an ambient colour as light as the diffuse one.
const AMBIENT: LinearRgb = LinearRgb::grey(0.15);

/// Light for a scene that has none: a white light far away, from the left above the camera, and dim ambient light. The
/// directions are relative to the camera, so that the visible side is lit from any viewpoint.
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

/// Reads a scene, or a mesh as a scene: framed by itself, with a light of its own, in a plain material.
///
/// A name that ends in `.toml` is a scene file, unless a format is given; without one, any other file's content and name
/// determine its format. A glTF file is a scene too: nodes, the first camera, punctual lights, base colours.
///
/// ```no_run
/// use crease::raster::{LoadOptions, load, render};
///
/// let mut file = load("bunny.obj".as_ref(), None, &LoadOptions::default())?;
/// file.settings.size = [1920, 1080];
/// let image = render(&file.scene(), &file.settings)?;
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
///
/// # Scene files
/// A scene in TOML; `docs/scenes.md` of the repository describes every key, `data/scenes` has annotated examples. Only objects are
/// needed: `[[object]]` and one of `mesh`, `polygons`, `surface`. Without a camera all is framed by itself, without a light it is
/// lit by [`default_lights`](crate::raster::default_lights). Angles are in degrees; faces and vertices are counted from 0.
///
/// # Errors
/// The errors of [`io::read`], and files without any face. In scene files, with the line and the key: unknown keys, values of
/// the wrong type or out of range, and what is wrong with meshes that they name. Nothing is silently ignored.
pub fn load(path: &Path, format: Option<Format>, options: &LoadOptions) -> Result<SceneFile, ReadError> {
    if format.is_some() || !is_scene(path) {
        return SceneFile::from_loaded(io::read(path, format, &options.read)?, options);
    }
    SceneFile::from_toml(&read_text(path, options)?, path.parent().unwrap_or(path), options)
}

/// Whether a name is that of a scene file.
pub(crate) fn is_scene(path: &Path) -> bool {
    path.extension().is_some_and(|extension| extension.eq_ignore_ascii_case("toml"))
}

/// The text of a scene file.
pub(crate) fn read_text(path: &Path, options: &LoadOptions) -> Result<String, ReadError> {
    let limits =
        Limits { bytes: options.read.limits.bytes.min(LARGEST_SCENE), ..options.read.limits.clone() };
    let bytes = io::read_whole(path, &limits)?;
    String::from_utf8(bytes).map_err(|error| {
        let before = &error.as_bytes()[..error.utf8_error().valid_up_to()];
        let place = Place::Line(1 + before.iter().filter(|&&byte| byte == b'\n').count() as u64);
        ReadError::new(Problem::Syntax, place, "the text is not UTF-8", "save it as UTF-8")
    })
}

/// Most bytes of a scene file, which takes many times that in memory when parsed.
const LARGEST_SCENE: u64 = 64 << 20;

#[cfg(test)]
mod tests {
    use super::*;
    use crate::io::{ReadOptions, read_bytes};
    use crate::raster::frame::render::render;
    use crate::raster::settings::RenderSettings;

    fn scene(text: &str) -> SceneFile {
        let loaded = read_bytes(text.as_bytes().to_vec(), Some(Format::Obj), None, &ReadOptions::default());
        SceneFile::from_loaded(loaded.unwrap(), &LoadOptions::default()).unwrap()
    }

    /// The same tetrahedron at any size and place gives the same picture, but for roundings of its rim; vertices that
    /// nothing uses do not count.
    #[test]
    fn a_bare_mesh_frames_itself() {
        let draw = |scale: f64, offset: f64| {
            let at = |x: f64, y: f64, z: f64| {
                format!("v {:e} {:e} {:e}\n", x * scale + offset, y * scale + offset, z * scale + offset)
            };
            let vertices =
                [at(0.0, 0.0, 0.0), at(1.0, 0.0, 0.0), at(0.0, 1.0, 0.0), at(0.0, 0.0, 1.0)].concat();
            let unused = at(1e6, 0.0, 0.0);
            let mut file = scene(&format!("{vertices}{unused}f 1 3 2\nf 1 2 4\nf 1 4 3\nf 2 3 4\n"));
            file.settings = RenderSettings { size: [64, 48], ..file.settings };
            render(&file.scene(), &file.settings).unwrap().statistics.covered_pixels
        };
        let expected = draw(1.0, 0.0);
        assert!(expected > 300, "{expected} of 3072 pixels");
        for (scale, offset) in [(1e-30, 0.0), (1e30, 0.0), (1.0, 1e7), (1e-6, -1.0)] {
            let covered = draw(scale, offset);
            assert!(covered.abs_diff(expected) <= 2, "{scale:e} {offset:e}: {covered}, not {expected}");
        }
    }

    #[test]
    fn without_faces_there_is_nothing_to_draw() {
        let loaded = read_bytes(b"v 0 0 0\n".to_vec(), None, None, &ReadOptions::default()).unwrap();
        let error = SceneFile::from_loaded(loaded, &LoadOptions::default()).unwrap_err();
        assert!(error.to_string().starts_with("there are no faces"), "{error}");
    }
}
