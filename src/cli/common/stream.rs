//! Files, and standard input and output.

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
