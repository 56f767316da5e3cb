//! Images of materials: from MTL to glTF, and from glTF to MTL.

use crease::io::{
    self, FileReflection, Format, Loaded, OutputContent, PartEdit, ReadOptions, TangentPolicy, WriteOptions,
    Written, read, read_bytes,
};
use serde_json::{Value, json};
use std::fs;
use std::path::Path;

/// The header of a PNG of one pixel, of a colour type.
fn png(colour_type: u8) -> Vec<u8> {
    let mut png = b"\x89PNG\r\n\x1a\n\0\0\0\x0dIHDR\0\0\0\x01\0\0\0\x01\x08".to_vec();
    png.extend([colour_type, 0, 0, 0, 0, 0, 0, 0]);
    png
}

const JPEG: &[u8] = b"\xff\xd8\xff\xe0 jpeg";

const SQUARE: &str = "mtllib m.mtl\nv 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nvt 0 0\nvt 1 0\nvt 1 1\nvt 0 1\n\
                      usemtl m\nf 1/1 2/2 3/3\nf 1/1 3/3 4/4\n";

/// A folder with an OBJ, its library and images.
fn folder(obj: &str, library: &str) -> tempfile::TempDir {
    let folder = tempfile::tempdir().unwrap();
    fs::create_dir(folder.path().join("maps")).unwrap();
    for (name, bytes) in [
        ("a.obj", obj.as_bytes()),
        ("m.mtl", library.as_bytes()),
        ("maps/a b.png", &png(2)),
        ("grey.png", &png(0)),
        ("n.jpg", JPEG),
        ("picture", JPEG),
        ("t.tga", b"tga"),
        ("cut.png", &png(2)[..20]),
    ] {
        fs::write(folder.path().join(name), bytes).unwrap();
    }
    folder
}

fn written(folder: &Path, to: Format, stem: Option<&str>) -> Written {
    let loaded = read(&folder.join("a.obj"), None, &ReadOptions::default()).unwrap();
    convert(&loaded, to, stem)
}

fn convert(loaded: &Loaded, to: Format, stem: Option<&str>) -> Written {
    let options = WriteOptions { stem: stem.map(str::to_owned), ..WriteOptions::default() };
    io::write(loaded, &[], to, &options).unwrap()
}

fn notes(written: &Written) -> Vec<String> {
    let notes = written.notes.iter().map(ToString::to_string);
    notes.filter(|note| note.starts_with("omitted from materials")).collect()
}

/// The JSON and the binary chunk of a GLB.
fn glb(bytes: &[u8]) -> (Value, &[u8]) {
    let length = u32::from_le_bytes(bytes[12..16].try_into().unwrap()) as usize;
    (serde_json::from_slice(&bytes[20..20 + length]).unwrap(), &bytes[28 + length..])
}

/// The bytes of an image of a GLB.
fn embedded<'a>((document, bin): &(Value, &'a [u8]), image: usize) -> &'a [u8] {
    let view = &document["bufferViews"][document["images"][image]["bufferView"].as_u64().unwrap() as usize];
    let start = view["byteOffset"].as_u64().unwrap() as usize;
    &bin[start..start + view["byteLength"].as_u64().unwrap() as usize]
}

