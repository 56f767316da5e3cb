//! Traced pictures on the command line: invalid materials, warnings, and the tree of rays.

use super::notes::notes;
use super::{render, report};
use crate::cli::{code, folder, path, text};

const SETTINGS: &str = "[settings]\nsize = [40, 30]\nshading = \"traced\"\n";
const GLASS: &str =
    "[[object]]\nname = \"ball\"\nsurface.sphere.radius = 1\nmaterial = { transmit = 0.9, ior = 1.5 }\n";

#[test]
fn invalid_optics_and_limits_are_errors_at_their_line() {
    let scene =
        |line: &str| format!("{SETTINGS}[[object]]\nsurface.sphere.radius = 1\nmaterial = {{ {line} }}\n");
    for (line, expected) in [
        ("transmit = 1, ior = 0.5", "line 6: `object.material.ior`: ior is 0.5"),
        ("transmit = 1, ior = nan", "ior is NaN"),
        ("ior = inf", "ior is inf"),
        ("reflect = -1", "line 6: `object.material.reflect`"),
        ("absorb = [0, -1, 0]", "line 6: `object.material.absorb`"),
    ] {
        let work = folder(&[("scene.toml", &scene(line))]);
        let file = path(work.path().join("scene.toml"));
        let output = render([file.as_str(), "--probe", "1,1"]);
        let message = text(&output.stderr);
        assert!(code(&output) == 3 && message.contains(expected), "{line}: {message}");
    }
    for (line, expected) in
        [("ray-depth = 65", "0 to 64"), ("ray-weight = 2", "0 to 1"), ("shadow-samples = 5000", "0 to 4096")]
    {
        let work = folder(&[("scene.toml", &format!("{SETTINGS}{line}\n{GLASS}"))]);
        let file = path(work.path().join("scene.toml"));
        let output = render([file.as_str(), "--probe", "1,1"]);
        let message = text(&output.stderr);
        assert!(code(&output) == 3 && message.contains(expected), "{line}: {message}");
    }
    let work = folder(&[("scene.toml", GLASS)]);
    let scene = path(work.path().join("scene.toml"));
    let output = render([scene.as_str(), "--material", "transmit=1 ior=0.9"]);
    assert!(code(&output) == 2 && text(&output.stderr).contains("below 1"), "{}", text(&output.stderr));
}

/// MTL's numbers that are no index were once dropped, and glTF's below 1 ignored, both without a word.
#[test]
fn impossible_indices_of_files_are_reported() {
    let body =
        "mtllib m.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nusemtl a\nf 1 3 2\nf 1 2 4\nf 2 3 4\nf 3 1 4\n";
    for index in ["0.5", "0", "-3", "nan", "inf"] {
        let material = format!("newmtl a\nillum 7\nTf 0.9 0.5 0.5\nNi {index}\n");
        let work = folder(&[("a.obj", body), ("m.mtl", &material)]);
        let found = notes(&[path(work.path().join("a.obj"))]);
        assert!(
            found.contains("refractive index of `a` is") && found.contains("not bend light"),
            "{index}: {found}"
        );
    }
    for (index, is_reported) in [("0.5", true), ("0", true), ("-1", true), ("1", false), ("1.4", false)] {
        let extensions = format!(
            r#""KHR_materials_transmission": {{"transmissionFactor": 1}}, "KHR_materials_ior": {{"ior": {index}}}"#
        );
        let file = format!(
            r#"{{"asset": {{"version": "2.0"}}, "scene": 0, "scenes": [{{"nodes": [0]}}], "nodes": [{{"mesh": 0}}],
            "materials": [{{"name": "a", "pbrMetallicRoughness": {{"metallicFactor": 0}}, "extensions": {{{extensions}}}}}],
            "buffers": [{{"byteLength": 36, "uri":
            "data:application/octet-stream;base64,AAAAAAAAAAAAAAAAAACAPwAAAAAAAAAAAAAAAAAAgD8AAAAA"}}],
            "bufferViews": [{{"buffer": 0, "byteLength": 36}}],
            "accessors": [{{"bufferView": 0, "componentType": 5126, "count": 3, "type": "VEC3",
            "min": [0, 0, 0], "max": [1, 1, 0]}}],
            "meshes": [{{"primitives": [{{"attributes": {{"POSITION": 0}}, "material": 0}}]}}]}}"#
        );
        let work = folder(&[("a.gltf", &file)]);
        let found = notes(&[path(work.path().join("a.gltf"))]);
        assert_eq!(found.contains("refractive index of `a` is"), is_reported, "{index}: {found}");
    }
}

