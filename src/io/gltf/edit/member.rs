//! The primitives that an edit changes, and their new indices.

use super::store::{NewData, Remark, Store};
use crate::io::gltf::data::Target;
use crate::io::gltf::document::{Block, GltfDocument, Piece};
use crate::io::gltf::extensions::{DRACO, ORDERED, has_implicit_features};
use crate::io::gltf::records::{Component, Format, Primitive};
use crate::io::{Loaded, PartEdit, WriteError};
use crate::mesh::{Column, Mesh};
use glam::DVec3;
use gltf::json::mesh::TRIANGLES;
use std::ops::Range;

/// The triangles of one primitive, as an edit leaves them.
pub struct Member<'a> {
    /// The glTF mesh, which is the part's number too.
    pub part: usize,
    pub primitive: &'a Primitive,
    pub block: &'a Block,
    pub mesh: &'a Mesh,
    pub edit: &'a PartEdit,
    /// Its corners, as numbers of the part's mesh.
    all: Range<u32>,
    /// Those that stay, in their new order, if faces were dropped or flipped.
    order: Option<Vec<u32>>,
}

impl<'a> Member<'a> {
    /// All primitives that an edit changes, in the order of the document.
    pub fn all(document: &'a GltfDocument, loaded: &'a Loaded, edits: &'a [PartEdit]) -> Vec<Member<'a>> {
        let mut members = Vec::new();
        for (part, (layout, edit)) in document.layouts.iter().zip(edits).enumerate() {
            if edit.normals.is_none() && edit.faces.is_empty() {
                continue;
            }
            for piece in &layout.pieces {
                let member = Member {
                    part,
                    primitive: &document.records.meshes[part].primitives[piece.primitive],
                    block: &layout.blocks[piece.block],
                    mesh: &loaded.parts[part].mesh,
                    edit,
                    all: 3 * piece.first_face..3 * (piece.first_face + piece.faces),
                    order: order(edit, piece),
                };
                if member.is_reshaped() || member.has_normals() {
                    members.push(member);
                }
            }
        }
        members
    }

    /// Whether faces were dropped or flipped.
    pub fn is_reshaped(&self) -> bool {
        self.order.is_some()
    }

    /// How many corners stay.
    pub fn corner_count(&self) -> usize {
        self.order.as_ref().map_or(self.all.len(), Vec::len)
    }

    /// The corners that stay, as numbers of the part's mesh, in their new order.
    pub fn corners(&self) -> impl Iterator<Item = u32> + Clone {
        (0..self.corner_count()).map(|number| match &self.order {
            None => self.all.start + number as u32,
            Some(order) => order[number],
        })
    }

    pub fn has_normals(&self) -> bool {
        let Some(normals) = &self.edit.normals else { return false };
        self.corners().any(|corner| self.slot(normals, corner).is_some())
    }

    /// Whether the edit has normals that are not the file's own.
    pub fn has_new_normals(&self) -> bool {
        let Some(normals) = &self.edit.normals else { return false };
        let mut slots = self.corners().filter_map(|corner| self.slot(normals, corner));
        slots.any(|slot| self.stored_element(slot).is_none())
    }

    /// Whether the edit has normals for each of so many morph targets.
    pub fn has_morph_normals(&self, targets: usize) -> bool {
        let values = self.edit.normals.as_ref().map_or(0, |normals| normals.values.len());
        let given = self.edit.morph_normals.iter().filter(|normals| normals.len() == values);
        given.count() >= targets
    }

    /// The vertex of a corner, as a number of the primitive's own accessors.
    pub fn vertex(&self, corner: u32) -> u32 {
        self.mesh.faces().corners()[corner as usize] - self.block.first_vertex
    }

    pub fn slot(&self, normals: &Column<DVec3>, corner: u32) -> Option<u32> {
        normals.slot(corner as usize, self.mesh.faces().corners()[corner as usize])
    }

    /// The element of the stored normals with a number, if it is one of the file's own.
    pub fn stored_element(&self, slot: u32) -> Option<usize> {
        if slot as usize >= self.edit.kept {
            return None;
        }
        let element = slot.checked_sub(self.block.first_normal?)?;
        (element < self.block.count).then_some(element as usize)
    }

    /// Whether an extension may refer to vertices by number.
    pub fn has_ordered_vertices(&self, document: &GltfDocument) -> bool {
        let primitive = document.records.fields(self.primitive.object);
        let mesh = document.records.fields(document.records.meshes[self.part].object);
        let is_used = |name: &str| primitive.extension(name).is_some() || mesh.extension(name).is_some();
        ORDERED.iter().any(|(name, _)| is_used(name))
            || has_implicit_features(&primitive)
            || document.lists("extensionsUsed", "FB_ngon_encoding")
    }

    /// Refuses to break an extension that refers to vertices or triangles by number; `moved` if some indices are of other vertices.
    fn check_order(&self, document: &GltfDocument, indices: &[u32], moved: bool) -> Result<(), WriteError> {
        let primitive = document.records.fields(self.primitive.object);
        let mesh = document.records.fields(document.records.meshes[self.part].object);
        let refuse = |name: &str, what: &str| {
            let text = format!(
                "{}: the extension {name} refers to {what} by number, and these would change; remove the extension, or keep \
                 the mesh unchanged (--crease off or --emit vertex splits no vertices; --degenerate keep without --flip and \
                 --orient keeps all faces)",
                primitive.place()
            );
            Err(WriteError::Unsupported(text))
        };
        for (name, has_triangles) in ORDERED {
            if primitive.extension(name).is_none() && mesh.extension(name).is_none() {
                continue;
            }
            if moved {
                return refuse(name, "vertices");
            }
            if self.is_reshaped() && has_triangles {
                return refuse(name, "triangles");
            }
        }
        if moved && has_implicit_features(&primitive) {
            return refuse("EXT_mesh_features", "vertices");
        }
        if document.lists("extensionsUsed", "FB_ngon_encoding") && !self.same_polygons(indices) {
            return refuse("FB_ngon_encoding", "the first corners of triangles");
        }
        Ok(())
    }

    /// Whether `FB_ngon_encoding` still makes the same polygons: neighbouring triangles with the same first corner are one.
    fn same_polygons(&self, indices: &[u32]) -> bool {
        let first_corners = || self.corners().step_by(3).zip(indices.iter().step_by(3));
        first_corners().zip(first_corners().skip(1)).all(|((old, new), (old_next, new_next))| {
            // Triangles that were not neighbours before belong to different polygons whatever their corners.
            let neighbours = old / 3 + 1 == old_next / 3;
            let before = neighbours && self.vertex(old) == self.vertex(old_next);
            before == (new == new_next)
        })
    }
}

/// The corners of a primitive's faces that are kept, with flipped faces, if any face was dropped or flipped.
fn order(edit: &PartEdit, piece: &Piece) -> Option<Vec<u32>> {
    let faces = piece.first_face..piece.first_face + piece.faces;
    let dropped = within(&edit.faces.dropped, &faces);
    let reversed = within(&edit.faces.reversed, &faces);
    if dropped.is_empty() && reversed.is_empty() {
        return None;
    }
    let kept = faces.filter(|face| dropped.binary_search(face).is_err());
    let corners = kept.flat_map(|face| {
        let first = 3 * face;
        let is_reversed = reversed.binary_search(&face).is_ok();
        if is_reversed { [first, first + 2, first + 1] } else { [first, first + 1, first + 2] }
    });
    Some(corners.collect())
}

fn within<'a>(sorted: &'a [u32], range: &Range<u32>) -> &'a [u32] {
    let start = sorted.partition_point(|&face| face < range.start);
    let end = sorted.partition_point(|&face| face < range.end);
    &sorted[start..end]
}

