//! New indices for a primitive, and the extensions that forbid them.

use crate::io::WriteError;
use crate::io::gltf::document::gltf_document::GltfDocument;
use crate::io::gltf::document::primitive::mode;
use crate::io::gltf::document::records::{Component, Format};
use crate::io::gltf::edit::member::Member;
use crate::io::gltf::edit::store::{NewData, Store};
use crate::io::gltf::extensions::{DRACO, ORDERED, has_implicit_features};
use crate::io::gltf::writer::data::Target;
use std::borrow::Cow;

/// Gives a primitive new triangles, as plain ones, if they are not what it has, and returns whether they are not. Their type
/// is as wide as it was, or as it has to be for the number of vertices.
pub fn rewrite_indices(
    store: &mut Store<'_>,
    member: &Member<'_>,
    mut indices: Vec<u32>,
    vertices: usize,
) -> Result<bool, WriteError> {
    let primitive = member.primitive;
    let moved = member.corners.iter().zip(&indices).any(|(&corner, &new)| member.vertex(corner) != new);
    if !moved && !member.reshaped {
        return Ok(false);
    }
    check_order(store.document, member, &indices, moved)?;
    if indices.is_empty() {
        // glTF has no empty primitives, and taking this one out would renumber others.
        indices = vec![0; 3];
        store.remarks.emptied += 1;
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
    Ok(true)
}

/// Removes a compressed copy of a primitive that differs from it now.
pub fn drop_draco(store: &mut Store<'_>, member: &Member<'_>) {
    let json = &store.document.records.json;
    let extensions = json.member(member.primitive.object, "extensions");
    if let Some(extensions) = extensions.filter(|&extensions| json.member(extensions, DRACO).is_some()) {
        store.splices.remove(extensions, DRACO);
        store.remarks.draco_dropped += 1;
    }
}

/// Refuses to break an extension that counts vertices or triangles. `indices` are the new ones; `moved` if
/// some of them are of other vertices.
fn check_order(
    document: &GltfDocument,
    member: &Member<'_>,
    indices: &[u32],
    moved: bool,
) -> Result<(), WriteError> {
    let at = member.primitive.at;
    let primitive = document.records.fields(member.primitive.object, at);
    let mesh = document.records.fields(document.records.meshes[member.part].object, at);
    let refuse = |name: &str, what: &str| {
        let text = format!(
            "{}: the extension {name} refers to {what} by number, and these would change; keep them as they are \
             (--crease off or --emit vertex splits none, --degenerate keep and no --flip or --orient keeps all \
             faces), or take the extension out first",
            at.place()
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
        if member.reshaped && has_triangles {
            return refuse(name, "triangles");
        }
    }
    if moved && has_implicit_features(&primitive) {
        return refuse("EXT_mesh_features", "vertices");
    }
    if document.lists("extensionsUsed", "FB_ngon_encoding") && !same_polygons(member, indices) {
        return refuse("FB_ngon_encoding", "the first corners of triangles");
    }
    Ok(())
}

/// Whether triangles that `FB_ngon_encoding` makes into polygons still are, and no others: neighbours in the list
/// belong together if they have the same first corner.
fn same_polygons(member: &Member<'_>, indices: &[u32]) -> bool {
    let first_corners = || member.corners.chunks_exact(3).zip(indices.chunks_exact(3));
    first_corners().zip(first_corners().skip(1)).all(|((old, new), (old_next, new_next))| {
        // Triangles that were not neighbours before belong to different polygons whatever their corners.
        let neighbours = old[0] / 3 + 1 == old_next[0] / 3;
        let before = neighbours && member.vertex(old[0]) == member.vertex(old_next[0]);
        before == (new[0] == new_next[0])
    })
}