#[test]
fn images_of_mtl_are_embedded_or_copied() {
    let library = "newmtl m\nKd 0.5 0.25 1\nmap_Kd maps/a b.png\nnorm -bm 0.5 n.jpg\n";
    let folder = folder(SQUARE, library);
    let output = written(folder.path(), Format::Glb, Some("out"));
    assert_eq!(notes(&output), [""; 0]);
    assert!(output.companions.is_empty());
    let file = glb(&output.bytes);
    assert_eq!(
        file.0["materials"][0],
        json!({"name": "m", "normalTexture": {"index": 1, "scale": 0.5}, "pbrMetallicRoughness":
            {"baseColorFactor": [0.5, 0.25, 1, 1], "baseColorTexture": {"index": 0}, "metallicFactor": 0}})
    );
    assert_eq!(file.0["textures"], json!([{"source": 0}, {"source": 1}]));
    let types: Vec<_> = (0..2).map(|image| file.0["images"][image]["mimeType"].as_str().unwrap()).collect();
    assert_eq!(types, ["image/png", "image/jpeg"]);
    assert_eq!((embedded(&file, 0), embedded(&file, 1)), (&*png(2), JPEG));
    read_bytes(output.bytes, None, None, &ReadOptions::default()).unwrap();

    let output = written(folder.path(), Format::Gltf, Some("out"));
    let document: Value = serde_json::from_slice(&output.bytes).unwrap();
    assert_eq!(document["images"], json!([{"uri": "maps/a%20b.png"}, {"uri": "n.jpg"}]));
    let copies = output.companions.iter().filter_map(|file| match &file.content {
        OutputContent::CopyOf(path) => Some((&*file.name, fs::read(path).unwrap())),
        OutputContent::Bytes(_) => None,
    });
    let copies: Vec<_> = copies.collect();
    assert_eq!(copies, [("maps/a b.png", png(2)), ("n.jpg", JPEG.to_vec())]);

    // A stream has no folder for files.
    let output = written(folder.path(), Format::Gltf, None);
    assert!(output.companions.is_empty());
    let document: Value = serde_json::from_slice(&output.bytes).unwrap();
    assert_eq!(document["images"][1]["mimeType"], "image/jpeg");
}

#[test]
fn what_does_not_become_a_texture_is_named() {
    let image = |library: &str, obj: &str| {
        let folder = folder(obj, &format!("newmtl m\n{library}"));
        let output = written(folder.path(), Format::Glb, Some("out"));
        let images = glb(&output.bytes).0["images"].as_array().map_or(0, Vec::len);
        (images, notes(&output).join("; "))
    };
    let from = |what: &str| format!("omitted from materials: {what} of `m`");
    for (statement, images, what) in [
        ("map_Kd t.tga", 0, "map_Kd (`t.tga` is not a PNG or JPEG)"),
        ("map_Kd cut.png", 0, "map_Kd (`cut.png` is not a PNG or JPEG)"),
        ("map_Kd gone.png", 0, "map_Kd (`gone.png` was not read)"),
        ("map_Kd ../../etc/passwd", 0, "map_Kd (`../../etc/passwd` was not read)"),
        ("map_Ks n.jpg", 0, "map_Ks"),
        ("map_Kd -s 2 2 n.jpg", 1, "-s of map_Kd"),
        ("map_Bump grey.png", 0, "map_Bump (`grey.png` is a height map, not a normal map)"),
        ("norm n.jpg\nbump maps/a b.png", 1, "map_Bump"),
        (
            "Ka 0.1 0 0\nKs 0.5\nKe 1 1 1\nNi 1.5\nTf 1 0.5 0\nillum 7\nPm 0.3\n# a",
            0,
            "Ka, Ke, Ks, Ni, Pm, Tf, illum",
        ),
        (
            "Kd xyz 0.1 0.2 0.3\nKs spectral a.rfl\nNs -5\nd -halo 0.4\nmap_aat on",
            0,
            "Kd (not understood), Ks (not understood), Ns (not understood), d (not understood), map_aat",
        ),
        ("Ka 0 0 0\nKs 0 0 0\nNi 1\nTf 1 1 1\nillum 2\nPr 0\nsharpness 60", 0, "sharpness"),
    ] {
        assert_eq!(image(statement, SQUARE), (images, from(what)), "{statement}");
    }
    assert_eq!(image("norm grey.png", SQUARE), (1, String::new()), "named a normal map");
    assert_eq!(image("map_Bump n.jpg", SQUARE), (1, String::new()));
    let without = SQUARE.replace("/1", "").replace("/2", "").replace("/3", "").replace("/4", "");
    let what = from("`n.jpg` (a mesh has no texture coordinates)");
    assert_eq!(image("map_Kd n.jpg", &without), (0, what));
}

