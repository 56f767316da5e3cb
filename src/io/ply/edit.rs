//! Writing a PLY back into its own bytes.

use super::document::{FaceRole, PlyDocument};
use super::header::{Element, Kind, Property};
use super::normal_properties::NormalProperties;
use super::rows::{Row, Rows, damaged};
use super::scalar::{Encoding, Scalar};
use crate::io::Part;
use crate::io::text::Changes;
use crate::io::{Emit, Loaded, Note, PartEdit, Place, Problem, ReadError, WriteError, WriteOptions, Written};
use crate::mesh::{Column, ColumnIndex, Faces, Mesh, NONE, VertexSplit, split_vertices};
use glam::DVec3;

/// The document with the edit applied. Everything that does not change stays byte for byte.
///
/// Normals are replaced where the file has them, or added after `z`. Types that cannot hold unit normals well become floats.
/// With [`Emit::Face`] the faces get [`PartEdit::face_normals`] instead. New vertices of splits come after the others, with all
/// of their properties. Fails if only some of `nx`, `ny`, `nz` are there.
pub(in crate::io) fn edit(
    document: &PlyDocument,
    loaded: &Loaded,
    edits: &[PartEdit],
    options: &WriteOptions,
) -> Result<Written, WriteError> {
    let ([Part { mesh, .. }, ..], [edit, ..]) = (&loaded.parts[..], edits) else {
        return Err(WriteError::no_document());
    };
    let by_face = options.emit == Emit::Face;
    // Points have no normals to change.
    let has_faces = mesh.face_count() > 0;
    let vertex_normals = edit.normals.as_ref().filter(|_| !by_face && has_faces);
    let face_normals = edit.face_normals.as_deref().filter(|_| by_face && has_faces);
    if edit.faces.is_empty() && vertex_normals.is_none() && face_normals.is_none() {
        let vertices = mesh.vertex_count() as u64;
        return Ok(Written { bytes: document.bytes.clone(), vertices, ..Written::default() });
    }
    let (faces, order) = edit.faces.corner_order(mesh.faces());
    let keys: Option<Vec<u32>> = match vertex_normals.map(|normals| &normals.index) {
        Some(ColumnIndex::PerCorner(index)) => {
            Some(order.iter().map(|&corner| index[corner as usize]).collect())
        }
        _ => None,
    };
    let split_keys: Vec<&[u32]> = keys.iter().map(Vec::as_slice).collect();
    let split = split_vertices(mesh.vertex_count(), faces.corners(), &split_keys);
    let editor = Editor {
        document,
        mesh,
        edit,
        vertex_normals,
        keys,
        face_normals,
        faces,
        split,
        header: Changes::default(),
        body: Vec::with_capacity(document.bytes.len() + document.bytes.len() / 4),
        notes: Vec::new(),
    };
    // The rows were read before, so an error is an unsupported feature.
    editor.run().map_err(|error| WriteError::Unsupported(format!("{}; convert the file first", error.found)))
}

struct Editor<'a> {
    document: &'a PlyDocument,
    mesh: &'a Mesh,
    edit: &'a PartEdit,
    vertex_normals: Option<&'a Column<DVec3>>,
    /// The normal of each corner that is kept, if they are given by corner.
    keys: Option<Vec<u32>>,
    face_normals: Option<&'a [DVec3]>,
    /// The faces that are kept, by old vertices.
    faces: Faces,
    split: VertexSplit,
    header: Changes,
    body: Vec<u8>,
    notes: Vec<Note>,
}

