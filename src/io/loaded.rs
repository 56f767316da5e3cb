//! A file as it was read.

use super::gltf::{GltfDocument, NodeTree};
use super::obj::ObjDocument;
use super::part::{FileNode, Part};
use super::ply::PlyDocument;
use super::stl::StlDocument;
use super::{Appearance, FileMaterial, Format, Note, gltf};
use crate::mesh::Movement;
use glam::{DMat4, DVec3, DVec4};

/// A file, read.
#[derive(Clone, Debug)]
pub struct Loaded {
    /// The format that it was in.
    pub format: Format,
    /// Its meshes. OBJ and PLY have one, STL one a solid, glTF one a glTF mesh, 3MF one an object with a mesh.
    pub parts: Vec<Part>,
    /// Where the meshes are placed in the world; empty if the format has no nodes (each part is then placed once, with
    /// the identity transform).
    pub nodes: Vec<FileNode>,
    /// What was repaired, skipped or refused.
    pub notes: Vec<Note>,
    /// The document itself, for editing it in place.
    pub document: Document,
}

impl Loaded {
    /// The file for inspection only, in less memory: without the bytes of PLY and STL and without the text of OBJ, except
    /// [its line numbers](super::obj::ObjDocument::lines). In STL, where each facet repeats its vertices, equal positions become
    /// one vertex. The document of glTF stays: attributes are read from it on demand.
    ///
    /// OBJ, PLY and STL can then not be [written](super::write) in their own format, which edits the document.
    ///
    /// ```
    /// use crease::io::{Format, ReadOptions, WriteOptions, read_bytes, write};
    ///
    /// let facet = "facet normal 0 0 1 outer loop vertex 0 0 0 vertex 1 0 0 vertex 0 1 0 endloop endfacet ";
    /// let text = format!("solid\n{facet}{facet}endsolid");
    /// let loaded = read_bytes(text.into_bytes(), Some(Format::Stl), None, &ReadOptions::default())?;
    /// assert_eq!(loaded.parts[0].mesh.vertex_count(), 6);
    /// let loaded = loaded.without_source();
    /// assert_eq!(loaded.parts[0].mesh.vertex_count(), 3);
    /// assert!(write(&loaded, &[], Format::Stl, &WriteOptions::default()).is_err());
    /// # Ok::<(), crease::io::ReadError>(())
    /// ```
    pub fn without_source(mut self) -> Self {
        match &mut self.document {
            Document::Obj(document) => document.forget_text(),
            Document::Ply(_) | Document::Stl(_) => self.document = Document::None,
            Document::Gltf(_) | Document::Forgotten(_) | Document::None => {}
        }
        if self.format == Format::Stl {
            for part in &mut self.parts {
                part.mesh = std::mem::take(&mut part.mesh).with_shared_vertices();
            }
        }
        self
    }

    /// Moves vertices of each mesh to the first one that stays and is at most this fraction of the mesh's diagonal away, so that
    /// [`Merge::Exact`](super::Merge::Exact) can merge them. Only for a file that will be written in another format: editing keeps
    /// the stored positions.
    pub fn move_together(&mut self, fraction: f64) -> Movement {
        let moved = self.parts.iter_mut().map(|part| part.mesh.move_together(fraction));
        moved.fold(Movement::default(), Movement::and)
    }

    /// Frees what only editing the file in its own format takes: the bytes of PLY and STL, and the text of OBJ with
    /// [its line numbers](super::obj::ObjDocument::lines). The document of glTF stays. Such a file can then only be written as new.
    pub fn forget_source(&mut self) {
        match &mut self.document {
            Document::Obj(document) => document.free_text(),
            Document::Ply(_) | Document::Stl(_) => {
                self.document = Document::Forgotten(self.document.outside_meshes(false));
            }
            Document::Gltf(_) | Document::Forgotten(_) | Document::None => {}
        }
    }

    /// Materials, cameras and lights; of files that were never read, and of PLY and STL, none.
    ///
    /// ```
    /// use crease::io::{Format, ReadOptions, read_bytes};
    ///
    /// let camera = r#"{"type": "perspective", "perspective": {"yfov": 0.5, "znear": 0.1}}"#;
    /// let text = format!(r#"{{"asset": {{"version": "2.0"}}, "cameras": [{camera}], "nodes": [{{"camera": 0}}]}}"#);
    /// let loaded = read_bytes(text.into_bytes(), Some(Format::Gltf), None, &ReadOptions::default())?;
    /// assert_eq!(loaded.appearance().cameras.len(), 1);
    /// # Ok::<(), crease::io::ReadError>(())
    /// ```
    pub fn appearance(&self) -> Appearance {
        match &self.document {
            Document::Gltf(document) => gltf::appearance(document),
            document => Appearance { materials: document.materials().to_vec(), ..Appearance::default() },
        }
    }

