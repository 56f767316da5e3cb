//! The limit on the memory for writing a mesh once for every node that shows it.
//!
//! A node takes a few bytes in a glTF file, so that a small file can show a mesh any number of times. The formats
//! without nodes need a copy for each.

use super::text::counted;
use super::{Document, Format, Loaded, PartEdit, WriteError};
use crate::mesh::{Column, FaceLabels, Mesh};

/// Memory that copies may take whatever the size of the file, and for each of its bytes: with the file itself this
/// keeps an input of 16 MiB within 512 MiB, and leaves room for a million instanced triangles in any file.
const FREE: u64 = 256 << 20;
const PER_BYTE: u64 = 16;

/// Refuses a file whose copies would not fit; `uses` is how many nodes show each part.
///
/// # Errors
/// [`WriteError::TooLarge`], with the counts.
pub(super) fn check(
    loaded: &Loaded,
    edits: &[PartEdit],
    uses: &[usize],
    format: Format,
) -> Result<(), WriteError> {
    let (mut copies, mut faces, mut memory) = (0_u64, 0_u64, 0_u64);
    for ((part, edit), &uses) in loaded.parts.iter().zip(edits).zip(uses).filter(|(_, uses)| **uses > 1) {
        // The first one is not a copy.
        let more = uses as u64 - 1;
        copies += more;
        faces = faces.saturating_add(more.saturating_mul(part.mesh.face_count() as u64));
        memory = memory.saturating_add(more.saturating_mul(size_of_copy(&part.mesh, edit)));
    }
    let file = if let Document::Gltf(document) = &loaded.document { document.bytes() } else { 0 };
    let limit = FREE.max(file.saturating_mul(PER_BYTE));
    if memory <= limit {
        return Ok(());
    }
    let nodes = counted(loaded.nodes.len(), "node shows", "nodes show");
    let meshes = counted(uses.iter().filter(|uses| **uses > 0).count(), "mesh", "meshes");
    Err(WriteError::TooLarge(format!(
        "{nodes} {meshes}: {format} has no instances, so {copies} copies with {faces} faces would take about {} MB of \
         memory, and the limit for a file of this size is {} MB; write .glb or .gltf, which keep instances, or divide \
         the scene",
        memory.div_ceil(1_000_000),
        limit / 1_000_000,
    )))
}

/// Bytes of memory for one more copy of a mesh, in the lists of the mesh and in the output; measured, it takes two thirds
/// to nine tenths of this.
fn size_of_copy(mesh: &Mesh, edit: &PartEdit) -> u64 {
    /// Text of three numbers, and of a corner of a face.
    const LINE: usize = 48;
    const CORNER: usize = 16;
    let columns = mesh.columns();
    let corners = mesh.faces().corner_count();
    let normals = edit.normals.as_ref().or(columns.normals.as_ref());
    let labels = [&columns.materials, &columns.objects].into_iter().flatten();
    let loose = columns.points.len() + columns.lines.iter().map(|line| 6 + line.len()).sum::<usize>();
    let bytes = mesh.vertex_count() * (24 + LINE + 24 * columns.morph_targets.len())
        + corners * (4 + CORNER)
        + size_of_column(normals, corners, LINE)
        + size_of_column(columns.uvs.as_ref(), corners, LINE)
        + edit.face_normals.as_ref().map_or(0, |normals| normals.len() * 24 + corners * 4)
        + columns.colors.as_ref().map_or(0, |colors| colors.len() * 16)
        + columns.smoothing.as_ref().map_or(0, |groups| groups.of_face.len() * 4)
        + labels.map(size_of_labels).sum::<usize>()
        + loose * 16
        // A part of its own, with its name.
        + 1024;
    bytes as u64
}

fn size_of_column<T>(column: Option<&Column<T>>, corners: usize, line: usize) -> usize {
    column.map_or(0, |column| column.values.len() * (size_of::<T>() + line) + 4 * corners)
}

fn size_of_labels(labels: &FaceLabels) -> usize {
    labels.of_face.len() * 4 + labels.names.iter().map(|name| 24 + 2 * name.len()).sum::<usize>()
}
