//! The scene of a plan: its objects with any model, drawn from every view.

use super::axes::{Normals, ObjectModel, Source, Terms};
use super::cost::{Highlight, Sizes};
use super::document::{Document, with_terms};
use crate::io::ReadError;
use crate::mesh::ColumnIndex;
use crate::normals::{Precision, Weight};
use crate::raster::{
    Camera, Image, LoadOptions, ObjectSettings, Paint, RenderError, RenderSettings, Scene, SceneFile,
    SceneShape, Shading, render,
};
use crate::shade::{Light, Material};
use std::collections::HashMap;
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
            background: whole.background,
            loaded: Mutex::default(),
        };
        for object in 0..document.objects() {
            let declared = Arc::new(SceneFile::from_toml(&document.only(object).to_string(), base, options)?);
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
        let files: Vec<Arc<SceneFile>> =
            models.iter().map(|(unit, model)| self.geometry(*unit, model)).collect::<Result<_, _>>()?;
        let mut objects = Vec::new();
        for ((unit, model), file) in models.iter().zip(&files) {
            let Unit { reference, material, .. } = &self.units[*unit];
            for mut object in file.unframed().objects {
                let own = &mut object.settings;
                let differs = ObjectSettings {
                    shading: (model.shading != reference.shading).then_some(model.shading).or(own.shading),
                    interpolation: (model.interpolation != reference.interpolation)
                        .then_some(model.interpolation)
                        .or(own.interpolation),
                    two_sided: (model.two_sided != reference.two_sided)
                        .then_some(model.two_sided)
                        .or(own.two_sided),
                };
                *own = differs;
                if let (Some(material), true) = (material, model.terms != Terms::Declared) {
                    object.paint = Paint::Lit(with_terms(material, model.terms));
                }
                objects.push(object);
            }
        }
        let scene = Scene {
            objects,
            lines: Vec::new(),
            lights: lights.to_vec(),
            camera: *camera,
            background: self.background,
        };
        Ok(render(&scene, &self.settings)?)
    }

    /// The numbers that pixels of a unit have if it is drawn with the others, or alone: see [`Image::objects`].
    pub fn numbers(&self, unit: usize, is_alone: bool) -> Vec<u32> {
        let before =
            if is_alone { 0 } else { self.units[..unit].iter().map(|it| it.declared.objects.len()).sum() };
        let samples = self.settings.samples.count();
        (before..before + self.units[unit].declared.objects.len())
            .map(|object| Image::number_of(object, samples))
            .collect()
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
