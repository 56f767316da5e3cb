//! The scene of a plan: its objects with any model, drawn from every view.

use super::axes::{Cells, Normals, ObjectModel, Terms};
use super::cost::Sizes;
use super::document::{Document, with_terms};
use super::unit::{Unit, count_vertices};
use crate::io::{ReadError, WriteError};
use crate::num::LinearRgb;
use crate::raster::{
    Camera, Image, LoadOptions, Object, Paint, RenderError, RenderScratch, RenderSettings, Samples, Scene,
    SceneFile, SceneShape, Shape, Show, pixel_colour, probe, render_reusing,
};
use crate::shade::Light;
use std::borrow::Cow;
use std::cell::RefCell;
use std::collections::HashMap;
use std::ops::Range;
use std::path::Path;
use std::rc::Rc;

/// What of a model decides the vertices and normals of an object.
type Geometry = (usize, Option<Normals>, Cells, bool);

/// The scene of a plan. A copy shares everything that was read.
#[derive(Clone)]
pub struct Stage<'a> {
    document: &'a Document,
    base: &'a Path,
    options: &'a LoadOptions,
    /// The settings of its pictures.
    pub settings: RenderSettings,
    /// Its objects.
    pub units: Rc<[Unit]>,
    /// The number of the first object of each unit, and of all objects at the end.
    first: Vec<usize>,
    background: LinearRgb,
    /// Those of other models that were needed.
    loaded: Rc<RefCell<Loaded>>,
    /// The memory of pictures before.
    scratch: Rc<RefCell<RenderScratch>>,
}

/// Models of objects that were read, and the corners that they have in all.
type Loaded = (HashMap<Geometry, Rc<SceneFile>>, usize);

/// Most corners of faces of models that are kept: some 50 bytes each. Beyond that all are read again when they are needed.
const MOST_CORNERS: usize = 1 << 25;

impl<'a> Stage<'a> {
    /// From a scene file, which is read as a `whole` already.
    ///
    /// # Errors
    /// What makes the scene unreadable.
    pub fn new(
        document: &'a Document,
        whole: &SceneFile,
        base: &'a Path,
        options: &'a LoadOptions,
    ) -> Result<Self, ReadError> {
        let settings = RenderSettings { keep_linear: true, keep_objects: true, ..whole.settings };
        let (mut units, mut first) = (Vec::new(), vec![0]);
        for object in 0..document.objects() {
            let declared = Rc::new(SceneFile::from_toml(&document.only(object).to_string(), base, options)?);
            first.push(first[object] + declared.objects.len());
            let mut unit = Unit::new(document, object, declared, &settings);
            if units.iter().any(|other: &Unit| other.name == unit.name) {
                unit.name += &format!(" ({object})");
            }
            units.push(unit);
        }
        let (units, background) = (units.into(), whole.background);
        let (loaded, scratch) = (Rc::default(), Rc::default());
        Ok(Self { document, base, options, settings, units, first, background, loaded, scratch })
    }

    /// The same scene, drawn with another number of samples for each pixel.
    pub fn with_samples(&self, samples: Samples) -> Self {
        let settings = RenderSettings { samples, ..self.settings };
        Self { settings, ..self.clone() }
    }

    /// The objects of a unit with the vertices and normals of a model.
    ///
    /// # Errors
    /// What makes the changed scene unreadable.
    pub fn geometry(&self, unit: usize, model: &ObjectModel) -> Result<Rc<SceneFile>, ReadError> {
        let Unit { declared, reference, .. } = &self.units[unit];
        // Without normals of vertices those of faces are taken, which every mesh has.
        let normals = model.normals.or(reference.normals);
        let key = (unit, normals, model.segments, model.merged);
        if key == (unit, reference.normals, reference.segments, reference.merged) {
            return Ok(declared.clone());
        }
        if let Some(known) = self.loaded.borrow().0.get(&key) {
            return Ok(known.clone());
        }
        let mut document = self.document.only(unit);
        let wanted = ObjectModel { normals, segments: model.segments, merged: model.merged, ..*reference };
        document.apply(0, &wanted, reference, None, &|_| String::new());
        let file = Rc::new(SceneFile::from_toml(&document.to_string(), self.base, self.options)?);
        let corners: usize = file.meshes.iter().map(|mesh| mesh.mesh.faces().corner_count()).sum();
        let (loaded, count) = &mut *self.loaded.borrow_mut();
        if *count + corners > MOST_CORNERS {
            loaded.clear();
            *count = 0;
        }
        *count += corners;
        loaded.insert(key, file.clone());
        Ok(file)
    }

