//! An edit of a document: only normals, and what depends on them, change.

use crate::io::gltf::document::gltf_document::GltfDocument;
use crate::io::gltf::edit::group::Group;
use crate::io::gltf::edit::member::Member;
use crate::io::gltf::edit::package;
use crate::io::gltf::edit::rows::SlotTables;
use crate::io::gltf::edit::store::Store;
use crate::io::gltf::extensions::QUANTIZATION;
use crate::io::{Format, Loaded, Note, Part, PartEdit, Place, WriteError, WriteOptions, Written};
use std::collections::BTreeMap;

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
    let source = document.accessors();
    let mut tables = SlotTables::default();
    let mut groups: BTreeMap<(usize, bool), Vec<Member<'_>>> = BTreeMap::new();
    for member in Member::all(document, loaded, edits) {
        groups.entry((member.block.source, member.has_normals())).or_default().push(member);
    }
    let mut added = 0;
    for ((number, new_normals), members) in &groups {
        let group = Group { vertices: document.vertex_accessors(*number), members, source: &source, options };
        if *new_normals {
            added += group.write(&mut store, &mut tables)?;
        } else {
            group.write_faces(&mut store)?;
        }
    }
    let remarks = std::mem::take(&mut store.remarks);
    if remarks.quantized {
        store.require(QUANTIZATION);
    }
    let mut written = package::package(document, store, to, options)?;
    let vertices: usize = loaded.parts.iter().map(|part: &Part| part.mesh.vertex_count()).sum();
    written.vertices = vertices as u64 + added;
    written.added_vertices = added;
    remarks.add_to(&mut written.notes);
    let drops = edits.iter().any(|edit| !edit.faces.dropped.is_empty());
    if (added > 0 || drops) && document.lists("extensionsUsed", "FB_geometry_metadata") {
        let text = "FB_geometry_metadata still counts the vertices and faces of the input";
        written.notes.push(Note::warning(Place::File, text));
    }
    Ok(written)
}
