//! Compressed glTF: `data/bracket-*.glb`, which gltf-transform and gltfpack made of `bracket.obj`.

use super::cli::{code, crease, data, folder, path, text};
use super::random::Random;
use crease::io::gltf::{edit, read};
use crease::io::{
    self, Document, Format, Loaded, MeshCompression, NonFinite, PartEdit, Problem, ReadOptions, WriteOptions,
    Written,
};
use glam::DVec3;
use meshoptimizer_rs::Workspace;
use meshoptimizer_rs::codec::{VertexEncoding, encode_vertex_buffer};
use serde_json::{Value, json};
use std::fs;

/// The files, and the step of their quantisation: 4 units over 14 bits, or none.
const FILES: [(&str, f64); 4] = [
    ("bracket-draco.glb", 4.0 / 16383.0),
    ("bracket-draco-sequential.glb", 4.0 / 16383.0),
    ("bracket-meshopt.glb", 4.0 / 16383.0),
    ("bracket-meshopt-float.glb", 0.0),
];

fn bytes(name: &str) -> Vec<u8> {
    fs::read(data(name)).unwrap()
}

fn open(bytes: Vec<u8>) -> Loaded {
    read(bytes, None, &ReadOptions::default()).unwrap()
}

fn refusal(bytes: Vec<u8>) -> io::ReadError {
    read(bytes, None, &ReadOptions::default()).unwrap_err()
}

/// The JSON and the BIN chunk of a GLB.
fn chunks(glb: &[u8]) -> (String, Vec<u8>) {
    let length = |at: usize| u32::from_le_bytes(glb[at..at + 4].try_into().unwrap()) as usize;
    let end = 20 + length(12);
    let text = String::from_utf8(glb[20..end].to_vec()).unwrap();
    (text.trim_end().to_owned(), glb[end + 8..end + 8 + length(end)].to_vec())
}

fn glb(text: &str, bin: &[u8]) -> Vec<u8> {
    let (mut text, mut bin) = (text.as_bytes().to_vec(), bin.to_vec());
    text.resize(text.len().next_multiple_of(4), b' ');
    bin.resize(bin.len().next_multiple_of(4), 0);
    let mut out = b"glTF\x02\0\0\0".to_vec();
    out.extend((28 + text.len() as u32 + bin.len() as u32).to_le_bytes());
    for (kind, chunk) in [(b"JSON", text), (b"BIN\0", bin)] {
        out.extend((chunk.len() as u32).to_le_bytes());
        out.extend(kind);
        out.extend(chunk);
    }
    out
}

fn change(loaded: &Loaded, to: Format, options: &WriteOptions) -> Written {
    let Document::Gltf(document) = &loaded.document else { panic!("no glTF") };
    let edits = vec![PartEdit::default(); loaded.parts.len()];
    edit(document, loaded, &edits, to, options).unwrap()
}

/// World positions of the corners of all faces.
fn corners(loaded: &Loaded) -> Vec<DVec3> {
    let of_node = |node: &io::FileNode| {
        let mesh = &loaded.parts[node.part].mesh;
        let positions = mesh.faces().corners().iter().map(|&vertex| mesh.positions().at(vertex));
        positions.map(|position| node.world_from_part.transform_point3(position)).collect::<Vec<_>>()
    };
    loaded.nodes.iter().flat_map(of_node).collect()
}

#[test]
fn positions_are_those_of_the_original_within_half_a_step() {
    let original = io::read(&data("bracket.obj"), None, &ReadOptions::default()).unwrap();
    let original: Vec<DVec3> = original.parts[0].mesh.positions().iter().collect();
    for (name, step) in FILES {
        let corners = corners(&open(bytes(name)));
        assert_eq!(corners.len(), 3 * 68, "{name}");
        let distance = |a: &DVec3, b: &DVec3| (*a - *b).abs().max_element();
        let nearest = |a: &DVec3, all: &[DVec3]| all.iter().map(|b| distance(a, b)).fold(f64::MAX, f64::min);
        // Single precision of numbers up to 4, and of the scale that gltfpack writes with nine digits.
        let bound = 0.5 * step + 2e-6;
        let there = corners.iter().map(|corner| nearest(corner, &original)).fold(0.0, f64::max);
        let back = original.iter().map(|vertex| nearest(vertex, &corners)).fold(0.0, f64::max);
        assert!(there <= bound && back <= bound, "{name}: {there} and {back}, bound {bound}");
    }
}

