//! What the geometry of a document takes, and how its normals are stored.

use super::buffers::Storage;
use super::document::GltfDocument;
use super::glb::padded;
use super::records::{Accessor, Component, Primitive};
use crate::io::NormalFormat;
use std::collections::{BTreeMap, BTreeSet};
use std::path::Path;

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

    /// The bytes of the document's text or GLB and of the buffers that are files of their own.
    pub fn file_bytes(&self) -> u64 {
        let files = self.buffers.list.iter().filter_map(|buffer| match &buffer.storage {
            Storage::File { path, bytes, .. } => Some((path, bytes.len() as u64)),
            _ => None,
        });
        let files: BTreeMap<_, u64> = files.collect();
        self.source().len() as u64 + files.values().sum::<u64>()
    }
}
