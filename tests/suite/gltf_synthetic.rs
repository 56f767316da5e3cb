//! glTF documents made for one point each.

use super::gltf::{entries, load};
use crease::io::gltf::{edit, read};
use crease::io::{Document, Format, Loaded, NormalFormat, OutputContent, Part, PartEdit, ReadOptions};
use crease::io::{TangentPolicy, WriteOptions, Written, write_new};
use crease::mesh::{Column, Columns, FaceLabels, Faces, MeshBuilder, NONE, Positions, Storage};
use glam::{DVec2, DVec3};
use std::path::Path;

fn parse(bytes: &[u8]) -> serde_json::Value {
    let glb = bytes.starts_with(b"glTF");
    let length = |at: usize| u32::from_le_bytes(bytes[at..at + 4].try_into().unwrap()) as usize;
    serde_json::from_slice(if glb { &bytes[20..20 + length(12)] } else { bytes }).unwrap()
}

fn open(bytes: &[u8]) -> Loaded {
    read(bytes.to_vec(), None, &ReadOptions::default()).unwrap_or_else(|error| panic!("{error}"))
}

fn change(
    loaded: &Loaded,
    edits: &[PartEdit],
    to: Format,
    options: &WriteOptions,
) -> Result<Written, String> {
    let Document::Gltf(document) = &loaded.document else { panic!("no glTF") };
    edit(document, loaded, edits, to, options).map_err(|error| error.to_string())
}

fn per_face(part: &Part) -> PartEdit {
    let faces = part.mesh.face_count() as u32;
    let values = vec![DVec3::X, DVec3::Y];
    let index = (0..3 * faces).map(|corner| corner / 3 % 2).collect();
    let morph_normals = vec![vec![DVec3::Y, DVec3::Z]; part.mesh.columns().morph_targets.len()];
    PartEdit { normals: Some(Column::per_corner(values, index)), morph_normals, ..PartEdit::default() }
}

fn up(part: &Part) -> PartEdit {
    let values = vec![DVec3::Z; part.mesh.vertex_count()];
    PartEdit { normals: Some(Column::per_vertex(values)), ..PartEdit::default() }
}

/// A square of two triangles, its buffer in the JSON. `primitive` and `root` are added to these objects.
fn square(primitive: &str, root: &str) -> Vec<u8> {
    use base64::Engine;
    let floats = [0.0_f32, 0.0, 0.0, 1.0, 0.0, 0.0, 1.0, 1.0, 0.0, 0.0, 1.0, 0.0];
    let mut bin: Vec<u8> = floats.iter().flat_map(|x| x.to_le_bytes()).collect();
    bin.extend([0_u8, 1, 2, 0, 2, 3, 0, 0]);
    let data = base64::engine::general_purpose::STANDARD.encode(&bin);
    format!(
        "{{\"asset\":{{\"version\":\"2.0\"}},\"meshes\":[{{\"primitives\":[{{\"attributes\":{{\"POSITION\":0}},\"indices\":1{primitive}}}]}}],\
         \"accessors\":[{{\"bufferView\":0,\"componentType\":5126,\"type\":\"VEC3\",\"count\":4,\"min\":[0,0,0],\"max\":[1,1,0]}},\
         {{\"bufferView\":1,\"componentType\":5121,\"type\":\"SCALAR\",\"count\":6}}],\
         \"bufferViews\":[{{\"buffer\":0,\"byteLength\":48}},{{\"buffer\":0,\"byteOffset\":48,\"byteLength\":6}}],\
         \"buffers\":[{{\"byteLength\":56,\"uri\":\"data:application/octet-stream;base64,{data}\"}}]{root}}}"
    )
    .into_bytes()
}

/// As a GLB without a BIN chunk.
fn without_bin(json: &[u8]) -> Vec<u8> {
    let mut text = json.to_vec();
    text.resize(text.len().next_multiple_of(4), b' ');
    let mut glb = b"glTF".to_vec();
    for word in [2, 20 + text.len() as u32, text.len() as u32, u32::from_le_bytes(*b"JSON")] {
        glb.extend(word.to_le_bytes());
    }
    glb.extend(text);
    glb
}