#[test]
fn open_bodies_untraced_materials_and_cut_light_are_noted() {
    let open = GLASS.replace("sphere.radius = 1", "plane = { width = 2, height = 2 }");
    let mirrors = "[[object]]\nsurface.plane = { width = 9, height = 9 }\nmaterial = { reflect = 0.9 }\n\
                   [[object]]\nsurface.plane = { width = 9, height = 9 }\nmaterial = { reflect = 0.9 }\n\
                   transform = [{ rotate = [0, 180, 0] }, { translate = [0, 0, 4] }]\n\
                   [camera]\neye = [0, 0, 3]\ntarget = [0, 0, 0]\nheight = 2\n";
    let phong = SETTINGS.replace("traced", "phong");
    let work = folder(&[
        ("closed.toml", &format!("{SETTINGS}{GLASS}")),
        ("open.toml", &format!("{SETTINGS}{open}")),
        ("thin.toml", &format!("{SETTINGS}{}", open.replace("ior = 1.5", "ior = 1"))),
        ("phong.toml", &format!("{phong}{GLASS}")),
        ("mirrors.toml", &format!("{SETTINGS}ray-depth = 3\n{mirrors}")),
        ("deep.toml", &format!("{SETTINGS}ray-depth = 64\nray-weight = 0\n{mirrors}")),
    ]);
    let found = |name: &str| notes(&[path(work.path().join(name))]);
    assert_eq!(found("closed.toml"), "");
    let warning = found("open.toml");
    assert!(warning.contains("object 0 (`ball`) transmits light, but its surface is open"), "{warning}");
    assert_eq!(found("thin.toml"), "");
    assert!(found("phong.toml").contains("which only --shading traced draws"));
    // 0.9⁴.
    let cut = found("mirrors.toml");
    assert!(cut.contains("cut off up to 65.6 % of the light") && cut.contains("`ray-depth` than 3"), "{cut}");
    // 0.9⁶⁵ is above a thousandth: 0.00106.
    assert!(found("deep.toml").contains("cut off up to 0.106 %"), "{}", found("deep.toml"));
}

#[test]
fn a_probe_prints_the_tree_of_rays() {
    let work = folder(&[("scene.toml", &format!("{SETTINGS}{GLASS}"))]);
    let scene = path(work.path().join("scene.toml"));
    let output = render([scene.as_str(), "--probe", "20,15"]);
    let printed = text(&output.stdout);
    for line in [
        "rays\n  camera",
        "    reflected  share",
        "    refracted  share",
        "      meets     object 0, its back",
        "Fresnel   0.04",
    ] {
        assert!(printed.contains(line), "no {line:?} in\n{printed}");
    }
    let report = report(&[scene.as_str(), "--probe", "20,15"]);
    let sample = &report["probe"]["samples"][0];
    let rays = &sample["rays"];
    assert_eq!(rays["colour"], sample["colour"]);
    // The colour is the local light and those of its rays by their shares.
    let number = |value: &serde_json::Value| value.as_f64().unwrap();
    let inner = rays["hit"]["rays"].as_array().unwrap();
    let sum: f64 = inner.iter().map(|ray| number(&ray["share"][0]) * number(&ray["colour"][0])).sum();
    let local = number(&rays["hit"]["local"][0]);
    assert!((number(&rays["colour"][0]) - local - sum).abs() < 1e-6);
    assert!(report["drawings"][0]["rays"].as_u64().unwrap() > 100);
    // Other pictures have no tree.
    let phong = super::report(&[scene.as_str(), "--probe", "20,15", "--shading", "phong"]);
    assert!(phong["probe"]["samples"][0].get("rays").is_none());
}
