//! A new OBJ from any meshes, and the numbers of normals in an OBJ that is edited or new.

use super::new_library::{library, named};
use crate::io::mesh_checks::unsupported_notes;
use crate::io::text::{push_integer, push_row};
use crate::io::{Emit, FileMaterial, Format, Note, Part, PartEdit, Place, WriteError, WriteOptions, Written};
use crate::mesh::{Column, FaceLabels, Mesh, NONE, Storage};
use glam::DVec3;
use rustc_hash::FxHashMap;
use std::ops::Range;
use std::slice;

/// An OBJ of all parts, each an object of its own, with `vn` shared where a mesh shares them. The `materials` that they use become
/// a material library next to it. Fails for normals of faces.
pub(in crate::io) fn write(
    parts: &[Part],
    materials: &[FileMaterial],
    options: &WriteOptions,
) -> Result<Written, WriteError> {
    check_emit(options)?;
    let mut writer = Writer::default();
    writer.out.extend_from_slice(concat!("# crease ", env!("CARGO_PKG_VERSION"), "\n").as_bytes());
    let library = library(parts, materials, options);
    if let Some(file) = library.files.first() {
        named(&mut writer.out, "mtllib", &file.name);
    }
    for part in parts {
        if options.merge.applies_to(&part.mesh) {
            let mesh = part.mesh.clone().with_corner_columns().with_shared_vertices();
            writer.part(&Part { name: part.name.clone(), mesh, ..Part::default() });
        } else {
            writer.part(part);
        }
    }
    let old: usize = parts.iter().map(|part| part.mesh.vertex_count()).sum();
    let mut written = Written {
        bytes: writer.out,
        notes: notes(parts, library.files.is_empty()),
        vertices: writer.vertices,
        ..Written::default()
    };
    written.notes.extend(library.note);
    written.companions = library.files;
    written.count_change(old);
    Ok(written)
}

pub(super) fn check_emit(options: &WriteOptions) -> Result<(), WriteError> {
    let text = "OBJ has no face normals; use --emit corner or --emit vertex";
    if options.emit == Emit::Face { Err(WriteError::Unsupported(text.to_owned())) } else { Ok(()) }
}

fn notes(parts: &[Part], is_without_library: bool) -> Vec<Note> {
    let mut notes = unsupported_notes(Format::Obj, parts);
    let has_opacity = |mesh: &Mesh| mesh.columns().colors.iter().flatten().any(|color| color[3] != 1.0);
    if parts.iter().any(|part| has_opacity(&part.mesh)) {
        notes.push(Note::warning(Place::File, "OBJ colours have no opacity; it was omitted"));
    }
    if is_without_library && parts.iter().any(|part| part.mesh.columns().materials.is_some()) {
        notes.push(Note::remark("usemtl names the materials, but no material library was written"));
    }
    notes
}

#[derive(Default)]
struct Writer {
    out: Vec<u8>,
    /// Lines written so far, which later indices count from.
    vertices: u64,
    uvs: u64,
    normals: u64,
    /// The labels in force after the parts so far.
    labels: Option<Labels>,
}

#[derive(Clone, Copy, PartialEq, Eq)]
struct Labels {
    object: u32,
    material: u32,
    smoothing: Option<u32>,
}

impl Labels {
    const NONE: Labels = Labels { object: NONE, material: NONE, smoothing: None };
}

impl Writer {
    fn part(&mut self, part: &Part) {
        let (mesh, columns) = (&part.mesh, part.mesh.columns());
        named(&mut self.out, "o", &part.name);
        self.positions(mesh);
        for uv in columns.uvs.iter().flat_map(|uvs| &uvs.values) {
            push_row(&mut self.out, "vt", mesh.storage(), &uv.to_array());
            self.out.push(b'\n');
        }
        // Only those that are referred to, and equal ones once.
        let normals = columns.normals.as_ref();
        let normals =
            normals.map(|normals| NormalNumbers::new(mesh, &PartEdit::default(), normals, 0, mesh.storage()));
        if let Some(normals) = &normals {
            normals.push_lines(b"\n", &mut self.out);
        }
        self.faces(mesh, normals.as_ref());
        for line in &columns.lines {
            self.vertex_list("l", line);
        }
        for point in &columns.points {
            self.vertex_list("p", slice::from_ref(point));
        }
        self.vertices += mesh.vertex_count() as u64;
        self.uvs += columns.uvs.as_ref().map_or(0, |uvs| uvs.values.len() as u64);
        self.normals += normals.map_or(0, |normals| normals.new.len() as u64);
    }

    fn positions(&mut self, mesh: &Mesh) {
        let colors = mesh.columns().colors.as_deref();
        for (vertex, position) in mesh.positions().iter().enumerate() {
            push_row(&mut self.out, "v", mesh.storage(), &position.to_array());
            if let Some(colors) = colors {
                push_row(&mut self.out, "", Storage::F32, &colors[vertex].map(f64::from)[..3]);
            }
            self.out.push(b'\n');
        }
    }

