//! Extensions: which may be required, and which refer to the order of vertices or triangles.

use super::fields::Fields;
use crate::io::{Note, Place, Problem, ReadError};
use std::borrow::Cow;

/// Extensions that do not affect the shape of surfaces, by name or family. A document may require them.
const HARMLESS: &[&str] = &[
    "ADOBE_materials_",
    "AGI_articulations",
    "EXT_instance_features",
    "EXT_lights_",
    "EXT_mesh_features",
    "EXT_mesh_manifold",
    "EXT_structural_metadata",
    "EXT_texture_",
    "FB_ngon_encoding",
    "KHR_animation_pointer",
    "KHR_audio",
    "KHR_interactivity",
    "KHR_lights_",
    "KHR_materials_",
    "KHR_mesh_quantization",
    "KHR_node_",
    "KHR_texture_",
    "KHR_xmp",
    "MSFT_packing_",
    "MSFT_texture_",
    "VRM",
    // Readable if the plain data are there too, which accessors find out.
    "EXT_meshopt_compression",
    "KHR_meshopt_compression",
    // Instances concern nodes; a note reports that they are not expanded.
    "EXT_mesh_gpu_instancing",
];

/// Attributes stored as integers.
pub const QUANTIZATION: &str = "KHR_mesh_quantization";

/// The name under which a primitive's Draco data are stored.
pub const DRACO: &str = "KHR_draco_mesh_compression";

/// Checks what a document requires, and adds notes on what is used but not expanded.
pub fn check(root: &Fields<'_>, notes: &mut Vec<Note>) -> Result<(), ReadError> {
    let names = |list: &str| -> Result<Vec<Cow<'_, str>>, ReadError> {
        Ok(root.items(list)?.filter_map(|value| root.json.string(value)).collect())
    };
    let is_harmless = |name: &str| HARMLESS.iter().any(|known| name.starts_with(known));
    let required = names("extensionsRequired")?;
    if let Some(number) = required.iter().position(|name| !is_harmless(name)) {
        let advice = match required[number].as_ref() {
            DRACO => "decompress the file first, for example with `gltf-transform copy`",
            _ => "convert the file to plain glTF 2.0 first",
        };
        let found = format!("unsupported required extension {}", required[number]);
        let place = Place::Json(format!("/extensionsRequired/{number}"));
        return Err(ReadError::new(Problem::Unsupported, place, found, advice));
    }
    if names("extensionsUsed")?.iter().any(|name| name == "EXT_mesh_gpu_instancing") {
        let text = "EXT_mesh_gpu_instancing: only one of the instances is written to other formats";
        notes.push(Note::warning(Place::File, text));
    }
    Ok(())
}

/// Extensions that refer to vertices by number, so that none may be split, and whether they also refer to triangles.
pub const ORDERED: [(&str, bool); 3] = [
    ("CESIUM_primitive_outline", false),
    ("EXT_mesh_primitive_edge_visibility", true),
    ("EXT_mesh_manifold", true),
];

/// Whether `EXT_mesh_features` on a primitive numbers its features by vertex.
pub fn has_implicit_features(primitive: &Fields<'_>) -> bool {
    let json = primitive.json;
    let Some(extension) = primitive.extension("EXT_mesh_features") else { return false };
    json.items(extension, "featureIds")
        .any(|set| json.member(set, "attribute").is_none() && json.member(set, "texture").is_none())
}
