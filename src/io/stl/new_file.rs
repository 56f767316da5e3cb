//! A new binary STL from any meshes.

use super::document::{FACET, FIRST, HEADER};
use crate::io::mesh_checks::{beyond_f32, displacement_note, needs_f64, unsupported_notes};
use crate::io::{Emit, Format, Note, Part, Place, WriteError, WriteOptions, Written};
use crate::mesh::{Mesh, triangulate};
use glam::DVec3;

/// A binary STL of all parts, cut into triangles. Facets without a normal that all corners of their face share have 0 0 0.
/// Fails for a position beyond the range of `f32`, and for more facets than 32 bits count.
pub(in crate::io) fn write(parts: &[Part], options: &WriteOptions) -> Result<Written, WriteError> {
    let mut bytes = header(parts);
    let mut count = 0_u64;
    let mut without_normal = 0;
    for part in parts {
        let mesh = &part.mesh;
        if mesh.positions().iter().any(|p| !p.as_vec3().is_finite()) {
            return Err(beyond_f32(mesh));
        }
        // One for each face. To check all corners of a polygon for each of its triangles would take quadratic time.
        let normals: Vec<Option<DVec3>> =
            (0..mesh.face_count()).map(|face| shared_normal(mesh, face)).collect();
        let triangulation = triangulate(mesh);
        count += triangulation.triangles.len() as u64;
        bytes.reserve(triangulation.triangles.len() * FACET);
        for (triangle, face) in triangulation.triangles.into_iter().zip(triangulation.source_face) {
            let normal = normals[face as usize];
            without_normal += usize::from(normal.is_none());
            let corners = triangle.map(|corner| mesh.faces().corners()[corner as usize] as usize);
            let [a, b, c] = corners.map(|vertex| stored(mesh.positions().at(vertex as u32)));
            let vectors = [normal.map_or([0.0; 3], stored), a, b, c];
            let vectors = vectors.map(|vector| vector.map(f32::to_le_bytes));
            bytes.extend_from_slice(vectors.as_flattened().as_flattened());
            bytes.extend([0, 0]);
        }
    }
    let counted = u32::try_from(count)
        .map_err(|_| WriteError::TooLarge(format!("{count} facets, more than STL can count")))?;
    bytes[HEADER..FIRST].copy_from_slice(&counted.to_le_bytes());
    let notes = notes(parts, without_normal, options);
    Ok(Written { bytes, notes, vertices: 3 * count, ..Written::default() })
}

/// The header, which must not begin with `solid`.
fn header(parts: &[Part]) -> Vec<u8> {
    let mut text = concat!("crease ", env!("CARGO_PKG_VERSION")).to_owned();
    for (k, part) in parts.iter().filter(|part| !part.name.is_empty()).enumerate() {
        text.push_str(if k == 0 { ": " } else { ", " });
        text.extend(part.name.chars().map(|c| if (' '..='~').contains(&c) { c } else { '_' }));
        if text.len() >= HEADER {
            break;
        }
    }
    let mut bytes = text.into_bytes();
    bytes.resize(HEADER, 0);
    bytes.resize(FIRST, 0);
    bytes
}

fn shared_normal(mesh: &Mesh, face: usize) -> Option<DVec3> {
    let normals = mesh.columns().normals.as_ref()?;
    let mut slots =
        mesh.faces().range(face).map(|corner| normals.slot(corner, mesh.faces().corners()[corner]));
    let first = slots.next()??;
    slots.all(|slot| slot == Some(first)).then(|| normals.values[first as usize])
}

fn notes(parts: &[Part], without_normal: usize, options: &WriteOptions) -> Vec<Note> {
    let mut notes = Vec::new();
    let any = |test: &dyn Fn(&Mesh) -> bool| parts.iter().any(|part| test(&part.mesh));
    if any(&|mesh| mesh.face_count() > 0) {
        notes.extend(vertex_normals_note(options));
    }
    notes.extend(Note::counted(without_normal, ["facet has", "facets have"], "no normal; 0 0 0 was written"));
    if parts.len() > 1 {
        let text = format!("a binary STL has one solid: {} meshes were merged", parts.len());
        notes.push(Note::warning(Place::File, text));
    }
    notes.extend(unsupported_notes(Format::Stl, parts));
    let displaced: Vec<Note> = parts.iter().filter_map(|part| displacement_note(&part.mesh)).collect();
    if !displaced.is_empty() {
        notes.extend(displaced);
    } else if any(&needs_f64) {
        notes.push(Note::remark("positions were rounded to 32-bit floats"));
    }
    notes
}

pub(super) fn stored(normal: DVec3) -> [f32; 3] {
    normal.as_vec3().to_array()
}

/// The warning that vertex normals are lost, unless the caller asked for those of faces.
pub(super) fn vertex_normals_note(options: &WriteOptions) -> Option<Note> {
    let text = "STL has no vertex normals; one normal per facet was written";
    (options.emit != Emit::Face).then(|| Note::warning(Place::File, text))
}
