//! Surfaces that face inwards: a cavity if another mesh of the file encloses it, inside out otherwise. The diagnosis and
//! `Orient::Outward` agree.

use super::surface;
use crate::cli::{crease, path, text};
use crease::io::{
    Document, FileNode, Format, Loaded, Part, ReadOptions, WriteOptions, read_bytes, write_new,
};
use crease::mesh::{FaceEdit, Mesh, Orient};
use crease::pipeline::{Task, revise};
use crease::quality::catalogue::Kind;
use crease::quality::{Thresholds, diagnose};
use crease::surface::{Sphere, Surface};
use glam::{DMat4, DQuat, DVec3};
use serde_json::{Value, json};
use std::f64::consts::FRAC_PI_3;
use std::fs;

/// No part is inside out.
const NO_PART: [usize; 0] = [];

/// A ball around the origin that faces outwards.
fn ball(radius: f64) -> Mesh {
    surface(&Surface::from(Sphere::new(radius).unwrap()), [12, 8]).with_normals(None)
}

fn turned(mesh: &Mesh) -> Mesh {
    let all = (0..mesh.face_count() as u32).collect();
    mesh.with_faces(&FaceEdit { reversed: all, ..FaceEdit::default() })
}

/// The wall of a cavity.
fn cavity(radius: f64) -> Mesh {
    turned(&ball(radius))
}

fn at(x: f64) -> DMat4 {
    DMat4::from_translation(DVec3::X * x)
}

fn scene(meshes: &[Mesh], nodes: &[(usize, DMat4)]) -> Loaded {
    let node = |(number, &(part, world_from_part)): (usize, &(usize, DMat4))| FileNode {
        number,
        name: String::new(),
        part,
        world_from_part,
    };
    Loaded {
        format: Format::Gltf,
        parts: meshes.iter().map(|mesh| Part { mesh: mesh.clone(), ..Part::default() }).collect(),
        nodes: nodes.iter().enumerate().map(node).collect(),
        notes: Vec::new(),
        document: Document::None,
    }
}

/// The parts of a file that are reported as inside out.
fn reported(loaded: &Loaded) -> Vec<usize> {
    let thresholds = Thresholds { places: 1 << 16, ..Thresholds::default() };
    let diagnosis = diagnose(loaded, &thresholds, &|_| {});
    let mut parts: Vec<usize> =
        diagnosis.get(Kind::InsideOut).map_or(vec![], |it| it.places.iter().map(|at| at.part).collect());
    parts.dedup();
    parts.sort_unstable();
    parts.dedup();
    parts
}

/// The parts that are reported as inside out. Asserts that `Orient::Outward` reverses all faces of these parts and no others, and
/// that nothing is reported afterwards.
#[track_caller]
fn inside_out(mut loaded: Loaded) -> Vec<usize> {
    let parts = reported(&loaded);
    let outward = Task { orient: Orient::Outward, ..Task::default() };
    let edits = revise(&loaded, &outward, None, &|_| {}).edits;
    for (number, (part, edit)) in loaded.parts.iter_mut().zip(edits).enumerate() {
        let expected = if parts.contains(&number) { part.mesh.face_count() } else { 0 };
        assert_eq!(edit.faces.reversed.len(), expected, "part {number}, where {parts:?} are reported");
        part.mesh = part.mesh.with_faces(&edit.faces);
    }
    assert_eq!(reported(&loaded), NO_PART, "after the fix");
    parts
}

#[test]
fn a_cavity_may_be_a_mesh_of_its_own() {
    let meshes = [ball(2.0), cavity(1.0)];
    let here = DMat4::IDENTITY;
    assert_eq!(inside_out(scene(&meshes, &[(0, here), (1, here)])), NO_PART);
    assert_eq!(
        inside_out(scene(&meshes, &[])),
        NO_PART,
        "parts without nodes keep their positions, like the solids of STL"
    );
    assert_eq!(inside_out(scene(&meshes, &[(0, here), (1, at(5.0))])), [1], "outside");
    assert_eq!(inside_out(scene(&meshes, &[(0, here), (1, at(1.5))])), [1], "through the wall");
    assert_eq!(inside_out(scene(&meshes, &[(0, here)])), [1], "nowhere");
    assert_eq!(inside_out(scene(&meshes[1..], &[(0, here)])), [0], "alone");
}

