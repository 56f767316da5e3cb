//! Bytes to a PLY document and its mesh.

use super::document::{FaceRole, Packed, PlyDocument, Roles, VertexRole};
use super::header;
use super::header::{Element, Header, Kind};
use super::rows::{OVERLONG, Row, Rows, places, vertex_index};
use super::scalar::{Encoding, Scalar};
use crate::io::error::{NoteKind, RepeatedNotes};
use crate::io::mesh_checks::check_size;
use crate::io::mesh_checks::{build_part, non_finite_note};
use crate::io::text::{counted, in_text, storage_of_text};
use crate::io::{Document, Format, Loaded, Note, Place, Problem, ReadError, ReadOptions, Severity};
use crate::mesh::{Column, Faces, MeshBuilder, MeshError, NONE, Positions, Storage};
use glam::{DVec2, DVec3};
use std::collections::BTreeSet;
use std::path::Path;

const SHORT_FACE: NoteKind = NoteKind::warning(0, "a face with fewer than 3 corners was skipped");
const NOT_FINITE: NoteKind =
    NoteKind::warning(1, "a colour or texture coordinate that is not finite was read as 0");

/// Reads a PLY file, which has no companion files. Normals stored as integers are divided by the largest of their type if one of
/// them is over 1. Vertices without faces or edges are points.
///
/// # Errors
/// With the line or the byte: an invalid header, a body that ends too early, words that are not numbers, vertex indices out of
/// range, positions that are not finite (unless [`ReadOptions::non_finite`] allows them).
pub fn read(bytes: Vec<u8>, _base: Option<&Path>, options: &ReadOptions) -> Result<Loaded, ReadError> {
    check_size(bytes.len() as u64, &options.limits)?;
    let header = header::parse(&bytes)?;
    let roles = Roles::of(&header)?;
    let place = |offset: usize| places(&bytes, header.encoding, &[offset]).remove(0);
    let mut rows = Rows::new(&bytes, &header, false);
    let mut reading = Reading::of(&mut rows, &header, &roles);
    if reading.as_ref().is_err_and(|error| error.problem == Problem::Truncated) && rows.notes.has(OVERLONG) {
        // What was skipped behind rows may be rows.
        let mut shared = Rows::new(&bytes, &header, true);
        if let Ok(other) = Reading::of(&mut shared, &header, &roles) {
            (reading, rows) = (Ok(other), shared);
        }
    }
    let reading = reading.map_err(|error| match header.encoding {
        Encoding::Ascii => in_text(error, &bytes),
        _ => error,
    })?;
    let mut notes = notes(&reading, &rows, &header);
    notes.extend(non_finite_note(reading.mesh.positions.view(), options.non_finite));
    let Reading { mesh, packed, non_finite, out_of_range, .. } = reading;
    let part = build_part(String::new(), mesh, options, |error| {
        let offset = match error {
            MeshError::NonFinite { .. } => non_finite,
            MeshError::VertexOutOfRange { .. } => out_of_range,
            _ => None,
        };
        offset.map_or(Place::File, place)
    })?;
    let shared_lines = rows.shared_lines;
    let document = Document::Ply(Box::new(PlyDocument { bytes, header, roles, shared_lines, packed }));
    Ok(Loaded { format: Format::Ply, parts: vec![part], nodes: Vec::new(), notes, document })
}

/// The mesh in the making, and what was found on the way.
#[derive(Default)]
struct Reading {
    mesh: MeshBuilder,
    notes: RepeatedNotes,
    packed: Packed,
    /// Where the first row is that has a position that is not finite.
    non_finite: Option<usize>,
    /// Where the row of the first face is that refers to a vertex that does not exist. Triangles of strips have no such row.
    out_of_range: Option<usize>,
}

impl Reading {
    fn of(rows: &mut Rows<'_>, header: &Header, roles: &Roles) -> Result<Self, ReadError> {
        let mut reading = Self::default();
        let vertex = &roles.vertex;
        let count = header.elements[vertex.element].count;
        for (at, element) in header.elements.iter().enumerate() {
            match (&roles.face, &roles.edge) {
                _ if vertex.element == at => reading.vertices(rows, element, vertex)?,
                (Some(face), _) if face.element == at && face.are_strips => {
                    reading.strips(rows, element, face)?;
                }
                (Some(face), _) if face.element == at => reading.faces(rows, element, face, vertex, count)?,
                (_, Some((edge, ends))) if *edge == at => reading.edges(rows, element, *ends)?,
                _ => rows.each(element, |_, _, _| Ok(()))?,
            }
        }
        let mesh = &mut reading.mesh;
        if mesh.faces.is_empty() && mesh.columns.lines.is_empty() {
            mesh.columns.points = (0..count as u32).collect();
        }
        Ok(reading)
    }

