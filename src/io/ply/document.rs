//! A PLY file as it was read.

use super::header::Header;
use super::property_roles::Roles;
use crate::mesh::{Column, ColumnIndex, Mesh};
use glam::DVec3;

/// A PLY file as it was read.
#[derive(Clone, Debug)]
pub struct PlyDocument {
    pub(super) bytes: Vec<u8>,
    pub(super) header: Header,
    pub(super) roles: Roles,
    /// Whether ascii rows share lines.
    pub(super) shared_lines: bool,
    pub(super) packed: Packed,
}

/// Whether stored normals are normalised integers.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct Packed {
    pub vertices: bool,
    pub faces: bool,
}

impl PlyDocument {
    /// The file as it was read.
    pub(in crate::io) fn source(&self) -> &[u8] {
        &self.bytes
    }

    /// The elements and properties that are not part of the mesh.
    pub(in crate::io) fn outside_meshes(&self) -> Vec<String> {
        let mut left = Vec::new();
        for (number, element) in self.header.elements.iter().enumerate() {
            match self.roles.used(number) {
                _ if element.count == 0 => {}
                None => left.push(format!("the element `{}`", element.name)),
                Some(used) => {
                    let names = element.properties.iter().enumerate().filter(|(at, _)| !used.contains(at));
                    let names: Vec<String> =
                        names.map(|(_, property)| format!("`{}`", property.name)).collect();
                    if !names.is_empty() {
                        left.push(format!("{} of the element `{}`", names.join(", "), element.name));
                    }
                }
            }
        }
        left
    }

    /// The stored normals of faces; `None` if vertices have some.
    pub(super) fn face_normals<'a>(&self, mesh: &'a Mesh) -> Option<&'a [DVec3]> {
        match &mesh.columns().normals {
            Some(Column { values, index: ColumnIndex::PerCorner(_) }) => Some(values),
            _ => None,
        }
    }
}