/// Nodes rotate, scale, shear and mirror both meshes; what is inside stays inside.
#[test]
fn places_in_the_world_count() {
    let turn = DMat4::from_quat(DQuat::from_axis_angle(DVec3::new(1.0, 2.0, -0.5).normalize(), FRAC_PI_3));
    let scale = |x: f64, y: f64, z: f64| DMat4::from_scale(DVec3::new(x, y, z));
    // A hundredth of the size, and far away.
    let small = at(1e4) * turn * scale(0.01, 0.02, 0.015);
    let mirrored = at(-3.0) * scale(-1.0, 1.0, 1.0) * turn;
    for world in
        [turn, small, mirrored, small * mirrored, scale(1e-100, 1e-100, 1e-100), scale(1e12, 1.0, 1.0)]
    {
        // The cavity is larger than the ball in mesh space and smaller in world space, where it is also rotated and mirrored.
        let own = turn * scale(-0.04, 0.03, 0.02);
        let meshes = [ball(2.0), cavity(40.0)];
        assert_eq!(inside_out(scene(&meshes, &[(0, world), (1, world * own)])), NO_PART, "{world}");
        assert_eq!(inside_out(scene(&meshes, &[(0, world), (1, world * at(4.0) * own)])), [1], "{world}");
        assert_eq!(inside_out(scene(&meshes, &[(0, world), (1, world)])), [1], "around it: {world}");
    }
    let flat = scale(1.0, 0.0, 1.0);
    let meshes = [ball(2.0), cavity(1.0)];
    assert_eq!(inside_out(scene(&meshes, &[(0, flat), (1, DMat4::IDENTITY)])), [1], "in a flattened ball");
    let hidden = [(0, DMat4::IDENTITY), (1, DMat4::IDENTITY), (1, at(9.0) * flat)];
    assert_eq!(inside_out(scene(&meshes, &hidden)), NO_PART, "an instance that is not visible");
}

#[test]
fn all_places_have_to_agree() {
    let meshes = [ball(2.0), cavity(1.0)];
    let here = DMat4::IDENTITY;
    assert_eq!(inside_out(scene(&meshes, &[(0, here), (1, here), (1, at(9.0))])), [1], "once in, once out");
    let both = [(0, here), (1, here), (0, at(9.0)), (1, at(9.0))];
    assert_eq!(inside_out(scene(&meshes, &both)), NO_PART, "in two balls");
    let twice = [(0, here), (1, here), (1, here)];
    assert_eq!(inside_out(scene(&meshes, &twice)), NO_PART, "twice at one place");
}

/// A point is in matter if more of the surfaces around it face outwards than inwards.
#[test]
fn what_encloses_is_counted_with_its_sign() {
    let here = |count: usize| (0..count).map(|part| (part, DMat4::IDENTITY)).collect::<Vec<_>>();
    let parts = |meshes: &[Mesh]| inside_out(scene(meshes, &here(meshes.len())));
    assert_eq!(parts(&[ball(4.0), ball(2.0)]), NO_PART, "an engine in a car");
    assert_eq!(parts(&[ball(4.0), ball(2.0), cavity(1.0)]), NO_PART, "the cavity of an engine in a car");
    assert_eq!(parts(&[ball(4.0), cavity(3.0), cavity(2.0)]), [2], "in a cavity there is no matter");
    assert_eq!(parts(&[cavity(2.0), cavity(3.0), ball(4.0)]), [0], "in any order");
    assert_eq!(parts(&[ball(4.0), cavity(3.0), ball(2.0), cavity(1.0)]), NO_PART, "a thing in a cavity");
    assert_eq!(parts(&[cavity(4.0), cavity(3.0)]), [0], "a cavity of what is inside out");
    assert_eq!(parts(&[cavity(4.0), cavity(3.0), cavity(2.0)]), [0, 2], "and what floats in it");
    assert_eq!(parts(&[cavity(4.0), cavity(3.0), cavity(2.0), cavity(1.0)]), [0, 2], "with a cavity");
}

/// Two instances of one mesh, the smaller one within the other.
#[test]
fn a_mesh_may_enclose_itself() {
    let smaller = DMat4::from_scale(DVec3::splat(0.5));
    let here = DMat4::IDENTITY;
    assert_eq!(inside_out(scene(&[ball(2.0)], &[(0, here), (0, smaller)])), NO_PART);
    assert_eq!(
        inside_out(scene(&[cavity(2.0)], &[(0, here), (0, smaller)])),
        [0],
        "the outer one is in nothing"
    );
}