    /// The names of some nodes with those of all above them, from the root on, as `body/arm/hand`; nodes without a name are
    /// given by their number, as `#7`. The names of the placed objects of a 3MF. Empty strings for formats without nodes.
    pub fn node_paths(&self, numbers: &[usize]) -> Vec<String> {
        let tree = self.node_tree();
        let name = |node: usize| self.nodes.get(node).map_or(String::new(), |node| node.name.clone());
        numbers.iter().map(|&node| tree.as_ref().map_or_else(|| name(node), |tree| tree.path(node))).collect()
    }

    /// The nodes of the file; `None` for formats without nodes (all but glTF).
    pub(crate) fn node_tree(&self) -> Option<NodeTree<'_>> {
        if let Document::Gltf(document) = &self.document { document.node_tree() } else { None }
    }

    /// The tangents of a part's vertices with their handedness, where they have one; empty if no vertex has, and for
    /// formats without tangents (all but glTF).
    pub fn tangents(&self, part: usize) -> Vec<Option<DVec4>> {
        let Document::Gltf(document) = &self.document else { return Vec::new() };
        document.attribute(part, 0, "TANGENT", |t: [f32; 4]| DVec4::from_array(t.map(f64::from)))
    }

    /// What a morph target adds to the normals of a part's vertices, where it has normals; empty if it has none, and for
    /// formats without morph targets (all but glTF).
    pub fn morph_normals(&self, part: usize, target: usize) -> Vec<Option<DVec3>> {
        let Document::Gltf(document) = &self.document else { return Vec::new() };
        let value = |n: [f32; 3]| DVec3::from_array(n.map(f64::from));
        document.attribute(part, target + 1, "NORMAL", value)
    }

    /// Where each part is placed in the world: nowhere if no node has it; once, with the identity, if there are no nodes at all.
    pub(crate) fn places(&self) -> Vec<Vec<DMat4>> {
        if self.nodes.is_empty() {
            return vec![vec![DMat4::IDENTITY]; self.parts.len()];
        }
        let mut places = vec![Vec::new(); self.parts.len()];
        self.nodes.iter().for_each(|node| places[node.part].push(node.world_from_part));
        places
    }
}

/// A document kept for editing. Its content is private to the readers and writers of its format.
#[derive(Clone, Debug)]
pub enum Document {
    /// Nothing kept: the file can only be written as new.
    None,
    /// Freed by [`Loaded::forget_source`]; what it had that is not part of its meshes, in words.
    Forgotten(Vec<String>),
    /// An OBJ file.
    Obj(Box<ObjDocument>),
    /// glTF, in either spelling.
    Gltf(Box<GltfDocument>),
    /// A PLY file.
    Ply(Box<PlyDocument>),
    /// An STL file.
    Stl(Box<StlDocument>),
}

impl Document {
    /// Whether these bytes are those that the document was read from.
    pub fn is_unchanged(&self, bytes: &[u8]) -> bool {
        match self {
            Document::None | Document::Forgotten(_) => false,
            Document::Obj(document) => document.source() == Some(bytes),
            Document::Gltf(document) => document.is_read_from(bytes),
            Document::Ply(document) => document.bytes == bytes,
            Document::Stl(document) => document.bytes == bytes,
        }
    }

    /// The materials in the material libraries of an OBJ.
    pub(super) fn materials(&self) -> &[FileMaterial] {
        match self {
            Document::Obj(document) => document.materials(),
            _ => &[],
        }
    }

    /// What the document has that is not part of its meshes, in words. A new file lacks it, except for materials if it
    /// has a library of them.
    pub(super) fn outside_meshes(&self, has_library: bool) -> Vec<String> {
        match self {
            Document::None | Document::Obj(_) => Vec::new(),
            Document::Forgotten(outside) => outside.clone(),
            Document::Gltf(document) => document.outside_meshes(has_library),
            Document::Ply(document) => document.outside_meshes(),
            Document::Stl(document) => document.outside_meshes(),
        }
    }
}
