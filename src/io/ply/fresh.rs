//! A new PLY from any meshes.

use super::scalar::{Encoding, Scalar};
use crate::io::left_out::{Feature, left_out};
use crate::io::{Emit, Note, Part, Place, WriteError, WriteOptions, Written};
use crate::mesh::{ColumnIndex, Mesh, NONE, Storage, VertexSplit, split_vertices};
use glam::{DVec2, DVec3};

const NOT_HELD: [Feature; 5] =
    [Feature::Materials, Feature::Objects, Feature::Smoothing, Feature::HardEdges, Feature::MorphTargets];

/// A binary little-endian PLY of all parts in one, with polygons as they are and lines as edges.
///
/// Positions and normals are floats, or doubles if floats would change a position: digits that were asked for once are kept. Vertices are split where corners differ in normal or
/// uv. With [`Emit::Face`] normals are those of faces, which the corners of each must share. Where a part has no
/// normals and another has, +Z stands in.
///
/// # Errors
/// [`WriteError::TooLarge`] for more vertices than 32 bits count.
pub(in crate::io) fn write(parts: &[Part], options: &WriteOptions) -> Result<Written, WriteError> {
    let shape = Shape::of(parts, options);
    let split: Vec<Split<'_>> = parts.iter().map(|part| Split::of(&part.mesh, shape.by_face)).collect();
    let vertices: usize = split.iter().map(|part| part.split.source.len()).sum();
    if vertices >= NONE as usize {
        let text = format!("{vertices} vertices are more than PLY's indices can count");
        return Err(WriteError::TooLarge(text));
    }
    let mut writer = Writer { out: shape.header(parts, vertices).into_bytes(), shape, without_normal: 0 };
    for part in &split {
        writer.vertices(part);
    }
    let mut base = 0;
    for part in &split {
        writer.faces(part, base);
        base += part.split.source.len() as u32;
    }
    let mut base = 0;
    for part in &split {
        for pair in part.mesh.columns().lines.iter().flat_map(|line| line.windows(2)) {
            writer.indices(pair.iter().map(|vertex| base + vertex));
        }
        base += part.split.source.len() as u32;
    }
    let old: usize = parts.iter().map(|part| part.mesh.vertex_count()).sum();
    let notes = notes(parts, writer.without_normal);
    let (vertices, added_vertices) = (vertices as u64, (vertices - old) as u64);
    Ok(Written { bytes: writer.out, notes, vertices, added_vertices, ..Written::default() })
}

/// Which properties there are.
struct Shape {
    position: Scalar,
    index: Scalar,
    count: Scalar,
    by_face: bool,
    normals: bool,
    uvs: bool,
    colors: bool,
    opacity: bool,
}

impl Shape {
    fn of(parts: &[Part], options: &WriteOptions) -> Self {
        let any = |test: &dyn Fn(&Mesh) -> bool| parts.iter().any(|part| test(&part.mesh));
        let is_rounded = |p: &DVec3| p.as_vec3().as_dvec3() != *p;
        let needs_doubles =
            any(&|mesh| mesh.storage() == Storage::F64 && mesh.positions().iter().any(is_rounded));
        // Every corner may become a vertex.
        let most: usize =
            parts.iter().map(|part| part.mesh.vertex_count() + part.mesh.faces().corner_count()).sum();
        let colors = || parts.iter().filter_map(|part| part.mesh.columns().colors.as_ref());
        Self {
            position: if needs_doubles { Scalar::F64 } else { Scalar::F32 },
            index: if most as f64 <= Scalar::I32.largest() { Scalar::I32 } else { Scalar::U32 },
            count: if any(&|mesh| mesh.faces().max_arity() > 255) { Scalar::I32 } else { Scalar::U8 },
            by_face: options.emit == Emit::Face,
            normals: any(&|mesh| mesh.columns().normals.is_some()),
            uvs: any(&|mesh| mesh.columns().uvs.is_some()),
            colors: colors().next().is_some(),
            opacity: colors().flatten().any(|color| color[3] != 1.0),
        }
    }

    fn header(&self, parts: &[Part], vertices: usize) -> String {
        let faces: usize = parts.iter().map(|part| part.mesh.face_count()).sum();
        let lines = parts.iter().flat_map(|part| &part.mesh.columns().lines);
        let edges: usize = lines.map(|line| line.len().saturating_sub(1)).sum();
        let mut text = concat!(
            "ply\nformat binary_little_endian 1.0\ncomment made by crease ",
            env!("CARGO_PKG_VERSION"),
            "\n"
        )
        .to_owned();
        let mut element = |name: &str, count: usize, properties: &[(bool, &str, &[&str])]| {
            text.push_str(&format!("element {name} {count}\n"));
            for (_, kind, names) in properties.iter().filter(|(present, ..)| *present) {
                names.iter().for_each(|name| text.push_str(&format!("property {kind} {name}\n")));
            }
        };
        let float = Scalar::F32.name(false);
        let normals: &[&str] = &["nx", "ny", "nz"];
        element(
            "vertex",
            vertices,
            &[
                (true, self.position.name(false), &["x", "y", "z"]),
                (self.normals && !self.by_face, self.position.name(false), normals),
                (self.uvs, float, &["s", "t"]),
                (self.colors, "uchar", &["red", "green", "blue"]),
                (self.opacity, "uchar", &["alpha"]),
            ],
        );
        let list = format!("list {} {}", self.count.name(false), self.index.name(false));
        if faces > 0 {
            let properties: [(bool, &str, &[&str]); 2] = [
                (true, &list, &["vertex_indices"]),
                (self.normals && self.by_face, self.position.name(false), normals),
            ];
            element("face", faces, &properties);
        }
        if edges > 0 {
            element("edge", edges, &[(true, self.index.name(false), &["vertex1", "vertex2"])]);
        }
        text.push_str("end_header\n");
        text
    }
}