/// Primitives of a glTF mesh, objects of an OBJ file and solids of an STL file.
#[test]
fn pieces_of_files_enclose_each_other() {
    let parts = [ball(2.0), cavity(1.0)].map(|mesh| Part { mesh, ..Part::default() });
    let moved = parts.clone().map(|part| part.mesh.transformed(at(9.0)).unwrap());
    let apart = [parts[0].clone(), Part { mesh: moved[1].clone(), ..Part::default() }];
    let read =
        |bytes: Vec<u8>, format| read_bytes(bytes, Some(format), None, &ReadOptions::default()).unwrap();
    for (parts, expected) in [(&parts, false), (&apart, true)] {
        let written = |format| write_new(parts, format, &WriteOptions::default()).unwrap().bytes;
        let formats = [Format::Obj, Format::Gltf, Format::Glb, Format::Ply, Format::Stl];
        let mut files: Vec<(Loaded, usize)> = formats
            .map(|format| (read(written(format), format), if format.is_gltf() { 2 } else { 1 }))
            .into();
        files.push((read(one_mesh(&written(Format::Gltf)).into_bytes(), Format::Gltf), 1));
        for (loaded, count) in files {
            assert_eq!(loaded.parts.len(), count, "{}", loaded.format);
            assert_eq!(!reported(&loaded).is_empty(), expected, "{}", loaded.format);
            let outward = Task { orient: Orient::Outward, ..Task::default() };
            let edits = revise(&loaded, &outward, None, &|_| {}).edits;
            let turned: usize = edits.iter().map(|edit| edit.faces.reversed.len()).sum();
            let wall = loaded.parts.iter().map(|part| part.mesh.face_count()).sum::<usize>() / 2;
            assert_eq!(turned, if expected { wall } else { 0 }, "{}", loaded.format);
        }
    }
    let solid = |part: &Part| {
        let bytes =
            write_new(std::slice::from_ref(part), Format::Stl, &WriteOptions::default()).unwrap().bytes;
        facets(&read(bytes, Format::Stl).parts[0].mesh)
    };
    for (parts, expected) in [(&parts, false), (&apart, true)] {
        let solids = read(parts.iter().map(solid).collect::<String>().into_bytes(), Format::Stl);
        assert_eq!(solids.parts.len(), 2);
        assert_eq!(!inside_out(solids).is_empty(), expected, "two solids");
    }
}

/// A solid of an STL file as text.
fn facets(mesh: &Mesh) -> String {
    let mut solid = String::from("solid\n");
    for face in mesh.faces().iter() {
        solid.push_str("facet normal 0 0 0\nouter loop\n");
        for &vertex in face {
            let [x, y, z] = mesh.positions().at(vertex).to_array();
            solid.push_str(&format!("vertex {x:e} {y:e} {z:e}\n"));
        }
        solid.push_str("endloop\nendfacet\n");
    }
    solid + "endsolid\n"
}

/// A glTF file with the primitives of all meshes in one.
pub(super) fn one_mesh(bytes: &[u8]) -> String {
    let mut document: Value = serde_json::from_slice(bytes).unwrap();
    let meshes = document["meshes"].as_array().unwrap().clone();
    let primitives: Vec<Value> =
        meshes.iter().flat_map(|mesh| mesh["primitives"].as_array().unwrap().clone()).collect();
    document["meshes"] = json!([{ "primitives": primitives }]);
    document["nodes"] = json!([{ "mesh": 0 }]);
    document["scenes"] = json!([{ "nodes": [0] }]);
    document.to_string()
}

/// The suggested command fixes the mesh that is inside out and does not change the cavity.
#[test]
fn the_suggested_command_leaves_cavities() {
    let parts = [ball(2.0), cavity(1.0), cavity(0.5).transformed(at(9.0)).unwrap()];
    let parts = parts.map(|mesh| Part { mesh, ..Part::default() });
    let folder = tempfile::tempdir().unwrap();
    let [file, mended] = ["balls.glb", "mended.glb"].map(|name| folder.path().join(name));
    fs::write(&file, write_new(&parts, Format::Glb, &WriteOptions::default()).unwrap().bytes).unwrap();
    let inspect = |file| {
        let output =
            crease().args(["inspect", "--json", "--only", "inside-out", &path(file)]).output().unwrap();
        let report: Value = serde_json::from_str(text(&output.stdout)).unwrap();
        report["findings"].as_array().unwrap().clone()
    };
    let found = inspect(&file);
    assert_eq!(found[0]["count"].as_u64(), Some(parts[2].mesh.face_count() as u64));
    let reported = found[0]["command"].as_str().unwrap();
    assert!(reported.ends_with("--orient outward"), "{reported}");
    let arguments = ["normals", &path(&file), "-o", &path(&mended), "--orient", "outward"];
    assert!(crease().args(arguments).output().unwrap().status.success());
    assert_eq!(inspect(&mended), Vec::<Value>::new());
    let read = |file: &std::path::Path| crease::io::read(file, None, &ReadOptions::default()).unwrap();
    let faces = |loaded: &Loaded, part: usize| loaded.parts[part].mesh.faces().face(0).to_vec();
    assert_eq!(faces(&read(&mended), 1), faces(&read(&file), 1), "the cavity stays");
}
