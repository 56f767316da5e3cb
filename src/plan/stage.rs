//! The scene of a plan: its objects with any model, drawn from every view.

use super::axes::{Normals, ObjectModel, Source, Terms};
use super::cost::{Highlight, Sizes};
use super::document::{Document, with_terms};
use crate::io::ReadError;
use crate::mesh::ColumnIndex;
use crate::normals::{Precision, Weight};
use crate::raster::{
    Camera, Image, LoadOptions, Object, Paint, RenderError, RenderSettings, Scene, SceneFile, SceneShape,
    Shading, Shape, pixel_colour, probe, render,
};
use crate::shade::{Light, Material};
use std::borrow::Cow;
use std::collections::HashMap;
use std::ops::Range;
use std::path::Path;
use std::sync::{Arc, Mutex};

/// An object table of the scene file, which may be several objects of a mesh file.
#[derive(Debug)]
pub struct Unit {
    /// Its name in reports.
    pub name: String,
    /// The objects as declared.
    pub declared: Arc<SceneFile>,
    /// Its model as declared.
    pub reference: ObjectModel,
    /// The material that all its objects have; `None` if they have several, or colours of their vertices.
    pub material: Option<Material>,
    /// Its most expensive highlight.
    pub highlight: Highlight,
    /// Whether the scene marks it as unchanged.
    pub is_kept: bool,
    /// Whether rays are cast at it.
    pub is_cast: bool,
    /// Whether its cells can be changed, with the declared ones.
    pub segments: Option<[u32; 2]>,
    /// Whether its normals differ between hard and smooth edges.
    pub has_splits: bool,
}

/// What of a model decides the vertices and normals of an object.
type Geometry = (usize, Option<Normals>, Option<[u32; 2]>);

/// The scene of a plan.
pub struct Stage<'a> {
    document: &'a Document,
    base: &'a Path,
    options: &'a LoadOptions,
    /// The settings of its pictures.
    pub settings: RenderSettings,
    /// Its objects.
    pub units: Vec<Unit>,
    /// The number of the first object of each unit, and of all objects at the end.
    first: Vec<usize>,
    background: crate::num::LinearRgb,
    loaded: Mutex<HashMap<Geometry, Arc<SceneFile>>>,
}

impl<'a> Stage<'a> {
    /// From a scene file.
    ///
    /// # Errors
    /// What makes the scene unreadable.
    pub fn new(document: &'a Document, base: &'a Path, options: &'a LoadOptions) -> Result<Self, ReadError> {
        let whole = SceneFile::from_toml(&document.to_string(), base, options)?;
        let settings = RenderSettings { keep_linear: true, keep_objects: true, ..whole.settings };
        let mut stage = Self {
            document,
            base,
            options,
            settings,
            units: Vec::new(),
            first: vec![0],
            background: whole.background,
            loaded: Mutex::default(),
        };
        for object in 0..document.objects() {
            let declared = Arc::new(SceneFile::from_toml(&document.only(object).to_string(), base, options)?);
            stage.first.push(stage.objects() + declared.objects.len());
            stage.units.push(unit(document, object, declared, &settings));
        }
        Ok(stage)
    }

