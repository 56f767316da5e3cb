//! Editing glTF: only what must change changes, and the output reads back as intended.

use super::gltf::{Entry, entries, load};
use crease::io::gltf::edit;
use crease::io::{Format, Loaded, NormalFormat, OutputContent, Part, PartEdit, ReadOptions};
use crease::io::{TangentPolicy, WriteOptions, Written};
use crease::mesh::{Column, FaceEdit, NONE};
use glam::DVec3;
use std::path::Path;

/// One normal a face: every corner asks for its own, so that shared vertices must be split.
fn faceted(part: &Part) -> PartEdit {
    let mesh = &part.mesh;
    let corner = |c: u32| mesh.positions().at(mesh.faces().corners()[c as usize]);
    let faces = mesh.face_count() as u32;
    let normal = |face: u32| {
        let [a, b, c] = [0, 1, 2].map(|k| corner(3 * face + k));
        (b - a).cross(c - a).try_normalize().unwrap_or(DVec3::Z)
    };
    let index = (0..3 * faces).map(|corner| corner / 3).collect();
    let values: Vec<DVec3> = (0..faces).map(normal).collect();
    let morph_normals = vec![values.clone(); mesh.columns().morph_targets.len()];
    PartEdit { normals: Some(Column::per_corner(values, index)), morph_normals, ..PartEdit::default() }
}

/// One normal a vertex, pointing away from the middle: nothing is split.
fn rounded(part: &Part) -> PartEdit {
    let mesh = &part.mesh;
    if mesh.face_count() == 0 {
        return PartEdit::default();
    }
    let (low, high) = mesh.bounds().unwrap();
    let normal = |p: DVec3| (p - (low + high) / 2.0).try_normalize().unwrap_or(DVec3::Y);
    let values: Vec<DVec3> = mesh.positions().iter().map(normal).collect();
    let morph_normals = vec![values.clone(); mesh.columns().morph_targets.len()];
    PartEdit { normals: Some(Column::per_vertex(values)), morph_normals, ..PartEdit::default() }
}

fn all(loaded: &Loaded, one: fn(&Part) -> PartEdit) -> Vec<PartEdit> {
    loaded.parts.iter().map(one).collect()
}

fn good() -> impl Iterator<Item = (Entry, Loaded)> {
    let good = entries("gltf/").into_iter().filter(|entry| entry.expect.starts_with("load"));
    good.map(|entry| {
        let loaded = load(&entry.path).unwrap();
        (entry, loaded)
    })
}

fn document(loaded: &Loaded) -> &crease::io::gltf::GltfDocument {
    let crease::io::Document::Gltf(document) = &loaded.document else { panic!("no glTF") };
    document
}

fn write(loaded: &Loaded, edits: &[PartEdit], to: Format, options: &WriteOptions) -> Written {
    edit(document(loaded), loaded, edits, to, options).unwrap()
}

fn read(bytes: Vec<u8>, base: Option<&Path>) -> Loaded {
    crease::io::gltf::read(bytes, base, &ReadOptions::default()).unwrap()
}

/// Position and uv of every corner, by face, and the normal with it.
fn corners(part: &Part) -> Vec<(DVec3, Option<glam::DVec2>, Option<DVec3>)> {
    let columns = part.mesh.columns();
    let vertices = part.mesh.faces().corners();
    let corner = |(c, &v): (usize, &u32)| {
        let uv = columns.uvs.as_ref().and_then(|uvs| uvs.get(c, v)).copied();
        let normal = columns.normals.as_ref().and_then(|normals| normals.get(c, v)).copied();
        (part.mesh.positions().at(v), uv, normal)
    };
    vertices.iter().enumerate().map(corner).collect()
}

/// The chunks of a GLB: JSON and BIN.
fn chunks(bytes: &[u8]) -> (&[u8], &[u8]) {
    let word = |at: usize| u32::from_le_bytes(bytes[at..at + 4].try_into().unwrap()) as usize;
    let json = word(12);
    let bin = if bytes.len() > 20 + json { &bytes[28 + json..28 + json + word(20 + json)] } else { &[][..] };
    (&bytes[20..20 + json], bin)
}

