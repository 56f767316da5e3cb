//! The objects of a scene file.

use crate::io::{self, Note, Place, Problem, ReadError, ReadOptions};
use crate::mesh::{Column, Columns, Faces, Mesh, MeshBuilder, normal_matrix};
use crate::normals::{When, compute};
use crate::num::{LinearRgb, UnitVec3};
use crate::raster::load::bare::{MOST_OBJECTS, MOST_PLACED_CORNERS};
use crate::raster::load::lights::plain_material;
use crate::raster::load::toml::choose;
use crate::raster::load::toml::keys::{ObjectKeys, PolygonKeys, SurfaceKeys, TessellationKeys};
use crate::raster::load::toml::material::{Colouring, material};
use crate::raster::load::toml::place::Source;
use crate::raster::load::toml::surfaces::{surface, tessellation};
use crate::raster::load::toml::values::Vector;
use crate::raster::load::{LoadOptions, SceneFile, SceneMesh, SceneObject, SceneShape};
use crate::surface::{Primitive, Surface};
use glam::{DMat3, DMat4};
use std::collections::BTreeMap;
use std::ops::Range;
use std::path::{Path, PathBuf};
use toml::Spanned;

/// Puts objects into a scene.
pub(super) struct Builder<'a> {
    source: Source<'a>,
    base: &'a Path,
    options: LoadOptions,
    /// The colouring of objects that say nothing about theirs.
    colouring: Option<Colouring>,
    scene: SceneFile,
    /// Objects of mesh files that are read, by path and by whether all their normals are computed.
    files: BTreeMap<(PathBuf, bool), Vec<SceneObject>>,
    /// Corners of faces, at all places where they stand.
    placed: u64,
}

impl<'a> Builder<'a> {
    pub(super) fn new(
        source: Source<'a>,
        base: &'a Path,
        options: &LoadOptions,
        colouring: Option<Colouring>,
        scene: SceneFile,
    ) -> Self {
        // What meshes refer to may lie anywhere in the scene's folder, too.
        let folder = if base.as_os_str().is_empty() { Path::new(".") } else { base };
        let root = options.read.root.clone().unwrap_or_else(|| folder.to_owned());
        let read = ReadOptions { root: Some(root), ..options.read.clone() };
        let options = LoadOptions { read, ..options.clone() };
        Self { source, base, options, colouring, scene, files: BTreeMap::new(), placed: 0 }
    }

    /// The scene.
    pub(super) fn finish(self) -> Result<SceneFile, ReadError> {
        if self.scene.objects.is_empty() {
            let found = "the scene has no objects";
            return Err(ReadError::new(Problem::Unsupported, Place::File, found, "add an [[object]]"));
        }
        Ok(self.scene)
    }

