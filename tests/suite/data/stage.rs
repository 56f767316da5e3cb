//! A glTF file that is a whole scene: nodes, a camera, lights, materials without images.

use super::shapes::Shape;
use super::write::{bounds, data_uri, f32_bytes, index_bytes};

/// A box about the origin, two units wide.
pub fn cube() -> Shape {
    let mut shape = Shape::default();
    for corner in 0..8_u32 {
        let side = |axis: u32| if corner >> axis & 1 == 1 { 1.0 } else { -1.0 };
        shape.vertex([side(0), side(1), side(2)]);
    }
    for face in [[0, 4, 6, 2], [1, 3, 7, 5], [0, 1, 5, 4], [2, 6, 7, 3], [0, 2, 3, 1], [4, 5, 7, 6]] {
        shape.face(&face, 0);
    }
    shape
}

/// One cube in three materials at four places, a camera and three lights. The cube has no normals: what is drawn are
/// those that are computed. The third box is mirrored, and the top one is its child.
pub fn stage() -> String {
    let shape = cube();
    let (positions, indices) = (f32_bytes(&shape.positions), index_bytes(&shape.triangles()));
    let (split, total) = (positions.len(), positions.len() + indices.len());
    let uri = data_uri(&[positions, indices].concat());
    let mesh = |name: &str, material: usize| {
        format!(
            r#"{{ "name": "{name}", "primitives": [{{ "attributes": {{ "POSITION": 0 }}, "indices": 1, "material": {material} }}] }}"#
        )
    };
    format!(
        r#"{{
  "asset": {{ "version": "2.0" }},
  "extensionsUsed": ["KHR_lights_punctual"],
  "extensions": {{
    "KHR_lights_punctual": {{
      "lights": [
        {{ "name": "sun", "type": "directional", "color": [1, 0.96, 0.9], "intensity": 2 }},
        {{ "name": "lamp", "type": "point", "color": [0.6, 0.75, 1], "intensity": 12 }},
        {{
          "name": "spot", "type": "spot", "color": [1, 0.85, 0.6], "intensity": 60, "range": 12,
          "spot": {{ "innerConeAngle": 0.2, "outerConeAngle": 0.35 }}
        }}
      ]
    }}
  }},
  "scene": 0,
  "scenes": [{{ "nodes": [0, 1, 2, 3, 5, 6, 7, 8] }}],
  "nodes": [
    {{ "name": "floor", "mesh": 0, "translation": [0, -0.1, 0], "scale": [3, 0.1, 2] }},
    {{ "name": "red", "mesh": 1, "translation": [-1.4, 0.5, 0.3], "scale": [0.5, 0.5, 0.5], "rotation": [0, 0.2588190451, 0, 0.9659258263] }},
    {{ "name": "gold", "mesh": 2, "translation": [0, 0.6, -0.4], "scale": [0.6, 0.6, 0.6] }},
    {{ "name": "mirrored", "mesh": 1, "translation": [1.4, 0.4, 0.2], "scale": [-0.4, 0.4, 0.4], "children": [4] }},
    {{ "name": "on top", "mesh": 2, "translation": [0, 1.5, 0], "scale": [0.5, 0.5, 0.5], "rotation": [0, 0.3826834324, 0, 0.9238795325] }},
    {{ "name": "eye", "camera": 0, "translation": [0, 2.4, 7], "rotation": [-0.1478094111, 0, 0, 0.9890158634] }},
    {{ "name": "sun", "extensions": {{ "KHR_lights_punctual": {{ "light": 0 }} }}, "rotation": [-0.4226182617, 0, 0, 0.906307787] }},
    {{ "name": "lamp", "extensions": {{ "KHR_lights_punctual": {{ "light": 1 }} }}, "translation": [-3, 2, 1] }},
    {{ "name": "spot", "extensions": {{ "KHR_lights_punctual": {{ "light": 2 }} }}, "translation": [0.3, 4, 0], "rotation": [-0.7071067812, 0, 0, 0.7071067812] }}
  ],
  "cameras": [{{ "name": "eye", "type": "perspective", "perspective": {{ "yfov": 0.55, "znear": 0.1 }} }}],
  "materials": [
    {{ "name": "stone", "pbrMetallicRoughness": {{ "baseColorFactor": [0.6, 0.58, 0.55, 1], "metallicFactor": 0, "roughnessFactor": 0.9 }} }},
    {{ "name": "red", "pbrMetallicRoughness": {{ "baseColorFactor": [0.7, 0.12, 0.1, 1], "metallicFactor": 0, "roughnessFactor": 0.4 }} }},
    {{ "name": "gold", "pbrMetallicRoughness": {{ "baseColorFactor": [1, 0.77, 0.34, 1], "metallicFactor": 0.4, "roughnessFactor": 0.5 }} }}
  ],
  "meshes": [
    {},
    {},
    {}
  ],
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
        mesh("stone box", 0),
        mesh("red box", 1),
        mesh("gold box", 2),
        vertices = shape.positions.len(),
        corners = 3 * shape.triangles().len(),
        bounds = bounds(&shape.positions),
        rest = total - split,
    )
}
