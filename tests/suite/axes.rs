//! Axes, units and the material of new files: positions follow, normals keep their bits.

use crate::cli::{code, data, folder, normals, path, succeed, text};
use crease::io::{self, Format, Loaded, MaterialFallback, ReadOptions, WriteOptions};
use crease::mesh::{AxisConversion, Mesh, UpAxis};
use crease::pipeline::{Task, revise};
use glam::DVec3;
use std::path::Path;

fn read(file: &Path) -> Loaded {
    io::read(file, None, &ReadOptions::default()).unwrap()
}

/// Position and normal of each corner.
fn corners(mesh: &Mesh) -> Vec<[DVec3; 2]> {
    let normals = mesh.columns().normals.as_ref().unwrap();
    let corner = |(corner, &vertex)| [mesh.positions().at(vertex), *normals.get(corner, vertex).unwrap()];
    mesh.faces().corners().iter().enumerate().map(corner).collect()
}

fn converted(loaded: &Loaded, to: Format, conversion: Option<AxisConversion>) -> Loaded {
    let revision = revise(loaded, &Task::default(), Some(to), &|_| {});
    let options = WriteOptions { conversion, ..WriteOptions::default() };
    let written = io::write(loaded, revision.edits, to, &options).unwrap();
    io::read_bytes(written.bytes, Some(to), None, &ReadOptions::default()).unwrap()
}

#[test]
fn positions_and_normals_of_a_new_gltf_follow_the_up_axis() {
    let loaded = read(&data("part-binary.stl"));
    let plain = corners(&converted(&loaded, Format::Glb, None).parts[0].mesh);
    for up in [UpAxis::X, UpAxis::Y, UpAxis::Z] {
        let conversion = AxisConversion::to_y_up(up).scaled(0.001);
        let metres = corners(&converted(&loaded, Format::Glb, Some(conversion)).parts[0].mesh);
        assert_eq!(plain.len(), metres.len());
        for ([old, old_normal], [new, new_normal]) in plain.iter().zip(&metres) {
            assert_eq!(*new, conversion.point(*old).as_vec3().as_dvec3(), "rounded once to f32");
            assert_eq!(*new_normal, conversion.rotate(*old_normal), "the same bits");
        }
    }
}

#[test]
fn the_way_back_restores_axes_and_units() {
    let work = folder(&[]);
    let [glb, ply] = ["part.glb", "part.ply"].map(|name| path(work.path().join(name)));
    for up in ["x", "y", "z"] {
        let options = ["--up", up, "--scale", "in", "--merge", "off", "-q"];
        succeed([&*path(data("part.stl")), "-o", &glb].into_iter().chain(options));
        succeed([&*glb, "-o", &ply].into_iter().chain(options));
        let (old, new) = (read(&data("part.stl")), read(Path::new(&ply)));
        let size = old.parts[0].mesh.bounds().map(|(low, high)| (high - low).length()).unwrap();
        for (a, b) in old.parts[0].mesh.positions().iter().zip(new.parts[0].mesh.positions().iter()) {
            // Rounded to f32 twice, and the inverse of the factor once.
            assert!((a - b).length() <= 4.0 * f64::from(f32::EPSILON) * size, "{a} became {b}");
        }
    }
}

#[test]
fn the_report_has_the_matrix_and_the_text_names_the_change() {
    let work = folder(&[]);
    let out = path(work.path().join("part.glb"));
    let input = path(data("part.stl"));
    let args = [&*input, "--up", "z", "--scale", "mm", "-o", &out];
    let printed = succeed(args);
    assert!(text(&printed.stdout).contains("rotated from z up, multiplied by 0.001"));
    assert!(!text(&printed.stderr).contains("coordinates are unchanged"));
    let report: serde_json::Value =
        serde_json::from_slice(&succeed(args.into_iter().chain(["--json"])).stdout).unwrap();
    let matrix =
        [[0.001, 0.0, 0.0, 0.0], [0.0, 0.0, -0.001, 0.0], [0.0, 0.001, 0.0, 0.0], [0.0, 0.0, 0.0, 1.0]];
    assert_eq!(report["output"]["matrix"], serde_json::json!(matrix.as_flattened()));
    let plain = succeed([&*input, "-o", &out]);
    let note = text(&plain.stderr);
    assert!(note.contains("coordinates are unchanged") && note.contains("--up and --scale"), "{note}");
}