/// A part and its vertices, split.
struct Split<'a> {
    mesh: &'a Mesh,
    split: VertexSplit,
}

impl<'a> Split<'a> {
    fn of(mesh: &'a Mesh, by_face: bool) -> Self {
        let columns = mesh.columns();
        let normals = columns.normals.as_ref().filter(|_| !by_face).map(|column| &column.index);
        let uvs = columns.uvs.as_ref().map(|column| &column.index);
        let keys: Vec<&[u32]> = [normals, uvs]
            .into_iter()
            .filter_map(|index| match index? {
                ColumnIndex::PerCorner(index) => Some(&index[..]),
                ColumnIndex::PerVertex => None,
            })
            .collect();
        Self { mesh, split: split_vertices(mesh.vertex_count(), mesh.faces().corners(), &keys) }
    }

    /// The value that a vertex has of a column.
    fn value<T: Copy>(&self, column: Option<&crate::mesh::Column<T>>, vertex: usize) -> Option<T> {
        let column = column?;
        let slot = match &column.index {
            ColumnIndex::PerVertex => self.split.source[vertex],
            ColumnIndex::PerCorner(index) => {
                let corner = Some(self.split.sample[vertex]).filter(|&corner| corner != NONE)?;
                Some(index[corner as usize]).filter(|&slot| slot != NONE)?
            }
        };
        Some(column.values[slot as usize])
    }
}

struct Writer {
    out: Vec<u8>,
    shape: Shape,
    /// Used vertices or faces that got a stand-in.
    without_normal: u64,
}

impl Writer {
    fn numbers(&mut self, scalar: Scalar, values: &[f64]) {
        values.iter().for_each(|&value| scalar.push(&mut self.out, value, Encoding::Little));
    }

    fn indices(&mut self, indices: impl Iterator<Item = u32>) {
        for index in indices {
            self.shape.index.push(&mut self.out, f64::from(index), Encoding::Little);
        }
    }

    fn normal(&mut self, normal: Option<DVec3>, is_used: bool) {
        self.without_normal += u64::from(normal.is_none() && is_used);
        self.numbers(self.shape.position, &normal.unwrap_or(DVec3::Z).to_array());
    }

    fn vertices(&mut self, part: &Split<'_>) {
        let columns = part.mesh.columns();
        for (vertex, &source) in part.split.source.iter().enumerate() {
            let source = source as usize;
            self.numbers(self.shape.position, &part.mesh.positions()[source].to_array());
            if self.shape.normals && !self.shape.by_face {
                let is_used = part.split.sample[vertex] != NONE;
                self.normal(part.value(columns.normals.as_ref(), vertex), is_used);
            }
            if self.shape.uvs {
                let uv = part.value(columns.uvs.as_ref(), vertex).unwrap_or(DVec2::ZERO);
                self.numbers(Scalar::F32, &uv.to_array());
            }
            if self.shape.colors {
                let color = columns.colors.as_ref().map_or([1.0; 4], |colors| colors[source]);
                let channels = if self.shape.opacity { 4 } else { 3 };
                let bytes = color.map(|value| f64::from(value) * 255.0);
                self.numbers(Scalar::U8, &bytes[..channels]);
            }
        }
    }

    fn faces(&mut self, part: &Split<'_>, base: u32) {
        let normals = part.mesh.columns().normals.as_ref();
        for range in part.mesh.faces().ranges() {
            self.numbers(self.shape.count, &[range.len() as f64]);
            self.indices(part.split.corners[range.clone()].iter().map(|vertex| base + vertex));
            if self.shape.normals && self.shape.by_face {
                let corner = range.start;
                let normal =
                    normals.and_then(|column| column.get(corner, part.mesh.faces().corners()[corner]));
                self.normal(normal.copied(), true);
            }
        }
    }
}

/// What PLY cannot hold.
fn notes(parts: &[Part], without_normal: u64) -> Vec<Note> {
    let mut notes = left_out("PLY", &NOT_HELD, parts);
    if parts.len() > 1 {
        let text =
            format!("PLY has no parts: all {} were put into one mesh, their names left out", parts.len());
        notes.push(Note::warning(Place::File, text));
    }
    if without_normal > 0 {
        let text = format!("0 0 1 was written for normals that are not there: {without_normal}");
        notes.push(Note::warning(Place::File, text));
    }
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
