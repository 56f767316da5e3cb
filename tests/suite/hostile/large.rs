//! Large inputs made to be slow or greedy to read.
//!
//! Each is read in a process of its own, this test binary again, whose peak memory is then its alone.

use super::patiently;
use crease::io::{self, Format, ReadOptions};
use std::fs;
use std::path::Path;
use std::process::Command;

/// Set for the child process: the format and the path of what it reads.
const INPUT: &str = "CREASE_HOSTILE_INPUT";

/// Peak memory allowed for an input of 16 MiB.
const LIMIT: u64 = 512 << 20;

/// A quarter of the size that the limit is for, with a quarter of the limit.
const SHARE: u64 = 4;

/// A glTF document filled up by repeating an item of one of its lists.
fn gltf(before: &str, item: &str, after: &str) -> Vec<u8> {
    let accessor = "{\"componentType\":5126,\"type\":\"VEC3\",\"count\":3}";
    let mut text = format!("{{\"asset\":{{\"version\":\"2.0\"}},\"accessors\":[{accessor}],{before}");
    while text.len() + item.len() + after.len() < (16 << 20) / SHARE as usize {
        text.push_str(item);
        text.push(',');
    }
    text.pop();
    text.push_str(after);
    text.into_bytes()
}

fn repeated(pattern: &str) -> Vec<u8> {
    pattern.bytes().cycle().take((16 << 20) / SHARE as usize).collect()
}

/// A glTF mesh of a few bytes, and a primitive.
const SMALL_MESH: &str = "{\"primitives\":[{\"attributes\":{\"POSITION\":0}}]}";
const SMALL_PRIMITIVE: &str = "{\"attributes\":{\"POSITION\":0}}";

/// A glTF mesh up to the attributes of its primitive.
const MESH: &str = "\"meshes\":[{\"primitives\":[{\"attributes\":{";

/// What to read and how it is called.
fn inputs() -> Vec<(Format, &'static str, Vec<u8>)> {
    let start = "v 0 0 0\nv 1 0 0\nv 0 1 0\n";
    let obj = |pattern: &str| [start.as_bytes(), &repeated(pattern)[..], b"\n"].concat();
    vec![
        (Format::Obj, "one line of backslashes", obj("\\")),
        (Format::Obj, "continued lines of nothing", obj("\\\n")),
        (Format::Obj, "a continued line of backslashes and blanks", obj("\\ \t\\ \n")),
        (Format::Obj, "one number", obj("0")),
        (Format::Obj, "one comment", obj("#")),
        (Format::Obj, "blank lines", obj("\r")),
        (Format::Obj, "one face", [start.as_bytes(), b"f", &repeated(" 1")[..]].concat()),
        (Format::Obj, "faces", obj("f 1 2 3\n")),
        (Format::Obj, "faces that count back now and then", obj("f 1 -2 3\n")),
        (Format::Obj, "short faces", obj("f\n")),
        (Format::Obj, "lines", obj("l 1 2\n")),
        (Format::Obj, "points", obj("p 1\n")),
        (Format::Obj, "one long name", [start.as_bytes(), b"f 1 2 3\ng ", &repeated("x")[..]].concat()),
        (Format::Obj, "groups", obj("g a\ng b\n")),
        (Format::Obj, "smoothing groups", obj("s a\ns 1\n")),
        (Format::Obj, "libraries", obj("mtllib a\nmtllib b.mtl c\n")),
        (
            Format::Obj,
            "one statement of libraries",
            [start.as_bytes(), b"mtllib", &repeated(" a.mtl")[..]].concat(),
        ),
        (Format::Obj, "one statement of words", [start.as_bytes(), b"mtllib", &repeated(" a")[..]].concat()),
        (Format::Obj, "names of their own", numbered("g ")),
        (Format::Obj, "libraries of their own", numbered("mtllib ")),
        (Format::Obj, "unknown statements", obj("x\n")),
        (Format::Obj, "colours", obj("v 0 0 0 1 1 1\n")),
        (Format::Ply, "faces", ply("3 0 1 2\n")),
        (Format::Ply, "faces in one line", ply("3 0 1 2 ")),
        (Format::Ply, "faces without corners", ply("0\n")),
        (Format::Ply, "one polygon", ply_polygon()),
        (Format::Ply, "elements of their own", ply_elements()),
        (
            Format::Stl,
            "facets",
            stl("facet outer loop vertex 0 0 0 vertex 0 1 0 vertex 1 0 0 endloop endfacet\n"),
        ),
        (Format::Stl, "solids", stl("endsolid\nsolid\n")),
        (Format::Stl, "unknown words", stl("x\n")),
        (Format::Gltf, "open brackets", repeated("[")),
        (Format::Gltf, "numbers", gltf("\"x\":[", "1", "]}")),
        (Format::Gltf, "members", gltf("\"x\":{", "\"a\":1", "}}")),
        (Format::Gltf, "nodes", gltf("\"nodes\":[", "{}", "]}")),
        (Format::Gltf, "meshes", gltf("\"meshes\":[", SMALL_MESH, "]}")),
        (Format::Gltf, "primitives", gltf("\"meshes\":[{\"primitives\":[", SMALL_PRIMITIVE, "]}]}")),
        (Format::Gltf, "materials", gltf("\"materials\":[", "{}", "]}")),
        (Format::Gltf, "images", gltf("\"images\":[", "{\"uri\":\"a\"}", "]}")),
        (Format::Gltf, "attributes", gltf(MESH, "\"a\":0", "}}]}]}")),
        (
            Format::Gltf,
            "targets",
            gltf(&format!("{MESH}\"POSITION\":0}},\"targets\":["), "{\"POSITION\":0}", "]}]}]}"),
        ),
    ]
}

