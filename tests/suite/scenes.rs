//! Scenes from files: those of `data/scenes`, the lectures' worked numbers through their scenes, glTF files as scenes,
//! scenes that make no sense, and the real meshes framed by themselves.

mod bad;
mod gltf;
mod lectures;
mod object_settings;
mod pictures;
mod program;
mod real;

use crease::raster::{LoadOptions, SceneFile, load};
use std::fs;
use std::path::{Path, PathBuf};

fn folder() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("data/scenes")
}

/// A scene of `data/scenes`.
fn scene(name: &str) -> SceneFile {
    let path = folder().join(name);
    load(&path, None, &LoadOptions::default()).unwrap_or_else(|error| panic!("{name}: {error}"))
}

/// A scene from text, which refers to no file.
fn from_text(text: &str) -> SceneFile {
    SceneFile::from_toml(text, Path::new(""), &LoadOptions::default())
        .unwrap_or_else(|error| panic!("{error}"))
}

/// The names of all scenes of `data/scenes`.
fn names() -> Vec<String> {
    let mut names = Vec::new();
    for folder in ["", "lectures/"] {
        for entry in fs::read_dir(self::folder().join(folder)).unwrap() {
            let entry = entry.unwrap();
            if entry.file_type().unwrap().is_file() {
                names.push(format!("{folder}{}", entry.file_name().into_string().unwrap()));
            }
        }
    }
    names.sort();
    names
}