#[test]
fn a_split_copies_attributes_and_widens_nothing_it_need_not() {
    let loaded = open(&square("", ""));
    let written =
        change(&loaded, &[per_face(&loaded.parts[0])], Format::Gltf, &WriteOptions::default()).unwrap();
    assert_eq!((written.vertices, written.added_vertices), (6, 2));
    let json = parse(&written.bytes);
    assert_eq!(
        json["accessors"].as_array().unwrap().len(),
        3,
        "position and indices in place, normals added"
    );
    assert_eq!(json["accessors"][0]["count"], 6);
    assert_eq!(json["accessors"][0]["max"], serde_json::json!([1, 1, 0]));
    assert_eq!(json["accessors"][1]["componentType"], 5121);
    assert_eq!(json["buffers"].as_array().unwrap().len(), 2);
    let again = open(&written.bytes);
    let normals = again.parts[0].mesh.columns().normals.as_ref().unwrap();
    let corners = again.parts[0].mesh.faces().corners();
    let found: Vec<DVec3> = corners.iter().map(|&v| normals.values[v as usize]).collect();
    assert_eq!(found, [[DVec3::X; 3], [DVec3::Y; 3]].concat());
}

/// A strip of triangles, one vertex more each, with indices of one byte.
fn ribbon(triangles: u8) -> Vec<u8> {
    use base64::Engine;
    let vertices = usize::from(triangles) + 2;
    let positions = (0..vertices).flat_map(|i| [(i / 2) as f32, (i % 2) as f32, 0.0]);
    let mut bin: Vec<u8> = positions.flat_map(f32::to_le_bytes).collect();
    bin.extend((0..triangles).flat_map(|i| [i, i + 1 + i % 2, i + 2 - i % 2]));
    let (split, length) = (12 * vertices, bin.len());
    let data = base64::engine::general_purpose::STANDARD.encode(&bin);
    format!(
        "{{\"asset\":{{\"version\":\"2.0\"}},\"meshes\":[{{\"primitives\":[{{\"attributes\":{{\"POSITION\":0}},\"indices\":1}}]}}],\
         \"accessors\":[{{\"bufferView\":0,\"componentType\":5126,\"type\":\"VEC3\",\"count\":{vertices}}},\
         {{\"bufferView\":1,\"componentType\":5121,\"type\":\"SCALAR\",\"count\":{}}}],\
         \"bufferViews\":[{{\"buffer\":0,\"byteLength\":{split}}},{{\"buffer\":0,\"byteOffset\":{split},\"byteLength\":{}}}],\
         \"buffers\":[{{\"byteLength\":{length},\"uri\":\"data:;base64,{data}\"}}]}}",
        3 * usize::from(triangles),
        length - split
    )
    .into_bytes()
}

#[test]
fn indices_grow_when_vertices_no_longer_fit() {
    // 85 triangles with a vertex a corner have 255 vertices, which bytes can count; 86 have too many.
    for (triangles, component) in [(85, 5121), (86, 5123)] {
        let loaded = open(&ribbon(triangles));
        let corners = 3 * u32::from(triangles);
        let values = (0..corners).map(|i| DVec3::new(f64::from(i), 1.0, 0.0).normalize()).collect();
        let every = PartEdit {
            normals: Some(Column::per_corner(values, (0..corners).collect())),
            ..PartEdit::default()
        };
        let written =
            change(&loaded, std::slice::from_ref(&every), Format::Glb, &WriteOptions::default()).unwrap();
        assert_eq!(written.vertices, u64::from(corners));
        assert_eq!(parse(&written.bytes)["accessors"][1]["componentType"], component);
        let again = open(&written.bytes);
        assert_eq!(drawn(&again.parts[0]), drawn(&loaded.parts[0]));
    }
}

