//! A glTF document that is kept for editing: what it has, what its geometry takes, and how normals are stored.

use super::accessor::Source;
use super::buffers::{Buffers, Storage};
use super::compressed::Compression;
use super::extensions::{DRACO, QUANTIZATION};
use super::glb::{Glb, padded};
use super::nodes::NodeTree;
use super::records::{Accessor, Component, MESHOPT, Primitive, Records, VertexAccessors};
use crate::io::text::counted;
use crate::io::{Format, NormalFormat, Note, Place};
use std::borrow::Cow;
use std::cell::{Cell, RefCell};
use std::collections::{BTreeMap, BTreeSet};
use std::path::{Path, PathBuf};

/// A glTF document, kept for editing.
#[derive(Clone, Debug)]
pub struct GltfDocument {
    pub(in crate::io::gltf) records: Records,
    pub(in crate::io::gltf) buffers: Buffers,
    pub(in crate::io::gltf) glb: Option<Glb>,
    /// The primitives, by mesh and number, whose vertices no primitive before them has.
    pub(in crate::io::gltf) sources: Vec<(usize, usize)>,
    /// How each part is made of primitives, one a mesh.
    pub(in crate::io::gltf) layouts: Vec<Layout>,
    /// The materials in use, by their name among the labels of faces.
    pub(in crate::io::gltf) materials: BTreeMap<String, usize>,
    /// Image files that the document refers to and that are there: relative name and path.
    pub(in crate::io::gltf) images: Vec<(String, PathBuf)>,
    /// How its data were compressed in the file, if they were.
    pub(in crate::io::gltf) compression: Option<Compression>,
}

impl GltfDocument {
    /// The nodes; `None` if they do not form trees.
    pub(in crate::io) fn node_tree(&self) -> Option<NodeTree<'_>> {
        NodeTree::new(&self.records.json).ok()
    }

    pub(in crate::io) fn source(&self) -> &[u8] {
        match self.glb {
            Some(_) => &self.buffers.file,
            None => self.records.json.text().as_bytes(),
        }
    }

    /// Whether these bytes are those of the file that it was read from.
    pub(in crate::io) fn is_read_from(&self, bytes: &[u8]) -> bool {
        self.compression.is_none() && self.source() == bytes
    }

    /// Bytes of the document and its buffers.
    pub(in crate::io) fn bytes(&self) -> u64 {
        self.records.json.text().len() as u64 + self.buffers.total()
    }

    pub(in crate::io::gltf) fn vertex_accessors(&self, source: usize) -> &VertexAccessors {
        let (mesh, primitive) = self.sources[source];
        &self.records.meshes[mesh].primitives[primitive].vertices
    }

    pub(in crate::io::gltf) fn strings(&self, list: &str) -> impl Iterator<Item = Cow<'_, str>> {
        let json = &self.records.json;
        json.items(json.root(), list).filter_map(|value| json.string(value))
    }

    pub(in crate::io::gltf) fn lists(&self, list: &str, name: &str) -> bool {
        self.strings(list).any(|string| string == name)
    }

    /// A reader of accessors, all of which were checked when the document was read.
    pub(in crate::io::gltf) fn accessors(&self) -> Source<'_> {
        Source {
            records: &self.records,
            buffers: &self.buffers,
            implied_limit: u64::MAX,
            memory: Cell::new(u64::MAX),
            notes: RefCell::default(),
        }
    }
}

/// How a part's mesh is made of vertex blocks and primitives.
#[derive(Clone, Debug, Default)]
pub struct Layout {
    pub blocks: Vec<Block>,
    pub pieces: Vec<Piece>,
}

/// The vertices of one source within a part.
#[derive(Clone, Debug)]
pub struct Block {
    pub source: usize,
    pub first_vertex: u32,
    pub count: u32,
    /// Triangles use it.
    pub solid: bool,
    /// Where its stored normals begin among the part's, if it has any.
    pub first_normal: Option<u32>,
}

#[derive(Clone, Debug)]
pub struct Piece {
    pub primitive: usize,
    pub block: usize,
    pub first_face: u32,
    pub faces: u32,
}

/// Attributes that meshes of this program have.
const KNOWN: [&str; 4] = ["POSITION", "NORMAL", "TEXCOORD_0", "COLOR_0"];

/// Extensions of storage: once read, nothing of them is left.
const OF_STORAGE: [&str; 4] = [QUANTIZATION, DRACO, MESHOPT[0], MESHOPT[1]];

const LISTS: [(&str, &str, &str); 4] = [
    ("textures", "texture", "textures"),
    ("skins", "skin", "skins"),
    ("animations", "animation", "animations"),
    ("cameras", "camera", "cameras"),
];

