//! The files of `data/`, written from their shapes by code that shares nothing with the crate's own writers.

use super::brushed::brushed;
use super::shapes::{self, GEAR_PARTS, Shape};
use super::stage::stage;
use base64::Engine;
use libm::{cos, sin};
use std::f64::consts::PI;
use std::fmt::Write;

/// Every file of `data/` but its README: name and content.
pub fn files() -> Vec<(&'static str, Vec<u8>)> {
    vec![
        ("gear.obj", gear().into_bytes()),
        ("gear.mtl", GEAR_MTL.into()),
        ("bracket.obj", bracket().into_bytes()),
        ("polygons.obj", polygons().into_bytes()),
        ("slivers.obj", slivers().into_bytes()),
        ("far.ply", far()),
        ("leaf.ply", leaf().into_bytes()),
        ("part.stl", stl_ascii(&shapes::part()).into_bytes()),
        ("part-binary.stl", stl_binary(&shapes::part())),
        ("mirrored.gltf", mirrored().into_bytes()),
        ("morph.gltf", morph().into_bytes()),
        ("sphere-seam.glb", sphere_seam()),
        ("brushed.glb", brushed()),
        ("scenes/stage.gltf", stage().into_bytes()),
    ]
}

const GEAR_MTL: &str = "\
newmtl steel
Kd 0.45 0.47 0.50
Ks 0.50 0.50 0.50
Ns 120
newmtl brass
Kd 0.60 0.46 0.21
Ks 0.40 0.36 0.24
Ns 60
";

/// A decimal with at most six places and no trailing zeros.
fn decimal(value: f64) -> String {
    let text = format!("{value:.6}");
    let text = text.trim_end_matches('0').trim_end_matches('.');
    if text == "-0" { "0".into() } else { text.into() }
}

fn vertices(out: &mut String, keyword: &str, shape: &Shape) {
    for position in &shape.positions {
        let [x, y, z] = position.map(decimal);
        let _ = writeln!(out, "{keyword}{x} {y} {z}");
    }
}

fn obj_face(out: &mut String, corners: &[u32]) {
    out.push('f');
    for corner in corners {
        let _ = write!(out, " {}", corner + 1);
    }
    out.push('\n');
}

fn gear() -> String {
    let shape = shapes::gear();
    let mut out = String::from(
        "# A spur gear: sharp teeth, a chamfer, a rounded hub, a bore.\nmtllib gear.mtl\no gear\n",
    );
    vertices(&mut out, "v ", &shape);
    for (label, part) in GEAR_PARTS.iter().enumerate() {
        let material = if matches!(*part, "hub" | "bore") { "brass" } else { "steel" };
        let group = if label == 0 { "off".into() } else { label.to_string() };
        let _ = writeln!(out, "g {part}\nusemtl {material}\ns {group}");
        for face in shape.faces.iter().filter(|face| face.label == label) {
            obj_face(&mut out, &face.corners);
        }
    }
    out
}

fn bracket() -> String {
    let shape = shapes::bracket();
    let mut out = String::from("# An L-shaped bracket: flats, a fillet and a rounded heel.\no bracket\n");
    vertices(&mut out, "v ", &shape);
    let mut group = None;
    for face in &shape.faces {
        if group != Some(face.label) {
            let name = if face.label == 0 { "off".into() } else { face.label.to_string() };
            let _ = writeln!(out, "s {name}");
            group = Some(face.label);
        }
        obj_face(&mut out, &face.corners);
    }
    out
}

fn polygons() -> String {
    let shape = shapes::polygons();
    let mut out =
        String::from("# Prisms with concave caps: an L with a corner on a straight edge, a star, a U.\n");
    vertices(&mut out, "v ", &shape);
    let mut object = None;
    for face in &shape.faces {
        if object != Some(face.label) {
            let _ = writeln!(out, "o {}", ["ell", "star", "u"][face.label]);
            object = Some(face.label);
        }
        obj_face(&mut out, &face.corners);
    }
    out
}

fn slivers() -> String {
    let shape = shapes::slivers();
    let mut out = String::from("# Caps fanned along a straight edge: most of their triangles are slivers.\n");
    vertices(&mut out, "v ", &shape);
    for face in &shape.faces {
        obj_face(&mut out, &face.corners);
    }
    out
}

