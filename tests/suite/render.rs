//! The verb `render` from outside.

mod backgrounds;
mod files;
mod gallery;
mod golden;
mod hostile;
mod notes;
mod options;
mod probe;
mod scenes;
mod tracing;
mod unused;
mod usage;

use crate::cli::{crease, path, text};
use image::RgbImage;
use std::ffi::OsStr;
use std::path::Path;
use std::process::Output;

/// Runs `crease render` and returns its output.
fn render<A: AsRef<OsStr>>(args: impl IntoIterator<Item = A>) -> Output {
    crease().arg("render").args(args).output().unwrap()
}

/// The bytes of a PNG or GIF file that `crease render` writes to standard output.
fn bytes(args: &[impl AsRef<str>]) -> Vec<u8> {
    let args = with(args, &["-o", "-", "-q"]);
    let output = render(&args);
    assert!(output.status.success(), "{args:?}: {}", text(&output.stderr));
    output.stdout
}

/// Its picture.
fn picture(args: &[impl AsRef<str>]) -> RgbImage {
    image::load_from_memory(&bytes(args)).unwrap().into_rgb8()
}

/// Its JSON report.
fn report(args: &[impl AsRef<str>]) -> serde_json::Value {
    let args = with(args, &["--json"]);
    let output = render(&args);
    serde_json::from_slice(&output.stdout).unwrap_or_else(|_| panic!("{args:?}: {}", text(&output.stderr)))
}

/// The gear of `data/`, small.
fn gear() -> [String; 3] {
    [path(crate::cli::data("gear.obj")), "--size".into(), "96x72".into()]
}

/// A square that faces the viewer, with a camera in front of it: white, red, green and blue at its corners.
const SQUARE: &str = "\
v -1 -1 0 1 1 1\nv 1 -1 0 1 0 0\nv 1 1 0 0 1 0\nv -1 1 0 0 0 1\nf 1 2 3 4\n";
const BEFORE: [&str; 4] = ["--camera", "eye=0,0,5 target=0,0,0 height=2", "--size", "40x40"];

/// A folder with the square in it, and the square's path.
fn square() -> (tempfile::TempDir, String) {
    let folder = crate::cli::folder(&[("square.obj", SQUARE)]);
    let file = path(folder.path().join("square.obj"));
    (folder, file)
}

/// Two lists of arguments as one.
fn with(some: &[impl AsRef<str>], more: &[impl AsRef<str>]) -> Vec<String> {
    let more = more.iter().map(AsRef::as_ref);
    some.iter().map(AsRef::as_ref).chain(more).map(str::to_owned).collect()
}

/// How many pixels of a picture are not of this colour.
fn pixels_unlike(picture: &RgbImage, colour: [u8; 3]) -> u64 {
    picture.pixels().filter(|pixel| pixel.0 != colour).count() as u64
}

fn exists(folder: &Path, name: &str) -> bool {
    folder.join(name).exists()
}
