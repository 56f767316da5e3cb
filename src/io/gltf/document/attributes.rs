//! What goes with normals but is no part of a mesh: tangents, what morph targets do to normals, and the way to a node.

use crate::io::gltf::GltfDocument;
use crate::io::gltf::document::accessor::Source;
use crate::io::gltf::document::mesh::VertexSource;
use crate::io::gltf::document::nodes::NodeTree;
use crate::io::{Document, Limits, Loaded};
use glam::{DVec3, DVec4};
use std::cell::Cell;

impl GltfDocument {
    /// The tangents of a part's vertices, where they have one.
    fn tangents(&self, part: usize) -> Vec<Option<DVec4>> {
        self.of_vertices(
            part,
            |source| source.get("TANGENT"),
            |t: [f32; 4]| DVec4::from_array(t.map(f64::from)),
        )
    }

    /// What a morph target adds to the normals of a part's vertices, where it says so.
    fn morph_normals(&self, part: usize, target: usize) -> Vec<Option<DVec3>> {
        let find = |source: VertexSource<'_>| source.target(target, "NORMAL");
        self.of_vertices(part, find, |n: [f32; 3]| DVec3::from_array(n.map(f64::from)))
    }

    /// An attribute of all vertices of a part; none where its primitive has none. Reading the file has checked that all
    /// of it is there.
    fn of_vertices<T: Copy, const N: usize>(
        &self,
        part: usize,
        find: impl Fn(VertexSource<'_>) -> Option<usize>,
        value: impl Fn([f32; N]) -> T,
    ) -> Vec<Option<T>> {
        let source = Source {
            records: &self.records,
            buffers: &self.buffers,
            implied_limit: Limits::default().implied_elements,
            memory: Cell::new(u64::MAX),
        };
        let mut all = Vec::new();
        for block in &self.layouts[part].blocks {
            let accessor = find(self.vertex_source(block.source));
            let elements = accessor.and_then(|accessor| source.elements(accessor).ok());
            match elements {
                Some(elements) => all.extend(elements.floats::<N>(0.0).into_iter().map(|x| Some(value(x)))),
                None => all.extend(std::iter::repeat_n(None, block.count as usize)),
            }
        }
        if all.iter().all(Option::is_none) { Vec::new() } else { all }
    }
}

impl Loaded {
    /// The names of some nodes with those of all above them, from the root on, as `body/arm/hand`; nodes without a name are
    /// told by their number, as `#7`. Empty strings for formats without nodes (all but glTF).
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
            Document::Gltf(document) => document.tangents(part),
            _ => Vec::new(),
        }
    }

    /// What a morph target adds to the normals of a part's vertices, where it says so; empty if it says nothing, and for
    /// formats without morph targets (all but glTF).
    pub fn morph_normals(&self, part: usize, target: usize) -> Vec<Option<DVec3>> {
        match &self.document {
            Document::Gltf(document) => document.morph_normals(part, target),
            _ => Vec::new(),
        }
    }
}
