//! Editing a document so that only normals, and what depends on them, change.

mod encode;
mod group;
mod indices;
mod member;
mod refs;
mod remarks;
mod rows;
pub(super) mod store;
mod tangents;

use super::GltfDocument;
use super::package;
use crate::io::{Format, Loaded, Part, PartEdit, WriteError, WriteOptions, Written};
use group::Group;
use indices::rewrite_indices;
use member::Member;
use remarks::Remarks;
use rows::SlotTables;
use std::collections::BTreeMap;
use store::Store;

/// Writes a document again with changes, one entry of `edits` a part, in the spelling `to`.
///
/// Normals replace the stored ones in place where nothing else uses those bytes, or are appended; vertices are
/// split where corners need different normals, and then all their attributes are copied. Everything else stays
/// byte for byte.
///
/// # Errors
/// [`WriteError::Unsupported`] where an extension refers to vertices or triangles by number and these change;
/// [`WriteError::TooLarge`] for a GLB beyond 4 GiB.
pub fn edit(
    document: &GltfDocument,
    loaded: &Loaded,
    edits: &[PartEdit],
    to: Format,
    options: &WriteOptions,
) -> Result<Written, WriteError> {
    let mut store = Store::new(document);
    let mut remarks = Remarks::default();
    let source = refs::source(document);
    let mut tables = SlotTables::default();
    let mut groups: BTreeMap<usize, Vec<Member<'_>>> = BTreeMap::new();
    let mut added = 0;
    for member in Member::all(document, loaded, edits) {
        if member.has_normals() {
            groups.entry(member.block.source).or_default().push(member);
        } else {
            let indices = member.corners.iter().map(|&corner| member.vertex(corner)).collect();
            rewrite_indices(&mut store, &member, indices, member.block.count as usize, &mut remarks)?;
        }
    }
    for (number, members) in &groups {
        let group = Group { vertices: &document.sources[*number], members, source: &source, options };
        added += group.write(&mut store, &mut tables, &mut remarks)?;
    }
    if remarks.quantized {
        store.require("KHR_mesh_quantization");
    }
    let mut written = package::package(document, store, to, options)?;
    let vertices: usize = loaded.parts.iter().map(|part: &Part| part.mesh.vertex_count()).sum();
    written.vertices = vertices as u64 + added;
    written.added_vertices = added;
    remarks.tell(&mut written.notes);
    Ok(written)
}