    fn faces(&mut self, mesh: &Mesh, normals: Option<&NormalNumbers<'_>>) {
        let columns = mesh.columns();
        let mut current = Labels::NONE;
        if let Some(left) = self.labels {
            self.change_labels(mesh, left, current);
        }
        for (face, range) in mesh.faces().ranges().enumerate() {
            let label =
                |labels: &Option<FaceLabels>| labels.as_ref().map_or(NONE, |labels| labels.of_face[face]);
            let labels = Labels {
                object: label(&columns.objects),
                material: label(&columns.materials),
                smoothing: columns.smoothing.as_ref().map(|groups| groups.of_face[face]),
            };
            if labels != current {
                self.change_labels(mesh, current, labels);
                current = labels;
            }
            self.out.push(b'f');
            for corner in range {
                self.corner(mesh, normals, corner);
            }
            self.out.push(b'\n');
        }
        self.labels = Some(current);
    }

    fn change_labels(&mut self, mesh: &Mesh, old: Labels, new: Labels) {
        for (keyword, labels, old, new) in [
            ("g", &mesh.columns().objects, old.object, new.object),
            ("usemtl", &mesh.columns().materials, old.material, new.material),
        ] {
            match labels.as_ref().and_then(|labels| labels.names.get(new as usize)) {
                _ if old == new => {}
                Some(name) => named(&mut self.out, keyword, name),
                // Without a name it means the default one.
                None => self.vertex_list(keyword, &[]),
            }
        }
        if new.smoothing != old.smoothing {
            let group = new.smoothing.filter(|&group| group > 0);
            named(&mut self.out, "s", &group.map_or("off".to_owned(), |group| group.to_string()));
        }
    }

    fn corner(&mut self, mesh: &Mesh, normals: Option<&NormalNumbers<'_>>, corner: usize) {
        let vertex = mesh.faces().corners()[corner];
        self.index(b" ", u64::from(vertex) + 1, self.vertices);
        let uv = mesh.columns().uvs.as_ref().and_then(|uvs| uvs.slot(corner, vertex));
        if let Some(uv) = uv {
            self.index(b"/", u64::from(uv) + 1, self.uvs);
        }
        if let Some(normal) = normals.and_then(|normals| normals.of_corner(corner)) {
            self.index(if uv.is_some() { b"/" } else { b"//" }, normal.into(), self.normals);
        }
    }

    fn index(&mut self, before: &[u8], number: u64, base: u64) {
        self.out.extend_from_slice(before);
        push_integer(&mut self.out, base + number);
    }

    fn vertex_list(&mut self, keyword: &str, vertices: &[u32]) {
        self.out.extend_from_slice(keyword.as_bytes());
        for &vertex in vertices {
            self.index(b" ", u64::from(vertex) + 1, self.vertices);
        }
        self.out.push(b'\n');
    }
}

/// Which `vn` lines stay, which are new, and the number of each value: the index of its line in the output, from 1.
///
/// The file's own normals keep their lines while corners refer to them. New ones are one block among them, equal ones once.
pub(super) struct NormalNumbers<'a> {
    mesh: &'a Mesh,
    normals: &'a Column<DVec3>,
    /// The number of each value of the column, 0 where it needs no line.
    numbers: Vec<u32>,
    kept: usize,
    /// The precision in which new normals are written.
    storage: Storage,
    /// The values that are written as new normals.
    new: Vec<u32>,
}

impl<'a> NormalNumbers<'a> {
    /// `before` of the file's own normals come before the new ones, which are written in this precision.
    pub fn new(
        mesh: &'a Mesh,
        edit: &PartEdit,
        normals: &'a Column<DVec3>,
        before: usize,
        storage: Storage,
    ) -> Self {
        let count = normals.values.len();
        let kept = edit.kept.min(count);
        let numbers = vec![0; count];
        let mut numbering = Self { mesh, normals, numbers, kept, storage, new: Vec::new() };
        let is_used = numbering.used(edit);
        let before = before.min(kept);
        let next = numbering.number_kept(0..before, &is_used, 1);
        let next = numbering.number_new(&is_used, next);
        numbering.number_kept(before..kept, &is_used, next);
        numbering
    }

    fn slot(&self, corner: usize) -> Option<usize> {
        self.normals.slot(corner, self.mesh.faces().corners()[corner]).map(|slot| slot as usize)
    }

    fn used(&self, edit: &PartEdit) -> Vec<bool> {
        let mut is_used = vec![false; self.normals.values.len()];
        let faces = self.mesh.faces().ranges().enumerate();
        for (_, range) in faces.filter(|&(face, _)| edit.faces.keeps(face as u32)) {
            range.filter_map(|corner| self.slot(corner)).for_each(|slot| is_used[slot] = true);
        }
        is_used
    }

    fn number_kept(&mut self, slots: Range<usize>, is_used: &[bool], mut next: u32) -> u32 {
        for slot in slots.filter(|&slot| is_used[slot]) {
            self.numbers[slot] = next;
            next += 1;
        }
        next
    }