/// Stores the new triangles of a primitive if they differ from the old ones, and returns whether they do.
pub fn rewrite_indices(
    store: &mut Store<'_>,
    member: &Member<'_>,
    mut indices: Vec<u32>,
    vertices: usize,
) -> Result<bool, WriteError> {
    let primitive = member.primitive;
    let moved = member.corners().zip(&indices).any(|(corner, &new)| member.vertex(corner) != new);
    if !moved && !member.is_reshaped() {
        return Ok(false);
    }
    member.check_order(store.document, &indices, moved)?;
    if indices.is_empty() {
        // glTF has no empty primitives, and taking this one out would renumber others.
        indices = vec![0; 3];
        store.remark(Remark::EMPTIED, 1);
    }
    let component = index_component(store.document, primitive, vertices);
    let bytes: Vec<u8> = match component {
        Component::U8 => indices.iter().map(|&index| index as u8).collect(),
        Component::U16 => indices.iter().flat_map(|&index| (index as u16).to_le_bytes()).collect(),
        _ => bytemuck::cast_slice(&indices).to_vec(),
    };
    let format = Format::vector(component, false, 1);
    let data = NewData { format, bytes, target: Target::Indices, same_bounds: false };
    store.put(primitive.indices, "indices", &[primitive.object], data);
    if primitive.mode != u64::from(TRIANGLES) {
        store.splices.set(primitive.object, "mode", TRIANGLES);
    }
    Ok(true)
}

/// The type of new indices of so many vertices: that of the old ones, or a wider one if necessary.
pub fn index_component(document: &GltfDocument, primitive: &Primitive, vertices: usize) -> Component {
    let old = primitive.indices.and_then(|accessor| document.records.accessors[accessor].format);
    let old = old.map_or(Component::U16, |format| format.component);
    // The largest number of each type is forbidden.
    match (old, vertices) {
        (Component::U8, ..=0xFF) => Component::U8,
        (Component::U8 | Component::U16, ..=0xFFFF) => Component::U16,
        _ => Component::U32,
    }
}

pub fn drop_draco(store: &mut Store<'_>, member: &Member<'_>) {
    let json = &store.document.records.json;
    let extensions = json.member(member.primitive.object, "extensions");
    if let Some(extensions) = extensions.filter(|&extensions| json.member(extensions, DRACO).is_some()) {
        store.splices.remove(extensions, DRACO);
        store.remark(Remark::DRACO_REMOVED, 1);
    }
}