#[test]
fn without_a_change_every_byte_stays() {
    for (entry, loaded) in good() {
        let nothing = vec![PartEdit::default(); loaded.parts.len()];
        let options = WriteOptions { stem: Some("out".into()), ..WriteOptions::default() };
        let written = write(&loaded, &nothing, loaded.format, &options);
        assert_eq!(written.bytes, std::fs::read(&entry.path).unwrap(), "{}", entry.name);
        assert!(
            written.companions.iter().all(|file| matches!(file.content, OutputContent::CopyOf(_))),
            "{}",
            entry.name
        );
        // The file's own normals, given back, are no change either.
        let own = |part: &Part| {
            let normals = part.mesh.columns().normals.clone();
            let kept = normals.as_ref().map_or(0, |normals| normals.values.len());
            let morph_normals = vec![vec![DVec3::X; kept]; part.mesh.columns().morph_targets.len()];
            PartEdit { normals, kept, morph_normals, ..PartEdit::default() }
        };
        let edits: Vec<PartEdit> = loaded.parts.iter().map(own).collect();
        let written = write(&loaded, &edits, loaded.format, &options);
        assert!(written.bytes == std::fs::read(&entry.path).unwrap(), "{}: own normals", entry.name);
    }
}

#[test]
fn normals_read_back_as_given_and_all_else_as_before() {
    for (entry, loaded) in good() {
        for (kind, split) in [(rounded as fn(&Part) -> PartEdit, false), (faceted, true)] {
            let edits = all(&loaded, kind);
            let result = edit(document(&loaded), &loaded, &edits, loaded.format, &WriteOptions::default());
            let written = match result {
                Err(error) if split && is_ordered(&entry, &error.to_string()) => continue,
                result => result.unwrap_or_else(|error| panic!("{}: {error}", entry.name)),
            };
            // New tangents may split vertices too.
            let has_tangents = entry.notes.contains("tangents=");
            assert!(split || has_tangents || written.added_vertices == 0, "{}", entry.name);
            let again = read(written.bytes.clone(), entry.path.parent());
            let vertices: usize = again.parts.iter().map(|part| part.mesh.vertex_count()).sum();
            assert!(vertices as u64 >= written.vertices || again.parts.len() > 1, "{}", entry.name);
            for ((old, new), edit) in loaded.parts.iter().zip(&again.parts).zip(&edits) {
                check_part(&entry.name, old, new, edit);
            }
            assert_eq!(loaded.nodes, again.nodes, "{}", entry.name);
            // Doing it again changes nothing.
            let second = write(&again, &all(&again, kind), again.format, &WriteOptions::default());
            assert!(second.bytes == written.bytes, "{}: a second run changes the file", entry.name);
        }
    }
}

/// Whether an error refuses to split vertices that an extension of the file counts.
fn is_ordered(entry: &Entry, error: &str) -> bool {
    let counting = ["EXT_mesh_manifold", "FB_ngon_encoding"];
    counting.iter().any(|name| entry.notes.contains(name) && error.contains(name))
}

fn check_part(name: &str, old: &Part, new: &Part, edit: &PartEdit) {
    assert_eq!(old.mesh.face_count(), new.mesh.face_count(), "{name}");
    assert_eq!(old.mesh.columns().materials, new.mesh.columns().materials, "{name}");
    let Some(normals) = &edit.normals else { return };
    let quantized = name.contains("quantized") || name.contains("meshopt");
    let tolerance = if quantized { 8e-3 } else { 1e-7 };
    for (c, (old_corner, new_corner)) in corners(old).iter().zip(corners(new)).enumerate() {
        let v = old.mesh.faces().corners()[c];
        assert_eq!((old_corner.0, old_corner.1), (new_corner.0, new_corner.1), "{name}: corner {c}");
        let (wanted, found) = (normals.get(c, v).unwrap(), new_corner.2.unwrap());
        assert!((*wanted - found).length() < tolerance, "{name}: corner {c} {wanted} {found}");
    }
    let (before, after) = (&old.mesh.columns().morph_targets, &new.mesh.columns().morph_targets);
    for (before, after) in before.iter().zip(after) {
        for (v, w) in old.mesh.faces().corners().iter().zip(new.mesh.faces().corners()) {
            assert_eq!(before[*v as usize], after[*w as usize], "{name}");
        }
    }
}