#[test]
fn the_output_is_plain_and_the_rest_stays() {
    for (name, _) in FILES {
        let input = bytes(name);
        let (old_text, _) = chunks(&input);
        let old: Value = serde_json::from_str(&old_text).unwrap();
        let written = change(&open(input.clone()), Format::Glb, &WriteOptions::default());
        let (text, bin) = chunks(&written.bytes);
        let new: Value = serde_json::from_str(&text).unwrap();
        assert!(
            !text.contains("draco") && !text.contains("meshopt") && !text.contains("\"extensions\""),
            "{text}"
        );
        assert_eq!(new["buffers"], json!([{ "byteLength": bin.len() }]));
        for member in ["asset", "nodes", "scenes", "scene"] {
            assert_eq!(new[member], old[member], "{name}: {member}");
        }
        if name.contains("meshopt") {
            let accessors = |text: &str| {
                let start = text.find("\"accessors\"").unwrap();
                text[start..start + text[start..].find(']').unwrap()].to_owned()
            };
            assert_eq!(accessors(&text), accessors(&old_text));
        }
        let (now, before) = (written.bytes.len(), input.len());
        let note = written.notes.iter().find(|note| note.text.starts_with("written without")).unwrap();
        assert!(note.text.contains(&format!("{now} bytes, {} more than", now - before)), "{}", note.text);
        assert_eq!(corners(&open(written.bytes)), corners(&open(input)), "{name}");
    }
}

#[test]
fn bounds_of_accessors_are_those_of_what_was_decoded() {
    let written = change(&open(bytes("bracket-draco.glb")), Format::Glb, &WriteOptions::default());
    let json: Value = serde_json::from_str(&chunks(&written.bytes).0).unwrap();
    let loaded = open(written.bytes);
    let positions = loaded.parts[0].mesh.positions();
    let (low, high) = positions.iter().fold((DVec3::MAX, DVec3::MIN), |(l, h), p| (l.min(p), h.max(p)));
    let accessor = &json["accessors"][1];
    assert_eq!(accessor["min"], json!(low.to_array()));
    assert_eq!(accessor["max"], json!(high.to_array()));
    // The original ends at 1, which is not a step of the quantisation.
    assert!(high.z > 1.0);
}

#[test]
fn plain_data_of_the_same_buffer_stay() {
    let image = b"an image";
    for (name, _) in FILES {
        let (text, mut bin) = chunks(&bytes(name));
        let mut json: Value = serde_json::from_str(&text).unwrap();
        let offset = bin.len() + 4;
        bin.resize(offset, 0xEE);
        bin.extend(image);
        json["buffers"][0]["byteLength"] = json!(bin.len());
        let views = json["bufferViews"].as_array_mut().unwrap();
        let number = views.len();
        views.push(json!({"buffer": 0, "byteOffset": offset, "byteLength": image.len(), "name": "a view"}));
        json["images"] = json!([{"bufferView": number, "mimeType": "image/png"}]);
        let loaded = open(glb(&json.to_string(), &bin));
        for compression in [MeshCompression::None, MeshCompression::Meshopt] {
            let written =
                change(&loaded, Format::Glb, &WriteOptions { compression, ..WriteOptions::default() });
            let (text, bin) = chunks(&written.bytes);
            let json: Value = serde_json::from_str(&text).unwrap();
            let view = &json["bufferViews"][number];
            let offset = view["byteOffset"].as_u64().unwrap() as usize;
            assert_eq!((&view["name"], &view["buffer"]), (&json!("a view"), &json!(0)));
            assert_eq!(&bin[offset..offset + image.len()], image, "{name}");
        }
    }
}

#[test]
fn compression_by_meshopt_is_without_loss() {
    let options = WriteOptions { compression: MeshCompression::Meshopt, ..WriteOptions::default() };
    for name in ["sphere-seam.glb", "bracket-draco.glb", "bracket-meshopt.glb"] {
        let loaded = open(bytes(name));
        let plain = change(&loaded, Format::Glb, &WriteOptions::default()).bytes;
        let compressed = change(&loaded, Format::Glb, &options).bytes;
        assert!(compressed.len() < plain.len(), "{name}: {} of {}", compressed.len(), plain.len());
        let json: Value = serde_json::from_str(&chunks(&compressed).0).unwrap();
        for list in ["extensionsUsed", "extensionsRequired"] {
            assert!(json[list].as_array().unwrap().contains(&json!("EXT_meshopt_compression")), "{name}");
        }
        let (plain, again) = (open(plain), open(compressed));
        for (one, other) in plain.parts.iter().zip(&again.parts) {
            assert_eq!(one.mesh.positions().to_vec(), other.mesh.positions().to_vec(), "{name}");
            assert_eq!(one.mesh.columns().normals, other.mesh.columns().normals, "{name}");
            assert_eq!(one.mesh.columns().uvs, other.mesh.columns().uvs, "{name}");
            // A triangle may begin with another corner.
            let faces = |loaded: &[u32]| {
                let least =
                    |face: &[u32]| (0..3).map(|k| [face[k], face[(k + 1) % 3], face[(k + 2) % 3]]).min();
                loaded.chunks_exact(3).filter_map(least).collect::<Vec<_>>()
            };
            assert_eq!(faces(one.mesh.faces().corners()), faces(other.mesh.faces().corners()), "{name}");
        }
    }
}