impl Editor<'_> {
    fn run(mut self) -> Result<Written, ReadError> {
        let document = self.document;
        let (roles, by_face) = (&document.roles, self.face_normals.is_some());
        let mut rows = Rows::new(&document.bytes, &document.header, document.shared_lines);
        for (at, element) in document.header.elements.iter().enumerate() {
            let start = rows.at;
            let role = roles.face.as_ref().filter(|role| role.element == at);
            match role {
                _ if roles.vertex.element == at && self.vertex_normals.is_some() => {
                    self.write_vertices(&mut rows, element)?;
                }
                Some(face) if !face.are_strips => self.write_faces(&mut rows, element, face)?,
                Some(strips) if self.adds_vertices() || !self.edit.faces.is_empty() || by_face => {
                    rows.each(element, |_, _, _| Ok(()))?;
                    self.replace_strips(element, strips)?;
                }
                _ => {
                    rows.each(element, |_, _, _| Ok(()))?;
                    self.body.extend_from_slice(&document.bytes[start..rows.at]);
                }
            }
        }
        self.body.extend_from_slice(&document.bytes[rows.at..]);
        let mut bytes = Vec::with_capacity(document.header.body + 256 + self.body.len());
        self.header.copy(&document.bytes, 0..document.header.body, &mut bytes);
        bytes.append(&mut self.body);
        let vertices = self.split.source.len() as u64;
        let added_vertices = self.split.added(self.mesh.vertex_count()) as u64;
        Ok(Written { bytes, notes: self.notes, vertices, added_vertices, ..Written::default() })
    }

    fn recount(&mut self, element: &Element, count: usize) {
        self.header.replace(element.count_at.clone(), |out| out.extend(count.to_string().bytes()));
    }

    /// An ascii row that another follows needs a line end.
    fn end_line(&mut self) {
        if self.document.header.encoding == Encoding::Ascii
            && !matches!(self.body.last(), None | Some(b'\n' | b'\r'))
        {
            self.body.extend_from_slice(self.document.header.line_end.as_bytes());
        }
    }

    fn write_vertices(&mut self, rows: &mut Rows<'_>, element: &Element) -> Result<(), ReadError> {
        let role = &self.document.roles.vertex;
        let [.., z] = role.position;
        let packed = self.document.packed.vertices;
        let (header, notes) = (&mut self.header, &mut self.notes);
        let fields = NormalProperties::plan(self.document, element, role.normal, packed, z, header, notes)?;
        let (old, new) = (self.mesh.vertex_count(), self.split.source.len());
        let mut starts = Vec::with_capacity(if new > old { old } else { 0 });
        let mut changes = Changes::default();
        rows.each(element, |vertex, row, rows| {
            if new > old {
                starts.push(row.span.start);
            }
            changes.clear();
            fields.change(self.normal(vertex), row, rows, &mut changes)?;
            changes.copy(rows.bytes, row.span.clone(), &mut self.body);
            Ok(())
        })?;
        if new == old {
            return Ok(());
        }
        let (mut source_rows, mut row) = (rows.clone(), Row::default());
        for vertex in old..new {
            self.end_line();
            let source = self.split.source[vertex] as usize;
            source_rows.at = starts[source];
            source_rows.next(element, &mut row)?;
            changes.clear();
            fields.change(self.normal(vertex), &row, &source_rows, &mut changes)?;
            // Without the blank lines in front.
            let first = row.fields[0].start;
            changes.copy(rows.bytes, first..row.span.end, &mut self.body);
        }
        self.end_line();
        self.recount(element, new);
        Ok(())
    }

    /// The normal of a vertex, old or added; `None` keeps the stored one.
    fn normal(&self, vertex: usize) -> Option<DVec3> {
        let normals = self.vertex_normals?;
        let slot = match (&self.keys, self.split.sample[vertex]) {
            (None, _) => self.split.source[vertex],
            (_, NONE) => NONE,
            (Some(keys), corner) => keys[corner as usize],
        };
        if slot == NONE {
            return self.unused_normal(vertex);
        }
        // Number `s` of the stored ones is that of vertex `s`, if vertices have any.
        let is_own = (slot as usize) < self.edit.kept
            && slot == self.split.source[vertex]
            && self.document.roles.vertex.normal.is_some();
        (!is_own).then(|| normals.values[slot as usize])
    }

    /// For a vertex that no face uses: +Z, unless it already has a unit normal.
    fn unused_normal(&self, vertex: usize) -> Option<DVec3> {
        let stored =
            self.mesh.columns().normals.as_ref().filter(|column| column.index == ColumnIndex::PerVertex);
        let normal = stored.map_or(DVec3::ZERO, |column| column.values[self.split.source[vertex] as usize]);
        // The bound of the official glTF validator.
        let is_unit = (normal.length() - 1.0).abs() <= 0.00674;
        (!is_unit).then_some(DVec3::Z)
    }

    fn adds_vertices(&self) -> bool {
        self.split.added(self.mesh.vertex_count()) > 0
    }

    /// The type of vertex indices: that of the file if it can hold the added vertices, else `int`, else `uint`.
    fn index_type(&mut self, list: &Property, item: Scalar) -> Scalar {
        let largest = (self.split.source.len().saturating_sub(1)) as f64;
        let holds = |scalar: &Scalar| scalar.largest() >= largest;
        if !self.adds_vertices() || holds(&item) {
            return item;
        }
        let new = if holds(&Scalar::I32) { Scalar::I32 } else { Scalar::U32 };
        self.header.replace(list.type_at.clone(), |out| out.extend(new.name(list.sized_name).bytes()));
        new
    }

    fn write_faces(
        &mut self,
        rows: &mut Rows<'_>,
        element: &Element,
        role: &FaceRole,
    ) -> Result<(), ReadError> {
        let list = &element.properties[role.list];
        let Kind::List { count, item } = list.kind else { return Ok(()) };
        let index_type = self.index_type(list, item);
        // The normals of reversed faces are reversed too.
        let reverses = role.normal.is_some() && !self.edit.faces.reversed.is_empty();
        let fields = (self.face_normals.is_some() || reverses).then(|| {
            let (packed, behind) = (self.document.packed.faces, element.properties.len() - 1);
            let (header, notes) = (&mut self.header, &mut self.notes);
            NormalProperties::plan(self.document, element, role.normal, packed, behind, header, notes)
        });
        let fields = fields.transpose()?;
        // Normals of faces, if vertices have none.
        let stored = match &self.mesh.columns().normals {
            Some(Column { values, index: ColumnIndex::PerCorner(_) }) => Some(values),
            _ => None,
        };
        let (mut faces_read, mut faces_kept, mut rows_kept) = (0_usize, 0, 0);
        let (mut corners, mut changes) = (Vec::new(), Changes::default());
        rows.each(element, |_, row, rows| {
            rows.corners(&row.fields[role.list], list.kind, &mut corners)?;
            changes.clear();
            // Rows with fewer than three corners are not faces of the mesh.
            let face = (corners.len() >= 3).then_some(faces_read);
            faces_read += usize::from(face.is_some());
            if face.is_some_and(|face| !self.edit.faces.keeps(face as u32)) {
                return Ok(());
            }
            rows_kept += 1;
            let reversed = face.is_some_and(|face| self.edit.faces.reverses(face as u32));
            let written = if face.is_some() {
                faces_kept += 1;
                &self.split.corners[self.faces.range(faces_kept - 1)]
            } else {
                &corners[..]
            };
            if written != corners || index_type != item {
                changes.replace(row.fields[role.list].clone(), |out| {
                    push_list(out, written, count, index_type, rows.encoding);
                });
            }
            if let (true, Some(uvs)) = (reversed, role.corner_uvs) {
                reverse_pairs(rows, row, uvs, element.properties[uvs].kind, written.len(), &mut changes);
            }
            if let Some(fields) = &fields {
                let normal = match self.face_normals {
                    Some(normals) => face.map(|face| normals[face]),
                    None => face.filter(|_| reversed).and_then(|face| Some(-*stored?.get(face)?)),
                };
                fields.change(normal, row, rows, &mut changes)?;
            }
            changes.copy(rows.bytes, row.span.clone(), &mut self.body);
            Ok(())
        })?;
        if rows_kept as u64 != element.count {
            self.recount(element, rows_kept);
        }
        Ok(())
    }

    fn replace_strips(&mut self, element: &Element, role: &FaceRole) -> Result<(), ReadError> {
        let list = &element.properties[role.list];
        let Kind::List { count, item } = list.kind else { return Ok(()) };
        if element.properties.len() > 1 || self.face_normals.is_some() {
            let found = "triangle strips cannot store normals or other properties of faces";
            return Err(damaged(Problem::Unsupported, 0, found));
        }
        let index_type = self.index_type(list, item);
        self.header.replace(element.name_at.clone(), |out| out.extend_from_slice(b"face"));
        self.recount(element, self.faces.len());
        self.end_line();
        for face in 0..self.faces.len() {
            let corners = &self.split.corners[self.faces.range(face)];
            push_list(&mut self.body, corners, count, index_type, self.document.header.encoding);
            self.end_line();
        }
        let text = "triangle strips became faces, because faces changed";
        self.notes.push(Note::warning(Place::Line(element.line), text));
        Ok(())
    }
}

fn push_list(out: &mut Vec<u8>, values: &[u32], count: Scalar, item: Scalar, encoding: Encoding) {
    count.push(out, values.len() as f64, encoding);
    for &value in values {
        if encoding == Encoding::Ascii {
            out.push(b' ');
        }
        item.push(out, f64::from(value), encoding);
    }
}

/// Reverses a list of two numbers a corner, except the first corner. A list of another length is not changed.
fn reverse_pairs(rows: &Rows<'_>, row: &Row, list: usize, kind: Kind, corners: usize, changes: &mut Changes) {
    let items: Vec<_> = rows.items(&row.fields[list], kind).collect();
    if items.len() != 2 * corners {
        return;
    }
    for corner in 1..corners {
        for part in 0..2 {
            let there = items[2 * (corners - corner) + part].clone();
            changes.replace(items[2 * corner + part].clone(), |out| out.extend(&rows.bytes[there]));
        }
    }
}