    /// The objects of a unit with the vertices and normals of a model.
    ///
    /// # Errors
    /// What makes the changed scene unreadable.
    pub fn geometry(&self, unit: usize, model: &ObjectModel) -> Result<Arc<SceneFile>, ReadError> {
        let Unit { declared, reference, .. } = &self.units[unit];
        // Without normals of vertices those of faces are taken, which every mesh has.
        let normals = model.normals.or(reference.normals);
        if normals == reference.normals && model.segments == reference.segments {
            return Ok(declared.clone());
        }
        let key = (unit, normals, model.segments);
        if let Some(known) = self.loaded.lock().ok().and_then(|loaded| loaded.get(&key).cloned()) {
            return Ok(known);
        }
        let mut document = self.document.only(unit);
        let wanted = ObjectModel { normals, segments: model.segments, ..*reference };
        document.apply(0, &wanted, reference, None, &|_| String::new());
        let file = Arc::new(SceneFile::from_toml(&document.to_string(), self.base, self.options)?);
        if let Ok(mut loaded) = self.loaded.lock() {
            loaded.insert(key, file.clone());
        }
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
        let files: Vec<Arc<SceneFile>> = files.collect::<Result<_, _>>()?;
        let objects = models.iter().zip(&files).flat_map(|((unit, model), file)| {
            file.unframed().objects.into_iter().map(|object| self.changed(*unit, model, object))
        });
        Ok(render(&self.scene(objects.collect(), lights, camera), &self.settings)?)
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

    /// The face of a unit that a pixel shows, with the number of its object in the unit; `None` if it shows no face.
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
        let point = probe(&scene, &self.settings, pixel, 0)?;
        Ok(point.and_then(|point| Some((point.object, point.face?))))
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
        let SceneShape::Mesh(number) = file.objects[object].shape else { return Ok([0.0; 3]) };
        let mut mesh = file.meshes[number].of_face(face);
        if let Some(format) = rounds {
            format.round(&mut mesh.normals);
        }
        let shape = Shape::Mesh { mesh: &mesh.mesh, normals: &mesh.normals };
        let whole = file.unframed().objects.swap_remove(object);
        let paint = match whole.paint {
            Paint::Given(_) => Paint::Given(Cow::Owned(mesh.colours.clone().unwrap_or_default())),
            Paint::Lit(material) => Paint::Lit(material),
        };
        let alone =
            Object { shape, transform: whole.transform, paint, surface: None, settings: whole.settings };
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
            let mesh = &file.meshes[number];
            let faces = mesh.mesh.faces();
            sizes.vertices += mesh.mesh.vertex_count() as u64;
            sizes.normals += match &mesh.normals.normals.index {
                ColumnIndex::PerVertex => mesh.mesh.vertex_count() as u64,
                ColumnIndex::PerCorner(_) => mesh.normals.normals.values.len() as u64,
            };
            sizes.faces += mesh.mesh.face_count() as u64;
            sizes.corners += faces.corner_count() as u64;
            sizes.triangles += (faces.corner_count() - 2 * mesh.mesh.face_count()) as u64;
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
}

fn unit(document: &Document, object: usize, declared: Arc<SceneFile>, settings: &RenderSettings) -> Unit {
    let first = &declared.objects[0];
    let is_same = declared.objects.iter().all(|other| other.material == first.material && !other.given);
    let material = (is_same && !first.given).then_some(first.material);
    let has_highlight =
        |object: &crate::raster::SceneObject| object.material.specular.merged().largest() > 0.0;
    let highlight =
        declared.objects.iter().find(|object| has_highlight(object)).map(|object| object.material.reflection);
    let is_cast = declared.objects.iter().all(|object| matches!(object.shape, SceneShape::Surface(_)));
    let own = first.settings;
    let normals = declared_normals(document, object);
    let reference = ObjectModel {
        shading: own.shading.unwrap_or(settings.shading),
        normals: (!is_cast).then_some(normals),
        interpolation: own.interpolation.unwrap_or(settings.interpolation),
        terms: Terms::Declared,
        segments: document.segments(object).filter(|_| !is_cast),
        two_sided: own.two_sided.unwrap_or(settings.two_sided),
    };
    let reference = match reference.shading {
        Shading::Flat | Shading::Wireframe => ObjectModel { normals: None, ..reference },
        _ => reference,
    };
    let has_splits =
        declared.meshes.iter().any(|mesh| mesh.normals.normals.values.len() > mesh.mesh.vertex_count());
    let name = if first.name.is_empty() { format!("object {object}") } else { first.name.clone() };
    let (is_kept, segments) = (first.is_kept, reference.segments);
    Unit { name, declared, reference, material, highlight, is_kept, is_cast, segments, has_splits }
}

/// The normals that an object declares.
fn declared_normals(document: &Document, object: usize) -> Normals {
    let text = |key: &str| document.text_of(object, key).or_else(|| document.setting(key));
    let weight = text("weight").and_then(|name| Weight::ALL.into_iter().find(|weight| weight.name() == name));
    let computes = weight.is_some()
        || text("precision").is_some()
        || document.has(object, "crease")
        || document.has_setting("crease");
    let is_given = match document.text_of(object, "normals") {
        Some(name) => name == "given",
        None => !document.has(object, "mesh") && !computes,
    };
    Normals {
        source: if is_given { Source::Given } else { Source::Computed(weight.unwrap_or_default()) },
        creases: true,
        precision: if text("precision") == Some("fast") { Precision::Fast } else { Precision::Faithful },
        format: text("normal-format").and_then(|name| {
            crate::raster::StoredFormat::ALL.into_iter().find(|format| format.name() == name)
        }),
    }
}