#[test]
fn a_document_with_files_gets_a_new_file_and_keeps_the_old_one() {
    let work = folder(&[]);
    let (text, bin) = chunks(&bytes("bracket-meshopt.glb"));
    let input = work.path().join("a.gltf");
    fs::write(&input, text.replacen("{\"byteLength\":476}", "{\"uri\":\"a.bin\",\"byteLength\":476}", 1))
        .unwrap();
    fs::write(work.path().join("a.bin"), &bin).unwrap();
    crease().args(["normals", &path(&input), "--in-place", "-q", "--crease", "10"]).assert().success();
    assert_eq!(fs::read(work.path().join("a.bin")).unwrap(), bin, "other documents may use it");
    let new: Value = serde_json::from_slice(&fs::read(&input).unwrap()).unwrap();
    assert_eq!(new["buffers"][0]["uri"], "a2.bin");
    assert_eq!(new["buffers"][0]["byteLength"], 1416);
    assert!(work.path().join("a2.bin").is_file());
    let again = io::read(&input, None, &ReadOptions::default()).unwrap();
    assert_eq!(corners(&again), corners(&open(bytes("bracket-meshopt.glb"))));
}

#[test]
fn compression_needs_a_glb() {
    let work = folder(&[]);
    let input = path(data("bracket.obj"));
    let out = path(work.path().join("a.gltf"));
    let output = crease().args(["normals", &input, "--compress", "meshopt", "-o", &out]).output().unwrap();
    let error = text(&output.stderr);
    assert_eq!(code(&output), 2);
    assert!(error.contains("GLB") && error.contains("--to glb"), "{error}");
    let out = path(work.path().join("a.glb"));
    crease().args(["normals", &input, "--compress", "meshopt", "-o", &out]).assert().success();
    assert!(chunks(&fs::read(out).unwrap()).0.contains("EXT_meshopt_compression"));
}

/// Reads a file, and if that succeeds edits it and reads the result: all but the last may fail, none may panic.
fn try_everything(bytes: &[u8]) {
    let force = ReadOptions { non_finite: NonFinite::DropFaces, ..ReadOptions::default() };
    let Ok(loaded) = read(bytes.to_vec(), None, &force) else { return };
    for compression in [MeshCompression::None, MeshCompression::Meshopt] {
        let Document::Gltf(document) = &loaded.document else { panic!("no glTF") };
        let options = WriteOptions { compression, ..WriteOptions::default() };
        let Ok(written) =
            edit(document, &loaded, vec![PartEdit::default(); loaded.parts.len()], Format::Glb, &options)
        else {
            continue;
        };
        let again = read(written.bytes, None, &force);
        assert!(again.is_ok(), "what was written does not read: {}", again.unwrap_err());
    }
}

#[test]
fn truncated_and_altered_data_are_an_error_or_load() {
    for (name, _) in FILES {
        let whole = bytes(name);
        (0..whole.len()).for_each(|end| try_everything(&whole[..end]));
        let (text, bin) = chunks(&whole);
        // The data end early, and the container says so.
        for end in (0..bin.len()).step_by(4) {
            try_everything(&glb(&text, &bin[..end]));
        }
        let mut random = Random(0x5EED);
        for round in 0..2000 {
            let mut altered = whole.clone();
            // Half of the changes are in the compressed data.
            let first = if round % 2 == 0 { 0 } else { whole.len() - bin.len() };
            for _ in 0..=random.below(3) {
                let at = first + random.below(whole.len() - first);
                altered[at] = if altered[at].is_ascii_digit() && first == 0 {
                    b'0' + random.below(10) as u8
                } else {
                    random.next() as u8
                };
            }
            try_everything(&altered);
        }
    }
}

#[test]
fn every_stream_that_ends_early_is_damaged() {
    for name in ["bracket-draco.glb", "bracket-draco-sequential.glb"] {
        let (text, bin) = chunks(&bytes(name));
        let json: Value = serde_json::from_str(&text).unwrap();
        let length = json["bufferViews"][0]["byteLength"].as_u64().unwrap() as usize;
        for end in 0..length {
            let mut json = json.clone();
            json["bufferViews"][0]["byteLength"] = json!(end);
            let error = refusal(glb(&json.to_string(), &bin));
            assert!(error.found.contains("KHR_draco_mesh_compression"), "{name}, {end}: {error}");
        }
    }
    for (name, extension) in [
        ("bracket-meshopt.glb", "KHR_meshopt_compression"),
        ("bracket-meshopt-float.glb", "EXT_meshopt_compression"),
    ] {
        let (text, bin) = chunks(&bytes(name));
        let json: Value = serde_json::from_str(&text).unwrap();
        for view in 0..3 {
            let length = json["bufferViews"][view]["extensions"][extension]["byteLength"].as_u64().unwrap();
            for end in 0..length {
                let mut json = json.clone();
                json["bufferViews"][view]["extensions"][extension]["byteLength"] = json!(end);
                let error = refusal(glb(&json.to_string(), &bin));
                assert!(error.found.contains(extension), "{name}, view {view}, {end}: {error}");
            }
        }
    }
}

