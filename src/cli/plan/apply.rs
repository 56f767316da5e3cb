//! `crease plan --apply`: mesh files as planned.

use super::args::{self as options, PlanArgs};
use super::report::FileReport;
use crate::cli::common::console::HELP;
use crate::cli::common::failure::Failure;
use crate::cli::common::output::{Store, Target, folder_of, is_same_file};
use crate::cli::common::output_conflicts::Files;
use crease::io::{self, Format, Loaded, OutputContent, ReadOptions, WriteOptions};
use crease::normals::When;
use crease::pipeline::{Task, revise};
use crease::plan::{
    AXES_OF_FILES, AppliedFile, Axis, Home, Plan, PlanError, Reference, apply, with_stored_normals,
};
use crease::raster::LoadOptions;
use std::collections::BTreeSet;
use std::path::{Component, Path, PathBuf, absolute};
use tempfile::TempDir;

/// What is planned: the input, or the glTF file that it is converted to.
pub struct Source {
    pub path: PathBuf,
    /// Exists as long as the conversion is read.
    folder: Option<TempDir>,
}

/// Why a command line cannot be carried out.
pub fn refusal(args: &PlanArgs) -> Option<String> {
    let target = args.apply.as_deref()?;
    let name = target.display();
    if let Some(axis) = args.only.iter().find(|axis| !AXES_OF_FILES.contains(axis)) {
        let held: Vec<&str> = AXES_OF_FILES.iter().map(|axis| axis.name()).collect();
        let advice = match axis {
            Axis::Shading => "flat shading is a value of `storage`",
            _ => "plan the scene without --apply",
        };
        let found = format!("--apply changes {}, not {}", held.join(", "), axis.name());
        return Some(format!("{found}{HELP}{advice}"));
    }
    let of_scenes = [
        ("--allow", args.allow.is_some()),
        ("--reference accurate", args.reference == options::Reference::Accurate),
    ];
    if let Some((option, _)) = of_scenes.into_iter().find(|(_, is_given)| *is_given) {
        return Some(format!("{option} cannot be used with --apply{HELP}plan the scene without --apply"));
    }
    if target.as_os_str() == "-" {
        return Some(format!("--apply cannot write to standard output{HELP}name a file"));
    }
    if is_scene(args.scene()) {
        let advice = "for a scene, all mesh files are written into a folder";
        let is_file =
            target.is_file() || target.extension().is_some_and(|_| Format::from_path(target).is_some());
        if is_file {
            return Some(format!("--apply {name} is a file{HELP}name a folder; {advice}"));
        }
        let overwrites = scene_output(args).is_some_and(|output| is_same_file(args.scene(), &output));
        return overwrites.then(|| format!("{name} is the folder of the input{HELP}name another folder"));
    }
    if target.is_dir() {
        return Some(format!("--apply {name} is a folder{HELP}name a .glb or .gltf file"));
    }
    if !Format::from_path(target).is_some_and(Format::is_gltf) {
        return Some(format!("--apply writes glTF, not {name}{HELP}name a .glb or .gltf file"));
    }
    let output = args.output.as_deref()?;
    mesh_name(output, target).is_none().then(|| not_below(target))
}

/// Where the planned scene goes; `None` if it is not written. With a folder for meshes it has the name of the input there.
pub fn scene_output(args: &PlanArgs) -> Option<PathBuf> {
    let folder = args.apply.as_deref().filter(|_| is_scene(args.scene()));
    let in_folder = || Some(folder?.join(args.scene().file_name()?));
    args.output.clone().or_else(in_folder)
}

fn not_below(file: &Path) -> String {
    let advice = "write the meshes into the folder of the scene or below it";
    format!("the planned scene cannot refer to {}{HELP}{advice}", file.display())
}

fn is_scene(path: &Path) -> bool {
    path.extension().is_some_and(|ending| ending.eq_ignore_ascii_case("toml"))
}

/// The name of a mesh file in a scene, which is in the same folder or above it.
pub fn mesh_name(scene: &Path, file: &Path) -> Option<String> {
    let folder = if scene.as_os_str() == "-" { PathBuf::from(".") } else { folder_of(scene) };
    let (folder, file) = (absolute(folder).ok()?, absolute(file).ok()?);
    let inner = file.strip_prefix(folder.components().collect::<PathBuf>()).ok()?;
    let is_below = inner.components().all(|part| matches!(part, Component::Normal(_)));
    is_below.then(|| inner.to_string_lossy().replace('\\', "/"))
}

impl Source {
    /// The input itself, but a mesh of another format than glTF as `crease normals --when missing` converts it. Where it has neither
    /// normals of vertices nor smoothing groups, it is converted without normals, so that a plan chooses how they are computed.
    pub fn new(args: &PlanArgs) -> Result<Self, Failure> {
        let path = args.scene().to_owned();
        if args.apply.is_none() || is_scene(&path) {
            return Ok(Self { path, folder: None });
        }
        let loaded = io::read(&path, None, &ReadOptions::default())?;
        if loaded.format.is_gltf() {
            return Ok(Self { path, folder: None });
        }
        let could_not = |error: std::io::Error| Failure::output(format!("no temporary folder: {error}"));
        let folder = tempfile::tempdir().map_err(could_not)?;
        let stem = path.file_stem().unwrap_or_default();
        let converted = folder.path().join(stem).with_extension("glb");
        std::fs::write(&converted, as_glb(loaded)?).map_err(could_not)?;
        Ok(Self { path: converted, folder: Some(folder) })
    }

