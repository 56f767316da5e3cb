//! Writing a file of any format: edited in its own document, or new.

use super::instances;
use super::text::counted;
use super::{Document, Emit, FileMaterial, Format, Loaded, NormalFormat, Note, Part, PartEdit};
use super::{Place, WriteError, WriteOptions, Written};
use super::{gltf, obj, ply, stl};
use crate::mesh::{Column, Mesh, TransformFault};
use glam::DMat4;
use std::borrow::Cow;

/// Writes a file with changes, one entry of `edits` a part (missing ones change nothing).
///
/// In its own format the document is edited, and everything that does not change survives byte for byte; a file
/// without changes is copied. glTF and GLB are one format here. In another format a new file is made: each node gives a copy
/// of its part with its transform applied, and what the format cannot store is noted.
///
/// For STL, and with [`Emit::Face`], the normals are [`PartEdit::face_normals`]. Owned edits
/// avoid a copy.
///
/// # Errors
/// [`WriteError`] for content that the format cannot store and that must not be dropped, or cannot count.
pub fn write<'a>(
    loaded: &Loaded,
    edits: impl Into<Cow<'a, [PartEdit]>>,
    format: Format,
    options: &WriteOptions,
) -> Result<Written, WriteError> {
    let mut edits = edits.into();
    if edits.len() < loaded.parts.len() {
        edits.to_mut().resize(loaded.parts.len(), PartEdit::default());
    }
    let mut notes = Vec::new();
    if !format.is_gltf() && options.normal_format != NormalFormat::Same {
        let text =
            format!("only glTF has a choice of how normals are stored; here they are as {format} has them");
        notes.push(Note::warning(Place::File, text));
    }
    if format == loaded.format || format.is_gltf() && loaded.format.is_gltf() {
        let mut written = edit(loaded, &edits, format, options)?;
        written.notes.splice(0..0, notes);
        return Ok(written);
    }
    let parts = placed(loaded, edits, format, options, &mut notes)?;
    let left = loaded.document.outside_meshes();
    if !left.is_empty() {
        let text = format!("a new file is made of the meshes alone; left out: {}", left.join(", "));
        notes.push(Note::warning(Place::File, text));
    }
    if let Document::Gltf(document) = &loaded.document {
        notes.extend(document.texture_transform_note(format));
    }
    let mut written = write_parts(format, &parts, loaded.document.materials(), options)?;
    written.notes.splice(0..0, notes);
    Ok(written)
}

/// Writes meshes as a new file, each a part of its own. What the format cannot store is noted.
///
/// For STL, and with [`Emit::Face`], a mesh's normals have to be those of its faces: shared by the corners of each.
///
/// ```
/// use crease::io::{Format, Part, WriteOptions, write_new};
/// use crease::surface::{Sphere, Surface, Tessellation};
///
/// let mesh = Surface::from(Sphere::default()).tessellate(&Tessellation::default()).unwrap();
/// let part = Part { name: "sphere".into(), mesh, ..Part::default() };
/// let written = write_new(&[part], Format::Ply, &WriteOptions::default())?;
/// assert!(written.bytes.starts_with(b"ply"));
/// # Ok::<(), crease::io::WriteError>(())
/// ```
///
/// # Errors
/// [`WriteError`] for content that the format cannot store and that must not be dropped, or cannot count.
pub fn write_new(parts: &[Part], format: Format, options: &WriteOptions) -> Result<Written, WriteError> {
    write_parts(format, parts, &[], options)
}

/// Writes a file again in its own format. glTF may change its container.
fn edit(
    loaded: &Loaded,
    edits: &[PartEdit],
    to: Format,
    options: &WriteOptions,
) -> Result<Written, WriteError> {
    match &loaded.document {
        Document::Obj(document) => obj::edit(document, loaded, edits, options),
        Document::Gltf(document) => gltf::edit(document, loaded, edits, to, options),
        Document::Ply(document) => ply::edit(document, loaded, edits, options),
        Document::Stl(document) => stl::edit(document, loaded, edits, options),
        Document::None => Err(WriteError::no_document()),
    }
}

fn write_parts(
    format: Format,
    parts: &[Part],
    materials: &[FileMaterial],
    options: &WriteOptions,
) -> Result<Written, WriteError> {
    match format {
        Format::Obj => obj::write(parts, options),
        Format::Gltf | Format::Glb => gltf::write_with_materials(parts, materials, format, options),
        Format::Stl => stl::write(parts, options),
        Format::Ply => ply::write(parts, options),
    }
}

/// The parts to write: edited, with the transforms of the nodes applied.
fn placed(
    loaded: &Loaded,
    mut edits: Cow<'_, [PartEdit]>,
    format: Format,
    options: &WriteOptions,
    notes: &mut Vec<Note>,
) -> Result<Vec<Part>, WriteError> {
    let by_face = format == Format::Stl || options.emit == Emit::Face;
    let mut uses = vec![0_usize; loaded.parts.len()];
    for node in &loaded.nodes {
        uses[node.part] += 1;
    }
    instances::check(loaded, &edits, &uses, format)?;
    let mut edited = |number: usize, is_last_use: bool| {
        let part = &loaded.parts[number];
        let mesh = match &mut edits {
            Cow::Owned(edits) if is_last_use => {
                edited_mesh(&part.mesh, std::mem::take(&mut edits[number]), by_face)
            }
            edits => edited_mesh(&part.mesh, edits[number].clone(), by_face),
        };
        Part { name: part.name.clone(), mesh, non_finite_faces: Vec::new() }
    };
    if loaded.nodes.is_empty() {
        return Ok((0..loaded.parts.len()).map(|number| edited(number, true)).collect());
    }
    let unused = uses.iter().filter(|&&uses| uses == 0).count();
    if unused > 0 {
        let meshes = counted(unused, "mesh", "meshes");
        notes.push(Note::warning(Place::File, format!("left out, because no node shows it: {meshes}")));
    }
    let mut flattened = 0;
    let mut parts = Vec::with_capacity(loaded.nodes.len());
    for node in &loaded.nodes {
        uses[node.part] -= 1;
        let mut part = edited(node.part, uses[node.part] == 0);
        if node.world_from_part != DMat4::IDENTITY {
            let had_normals = part.mesh.columns().normals.is_some();
            part.mesh = part.mesh.transformed(node.world_from_part).map_err(|TransformFault::Overflow| {
                let name = &node.name;
                let text = format!(
                    "the node `{name}` moves a vertex beyond the range of numbers; correct its transform"
                );
                WriteError::Unsupported(text)
            })?;
            flattened += usize::from(had_normals && part.mesh.columns().normals.is_none());
        }
        if !node.name.is_empty() {
            part.name.clone_from(&node.name);
        }
        parts.push(part);
    }
    if flattened > 0 {
        let nodes = counted(flattened, "node", "nodes");
        let text = format!("meshes that a node squeezes flat have no normals there: {nodes}");
        notes.push(Note::warning(Place::File, text));
    }
    Ok(parts)
}

/// The mesh with an edit applied.
fn edited_mesh(mesh: &Mesh, edit: PartEdit, by_face: bool) -> Mesh {
    let normals = match edit.face_normals {
        Some(normals) if by_face => Some(Column::per_corner(normals, mesh.faces().owners())),
        _ => edit.normals,
    };
    let mesh = match normals {
        Some(normals) => mesh.clone().with_normals(Some(normals)),
        None => mesh.clone(),
    };
    if edit.faces.is_empty() { mesh } else { mesh.with_faces(&edit.faces) }
}