#[test]
fn a_glb_whose_buffer_is_in_the_json_gets_another_such_buffer() {
    let loaded = open(&without_bin(&square("", "")));
    assert_eq!(loaded.format, Format::Glb);
    let options = WriteOptions { stem: Some("x".into()), ..WriteOptions::default() };
    let written = change(&loaded, &[up(&loaded.parts[0])], Format::Glb, &options).unwrap();
    assert!(written.companions.is_empty());
    let json = parse(&written.bytes);
    assert!(json["buffers"][1]["uri"].as_str().unwrap().starts_with("data:"));
    assert!(open(&written.bytes).parts[0].mesh.columns().normals.is_some());
}

#[test]
fn external_buffers_are_left_alone_next_to_a_file_and_taken_in_for_a_stream() {
    let folder = tempfile::tempdir().unwrap();
    let plain = open(&square("", ""));
    let options = WriteOptions { stem: Some("in put".into()), ..WriteOptions::default() };
    let glb = change(&plain, &[PartEdit::default()], Format::Glb, &options).unwrap().bytes;
    let external = change(&open(&glb), &[PartEdit::default()], Format::Gltf, &options).unwrap();
    let OutputContent::Bytes(bin) = &external.companions[0].content else { panic!("no new file") };
    assert_eq!(external.companions[0].name, "in put.bin");
    std::fs::write(folder.path().join("in put.bin"), bin).unwrap();
    let text = String::from_utf8(external.bytes).unwrap();
    assert!(text.contains("\"in%20put.bin\""));
    let text = text.replacen(
        '{',
        "{\"images\":[{\"uri\":\"there.png\"},{\"uri\":\"gone.png\"},{\"uri\":\"../x.png\"}],",
        1,
    );
    std::fs::write(folder.path().join("there.png"), b"not opened").unwrap();
    let loaded = read(text.into_bytes(), Some(folder.path()), &ReadOptions::default()).unwrap();
    assert_eq!(loaded.notes.len(), 1, "{:?}", loaded.notes);

    let options = WriteOptions { stem: Some("out".into()), ..WriteOptions::default() };
    let written = change(&loaded, &[up(&loaded.parts[0])], Format::Gltf, &options).unwrap();
    let names: Vec<&str> = written.companions.iter().map(|file| file.name.as_str()).collect();
    assert_eq!(names, ["out.normals.bin", "in put.bin", "there.png"]);
    assert!(matches!(written.companions[0].content, OutputContent::Bytes(_)));
    assert!(
        matches!(&written.companions[1].content, OutputContent::CopyOf(path) if path.ends_with("in put.bin"))
    );

    // A second edit of the result must not write over the buffer that the first one made.
    let OutputContent::Bytes(normals) = &written.companions[0].content else { panic!("no new file") };
    std::fs::write(folder.path().join("out.normals.bin"), normals).unwrap();
    let again = read(written.bytes, Some(folder.path()), &ReadOptions::default()).unwrap();
    let twice = change(&again, &[per_face(&again.parts[0])], Format::Gltf, &options).unwrap();
    let names: Vec<&str> = twice.companions.iter().map(|file| file.name.as_str()).collect();
    assert_eq!(
        names,
        ["out.normals2.bin", "in put.bin", "there.png"],
        "the first one is not needed any more"
    );
    let OutputContent::Bytes(normals) = &twice.companions[0].content else { panic!("no new file") };
    std::fs::write(folder.path().join("out.normals2.bin"), normals).unwrap();
    let third = read(twice.bytes, Some(folder.path()), &ReadOptions::default()).unwrap();
    assert_eq!(third.parts[0].mesh.columns().normals.as_ref().unwrap().values.len(), 6);
    let thrice = change(&third, &[up(&third.parts[0])], Format::Gltf, &options).unwrap();
    assert_eq!(thrice.companions[0].name, "out.normals.bin", "two names take turns");

    let stream = change(&loaded, &[up(&loaded.parts[0])], Format::Gltf, &WriteOptions::default()).unwrap();
    assert!(stream.companions.is_empty());
    assert!(stream.notes.iter().any(|note| note.text.contains("there.png")));
    assert!(open(&stream.bytes).parts[0].mesh.columns().normals.is_some());
}

