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

/// The number of triangles that a file shows: those of a part count once for each of its nodes.
fn shown_triangles(loaded: &Loaded) -> usize {
    let triangles = |mesh: &Mesh| mesh.faces().ranges().map(|range| range.len() - 2).sum::<usize>();
    match loaded.nodes.is_empty() {
        true => loaded.parts.iter().map(|part| triangles(&part.mesh)).sum(),
        false => loaded.nodes.iter().map(|node| triangles(&loaded.parts[node.part].mesh)).sum(),
    }
}

/// Asserts that every corner has a unit normal. Returns the number of faces whose winding is opposite to one of their normals,
/// without faces whose height is below the rounding of their corners to `f32`.
fn check_normals(name: &str, loaded: &Loaded) -> usize {
    let mut turned = 0;
    for mesh in loaded.parts.iter().map(|part| &part.mesh) {
        let Some(normals) = &mesh.columns().normals else { continue };
        let largest = mesh.positions().iter().fold(0.0, |m: f64, p| m.max(p.abs().max_element()));
        for (face, range) in mesh.faces().ranges().enumerate() {
            let truth = face_normal(mesh, face);
            let corners: Vec<DVec3> =
                mesh.faces().face(face).iter().map(|&v| mesh.positions().at(v)).collect();
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

/// The number of triangles in fans of polygons that cross themselves; these may have any winding.
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
        // Some need extensions that crease refuses.
        let Ok(loaded) = io::read(path, None, &ReadOptions::default()) else { continue };
        for to in Format::WRITTEN
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
    // The largest ones would only take long.
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
            .flat_map(|part| part.mesh.faces().corners().iter().map(|&v| part.mesh.positions().at(v)))
            .collect();
        assert_eq!(corners.len(), 6);
        // The mirrored triangle still faces +z: its corners run 0, 2, 1.
        assert_eq!(
            corners[3..].iter().map(|p| [p.x, p.y]).collect::<Vec<_>>(),
            [[5., 0.], [5., 1.], [3., 0.]]
        );
    }
}

/// A node takes a few bytes and a copy of its mesh takes many, so formats without nodes limit the number of copies.
#[test]
fn instances_are_copied_within_reason() {
    let corners = 3000;
    let scene = |nodes: usize| {
        let list: Vec<String> = (0..nodes).map(|node| node.to_string()).collect();
        let text = format!(
            r#"{{"asset":{{"version":"2.0"}},"scene":0,"scenes":[{{"nodes":[{}]}}],"nodes":[{}],
            "meshes":[{{"primitives":[{{"attributes":{{"POSITION":0}}}}]}}],
            "accessors":[{{"componentType":5126,"count":{corners},"type":"VEC3","min":[0,0,0],"max":[0,0,0]}}]}}"#,
            list.join(","),
            vec!["{\"mesh\":0}"; nodes].join(",")
        );
        io::read_bytes(text.into_bytes(), None, None, &ReadOptions::default()).unwrap()
    };
    let few = scene(300);
    for to in [Format::Obj, Format::Ply, Format::Stl] {
        assert_eq!(shown_triangles(&write(&few, to)), 300 * corners / 3, "{to}");
    }
    let many = scene(50_000);
    for to in [Format::Obj, Format::Ply, Format::Stl] {
        let error = io::write(&many, &[], to, &WriteOptions::default()).unwrap_err().to_string();
        for piece in ["50000 nodes of 1 mesh", "49999 copies with 49999000 faces", "write .glb or .gltf"] {
            assert!(error.contains(piece), "{error}");
        }
    }
    assert!(io::write(&many, &[], Format::Glb, &WriteOptions::default()).is_ok());
}

fn notes(loaded: &Loaded, to: Format) -> Vec<String> {
    let written = io::write(loaded, &[], to, &WriteOptions::default()).unwrap();
    written.notes.iter().map(ToString::to_string).collect()
}

/// The JSON of a GLB.
fn json(glb: &[u8]) -> serde_json::Value {
    let length = u32::from_le_bytes(glb[12..16].try_into().unwrap()) as usize;
    serde_json::from_slice(&glb[20..20 + length]).unwrap()
}