    /// Adds an object of the file: all of a mesh file's, if it is one.
    pub(super) fn add(&mut self, keys: Spanned<ObjectKeys>) -> Result<(), ReadError> {
        let (span, keys) = (keys.span(), keys.into_inner());
        let transform = keys.transform.iter().fold(DMat4::IDENTITY, |so_far, step| step.matrix() * so_far);
        if normal_matrix(DMat3::from_mat4(transform)).is_none() || !transform.is_finite() {
            let span = self.source.member(&span, &["transform"]);
            let advice = "scale no axis by 0, and keep numbers moderate";
            return Err(self.source.error(&span, "it flattens space, or is beyond all measure", advice));
        }
        let material = keys.material.as_ref().map(|keys| material(self.source, keys)).transpose()?;
        let (material, own) = material.unwrap_or_default();
        let colouring = own.or(self.colouring);
        for object in self.shapes(&span, &keys)? {
            let mut object = SceneObject {
                name: if keys.name.is_empty() { object.name } else { keys.name.clone() },
                transform: transform * object.transform,
                material: material.unwrap_or(object.material),
                ..object
            };
            match colouring {
                Some(Colouring::Lit(reflection)) => {
                    object.material.reflection = reflection;
                    object.given = false;
                }
                Some(Colouring::Given) => object.given = true,
                None => {}
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
            let advice = "give polygons `colours`, take a mesh file that has them, or light the object";
            return Err(self.source.error(
                span,
                "reflection is given, but the vertices have no colours",
                advice,
            ));
        }
        self.placed += mesh.map_or(0, |mesh| mesh.mesh.faces().corner_count() as u64);
        if self.placed > MOST_PLACED_CORNERS || self.scene.objects.len() == MOST_OBJECTS {
            let found =
                format!("{} corners of faces by now, in {} objects", self.placed, self.scene.objects.len());
            return Err(self.source.error(span, &found, "divide the scene"));
        }
        self.scene.objects.push(object);
        Ok(())
    }

    /// What an object is made of, in its own space.
    fn shapes(&mut self, span: &Range<usize>, keys: &ObjectKeys) -> Result<Vec<SceneObject>, ReadError> {
        if let (Some(tessellation), None) = (&keys.tessellation, &keys.surface) {
            let found = "a tessellation without a surface";
            return Err(self.source.error(&tessellation.span(), found, "only a surface can be tessellated"));
        }
        let policy = match &keys.normals {
            Some(name) => Some(choose(self.source, name, NORMALS)?),
            None => None,
        };
        match (&keys.mesh, &keys.polygons, &keys.surface) {
            (Some(name), None, None) => self.file(name, policy),
            (None, Some(polygons), None) => {
                let (mesh, colours) = self.polygons(polygons)?;
                Ok(vec![self.own(mesh, colours, policy, None)])
            }
            (None, None, Some(surface)) => self.surface(surface, keys.tessellation.as_ref(), policy),
            _ => {
                let advice = "an object has exactly one of `mesh`, `polygons` and `surface`";
                Err(self.source.error(span, "no shape, or several", advice))
            }
        }
    }

    /// A mesh of the scene's own, which keeps the normals that it has unless they are to be computed.
    fn own(
        &mut self,
        mesh: Mesh,
        colours: Option<Vec<LinearRgb>>,
        policy: Option<When>,
        surface: Option<Primitive>,
    ) -> SceneObject {
        let normals = compute(&mesh, &self.options.recipe)
            .selected(&mesh, self.options.when.or(policy).unwrap_or(When::Missing));
        self.scene.meshes.push(SceneMesh { mesh, normals, colours, source_faces: None });
        let shape = SceneShape::Mesh(self.scene.meshes.len() - 1);
        SceneObject { surface, ..plain(shape) }
    }

    /// The objects of a mesh file, which is read once.
    fn file(&mut self, name: &Spanned<String>, policy: Option<When>) -> Result<Vec<SceneObject>, ReadError> {
        let fault = |error: ReadError| {
            let place = if error.place == Place::File { String::new() } else { format!("{}: ", error.place) };
            let found = format!("{}: {place}{}", name.get_ref(), error.found);
            // A scene has no place to name a format.
            let is_unknown = error.problem == Problem::Syntax && error.advice.contains("--format");
            let advice = match is_unknown {
                true => "give it the ending of its format: .obj, .ply, .stl, .gltf or .glb",
                false => &error.advice,
            };
            ReadError { problem: error.problem, ..self.source.error(&name.span(), &found, advice) }
        };
        let when = self.options.when.or(policy).unwrap_or_default();
        let path = io::companion(self.base, name.get_ref(), &self.options.read).map_err(fault)?;
        let key = (path, when == When::Always);
        if let Some(objects) = self.files.get(&key) {
            return Ok(objects.clone());
        }
        let options = LoadOptions { when: Some(when), from_elsewhere: true, ..self.options.clone() };
        let loaded = io::read(&key.0, None, &options.read).map_err(fault)?;
        let file = SceneFile::from_loaded(loaded, &options).map_err(fault)?;
        let note =
            |note: Note| Note { text: format!("{}: {note}", name.get_ref()), place: Place::File, ..note };
        self.scene.notes.extend(file.notes.into_iter().map(note));
        if file.lights.is_some() || file.camera.is_some() {
            let text = format!("{}: its camera and lights are not those of the scene", name.get_ref());
            self.scene.notes.push(Note::remark(text));
        }
        let first = self.scene.meshes.len();
        self.scene.meshes.extend(file.meshes);
        let shift = |object: SceneObject| match object.shape {
            SceneShape::Mesh(number) => SceneObject { shape: SceneShape::Mesh(first + number), ..object },
            SceneShape::Surface(_) => object,
        };
        let objects: Vec<SceneObject> = file.objects.into_iter().map(shift).collect();
        self.files.insert(key, objects.clone());
        Ok(objects)
    }

    fn polygons(&self, keys: &Spanned<PolygonKeys>) -> Result<(Mesh, Option<Vec<LinearRgb>>), ReadError> {
        let (span, keys) = (keys.span(), keys.get_ref());
        let error = |member: &str, found: &str| {
            self.source.error(&self.source.member(&span, &[member, "colors"]), found, "")
        };
        if keys.faces.is_empty() {
            return Err(error("faces", "there are no faces to draw"));
        }
        let mut faces = Faces::new();
        keys.faces.iter().for_each(|face| faces.push(face));
        let vectors = |list: &[Vector]| list.iter().map(|vector| vector.get()).collect::<Vec<_>>();
        let positions = vectors(&keys.vertices);
        let one_each = |member: &str, count: Option<usize>| match count {
            Some(count) if count != positions.len() => {
                Err(error(member, &format!("{count} {member} for {} vertices", positions.len())))
            }
            _ => Ok(()),
        };
        one_each("normals", keys.normals.as_ref().map(Vec::len))?;
        one_each("colours", keys.colours.as_ref().map(Vec::len))?;
        let mut normals = keys.normals.as_ref().map(|normals| vectors(normals));
        for (vertex, normal) in normals.iter_mut().flatten().enumerate() {
            let unit = UnitVec3::new(*normal);
            *normal = unit.ok_or_else(|| error("normals", &format!("normal {vertex} is {normal}")))?.get();
        }
        let columns = Columns { normals: normals.map(Column::per_vertex), ..Columns::default() };
        let builder = MeshBuilder { positions, faces, columns, ..MeshBuilder::default() };
        let mesh = builder.build().map_err(|fault| error("faces", &fault.to_string()))?;
        let colours = keys.colours.as_ref();
        Ok((mesh, colours.map(|colours| colours.iter().map(|colour| colour.0).collect())))
    }

    fn surface(
        &mut self,
        keys: &Spanned<SurfaceKeys>,
        cut: Option<&Spanned<TessellationKeys>>,
        policy: Option<When>,
    ) -> Result<Vec<SceneObject>, ReadError> {
        let source = self.source;
        let surface =
            surface(*keys.get_ref()).map_err(|error| source.error(&keys.span(), &error.to_string(), ""))?;
        let primitive = match surface {
            Surface::Primitive(primitive) => Some(primitive),
            _ => None,
        };
        match (cut, primitive) {
            (Some(cut), _) => {
                let mesh = surface.tessellate(&tessellation(cut.get_ref()));
                let mesh = mesh.map_err(|error| source.error(&cut.span(), &error.to_string(), ""))?;
                Ok(vec![self.own(mesh, None, policy, primitive)])
            }
            (None, Some(primitive)) => Ok(vec![plain(SceneShape::Surface(primitive))]),
            (None, None) => {
                let found = "no rays can be cast at this surface";
                Err(source.error(&keys.span(), found, "give the object a tessellation, for example { }"))
            }
        }
    }
}

/// The names of what becomes of the normals that a mesh has.
const NORMALS: &[(&str, When)] = &[("given", When::Missing), ("computed", When::Always)];

fn plain(shape: SceneShape) -> SceneObject {
    SceneObject {
        name: String::new(),
        shape,
        transform: DMat4::IDENTITY,
        material: plain_material(),
        given: false,
        surface: None,
    }
}
