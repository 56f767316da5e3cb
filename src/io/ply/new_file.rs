//! A new PLY from any meshes.

use super::scalar::{Encoding, Scalar};
use crate::io::mesh_checks::{blank_uv_note, needs_f64, unsupported_notes};
use crate::io::split_mesh::SplitMesh;
use crate::io::{Emit, Format, Note, Part, Place, WriteError, WriteOptions, Written};
use crate::mesh::{Mesh, NONE, Storage};
use glam::{DVec2, DVec3, DVec4};

/// A binary little-endian PLY of all parts in one, with polygons unchanged and lines as edges.
///
/// Positions and normals are floats, or doubles if floats would change a position. Vertices are split where corners differ in
/// normal or uv. With [`Emit::Face`] normals are those of faces. If only some parts have normals, the others get +Z.
pub(in crate::io) fn write(parts: &[Part], options: &WriteOptions) -> Result<Written, WriteError> {
    let layout = Layout::of(parts, options);
    let by_face = options.emit == Emit::Face;
    let storage = if layout.vertex[0].1 == Scalar::F64 { Storage::F64 } else { Storage::F32 };
    let split: Vec<SplitMesh<'_>> =
        parts.iter().map(|part| SplitMesh::new(&part.mesh, by_face, (options.merge, storage))).collect();
    let vertices: usize = split.iter().map(SplitMesh::vertex_count).sum();
    if vertices >= NONE as usize {
        let text = format!("{vertices} vertices, more than the indices of PLY can count");
        return Err(WriteError::TooLarge(text));
    }
    let mut writer = Writer { out: layout.header(parts, vertices).into_bytes(), layout, without_normal: 0 };
    for part in &split {
        writer.vertices(part);
    }
    let mut base = 0;
    for part in &split {
        writer.faces(part, base);
        base += part.vertex_count() as u32;
    }
    let mut base = 0;
    for part in &split {
        for pair in part.mesh.columns().lines.iter().flat_map(|line| line.windows(2)) {
            writer.indices(pair.iter().map(|vertex| base + vertex));
        }
        base += part.vertex_count() as u32;
    }
    let old: usize = parts.iter().map(|part| part.mesh.vertex_count()).sum();
    let notes = notes(parts, writer.without_normal);
    let mut written = Written { bytes: writer.out, notes, vertices: vertices as u64, ..Written::default() };
    written.count_change(old);
    Ok(written)
}

#[derive(Clone, Copy)]
enum Content {
    Position,
    Normal,
    Uv,
    Color,
}

type Names = &'static [&'static str];

const NORMALS: Names = &["nx", "ny", "nz"];

struct Layout {
    vertex: Vec<(Content, Scalar, Names)>,
    /// The type of the normals of faces, if they have some.
    face_normals: Option<Scalar>,
    index: Scalar,
    count: Scalar,
}

impl Layout {
    fn of(parts: &[Part], options: &WriteOptions) -> Self {
        let any = |test: &dyn Fn(&Mesh) -> bool| parts.iter().any(|part| test(&part.mesh));
        let position = if any(&needs_f64) { Scalar::F64 } else { Scalar::F32 };
        // Every corner may become a vertex.
        let most: usize =
            parts.iter().map(|part| part.mesh.vertex_count() + part.mesh.faces().corner_count()).sum();
        let mut colors = parts.iter().filter_map(|part| part.mesh.columns().colors.as_ref()).flatten();
        let by_face = options.emit == Emit::Face;
        let has_normals = any(&|mesh| mesh.columns().normals.is_some());
        let mut vertex: Vec<(Content, Scalar, Names)> = vec![(Content::Position, position, &["x", "y", "z"])];
        if has_normals && !by_face {
            vertex.push((Content::Normal, position, NORMALS));
        }
        if any(&|mesh| mesh.columns().uvs.is_some()) {
            vertex.push((Content::Uv, Scalar::F32, &["s", "t"]));
        }
        if any(&|mesh| mesh.columns().colors.is_some()) {
            let channels: Names = &["red", "green", "blue", "alpha"];
            let has_opacity = colors.any(|color| color[3] != 1.0);
            vertex.push((Content::Color, Scalar::U8, &channels[..if has_opacity { 4 } else { 3 }]));
        }
        Self {
            vertex,
            face_normals: (has_normals && by_face).then_some(position),
            index: if most as f64 <= Scalar::I32.largest() { Scalar::I32 } else { Scalar::U32 },
            count: if any(&|mesh| mesh.faces().max_arity() > 255) { Scalar::I32 } else { Scalar::U8 },
        }
    }