#[test]
fn extensions_that_count_vertices_allow_normals_and_refuse_splits() {
    let counting = [
        ("CESIUM_primitive_outline", ",\"extensions\":{\"CESIUM_primitive_outline\":{\"indices\":1}}"),
        (
            "EXT_mesh_primitive_edge_visibility",
            ",\"extensions\":{\"EXT_mesh_primitive_edge_visibility\":{\"visibility\":1}}",
        ),
        (
            "EXT_mesh_features",
            ",\"extensions\":{\"EXT_mesh_features\":{\"featureIds\":[{\"featureCount\":4}]}}",
        ),
    ];
    for (name, extension) in counting {
        let loaded = open(&square(extension, ""));
        let part = &loaded.parts[0];
        let whole = change(&loaded, &[up(part)], Format::Gltf, &WriteOptions::default()).unwrap();
        assert!(String::from_utf8(whole.bytes).unwrap().contains(extension));
        let error = change(&loaded, &[per_face(part)], Format::Gltf, &WriteOptions::default()).unwrap_err();
        assert!(error.contains(name), "{error}");
    }
    // Feature ids that are stored with the vertices are copied with them.
    let stored =
        ",\"extensions\":{\"EXT_mesh_features\":{\"featureIds\":[{\"featureCount\":4,\"attribute\":0}]}}";
    let loaded = open(&square(stored, ""));
    assert!(change(&loaded, &[per_face(&loaded.parts[0])], Format::Gltf, &WriteOptions::default()).is_ok());
}

#[test]
fn accessors_that_an_extension_may_mean_are_not_rewritten() {
    // The outline's indices are the primitive's own: dropping a face needs new ones, and the old must stay.
    let outline = ",\"extensions\":{\"CESIUM_primitive_outline\":{\"indices\":1}}";
    let loaded = open(&square(outline, ""));
    let faces = crease::mesh::FaceEdit { dropped: vec![0], reversed: vec![1] };
    let edits = [PartEdit { faces, ..PartEdit::default() }];
    let json = parse(&change(&loaded, &edits, Format::Gltf, &WriteOptions::default()).unwrap().bytes);
    assert_eq!(json["accessors"][1]["count"], 6);
    assert_eq!(json["meshes"][0]["primitives"][0]["indices"], 2);
    assert_eq!(json["accessors"][2]["count"], 3);
}

#[test]
fn a_draco_copy_goes_when_the_plain_data_change() {
    let draco = ",\"extensions\":{\"KHR_draco_mesh_compression\":{\"bufferView\":0,\"attributes\":{\"POSITION\":0}},\"X_y\":{}}";
    let loaded = open(&square(draco, ""));
    let written = change(&loaded, &[up(&loaded.parts[0])], Format::Gltf, &WriteOptions::default()).unwrap();
    let json = parse(&written.bytes);
    assert_eq!(json["meshes"][0]["primitives"][0]["extensions"], serde_json::json!({"X_y": {}}));
    assert!(written.notes.iter().any(|note| note.text.contains("Draco")));
    let compressed_only = String::from_utf8(square(draco, "")).unwrap().replacen(
        "\"bufferView\":0,\"componentType\"",
        "\"componentType\"",
        1,
    );
    let error = read(compressed_only.into_bytes(), None, &ReadOptions::default()).unwrap_err();
    assert!(error.to_string().contains("KHR_draco_mesh_compression"));
}

