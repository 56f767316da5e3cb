//! From every format to every other.

use crate::flat::{face_normal, flat};
use crate::meshes::rows;
use crease::io::{self, Format, Loaded, PartEdit, ReadOptions, WriteOptions};
use crease::mesh::{Mesh, triangulate};
use glam::DVec3;
use std::fs;
use std::path::{Path, PathBuf};

fn write(loaded: &Loaded, to: Format) -> Loaded {
    let edits: Vec<PartEdit> = loaded.parts.iter().map(flat).collect();
    let written =
        io::write(loaded, &edits, to, &WriteOptions::default()).unwrap_or_else(|error| panic!("{error}"));
    io::read_bytes(written.bytes, Some(to), None, &ReadOptions::default())
        .unwrap_or_else(|error| panic!("{error}"))
}

/// Triangles that the file shows: those of each part as often as a node shows it.
fn shown_triangles(loaded: &Loaded) -> usize {
    let triangles = |mesh: &Mesh| mesh.faces().ranges().map(|range| range.len() - 2).sum::<usize>();
    match loaded.nodes.is_empty() {
        true => loaded.parts.iter().map(|part| triangles(&part.mesh)).sum(),
        false => loaded.nodes.iter().map(|node| triangles(&loaded.parts[node.part].mesh)).sum(),
    }
}

/// Every corner has a unit normal. Returns how many faces run the other way round than a normal of theirs says.
///
/// Faces whose height is less than what rounding to `f32` can move their corners by have no say.
fn check_normals(name: &str, loaded: &Loaded) -> usize {
    let mut turned = 0;
    for mesh in loaded.parts.iter().map(|part| &part.mesh) {
        let Some(normals) = &mesh.columns().normals else { continue };
        let largest = mesh.positions().iter().fold(0.0, |m: f64, p| m.max(p.abs().max_element()));
        for (face, range) in mesh.faces().ranges().enumerate() {
            let truth = face_normal(mesh, face);
            let corners: Vec<DVec3> =
                mesh.faces().face(face).iter().map(|&v| mesh.positions()[v as usize]).collect();
            let longest = corners.iter().map(|corner| corner.distance(corners[0])).fold(0.0, f64::max);
            let area = (corners[1] - corners[0]).cross(corners[2] - corners[0]).length();
            let is_thin = area <= 1e-5 * largest * longest;
            let of_corner = |corner| *normals.get(corner, mesh.faces().corners()[corner]).unwrap();
            for normal in range.clone().map(of_corner) {
                assert!((normal.length() - 1.0).abs() < 1e-6, "{name}: {normal}");
            }
            turned +=
                usize::from(!is_thin && range.into_iter().any(|corner| of_corner(corner).dot(truth) <= 0.0));
        }
    }
    turned
}

/// Triangles that are the fan of a polygon that crosses itself, which may run any way.
fn fan_triangles(loaded: &Loaded) -> usize {
    let fans = |mesh: &Mesh| {
        triangulate(mesh).failed.iter().map(|&face| mesh.faces().face(face as usize).len() - 2).sum::<usize>()
    };
    loaded.parts.iter().map(|part| fans(&part.mesh)).sum::<usize>() * loaded.nodes.len().max(1)
}

fn own_files() -> Vec<PathBuf> {
    let data = Path::new(env!("CARGO_MANIFEST_DIR")).join("data");
    let mut paths: Vec<_> = fs::read_dir(data).unwrap().map(|entry| entry.unwrap().path()).collect();
    paths.retain(|path| Format::from_path(path).is_some());
    paths.sort();
    paths
}