#[test]
fn appending_keeps_the_old_buffer_and_patching_touches_only_normals() {
    for (entry, loaded) in good().filter(|(entry, _)| entry.name.ends_with(".glb")) {
        let before = std::fs::read(&entry.path).unwrap();
        let (old_json, old_bin) = chunks(&before);
        for kind in [rounded as fn(&Part) -> PartEdit, faceted] {
            let Ok(written) =
                edit(document(&loaded), &loaded, all(&loaded, kind), Format::Glb, &WriteOptions::default())
            else {
                continue;
            };
            let (new_json, new_bin) = chunks(&written.bytes);
            assert!(new_bin.len() >= old_bin.len(), "{}", entry.name);
            let normals = normal_bytes(old_json);
            for (at, (old, new)) in old_bin.iter().zip(new_bin).enumerate() {
                assert!(old == new || normals.contains(&at), "{}: byte {at} of BIN changed", entry.name);
            }
            if old_json == new_json {
                assert_eq!(old_bin.len(), new_bin.len(), "{}", entry.name);
            }
            check_json(&entry.name, old_json, new_json);
        }
    }
}

/// All bytes of BIN that elements of NORMAL and TANGENT accessors take, found without the library's reader.
fn normal_bytes(json: &[u8]) -> std::collections::HashSet<usize> {
    let json: serde_json::Value = serde_json::from_slice(json).unwrap();
    let list = |value: &serde_json::Value| value.as_array().cloned().unwrap_or_default();
    let mut bytes = std::collections::HashSet::new();
    for primitive in list(&json["meshes"]).iter().flat_map(|mesh| list(&mesh["primitives"])) {
        let targets = list(&primitive["targets"]);
        let all = std::iter::once(&primitive["attributes"]).chain(&targets);
        for accessor in all.flat_map(|attributes| [&attributes["NORMAL"], &attributes["TANGENT"]]) {
            let Some(accessor) = accessor.as_u64() else { continue };
            let width = if json["accessors"][accessor as usize]["type"] == "VEC4" { 4 } else { 3 };
            let accessor = &json["accessors"][accessor as usize];
            let Some(view) = accessor["bufferView"].as_u64() else { continue };
            let view = &json["bufferViews"][view as usize];
            let size = match accessor["componentType"].as_u64().unwrap() {
                5120 => width,
                5122 => 2 * width,
                _ => 4 * width,
            };
            let number = |value: &serde_json::Value| value.as_u64().map(|n| n as usize);
            let start =
                number(&view["byteOffset"]).unwrap_or(0) + number(&accessor["byteOffset"]).unwrap_or(0);
            let stride = number(&view["byteStride"]).unwrap_or(size);
            for element in 0..number(&accessor["count"]).unwrap() {
                bytes.extend((0..size).map(|byte| start + element * stride + byte));
            }
        }
    }
    bytes
}

/// Members that an edit may change or add, by the last names of their paths.
fn may_change(path: &str) -> bool {
    let meshes = path.starts_with("/meshes/") && !path.contains("/extras");
    let geometry =
        meshes && ["/NORMAL", "/TANGENT", "/indices", "/mode"].iter().any(|end| path.ends_with(end));
    let moved = meshes && (path.contains("/attributes/") || path.contains("/targets/"));
    let data =
        path.starts_with("/accessors") || path.starts_with("/bufferViews") || path.starts_with("/buffers");
    geometry || moved || data
}

/// Asserts that every value outside those members keeps its text and its order.
fn check_json(name: &str, old: &[u8], new: &[u8]) {
    let leaves = |json: &[u8]| {
        let value: Box<serde_json::value::RawValue> = serde_json::from_slice(json).unwrap();
        let mut leaves = Vec::new();
        collect(&value, String::new(), &mut leaves);
        leaves.retain(|(path, _)| !may_change(path));
        leaves
    };
    assert_eq!(leaves(old), leaves(new), "{name}");
}

fn collect(value: &serde_json::value::RawValue, path: String, leaves: &mut Vec<(String, String)>) {
    let text = value.get();
    if text.starts_with('[') {
        let list: Vec<Box<serde_json::value::RawValue>> = serde_json::from_str(text).unwrap();
        list.iter()
            .enumerate()
            .for_each(|(number, value)| collect(value, format!("{path}/{number}"), leaves));
    } else if text.starts_with('{') {
        let members: std::collections::BTreeMap<String, Box<serde_json::value::RawValue>> =
            serde_json::from_str(text).unwrap();
        members.iter().for_each(|(key, value)| collect(value, format!("{path}/{key}"), leaves));
    } else {
        leaves.push((path, text.to_owned()));
    }
}