#[test]
fn required_extensions_are_known_harmless_or_refused() {
    let with = |name: &str| {
        read(square("", &format!(",\"extensionsRequired\":[\"{name}\"]")), None, &ReadOptions::default())
    };
    for harmless in [
        "KHR_texture_basisu",
        "KHR_materials_unlit",
        "KHR_mesh_quantization",
        "KHR_node_visibility",
        "KHR_physics_rigid_bodies",
        "KHR_animation_pointer",
        "EXT_texture_webp",
        "MSFT_lod",
        // Decompressed, or not used.
        "KHR_draco_mesh_compression",
        "EXT_meshopt_compression",
        // Refused only where a split would move what they number.
        "CESIUM_primitive_outline",
        "EXT_mesh_manifold",
    ] {
        assert!(with(harmless).is_ok(), "{harmless}");
    }
    for unknown in ["EXT_mesh_primitive_restart", "KHR_gaussian_splatting", "X_new"] {
        let error = with(unknown).unwrap_err();
        assert!(error.found.contains(unknown), "{error}");
        let allowed = ReadOptions { allowed_extensions: vec![unknown.to_owned()], ..ReadOptions::default() };
        let again = read(square("", &format!(",\"extensionsRequired\":[\"{unknown}\"]")), None, &allowed);
        assert!(again.is_ok(), "{unknown}");
    }
    assert!(with("X_new").unwrap_err().to_string().contains("--allow-extension X_new"));
}

#[test]
fn integers_for_normals_need_their_extension_once() {
    let loaded = open(&square("", ",\"extensionsUsed\":[\"KHR_mesh_quantization\"]"));
    for (normal_format, step) in [(NormalFormat::I8, 4), (NormalFormat::I16, 8)] {
        let options = WriteOptions { normal_format, ..WriteOptions::default() };
        let written = change(&loaded, &[up(&loaded.parts[0])], Format::Glb, &options).unwrap();
        let json = parse(&written.bytes);
        assert_eq!(json["extensionsUsed"], serde_json::json!(["KHR_mesh_quantization"]));
        assert_eq!(json["extensionsRequired"], serde_json::json!(["KHR_mesh_quantization"]));
        assert_eq!(json["bufferViews"][2]["byteStride"], step);
        assert_eq!(json["accessors"][2]["normalized"], true);
        let again = open(&written.bytes);
        assert_eq!(again.parts[0].mesh.columns().normals.as_ref().unwrap().values, [DVec3::Z; 4]);
    }
}

/// What comes from another format may be stored as integers as well; where there is no choice that is said.
#[test]
fn new_files_have_normals_in_the_format_that_is_asked_for() {
    let text =
        "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nvn 0 0.6 0.8\nvn 0.48 -0.6 0.64\nf 1//1 2//2 3//1\nf 1 3 4\n";
    let read = |bytes: Vec<u8>, format| {
        crease::io::read_bytes(bytes, Some(format), None, &ReadOptions::default()).unwrap()
    };
    let obj = read(text.as_bytes().to_vec(), Format::Obj);
    let normals = |loaded: &Loaded| {
        let mesh = &loaded.parts[0].mesh;
        let corners = mesh.faces().corners();
        let stored = mesh.columns().normals.as_ref().unwrap();
        [0, 1, 2].map(|corner| *stored.get(corner, corners[corner]).unwrap())
    };
    let before = normals(&obj);
    for (normal_format, step, tolerance) in [
        (NormalFormat::Same, None, 1e-7),
        (NormalFormat::F32, None, 1e-7),
        (NormalFormat::I16, Some(8), 3e-5),
        (NormalFormat::I8, Some(4), 8e-3),
    ] {
        let options = WriteOptions { normal_format, ..WriteOptions::default() };
        for format in [Format::Glb, Format::Gltf] {
            let written = crease::io::write(&obj, vec![], format, &options).unwrap();
            assert!(!written.notes.iter().any(|note| note.text.contains("choice")));
            if format == Format::Gltf {
                let json = parse(&written.bytes);
                let used = step.map(|_| serde_json::json!(["KHR_mesh_quantization"])).unwrap_or_default();
                assert_eq!((&json["extensionsUsed"], &json["extensionsRequired"]), (&used, &used));
                let accessor = &json["meshes"][0]["primitives"][0]["attributes"]["NORMAL"];
                let accessor = &json["accessors"][accessor.as_u64().unwrap() as usize];
                let view = &json["bufferViews"][accessor["bufferView"].as_u64().unwrap() as usize];
                assert_eq!(
                    (view["byteStride"].as_i64(), accessor["normalized"] == true),
                    (step, step.is_some())
                );
            }
            let after = normals(&read(written.bytes, format));
            let off = (0..3).map(|corner| (after[corner] - before[corner]).length()).fold(0.0, f64::max);
            assert!(off < tolerance, "{normal_format:?}: {off}");
            assert!(step.is_none() || off > 0.0, "{normal_format:?} is as exact as a float");
        }
        for format in [Format::Obj, Format::Ply] {
            let written = crease::io::write(&obj, vec![], format, &options).unwrap();
            let reported = written.notes.iter().any(|note| note.text.contains("only glTF has one"));
            assert_eq!(reported, normal_format != NormalFormat::Same, "{format}");
        }
    }
}

