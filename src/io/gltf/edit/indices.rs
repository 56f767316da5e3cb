//! New indices for a primitive.

use crate::io::WriteError;
use crate::io::gltf::document::primitive::mode;
use crate::io::gltf::document::records::{Component, Format};
use crate::io::gltf::edit::member::Member;
use crate::io::gltf::edit::remarks::Remarks;
use crate::io::gltf::edit::store::{NewData, Store};
use crate::io::gltf::writer::data::Target;
use std::borrow::Cow;

/// Gives a primitive new triangles, as plain ones, if they are not what it has. Their type is as wide as it was, or
/// as it has to be for the number of vertices.
pub fn rewrite_indices(
    store: &mut Store<'_>,
    member: &Member<'_>,
    mut indices: Vec<u32>,
    vertices: usize,
    remarks: &mut Remarks,
) -> Result<(), WriteError> {
    let primitive = member.primitive;
    let moved = member.corners.iter().zip(&indices).any(|(&corner, &new)| member.vertex(corner) != new);
    if !moved && !member.reshaped {
        return Ok(());
    }
    remarks.check_order(store.document, member, &indices, moved)?;
    if indices.is_empty() {
        // glTF has no empty primitives, and taking this one out would renumber others.
        indices = vec![0; 3];
        remarks.emptied += 1;
    }
    let old = primitive.indices.and_then(|accessor| store.document.records.accessors[accessor].format);
    let old = old.map_or(Component::U16, |format| format.component);
    // The largest number of each type is forbidden.
    let component = match (old, vertices) {
        (Component::U8, ..=0xFF) => Component::U8,
        (Component::U8 | Component::U16, ..=0xFFFF) => Component::U16,
        _ => Component::U32,
    };
    let bytes: Vec<u8> = match component {
        Component::U8 => indices.iter().map(|&index| index as u8).collect(),
        Component::U16 => indices.iter().flat_map(|&index| (index as u16).to_le_bytes()).collect(),
        _ => bytemuck::cast_slice(&indices).to_vec(),
    };
    let data = NewData {
        format: Format::vector(component, false, 1),
        bytes: Cow::Owned(bytes),
        target: Target::Indices,
        same_bounds: false,
    };
    store.put(primitive.indices, "indices", &[primitive.object], &data);
    if primitive.mode != mode::TRIANGLES {
        store.splices.set(primitive.object, "mode", mode::TRIANGLES);
    }
    remarks.drop_draco(store, member);
    Ok(())
}