#[test]
fn faces_can_be_dropped_and_turned() {
    for (entry, loaded) in good().filter(|(entry, _)| !entry.notes.contains("manifold")) {
        let edits: Vec<PartEdit> = loaded
            .parts
            .iter()
            .map(|part| {
                let faces = part.mesh.face_count() as u32;
                let faces = FaceEdit {
                    dropped: (0..faces).filter(|face| face % 3 == 1).collect(),
                    reversed: (0..faces).filter(|face| face % 2 == 1).collect(),
                };
                PartEdit { faces, ..PartEdit::default() }
            })
            .collect();
        let result = edit(document(&loaded), &loaded, &edits, loaded.format, &WriteOptions::default());
        let written = result.unwrap_or_else(|error| panic!("{}: {error}", entry.name));
        let again = read(written.bytes, entry.path.parent());
        for ((old, new), edit) in loaded.parts.iter().zip(&again.parts).zip(&edits) {
            let wanted = corners(&Part { mesh: old.mesh.with_faces(&edit.faces), ..Part::default() });
            // A primitive that loses every face keeps one without area.
            let found: Vec<_> = corners(new);
            if wanted.len() == found.len() {
                assert_eq!(wanted, found, "{}", entry.name);
            } else {
                assert!(
                    found.chunks(3).any(|face| face[0].0 == face[1].0 && face[1].0 == face[2].0),
                    "{}",
                    entry.name
                );
            }
        }
    }
}

#[test]
fn the_other_spelling_says_the_same() {
    for (entry, loaded) in good() {
        let to = if loaded.format == Format::Glb { Format::Gltf } else { Format::Glb };
        let edits = all(&loaded, rounded);
        let written = write(&loaded, &edits, to, &WriteOptions::default());
        let again = read(written.bytes, None);
        assert_eq!(again.format, to, "{}", entry.name);
        for ((old, new), edit) in loaded.parts.iter().zip(&again.parts).zip(&edits) {
            check_part(&entry.name, old, new, edit);
        }
        // And back again.
        let nothing = vec![PartEdit::default(); again.parts.len()];
        let back = write(&again, &nothing, loaded.format, &WriteOptions::default());
        let back = read(back.bytes, None);
        for (new, back) in again.parts.iter().zip(&back.parts) {
            assert!(new.mesh == back.mesh, "{}", entry.name);
        }
    }
}

#[test]
fn stored_formats_follow_the_option() {
    let formats = [(NormalFormat::F32, 1e-7), (NormalFormat::I16, 3e-5), (NormalFormat::I8, 8e-3)];
    for (entry, loaded) in
        good().filter(|(entry, _)| entry.name.contains("quantized") || entry.name.contains("Box"))
    {
        for (normal_format, tolerance) in formats {
            let options = WriteOptions { normal_format, ..WriteOptions::default() };
            let edits = all(&loaded, rounded);
            let written = write(&loaded, &edits, loaded.format, &options);
            let required = String::from_utf8_lossy(&written.bytes).contains("\"extensionsRequired\"");
            assert!(required || normal_format == NormalFormat::F32, "{}", entry.name);
            let again = read(written.bytes, entry.path.parent());
            for (part, edit) in again.parts.iter().zip(&edits) {
                let (normals, wanted) =
                    (part.mesh.columns().normals.as_ref().unwrap(), edit.normals.as_ref().unwrap());
                for (a, b) in normals.values.iter().zip(&wanted.values) {
                    assert!((*a - *b).length() < tolerance, "{}: {a} {b}", entry.name);
                }
            }
        }
    }
}