#[test]
fn images_count_for_the_size_limit() {
    let folder = folder(SQUARE, "newmtl m\nmap_Kd n.jpg\n");
    let mut options = ReadOptions::default();
    options.limits.bytes = SQUARE.len() as u64;
    fs::write(folder.path().join("n.jpg"), [JPEG, &[0; 500]].concat()).unwrap();
    let loaded = read(&folder.path().join("a.obj"), None, &options).unwrap();
    let what = "omitted from materials: map_Kd (`n.jpg` exceeds the size limit of one input) of `m`";
    assert_eq!(notes(&convert(&loaded, Format::Glb, None)), [what]);
}

/// Two materials have the same file, and another has one of the same name in another folder.
#[test]
fn an_image_is_stored_once() {
    let library = "newmtl m\nmap_Kd n.jpg\nnewmtl o\nmap_Kd n.jpg\nnewmtl p\nmap_Kd picture\n";
    let obj = format!("{SQUARE}usemtl o\nf 1/1 2/2 4/4\nusemtl p\nf 2/2 3/3 4/4\n");
    let folder = folder(&obj, library);
    let output = written(folder.path(), Format::Gltf, Some("out"));
    let document: Value = serde_json::from_slice(&output.bytes).unwrap();
    assert_eq!(document["images"], json!([{"uri": "n.jpg"}, {"uri": "picture.jpg"}]));
    let index = |material: usize| {
        document["materials"][material]["pbrMetallicRoughness"]["baseColorTexture"]["index"].as_u64()
    };
    assert_eq!([0, 1, 2].map(index), [Some(0), Some(0), Some(1)]);
}

#[test]
fn images_of_gltf_become_those_of_mtl() {
    let folder =
        folder(SQUARE, "newmtl m\nKd 0.5 0.25 1\nNs 30\nd 0.5\nmap_Kd maps/a b.png\nnorm -bm 0.5 n.jpg\n");
    let glb = written(folder.path(), Format::Glb, Some("out")).bytes;
    let loaded = read_bytes(glb, None, None, &ReadOptions::default()).unwrap();
    let output = convert(&loaded, Format::Obj, Some("back"));
    assert!(!output.notes.iter().any(|note| note.to_string().contains("texture")), "{:?}", output.notes);
    let names: Vec<&str> = output.companions.iter().map(|file| &*file.name).collect();
    assert_eq!(names, ["back.mtl", "back.image0.png", "back.image1.jpg"]);
    let work = tempfile::tempdir().unwrap();
    for file in &output.companions {
        let OutputContent::Bytes(bytes) = &file.content else { panic!("{}", file.name) };
        fs::write(work.path().join(&file.name), bytes).unwrap();
    }
    fs::write(work.path().join("back.obj"), &output.bytes).unwrap();
    let text = fs::read_to_string(work.path().join("back.mtl")).unwrap();
    assert!(text.ends_with(
        "newmtl m\nKd 0.5 0.25 1\nNs 30\nd 0.5\nmap_Kd back.image0.png\nnorm -bm 0.5 back.image1.jpg\n"
    ));
    let again = read(&work.path().join("back.obj"), None, &ReadOptions::default()).unwrap();
    assert!(again.notes.is_empty(), "{:?}", again.notes);
    let material = &again.appearance().materials[0];
    let FileReflection::Phong { diffuse, exponent, .. } = material.reflection else { panic!("Phong") };
    assert_eq!((diffuse, exponent, material.opacity), (Some([0.5, 0.25, 1.0]), Some(30.0), Some(0.5)));
    let normal = material.images.normal.as_ref().unwrap();
    assert_eq!((&*normal.name, normal.scale), ("back.image1.jpg", 0.5));
    assert_eq!(fs::read(work.path().join("back.image0.png")).unwrap(), png(2));

    // A stream has no library.
    let output = convert(&loaded, Format::Obj, None);
    assert!(output.companions.is_empty() && !output.bytes.windows(6).any(|word| word == b"mtllib"));
}

