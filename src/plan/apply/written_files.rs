//! The mesh files of a plan, and the scene that shows them.

use super::file_objects::{FileObject, document_of, read_options};
use crate::io::{
    self, Emit, Format, Loaded, OutputContent, Part, PartEdit, TangentPolicy, WriteOptions, Written,
};
use crate::mesh::Column;
use crate::normals::{Scope, When};
use crate::pipeline::{Task, revise};
use crate::plan::axes::Axis;
use crate::plan::decisions::Plan;
use crate::plan::document::Document;
use crate::plan::stage::PlanError;
use crate::raster::{LoadOptions, NormalSettings};
use glam::DVec3;
use std::path::{Path, PathBuf};

/// Where a mesh file goes.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Home {
    /// The file; its ending determines how glTF is spelled.
    pub path: PathBuf,
    /// Its name in the scene.
    pub mesh: String,
}

/// What a file takes.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, serde::Serialize)]
pub struct FileSize {
    /// Bytes of the file and of the buffers that are files of their own.
    pub file_bytes: u64,
    /// Bytes of the attributes of vertices, which begin at multiples of four.
    pub vertex_bytes: u64,
    /// Bytes of indices.
    pub index_bytes: u64,
    /// Vertices of all meshes.
    pub vertices: u64,
}

/// A mesh file as planned, ready to be stored.
#[derive(Clone, Debug)]
pub struct AppliedFile {
    /// The file that it is made from.
    pub input: PathBuf,
    /// Files that the input refers to.
    pub companions: Vec<PathBuf>,
    /// Where it goes.
    pub home: Home,
    /// What the input takes.
    pub before: FileSize,
    /// What it takes itself.
    pub after: FileSize,
    /// Its bytes.
    pub written: Written,
}

/// The mesh files of a plan.
#[derive(Clone, Debug)]
pub struct Applied {
    /// The planned scene, whose objects show the files.
    pub text: String,
    /// The files.
    pub files: Vec<AppliedFile>,
}

/// Writes the mesh files of a plan that was made [for files](crate::plan::PlanOptions::for_files), each of them once for all objects
/// that show it the same way. `home` is asked once for each output.
///
/// Normals are replaced or omitted, vertices that agree in everything are merged, and bytes that nothing uses are removed.
/// Everything else stays. The pictures of the scene in the result are those of the plan, to the bit.
///
/// # Errors
/// Unreadable files, and files whose extensions forbid to split vertices.
pub fn apply(
    plan: &Plan,
    base: &Path,
    load: &LoadOptions,
    home: &mut dyn FnMut(&Path) -> Home,
) -> Result<Applied, PlanError> {
    let mut document =
        Document::parse(&plan.text).map_err(|error| PlanError::Invalid(error.to_string()))?.with_tables();
    let mut files: Vec<(PathBuf, FileModel, AppliedFile)> = Vec::new();
    for number in 0..document.objects() {
        let Some(object) = FileObject::new(&document, number, base, load)? else { continue };
        let model = FileModel::of(&object);
        let known = files.iter().position(|(path, other, _)| (path, other) == (&object.path, &model));
        let at = match known {
            Some(at) => at,
            None => {
                let file = applied_file(&object, &model, home(&object.path), base, load)?;
                files.push((object.path, model, file));
                files.len() - 1
            }
        };
        let mesh = &files[at].2.home.mesh;
        document.set(number, "mesh", mesh.as_str(), &reasons(plan, number));
        model.declare(&mut document, number);
    }
    Ok(Applied { text: document.to_string(), files: files.into_iter().map(|(.., file)| file).collect() })
}

/// The changes of an object in one line.
fn reasons(plan: &Plan, number: usize) -> String {
    let decisions = plan.decisions.iter().filter(|it| it.number == number && it.axis != Axis::Lights);
    let changes: Vec<String> =
        decisions.map(|it| format!("{} {} to {}", it.axis.name(), it.from, it.to)).collect();
    if changes.is_empty() { String::new() } else { format!("plan: {}", changes.join(", ")) }
}

/// How a file is written.
#[derive(Clone, Copy, Debug, PartialEq)]
enum FileModel {
    /// All but the spelling of glTF stays.
    Unchanged,
    /// Without normals.
    Flat,
    /// With the stored normals, which no picture shows: other attributes need them.
    AsStored,
    /// With normals by these settings; whether stored ones stay.
    Normals(NormalSettings, bool),
}

impl FileModel {
    fn of(object: &FileObject) -> Self {
        match object {
            _ if object.is_kept => Self::Unchanged,
            _ if object.is_flat && object.may_omit_normals() => Self::Flat,
            _ if object.is_flat => Self::AsStored,
            _ => Self::Normals(object.normals, object.keeps_normals),
        }
    }