#[test]
fn counts_alone_take_no_memory() {
    let (text, bin) = chunks(&bytes("bracket-meshopt.glb"));
    let json: Value = serde_json::from_str(&text).unwrap();
    for count in [3_000_u64, 3_000_000, 3_000_000_000, 1 << 61] {
        for (view, stride) in [(0, 8), (1, 4), (2, 2)] {
            let mut json = json.clone();
            let count = if view == 2 { 3 * (count / 3) } else { count };
            json["bufferViews"][view]["byteLength"] = json!(count.wrapping_mul(stride));
            json["bufferViews"][view]["extensions"]["KHR_meshopt_compression"]["count"] = json!(count);
            let error = refusal(glb(&json.to_string(), &bin));
            assert!(matches!(error.problem, Problem::Limit | Problem::Range), "{count}, {view}: {error}");
        }
    }
    // The same bytes many times: four million zeros each time, of a few kilobytes.
    let encoding = VertexEncoding::new(0, 0).unwrap();
    let stream = encode_vertex_buffer(&vec![0; 4_000_000], 1_000_000, 4, encoding, &mut Workspace::default());
    let stream = stream.unwrap();
    let mut json = json!({"asset": {"version": "2.0"}});
    json["buffers"] = json!([{"byteLength": stream.len()}, {"byteLength": 0}]);
    let extension = json!({"buffer": 0, "byteLength": stream.len(), "byteStride": 4, "count": 1_000_000, "mode": "ATTRIBUTES"});
    let view =
        json!({"buffer": 1, "byteLength": 4_000_000, "extensions": {"KHR_meshopt_compression": extension}});
    let views = |count| vec![view.clone(); count];
    json["bufferViews"] = json!(views(100));
    assert_eq!(refusal(glb(&json.to_string(), &stream)).problem, Problem::Limit);
    json["bufferViews"] = json!(views(4));
    open(glb(&json.to_string(), &stream));
}

#[test]
fn contradictions_are_named() {
    let (text, bin) = chunks(&bytes("bracket-meshopt.glb"));
    let with = |from: &str, to: &str| refusal(glb(&text.replacen(from, to, 1), &bin)).to_string();
    let place = "/bufferViews/0/extensions/KHR_meshopt_compression";
    assert!(with("\"byteStride\":8,\"mode\"", "\"byteStride\":12,\"mode\"").contains(place));
    assert!(with("\"mode\":\"ATTRIBUTES\"", "\"mode\":\"SOMETHING\"").contains("SOMETHING"));
    assert!(with("\"filter\":\"OCTAHEDRAL\"", "\"filter\":\"UNKNOWN\"").contains("UNKNOWN"));
    assert!(with("\"byteLength\":285", "\"byteLength\":9285").contains("exceed the buffer"));
    let (text, bin) = chunks(&bytes("bracket-draco.glb"));
    let with = |from: &str, to: &str| refusal(glb(&text.replacen(from, to, 1), &bin)).to_string();
    assert!(with("\"NORMAL\":1}}", "\"NORMAL\":7}}").contains("no attribute 7"));
    assert!(with("\"mode\":4", "\"mode\":5").contains("only indexed triangles"));
    assert!(with("\"type\":\"VEC3\"", "\"type\":\"VEC2\"").contains("components"));
}

#[test]
fn counts_and_indices_follow_what_was_decoded() {
    // Exporters declare the vertices before seams split them.
    let (text, bin) = chunks(&bytes("bracket-draco.glb"));
    let text = text.replace("\"count\":84", "\"count\":36").replacen(
        "\"componentType\":5123",
        "\"componentType\":5121",
        1,
    );
    let written = change(&open(glb(&text, &bin)), Format::Glb, &WriteOptions::default());
    let json: Value = serde_json::from_str(&chunks(&written.bytes).0).unwrap();
    assert_eq!((&json["accessors"][1]["count"], &json["accessors"][2]["count"]), (&json!(84), &json!(84)));
    assert_eq!(json["accessors"][0]["componentType"], 5121, "84 vertices need one byte");
    assert_eq!(corners(&open(written.bytes)), corners(&open(bytes("bracket-draco.glb"))));
}
