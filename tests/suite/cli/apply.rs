//! `crease plan --apply`: files, reports, and command lines that are refused.

use super::{TRIANGLE, code, crease, data, folder, names, path, text};
use std::fs;
use std::process::Output;
use tempfile::TempDir;

fn plan(args: &[&str]) -> Output {
    crease().arg("plan").args(args).output().unwrap()
}

/// A folder with a GLB of the gear, a scene that shows it, and a scene without mesh files.
fn gear() -> TempDir {
    let scene = "[settings]\nsize = [24, 20]\n[[object]]\nname = \"gear\"\nmesh = \"gear.glb\"\nnormals = \"given\"\n";
    let ball = "[settings]\nsize = [8, 8]\n[[object]]\nsurface = { sphere = { radius = 1 } }\n";
    let folder = folder(&[("scene.toml", scene), ("ball.toml", ball), ("triangle.obj", TRIANGLE)]);
    let gear = path(folder.path().join("gear.glb"));
    let made = crease().args(["normals", &path(data("gear.obj")), "-o", &gear, "-q"]).output().unwrap();
    assert!(made.status.success(), "{}", text(&made.stderr));
    folder
}

fn at(folder: &TempDir, name: &str) -> String {
    path(folder.path().join(name))
}

#[test]
fn the_report_has_the_sizes_of_files() {
    let folder = gear();
    let (input, lean, scene) = (at(&folder, "gear.glb"), at(&folder, "lean.glb"), at(&folder, "lean.toml"));
    let before = fs::read(&input).unwrap();
    let done = plan(&[&input, "--size", "24x20", "--apply", &lean, "-o", &scene]);
    assert_eq!(code(&done), 0, "{}", text(&done.stderr));
    let report = text(&done.stdout);
    assert!(report.contains("storage f32 to i8"), "{report}");
    let line = |label: &str| {
        let label = format!("  {label} ");
        report
            .lines()
            .find(|line| line.starts_with(&label))
            .unwrap_or_else(|| panic!("{label}: {report}"))
            .to_owned()
    };
    assert!(line("file").contains(&format!("{input} -> {lean}: ")), "{report}");
    assert!(line("data").contains("vertices") && line("data").contains("indices"), "{report}");
    assert_eq!(fs::read(&input).unwrap(), before);
    // The planned scene shows the file, and is drawn.
    let picture = at(&folder, "picture.png");
    assert!(fs::read_to_string(&scene).unwrap().contains("mesh = \"lean.glb\" # plan: storage f32 to i8"));
    assert_eq!(code(&crease().args(["render", &scene, "-o", &picture, "-q"]).output().unwrap()), 0);

    let other = at(&folder, "other.gltf");
    let done = plan(&[&input, "--size", "24x20", "--apply", &other, "--json", "-q"]);
    let report: serde_json::Value = serde_json::from_slice(&done.stdout).unwrap();
    assert_eq!((&report["schema"], &report["minimise"]), (&"crease-plan/1".into(), &"bytes".into()));
    let file = &report["files"][0];
    assert_eq!((&file["input"], &file["output"]), (&input.as_str().into(), &other.as_str().into()));
    assert_eq!(file["before"]["file_bytes"], before.len());
    let written: u64 =
        ["other.gltf", "other.bin"].iter().map(|name| fs::metadata(at(&folder, name)).unwrap().len()).sum();
    assert_eq!(file["after"]["file_bytes"], written);
    assert!(file["after"]["vertex_bytes"].as_u64() < file["before"]["vertex_bytes"].as_u64());
    // The members that docs/json.md lists.
    let page = fs::read_to_string(path(data("../docs/json.md"))).unwrap();
    let section = page.split("## `crease-plan/1`").nth(1).unwrap().split("\n## ").next().unwrap();
    for member in file.as_object().unwrap().keys().chain(file["after"].as_object().unwrap().keys()) {
        assert!(section.contains(&format!("`{member}`")), "{member} is not in docs/json.md");
    }
}

/// Meshes of other formats are converted first: what has no normals of vertices is planned with computed ones.
#[test]
fn meshes_of_other_formats_become_gltf() {
    let folder = folder(&[]);
    for (name, had_normals) in
        [("gear.obj", true), ("part.stl", false), ("leaf.ply", false), ("polygons.obj", false)]
    {
        let (input, output) = (path(data(name)), at(&folder, "out.glb"));
        let done =
            plan(&[&input, "--size", "24x20", "--tolerance", "60", "--apply", &output, "--json", "-q"]);
        assert_eq!(code(&done), 0, "{name}: {}", text(&done.stderr));
        let report: serde_json::Value = serde_json::from_slice(&done.stdout).unwrap();
        assert_eq!(report["files"][0]["before"]["file_bytes"], fs::metadata(&input).unwrap().len(), "{name}");
        let axes: Vec<&str> = report["decisions"]
            .as_array()
            .unwrap()
            .iter()
            .map(|decision| decision["axis"].as_str().unwrap())
            .collect();
        assert!(!axes.is_empty() && (!had_normals || axes == ["storage"]), "{name}: {axes:?}");
        let checked = crease().args(["inspect", &output, "-q", "--json"]).output().unwrap();
        assert!(code(&checked) <= 1, "{name}: {}", text(&checked.stderr));
    }
}