    /// Draws units with their models from a camera, under lights.
    ///
    /// # Errors
    /// What makes a picture impossible.
    pub fn draw(
        &self,
        models: &[(usize, ObjectModel)],
        lights: &[Light],
        camera: &Camera,
    ) -> Result<Image, PlanError> {
        let files = models.iter().map(|(unit, model)| self.geometry(*unit, model));
        let files: Vec<Rc<SceneFile>> = files.collect::<Result<_, _>>()?;
        let objects = models.iter().zip(&files).flat_map(|((unit, model), file)| {
            file.unframed().objects.into_iter().map(|object| self.changed(*unit, model, object))
        });
        let scene = self.scene(objects.collect(), lights, camera);
        Ok(render_reusing(&scene, &self.settings, &mut self.scratch.borrow_mut())?)
    }

    /// Which sides of faces are seen, before a black background.
    ///
    /// # Errors
    /// What makes a picture impossible.
    pub fn sides(&self, models: &[(usize, ObjectModel)], camera: &Camera) -> Result<Image, PlanError> {
        let settings = RenderSettings { show: Show::Facing, ..self.settings };
        Self { settings, background: LinearRgb::BLACK, ..self.clone() }.draw(models, &[], camera)
    }

    fn scene<'o>(&self, objects: Vec<Object<'o>>, lights: &[Light], camera: &Camera) -> Scene<'o> {
        Scene {
            objects,
            lines: Vec::new(),
            lights: lights.to_vec(),
            camera: *camera,
            background: self.background,
        }
    }

    /// An object of a unit with the settings and the material of a model.
    fn changed<'o>(&self, unit: usize, model: &ObjectModel, mut object: Object<'o>) -> Object<'o> {
        let Unit { reference, material, .. } = &self.units[unit];
        let own = &mut object.settings;
        if model.shading != reference.shading {
            own.shading = Some(model.shading);
        }
        if model.interpolation != reference.interpolation {
            own.interpolation = Some(model.interpolation);
        }
        if model.two_sided != reference.two_sided {
            own.two_sided = Some(model.two_sided);
        }
        if let (Some(material), true) = (material, model.terms != Terms::Declared) {
            object.paint = Paint::Lit(with_terms(material, model.terms));
        }
        object
    }

    /// The face of a unit that all samples of a pixel show, with the number of its object in the unit; `None` if there is none. A surface
    /// that rays are cast at is one face.
    ///
    /// # Errors
    /// What makes a picture impossible.
    pub fn face_at(
        &self,
        (unit, model): (usize, &ObjectModel),
        camera: &Camera,
        pixel: [u32; 2],
    ) -> Result<Option<(usize, u32)>, PlanError> {
        let file = self.geometry(unit, model)?;
        let scene = self.scene(file.unframed().objects, &[], camera);
        let mut found = None;
        for sample in 0..self.settings.samples.count() {
            let point = probe(&scene, &self.settings, pixel, sample)?;
            let is_cast = self.units[unit].is_cast;
            let face = point.and_then(|point| Some((point.object, point.face.or(is_cast.then_some(0))?)));
            if face.is_none() || sample > 0 && face != found {
                return Ok(None);
            }
            found = face;
        }
        Ok(found)
    }

    /// The linear colour of a pixel that shows only this face of a unit: as in the whole picture, to the bit.
    ///
    /// # Errors
    /// What makes a picture impossible.
    pub fn colour_of_face(
        &self,
        (unit, model): (usize, &ObjectModel),
        lights: &[Light],
        camera: &Camera,
        ((object, face), pixel): ((usize, u32), [u32; 2]),
    ) -> Result<[f32; 3], PlanError> {
        let declared = self.units[unit].reference.normals.and_then(|normals| normals.format);
        // Normals are rounded here, where the declared ones are not: a mesh has many, a face a few.
        let rounds = model.normals.and_then(|normals| normals.format).filter(|_| declared.is_none());
        let unrounded = match rounds {
            Some(_) => model.with_format(None),
            None => *model,
        };
        let file = self.geometry(unit, &unrounded)?;
        let whole = file.unframed().objects.swap_remove(object);
        let SceneShape::Mesh(number) = file.objects[object].shape else {
            let alone = self.changed(unit, model, whole);
            return Ok(pixel_colour(&self.scene(vec![alone], lights, camera), &self.settings, pixel)?);
        };
        let mut mesh = file.meshes[number].of_face(face);
        if let Some(format) = rounds {
            format.round(&mut mesh.normals);
        }
        let shape = Shape::Mesh { mesh: &mesh.mesh, normals: &mesh.normals };
        let paint = match &whole.paint {
            Paint::Given(_) => Paint::Given(Cow::Owned(mesh.colours.clone().unwrap_or_default())),
            Paint::Lit(material) => Paint::Lit(*material),
        };
        let alone = Object { shape, paint, surface: None, ..whole };
        let alone = self.changed(unit, model, alone);
        Ok(pixel_colour(&self.scene(vec![alone], lights, camera), &self.settings, pixel)?)
    }

    /// The number of objects of all units.
    pub fn objects(&self) -> usize {
        self.first.last().copied().unwrap_or(0)
    }

    /// The numbers of a unit's objects among those of all.
    pub fn objects_of(&self, unit: usize) -> Range<usize> {
        self.first[unit]..self.first[unit + 1]
    }

    /// The unit that an object belongs to.
    pub fn unit_of(&self, object: u32) -> usize {
        self.first.partition_point(|&first| first <= object as usize) - 1
    }

    /// The sizes of a unit with a model; its samples and pictures are those of the reference.
    ///
    /// # Errors
    /// What makes the changed scene unreadable.
    pub fn sizes(
        &self,
        unit: usize,
        model: &ObjectModel,
        samples: u64,
        pictures: u64,
    ) -> Result<Sizes, ReadError> {
        let file = self.geometry(unit, model)?;
        let mut sizes = Sizes { samples, pictures, is_cast: self.units[unit].is_cast, ..Sizes::default() };
        for object in &file.objects {
            let SceneShape::Mesh(number) = object.shape else { continue };
            let [vertices, normals] = count_vertices(&file.meshes[number]);
            sizes.vertices += vertices;
            sizes.normals += normals;
            let mesh = &file.meshes[number].mesh;
            sizes.faces += mesh.face_count() as u64;
            sizes.corners += mesh.faces().corner_count() as u64;
            sizes.triangles += (mesh.faces().corner_count() - 2 * mesh.face_count()) as u64;
        }
        Ok(sizes)
    }
}

/// Why there is no plan.
#[derive(Debug, thiserror::Error)]
pub enum PlanError {
    /// The scene cannot be read.
    #[error(transparent)]
    Read(#[from] ReadError),
    /// The scene cannot be drawn.
    #[error(transparent)]
    Render(#[from] RenderError),
    /// Pictures cannot be compared.
    #[error(transparent)]
    Metric(#[from] crate::metric::MetricError),
    /// What was asked for makes no sense for the scene.
    #[error("{0}")]
    Invalid(String),
    /// A planned mesh file cannot be made.
    #[error("{name}: {error}")]
    Write {
        /// The file that it is made from, as the scene names it.
        name: String,
        /// Why.
        error: WriteError,
    },
}
