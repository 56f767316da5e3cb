//! From rows to a mesh.

use super::Packed;
use super::header::{Element, Header, Kind};
use super::roles::{FaceRole, Roles, VertexRole};
use super::rows::{Fault, Row, Rows, place, places};
use super::scalar::{Encoding, Scalar};
use crate::io::singles::restore_singles;
use crate::io::tally::{Tally, build_part, non_finite_note};
use crate::io::text::counted;
use crate::io::{Note, Part, Place, Problem, ReadError, ReadOptions, Severity};
use crate::mesh::{Column, Columns, Faces, MeshBuilder, MeshError, NONE, Storage};
use glam::{DVec2, DVec3};
use std::collections::BTreeSet;

/// What a body gives: the mesh in the making and what was odd.
#[derive(Default)]
struct Reading {
    mesh: MeshBuilder,
    vertex_normals: Vec<DVec3>,
    face_normals: Vec<DVec3>,
    vertex_uvs: Vec<DVec2>,
    corner_uvs: Vec<DVec2>,
    /// One a corner, [`NONE`] where a face has no uv.
    corner_uv_index: Vec<u32>,
    edges: Vec<Vec<u32>>,
    short_faces: Tally,
    not_finite: Tally,
    overlong: Tally,
    packed: Packed,
    /// Where the body ends.
    end: usize,
}

/// A body, read.
pub(super) struct Body {
    pub part: Part,
    pub notes: Vec<Note>,
    /// Whether ascii rows share lines.
    pub shared_lines: bool,
    pub packed: Packed,
}

/// Reads the body into the one part that a PLY file is.
pub(super) fn read(
    bytes: &[u8],
    header: &Header,
    roles: &Roles,
    options: &ReadOptions,
) -> Result<Body, ReadError> {
    let mut shared_lines = false;
    let mut reading = Reading::of(bytes, header, roles, shared_lines);
    if let Err((fault, overlong)) = &reading
        && fault.problem == Problem::Truncated
        && *overlong
        && let Ok(other) = Reading::of(bytes, header, roles, true)
    {
        // What was skipped behind rows were rows.
        (reading, shared_lines) = (Ok(other), true);
    }
    let reading = reading.map_err(|(fault, _)| fault.into_error(bytes, header.encoding))?;
    let mut notes = reading.notes(bytes, header);
    notes.extend(non_finite_note(&reading.mesh.positions, options.non_finite));
    let place_of = |error: &MeshError| match error {
        MeshError::NonFinite { vertex, .. } => Some((roles.vertex.element, *vertex)),
        // Of strips only the element is known.
        MeshError::VertexOutOfRange { face, .. } => roles.face.as_ref().map(|role| (role.element, *face)),
        _ => None,
    };
    let packed = reading.packed;
    let mesh = reading.finish(header, roles);
    let part = build_part(String::new(), mesh, options, |error| {
        let offset = place_of(error)
            .and_then(|(element, number)| row_offset(bytes, header, roles, shared_lines, element, number));
        offset.map_or(Place::File, |offset| place(bytes, header.encoding, offset))
    })?;
    Ok(Body { part, notes, shared_lines, packed })
}

/// Where a row of an element starts; of faces only those that are faces of the mesh are counted.
fn row_offset(
    bytes: &[u8],
    header: &Header,
    roles: &Roles,
    shared_lines: bool,
    wanted: usize,
    number: usize,
) -> Option<usize> {
    let mut rows = Rows::new(bytes, header, shared_lines);
    let (mut found, mut counted) = (None, 0);
    for (at, element) in header.elements.iter().enumerate() {
        let visited = rows.each(element, |_, row, rows| {
            let is_face = |role: &FaceRole| {
                rows.items(&row.fields[role.list], element.properties[role.list].kind).nth(2)
            };
            let counts = at != roles.face.as_ref().map_or(usize::MAX, |role| role.element)
                || roles.face.as_ref().and_then(is_face).is_some();
            if at == wanted && counts {
                if counted == number {
                    found = row.fields.first().map(|field| field.start);
                }
                counted += 1;
            }
            Ok(())
        });
        if visited.is_err() || at == wanted {
            break;
        }
    }
    found
}

impl Reading {
    /// On failure also tells whether anything was skipped behind ascii rows.
    fn of(bytes: &[u8], header: &Header, roles: &Roles, shared_lines: bool) -> Result<Self, (Fault, bool)> {
        let mut reading = Reading::default();
        let mut rows = Rows::new(bytes, header, shared_lines);
        for (at, element) in header.elements.iter().enumerate() {
            let read = match roles {
                Roles { vertex, .. } if vertex.element == at => reading.vertices(&mut rows, element, vertex),
                Roles { face: Some(face), .. } if face.element == at => {
                    reading.faces(&mut rows, element, face)
                }
                Roles { strips: Some(strips), .. } if strips.element == at => {
                    reading.strips(&mut rows, element, strips)
                }
                Roles { edge: Some((edge, ends)), .. } if *edge == at => {
                    reading.edges(&mut rows, element, *ends)
                }
                _ => rows.each(element, |_, _, _| Ok(())),
            };
            read.map_err(|fault| (fault, rows.overlong.is_met()))?;
        }
        reading.overlong = rows.overlong;
        reading.end = rows.at;
        Ok(reading)
    }

