//! Extensions: which may be required, and which refer to the order of vertices or triangles.

use super::fields::Fields;
use crate::io::{Note, Place, Problem, ReadError};
use std::borrow::Cow;

/// Registered extensions, by the start of their names, that hold nothing of a mesh: they pass through unchanged.
const NOT_OF_MESHES: &[&str] = &[
    "KHR_animation_pointer",
    "KHR_audio",
    "KHR_character",
    "KHR_collision_shapes",
    // What is compressed was decompressed before, unless there are plain data too.
    DRACO,
    "KHR_meshopt_compression",
    "EXT_meshopt_compression",
    "KHR_implicit_shapes",
    "KHR_interactivity",
    "KHR_lights_",
    "KHR_materials_",
    QUANTIZATION,
    "KHR_node_",
    "KHR_physics_rigid_bodies",
    "KHR_techniques_webgl",
    "KHR_texture_",
    "KHR_xmp",
    "EXT_instance_features",
    "EXT_lights_",
    "EXT_materials_",
    // Metadata of vertices by attribute or texture; those by number are found in primitives.
    "EXT_mesh_features",
    // Instances concern nodes; a note reports that they are not expanded.
    INSTANCING,
    "EXT_structural_metadata",
    "EXT_texture_",
    "ADOBE_materials_",
    "AGI_articulations",
    "AGI_stk_metadata",
    "BLENDER_physics",
    // Polygons by the first vertices of triangles, which stay.
    "FB_ngon_encoding",
    "GODOT_single_root",
    "GRIFFEL_bim_data",
    "MOZ_",
    "MSFT_lod",
    "MSFT_packing_",
    "MSFT_texture_",
    "NV_materials_",
    "OMI_",
    "VRM",
];

/// Extensions that refer to vertices by number, so that none may be split, and whether they also refer to triangles.
pub const ORDERED: [(&str, bool); 3] = [
    ("EXT_mesh_manifold", true),
    ("EXT_mesh_primitive_edge_visibility", true),
    ("CESIUM_primitive_outline", false),
];

/// Those that hold vertices or indices themselves, or what they mean: meshes are incomplete without them. In their order: positions
/// in double precision, points that are splats, indices that end a strip, accessors that change with time.
const DATA: [&str; 4] =
    ["KHR_accessor_float64", "KHR_gaussian_splatting", "EXT_mesh_primitive_restart", "MPEG_"];

/// Attributes stored as integers.
pub const QUANTIZATION: &str = "KHR_mesh_quantization";

/// The name under which a primitive's Draco data are stored.
pub const DRACO: &str = "KHR_draco_mesh_compression";

const INSTANCING: &str = "EXT_mesh_gpu_instancing";

/// Checks what a document requires, and adds notes on what is used but not expanded. Extensions that are `allowed` by name pass.
pub fn check(root: &Fields<'_>, allowed: &[String], notes: &mut Vec<Note>) -> Result<(), ReadError> {
    let names = |list: &str| -> Result<Vec<Cow<'_, str>>, ReadError> {
        Ok(root.items(list)?.filter_map(|value| root.json.string(value)).collect())
    };
    for (number, name) in names("extensionsRequired")?.iter().enumerate() {
        let starts_like = |known: &&str| name.starts_with(*known);
        let is_ordered = ORDERED.iter().any(|(known, _)| starts_like(known));
        if is_ordered || NOT_OF_MESHES.iter().any(starts_like) || allowed.iter().any(|known| known == name) {
            continue;
        }
        let (what, advice) = if DATA.iter().any(starts_like) {
            ("", "convert the file to plain glTF 2.0 first".to_owned())
        } else {
            let advice = "if it holds no vertices, indices or their order, use --allow-extension";
            (", which crease does not know", format!("{advice} {name}"))
        };
        let found = format!("unsupported required extension {name}{what}");
        let place = Place::Json(format!("/extensionsRequired/{number}"));
        return Err(ReadError::new(Problem::Unsupported, place, found, advice));
    }
    if names("extensionsUsed")?.iter().any(|name| name == INSTANCING) {
        let text =
            "EXT_mesh_gpu_instancing: of the instances of a node only one is read; glTF files keep all";
        notes.push(Note::warning(Place::File, text));
    }
    Ok(())
}

/// Whether `EXT_mesh_features` on a primitive numbers its features by vertex.
pub fn has_implicit_features(primitive: &Fields<'_>) -> bool {
    let json = primitive.json;
    let Some(extension) = primitive.extension("EXT_mesh_features") else { return false };
    json.items(extension, "featureIds")
        .any(|set| json.member(set, "attribute").is_none() && json.member(set, "texture").is_none())
}
