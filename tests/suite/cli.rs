//! The program from outside: arguments, streams, files, exit codes.

mod apply;
mod inspect;
mod options;
mod outputs;
mod plan;
mod report;
mod streams;
mod usage;

use assert_cmd::Command;
use std::ffi::OsStr;
use std::fs;
use std::path::{Path, PathBuf};
use std::process::Output;
use tempfile::TempDir;

/// A file of `data/`.
pub(crate) fn data(name: &str) -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("data").join(name)
}

/// The program, without environment variables that control colour.
pub(crate) fn crease() -> Command {
    let mut command = Command::new(env!("CARGO_BIN_EXE_crease"));
    for name in ["NO_COLOR", "CLICOLOR", "CLICOLOR_FORCE"] {
        command.env_remove(name);
    }
    command
}

/// Runs `crease normals` and returns its output.
pub(crate) fn normals<A: AsRef<OsStr>>(args: impl IntoIterator<Item = A>) -> Output {
    crease().arg("normals").args(args).output().unwrap()
}

/// Runs `crease normals`, which has to succeed.
pub(crate) fn succeed<A: AsRef<OsStr>>(args: impl IntoIterator<Item = A>) -> Output {
    let output = normals(args);
    assert!(output.status.success(), "{}", text(&output.stderr));
    output
}

pub(crate) fn code(output: &Output) -> i32 {
    output.status.code().expect("no signal")
}

pub(crate) fn text(bytes: &[u8]) -> &str {
    std::str::from_utf8(bytes).unwrap()
}

pub(crate) fn path(path: impl AsRef<Path>) -> String {
    path.as_ref().to_str().unwrap().to_owned()
}

/// A folder with some files in it.
pub(crate) fn folder(files: &[(&str, &str)]) -> TempDir {
    let folder = tempfile::tempdir().unwrap();
    for (name, content) in files {
        let path = folder.path().join(name);
        fs::create_dir_all(path.parent().unwrap()).unwrap();
        fs::write(path, content).unwrap();
    }
    folder
}

/// All files below a folder, sorted, relative to it.
pub(crate) fn names(folder: &Path) -> Vec<String> {
    let mut found = Vec::new();
    let mut open = vec![folder.to_path_buf()];
    while let Some(next) = open.pop() {
        for entry in fs::read_dir(next).unwrap() {
            let path = entry.unwrap().path();
            if path.is_dir() {
                open.push(path);
            } else {
                found.push(path.strip_prefix(folder).unwrap().to_str().unwrap().replace('\\', "/"));
            }
        }
    }
    found.sort();
    found
}

pub(crate) const TRIANGLE: &str = "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n";
pub(crate) const BAD: &str = "v 0 0 0\nf 1 2 3\n";