    fn vertices(&mut self, rows: &mut Rows<'_>, element: &Element, role: &VertexRole) -> Result<(), Fault> {
        let kinds: Vec<Scalar> = element.properties.iter().map(|property| scalar_of(property.kind)).collect();
        let count = rows.plausible_count(element);
        self.mesh.positions.reserve(count);
        self.vertex_normals.reserve(role.normal.map_or(0, |_| count));
        self.vertex_uvs.reserve(role.uv.map_or(0, |_| count));
        let mut colors = role.color.map(|_| Vec::with_capacity(count));
        rows.each(element, |_, row, rows| {
            let value = |at: usize| rows.scalar(&row.fields[at], kinds[at]);
            let vector = |[x, y, z]: [usize; 3]| Ok(DVec3::new(value(x)?, value(y)?, value(z)?));
            self.mesh.positions.push(vector(role.position)?);
            if let Some(normal) = role.normal {
                self.vertex_normals.push(vector(normal)?);
            }
            if let Some([u, v]) = role.uv {
                let uv = DVec2::new(value(u)?, value(v)?);
                self.vertex_uvs.push(self.not_finite.mend(uv.is_finite(), uv, row.span.start));
            }
            if let (Some(color), Some(colors)) = (role.color, &mut colors) {
                let channel = |at: usize| Ok((value(at)? / full_scale(kinds[at])) as f32);
                let [r, g, b] = color.map(channel);
                let color = [r?, g?, b?, role.opacity.map_or(Ok(1.0), channel)?];
                let is_finite = color.iter().all(|value| value.is_finite());
                colors.push(self.not_finite.mend(is_finite, color, row.span.start));
            }
            Ok(())
        })?;
        self.mesh.columns.colors = colors;
        let exact = |at: usize| match kinds[at] {
            Scalar::F64 => false,
            Scalar::I32 | Scalar::U32 => self.mesh.positions.iter().all(|p| p.as_vec3().as_dvec3() == *p),
            _ => true,
        };
        let are_singles = role.position.into_iter().all(exact);
        self.mesh.storage = match (are_singles, rows.encoding) {
            (true, Encoding::Ascii) => restore_singles(&mut [&mut self.mesh.positions]),
            (true, _) => Storage::F32,
            (false, _) => Storage::F64,
        };
        if let Some([x, ..]) = role.normal {
            self.packed.vertices = unpack(&mut self.vertex_normals, kinds[x]);
        }
        Ok(())
    }

    fn faces(&mut self, rows: &mut Rows<'_>, element: &Element, role: &FaceRole) -> Result<(), Fault> {
        let kind = element.properties[role.list].kind;
        let mut corners = Vec::new();
        self.mesh.faces = Faces::with_capacity(3 * rows.plausible_count(element));
        rows.each(element, |_, row, rows| {
            read_corners(rows, row, role.list, kind, &mut corners)?;
            if corners.len() < 3 {
                self.short_faces.add(row.fields[role.list].start);
                return Ok(());
            }
            self.mesh.faces.push(&corners);
            if let Some(normal) = role.normal {
                let [x, y, z] =
                    normal.map(|at| rows.scalar(&row.fields[at], scalar_of(element.properties[at].kind)));
                self.face_normals.push(DVec3::new(x?, y?, z?));
            }
            if let Some(uvs) = role.corner_uvs {
                self.corner_uvs(rows, row, uvs, element.properties[uvs].kind, corners.len())?;
            }
            Ok(())
        })?;
        if let Some([x, ..]) = role.normal {
            let scalar = scalar_of(element.properties[x].kind);
            self.packed.faces = unpack(&mut self.face_normals, scalar);
        }
        Ok(())
    }

    /// Two coordinates a corner, or else nothing for the face.
    fn corner_uvs(
        &mut self,
        rows: &Rows<'_>,
        row: &Row,
        at: usize,
        kind: Kind,
        corners: usize,
    ) -> Result<(), Fault> {
        let first = self.corner_uvs.len();
        let mut pending = None;
        for item in rows.items(&row.fields[at], kind) {
            let value = rows.scalar(&item, scalar_of(kind))?;
            match pending.take() {
                None => pending = Some(value),
                Some(u) => {
                    let uv = DVec2::new(u, value);
                    self.corner_uvs.push(self.not_finite.mend(uv.is_finite(), uv, item.start));
                }
            }
        }
        if self.corner_uvs.len() - first == corners && pending.is_none() {
            self.corner_uv_index.extend(first as u32..(first + corners) as u32);
        } else {
            self.corner_uvs.truncate(first);
            self.corner_uv_index.extend(std::iter::repeat_n(NONE, corners));
        }
        Ok(())
    }