    /// The folder that the scene refers from.
    pub fn base(&self) -> &Path {
        self.path.parent().unwrap_or(Path::new(""))
    }
}

fn as_glb(mut loaded: Loaded) -> Result<Vec<u8>, Failure> {
    let columns = || loaded.parts.iter().map(|part| part.mesh.columns());
    let has_normals = loaded.format != Format::Stl
        && columns().any(|columns| columns.normals.is_some() || columns.smoothing.is_some());
    let edits = match has_normals {
        true => {
            let task = Task { when: When::Missing, ..Task::default() };
            revise(&loaded, &task, Some(Format::Glb), &|_| {}).edits
        }
        false => {
            for part in &mut loaded.parts {
                part.mesh = std::mem::take(&mut part.mesh).with_normals(None);
            }
            Vec::new()
        }
    };
    let written = io::write(&loaded, edits, Format::Glb, &WriteOptions::default());
    Ok(written.map_err(Failure::output)?.bytes)
}

/// The text of a scene in which mesh files declare how they store normals, if they are to be written.
pub fn declared(args: &PlanArgs, source: &Source, text: String) -> Result<String, Failure> {
    if args.apply.is_none() {
        return Ok(text);
    }
    let reference = match source.folder {
        Some(_) => Reference::Conversion,
        None if is_scene(args.scene()) => Reference::Scene,
        None => Reference::File,
    };
    with_stored_normals(&text, source.base(), &LoadOptions::default(), reference).map_err(|error| match error
    {
        PlanError::Read(error) => error.into(),
        error => Failure::usage(error.to_string().replacen("; ", HELP, 1)),
    })
}

/// Stores the mesh files of a plan, whose scene then shows them.
pub fn store(args: &PlanArgs, source: &Source, plan: &mut Plan) -> Result<Vec<FileReport>, Failure> {
    let Some(target) = &args.apply else { return Ok(Vec::new()) };
    let is_folder = is_scene(args.scene());
    let scene = scene_output(args).unwrap_or_else(|| target.clone());
    let mut taken = BTreeSet::new();
    let mut home = |input: &Path| {
        let path = if is_folder { free_path(target, input, &mut taken) } else { target.clone() };
        Home { mesh: mesh_name(&scene, &path).unwrap_or_default(), path }
    };
    let applied = apply(plan, source.base(), &LoadOptions::default(), &mut home);
    let applied = applied.map_err(|error| match error {
        PlanError::Read(error) => error.into(),
        error => Failure::output(error),
    })?;
    if is_folder && applied.files.iter().any(|file| file.home.mesh.is_empty()) {
        return Err(Failure::usage(not_below(target)));
    }
    check_inputs(args.scene(), &applied.files)?;
    let store = Store::default();
    let mut reports = Vec::new();
    for file in applied.files {
        let mut notes = file.written.notes.clone();
        notes.extend(store.store(file.written, &Target::File(file.home.path.clone()))?.notes);
        let mut report = FileReport {
            input: file.input.display().to_string(),
            output: file.home.path.display().to_string(),
            before: file.before,
            after: file.after,
            notes,
        };
        if source.folder.is_some() {
            // Of the input, not of its conversion.
            report.input = args.scene().display().to_string();
            report.before.file_bytes = args.scene().metadata().map_or(0, |metadata| metadata.len());
        } else if !is_folder {
            report.input = args.scene().display().to_string();
        }
        reports.push(report);
    }
    plan.text = applied.text;
    Ok(reports)
}

/// The name of a file in a folder, as a GLB; with a number if another file of this run has it.
fn free_path(folder: &Path, input: &Path, taken: &mut BTreeSet<PathBuf>) -> PathBuf {
    let stem = input.file_stem().unwrap_or_default().to_string_lossy().into_owned();
    let numbered = (2_u32..).map(|number| format!("{stem}-{number}.glb"));
    let names = std::iter::once(format!("{stem}.glb")).chain(numbered).map(|name| folder.join(name));
    let free = names.into_iter().find(|path| taken.insert(path.clone()));
    free.unwrap_or_else(|| folder.join(stem))
}

/// No output may be an input, or a file that an input refers to.
fn check_inputs(scene: &Path, files: &[AppliedFile]) -> Result<(), Failure> {
    let of_files = files.iter().flat_map(|file| file.companions.iter().chain([&file.input]));
    let inputs = Files::read(of_files.map(PathBuf::as_path).chain([scene]));
    for file in files {
        let folder = folder_of(&file.home.path);
        let new = file.written.companions.iter().filter(|it| matches!(it.content, OutputContent::Bytes(_)));
        let outputs = new.map(|companion| folder.join(&companion.name)).chain([file.home.path.clone()]);
        for output in outputs {
            inputs.check(&output).map_err(Failure::usage)?;
        }
    }
    Ok(())
}