#[test]
fn regenerated_tangents_agree_with_those_of_an_exporter() {
    for (entry, loaded) in good().filter(|(entry, _)| entry.name.contains("Lantern")) {
        // The same normals, but for one vertex: everything is written again.
        let nudged = |part: &Part| {
            let mut normals = part.mesh.columns().normals.clone().unwrap();
            let kept = normals.values.len();
            normals.values.push(DVec3::X);
            let corner_vertices = part.mesh.faces().corners();
            let mut index = normals.corner_index(corner_vertices);
            index[0] = kept as u32;
            PartEdit { normals: Some(Column::per_corner(normals.values, index)), kept, ..PartEdit::default() }
        };
        let edits: Vec<PartEdit> = loaded.parts.iter().map(nudged).collect();
        let options = WriteOptions { tangents: TangentPolicy::Regenerate, ..WriteOptions::default() };
        let old = tangents(
            &write(&loaded, &vec![PartEdit::default(); 3], Format::Gltf, &WriteOptions::default()).bytes,
        );
        let new = tangents(&write(&loaded, &edits, Format::Gltf, &options).bytes);
        let drop = WriteOptions { tangents: TangentPolicy::Drop, ..WriteOptions::default() };
        let dropped = tangents(&write(&loaded, &edits, Format::Gltf, &drop).bytes);
        assert!(dropped.is_empty());
        assert_eq!(old.len(), new.len());
        for (old, new) in old.iter().zip(&new) {
            let same = old.iter().zip(new).filter(|(a, b)| {
                let dot = a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
                a[3] == b[3] && dot > 0.9
            });
            // The other tool treats seams of the texture differently.
            let (same, count) = (same.count(), old.len());
            assert!(same * 100 > count * 90, "{}: {same} of {count}", entry.name);
            for tangent in new {
                let length =
                    (tangent[0] * tangent[0] + tangent[1] * tangent[1] + tangent[2] * tangent[2]).sqrt();
                assert!((length - 1.0).abs() < 1e-5 && tangent[3].abs() == 1.0, "{tangent:?}");
            }
        }
    }
}

/// The tangents of each primitive, read by the `gltf` crate from a document with embedded buffers.
fn tangents(json: &[u8]) -> Vec<Vec<[f32; 4]>> {
    let gltf = gltf::Gltf::from_slice(json).unwrap();
    let buffers = super::gltf::buffers(&gltf, Path::new(""));
    let primitives = gltf.meshes().flat_map(|mesh| mesh.primitives().collect::<Vec<_>>());
    let tangents = primitives.filter_map(|primitive| {
        let reader = primitive.reader(|buffer| buffers.get(buffer.index()).map(Vec::as_slice));
        reader.read_tangents().map(Iterator::collect)
    });
    tangents.collect()
}

#[test]
fn corners_of_the_files_own_normals_keep_their_bits() {
    for (entry, loaded) in good().filter(|(entry, _)| entry.name.contains("quantized")) {
        // One new normal in the first face, all others the file's own.
        let edits: Vec<PartEdit> = loaded
            .parts
            .iter()
            .map(|part| {
                let mut normals = part.mesh.columns().normals.clone().unwrap();
                let kept = normals.values.len();
                normals.values.push(DVec3::new(0.6, 0.0, 0.8));
                let mut index = normals.corner_index(part.mesh.faces().corners());
                index[0] = kept as u32;
                PartEdit {
                    normals: Some(Column::per_corner(normals.values, index)),
                    kept,
                    ..PartEdit::default()
                }
            })
            .collect();
        let written = write(&loaded, &edits, Format::Glb, &WriteOptions::default());
        let again = read(written.bytes, None);
        for (old, new) in loaded.parts.iter().zip(&again.parts) {
            let changed = corners(old).iter().zip(corners(new)).filter(|(a, b)| a.2 != b.2).count();
            assert_eq!(changed, 1, "{}", entry.name);
        }
        assert!(written.added_vertices <= loaded.parts.len() as u64, "{}", entry.name);
    }
}

#[test]
fn a_corner_without_a_normal_is_reported() {
    let Some((_, loaded)) = good().find(|(entry, _)| entry.name.contains("Fox")) else { return };
    let mut edits = all(&loaded, faceted);
    let mut index = edits[0].normals.as_ref().unwrap().corner_index(loaded.parts[0].mesh.faces().corners());
    index[4] = NONE;
    let values = edits[0].normals.take().unwrap().values;
    edits[0].normals = Some(Column::per_corner(values, index));
    let written = write(&loaded, &edits, Format::Glb, &WriteOptions::default());
    assert!(
        written
            .notes
            .iter()
            .any(|note| note.text == "1 corner has no new normal; the stored one was kept, or +Z written"),
        "{:?}",
        written.notes
    );
}

/// Found by fuzzing: the normals of faces were ignored, and the old ones stayed.
#[test]
fn face_normals_are_refused() {
    let data = Path::new(env!("CARGO_MANIFEST_DIR")).join("data/sphere-seam.glb");
    let loaded = crease::io::read(&data, None, &ReadOptions::default()).unwrap();
    let options = WriteOptions { emit: crease::io::Emit::Face, ..WriteOptions::default() };
    for to in [Format::Glb, Format::Gltf] {
        let error = crease::io::write(&loaded, &[], to, &options).unwrap_err().to_string();
        assert!(error.contains("no face normals"), "{error}");
    }
}