    fn strips(&mut self, rows: &mut Rows<'_>, element: &Element, role: &FaceRole) -> Result<(), Fault> {
        let kind = element.properties[role.list].kind;
        rows.each(element, |_, row, rows| {
            // The last two vertices, and whether the triangle that they are in runs backwards.
            let (mut last, mut backwards) = ([NONE; 2], false);
            for item in rows.items(&row.fields[role.list], kind) {
                let value = rows.scalar(&item, scalar_of(kind))?;
                if value == -1.0 {
                    (last, backwards) = ([NONE; 2], false);
                    continue;
                }
                let [a, b] = last;
                let c = index(value, item.start)?;
                if a != NONE {
                    // Triangles that repeat a vertex only lead from one stretch to the next.
                    if a != b && b != c && a != c {
                        self.mesh.faces.push(&if backwards { [b, a, c] } else { [a, b, c] });
                    }
                    backwards = !backwards;
                }
                last = [b, c];
            }
            Ok(())
        })
    }

    fn edges(&mut self, rows: &mut Rows<'_>, element: &Element, ends: [usize; 2]) -> Result<(), Fault> {
        rows.each(element, |_, row, rows| {
            let [a, b] = ends.map(|at| {
                let field = &row.fields[at];
                index(rows.scalar(field, scalar_of(element.properties[at].kind))?, field.start)
            });
            self.edges.push(vec![a?, b?]);
            Ok(())
        })
    }

    fn finish(self, header: &Header, roles: &Roles) -> MeshBuilder {
        let mut mesh = self.mesh;
        let columns: &mut Columns = &mut mesh.columns;
        columns.normals = if roles.vertex.normal.is_some() {
            Some(Column::per_vertex(self.vertex_normals))
        } else if self.face_normals.is_empty() {
            None
        } else {
            Some(Column::per_corner(self.face_normals, mesh.faces.owners()))
        };
        columns.uvs = if roles.vertex.uv.is_some() {
            Some(Column::per_vertex(self.vertex_uvs))
        } else if self.corner_uvs.is_empty() {
            None
        } else {
            Some(Column::per_corner(self.corner_uvs, self.corner_uv_index))
        };
        let count = header.elements[roles.vertex.element].count;
        if mesh.faces.is_empty() && self.edges.is_empty() {
            columns.points = (0..count as u32).collect();
        }
        columns.lines = self.edges;
        mesh
    }

    fn notes(&self, bytes: &[u8], header: &Header) -> Vec<Note> {
        let places = |offsets: &[usize]| places(bytes, header.encoding, offsets);
        let mut notes: Vec<Note> = [
            (&self.short_faces, "a face with fewer than three corners was skipped"),
            (&self.not_finite, "a colour or texture coordinate that is not finite was read as 0"),
            (&self.overlong, "a row has more values than the header says; they were skipped"),
        ]
        .into_iter()
        .filter_map(|(tally, text)| tally.note(Severity::Warning, places, text))
        .collect();
        let rest = &bytes[self.end..];
        if !rest.trim_ascii().is_empty() {
            let bytes_left = counted(rest.len(), "byte", "bytes");
            let text = format!("not read, because it is behind the last row: {bytes_left}");
            notes.push(Note::warning(place(bytes, header.encoding, self.end), text));
        }
        let mut names = BTreeSet::new();
        let again: Vec<&Element> =
            header.elements.iter().filter(|element| !names.insert(&element.name)).collect();
        let lines = again.iter().map(|element| Place::Line(element.line));
        let text = "an element with a name that another has is only carried along";
        notes.extend(Note::for_all(Severity::Warning, again.len() as u64, lines, text));
        notes
    }
}

/// The type of a scalar, or of the items of a list.
pub(super) fn scalar_of(kind: Kind) -> Scalar {
    match kind {
        Kind::Scalar(scalar) | Kind::List { item: scalar, .. } => scalar,
    }
}

/// What stands for 1 in a colour.
fn full_scale(scalar: Scalar) -> f64 {
    if scalar.is_integer() { scalar.largest() } else { 1.0 }
}

/// Makes whole numbers that stand for −1..1 these. They are told by one that is not within that already.
fn unpack(normals: &mut [DVec3], scalar: Scalar) -> bool {
    let largest = normals.iter().fold(0.0, |m: f64, n| m.max(n.abs().max_element()));
    let packed = matches!(scalar, Scalar::I8 | Scalar::I16 | Scalar::I32) && largest > 1.0;
    if packed {
        normals.iter_mut().for_each(|normal| *normal /= scalar.largest());
    }
    packed
}

/// The vertices of the face in a row.
pub(super) fn read_corners(
    rows: &Rows<'_>,
    row: &Row,
    list: usize,
    kind: Kind,
    corners: &mut Vec<u32>,
) -> Result<(), Fault> {
    corners.clear();
    let scalar = scalar_of(kind);
    for item in rows.items(&row.fields[list], kind) {
        corners.push(index(rows.scalar(&item, scalar)?, item.start)?);
    }
    Ok(())
}

#[inline]
fn index(value: f64, offset: usize) -> Result<u32, Fault> {
    let number = value as u32;
    if f64::from(number) == value && number != NONE {
        return Ok(number);
    }
    Err(Fault::new(Problem::Range, offset, format!("{value} is no number of a vertex")))
}
