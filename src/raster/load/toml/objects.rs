//! The objects of a scene file.

use crate::io::{self, Note, Place, Problem, ReadError, ReadOptions};
use crate::mesh::{Mesh, normal_matrix};
use crate::normals::{Precision, Weight, When};
use crate::num::LinearRgb;
use crate::raster::load::normal_settings::{CreaseValue, MergeName, NormalSettings, StoredFormat, of_keys};
use crate::raster::load::scene_file::{
    LoadOptions, MOST_OBJECTS, MOST_PLACED_CORNERS, SceneFile, SceneMesh, SceneObject, SceneShape,
};
use crate::raster::load::toml::lighting::{MaterialTable, PlanName, ReflectionName};
use crate::raster::load::toml::source::Source;
use crate::raster::load::toml::values::Step;
use crate::raster::load::toml::values::{PolygonTable, SurfaceTable};
use crate::raster::settings::{Interpolation, ObjectSettings, Shading};
use crate::shade::Optics;
use crate::surface::{Primitive, Surface, Tessellation};
use glam::{DMat3, DMat4};
use serde::Deserialize;
use std::ops::Range;
use std::path::{Path, PathBuf};
use toml::Spanned;

#[derive(Deserialize)]
#[serde(deny_unknown_fields, rename_all = "kebab-case")]
pub(super) struct ObjectTable {
    #[serde(default)]
    name: String,
    mesh: Option<Spanned<String>>,
    polygons: Option<Spanned<PolygonTable>>,
    surface: Option<Spanned<SurfaceTable>>,
    tessellation: Option<Spanned<Tessellation>>,
    normals: Option<NormalsName>,
    weight: Option<Weight>,
    crease: Option<CreaseValue>,
    precision: Option<Precision>,
    normal_format: Option<StoredFormat>,
    merge: Option<MergeName>,
    shading: Option<Spanned<ShadingName>>,
    interpolation: Option<Interpolation>,
    two_sided: Option<bool>,
    plan: Option<PlanName>,
    #[serde(default)]
    transform: Vec<Step>,
    material: Option<Spanned<MaterialTable>>,
}

/// `normals = …`
#[derive(Clone, Copy, Deserialize)]
#[serde(rename_all = "kebab-case")]
enum NormalsName {
    Given,
    Computed,
}

impl From<NormalsName> for When {
    fn from(name: NormalsName) -> Self {
        match name {
            NormalsName::Given => When::Missing,
            NormalsName::Computed => When::Always,
        }
    }
}

/// `shading = …` of an object: a wireframe is one of all objects.
#[derive(Clone, Copy, Deserialize)]
#[serde(rename_all = "kebab-case")]
enum ShadingName {
    Flat,
    Gouraud,
    Phong,
    Exact,
}

impl From<&ShadingName> for Shading {
    fn from(name: &ShadingName) -> Self {
        match name {
            ShadingName::Flat => Self::Flat,
            ShadingName::Gouraud => Self::Gouraud,
            ShadingName::Phong => Self::Phong,
            ShadingName::Exact => Self::Exact,
        }
    }
}

pub(super) struct Builder<'a> {
    source: Source<'a>,
    base: &'a Path,
    options: LoadOptions,
    reflection: Option<ReflectionName>,
    /// The normals of objects that state nothing themselves.
    normals: NormalSettings,
    scene: SceneFile,
    /// Objects of mesh files that are read, with their paths and how their normals are computed.
    files: Vec<(PathBuf, When, NormalSettings, Vec<SceneObject>)>,
    /// Corners of faces of all objects.
    placed: u64,
}

impl<'a> Builder<'a> {
    pub(super) fn new(
        source: Source<'a>,
        base: &'a Path,
        options: &LoadOptions,
        reflection: Option<ReflectionName>,
        normals: NormalSettings,
        scene: SceneFile,
    ) -> Self {
        // Files that meshes refer to may lie anywhere in the scene's folder, too.
        let folder = if base.as_os_str().is_empty() { Path::new(".") } else { base };
        let root = options.read.root.clone().unwrap_or_else(|| folder.to_owned());
        let read = ReadOptions { root: Some(root), ..options.read.clone() };
        let options = LoadOptions { read, ..options.clone() };
        Self { source, base, options, reflection, normals, scene, files: Vec::new(), placed: 0 }
    }

    pub(super) fn finish(self) -> Result<SceneFile, ReadError> {
        if self.scene.objects.is_empty() {
            let found = "the scene has no objects";
            return Err(ReadError::new(Problem::Unsupported, Place::File, found, "add an [[object]]"));
        }
        Ok(self.scene)
    }

