//! The primitives and corners that an edit changes.

use crate::io::gltf::document::gltf_document::{Block, GltfDocument, Piece};
use crate::io::gltf::document::records::Primitive;
use crate::io::{Loaded, PartEdit};
use crate::mesh::{Column, Mesh};
use glam::DVec3;
use std::ops::Range;

/// The triangles of one primitive, as an edit leaves them.
pub struct Member<'a> {
    /// The glTF mesh, which is the part's number too.
    pub part: usize,
    pub primitive: &'a Primitive,
    pub block: &'a Block,
    pub mesh: &'a Mesh,
    pub edit: &'a PartEdit,
    /// The corners that stay, as numbers of the part's mesh, in their new order.
    pub corners: Vec<u32>,
    /// Faces were dropped or flipped.
    pub reshaped: bool,
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
                let (corners, reshaped) = order(edit, piece);
                let member = Member {
                    part,
                    primitive: &document.records.meshes[part].primitives[piece.primitive],
                    block: &layout.blocks[piece.block],
                    mesh: &loaded.parts[part].mesh,
                    edit,
                    corners,
                    reshaped,
                };
                if reshaped || member.has_normals() {
                    members.push(member);
                }
            }
        }
        members
    }

    /// Whether the edit gives any corner a normal.
    pub fn has_normals(&self) -> bool {
        let Some(normals) = &self.edit.normals else { return false };
        self.corners.iter().any(|&corner| self.slot(normals, corner).is_some())
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

    /// The number of the normal of a corner.
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
}

/// The corners of a primitive's faces that are kept, with flipped faces, and whether any face was dropped or flipped.
fn order(edit: &PartEdit, piece: &Piece) -> (Vec<u32>, bool) {
    let faces = piece.first_face..piece.first_face + piece.faces;
    let dropped = within(&edit.faces.dropped, &faces);
    let reversed = within(&edit.faces.reversed, &faces);
    if dropped.is_empty() && reversed.is_empty() {
        return ((3 * faces.start..3 * faces.end).collect(), false);
    }
    let kept = faces.filter(|face| dropped.binary_search(face).is_err());
    let corners = kept.flat_map(|face| {
        let first = 3 * face;
        let is_reversed = reversed.binary_search(&face).is_ok();
        if is_reversed { [first, first + 2, first + 1] } else { [first, first + 1, first + 2] }
    });
    (corners.collect(), true)
}

fn within<'a>(sorted: &'a [u32], range: &Range<u32>) -> &'a [u32] {
    let start = sorted.partition_point(|&face| face < range.start);
    let end = sorted.partition_point(|&face| face < range.end);
    &sorted[start..end]
}
