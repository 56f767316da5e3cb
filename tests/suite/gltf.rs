//! glTF and GLB: real files are read, broken ones are refused, and edits change nothing else.

use crease::io::gltf::read;
use crease::io::write_new;
use crease::io::{
    Format, Loaded, MaterialFallback, Part, Place, ReadError, ReadOptions, Severity, WriteOptions,
};
use std::fs;
use std::path::{Path, PathBuf};

/// A line of the manifest of real meshes.
pub struct Entry {
    pub path: PathBuf,
    pub name: String,
    vertices: Option<usize>,
    faces: Option<usize>,
    normals: String,
    pub notes: String,
    pub expect: String,
}

/// The glTF files of a folder of the real meshes; empty, with a message, if the meshes are not available.
pub fn entries(folder: &str) -> Vec<Entry> {
    let meshes = std::env::var_os("CREASE_MESHES")
        .map_or_else(|| Path::new(env!("CARGO_MANIFEST_DIR")).join("../shared/meshes"), PathBuf::from);
    let Ok(manifest) = fs::read_to_string(meshes.join("MANIFEST.tsv")) else {
        println!("skipped: the real meshes are not at {}", meshes.display());
        return Vec::new();
    };
    let mut lines = manifest.lines();
    let header: Vec<&str> = lines.next().unwrap().split('\t').collect();
    let column = |name: &str| header.iter().position(|&column| column == name).unwrap();
    let (file, vertices, faces) = (column("file"), column("verts"), column("faces"));
    let (normals, notes, expect) = (column("normals"), column("notes"), column("expect"));
    let rows = lines.map(|line| line.split('\t').collect::<Vec<_>>());
    let gltf = rows.filter(|row| {
        row[file].starts_with(folder) && (row[file].ends_with(".gltf") || row[file].ends_with(".glb"))
    });
    let entries: Vec<Entry> = gltf
        .map(|row| Entry {
            path: meshes.join(row[file]),
            name: row[file].to_owned(),
            vertices: row[vertices].parse().ok(),
            faces: row[faces].parse().ok(),
            normals: row[normals].to_owned(),
            notes: row[notes].to_owned(),
            expect: row[expect].to_owned(),
        })
        .collect();
    assert!(entries.len() > 20, "the manifest was not understood");
    entries
}

pub fn load(path: &Path) -> Result<Loaded, ReadError> {
    read(fs::read(path).unwrap(), path.parent(), &ReadOptions::default())
}

fn vertices(parts: &[Part]) -> usize {
    parts.iter().map(|part| part.mesh.vertex_count()).sum()
}

fn faces(parts: &[Part]) -> usize {
    parts.iter().map(|part| part.mesh.face_count()).sum()
}

#[test]
fn good_files_load_with_the_counts_of_the_manifest() {
    for entry in entries("gltf/") {
        let loaded = load(&entry.path);
        if entry.expect.starts_with("reject") {
            // The manifest is older than the decoders of Draco and meshopt: both are boxes.
            assert_eq!(faces(&loaded.unwrap().parts), 12, "{}", entry.name);
            continue;
        }
        if entry.expect.starts_with("either") && loaded.is_err() {
            continue;
        }
        let loaded = loaded.unwrap_or_else(|error| panic!("{}: {error}", entry.name));
        assert_eq!(Some(faces(&loaded.parts)), entry.faces, "{}: faces", entry.name);
        // The manifest counts a vertex once for each primitive, a part once for all primitives that share it.
        let shared = vertices(&loaded.parts);
        let counted = entry.vertices.unwrap();
        let shares =
            ["mode5_strips.gltf", "gltf_primitives.glb"].iter().any(|name| entry.name.ends_with(name));
        assert!(
            if shares { shared <= counted } else { shared == counted },
            "{}: {shared} of {counted}",
            entry.name
        );
        let with = loaded.parts.iter().filter(|part| part.mesh.columns().normals.is_some()).count();
        if entry.normals == "all" {
            let solid = loaded.parts.iter().filter(|part| part.mesh.face_count() > 0).count();
            assert_eq!(with, solid, "{}: normals", entry.name);
        } else if entry.normals == "no" {
            assert_eq!(with, 0, "{}: normals", entry.name);
        }
        if entry.notes.contains("morph=") {
            assert!(
                loaded.parts.iter().any(|part| !part.mesh.columns().morph_targets.is_empty()),
                "{}",
                entry.name
            );
        }
    }
}

#[test]
fn bad_files_fail_with_a_place_or_load() {
    for entry in entries("bad/") {
        let loaded = load(&entry.path);
        let name = &entry.name;
        match (entry.expect.split([' ', '(']).next().unwrap(), loaded) {
            ("reject", Ok(_)) => panic!("{name} was accepted"),
            ("load", Err(error)) => panic!("{name}: {error}"),
            (_, Err(error)) => {
                assert!(!error.found.is_empty() && !error.advice.is_empty(), "{name}: {error:?}");
                let placed = error.place != Place::File
                    || error.found.contains("glTF")
                    || error.found.contains("extension");
                assert!(placed, "{name}: no place in {error:?}");
            }
            ("load", Ok(loaded)) if entry.expect.contains("warning") => {
                let warned = loaded.notes.iter().any(|note| note.severity == Severity::Warning);
                assert!(warned, "{name}: no warning");
            }
            (_, Ok(_)) => {}
        }
    }
}