    /// Makes the keys of an object those of the file that it shows.
    fn declare(&self, document: &mut Document, number: usize) {
        if *self == Self::Unchanged {
            return;
        }
        for key in ["normals", "weight", "crease", "precision", "normal-format"] {
            document.remove(number, key);
        }
        if matches!(self, Self::Normals(..)) {
            document.set(number, "normals", "given", "");
        }
    }

    /// The edits of the parts of a file, and how they are written.
    fn edits(&self, loaded: &Loaded, load: &LoadOptions) -> (Vec<PartEdit>, WriteOptions) {
        let as_stored = |part: &Part| {
            let normals = part.mesh.columns().normals.clone();
            let kept = normals.as_ref().map_or(0, |normals| normals.values.len());
            PartEdit { normals, kept, ..PartEdit::default() }
        };
        let options =
            WriteOptions { tangents: TangentPolicy::Keep, compact: true, ..WriteOptions::default() };
        match *self {
            Self::Unchanged => (Vec::new(), WriteOptions::default()),
            Self::AsStored => (loaded.parts.iter().map(as_stored).collect(), options),
            Self::Flat => {
                // They mark the part as changed; none of them is written.
                let any = |part: &Part| {
                    let normals = Column::per_vertex(vec![DVec3::Z; part.mesh.vertex_count()]);
                    PartEdit { normals: Some(normals), ..PartEdit::default() }
                };
                (loaded.parts.iter().map(any).collect(), WriteOptions { omit_normals: true, ..options })
            }
            Self::Normals(normals, keeps_normals) => {
                let recipe = normals.recipe(&load.recipe);
                let emit = if recipe.scope == Scope::Vertex { Emit::Vertex } else { Emit::Corner };
                let when = if keeps_normals { When::Missing } else { When::Always };
                let task = Task { recipe, emit, when, ..Task::default() };
                let mut edits = revise(loaded, &task, Some(Format::Glb), &|_| {}).edits;
                for (edit, part) in
                    edits.iter_mut().zip(&loaded.parts).filter(|(edit, _)| edit.normals.is_none())
                {
                    // Nothing is missing, but another storage is written.
                    *edit = as_stored(part);
                }
                let tangents = if keeps_normals { TangentPolicy::Keep } else { TangentPolicy::Auto };
                let normal_format = normals.format.and_then(|format| format.in_gltf()).unwrap_or_default();
                (edits, WriteOptions { emit, tangents, normal_format, ..options })
            }
        }
    }
}

fn applied_file(
    object: &FileObject,
    model: &FileModel,
    home: Home,
    base: &Path,
    load: &LoadOptions,
) -> Result<AppliedFile, PlanError> {
    let failed = |error| PlanError::Write { name: object.name.clone(), error };
    let (edits, options) = model.edits(&object.loaded, load);
    let stem = home.path.file_stem().map(|stem| stem.to_string_lossy().into_owned());
    let options = WriteOptions { stem, folder: home.path.parent().map(Path::to_owned), ..options };
    let mut written = io::write(&object.loaded, edits, Format::Glb, &options).map_err(failed)?;
    // What is stored can be read.
    let folder = object.path.parent().unwrap_or(base);
    let read =
        io::read_bytes(written.bytes.clone(), Some(Format::Glb), Some(folder), &read_options(base, load))?;
    let mut after = size_of(&read);
    if Format::from_path(&home.path) == Some(Format::Gltf) {
        let notes = std::mem::take(&mut written.notes);
        let options = WriteOptions { compact: false, omit_normals: false, ..options };
        written = io::write(&read, Vec::new(), Format::Gltf, &options).map_err(failed)?;
        written.notes.splice(0..0, notes);
        let lengths = written.companions.iter().map(|file| match &file.content {
            OutputContent::Bytes(bytes) => bytes.len() as u64,
            OutputContent::CopyOf(_) => 0,
        });
        after.file_bytes = written.bytes.len() as u64 + lengths.sum::<u64>();
    }
    let companions = object.document().into_iter().flat_map(|document| document.companions());
    Ok(AppliedFile {
        input: object.path.clone(),
        companions: companions.map(Path::to_owned).collect(),
        before: size_of(&object.loaded),
        after,
        written,
        home,
    })
}

fn size_of(loaded: &Loaded) -> FileSize {
    let Some(document) = document_of(loaded) else { return FileSize::default() };
    let geometry = document.geometry_bytes();
    FileSize {
        file_bytes: document.file_bytes(),
        vertex_bytes: geometry.vertices,
        index_bytes: geometry.indices,
        vertices: loaded.parts.iter().map(|part| part.mesh.vertex_count() as u64).sum(),
    }
}
