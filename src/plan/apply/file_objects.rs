//! The mesh files of a scene, and how the scene declares their normals.

use crate::io::gltf::GltfDocument;
use crate::io::{self, Document as FileDocument, Loaded, NormalFormat, ReadOptions, shell_word};
use crate::plan::document::Document;
use crate::plan::stage::PlanError;
use crate::raster::{LoadOptions, NormalSettings, SceneFile, Shading, StoredFormat};
use std::path::{Path, PathBuf};

/// An object of a glTF file.
pub struct FileObject {
    /// The file as the scene names it.
    pub name: String,
    pub path: PathBuf,
    pub loaded: Loaded,
    /// How the scene computes and stores its normals.
    pub normals: NormalSettings,
    /// Whether stored normals stay.
    pub keeps_normals: bool,
    pub is_flat: bool,
    /// Whether plans leave it unchanged.
    pub is_kept: bool,
}

impl FileObject {
    /// An object of a scene; `None` if it has no mesh file.
    ///
    /// # Errors
    /// Unreadable files, and files of other formats.
    pub fn new(
        document: &Document,
        number: usize,
        base: &Path,
        load: &LoadOptions,
    ) -> Result<Option<Self>, PlanError> {
        let Some(name) = document.mesh(number) else { return Ok(None) };
        let read = read_options(base, load);
        let path = io::companion(base, name, &read)?;
        let loaded = io::read(&path, None, &read)?;
        if !loaded.format.is_gltf() {
            let output = Path::new(name).with_extension("glb");
            let advice =
                format!("crease normals {} -o {}", shell_word(name), shell_word(&output.to_string_lossy()));
            let found = format!("{name} is not a glTF file, but planned meshes are written as glTF");
            return Err(PlanError::Invalid(format!("{found}; convert it with `{advice}`")));
        }
        let scene = SceneFile::from_toml(&document.only(number).to_string(), base, load)?;
        let first = &scene.objects[0];
        let shading = first.settings.shading.unwrap_or(scene.settings.shading);
        Ok(Some(Self {
            name: name.to_owned(),
            path,
            loaded,
            normals: first.normals,
            keeps_normals: first.keeps_normals,
            is_flat: shading == Shading::Flat,
            is_kept: first.is_kept,
        }))
    }

    /// The document of the file.
    pub fn document(&self) -> Option<&GltfDocument> {
        document_of(&self.loaded)
    }

    /// Whether faces may be flat without stored normals.
    pub fn may_omit_normals(&self) -> bool {
        self.document().is_some_and(|document| !document.needs_normals())
    }
}

pub fn document_of(loaded: &Loaded) -> Option<&GltfDocument> {
    if let FileDocument::Gltf(document) = &loaded.document { Some(document) } else { None }
}

/// The options that scenes read their files with: companions may lie anywhere in the scene's folder.
pub fn read_options(base: &Path, load: &LoadOptions) -> ReadOptions {
    let folder = if base.as_os_str().is_empty() { Path::new(".") } else { base };
    let root = load.read.root.clone().unwrap_or_else(|| folder.to_owned());
    ReadOptions { root: Some(root), ..load.read.clone() }
}

/// What determines the normals that a plan of files is compared with.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Reference {
    /// The scene, for each of its objects.
    Scene,
    /// A glTF file by its standard: stored normals stay, and without any its faces are flat.
    File,
    /// A file that was converted from another format: stored normals stay, and without any they are computed.
    Conversion,
}

/// The text of a scene in which each object of a mesh file states how the file stores its normals, so that a plan is compared with what
/// a file holds.
///
/// # Errors
/// Unreadable scenes and files, scenes without mesh files, files that are no glTF, and storages that glTF does not have.
pub fn with_stored_normals(
    text: &str,
    base: &Path,
    load: &LoadOptions,
    reference: Reference,
) -> Result<String, PlanError> {
    // Errors of the text have lines if the reader of scenes finds them.
    SceneFile::from_toml(text, base, load)?;
    let mut document =
        Document::parse(text).map_err(|error| PlanError::Invalid(error.to_string()))?.with_tables();
    let mut is_any = false;
    for number in 0..document.objects() {
        let Some(object) = FileObject::new(&document, number, base, load)? else { continue };
        is_any = true;
        if object.is_kept {
            continue;
        }
        let in_file = object.document().and_then(GltfDocument::normal_format);
        let is_whole = reference != Reference::Scene;
        if is_whole && in_file.is_some() {
            document.set(number, "normals", "given", "");
        } else if reference == Reference::File {
            document.set(number, "shading", "flat", "");
            continue;
        }
        let keeps_normals = object.keeps_normals || is_whole && in_file.is_some();
        let format = match object.normals.format {
            Some(format) if format.in_gltf().is_some() => continue,
            Some(format) => {
                let found = format!("{}: glTF cannot store normals as {}", object.name, format.name());
                return Err(PlanError::Invalid(format!("{found}; choose f32, i16 or i8 in the scene")));
            }
            None => in_file.filter(|_| keeps_normals),
        };
        let format = match format {
            Some(NormalFormat::I8) => StoredFormat::I8,
            Some(NormalFormat::I16) => StoredFormat::I16,
            _ => StoredFormat::F32,
        };
        document.set(number, "normal-format", format.name(), "");
    }
    if !is_any {
        let found = "no object of the scene has a mesh file";
        return Err(PlanError::Invalid(format!("{found}; a plan without --apply changes the scene itself")));
    }
    Ok(document.to_string())
}
