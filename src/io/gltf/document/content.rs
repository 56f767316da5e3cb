//! Content of a document that is not in meshes: tangents, normals of morph targets, paths to nodes, and what other formats
//! cannot hold.

use crate::io::gltf::document::gltf_document::GltfDocument;
use crate::io::gltf::document::nodes::NodeTree;
use crate::io::gltf::document::records::MESHOPT;
use crate::io::gltf::extensions::{DRACO, QUANTIZATION};
use crate::io::text::counted;
use crate::io::{Document, Format, Loaded, Note, Place};
use glam::{DVec3, DVec4};
use std::collections::BTreeSet;

/// Attributes that meshes of this program have.
const KNOWN: [&str; 4] = ["POSITION", "NORMAL", "TEXCOORD_0", "COLOR_0"];

/// Extensions of storage: once read, nothing of them is left.
const OF_STORAGE: [&str; 4] = [QUANTIZATION, DRACO, MESHOPT[0], MESHOPT[1]];

/// Lists of the document and how their elements are called.
const LISTS: [(&str, &str, &str); 4] = [
    ("textures", "texture", "textures"),
    ("skins", "skin", "skins"),
    ("animations", "animation", "animations"),
    ("cameras", "camera", "cameras"),
];

impl GltfDocument {
    /// A vertex attribute of set `set` of a part; empty if no vertex has it.
    fn attribute<T: Copy, const N: usize>(
        &self,
        part: usize,
        set: usize,
        semantic: &str,
        value: impl Fn([f32; N]) -> T,
    ) -> Vec<Option<T>> {
        let source = self.accessors();
        let mut all = Vec::new();
        for block in &self.layouts[part].blocks {
            let accessor = self.vertex_accessors(block.source).of_set(set, semantic);
            match accessor.and_then(|accessor| source.elements(accessor).ok()) {
                Some(elements) => all.extend(elements.floats::<N>(0.0).into_iter().map(|x| Some(value(x)))),
                None => all.extend(std::iter::repeat_n(None, block.count as usize)),
            }
        }
        if all.iter().all(Option::is_none) { Vec::new() } else { all }
    }

    /// What does not reach a file of another format, in words.
    pub(in crate::io) fn outside_meshes(&self) -> Vec<String> {
        let json = &self.records.json;
        let mut left = Vec::new();
        let materials = self.records.materials.len();
        if materials > 0 {
            let materials = counted(materials, "material", "materials");
            left.push(format!("colours and other properties of {materials}"));
        }
        for (list, one, many) in LISTS {
            let count = json.items(json.root(), list).count();
            left.extend((count > 0).then(|| counted(count, one, many)));
        }
        let primitives = self.records.meshes.iter().flat_map(|mesh| &mesh.primitives);
        let attributes = primitives.flat_map(|primitive| &primitive.vertices.sets[0]);
        let names = attributes.map(|(name, _)| name.as_str()).filter(|name| !KNOWN.contains(name));
        let names: Vec<&str> = names.collect::<BTreeSet<_>>().into_iter().collect();
        if !names.is_empty() {
            left.push(format!("the vertex attributes {}", names.join(", ")));
        }
        let extensions = self.strings("extensionsUsed");
        let extensions: Vec<_> = extensions.filter(|name| !OF_STORAGE.contains(&name.as_ref())).collect();
        if !extensions.is_empty() {
            left.push(format!("what the extensions {} say", extensions.join(", ")));
        }
        left
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

impl Loaded {
    /// The names of some nodes with those of all above them, from the root on, as `body/arm/hand`; nodes without a name are
    /// given by their number, as `#7`. Empty strings for formats without nodes (all but glTF).
    pub fn node_paths(&self, numbers: &[usize]) -> Vec<String> {
        let tree = self.node_tree();
        numbers.iter().map(|&node| tree.as_ref().map_or(String::new(), |tree| tree.path(node))).collect()
    }

    /// The nodes of the file; `None` for formats without nodes (all but glTF).
    pub(crate) fn node_tree(&self) -> Option<NodeTree<'_>> {
        match &self.document {
            Document::Gltf(document) => NodeTree::new(&document.records.json).ok(),
            _ => None,
        }
    }

    /// The tangents of a part's vertices with their handedness, where they have one; empty if no vertex has, and for
    /// formats without tangents (all but glTF).
    pub fn tangents(&self, part: usize) -> Vec<Option<DVec4>> {
        match &self.document {
            Document::Gltf(document) => {
                document.attribute(part, 0, "TANGENT", |t: [f32; 4]| DVec4::from_array(t.map(f64::from)))
            }
            _ => Vec::new(),
        }
    }

    /// What a morph target adds to the normals of a part's vertices, where it has normals; empty if it has none, and for
    /// formats without morph targets (all but glTF).
    pub fn morph_normals(&self, part: usize, target: usize) -> Vec<Option<DVec3>> {
        match &self.document {
            Document::Gltf(document) => {
                let value = |n: [f32; 3]| DVec3::from_array(n.map(f64::from));
                document.attribute(part, target + 1, "NORMAL", value)
            }
            _ => Vec::new(),
        }
    }
}