    /// Values that are written alike share a line.
    fn number_new(&mut self, is_used: &[bool], first: u32) -> u32 {
        let mut known: FxHashMap<[u64; 3], u32> = FxHashMap::default();
        for slot in (self.kept..is_used.len()).filter(|&slot| is_used[slot]) {
            let normal = self.normals.values[slot];
            let written = match self.storage {
                Storage::F32 => normal.as_vec3().as_dvec3(),
                Storage::F64 => normal,
            };
            self.numbers[slot] = *known.entry(written.to_array().map(f64::to_bits)).or_insert_with(|| {
                self.new.push(slot as u32);
                first + self.new.len() as u32 - 1
            });
        }
        first + self.new.len() as u32
    }

    /// Whether the line of the file's `normal`-th normal, counted from 0, stays.
    pub fn keeps(&self, normal: usize) -> bool {
        normal < self.kept && self.numbers[normal] != 0
    }

    pub fn of_corner(&self, corner: usize) -> Option<u32> {
        self.slot(corner).map(|slot| self.numbers[slot])
    }

    pub fn push_lines(&self, line_end: &[u8], out: &mut Vec<u8>) {
        for &slot in &self.new {
            push_row(out, "vn", self.storage, &self.normals.values[slot as usize].to_array());
            out.extend_from_slice(line_end);
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::io::{Format, ReadOptions, read_bytes};
    use crate::mesh::{Column, Columns, Faces, MeshBuilder, Positions, SmoothingGroups};
    use glam::{DVec2, DVec3};

    fn written(parts: &[Part]) -> String {
        let written = write(parts, &[], &WriteOptions::default()).unwrap();
        String::from_utf8(written.bytes).unwrap().split_once('\n').unwrap().1.to_owned()
    }

    fn part(name: &str, columns: Columns) -> Part {
        let mesh = MeshBuilder {
            positions: Positions::rounded(
                vec![DVec3::ZERO, DVec3::X * f64::from(0.1_f32), DVec3::Y, DVec3::ONE],
                Storage::F32,
            ),
            faces: Faces::polygons(vec![0, 1, 2, 0, 1, 3, 2], vec![0, 3, 7]),
            columns,
        };
        Part { name: name.to_owned(), mesh: mesh.build().unwrap(), non_finite_faces: Vec::new() }
    }

    #[test]
    fn everything_that_obj_has() {
        let labels = |of_face: &[u32], names: &[&str]| {
            let names = names.iter().map(|&name| name.to_owned()).collect();
            Some(FaceLabels { of_face: of_face.to_vec(), names })
        };
        let columns = Columns {
            normals: Some(Column::per_corner(vec![DVec3::Z], vec![0, 0, NONE, 0, 0, 0, 0])),
            uvs: Some(Column::per_vertex(vec![DVec2::ZERO; 4])),
            smoothing: Some(SmoothingGroups { of_face: vec![0, 3], before_first: 0 }),
            materials: labels(&[NONE, 0], &["red\n"]),
            objects: labels(&[0, 1], &["a", "b\\"]),
            points: vec![3],
            lines: vec![vec![0, 3, 1]],
            ..Columns::default()
        };
        let second = Columns { colors: Some(vec![[0.5, 0.25, 1.0, 1.0]; 4]), ..Columns::default() };
        let text = written(&[part("one", columns), part(" ", second)]);
        assert_eq!(
            text,
            "o one\nv 0 0 0\nv 0.1 0 0\nv 0 1 0\nv 1 1 1\nvt 0 0\nvt 0 0\nvt 0 0\nvt 0 0\nvn 0 0 1\n\
             g a\ns off\nf 1/1/1 2/2/1 3/3\ng b\nusemtl red\ns 3\nf 1/1/1 2/2/1 4/4/1 3/3/1\nl 1 4 2\np 4\n\
             v 0 0 0 0.5 0.25 1\nv 0.1 0 0 0.5 0.25 1\nv 0 1 0 0.5 0.25 1\nv 1 1 1 0.5 0.25 1\n\
             g\nusemtl\ns off\nf 5 6 7\nf 5 6 8 7\n"
        );
        let back = read_bytes(text.into_bytes(), Some(Format::Obj), None, &ReadOptions::default()).unwrap();
        let columns = back.parts[0].mesh.columns();
        assert_eq!(columns.materials.as_ref().unwrap().of_face, [NONE, 0, NONE, NONE]);
        assert_eq!(columns.smoothing.as_ref().unwrap().of_face, [0, 3, 0, 0]);
    }

    #[test]
    fn what_is_lost_is_said() {
        let columns = Columns {
            colors: Some(vec![[1.0, 1.0, 1.0, 0.5]; 4]),
            hard_edges: vec![[0, 1]],
            morph_targets: vec![vec![DVec3::ZERO; 4]],
            ..Columns::default()
        };
        let written = write(&[part("", columns)], &[], &WriteOptions::default()).unwrap();
        assert_eq!(written.notes.len(), 3);
        let faces = WriteOptions { emit: Emit::Face, ..WriteOptions::default() };
        assert!(write(&[part("", Columns::default())], &[], &faces).is_err());
    }
}