#[test]
fn objects_and_materials_of_obj_become_those_of_gltf() {
    let work = tempfile::tempdir().unwrap();
    let library =
        "newmtl red\nKd 0.5 0.25 0\nNs 30\nmap_Kd a.png\nnewmtl plain\nnewmtl unused\nmap_Kd b.png\n";
    fs::write(work.path().join("m.mtl"), library).unwrap();
    for name in ["a.png", "b.png"] {
        fs::write(work.path().join(name), "").unwrap();
    }
    // Two squares in two objects, which share an edge with a dihedral angle of 30°.
    let obj = "mtllib m.mtl\nv 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv -0.866 0 0.5\nv -0.866 1 0.5\nv 9 9 9\n\
               o one\nusemtl red\nf 1 2 3 4\no two\nusemtl plain\nf 5 1 4 6\n";
    fs::write(work.path().join("a.obj"), obj).unwrap();
    let loaded = io::read(&work.path().join("a.obj"), None, &ReadOptions::default()).unwrap();
    let revision = crease::pipeline::revise(&loaded, &Default::default(), Some(Format::Glb), &|_| {});
    let written = io::write(&loaded, revision.edits, Format::Glb, &WriteOptions::default()).unwrap();
    let json = json(&written.bytes);
    let names = |list: &str| -> Vec<String> {
        json[list].as_array().unwrap().iter().map(|it| it["name"].as_str().unwrap().to_owned()).collect()
    };
    assert_eq!(
        (names("nodes"), names("meshes")),
        (vec!["one".into(), "two".into()], vec!["one".into(), "two".into()])
    );
    assert_eq!(names("materials"), ["red", "plain"]);
    let red = &json["materials"][0]["pbrMetallicRoughness"];
    assert_eq!(
        *red,
        serde_json::json!({"baseColorFactor": [0.5, 0.25, 0, 1], "metallicFactor": 0, "roughnessFactor": 0.5})
    );
    // Not a rough metal, which a material without members would be.
    let plain = serde_json::json!({"metallicFactor": 0, "roughnessFactor": 0.6});
    assert_eq!(json["materials"][1], serde_json::json!({"name": "plain", "pbrMetallicRoughness": plain}));
    let said: Vec<String> = written.notes.iter().map(ToString::to_string).collect();
    assert_eq!(
        said,
        [
            "omitted from materials: map_Kd (`a.png` is not a PNG or JPEG) of `red`",
            "omitted, because no object uses them: 1 vertex"
        ]
    );
    assert_eq!(
        (written.vertices, written.added_vertices),
        (8, 1),
        "two vertices are in both objects, one in none"
    );

    // The edge between the objects is smooth.
    let again = io::read_bytes(written.bytes, None, None, &ReadOptions::default()).unwrap();
    let at_origin: Vec<DVec3> = again
        .parts
        .iter()
        .map(|part| {
            let vertex = part.mesh.positions().iter().position(|p| p == DVec3::ZERO).unwrap();
            part.mesh.columns().normals.as_ref().unwrap().values[vertex]
        })
        .collect();
    assert_eq!(at_origin[0], at_origin[1]);
    // Halfway between the two planes, whose corners have the same angle.
    let (sine, cosine) = libm::sincos(15_f64.to_radians());
    let expected = DVec3::new(sine, 0.0, cosine);
    assert!(at_origin[0].distance(expected) < 1e-4, "{}", at_origin[0]);
}