fn convert_all(paths: &[PathBuf]) {
    for path in paths {
        // Some are refused by name for their extensions.
        let Ok(loaded) = io::read(path, None, &ReadOptions::default()) else { continue };
        for to in Format::ALL
            .into_iter()
            .filter(|to| *to != loaded.format && !(to.is_gltf() && loaded.format.is_gltf()))
        {
            let name = format!("{} to {to}", path.file_name().unwrap().to_string_lossy());
            let again = write(&loaded, to);
            assert_eq!(shown_triangles(&again), shown_triangles(&loaded), "{name}");
            assert!(check_normals(&name, &again) <= fan_triangles(&loaded), "{name}");
        }
    }
}

#[test]
fn own_files_to_every_format() {
    let paths = own_files();
    assert!(paths.len() > 4);
    convert_all(&paths);
}

#[test]
fn real_files_to_every_format() {
    let all = rows("", &["obj", "ply", "stl", "STL", "gltf", "glb"]);
    let good =
        all.iter().filter(|row| !row.name().starts_with("bad/") && row.text("expect").starts_with("load"));
    // The largest ones only take long.
    let small = good.filter(|row| row.number("bytes") < 1_000_000);
    convert_all(&small.map(|row| row.path.clone()).collect::<Vec<_>>());
}

#[test]
fn a_mirrored_node_turns_faces_and_normals_together() {
    let text = r#"{"asset":{"version":"2.0"},"scene":0,"scenes":[{"nodes":[0,1]}],
        "nodes":[{"mesh":0,"name":"left"},{"mesh":0,"name":"right","scale":[-2,1,1],"translation":[5,0,0]}],
        "meshes":[{"primitives":[{"attributes":{"POSITION":0},"mode":4}]}],
        "accessors":[{"bufferView":0,"componentType":5126,"count":3,"type":"VEC3","min":[0,0,0],"max":[1,1,0]}],
        "bufferViews":[{"buffer":0,"byteLength":36}],
        "buffers":[{"byteLength":36,"uri":"data:application/octet-stream;base64,AAAAAAAAAAAAAAAAAACAPwAAAAAAAAAAAAAAAAAAgD8AAAAA"}]}"#;
    let loaded = io::read_bytes(text.as_bytes().to_vec(), None, None, &ReadOptions::default())
        .unwrap_or_else(|e| panic!("{e}"));
    for to in [Format::Obj, Format::Ply, Format::Stl] {
        let again = write(&loaded, to);
        assert_eq!(check_normals(&to.to_string(), &again), 0);
        let corners: Vec<_> = again
            .parts
            .iter()
            .flat_map(|part| part.mesh.faces().corners().iter().map(|&v| part.mesh.positions()[v as usize]))
            .collect();
        assert_eq!(corners.len(), 6);
        // The mirrored triangle still faces +z: its corners run 0, 2, 1.
        assert_eq!(
            corners[3..].iter().map(|p| [p.x, p.y]).collect::<Vec<_>>(),
            [[5., 0.], [5., 1.], [3., 0.]]
        );
    }
}

#[test]
fn points_and_lines_go_where_they_can() {
    let obj = b"v 0 0 0\nv 1 0 0\nv 1 1 0\nl 1 2 3\np 1\n".to_vec();
    let loaded = io::read_bytes(obj.clone(), Some(Format::Obj), None, &ReadOptions::default()).unwrap();
    assert_eq!(io::write(&loaded, &[], Format::Obj, &WriteOptions::default()).unwrap().bytes, obj);
    let ply = write(&loaded, Format::Ply);
    assert_eq!(ply.parts[0].mesh.columns().lines, [[0, 1], [1, 2]]);
    let glb = write(&loaded, Format::Glb);
    assert_eq!(glb.parts[0].mesh.columns().lines.concat().len(), 3);
    let stl = io::write(&loaded, &[], Format::Stl, &WriteOptions::default()).unwrap();
    assert_eq!(stl.bytes.len(), 84);
    let texts: Vec<_> = stl.notes.iter().map(|note| note.text.as_str()).collect();
    assert!(
        texts.iter().any(|text| text.contains("no points"))
            && texts.iter().any(|text| text.contains("no lines"))
    );
}