#[test]
fn options_that_cannot_apply_are_usage_errors() {
    let (stl, glb) = (path(data("part.stl")), path(data("sphere-seam.glb")));
    for (args, found) in [
        (vec![&*stl, "--to", "stl", "--up", "z"], "stl to stl keeps them"),
        (vec![&*glb, "--to", "gltf", "--scale", "2"], "glb to gltf keeps them"),
        (vec![&*stl, "--to", "ply", "--up", "z"], "no fixed up axis"),
        (vec![&*stl, "--to", "obj", "--scale", "mm"], "--scale takes a factor"),
        (vec![&*stl, "--to", "glb", "--scale", "0"], "a factor above 0"),
        (vec![&*stl, "--to", "glb", "--scale", "-1"], "a factor above 0"),
        (vec![&*stl, "--to", "glb", "--scale", "inf"], "a factor above 0"),
        (vec![&*stl, "--to", "glb", "--scale", "furlong"], "mm, cm, m, in"),
    ] {
        let refused = normals(args.iter().copied().chain(["--dry-run"]));
        let (status, message) = (code(&refused), text(&refused.stderr));
        assert!(status == 2 && message.contains(found), "{args:?}: {status}, {message}");
    }
    let refused = normals([&*stl, "--to", "glb", "--dry-run", "--scale", "1e38"]);
    let (status, message) = (code(&refused), text(&refused.stderr));
    assert!(status == 4 && message.contains("out of the range"), "{status}, {message}");
    // All vertices would be in one point.
    let refused = normals([&*stl, "--to", "glb", "--dry-run", "--scale", "1e-46"]);
    let (status, message) = (code(&refused), text(&refused.stderr));
    assert!(status == 4 && message.contains("use a larger --scale"), "{status}, {message}");
}

#[test]
fn faces_without_a_material_get_one_that_is_not_metallic() {
    let json_of = |file: &str, material| {
        let loaded = read(&data(file));
        let options = WriteOptions { material, ..WriteOptions::default() };
        let written = io::write(&loaded, &[][..], Format::Gltf, &options).unwrap();
        serde_json::from_slice::<serde_json::Value>(&written.bytes).unwrap()
    };
    let plastic = json_of("part.stl", MaterialFallback::Plastic);
    let [material] = &plastic["materials"].as_array().unwrap()[..] else { panic!("one material") };
    assert_eq!(material["name"], "default");
    let surface = &material["pbrMetallicRoughness"];
    assert_eq!(surface["metallicFactor"], 0);
    assert_eq!(surface["roughnessFactor"], 0.6);
    assert_eq!(plastic["meshes"][0]["primitives"][0]["material"], 0);
    // Authored materials stay alone where every face has one.
    let authored = json_of("gear.obj", MaterialFallback::Plastic);
    let names = authored["materials"].as_array().map_or(0, Vec::len);
    assert_eq!(authored, json_of("gear.obj", MaterialFallback::Omit), "{names} materials");
    let none = json_of("part.stl", MaterialFallback::Omit);
    assert!(none["materials"].is_null() && none["meshes"][0]["primitives"][0]["material"].is_null());
}

#[test]
fn a_picture_with_an_up_axis_is_that_of_the_rotated_mesh() {
    let work = folder(&[]);
    let [glb, rotated, upright] = ["part.glb", "a.png", "b.png"].map(|name| path(work.path().join(name)));
    let stl = path(data("part.stl"));
    let draw = |args: &[&str]| {
        crate::cli::crease().arg("render").args(args).args(["-q", "--size", "96x72"]).assert().success();
    };
    for up in ["x", "z"] {
        succeed([&*stl, "-o", &glb, "--up", up, "--material", "none", "-q"]);
        draw(&[&glb, "-o", &rotated]);
        draw(&[&stl, "-o", &upright, "--up", up]);
        assert_eq!(std::fs::read(&rotated).unwrap(), std::fs::read(&upright).unwrap(), "{up}");
    }
}
