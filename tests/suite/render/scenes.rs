//! Scenes that bring their camera, lights and settings, and options that override them.

use super::{bytes, picture, pixels_unlike, report, with};
use crate::cli::{folder, path};

/// A coarse mesh of a sphere, and all settings that options can override.
fn scene(settings: &str) -> String {
    format!(
        "[settings]\n{settings}\n
[camera]\neye = [0, 0, 6]\ntarget = [0, 0, 0]\nangle = 25\n
[[light.ambient]]\ncolour = 0.2\n[[light.point]]\nposition = [2, 2, 3]\ncolour = 1\n
[[object]]\nsurface = {{ sphere = {{ radius = 1 }} }}
tessellation = {{ pattern = \"quads\", segments = [10, 6] }}
material = {{ colour = [0.2, 0.4, 0.9], exponent = 20 }}\n"
    )
}

/// A scene with the first setting and the option, and one with the second setting, give the same picture, and another
/// one than the first setting alone.
const OVERRIDES: &[(&str, &[&str], &str)] = &[
    ("size = [48, 36]", &["--size", "60x40"], "size = [60, 40]"),
    ("samples = 1", &["--samples", "8"], "samples = 8"),
    ("bits = 8", &["--bits", "16"], "bits = 16"),
    ("shading = \"flat\"", &["--shading", "phong"], "shading = \"phong\""),
    ("shading = \"flat\"", &["--shading", "exact"], "shading = \"exact\""),
    ("reflection = \"blinn\"", &["--reflection", "phong"], "reflection = \"phong\""),
    (
        "tone = \"clamp\"\nbackground = [2, 1, 0]",
        &["--tone", "max"],
        "tone = \"max\"\nbackground = [2, 1, 0]",
    ),
    ("transfer = \"direct\"", &["--transfer", "srgb"], "transfer = \"srgb\""),
    ("background = 0.5", &["--background", "#102030"], "background = \"#102030\""),
    ("cull = \"front\"", &["--cull", "back"], "cull = \"back\""),
    (
        "literal = true\nshading = \"phong\"",
        &["--guard", "renormalise=on"],
        "literal = true\nguards.renormalise = true",
    ),
    ("guards.renormalise = true", &["--literal"], "literal = true"),
];

#[test]
fn options_override_what_the_scene_says() {
    for (before, option, after) in OVERRIDES {
        let folder = folder(&[("before.toml", &scene(before)), ("after.toml", &scene(after))]);
        let [first, second] = ["before.toml", "after.toml"].map(|name| path(folder.path().join(name)));
        let overridden = bytes(&with(&[first.as_str()], option));
        assert!(overridden == bytes(&[second.as_str()]), "{option:?} is not {after}");
        assert!(overridden != bytes(&[first.as_str()]), "{option:?} changes nothing");
    }
}

/// Cameras and lights are changed in part, or replaced.
#[test]
fn cameras_lights_and_materials_of_a_scene_can_be_changed() {
    let folder = folder(&[("ball.toml", &scene("size = [48, 48]"))]);
    let ball = path(folder.path().join("ball.toml"));
    let plain = report(&[ball.as_str()]);
    let camera = |report: &serde_json::Value, key: &str| report["scene"]["camera"][key].clone();
    let moved = report(&[ball.as_str(), "--camera", "eye=0,3,6"]);
    assert_eq!(camera(&moved, "eye"), serde_json::json!([0.0, 3.0, 6.0]));
    assert_eq!(camera(&moved, "target"), camera(&plain, "target"));
    assert_eq!(camera(&moved, "angle"), camera(&plain, "angle"));
    assert_eq!(plain["scene"]["lights"], serde_json::json!(["ambient", "point"]));
    let lit = report(&[ball.as_str(), "--light", "directional towards=0,0,1"]);
    assert_eq!(lit["scene"]["lights"], serde_json::json!(["ambient", "directional"]));
    let red = picture(&[ball.as_str(), "--material", "colour=1,0,0 ks=0"]);
    assert!(red.pixels().all(|pixel| pixel.0[1] == 0 && pixel.0[2] == 0));
    assert!(pixels_unlike(&red, [0; 3]) > 500);
    assert_eq!(plain["settings"]["samples"], 1, "a scene is drawn as it says");
    assert_eq!(plain["settings"]["bits"], 8);
}

/// The exact surface of the lectures next to the approximations of it.
#[test]
fn panels_compare_shading_with_the_exact_surface() {
    let folder = folder(&[("ball.toml", &scene("size = [64, 64]"))]);
    let ball = path(folder.path().join("ball.toml"));
    let report = report(&[ball.as_str(), "--compare", "flat,gouraud,phong,exact"]);
    let covered: Vec<u64> =
        (0..4).map(|panel| report["drawings"][panel]["covered_pixels"].as_u64().unwrap()).collect();
    assert!(covered[0] == covered[1] && covered[1] == covered[2], "one coverage: {covered:?}");
    assert!(covered[3] > covered[0], "the sphere is larger than the mesh within: {covered:?}");
}

/// Files outside the scene's folder are read if `--root` allows it.
#[test]
fn meshes_elsewhere_need_a_root() {
    let text = "[settings]\nsize = [40, 40]\n[[object]]\nmesh = \"../square.obj\"\n";
    let folder = folder(&[("scenes/a.toml", text), ("square.obj", super::SQUARE)]);
    let scene = path(folder.path().join("scenes/a.toml"));
    let refused = report(&[scene.as_str()]);
    assert!(refused["error"]["message"].as_str().unwrap().contains("--root"), "{refused}");
    assert_eq!(report(&[scene.as_str(), "--root", &path(folder.path())])["scene"]["faces"], 1);
}

/// A scene's meshes come from its folder.
#[test]
fn meshes_of_a_scene_lie_next_to_it() {
    let text = "[settings]\nsize = [40, 40]\n[[object]]\nmesh = \"parts/square.obj\"\n";
    let folder = folder(&[("a.toml", text), ("parts/square.obj", super::SQUARE)]);
    let scene = path(folder.path().join("a.toml"));
    assert_eq!(report(&[scene.as_str()])["scene"]["faces"], 1);
    let mesh = path(folder.path().join("parts/square.obj"));
    let drawn = [mesh.as_str(), "--size", "40x40", "--samples", "1", "--background", "black"];
    assert!(bytes(&[scene.as_str()]) == bytes(&drawn), "a bare mesh is the plainest scene");
}
