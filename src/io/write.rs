//! Writing a file of any format: edited in its own document, or new.

use super::text::counted;
use super::{
    Document, Emit, FileMaterial, Format, Loaded, Merge, MeshCompression, NormalFormat, Note, Part, PartEdit,
    Place, WriteError, WriteOptions, Written, gltf, obj, ply, stl,
};
use crate::mesh::{AxisConversion, Column, FaceLabels, Mesh, TransformFault};
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
        let text = format!("{format} has no choice of normal formats; only glTF has one");
        notes.push(Note::warning(Place::File, text));
    }
    if options.compression != MeshCompression::None && format != Format::Glb {
        return Err(WriteError::not_compressible(format));
    }
    if options.merge == Merge::Exact && format.edits(loaded.format) && !format.is_gltf() {
        let text = format!("{format} keeps the vertices of an input in its own format; none were merged");
        notes.push(Note::warning(Place::File, text));
    }
    let mut written = if format.edits(loaded.format) {
        match &loaded.document {
            Document::Obj(document) => obj::edit(document, loaded, &edits, options),
            Document::Gltf(document) => gltf::edit(document, loaded, edits, format, options),
            Document::Ply(document) => ply::edit(document, loaded, &edits, options),
            Document::Stl(document) => stl::edit(document, loaded, &edits, options),
            Document::None | Document::Forgotten(_) => Err(WriteError::no_document()),
        }?
    } else {
        let mut parts = placed(loaded, edits, format, options, &mut notes)?;
        if let Some(conversion) = options.conversion {
            convert(&mut parts, conversion)?;
        }
        let has_library = format == Format::Obj && options.stem.is_some();
        let left = loaded.document.outside_meshes(has_library);
        if !left.is_empty() {
            let text = format!("a new file has only the meshes; omitted: {}", left.join(", "));
            notes.push(Note::warning(Place::File, text));
        }
        if let Document::Gltf(document) = &loaded.document {
            notes.extend(document.texture_transform_note(format));
        }
        let materials: Cow<'_, [FileMaterial]> = match &loaded.document {
            Document::Gltf(document) if has_library => {
                gltf::materials_with_images(document, options.stem.as_deref()).into()
            }
            document => document.materials().into(),
        };
        write_parts(format, &parts, &materials, options)?
    };
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

fn write_parts(
    format: Format,
    parts: &[Part],
    materials: &[FileMaterial],
    options: &WriteOptions,
) -> Result<Written, WriteError> {
    match format {
        Format::Obj => obj::write(parts, materials, options),
        Format::Gltf | Format::Glb => gltf::write(parts, materials, format, options),
        Format::Stl => stl::write(parts, options),
        Format::Ply => ply::write(parts, options),
        Format::ThreeMf => Err(WriteError::Unsupported("3MF has no normals; write another format".into())),
    }
}

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
    check_copies(loaded, &edits, &uses, format)?;
    let mut edited = |number: usize, is_last_use: bool| {
        let part = &loaded.parts[number];
        let edit = match &mut edits {
            Cow::Owned(edits) if is_last_use => std::mem::take(&mut edits[number]),
            edits => edits[number].clone(),
        };
        let mesh = edited_mesh(&part.mesh, edit, by_face);
        Part { name: part.name.clone(), mesh, non_finite_faces: Vec::new() }
    };
    if loaded.nodes.is_empty() {
        return Ok((0..loaded.parts.len()).map(|number| edited(number, true)).collect());
    }
    let unused = uses.iter().filter(|&&uses| uses == 0).count();
    notes.extend(Note::counted(
        unused,
        ["mesh has no node and was omitted", "meshes have no node and were omitted"],
        "",
    ));
    let mut flattened = 0;
    let mut parts = Vec::with_capacity(loaded.nodes.len());
    for node in &loaded.nodes {
        uses[node.part] -= 1;
        let mut part = edited(node.part, uses[node.part] == 0);
        if node.world_from_part != DMat4::IDENTITY {
            let had_normals = part.mesh.columns().normals.is_some();
            part.mesh = part.mesh.transformed(node.world_from_part).map_err(|TransformFault::Overflow| {
                let name = &node.name;
                let text = format!("the transform of node `{name}` moves a vertex out of range; correct it");
                WriteError::Unsupported(text)
            })?;
            flattened += usize::from(had_normals && part.mesh.columns().normals.is_none());
        }
        if !node.name.is_empty() {
            part.name.clone_from(&node.name);
        }
        parts.push(part);
    }
    let transforms = [
        "node transform flattens its mesh and makes normals undefined",
        "node transforms flatten their meshes and make normals undefined",
    ];
    notes.extend(Note::counted(flattened, transforms, ""));
    Ok(parts)
}

fn convert(parts: &mut [Part], conversion: AxisConversion) -> Result<(), WriteError> {
    let largest =
        |part: &Part| part.mesh.bounds().map_or(0.0, |(low, high)| low.abs().max(high.abs()).max_element());
    for part in parts {
        let before = largest(part);
        part.mesh = part.mesh.converted(conversion).map_err(|TransformFault::Overflow| {
            let text = "the scale moves a vertex out of range; use a smaller --scale".to_owned();
            WriteError::Unsupported(text)
        })?;
        if before > 0.0 && largest(part) < f64::from(f32::MIN_POSITIVE) {
            let text =
                "the scale makes all coordinates smaller than 1.2e-38; use a larger --scale".to_owned();
            return Err(WriteError::Unsupported(text));
        }
    }
    Ok(())
}

fn edited_mesh(mesh: &Mesh, edit: PartEdit, by_face: bool) -> Mesh {
    let normals = match edit.face_normals {
        Some(normals) if by_face => Some(Column::per_corner(normals, mesh.faces().owners())),
        _ => edit.normals,
    };
    let mut mesh = mesh.clone();
    if let Some(normals) = normals {
        mesh = mesh.with_normals(Some(normals));
    }
    if edit.faces.is_empty() { mesh } else { mesh.with_faces(&edit.faces) }
}

/// Memory for copies in any file, and for each byte of the file: an input of 16 MiB stays within 512 MiB.
const FREE: u64 = 256 << 20;
const PER_BYTE: u64 = 16;

/// Refuses a file whose copies need too much memory; `uses` is how many nodes show each part.
fn check_copies(
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
    let nodes = counted(loaded.nodes.len(), "node", "nodes");
    let meshes = counted(uses.iter().filter(|uses| **uses > 0).count(), "mesh", "meshes");
    Err(WriteError::TooLarge(format!(
        "{format} has no instances: {copies} copies with {faces} faces for {nodes} of {meshes} need about {} MB of \
         memory (limit for a file of this size: {} MB); write .glb or .gltf, which keep instances, or split the scene",
        memory.div_ceil(1_000_000),
        limit / 1_000_000,
    )))
}

/// Bytes of memory for one more copy of a mesh and its output; measured, it takes two thirds to nine tenths of this.
fn size_of_copy(mesh: &Mesh, edit: &PartEdit) -> u64 {
    /// Text of three numbers, and of a corner of a face.
    const LINE: usize = 48;
    const CORNER: usize = 16;
    let columns = mesh.columns();
    let corners = mesh.faces().corner_count();
    let normals = edit.normals.as_ref().or(columns.normals.as_ref());
    let size_of_labels = |labels: &FaceLabels| {
        labels.of_face.len() * 4 + labels.names.iter().map(|name| 24 + 2 * name.len()).sum::<usize>()
    };
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