    fn header(&self, parts: &[Part], vertices: usize) -> String {
        let version = env!("CARGO_PKG_VERSION");
        let mut text = format!("ply\nformat binary_little_endian 1.0\ncomment made by crease {version}\n");
        let mut element = |name: &str, count: usize, properties: &[(&str, Names)]| {
            text.push_str(&format!("element {name} {count}\n"));
            for (kind, names) in properties {
                names.iter().for_each(|name| text.push_str(&format!("property {kind} {name}\n")));
            }
        };
        let properties = self.vertex.iter().map(|&(_, scalar, names)| (scalar.name(false), names));
        element("vertex", vertices, &properties.collect::<Vec<_>>());
        let faces: usize = parts.iter().map(|part| part.mesh.face_count()).sum();
        if faces > 0 {
            let list = format!("list {} {}", self.count.name(false), self.index.name(false));
            let normals = self.face_normals.map(|scalar| (scalar.name(false), NORMALS));
            let list: (&str, Names) = (&list, &["vertex_indices"]);
            element("face", faces, &[list].into_iter().chain(normals).collect::<Vec<_>>());
        }
        let lines = parts.iter().flat_map(|part| &part.mesh.columns().lines);
        let edges: usize = lines.map(|line| line.len().saturating_sub(1)).sum();
        if edges > 0 {
            element("edge", edges, &[(self.index.name(false), &["vertex1", "vertex2"])]);
        }
        text.push_str("end_header\n");
        text
    }
}

struct Writer {
    out: Vec<u8>,
    layout: Layout,
    /// Used vertices or faces without a normal, for which +Z was written.
    without_normal: usize,
}

impl Writer {
    fn numbers(&mut self, scalar: Scalar, values: &[f64]) {
        values.iter().for_each(|&value| scalar.push(&mut self.out, value, Encoding::Little));
    }

    fn indices(&mut self, indices: impl Iterator<Item = u32>) {
        for index in indices {
            self.layout.index.push(&mut self.out, f64::from(index), Encoding::Little);
        }
    }

    fn normal_or_z(&mut self, normal: Option<&DVec3>, is_used: impl FnOnce() -> bool) -> DVec3 {
        self.without_normal += usize::from(normal.is_none() && is_used());
        normal.copied().unwrap_or(DVec3::Z)
    }

    fn vertices(&mut self, part: &SplitMesh<'_>) {
        let columns = part.mesh.columns();
        for vertex in 0..part.vertex_count() {
            let source = part.source(vertex);
            for property in 0..self.layout.vertex.len() {
                let (content, scalar, names) = self.layout.vertex[property];
                let values = match content {
                    Content::Position => part.mesh.positions().at(source as u32).extend(0.0),
                    Content::Normal => {
                        let normal = columns.normals.as_ref().and_then(|column| part.value(column, vertex));
                        self.normal_or_z(normal, || part.is_used(vertex)).extend(0.0)
                    }
                    Content::Uv => {
                        let uv = columns.uvs.as_ref().and_then(|column| part.value(column, vertex));
                        uv.unwrap_or(&DVec2::ZERO).extend(0.0).extend(0.0)
                    }
                    Content::Color => {
                        let color = columns.colors.as_ref().map_or([1.0; 4], |colors| colors[source]);
                        DVec4::from_array(color.map(f64::from)) * 255.0
                    }
                };
                self.numbers(scalar, &values.to_array()[..names.len()]);
            }
        }
    }

    fn faces(&mut self, part: &SplitMesh<'_>, base: u32) {
        let normals = part.mesh.columns().normals.as_ref();
        for range in part.mesh.faces().ranges() {
            self.numbers(self.layout.count, &[range.len() as f64]);
            self.indices(part.vertex_of[range.clone()].iter().map(|vertex| base + vertex));
            if let Some(scalar) = self.layout.face_normals {
                let corner = range.start;
                let normal =
                    normals.and_then(|column| column.get(corner, part.mesh.faces().corners()[corner]));
                let normal = self.normal_or_z(normal, || true);
                self.numbers(scalar, &normal.to_array());
            }
        }
    }
}

fn notes(parts: &[Part], without_normal: usize) -> Vec<Note> {
    let mut notes = unsupported_notes(Format::Ply, parts);
    notes.extend(blank_uv_note("PLY", parts.iter(), true));
    if parts.len() > 1 {
        let text = format!("a PLY has one mesh: {} meshes were merged, and their names omitted", parts.len());
        notes.push(Note::warning(Place::File, text));
    }
    let nouns = ["missing normal was", "missing normals were"];
    notes.extend(Note::counted(without_normal, nouns, "written as 0 0 1"));
    let is_coarse = |value: &f32| {
        let byte = value * 255.0;
        (byte - byte.round()).abs() > 0.01 || !(0.0..=255.0).contains(&byte)
    };
    let colors = || parts.iter().filter_map(|part| part.mesh.columns().colors.as_ref()).flatten();
    if colors().flatten().any(is_coarse) {
        notes.push(Note::remark("colours were rounded to 8 bits"));
    }
    notes
}