    fn vertices(
        &mut self,
        rows: &mut Rows<'_>,
        element: &Element,
        role: &VertexRole,
    ) -> Result<(), ReadError> {
        let kinds: Vec<Scalar> = element.properties.iter().map(|property| property.kind.scalar()).collect();
        let count = rows.plausible_count(element);
        let (mesh, notes, non_finite) = (&mut self.mesh, &mut self.notes, &mut self.non_finite);
        let is = |scalars: &[Scalar]| role.position.into_iter().all(|at| scalars.contains(&kinds[at]));
        // Wide integers may be more than an `f32` holds, and so may text.
        let is_narrow = is(&[Scalar::F32, Scalar::I8, Scalar::U8, Scalar::I16, Scalar::U16]);
        let are_singles = is_narrow && rows.encoding != Encoding::Ascii;
        let mut singles: Vec<[f32; 3]> = Vec::with_capacity(if are_singles { count } else { 0 });
        let mut doubles = Vec::with_capacity(if are_singles { 0 } else { count });
        let mut normals = role.normal.map(|_| Vec::with_capacity(count));
        let mut uvs = role.uv.map(|_| Vec::with_capacity(count));
        let mut colors = role.color.map(|_| Vec::with_capacity(count));
        rows.each(element, |_, row, rows| {
            let value = |at: usize| rows.scalar(&row.fields[at], kinds[at]);
            let vector = |[x, y, z]: [usize; 3]| Ok(DVec3::new(value(x)?, value(y)?, value(z)?));
            let position = vector(role.position)?;
            if !position.is_finite() && non_finite.is_none() {
                *non_finite = row.fields.first().map(|field| field.start);
            }
            match are_singles {
                true => singles.push(position.as_vec3().to_array()),
                false => doubles.push(position),
            }
            if let (Some(normal), Some(normals)) = (role.normal, &mut normals) {
                normals.push(vector(normal)?);
            }
            if let (Some([u, v]), Some(uvs)) = (role.uv, &mut uvs) {
                let uv = DVec2::new(value(u)?, value(v)?);
                uvs.push(notes.valid_or_zero(NOT_FINITE, row.span.start, uv.is_finite(), uv));
            }
            if let (Some(color), Some(colors)) = (role.color, &mut colors) {
                let full = |scalar: Scalar| if scalar.is_integer() { scalar.largest() } else { 1.0 };
                let channel = |at: usize| Ok((value(at)? / full(kinds[at])) as f32);
                let [r, g, b] = color.map(channel);
                let color = [r?, g?, b?, role.opacity.map_or(Ok(1.0), channel)?];
                let is_finite = color.iter().all(|value| value.is_finite());
                colors.push(notes.valid_or_zero(NOT_FINITE, row.span.start, is_finite, color));
            }
            Ok(())
        })?;
        let exact = |at: usize| match kinds[at] {
            Scalar::F64 => false,
            Scalar::I32 | Scalar::U32 => doubles.iter().all(|p| p.as_vec3().as_dvec3() == *p),
            _ => true,
        };
        mesh.positions = match (role.position.into_iter().all(exact), rows.encoding) {
            _ if are_singles => singles.into(),
            (true, Encoding::Ascii) if !is(&[Scalar::F32]) => {
                let storage = storage_of_text(&[&doubles]);
                Positions::rounded(doubles, storage)
            }
            (true, _) => Positions::rounded(doubles, Storage::F32),
            (false, _) => doubles.into(),
        };
        if let (Some([x, ..]), Some(normals)) = (role.normal, &mut normals) {
            self.packed.vertices = unpack(normals, kinds[x]);
        }
        mesh.columns.normals = normals.map(Column::per_vertex).or(mesh.columns.normals.take());
        mesh.columns.uvs = uvs.map(Column::per_vertex).or(mesh.columns.uvs.take());
        mesh.columns.colors = colors;
        Ok(())
    }

    /// Reads faces. Their normals and texture coordinates count only if vertices have none.
    fn faces(
        &mut self,
        rows: &mut Rows<'_>,
        element: &Element,
        role: &FaceRole,
        vertex: &VertexRole,
        vertex_count: u64,
    ) -> Result<(), ReadError> {
        let kind = element.properties[role.list].kind;
        let (mut corners, mut normals, mut uvs) = (Vec::new(), Vec::new(), CornerUvs::default());
        let mesh = &mut self.mesh;
        mesh.faces = Faces::with_capacity(3 * rows.plausible_count(element));
        rows.each(element, |_, row, rows| {
            rows.corners(&row.fields[role.list], kind, &mut corners)?;
            if corners.len() < 3 {
                self.notes.add(SHORT_FACE, row.fields[role.list].start);
                return Ok(());
            }
            if corners.iter().any(|&corner| u64::from(corner) >= vertex_count) && self.out_of_range.is_none()
            {
                self.out_of_range = row.fields.first().map(|field| field.start);
            }
            mesh.faces.push(&corners);
            if let Some(normal) = role.normal {
                let [x, y, z] =
                    normal.map(|at| rows.scalar(&row.fields[at], element.properties[at].kind.scalar()));
                normals.push(DVec3::new(x?, y?, z?));
            }
            if let Some(at) = role.corner_uvs {
                uvs.push(rows, row, at, element.properties[at].kind, corners.len(), &mut self.notes)?;
            }
            Ok(())
        })?;
        if let Some([x, ..]) = role.normal {
            self.packed.faces = unpack(&mut normals, element.properties[x].kind.scalar());
        }
        if vertex.normal.is_none() && !normals.is_empty() {
            mesh.columns.normals = Some(Column::per_corner(normals, mesh.faces.owners()));
        }
        if vertex.uv.is_none() && !uvs.values.is_empty() {
            mesh.columns.uvs = Some(Column::per_corner(uvs.values, uvs.index));
        }
        Ok(())
    }