/// Rolling ground in a national grid's coordinates, in metres, as doubles: an `f32` there has steps of half a
/// metre.
fn far() -> Vec<u8> {
    let mut shape = shapes::patch(16, 0.25, |x, z| 0.2 * sin(1.7 * x) * cos(1.3 * z));
    for [x, y, z] in &mut shape.positions {
        (*x, *y, *z) = (*x + 2_684_123.0, *y + 1_251.0, *z + 5_247_888.0);
    }
    let mut out = format!(
        "ply\nformat binary_little_endian 1.0\ncomment ground far from the origin\nelement vertex {}\nproperty double x\n\
         property double y\nproperty double z\nelement face {}\nproperty list uchar int vertex_indices\nend_header\n",
        shape.positions.len(),
        shape.faces.len()
    )
    .into_bytes();
    out.extend(shape.positions.as_flattened().iter().flat_map(|x| x.to_le_bytes()));
    for face in &shape.faces {
        out.push(face.corners.len() as u8);
        out.extend(face.corners.iter().flat_map(|v| v.to_le_bytes()));
    }
    out
}

fn leaf() -> String {
    let shape = shapes::leaf();
    let mut out = format!(
        "ply\nformat ascii 1.0\ncomment two sheets back to back\nelement vertex {}\nproperty float x\n\
         property float y\nproperty float z\nelement face {}\nproperty list uchar int vertex_indices\n\
         property uchar side\nend_header\n",
        shape.positions.len(),
        shape.faces.len()
    );
    vertices(&mut out, "", &shape);
    for face in &shape.faces {
        let _ = write!(out, "{}", face.corners.len());
        for corner in &face.corners {
            let _ = write!(out, " {corner}");
        }
        let _ = writeln!(out, " {}", face.label);
    }
    out
}

/// The unit normal and the corners of every triangle.
fn facets(shape: &Shape) -> Vec<[[f64; 3]; 4]> {
    let facet = |corners: [u32; 3]| {
        let [a, b, c] = corners.map(|v| shape.positions[v as usize]);
        let (e, f) = ([b[0] - a[0], b[1] - a[1], b[2] - a[2]], [c[0] - a[0], c[1] - a[1], c[2] - a[2]]);
        let n = [e[1] * f[2] - e[2] * f[1], e[2] * f[0] - e[0] * f[2], e[0] * f[1] - e[1] * f[0]];
        let length = (n[0] * n[0] + n[1] * n[1] + n[2] * n[2]).sqrt();
        [n.map(|x| x / length), a, b, c]
    };
    shape.triangles().into_iter().map(facet).collect()
}

fn stl_ascii(shape: &Shape) -> String {
    let mut out = String::from("solid part\n");
    for [normal, corners @ ..] in facets(shape) {
        let [x, y, z] = normal.map(decimal);
        let _ = writeln!(out, "  facet normal {x} {y} {z}\n    outer loop");
        for corner in corners {
            let [x, y, z] = corner.map(decimal);
            let _ = writeln!(out, "      vertex {x} {y} {z}");
        }
        out.push_str("    endloop\n  endfacet\n");
    }
    out.push_str("endsolid part\n");
    out
}

fn stl_binary(shape: &Shape) -> Vec<u8> {
    let mut out = b"a cylinder with a cone on top".to_vec();
    out.resize(80, b' ');
    let facets = facets(shape);
    out.extend((facets.len() as u32).to_le_bytes());
    for facet in facets {
        out.extend(facet.as_flattened().iter().flat_map(|&x| (x as f32).to_le_bytes()));
        out.extend([0, 0]);
    }
    out
}

pub fn f32_bytes(values: &[[f64; 3]]) -> Vec<u8> {
    values.as_flattened().iter().flat_map(|&x| (x as f32).to_le_bytes()).collect()
}

/// `"min":[…],"max":[…]` of positions as stored.
pub fn bounds(values: &[[f64; 3]]) -> String {
    let fold = |pick: fn(f32, f32) -> f32| {
        let bound = |axis: usize| values.iter().map(|p| p[axis] as f32).reduce(pick).unwrap_or(0.0);
        format!("[{},{},{}]", bound(0), bound(1), bound(2))
    };
    format!("\"min\":{},\"max\":{}", fold(f32::min), fold(f32::max))
}

pub fn index_bytes(triangles: &[[u32; 3]]) -> Vec<u8> {
    triangles.as_flattened().iter().flat_map(|&v| (v as u16).to_le_bytes()).collect()
}