#[test]
fn morph_targets_get_the_difference_of_normals() {
    let bytes = std::fs::read(Path::new(env!("CARGO_MANIFEST_DIR")).join("data/morph.gltf")).unwrap();
    let loaded = open(&bytes);
    let part = &loaded.parts[0];
    let targets = part.mesh.columns().morph_targets.len();
    assert!(targets > 0);
    // Directions that single precision holds exactly, so that differences are exact too.
    let base = vec![DVec3::new(0.0, 0.6_f32.into(), 0.8_f32.into()); part.mesh.vertex_count()];
    let morph_normals: Vec<Vec<DVec3>> =
        (0..targets).map(|t| vec![[DVec3::X, DVec3::Y][t % 2]; base.len()]).collect();
    let edit = PartEdit { normals: Some(Column::per_vertex(base)), morph_normals, ..PartEdit::default() };
    for tangents in [TangentPolicy::Auto, TangentPolicy::Drop, TangentPolicy::Keep, TangentPolicy::Regenerate]
    {
        let options = WriteOptions { tangents, ..WriteOptions::default() };
        let written = change(&loaded, std::slice::from_ref(&edit), Format::Gltf, &options).unwrap();
        let gltf = gltf::Gltf::from_slice(&written.bytes).unwrap();
        let buffers = super::gltf::buffers(&gltf, Path::new(""));
        let primitive = gltf.meshes().next().unwrap().primitives().next().unwrap();
        let reader = primitive.reader(|buffer| buffers.get(buffer.index()).map(Vec::as_slice));
        for (target, (_, normals, _)) in reader.read_morph_targets().enumerate() {
            let wanted = [[1.0, -0.6_f32, -0.8_f32], [0.0, 1.0 - 0.6_f32, -0.8_f32]][target % 2];
            assert!(normals.unwrap().all(|delta| delta == wanted));
        }
    }
}