    /// Adds an object of the file: all objects of a mesh file, if it names one.
    pub(super) fn add(&mut self, table: Spanned<ObjectTable>) -> Result<(), ReadError> {
        let (span, table) = (table.span(), table.into_inner());
        let transform = table.transform.iter().fold(DMat4::IDENTITY, |so_far, step| step.matrix() * so_far);
        if normal_matrix(DMat3::from_mat4(transform)).is_none() || !transform.is_finite() {
            let span = self.source.member(&span, &["transform"]);
            let advice = "scale no axis by 0, and keep numbers moderate";
            return Err(self.source.error(&span, "the transform flattens space, or is out of range", advice));
        }
        let material = table.material.as_ref().map(|table| MaterialTable::material(self.source, table));
        let material = material.transpose()?.flatten();
        let optics = table.material.as_ref().map(|table| MaterialTable::optics(self.source, table));
        let optics = optics.transpose()?.flatten();
        let own = table.material.as_ref().and_then(|material| material.get_ref().reflection);
        let keys = of_keys(table.weight, table.crease, table.precision, table.normal_format, table.merge);
        let normals = keys.or(self.normals);
        let computes = normals.computes().then_some(When::Always);
        let when = self.options.when.or(table.normals.map(When::from)).or(computes);
        // Meshes of the scene itself keep their normals unless they are to be computed.
        let when = when.unwrap_or(if table.mesh.is_some() { When::default() } else { When::Missing });
        let normals = (when, self.options.normals.or(normals));
        for object in self.shapes(&span, &table, normals)? {
            let mut object = SceneObject {
                name: if table.name.is_empty() { object.name } else { table.name.clone() },
                transform: transform * object.transform,
                material: material.unwrap_or(object.material),
                // A material of its own replaces that of a file.
                optics: optics.or(material.map(|_| Optics::NONE)).unwrap_or(object.optics),
                settings: ObjectSettings {
                    shading: table.shading.as_ref().map(|shading| shading.get_ref().into()),
                    interpolation: table.interpolation,
                    two_sided: table.two_sided,
                },
                normals: normals.1,
                keeps_normals: when != When::Always,
                is_kept: table.plan.is_some(),
                ..object
            };
            if let Some(name) = own.or(self.reflection) {
                object.given = matches!(name, ReflectionName::Given);
                object.material.reflection = name.reflection().unwrap_or(object.material.reflection);
            }
            let is_surface = object.surface.is_some() || matches!(object.shape, SceneShape::Surface(_));
            if let (Some(shading), false) = (&table.shading, is_surface)
                && matches!(shading.get_ref(), ShadingName::Exact)
            {
                let found = "exact shading of a mesh";
                let advice = "choose another shading, or give the object a `surface`";
                return Err(self.source.error(&shading.span(), found, advice));
            }
            self.place(&span, object)?;
        }
        Ok(())
    }

    fn place(&mut self, span: &Range<usize>, object: SceneObject) -> Result<(), ReadError> {
        let mesh = match object.shape {
            SceneShape::Mesh(number) => Some(&self.scene.meshes[number]),
            SceneShape::Surface(_) => None,
        };
        if object.given && mesh.is_none_or(|mesh| mesh.colours.is_none()) {
            let found = "reflection is given, but the vertices have no colours";
            let advice = "give polygons `colours`, use a mesh file that has them, or light the object";
            return Err(self.source.error(span, found, advice));
        }
        self.placed += mesh.map_or(0, |mesh| mesh.mesh.faces().corner_count() as u64);
        let objects = self.scene.objects.len();
        if self.placed > MOST_PLACED_CORNERS || objects == MOST_OBJECTS {
            let found = format!("{} corners of faces so far, in {objects} objects", self.placed);
            return Err(self.source.error(span, &found, "divide the scene"));
        }
        self.scene.objects.push(object);
        Ok(())
    }