/// The same numbers, read by the `gltf` crate, for the files that it can read.
#[test]
fn positions_normals_and_indices_agree_with_the_gltf_crate() {
    let mut compared = 0;
    for entry in entries("gltf/") {
        // The crate ignores component types of quantised data and panics or reads garbage there.
        if entry.notes.contains("ext=") || entry.expect != "load" {
            continue;
        }
        let bytes = fs::read(&entry.path).unwrap();
        let Ok(document) = gltf::Gltf::from_slice(&bytes) else { continue };
        let buffers = buffers(&document, entry.path.parent().unwrap());
        let loaded = load(&entry.path).unwrap();
        for (mesh, part) in document.meshes().zip(&loaded.parts) {
            let primitives: Vec<_> = mesh.primitives().collect();
            let [primitive] = primitives.as_slice() else { continue };
            let reader = primitive.reader(|buffer| buffers.get(buffer.index()).map(Vec::as_slice));
            let theirs: Vec<[f64; 3]> = reader.read_positions().unwrap().map(|p| p.map(f64::from)).collect();
            let ours: Vec<[f64; 3]> = part.mesh.positions().iter().map(|p| p.to_array()).collect();
            assert_eq!(ours, theirs, "{}", entry.name);
            if primitive.mode() == gltf::mesh::Mode::Triangles {
                let count = theirs.len() as u32;
                let indices = reader
                    .read_indices()
                    .map_or_else(|| (0..count).collect(), |i| i.into_u32().collect::<Vec<_>>());
                assert_eq!(part.mesh.faces().corners(), indices, "{}", entry.name);
                let theirs: Option<Vec<[f64; 3]>> =
                    reader.read_normals().map(|n| n.map(|n| n.map(f64::from)).collect());
                let ours = part.mesh.columns().normals.as_ref();
                assert_eq!(
                    ours.map(|n| n.values.iter().map(|n| n.to_array()).collect()),
                    theirs,
                    "{}",
                    entry.name
                );
                compared += 1;
            }
        }
    }
    assert!(compared == 0 || compared > 20, "only {compared} meshes were compared");
}

pub fn buffers(document: &gltf::Gltf, folder: &Path) -> Vec<Vec<u8>> {
    use base64::Engine;
    let load = |buffer: gltf::Buffer<'_>| match buffer.source() {
        gltf::buffer::Source::Bin => document.blob.clone().unwrap(),
        gltf::buffer::Source::Uri(uri) => match uri.split_once(";base64,") {
            Some((_, data)) => base64::engine::general_purpose::STANDARD.decode(data).unwrap(),
            None => fs::read(folder.join(uri)).unwrap(),
        },
    };
    document.buffers().map(load).collect()
}

#[test]
fn a_new_file_loads_back_as_the_mesh_that_it_was_made_of() {
    for entry in entries("gltf/").into_iter().filter(|entry| entry.expect == "load") {
        let loaded = load(&entry.path).unwrap();
        let options = WriteOptions { material: MaterialFallback::Omit, ..WriteOptions::default() };
        for to in [Format::Glb, Format::Gltf] {
            let written = write_new(&loaded.parts, to, &options).unwrap();
            let again = read(written.bytes, None, &ReadOptions::default()).unwrap();
            assert!(again.notes.is_empty(), "{}: {:?}", entry.name, again.notes);
            let before = loaded.parts.iter().filter(|part| part.mesh.vertex_count() > 0);
            for (old, new) in before.zip(&again.parts) {
                assert_eq!(old.mesh.face_count(), new.mesh.face_count(), "{}", entry.name);
                assert_eq!(old.mesh.bounds(), new.mesh.bounds(), "{}", entry.name);
                assert_eq!(triangle_soup(old), triangle_soup(new), "{}", entry.name);
            }
        }
    }
}

/// What is drawn: material, position, normal and uv of every corner, whatever the numbering; sorted.
fn triangle_soup(part: &Part) -> Vec<(Option<&str>, [[u64; 8]; 3])> {
    let (mesh, columns) = (&part.mesh, part.mesh.columns());
    let corner = |c: usize| {
        let v = mesh.faces().corners()[c];
        let normal =
            columns.normals.as_ref().and_then(|normals| normals.get(c, v)).copied().unwrap_or_default();
        let uv = columns.uvs.as_ref().and_then(|uvs| uvs.get(c, v)).copied().unwrap_or_default();
        let [x, y, z] = mesh.positions().at(v).to_array().map(f64::to_bits);
        let [i, j, k] = normal.to_array().map(f64::to_bits);
        // Mirrored twice, v loses the digits that 1 - v cannot hold in single precision.
        [x, y, z, i, j, k, uv.x.to_bits(), (uv.y * 1e5).round().to_bits()]
    };
    let mut faces: Vec<_> = (0..mesh.face_count())
        .map(|face| {
            let material = columns.materials.as_ref().and_then(|m| m.names.get(m.of_face[face] as usize));
            (material.map(String::as_str), [0, 1, 2].map(|k| corner(3 * face + k)))
        })
        .collect();
    faces.sort_unstable();
    faces
}