    fn strips(&mut self, rows: &mut Rows<'_>, element: &Element, role: &FaceRole) -> Result<(), ReadError> {
        let kind = element.properties[role.list].kind;
        rows.each(element, |_, row, rows| {
            // The last two vertices, and whether the next triangle is reversed.
            let (mut last, mut reversed) = ([NONE; 2], false);
            for item in rows.items(&row.fields[role.list], kind) {
                let value = rows.scalar(&item, kind.scalar())?;
                if value == -1.0 {
                    (last, reversed) = ([NONE; 2], false);
                    continue;
                }
                let [a, b] = last;
                let c = vertex_index(value, item.start)?;
                if a != NONE {
                    // Triangles that repeat a vertex only join two strips.
                    if a != b && b != c && a != c {
                        self.mesh.faces.push(&if reversed { [b, a, c] } else { [a, b, c] });
                    }
                    reversed = !reversed;
                }
                last = [b, c];
            }
            Ok(())
        })
    }

    fn edges(&mut self, rows: &mut Rows<'_>, element: &Element, ends: [usize; 2]) -> Result<(), ReadError> {
        rows.each(element, |_, row, rows| {
            let [a, b] = ends.map(|at| {
                let field = &row.fields[at];
                vertex_index(rows.scalar(field, element.properties[at].kind.scalar())?, field.start)
            });
            self.mesh.columns.lines.push(vec![a?, b?]);
            Ok(())
        })
    }
}

#[derive(Default)]
struct CornerUvs {
    values: Vec<DVec2>,
    /// One a corner, [`NONE`] where a face has no uv.
    index: Vec<u32>,
    /// The list of one face: where each number is, and the number.
    list: Vec<(usize, f64)>,
}

impl CornerUvs {
    /// Appends the list of a face: two coordinates a corner, or else nothing.
    fn push(
        &mut self,
        rows: &Rows<'_>,
        row: &Row,
        at: usize,
        kind: Kind,
        corners: usize,
        notes: &mut RepeatedNotes,
    ) -> Result<(), ReadError> {
        self.list.clear();
        for item in rows.items(&row.fields[at], kind) {
            self.list.push((item.start, rows.scalar(&item, kind.scalar())?));
        }
        if self.list.len() != 2 * corners {
            self.index.extend(std::iter::repeat_n(NONE, corners));
            return Ok(());
        }
        for &[(_, u), (at, v)] in self.list.as_chunks().0 {
            let uv = DVec2::new(u, v);
            self.index.push(self.values.len() as u32);
            self.values.push(notes.valid_or_zero(NOT_FINITE, at, uv.is_finite(), uv));
        }
        Ok(())
    }
}

/// Divides normalised integers by the largest of their type, if any of them exceeds 1; says whether it did.
fn unpack(normals: &mut [DVec3], scalar: Scalar) -> bool {
    let largest = normals.iter().fold(0.0, |m: f64, n| m.max(n.abs().max_element()));
    let packed = matches!(scalar, Scalar::I8 | Scalar::I16 | Scalar::I32) && largest > 1.0;
    if packed {
        normals.iter_mut().for_each(|normal| *normal /= scalar.largest());
    }
    packed
}

fn notes(reading: &Reading, rows: &Rows<'_>, header: &Header) -> Vec<Note> {
    let mut found = reading.notes.clone();
    found.append(rows.notes.clone());
    let places = |offsets: &[usize]| places(rows.bytes, header.encoding, offsets);
    let mut notes: Vec<Note> = found.notes(places).map(|(_, note)| note).collect();
    let rest = &rows.bytes[rows.at..];
    if !rest.trim_ascii().is_empty() {
        let bytes_left = counted(rest.len(), "byte", "bytes");
        let text = format!("ignored after the last row: {bytes_left}");
        notes.push(Note::warning(places(&[rows.at]).remove(0), text));
    }
    let mut names = BTreeSet::new();
    let repeated: Vec<&Element> =
        header.elements.iter().filter(|element| !names.insert(&element.name)).collect();
    let lines = repeated.iter().map(|element| Place::Line(element.line));
    let text = "a second element with the same name is kept, but not read";
    notes.extend(Note::for_all(Severity::Warning, repeated.len() as u64, lines, text));
    notes
}