    /// The objects of a table, in their own space.
    fn shapes(
        &mut self,
        span: &Range<usize>,
        table: &ObjectTable,
        normals: (When, NormalSettings),
    ) -> Result<Vec<SceneObject>, ReadError> {
        if let (Some(tessellation), None) = (&table.tessellation, &table.surface) {
            let found = "a tessellation without a surface";
            return Err(self.source.error(&tessellation.span(), found, "only a surface can be tessellated"));
        }
        match (&table.mesh, &table.polygons, &table.surface) {
            (Some(name), None, None) => self.file(name, normals),
            (None, Some(polygons), None) => {
                let (mesh, colours) = PolygonTable::mesh(self.source, polygons)?;
                Ok(vec![self.mesh(mesh, colours, normals, None)])
            }
            (None, None, Some(surface)) => self.surface(surface, table.tessellation.as_ref(), normals),
            _ => {
                let advice = "an object has exactly one of `mesh`, `polygons` and `surface`";
                Err(self.source.error(span, "no shape, or several", advice))
            }
        }
    }

    /// A mesh of the scene itself.
    fn mesh(
        &mut self,
        mesh: Mesh,
        colours: Option<Vec<LinearRgb>>,
        (when, normals): (When, NormalSettings),
        surface: Option<Primitive>,
    ) -> SceneObject {
        let field = normals.normals(&mesh, &self.options.recipe, when);
        let mesh = SceneMesh { mesh, normals: field, colours, source_faces: None };
        self.scene.meshes.push(mesh.stored(&normals));
        SceneObject { surface, ..SceneObject::new(SceneShape::Mesh(self.scene.meshes.len() - 1)) }
    }

    fn surface(
        &mut self,
        table: &Spanned<SurfaceTable>,
        tessellation: Option<&Spanned<Tessellation>>,
        normals: (When, NormalSettings),
    ) -> Result<Vec<SceneObject>, ReadError> {
        let source = self.source;
        let surface = table.get_ref().surface();
        let surface = surface.map_err(|error| source.error(&table.span(), &error.to_string(), ""))?;
        let primitive = match surface {
            Surface::Primitive(primitive) => Some(primitive),
            _ => None,
        };
        match (tessellation, primitive) {
            (Some(tessellation), _) => {
                let mesh = surface.tessellate(tessellation.get_ref());
                let mesh =
                    mesh.map_err(|error| source.error(&tessellation.span(), &error.to_string(), ""))?;
                Ok(vec![self.mesh(mesh, None, normals, primitive)])
            }
            (None, Some(primitive)) => Ok(vec![SceneObject::new(SceneShape::Surface(primitive))]),
            (None, None) => {
                let found = "no rays can be cast at this surface";
                Err(source.error(&table.span(), found, "give the object a tessellation, for example { }"))
            }
        }
    }

    /// The objects of a mesh file, which is read once.
    fn file(
        &mut self,
        name: &Spanned<String>,
        (when, normals): (When, NormalSettings),
    ) -> Result<Vec<SceneObject>, ReadError> {
        let fault = |error: ReadError| {
            let place = if error.place == Place::File { String::new() } else { format!("{}: ", error.place) };
            let found = format!("{}: {place}{}", name.get_ref(), error.found);
            // A scene cannot name the format of a file.
            let is_unknown = error.problem == Problem::Syntax && error.advice.contains("--format");
            let advice = match is_unknown {
                true => "give it the ending of its format: .obj, .ply, .stl, .gltf, .glb or .3mf",
                false => &error.advice,
            };
            ReadError { problem: error.problem, ..self.source.error(&name.span(), &found, advice) }
        };
        let path = io::companion(self.base, name.get_ref(), &self.options.read).map_err(fault)?;
        let is_same = |known: &&(PathBuf, When, NormalSettings, _)| {
            (&known.0, known.1, known.2) == (&path, when, normals)
        };
        if let Some((.., objects)) = self.files.iter().find(is_same) {
            return Ok(objects.clone());
        }
        let options = LoadOptions { when: Some(when), normals, from_elsewhere: true, ..self.options.clone() };
        let loaded = io::read(&path, None, &options.read).map_err(fault)?;
        let mut file = SceneFile::from_loaded(loaded, &options).map_err(fault)?;
        let note =
            |note: Note| Note { text: format!("{}: {note}", name.get_ref()), place: Place::File, ..note };
        self.scene.notes.extend(file.notes.into_iter().map(note));
        if file.lights.is_some() || file.camera.is_some() {
            let text = format!("{}: its camera and lights are not those of the scene", name.get_ref());
            self.scene.notes.push(Note::remark(text));
        }
        let first = self.scene.meshes.len();
        self.scene.meshes.extend(file.meshes);
        for object in &mut file.objects {
            if let SceneShape::Mesh(number) = &mut object.shape {
                *number += first;
            }
        }
        self.files.push((path, when, normals, file.objects.clone()));
        Ok(file.objects)
    }
}
