//! What a document holds beside meshes and the nodes that show them.

use crate::io::gltf::GltfDocument;
use crate::io::gltf::json::tree::Value;
use crate::io::text::counted;
use crate::io::{Format, Note, Place};
use std::collections::BTreeSet;

/// Attributes that meshes of this program have.
const KNOWN: [&str; 4] = ["POSITION", "NORMAL", "TEXCOORD_0", "COLOR_0"];

/// Extensions of storage: once read, nothing of them is left.
const OF_STORAGE: [&str; 4] = [
    "KHR_mesh_quantization",
    "KHR_draco_mesh_compression",
    "EXT_meshopt_compression",
    "KHR_meshopt_compression",
];

/// Lists of the document and how their elements are called.
const LISTS: [(&str, &str, &str); 4] = [
    ("textures", "texture", "textures"),
    ("skins", "skin", "skins"),
    ("animations", "animation", "animations"),
    ("cameras", "camera", "cameras"),
];

impl GltfDocument {
    /// What does not reach a file of another format, in words.
    pub(in crate::io) fn outside_meshes(&self) -> Vec<String> {
        let json = &self.records.json;
        let count = |list: Option<Value>| list.map_or(0, |list| json.elements(list).count());
        let materials = self.records.materials.len();
        let mut left = Vec::new();
        if materials > 0 {
            left.push(format!(
                "colours and other properties of {}",
                counted(materials, "material", "materials")
            ));
        }
        let lists = LISTS.iter().map(|&(name, one, many)| (count(json.member(json.root(), name)), one, many));
        left.extend(lists.filter(|list| list.0 > 0).map(|(count, one, many)| counted(count, one, many)));
        let attributes = self.other_attributes();
        if !attributes.is_empty() {
            left.push(format!(
                "the vertex attributes {}",
                attributes.into_iter().collect::<Vec<_>>().join(", ")
            ));
        }
        let extensions = self.other_extensions();
        if !extensions.is_empty() {
            left.push(format!("what the extensions {} say", extensions.join(", ")));
        }
        left
    }

    fn other_attributes(&self) -> BTreeSet<&str> {
        let primitives = self.records.meshes.iter().flat_map(|mesh| &mesh.primitives);
        let all =
            primitives.flat_map(|primitive| primitive.attributes.list.iter().map(|(name, _)| name.as_str()));
        all.filter(|name| !KNOWN.contains(name)).collect()
    }

    fn other_extensions(&self) -> Vec<String> {
        let json = &self.records.json;
        let list = json.member(json.root(), "extensionsUsed");
        let names =
            list.into_iter().flat_map(|list| json.elements(list)).filter_map(|name| json.string(name));
        names.filter(|name| !OF_STORAGE.contains(&name.as_ref())).map(|name| name.into_owned()).collect()
    }

    /// Texture coordinates are written as they are stored, which a transform of textures would change.
    pub(in crate::io) fn texture_transform_note(&self, format: Format) -> Option<Note> {
        let has_uvs = matches!(format, Format::Obj | Format::Ply);
        let text =
            "texture coordinates are those of the file, without the KHR_texture_transform of its textures";
        (has_uvs && self.lists("extensionsUsed", "KHR_texture_transform"))
            .then(|| Note::warning(Place::File, text))
    }
}
