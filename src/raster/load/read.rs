//! Scenes from files.

use crate::io::{self, Format, Limits, Place, Problem, ReadError};
use crate::raster::load::scene_file::{LoadOptions, SceneFile};
use std::path::Path;

/// Reads a scene, or a mesh as a scene: framed by itself, with a light of its own, in a plain material.
///
/// A name that ends in `.toml` is a scene file, unless a format is given; without one, any other file's content and name
/// tell what it is. A glTF file is a scene too: nodes, the first camera, punctual lights, base colours.
///
/// ```no_run
/// use crease::raster::{LoadOptions, load, render};
///
/// let mut file = load("bunny.obj".as_ref(), None, &LoadOptions::default())?;
/// file.settings.size = [1920, 1080];
/// let image = render(&file.scene(), &file.settings)?;
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
///
/// # Scene files
/// A scene in TOML; `docs/scenes.md` of the repository describes every key, `data/scenes` has annotated examples. Only objects are
/// needed: `[[object]]` and one of `mesh`, `polygons`, `surface`. Without a camera all is framed by itself, without a light it is
/// lit by [`default_lights`](crate::raster::default_lights). Angles are in degrees; faces and vertices are counted from 0.
///
/// # Errors
/// What [`io::read`] says, and files without any face. In scene files, with the line and the key: unknown keys, values of
/// the wrong type or out of range, and what is wrong with meshes that they name. Nothing is silently ignored.
pub fn load(path: &Path, format: Option<Format>, options: &LoadOptions) -> Result<SceneFile, ReadError> {
    let is_scene = path.extension().is_some_and(|extension| extension.eq_ignore_ascii_case("toml"));
    if format.is_some() || !is_scene {
        return SceneFile::from_loaded(io::read(path, format, &options.read)?, options);
    }
    let limits =
        Limits { bytes: options.read.limits.bytes.min(LARGEST_SCENE), ..options.read.limits.clone() };
    let bytes = io::read_whole(path, &limits)?;
    let text = String::from_utf8(bytes).map_err(|error| {
        let before = &error.as_bytes()[..error.utf8_error().valid_up_to()];
        let place = Place::Line(1 + before.iter().filter(|&&byte| byte == b'\n').count() as u64);
        ReadError::new(Problem::Syntax, place, "the text is not UTF-8", "save it as UTF-8")
    })?;
    SceneFile::from_toml(&text, path.parent().unwrap_or(path), options)
}

/// Most bytes of a scene file, whose text takes many times that in memory when it is understood. Large meshes have
/// files of their own.
const LARGEST_SCENE: u64 = 64 << 20;

#[cfg(test)]
mod tests {
    use super::*;
    use crate::io::{ReadOptions, read_bytes};
    use crate::raster::frame::render::render;
    use crate::raster::settings::RenderSettings;

    fn scene(text: &str) -> SceneFile {
        let loaded = read_bytes(text.as_bytes().to_vec(), Some(Format::Obj), None, &ReadOptions::default());
        SceneFile::from_loaded(loaded.unwrap(), &LoadOptions::default()).unwrap()
    }

    /// The same tetrahedron at any size and place gives the same picture, but for roundings of its rim; vertices that
    /// nothing uses do not count.
    #[test]
    fn a_bare_mesh_frames_itself() {
        let draw = |scale: f64, offset: f64| {
            let at = |x: f64, y: f64, z: f64| {
                format!("v {:e} {:e} {:e}\n", x * scale + offset, y * scale + offset, z * scale + offset)
            };
            let vertices =
                [at(0.0, 0.0, 0.0), at(1.0, 0.0, 0.0), at(0.0, 1.0, 0.0), at(0.0, 0.0, 1.0)].concat();
            let unused = at(1e6, 0.0, 0.0);
            let mut file = scene(&format!("{vertices}{unused}f 1 3 2\nf 1 2 4\nf 1 4 3\nf 2 3 4\n"));
            file.settings = RenderSettings { size: [64, 48], ..file.settings };
            render(&file.scene(), &file.settings).unwrap().statistics.covered_pixels
        };
        let expected = draw(1.0, 0.0);
        assert!(expected > 300, "{expected} of 3072 pixels");
        for (scale, offset) in [(1e-30, 0.0), (1e30, 0.0), (1.0, 1e7), (1e-6, -1.0)] {
            let covered = draw(scale, offset);
            assert!(covered.abs_diff(expected) <= 2, "{scale:e} {offset:e}: {covered}, not {expected}");
        }
    }

    #[test]
    fn without_faces_there_is_nothing_to_draw() {
        let loaded = read_bytes(b"v 0 0 0\n".to_vec(), None, None, &ReadOptions::default()).unwrap();
        let error = SceneFile::from_loaded(loaded, &LoadOptions::default()).unwrap_err();
        assert!(error.to_string().starts_with("there are no faces"), "{error}");
    }
}