pub fn data_uri(bytes: &[u8]) -> String {
    format!(
        "data:application/octet-stream;base64,{}",
        base64::engine::general_purpose::STANDARD.encode(bytes)
    )
}

/// One wedge, shown unchanged and through a mirroring node.
fn mirrored() -> String {
    let shape = shapes::wedge();
    let (positions, indices) = (f32_bytes(&shape.positions), index_bytes(&shape.triangles()));
    let (split, total) = (positions.len(), positions.len() + indices.len());
    let uri = data_uri(&[positions, indices].concat());
    format!(
        r#"{{
  "asset": {{ "version": "2.0" }},
  "scene": 0,
  "scenes": [{{ "nodes": [0, 1] }}],
  "nodes": [
    {{ "name": "plain", "mesh": 0, "translation": [0.5, 0, 0] }},
    {{ "name": "mirrored", "mesh": 0, "translation": [-0.5, 0, 0], "scale": [-1, 1, 1] }}
  ],
  "meshes": [{{ "name": "wedge", "primitives": [{{ "attributes": {{ "POSITION": 0 }}, "indices": 1 }}] }}],
  "accessors": [
    {{ "bufferView": 0, "componentType": 5126, "count": {vertices}, "type": "VEC3", {bounds} }},
    {{ "bufferView": 1, "componentType": 5123, "count": {corners}, "type": "SCALAR" }}
  ],
  "bufferViews": [
    {{ "buffer": 0, "byteOffset": 0, "byteLength": {split}, "target": 34962 }},
    {{ "buffer": 0, "byteOffset": {split}, "byteLength": {rest}, "target": 34963 }}
  ],
  "buffers": [{{ "byteLength": {total}, "uri": "{uri}" }}]
}}
"#,
        vertices = shape.positions.len(),
        corners = 3 * shape.faces.len(),
        bounds = bounds(&shape.positions),
        rest = total - split,
    )
}

/// A flat sheet with flat normals, and a morph target that raises a bump and says nothing about normals yet: its
/// normal deltas are zero.
fn morph() -> String {
    let mut shape = shapes::patch(8, 0.25, |_, _| 0.0);
    for position in &mut shape.positions {
        position[0] -= 1.0;
        position[2] -= 1.0;
    }
    let bump = |p: &[f64; 3]| 0.25 * (1.0 + cos(PI * p[0])) * (1.0 + cos(PI * p[2]));
    let raised: Vec<[f64; 3]> = shape.positions.iter().map(|p| [0.0, bump(p), 0.0]).collect();
    let triangles: Vec<[u32; 3]> = shape.triangles();
    let count = shape.positions.len();
    let columns = [
        f32_bytes(&shape.positions),
        f32_bytes(&vec![[0.0, 1.0, 0.0]; count]),
        f32_bytes(&raised),
        f32_bytes(&vec![[0.0; 3]; count]),
        index_bytes(&triangles),
    ];
    let mut views = String::new();
    let mut offset = 0;
    for (number, column) in columns.iter().enumerate() {
        let (target, comma) = if number == 4 { (34963, "") } else { (34962, ",") };
        let length = column.len();
        let _ = write!(
            views,
            "\n    {{ \"buffer\": 0, \"byteOffset\": {offset}, \"byteLength\": {length}, \"target\": {target} }}{comma}"
        );
        offset += length;
    }
    let uri = data_uri(&columns.concat());
    format!(
        r#"{{
  "asset": {{ "version": "2.0" }},
  "scene": 0,
  "scenes": [{{ "nodes": [0] }}],
  "nodes": [{{ "name": "sheet", "mesh": 0 }}],
  "meshes": [{{
    "name": "sheet",
    "weights": [0.5],
    "primitives": [{{
      "attributes": {{ "POSITION": 0, "NORMAL": 1 }},
      "targets": [{{ "POSITION": 2, "NORMAL": 3 }}],
      "indices": 4
    }}]
  }}],
  "accessors": [
    {{ "bufferView": 0, "componentType": 5126, "count": {count}, "type": "VEC3", {base} }},
    {{ "bufferView": 1, "componentType": 5126, "count": {count}, "type": "VEC3" }},
    {{ "bufferView": 2, "componentType": 5126, "count": {count}, "type": "VEC3", {target} }},
    {{ "bufferView": 3, "componentType": 5126, "count": {count}, "type": "VEC3" }},
    {{ "bufferView": 4, "componentType": 5123, "count": {corners}, "type": "SCALAR" }}
  ],
  "bufferViews": [{views}
  ],
  "buffers": [{{ "byteLength": {offset}, "uri": "{uri}" }}]
}}
"#,
        base = bounds(&shape.positions),
        target = bounds(&raised),
        corners = 3 * triangles.len(),
    )
}