impl GltfDocument {
    /// A vertex attribute of set `set` of a part; empty if no vertex has it.
    pub(in crate::io) fn attribute<T: Copy, const N: usize>(
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
                Some(elements) => all.extend(elements.floats::<N>(0.0).map(|x| Some(value(x)))),
                None => all.extend(std::iter::repeat_n(None, block.count as usize)),
            }
        }
        if all.iter().all(Option::is_none) { Vec::new() } else { all }
    }

    /// What does not reach a file of another format, in words. What a library of materials lacks is found when it is
    /// written.
    pub(in crate::io) fn outside_meshes(&self, has_library: bool) -> Vec<String> {
        let json = &self.records.json;
        let mut left = Vec::new();
        let materials = self.records.materials.len();
        if materials > 0 && !has_library {
            let materials = counted(materials, "material", "materials");
            left.push(format!("properties of {materials}"));
        }
        for (list, one, many) in LISTS.into_iter().filter(|(list, ..)| !has_library || *list != "textures") {
            let count = json.items(json.root(), list).count();
            left.extend((count > 0).then(|| counted(count, one, many)));
        }
        let names = self
            .records
            .primitives()
            .flat_map(|primitive| primitive.vertices.sets[0].iter().map(|(name, _)| name.as_str()));
        let names: BTreeSet<&str> = names.filter(|name| !KNOWN.contains(name)).collect();
        let names: Vec<&str> = names.into_iter().collect();
        if !names.is_empty() {
            left.push(format!("the vertex attributes {}", names.join(", ")));
        }
        let extensions = self.strings("extensionsUsed");
        let extensions: Vec<_> = extensions.filter(|name| !OF_STORAGE.contains(&name.as_ref())).collect();
        if !extensions.is_empty() {
            left.push(format!("the extensions {}", extensions.join(", ")));
        }
        left
    }

    /// Texture coordinates are written as they are stored, which a transform of textures would change.
    pub(in crate::io) fn texture_transform_note(&self, format: Format) -> Option<Note> {
        let has_uvs = matches!(format, Format::Obj | Format::Ply);
        let text = "texture coordinates were written without KHR_texture_transform";
        (has_uvs && self.lists("extensionsUsed", "KHR_texture_transform"))
            .then(|| Note::warning(Place::File, text))
    }
}

/// Bytes of the accessors of primitives. Elements of vertices begin at multiples of four bytes.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct GeometryBytes {
    /// Attributes and morph targets.
    pub vertices: u64,
    /// Indices.
    pub indices: u64,
}

impl GltfDocument {
    /// The bytes of vertices and indices, each accessor once.
    pub fn geometry_bytes(&self) -> GeometryBytes {
        let attributes =
            self.records.primitives().flat_map(|primitive| primitive.vertices.sets.iter().flatten());
        let attributes: BTreeSet<usize> = attributes.map(|(_, accessor)| *accessor).collect();
        let indices: BTreeSet<usize> =
            self.records.primitives().filter_map(|primitive| primitive.indices).collect();
        let size = |accessor: &Accessor| accessor.format.map_or(0, |format| format.size());
        let sum = |numbers: BTreeSet<usize>, size: &dyn Fn(&Accessor) -> usize| {
            let bytes = numbers.into_iter().map(|number| {
                let accessor = &self.records.accessors[number];
                (size(accessor) as u64).saturating_mul(accessor.count)
            });
            bytes.fold(0, u64::saturating_add)
        };
        GeometryBytes {
            vertices: sum(attributes, &|accessor| padded(size(accessor))),
            indices: sum(indices, &size),
        }
    }

    /// Whether some primitive needs its normals for more than the shape of its faces: it has tangents, normals of morph targets, or
    /// a material with a normal map.
    pub fn needs_normals(&self) -> bool {
        let json = &self.records.json;
        let has_map = |primitive: &Primitive| {
            let material = primitive.material.map(|material| self.records.materials[material]);
            let is_map =
                |key| json.string(key).is_some_and(|name| name.to_lowercase().ends_with("normaltexture"));
            material.is_some_and(|material| {
                let objects = json.descendants(material).chain([material]);
                objects.flat_map(|object| json.members(object)).any(|(key, _)| is_map(key))
            })
        };
        self.records.primitives().any(|primitive| primitive.vertices.need_normals() || has_map(primitive))
    }

    /// The widest type in which normals of triangles are stored; `None` if there are none.
    pub fn normal_format(&self) -> Option<NormalFormat> {
        let blocks = self.layouts.iter().flat_map(|layout| &layout.blocks).filter(|block| block.solid);
        let accessors = blocks.filter_map(|block| self.vertex_accessors(block.source).get("NORMAL"));
        let formats = accessors.map(|accessor| match self.records.accessors[accessor].format {
            Some(format) if format.normalized && format.component == Component::I8 => NormalFormat::I8,
            Some(format) if format.normalized && format.component == Component::I16 => NormalFormat::I16,
            _ => NormalFormat::F32,
        });
        formats.min_by_key(|format| match format {
            NormalFormat::I8 => 2,
            NormalFormat::I16 => 1,
            NormalFormat::F32 | NormalFormat::Same => 0,
        })
    }

    /// The files that it refers to and that are there: buffers, then images.
    pub fn companions(&self) -> impl Iterator<Item = &Path> {
        let buffers = self.buffers.list.iter().filter_map(|buffer| Some(buffer.storage.file()?.1));
        buffers.chain(self.images.iter().map(|(_, path)| path.as_path()))
    }

    /// The bytes of the document's text or GLB and of the buffers that are files of their own, compressed if they were.
    pub fn file_bytes(&self) -> u64 {
        if let Some(compression) = &self.compression {
            return compression.file_bytes();
        }
        let files = self.buffers.list.iter().filter_map(|buffer| match &buffer.storage {
            Storage::File { path, bytes, .. } => Some((path, bytes.len() as u64)),
            _ => None,
        });
        let files: BTreeMap<_, u64> = files.collect();
        self.source().len() as u64 + files.values().sum::<u64>()
    }
}
