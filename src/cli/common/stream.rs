//! Files, and standard input and output.

use crease::io::Format;
use std::path::{Path, PathBuf};

/// A file, or standard input or output.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Stream {
    Standard,
    File(PathBuf),
}

impl Stream {
    /// The stream that a path names: `-` is the standard one.
    pub fn of(path: &Path) -> Self {
        if path.as_os_str() == "-" { Stream::Standard } else { Stream::File(path.to_path_buf()) }
    }

    pub fn path(&self) -> Option<&Path> {
        if let Stream::File(path) = self { Some(path) } else { None }
    }

    /// Its path, or `-`.
    pub fn name(&self) -> String {
        self.path().map_or("-".into(), |path| path.to_string_lossy().into_owned())
    }

    pub fn length(&self) -> Option<u64> {
        self.path()?.metadata().ok().map(|metadata| metadata.len())
    }
}

/// The file, or standard output, and the format that a path and `--to` name together.
pub fn file_target(path: &Path, to: Option<Format>) -> Result<(Stream, Option<Format>), String> {
    let target = Stream::of(path);
    if target == Stream::Standard {
        return Ok((target, to));
    }
    if path.is_dir() {
        return Err(format!("{} is a folder\nhelp: --out-dir writes into a folder", path.display()));
    }
    let named = Format::from_path(path).filter(|format| Format::WRITTEN.contains(format));
    let format = match (named, to) {
        (Some(named), Some(to)) if named != to => {
            return Err(format!("{} has the name of a {named} file, but --to is {to}", path.display()));
        }
        (None, None) => {
            return Err(format!("{}\nhelp: use {ENDINGS}, or choose with --to", unknown_format(path)));
        }
        (named, to) => to.or(named),
    };
    Ok((target, format))
}

/// The endings of mesh files.
const ENDINGS: &str = ".obj, .ply, .stl, .gltf or .glb";

fn unknown_format(path: &Path) -> String {
    match path.extension() {
        Some(ending) => format!("unknown output format \".{}\" ({})", ending.display(), path.display()),
        None => format!("unknown output format ({})", path.display()),
    }
}