fn sphere_seam() -> Vec<u8> {
    let (shape, uvs) = shapes::seamed_sphere();
    let triangles = shape.triangles();
    let positions = f32_bytes(&shape.positions);
    let uvs: Vec<u8> = uvs.as_flattened().iter().flat_map(|&x| (x as f32).to_le_bytes()).collect();
    let indices = index_bytes(&triangles);
    let (a, b, c) = (positions.len(), uvs.len(), indices.len());
    let bin = [positions, uvs, indices, CHECKER.to_vec()].concat();
    let json = format!(
        concat!(
            r#"{{"asset":{{"version":"2.0"}},"scene":0,"scenes":[{{"nodes":[0]}}],"nodes":[{{"mesh":0}}],"#,
            r#""meshes":[{{"name":"sphere","primitives":[{{"attributes":{{"POSITION":0,"TEXCOORD_0":1}},"indices":2,"#,
            r#""material":0}}]}}],"materials":[{{"name":"chart","pbrMetallicRoughness":{{"baseColorTexture":{{"index":0}}}}}}],"#,
            r#""textures":[{{"source":0}}],"images":[{{"name":"checker","mimeType":"image/png","bufferView":3}}],"#,
            r#""accessors":[{{"bufferView":0,"componentType":5126,"count":{count},"type":"VEC3",{bounds}}},"#,
            r#"{{"bufferView":1,"componentType":5126,"count":{count},"type":"VEC2"}},"#,
            r#"{{"bufferView":2,"componentType":5123,"count":{corners},"type":"SCALAR"}}],"#,
            r#""bufferViews":[{{"buffer":0,"byteLength":{a},"target":34962}},"#,
            r#"{{"buffer":0,"byteOffset":{a},"byteLength":{b},"target":34962}},"#,
            r#"{{"buffer":0,"byteOffset":{ab},"byteLength":{c},"target":34963}},"#,
            r#"{{"buffer":0,"byteOffset":{abc},"byteLength":{d}}}],"#,
            r#""buffers":[{{"byteLength":{length}}}]}}"#
        ),
        count = shape.positions.len(),
        bounds = bounds(&shape.positions),
        corners = 3 * triangles.len(),
        a = a,
        b = b,
        ab = a + b,
        c = c,
        abc = a + b + c,
        d = CHECKER.len(),
        length = bin.len(),
    );
    glb(json, bin)
}

pub fn glb(json: String, mut bin: Vec<u8>) -> Vec<u8> {
    bin.resize(bin.len().next_multiple_of(4), 0);
    let mut json = json.into_bytes();
    json.resize(json.len().next_multiple_of(4), b' ');
    let chunk =
        |kind: &[u8; 4], content: &[u8]| [&(content.len() as u32).to_le_bytes(), &kind[..], content].concat();
    let body = [chunk(b"JSON", &json), chunk(b"BIN\0", &bin)].concat();
    [&b"glTF"[..], &2u32.to_le_bytes(), &(12 + body.len() as u32).to_le_bytes(), &body].concat()
}

/// A PNG of 2 × 2 grey pixels.
pub const CHECKER: &[u8] = &[
    0x89, 0x50, 0x4e, 0x47, 0x0d, 0x0a, 0x1a, 0x0a, 0x00, 0x00, 0x00, 0x0d, 0x49, 0x48, 0x44, 0x52, 0x00,
    0x00, 0x00, 0x02, 0x00, 0x00, 0x00, 0x02, 0x08, 0x00, 0x00, 0x00, 0x00, 0x57, 0xdd, 0x52, 0xf8, 0x00,
    0x00, 0x00, 0x0e, 0x49, 0x44, 0x41, 0x54, 0x78, 0xda, 0x63, 0x78, 0x90, 0xc0, 0x90, 0xf0, 0x00, 0x00,
    0x07, 0x86, 0x02, 0x81, 0x3c, 0xf8, 0x5c, 0x8a, 0x00, 0x00, 0x00, 0x00, 0x49, 0x45, 0x4e, 0x44, 0xae,
    0x42, 0x60, 0x82,
];
