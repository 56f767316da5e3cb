//! Any text as a scene file in `data/scenes`: it is drawn small, its meshes are written to every format and read back, and with
//! another size of the picture it is the same scene.
#![no_main]

use crease::io::{Format, Part, ReadOptions, WriteOptions, read_bytes, write_new};
use crease::plan::{most_accurate, with_size};
use crease::raster::{LoadOptions, SceneFile, SceneShape, Shading, render};
use crease_fuzz::{Choices, MOST_CORNERS, read_options, start};
use libfuzzer_sys::fuzz_target;
use std::path::Path;

const MOST_OBJECTS: usize = 50;

fn load(text: &str, options: &LoadOptions) -> Option<SceneFile> {
    let data = Path::new(env!("CARGO_MANIFEST_DIR")).join("../data/scenes");
    match SceneFile::from_toml(text, &data, options) {
        Ok(scene) => Some(scene),
        Err(error) => {
            assert!(!error.found.is_empty(), "{error:?}");
            None
        }
    }
}

fuzz_target!(init: start(), |bytes: &[u8]| {
    let Ok(text) = std::str::from_utf8(bytes) else { return };
    let mut choices = Choices::of(bytes);
    let data = Path::new(env!("CARGO_MANIFEST_DIR")).join("../data");
    let read = ReadOptions { root: Some(data), ..read_options(&mut choices) };
    let options = LoadOptions { recipe: choices.recipe(), read, ..LoadOptions::default() };
    let Some(mut scene) = load(text, &options) else { return };
    let corners: usize = scene.meshes.iter().map(|mesh| mesh.mesh.faces().corner_count()).sum();
    if corners > MOST_CORNERS || scene.objects.len() > MOST_OBJECTS {
        return;
    }
    for mesh in &scene.meshes {
        assert!(mesh.normals.normals.values.iter().all(|normal| normal.is_finite()));
    }
    let other = with_size(text, [16, 12]).expect("what was read is TOML");
    let other = load(&other, &options).expect("another size keeps a scene valid");
    // Debug text, in which what is not a number equals itself.
    let described = |scene: &SceneFile| format!("{:?} {:?} {:?}", scene.objects, scene.lights, scene.camera);
    assert_eq!((described(&scene), scene.meshes.len()), (described(&other), other.meshes.len()));
    assert_eq!(other.settings.size, [16, 12]);
    let best = most_accurate(text).expect("what was read is TOML");
    load(&best, &options).expect("the most accurate models keep a scene valid");

    scene.settings.size = [16, 12];
    scene.settings.keep_linear = true;
    scene.settings.tracing.depth = scene.settings.tracing.depth.min(3);
    scene.settings.tracing.shadow_samples = scene.settings.tracing.shadow_samples.min(4);
    for shading in [scene.settings.shading, choices.one(&[Shading::Flat, Shading::Gouraud, Shading::Traced])] {
        scene.settings.shading = shading;
        if let Ok(image) = render(&scene.scene(), &scene.settings) {
            assert!(image.linear.iter().flatten().flatten().all(|value| value.is_finite()));
        }
    }
    for object in &scene.objects {
        let SceneShape::Mesh(number) = object.shape else { continue };
        let mesh = scene.meshes[number].mesh.clone();
        let faces = mesh.face_count();
        let part = Part { name: object.name.clone(), mesh, ..Part::default() };
        for format in Format::WRITTEN {
            let Ok(written) = write_new(std::slice::from_ref(&part), format, &WriteOptions::default()) else { continue };
            let again = read_bytes(written.bytes, Some(format), None, &ReadOptions::default());
            let again = again.unwrap_or_else(|error| panic!("{format}: {error}"));
            let found: usize = again.parts.iter().map(|part| part.mesh.face_count()).sum();
            assert!(found >= faces, "{format}: {found} of {faces} faces");
        }
    }
});