#[test]
fn a_new_file_has_all_that_meshes_have() {
    let positions = [[0, 0], [1, 0], [2, 0], [2, 1], [1, 1], [0, 1], [9, 9]]
        .map(|[x, y]| DVec3::new(f64::from(x), f64::from(y), 0.0));
    let mut faces = Faces::new();
    faces.push(&[0, 1, 4, 5]);
    faces.push(&[1, 2, 3, 4]);
    let normals = Column::per_corner(vec![DVec3::Z, DVec3::X], vec![0, 0, 0, 0, 1, 1, 1, NONE]);
    let columns = Columns {
        normals: Some(normals),
        uvs: Some(Column::per_corner(vec![DVec2::new(0.25, 1.0)], vec![0, 0, 0, 0, NONE, NONE, NONE, NONE])),
        colors: Some(vec![[0.5, 2.0, f32::NAN, 1.0]; 7]),
        materials: Some(FaceLabels { of_face: vec![0, NONE], names: vec!["red \"one\"".into()] }),
        points: vec![6],
        lines: vec![vec![0, 1], vec![1, 2, 3]],
        ..Columns::default()
    };
    let mesh = MeshBuilder { positions: positions.to_vec().into(), faces, columns }.build().unwrap();
    let part = Part { name: "ü/part".into(), mesh, ..Part::default() };
    let written = write_new(&[part, Part::default()], Format::Glb, &WriteOptions::default()).unwrap();
    let notes: Vec<String> = written.notes.iter().map(ToString::to_string).collect();
    assert_eq!(notes, ["4 corners without texture coordinates were written to the glTF with (0, 0)"]);
    let json = parse(&written.bytes);
    let primitives = json["meshes"][0]["primitives"].as_array().unwrap();
    assert_eq!(json["meshes"].as_array().unwrap().len(), 1, "a part without vertices is no mesh");
    assert_eq!(primitives.len(), 4, "a material, a face without normals, points, lines");
    assert_eq!(json["materials"][0]["name"], "red \"one\"");
    assert!(
        primitives[0]["attributes"]["NORMAL"].is_u64() && primitives[1]["attributes"]["NORMAL"].is_null()
    );
    assert_eq!((&primitives[2]["mode"], &primitives[3]["mode"]), (&0.into(), &1.into()));
    let again = open(&written.bytes);
    let columns = again.parts[0].mesh.columns();
    assert_eq!((again.parts[0].mesh.face_count(), again.parts[0].name.as_str()), (4, "ü/part"));
    // Primitives with other attributes have vertices of their own.
    let first = columns.points[0] - 6;
    assert_eq!(columns.lines, [[0, 1], [1, 2], [2, 3]].map(|line| line.map(|v| v + first)));
    assert_eq!(columns.colors.as_ref().unwrap()[0], [0.5, 1.0, 0.0, 1.0]);
    assert_eq!(columns.uvs.as_ref().unwrap().values[0], DVec2::new(0.25, 1.0), "turned over twice");
    let uv = json["accessors"][primitives[0]["attributes"]["TEXCOORD_0"].as_u64().unwrap() as usize].clone();
    assert_eq!(uv["type"], "VEC2");
}

#[test]
fn nothing_points_and_far_away_things_are_written_right() {
    let cloud = |positions: Vec<DVec3>, storage| {
        let mesh =
            MeshBuilder { positions: Positions::rounded(positions, storage), ..MeshBuilder::default() }
                .build()
                .unwrap();
        [Part { mesh, ..Part::default() }]
    };
    let empty = write_new(&[], Format::Gltf, &WriteOptions::default()).unwrap();
    assert!(open(&empty.bytes).parts.is_empty());
    let points =
        write_new(&cloud(vec![DVec3::ZERO, DVec3::ONE], Storage::F32), Format::Glb, &WriteOptions::default())
            .unwrap();
    assert_eq!(open(&points.bytes).parts[0].mesh.columns().points, [0, 1]);
    let beyond =
        write_new(&cloud(vec![DVec3::X * 1e39], Storage::F64), Format::Glb, &WriteOptions::default());
    assert!(beyond.unwrap_err().to_string().contains("1e39"));
    let near = [DVec3::new(0.1, 0.2, 0.3), DVec3::ONE];
    let far = near.map(|p| p + DVec3::splat(1e8));
    for (positions, warned) in [(near, false), (far, true)] {
        let written =
            write_new(&cloud(positions.to_vec(), Storage::F64), Format::Glb, &WriteOptions::default())
                .unwrap();
        assert_eq!(!written.notes.is_empty(), warned, "{:?}", written.notes);
    }
    let options = WriteOptions { stem: Some("a b".into()), ..WriteOptions::default() };
    let next_to = write_new(&cloud(near.to_vec(), Storage::F32), Format::Gltf, &options).unwrap();
    assert_eq!(next_to.companions[0].name, "a b.bin");
    assert_eq!(parse(&next_to.bytes)["buffers"][0]["uri"], "a%20b.bin");
}