#[test]
fn what_stays_behind_is_identified_by_name_and_only_then() {
    let ply = "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\nproperty float z\n\
               property float quality\nelement face 1\nproperty list uchar int vertex_indices\nproperty int flags\n\
               element camera 1\nproperty float view\nend_header\n0 0 0 1\n1 0 0 1\n0 1 0 1\n3 0 1 2 7\n5\n";
    let load =
        |text: &str| io::read_bytes(text.as_bytes().to_vec(), None, None, &ReadOptions::default()).unwrap();
    let loaded = load(ply);
    let left = "a new file has only the meshes; omitted: `quality` of the element `vertex`, `flags` of the \
                element `face`, the element `camera`";
    for to in [Format::Obj, Format::Glb] {
        assert_eq!(notes(&loaded, to), [left], "{to}");
    }
    let bare = load(
        "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\nproperty float z\n\
         element face 1\nproperty list uchar int vertex_indices\nend_header\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n",
    );
    assert_eq!(notes(&bare, Format::Glb), [""; 0]);

    let gltf = |more: &str, attributes: &str| {
        load(&format!(
            r#"{{"asset":{{"version":"2.0"}},{more}"nodes":[{{"mesh":0}}],
            "meshes":[{{"primitives":[{{"attributes":{{"POSITION":0{attributes}}}}}]}}],
            "accessors":[{{"componentType":5126,"count":3,"type":"VEC3","min":[0,0,0],"max":[0,0,0]}},
            {{"componentType":5126,"count":3,"type":"VEC2"}}]}}"#
        ))
    };
    assert_eq!(notes(&gltf("", ""), Format::Obj), [""; 0]);
    let full = gltf(
        r#""materials":[{"name":"m"}],"skins":[{"joints":[0]}],"animations":[{"channels":[],"samplers":[]},{"channels":[],"samplers":[]}],
        "extensionsUsed":["KHR_texture_transform","KHR_mesh_quantization"],"#,
        r#","TEXCOORD_0":1,"TEXCOORD_1":1"#,
    );
    let left = "a new file has only the meshes; omitted: properties of 1 material, 1 skin, 2 animations, the vertex attributes \
                TEXCOORD_1, the extensions KHR_texture_transform";
    let uvs = "texture coordinates were written without KHR_texture_transform";
    assert_eq!(notes(&full, Format::Obj), [left, uvs]);
    assert!(!notes(&full, Format::Stl).iter().any(|note| note == uvs), "it has none");

    let smooth = load("v 0 0 0\nv 1 0 0\nv 0 1 0\ns 1\nf 1 2 3\n");
    assert_eq!(notes(&smooth, Format::Glb), ["glTF has no smoothing groups; the normals keep their effect"]);
    assert!(notes(&smooth, Format::Ply)[0].contains("PLY has no smoothing groups"));
}

#[test]
fn positions_that_are_let_pass_are_reported() {
    let options = ReadOptions { non_finite: io::NonFinite::DropFaces, ..ReadOptions::default() };
    let obj = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv nan 0 0\nf 1 2 3\n";
    let loaded = io::read_bytes(obj.as_bytes().to_vec(), None, None, &options).unwrap();
    let said = loaded.notes[0].to_string();
    assert!(
        said.contains("1 vertex has no finite position (first: vertex 3") && said.contains("the origin"),
        "{said}"
    );
}

/// An OBJ may have texture coordinates at some corners only.
#[test]
fn corners_without_texture_coordinates_are_reported() {
    let obj = b"v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nvt 0.5 0.5\nf 1/1 2/1 3/1\nf 1 3 4\n".to_vec();
    let loaded = io::read_bytes(obj, Some(Format::Obj), None, &ReadOptions::default()).unwrap();
    let blank = |format: &str| {
        format!("3 corners without texture coordinates were written to the {format} with (0, 0)")
    };
    assert_eq!(notes(&loaded, Format::Glb), [blank("glTF")]);
    assert_eq!(notes(&loaded, Format::Ply), [blank("PLY")]);
    assert_eq!(notes(&loaded, Format::Obj), [] as [&str; 0]);
    // An object without texture coordinates has none in its own mesh.
    let obj = b"v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nvt 0.5 0.5\no a\nf 1/1 2/1 3/1\no b\nf 1 3 4\n".to_vec();
    let loaded = io::read_bytes(obj, Some(Format::Obj), None, &ReadOptions::default()).unwrap();
    assert_eq!(notes(&loaded, Format::Glb), [] as [&str; 0]);
    let glb = write(&loaded, Format::Glb);
    let have_uvs: Vec<bool> = glb.parts.iter().map(|part| part.mesh.columns().uvs.is_some()).collect();
    assert_eq!(have_uvs, [true, false]);
    assert!(notes(&loaded, Format::Ply).contains(&blank("PLY")));
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
