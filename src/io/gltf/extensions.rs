//! Extensions: which may be required, and which refer to the order of vertices or triangles.

use super::fields::Fields;
use crate::io::{Note, Place, Problem, ReadError};
use std::borrow::Cow;

/// What an extension holds of a mesh.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Holds {
    /// Nothing: it passes through unchanged.
    Nothing,
    /// Vertices by number, so that none may be split.
    VertexOrder,
    /// Vertices and triangles by number.
    TriangleOrder,
    /// Vertices or indices themselves, or what they mean: meshes are incomplete without it.
    Data,
}

use Holds::{Data, Nothing, TriangleOrder, VertexOrder};

/// Registered extensions by the start of their names, what they hold of a mesh, and what they are.
const REGISTRY: &[(&str, Holds, &str)] = &[
    // Khronos.
    ("KHR_accessor_float64", Data, "positions as double precision numbers"),
    ("KHR_animation_pointer", Nothing, "animation of any property but accessors"),
    ("KHR_audio", Nothing, "sound"),
    ("KHR_character", Nothing, "roles of nodes and animations"),
    ("KHR_collision_shapes", Nothing, "spheres, boxes and other analytic shapes"),
    // What is compressed was decompressed before, unless there are plain data too.
    (DRACO, Nothing, "compressed vertices and indices"),
    ("KHR_gaussian_splatting", Data, "another meaning of point primitives"),
    ("KHR_implicit_shapes", Nothing, "spheres, boxes and other analytic shapes"),
    ("KHR_interactivity", Nothing, "behaviour graphs"),
    ("KHR_lights_", Nothing, "lights"),
    ("KHR_materials_", Nothing, "materials"),
    (QUANTIZATION, Nothing, "integer attributes, which crease reads"),
    ("KHR_meshopt_compression", Nothing, "compressed buffer views"),
    ("KHR_node_", Nothing, "visibility and selection of nodes"),
    ("KHR_physics_rigid_bodies", Nothing, "masses, joints and colliders of nodes and whole meshes"),
    ("KHR_techniques_webgl", Nothing, "shaders"),
    ("KHR_texture_", Nothing, "texture transforms and image formats"),
    ("KHR_xmp", Nothing, "metadata"),
    // Several vendors.
    ("EXT_instance_features", Nothing, "metadata of instances"),
    ("EXT_lights_", Nothing, "lights"),
    ("EXT_materials_", Nothing, "materials"),
    (
        "EXT_mesh_features",
        Nothing,
        "metadata of vertices by attribute or texture; by number is found in primitives",
    ),
    // Instances concern nodes; a note reports that they are not expanded.
    (INSTANCING, Nothing, "copies of a node"),
    ("EXT_mesh_manifold", TriangleOrder, "ranges of the indices of a closed mesh"),
    ("EXT_mesh_primitive_edge_visibility", TriangleOrder, "edges of numbered triangles"),
    ("EXT_mesh_primitive_restart", Data, "indices that end a strip"),
    ("EXT_meshopt_compression", Nothing, "compressed buffer views"),
    ("EXT_structural_metadata", Nothing, "metadata tables"),
    ("EXT_texture_", Nothing, "image formats"),
    // One vendor.
    ("ADOBE_materials_", Nothing, "materials"),
    ("AGI_articulations", Nothing, "named motions of nodes"),
    ("AGI_stk_metadata", Nothing, "metadata"),
    ("BLENDER_physics", Nothing, "masses of nodes"),
    ("CESIUM_primitive_outline", VertexOrder, "outlines as pairs of vertices"),
    ("FB_ngon_encoding", Nothing, "polygons by the first vertices of triangles, which stay"),
    ("GODOT_single_root", Nothing, "a promise about nodes"),
    ("GRIFFEL_bim_data", Nothing, "metadata of nodes"),
    ("MOZ_", Nothing, "components of nodes, light maps"),
    ("MPEG_", Data, "accessors that change with time"),
    ("MSFT_lod", Nothing, "levels of detail by node or material"),
    ("MSFT_packing_", Nothing, "channels of textures"),
    ("MSFT_texture_", Nothing, "image formats"),
    ("NV_materials_", Nothing, "materials"),
    ("OMI_", Nothing, "physics, seats and links of nodes"),
    ("VRM", Nothing, "avatars: bones, expressions and materials"),
];

/// Attributes stored as integers.
pub const QUANTIZATION: &str = "KHR_mesh_quantization";

/// The name under which a primitive's Draco data are stored.
pub const DRACO: &str = "KHR_draco_mesh_compression";

const INSTANCING: &str = "EXT_mesh_gpu_instancing";

fn holds(name: &str) -> Option<Holds> {
    REGISTRY.iter().find(|(known, ..)| name.starts_with(known)).map(|(_, holds, _)| *holds)
}

/// Checks what a document requires, and adds notes on what is used but not expanded. Extensions that are `allowed` by name pass.
pub fn check(root: &Fields<'_>, allowed: &[String], notes: &mut Vec<Note>) -> Result<(), ReadError> {
    let names = |list: &str| -> Result<Vec<Cow<'_, str>>, ReadError> {
        Ok(root.items(list)?.filter_map(|value| root.json.string(value)).collect())
    };
    for (number, name) in names("extensionsRequired")?.iter().enumerate() {
        let (what, advice) = match holds(name) {
            Some(Nothing | VertexOrder | TriangleOrder) => continue,
            _ if allowed.iter().any(|allowed| allowed == name) => continue,
            Some(Data) => ("", "convert the file to plain glTF 2.0 first".to_owned()),
            None => (
                ", which crease does not know",
                format!("if it holds no vertices, indices or their order, use --allow-extension {name}"),
            ),
        };
        let found = format!("unsupported required extension {name}{what}");
        let place = Place::Json(format!("/extensionsRequired/{number}"));
        return Err(ReadError::new(Problem::Unsupported, place, found, advice));
    }
    if names("extensionsUsed")?.iter().any(|name| name == INSTANCING) {
        let text = "EXT_mesh_gpu_instancing: only one of the instances is written to other formats";
        notes.push(Note::warning(Place::File, text));
    }
    Ok(())
}

/// Extensions that refer to vertices by number, so that none may be split, and whether they also refer to triangles.
pub fn ordered() -> impl Iterator<Item = (&'static str, bool)> {
    let order = |&(name, holds, _): &(&'static str, Holds, &str)| match holds {
        VertexOrder => Some((name, false)),
        TriangleOrder => Some((name, true)),
        Nothing | Data => None,
    };
    REGISTRY.iter().filter_map(order)
}

/// Whether `EXT_mesh_features` on a primitive numbers its features by vertex.
pub fn has_implicit_features(primitive: &Fields<'_>) -> bool {
    let json = primitive.json;
    let Some(extension) = primitive.extension("EXT_mesh_features") else { return false };
    json.items(extension, "featureIds")
        .any(|set| json.member(set, "attribute").is_none() && json.member(set, "texture").is_none())
}