#[test]
fn what_mtl_lacks_is_named() {
    let document = |material: &str, images: &str| {
        let text = format!(
            r#"{{"asset":{{"version":"2.0"}},"nodes":[{{"mesh":0}}],"meshes":[{{"primitives":[{{"attributes":{{"POSITION":0}},
            "material":0}}]}}],"accessors":[{{"componentType":5126,"count":3,"type":"VEC3","min":[0,0,0],"max":[0,0,0]}}],
            "materials":[{{"name":"m",{material}}}],"textures":[{{"source":0}}],"images":[{images}]}}"#
        );
        let loaded =
            read_bytes(text.into_bytes(), Some(Format::Gltf), None, &ReadOptions::default()).unwrap();
        notes(&convert(&loaded, Format::Obj, Some("out"))).join("; ")
    };
    let texture = r#""pbrMetallicRoughness":{"metallicFactor":0,"baseColorTexture":{"index":0}}"#;
    for (material, images, what) in [
        (r#""pbrMetallicRoughness":{}"#, "", "metallicFactor of `m`"),
        (texture, "", "baseColorTexture (has no PNG or JPEG) of `m`"),
        (texture, r#"{"uri":"data:,x"}"#, "baseColorTexture (is not a PNG or JPEG) of `m`"),
        (texture, r#"{"uri":"http://host/a.png"}"#, "baseColorTexture (is not a file in this folder) of `m`"),
        (texture, r#"{"uri":"../a.png"}"#, "baseColorTexture (was not found) of `m`"),
        (
            r#""pbrMetallicRoughness":{"metallicFactor":0},"doubleSided":true,"alphaMode":"OPAQUE","emissiveFactor":[1,1,1],
            "extensions":{"KHR_materials_unlit":{}}"#,
            "",
            "doubleSided, emissiveFactor, KHR_materials_unlit of `m`",
        ),
    ] {
        let images = if images.is_empty() { r#"{"bufferView":7}"# } else { images };
        let what = what.replace("has no PNG or JPEG", "has no data");
        assert_eq!(document(material, images), format!("omitted from materials: {what}"), "{material}");
    }
    assert_eq!(document(r#""pbrMetallicRoughness":{"metallicFactor":0}"#, ""), "");
}

/// The official validator warns of data URIs in a GLB.
#[test]
fn images_in_data_uris_move_into_a_glb() {
    let uri =
        |bytes: &[u8]| bytes.iter().fold("data:image/x,".to_owned(), |uri, byte| format!("{uri}%{byte:02X}"));
    let document = |buffers: &str| {
        let text = format!(
            r#"{{"asset":{{"version":"2.0"}},{buffers}"images":[{{"uri":"{}","name":"one"}},{{"uri":"data:,text"}},
            {{"mimeType":"image/jpeg","uri":"{}"}}]}}"#,
            uri(&png(2)),
            uri(JPEG)
        );
        read_bytes(text.into_bytes(), Some(Format::Gltf), None, &ReadOptions::default()).unwrap()
    };
    let view =
        r#""buffers":[{"byteLength":3,"uri":"data:,abc"}],"bufferViews":[{"buffer":0,"byteLength":3}],"#;
    for (buffers, first) in [("", 0), (view, 1)] {
        let output = convert(&document(buffers), Format::Glb, None);
        let file = glb(&output.bytes);
        assert_eq!(
            file.0["images"],
            json!([{"name": "one", "bufferView": first, "mimeType": "image/png"}, {"uri": "data:,text"},
                {"mimeType": "image/jpeg", "bufferView": first + 1}])
        );
        assert_eq!((embedded(&file, 0), embedded(&file, 2)), (&*png(2), JPEG));
        assert_eq!(file.0["buffers"].as_array().unwrap().len(), 1);
        read_bytes(output.bytes, None, None, &ReadOptions::default()).unwrap();
    }
}

/// The tangents that a GLB has at its vertices, by position and u.
fn tangents((document, bin): &(Value, &[u8])) -> Vec<([f32; 3], f32, [f32; 4])> {
    let attributes = &document["meshes"][0]["primitives"][0]["attributes"];
    let floats = |name: &str, width: usize| -> Vec<f32> {
        let accessor = &document["accessors"][attributes[name].as_u64().unwrap() as usize];
        let view = &document["bufferViews"][accessor["bufferView"].as_u64().unwrap() as usize];
        let start = view["byteOffset"].as_u64().unwrap() as usize;
        let length = 4 * width * accessor["count"].as_u64().unwrap() as usize;
        bin[start..start + length]
            .chunks(4)
            .map(|four| f32::from_le_bytes(four.try_into().unwrap()))
            .collect()
    };
    let (places, uvs, tangents) = (floats("POSITION", 3), floats("TEXCOORD_0", 2), floats("TANGENT", 4));
    let vertices = places.chunks(3).zip(uvs.chunks(2)).zip(tangents.chunks(4));
    vertices.map(|((p, uv), t)| (p.try_into().unwrap(), uv[0], t.try_into().unwrap())).collect()
}

/// Two squares, the second of which mirrors the texture. They share the vertices, the normals and the texture coordinates of their
/// edge, and differ there in tangent alone.
const MIRRORED: &str = "mtllib m.mtl\nv 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv 2 0 0\nv 2 1 0\nvt 0 0\nvt 1 0\nvt 1 1\n\
                        vt 0 1\nvn 0 0 1\nusemtl m\nf 1/1/1 2/2/1 3/3/1 4/4/1\nf 2/2/1 5/1/1 6/4/1 3/3/1\n";

#[test]
fn new_files_have_tangents_for_normal_textures() {
    let folder = folder(MIRRORED, "newmtl m\nnorm n.jpg\n");
    let output = written(folder.path(), Format::Glb, None);
    let vertices = tangents(&glb(&output.bytes));
    assert_eq!(vertices.len(), 8, "{vertices:?}");
    for ([x, ..], _, tangent) in &vertices {
        // The picture is upright: u rises with x on the left square, and falls on the right one.
        let expected: &[[f32; 4]] = match *x {
            0.0 => &[[1.0, 0.0, 0.0, 1.0]],
            1.0 => &[[1.0, 0.0, 0.0, 1.0], [-1.0, 0.0, 0.0, -1.0]],
            _ => &[[-1.0, 0.0, 0.0, -1.0]],
        };
        assert!(expected.contains(tangent), "{x}: {tangent:?}");
    }
    assert_eq!(vertices.iter().filter(|(place, _, tangent)| place[0] == 1.0 && tangent[3] == 1.0).count(), 2);

    // The same without any vertex to split: the texture is turned by a quarter, so that u rises with y.
    let turned = "mtllib m.mtl\nv 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nvt 0 1\nvt 0 0\nvt 1 0\nvt 1 1\nvn 0 0 1\nvn 0 0 1\n\
                  vn 0 0 1\nvn 0 0 1\nusemtl m\nf 1/1/1 2/2/2 3/3/3 4/4/4\n";
    fs::write(folder.path().join("a.obj"), turned).unwrap();
    let vertices = tangents(&glb(&written(folder.path(), Format::Glb, None).bytes));
    assert_eq!(vertices.len(), 4);
    assert!(vertices.iter().all(|(.., tangent)| *tangent == [0.0, 1.0, 0.0, 1.0]), "{vertices:?}");

    let options = WriteOptions { tangents: TangentPolicy::Drop, ..WriteOptions::default() };
    let loaded = read(&folder.path().join("a.obj"), None, &ReadOptions::default()).unwrap();
    let without = io::write(&loaded, &[], Format::Glb, &options).unwrap();
    let attributes = &glb(&without.bytes).0["meshes"][0]["primitives"][0]["attributes"];
    assert!(attributes["TANGENT"].is_null() && !attributes["NORMAL"].is_null());
}

#[test]
fn tangents_of_new_files_are_those_of_edited_ones() {
    let folder = folder(MIRRORED, "newmtl m\nnorm n.jpg\n");
    let new = written(folder.path(), Format::Glb, None);
    let loaded = read_bytes(new.bytes.clone(), Some(Format::Glb), None, &ReadOptions::default()).unwrap();
    let options = WriteOptions { tangents: TangentPolicy::Regenerate, ..WriteOptions::default() };
    let normals = loaded.parts[0].mesh.columns().normals.clone();
    assert!(normals.is_some());
    let edits = [PartEdit { normals, ..PartEdit::default() }];
    let edited = io::write(&loaded, &edits[..], Format::Glb, &options).unwrap();
    assert_eq!(tangents(&glb(&edited.bytes)), tangents(&glb(&new.bytes)));
}