/// Positions of the corners of all faces, each face turned to begin with its smallest corner, sorted.
fn drawn(part: &Part) -> Vec<[[u64; 3]; 3]> {
    let corner = |&v: &u32| part.mesh.positions().at(v).to_array().map(f64::to_bits);
    let mut faces: Vec<[[u64; 3]; 3]> = part
        .mesh
        .faces()
        .iter()
        .map(|face| {
            let mut corners = [corner(&face[0]), corner(&face[1]), corner(&face[2])];
            let first = (0..3).min_by_key(|&k| corners[k]).unwrap();
            corners.rotate_left(first);
            corners
        })
        .collect();
    faces.sort_unstable();
    faces
}

#[test]
fn ways_to_store_the_same_surface_agree() {
    let files = entries("gltf/");
    let find =
        |name: &str| load(&files.iter().find(|entry| entry.name.ends_with(name)).unwrap().path).unwrap();
    if files.is_empty() {
        return;
    }
    let (dense, sparse) = (find("roundedCube.glb"), find("roundedCube_sparse.glb"));
    assert_eq!(dense.parts[0].mesh, sparse.parts[0].mesh);
    assert_eq!(find("pirate_quantized.glb").parts[0].mesh.face_count(), 5010);
    let square = |number: &str| find(&format!("Mesh_PrimitiveMode_{number}.gltf")).parts.remove(0);
    // Lists without indices and with bytes, shorts and ints. The strip and the fan cut along either diagonal.
    let list = drawn(&square("06"));
    for other in ["13", "14", "15"] {
        assert_eq!(drawn(&square(other)), list, "{other}");
    }
    assert_eq!(drawn(&square("04")), drawn(&square("11")));
    assert_eq!(drawn(&square("05")), drawn(&square("12")));
    for number in ["04", "05", "06"] {
        let part = square(number);
        let normal = |face: &[u32]| {
            let [a, b, c] = [0, 1, 2].map(|k| part.mesh.positions().at(face[k]));
            (b - a).cross(c - a)
        };
        let area: DVec3 = part.mesh.faces().iter().map(normal).sum();
        assert_eq!(area / 2.0, DVec3::Z, "{number}: whole, and facing the viewer");
    }
}

#[test]
fn broken_normals_of_unused_vertices_do_not_stay_in_new_ones() {
    // Four vertices with normals of length 2, of which the triangle uses three.
    let columns = Columns {
        normals: Some(Column::per_vertex(vec![DVec3::X * 2.0; 4])),
        uvs: Some(Column::per_vertex(vec![DVec2::new(f64::NAN, 0.0); 4])),
        ..Columns::default()
    };
    let positions = vec![DVec3::ZERO, DVec3::X, DVec3::Y, DVec3::ONE];
    let faces = Faces::triangles(vec![0, 1, 2]);
    let mesh = MeshBuilder { positions: Positions::rounded(positions, Storage::F32), faces, columns }
        .build()
        .unwrap();
    let part = Part { mesh, ..Part::default() };
    let loaded = open(&write_new(&[part], Format::Glb, &WriteOptions::default()).unwrap().bytes);
    assert_eq!(loaded.parts[0].mesh.columns().uvs.as_ref().unwrap().values[0], DVec2::ZERO);
    let edit =
        PartEdit { normals: Some(Column::per_corner(vec![DVec3::Y], vec![0; 3])), ..PartEdit::default() };
    let written = change(&loaded, &[edit], Format::Glb, &WriteOptions::default()).unwrap();
    let normals = open(&written.bytes).parts[0].mesh.columns().normals.clone().unwrap();
    assert_eq!(normals.values, [DVec3::Y, DVec3::Y, DVec3::Y, DVec3::Z]);
}