/// A statement with another name each time.
fn numbered(keyword: &str) -> Vec<u8> {
    let mut text = b"v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n".to_vec();
    for number in 0.. {
        if text.len() as u64 > (16 << 20) / SHARE {
            break;
        }
        text.extend_from_slice(format!("{keyword}{number}\n").as_bytes());
    }
    text
}

/// Three vertices and as many faces as there is room for.
fn ply(row: &str) -> Vec<u8> {
    let faces = repeated(row);
    [ply_header(faces.len() / row.len()).as_bytes(), &faces].concat()
}

fn ply_header(faces: usize) -> String {
    let vertex = "element vertex 3\nproperty float x\nproperty float y\nproperty float z\n";
    let face = format!("element face {faces}\nproperty list int int vertex_indices\n");
    format!("ply\nformat ascii 1.0\n{vertex}{face}end_header\n0 0 0\n1 0 0\n0 1 0\n")
}

fn ply_polygon() -> Vec<u8> {
    let corners = repeated("0 1 2 ");
    [format!("{}{} ", ply_header(1), corners.len() / 2).as_bytes(), &corners, b"0 1 2\n"].concat()
}

fn ply_elements() -> Vec<u8> {
    let elements = (0..200_000).map(|number| format!("element e{number} 0\n")).collect::<String>();
    ply_header(0).replace("element face", &format!("{elements}element face")).into_bytes()
}

fn stl(pattern: &str) -> Vec<u8> {
    [b"solid\n", &repeated(pattern)[..], b"\nendsolid\n"].concat()
}

#[test]
fn large_inputs_take_little_time_and_memory() {
    if !cfg!(target_os = "linux") {
        println!("skipped: peak memory is read from /proc");
        return;
    }
    let folder = tempfile::tempdir().unwrap();
    for (format, name, bytes) in inputs() {
        let path = folder.path().join("input");
        fs::write(&path, &bytes).unwrap();
        let mut child = Command::new(std::env::current_exe().unwrap());
        child.args(["--exact", "hostile::large::the_input_of_a_child_process", "--nocapture"]);
        child.env(INPUT, format!("{format} {}", path.display()));
        patiently(name, move || {
            let output = child.output().unwrap();
            let said = String::from_utf8_lossy(&output.stdout);
            assert!(output.status.success(), "{name}: {said}");
            let peak =
                said.lines().find_map(|line| line.split_once("peak KiB ")?.1.trim().parse::<u64>().ok());
            let peak = peak.unwrap_or_else(|| panic!("{name}: no peak in {said}")) << 10;
            assert!(peak < LIMIT / SHARE, "{name} takes {} MiB", peak >> 20);
        });
    }
}

/// Does nothing but in the child process that the test above starts.
#[test]
fn the_input_of_a_child_process() {
    let Ok(input) = std::env::var(INPUT) else { return };
    let (format, path) = input.split_once(' ').unwrap();
    let format = Format::ALL.into_iter().find(|known| known.extension() == format).unwrap();
    match io::read(Path::new(path), Some(format), &ReadOptions::default()) {
        Ok(loaded) => println!("{} notes", loaded.notes.len()),
        Err(error) => println!("{error}"),
    }
    let status = fs::read_to_string("/proc/self/status").unwrap();
    let peak = status.lines().find_map(|line| line.strip_prefix("VmHWM:")).unwrap();
    println!("peak KiB {}", peak.trim_end_matches("kB").trim());
}
