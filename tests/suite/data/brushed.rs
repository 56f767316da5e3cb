//! A half cylinder of brushed metal: its material needs tangents and has no normal texture.

use super::write::{CHECKER, bounds, f32_bytes, glb, index_bytes};
use libm::{cos, sin};
use std::f64::consts::PI;

/// Faces along the arc.
const FACES: u32 = 8;

/// The texture is mirrored in the middle of the arc, where vertices are doubled.
pub fn brushed() -> Vec<u8> {
    let half = FACES / 2;
    let columns: Vec<(u32, f64)> =
        (0..=half).map(|column| (column, -1.0)).chain((half..=FACES).map(|column| (column, 1.0))).collect();
    let (mut positions, mut normals, mut tangents, mut uvs) = (vec![], vec![], vec![], vec![]);
    for &(column, side) in &columns {
        let angle = PI * f64::from(column) / f64::from(FACES);
        for height in [0.0, 1.0] {
            positions.push([cos(angle), height, -sin(angle)]);
            normals.push([cos(angle), 0.0, -sin(angle)]);
            tangents.extend([-side * sin(angle), 0.0, -side * cos(angle), side].map(|x| x as f32));
            let from_middle = (f64::from(column) - f64::from(half)).abs() / f64::from(half);
            uvs.extend([from_middle, 1.0 - height].map(|x| x as f32));
        }
    }
    let first = (0..columns.len() as u32 - 1).filter(|&column| column != half).map(|column| 2 * column);
    let triangles: Vec<[u32; 3]> = first.flat_map(|v| [[v, v + 2, v + 3], [v, v + 3, v + 1]]).collect();
    let bytes = |values: &[f32]| values.iter().flat_map(|x| x.to_le_bytes()).collect::<Vec<u8>>();
    let pieces = [
        f32_bytes(&positions),
        f32_bytes(&normals),
        bytes(&tangents),
        bytes(&uvs),
        index_bytes(&triangles),
        CHECKER.to_vec(),
    ];
    let mut views = Vec::new();
    let mut offset = 0;
    for (piece, target) in pieces.iter().zip([34962, 34962, 34962, 34962, 34963, 0]) {
        let target = if target == 0 { String::new() } else { format!(r#","target":{target}"#) };
        views.push(format!(r#"{{"buffer":0,"byteOffset":{offset},"byteLength":{}{target}}}"#, piece.len()));
        offset += piece.len();
    }
    let count = positions.len();
    let json = format!(
        concat!(
            r#"{{"asset":{{"version":"2.0"}},"extensionsUsed":["KHR_materials_anisotropy"],"scene":0,"#,
            r#""scenes":[{{"nodes":[0]}}],"nodes":[{{"mesh":0}}],"meshes":[{{"name":"shell","primitives":[{{"attributes":"#,
            r#"{{"POSITION":0,"NORMAL":1,"TANGENT":2,"TEXCOORD_0":3}},"indices":4,"material":0}}]}}],"#,
            r#""materials":[{{"name":"brushed","extensions":{{"KHR_materials_anisotropy":{{"anisotropyStrength":0.8,"#,
            r#""anisotropyTexture":{{"index":0}}}}}}}}],"textures":[{{"source":0}}],"#,
            r#""images":[{{"name":"directions","mimeType":"image/png","bufferView":5}}],"#,
            r#""accessors":[{{"bufferView":0,"componentType":5126,"count":{count},"type":"VEC3",{bounds}}},"#,
            r#"{{"bufferView":1,"componentType":5126,"count":{count},"type":"VEC3"}},"#,
            r#"{{"bufferView":2,"componentType":5126,"count":{count},"type":"VEC4"}},"#,
            r#"{{"bufferView":3,"componentType":5126,"count":{count},"type":"VEC2"}},"#,
            r#"{{"bufferView":4,"componentType":5123,"count":{corners},"type":"SCALAR"}}],"#,
            r#""bufferViews":[{views}],"buffers":[{{"byteLength":{offset}}}]}}"#
        ),
        count = count,
        bounds = bounds(&positions),
        corners = 3 * triangles.len(),
        views = views.join(","),
        offset = offset,
    );
    glb(json, pieces.concat())
}