#[test]
fn the_meshes_of_a_scene_go_into_a_folder() {
    let folder = gear();
    let (scene, lean) = (at(&folder, "scene.toml"), at(&folder, "lean"));
    let done = plan(&[&scene, "--apply", &lean]);
    assert_eq!(code(&done), 0, "{}", text(&done.stderr));
    assert_eq!(
        names(folder.path()),
        ["ball.toml", "gear.glb", "lean/gear.glb", "lean/scene.toml", "scene.toml", "triangle.obj"]
    );
    assert!(text(&done.stdout).starts_with(&format!("{scene} -> {}\n", at(&folder, "lean/scene.toml"))));
    // With a name for the scene, which is above the meshes.
    let planned = at(&folder, "planned.toml");
    assert_eq!(code(&plan(&[&scene, "--apply", &lean, "-o", &planned, "-q"])), 0);
    assert!(fs::read_to_string(&planned).unwrap().contains("mesh = \"lean/gear.glb\""));
    for scene in [&planned, &at(&folder, "lean/scene.toml")] {
        let picture = at(&folder, "picture.png");
        assert_eq!(code(&crease().args(["render", scene, "-o", &picture, "-q"]).output().unwrap()), 0);
    }
}

#[test]
fn impossible_requests_are_refused() {
    let folder = gear();
    let (mesh, scene, ball) = (at(&folder, "gear.glb"), at(&folder, "scene.toml"), at(&folder, "ball.toml"));
    let out = at(&folder, "out.glb");
    let before = names(folder.path());
    let contents = || -> Vec<Vec<u8>> {
        before.iter().map(|name| fs::read(folder.path().join(name)).unwrap()).collect()
    };
    let old = contents();
    let refused: &[(&[&str], &str)] = &[
        (&[&mesh, "--apply", &out, "--only", "interpolation"], "not interpolation"),
        (&[&mesh, "--apply", &out, "--only", "storage,shading"], "flat shading is a value of `storage`"),
        (&[&mesh, "--apply", &out, "--only", "lights"], "not lights"),
        (
            &[&mesh, "--apply", &out, "--reference", "accurate"],
            "--reference accurate cannot be used with --apply",
        ),
        (&[&mesh, "--apply", &out, "--allow", "antialiasing"], "--allow cannot be used with --apply"),
        (&[&mesh, "--apply", &mesh], "this would overwrite the input"),
        (&[&mesh, "--apply", &at(&folder, "out.obj")], "--apply writes glTF"),
        (&[&mesh, "--apply", &at(&folder, "out")], "--apply writes glTF"),
        (&[&mesh, "--apply", "-"], "--apply cannot write to standard output"),
        (&[&mesh, "--apply", &path(folder.path())], "is a folder"),
        (&[&mesh, "--apply", &out, "-o", &out], "two outputs would both be written"),
        (
            &[&mesh, "--apply", &out, "-o", &at(&folder, "below/planned.toml")],
            "the planned scene cannot refer to",
        ),
        (&[&scene, "--apply", &out], "is a file"),
        (&[&scene, "--apply", &mesh], "is a file"),
        (&[&scene, "--apply", &path(folder.path())], "is the folder of the input"),
        (
            &[&scene, "--apply", &at(&folder, "a"), "-o", &at(&folder, "b/planned.toml")],
            "the planned scene cannot refer to",
        ),
        (
            &[&scene, "--apply", &path(folder.path()), "-o", &at(&folder, "planned.toml")],
            "this would overwrite the input",
        ),
        (&[&ball, "--apply", &at(&folder, "a")], "no object of the scene has a mesh file"),
    ];
    for (args, message) in refused {
        let output = plan(&[args, &["--size", "8x8"][..]].concat());
        let error = text(&output.stderr);
        assert_eq!(code(&output), 2, "{args:?}: {error}");
        assert!(error.starts_with("error: ") && error.contains(message), "{args:?}: {error}");
        assert_eq!((names(folder.path()), contents()), (before.clone(), old.clone()), "{args:?}");
    }
    let bad = plan(&[&at(&folder, "missing.glb"), "--apply", &out]);
    assert_eq!(code(&bad), 3, "{}", text(&bad.stderr));
    assert_eq!(names(folder.path()), before);
}

/// A file that the input refers to is no output either.
#[test]
fn buffers_of_the_input_are_not_overwritten() {
    let folder = gear();
    let (glb, gltf) = (at(&folder, "gear.glb"), at(&folder, "gear.gltf"));
    assert!(crease().args(["normals", &glb, "-o", &gltf, "-q"]).output().unwrap().status.success());
    assert!(names(folder.path()).contains(&"gear.bin".to_owned()));
    fs::rename(&gltf, at(&folder, "input.gltf")).unwrap();
    let buffer = fs::read(at(&folder, "gear.bin")).unwrap();
    let refused = plan(&[&at(&folder, "input.gltf"), "--size", "8x8", "--apply", &gltf]);
    assert_eq!(code(&refused), 2, "{}", text(&refused.stderr));
    assert!(text(&refused.stderr).contains("gear.bin"), "{}", text(&refused.stderr));
    assert_eq!(fs::read(at(&folder, "gear.bin")).unwrap(), buffer);
    assert!(!folder.path().join("gear.gltf").exists());
}

#[cfg(unix)]
#[test]
fn what_cannot_be_written_leaves_nothing() {
    let folder = gear();
    let (input, output) = (at(&folder, "gear.glb"), at(&folder, "triangle.obj/out.glb"));
    let before = names(folder.path());
    let failed = plan(&[&input, "--size", "8x8", "--apply", &output]);
    assert_eq!(code(&failed), 4, "{}", text(&failed.stderr));
    assert_eq!(names(folder.path()), before);
}
