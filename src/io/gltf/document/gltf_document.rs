//! A glTF document that is kept for editing.

use crate::io::gltf::container::buffers::Buffers;
use crate::io::gltf::container::glb::Glb;
use crate::io::gltf::document::accessor::Source;
use crate::io::gltf::document::records::{Records, VertexAccessors};
use std::borrow::Cow;
use std::cell::{Cell, RefCell};
use std::collections::BTreeMap;
use std::path::PathBuf;

/// A glTF document, kept for editing.
#[derive(Clone, Debug)]
pub struct GltfDocument {
    pub(in crate::io::gltf) records: Records,
    pub(in crate::io::gltf) buffers: Buffers,
    /// The chunks of the file, if it is a GLB.
    pub(in crate::io::gltf) glb: Option<Glb>,
    /// The primitives, by mesh and number, whose vertices no primitive before them has.
    pub(in crate::io::gltf) sources: Vec<(usize, usize)>,
    /// How each part is made of primitives, one a mesh.
    pub(in crate::io::gltf) layouts: Vec<Layout>,
    /// The materials in use, by their name among the labels of faces.
    pub(in crate::io::gltf) materials: BTreeMap<String, usize>,
    /// Image files that the document refers to and that are there: relative name and path.
    pub(in crate::io::gltf) images: Vec<(String, PathBuf)>,
}

impl GltfDocument {
    /// The file as it was read.
    pub(in crate::io) fn source(&self) -> &[u8] {
        match self.glb {
            Some(_) => &self.buffers.file,
            None => self.records.json.text().as_bytes(),
        }
    }

    /// Bytes of the document and its buffers.
    pub(in crate::io) fn bytes(&self) -> u64 {
        self.records.json.text().len() as u64 + self.buffers.total()
    }

    /// The vertex accessors of a source.
    pub(in crate::io::gltf) fn vertex_accessors(&self, source: usize) -> &VertexAccessors {
        let (mesh, primitive) = self.sources[source];
        &self.records.meshes[mesh].primitives[primitive].vertices
    }

    /// The strings of a top-level list.
    pub(in crate::io::gltf) fn strings(&self, list: &str) -> impl Iterator<Item = Cow<'_, str>> {
        let json = &self.records.json;
        json.items(json.root(), list).filter_map(|value| json.string(value))
    }

    /// Whether a top-level list of strings contains a certain one.
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

/// The triangles of one primitive within a part.
#[derive(Clone, Debug)]
pub struct Piece {
    pub primitive: usize,
    pub block: usize,
    pub first_face: u32,
    pub faces: u32,
}
