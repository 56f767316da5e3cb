//! Stretches of a file put together, in order, into one mesh.

use super::arguments::Fault;
use super::indices::{Indices, NOWHERE};
use super::labels::Labels;
use super::lexer::{Cursor, Keyword, shown, statements};
use super::locate::{Counts, Target, arguments_of, bad_references};
use super::number;
use super::remarks::{Remark, Remarks};
use super::stretch::{Label, LabelKind, NO_COLOR, Stretch};
use crate::io::singles::restore_singles;
use crate::io::tally::non_finite_note;
use crate::io::{NonFinite, Note, Place, Problem};
use crate::mesh::{Column, Columns, Faces, Mesh, MeshBuilder, MeshError, NONE};
use glam::{DVec2, DVec3};
use std::ops::Range;

/// A whole file.
pub(super) struct Merged {
    pub mesh: Mesh,
    pub non_finite_faces: Vec<u32>,
    pub remarks: Remarks,
    pub notes: Vec<Note>,
    /// The names of material libraries, where they stand in the text.
    pub libraries: Vec<Range<usize>>,
}

/// The file so far, growing by one stretch at a time.
#[derive(Default)]
pub(super) struct File {
    positions: Vec<DVec3>,
    colors: Vec<[f32; 4]>,
    uvs: Vec<DVec2>,
    normals: Vec<DVec3>,
    corners: Vec<u32>,
    /// Empty while all faces are triangles.
    face_offsets: Vec<u32>,
    corner_uvs: Vec<u32>,
    corner_normals: Vec<u32>,
    points: Vec<u32>,
    lines: Vec<Vec<u32>>,
    labels: Vec<Label>,
    remarks: Remarks,
    has_faces: bool,
    /// Where new normals go, and how many there are in front of it; final once there are faces.
    pub insertion: (usize, usize),
    pub surface_normals: bool,
    pub statements: u64,
}

impl File {
    /// Appends what a stretch says.
    pub fn append(&mut self, mut stretch: Stretch) -> Result<(), Fault> {
        let (vertices, corners) = (self.positions.len(), self.corners.len());
        check_count("vertices", vertices + stretch.positions.len())?;
        check_count("corners", corners + stretch.corners.values.len())?;
        self.find_insertion(&stretch);
        stretch.corners.resolve(vertices);
        stretch.points.resolve(vertices);
        stretch.lines.resolve(vertices);
        stretch.corner_uvs.resolve(self.uvs.len());
        stretch.corner_normals.resolve(self.normals.len());
        let faces = self.face_count() as u32;
        self.labels
            .extend(stretch.labels.into_iter().map(|label| Label { face: label.face + faces, ..label }));
        self.append_face_ends(stretch.face_ends, stretch.corners.values.len());
        self.append_colors(stretch.colors, stretch.positions.len());
        append_aligned(&mut self.corner_uvs, stretch.corner_uvs, corners);
        append_aligned(&mut self.corner_normals, stretch.corner_normals, corners);
        append(&mut self.corners, stretch.corners.values);
        append(&mut self.positions, stretch.positions);
        append(&mut self.uvs, stretch.uvs);
        append(&mut self.normals, stretch.normals);
        append(&mut self.points, stretch.points.values);
        let mut start = 0;
        for end in stretch.line_ends {
            self.lines.push(stretch.lines.values[start..end as usize].to_vec());
            start = end as usize;
        }
        self.remarks.append(stretch.remarks);
        self.surface_normals |= stretch.surface_normals;
        self.statements += stretch.statements;
        Ok(())
    }

    /// New normals go behind the last one in front of the first face, or else in front of that face.
    fn find_insertion(&mut self, stretch: &Stretch) {
        if self.has_faces {
            return;
        }
        if let Some((at, count)) = stretch.leading_normals {
            self.insertion = (at, self.normals.len() + count);
        }
        if let Some(face) = stretch.first_face {
            self.has_faces = true;
            if self.insertion.1 == 0 {
                self.insertion.0 = face;
            }
        }
    }

    fn append_face_ends(&mut self, ends: Option<Vec<u32>>, corners: usize) {
        if ends.is_none() && self.face_offsets.is_empty() {
            return;
        }
        let base = self.corners.len() as u32;
        if self.face_offsets.is_empty() {
            self.face_offsets.extend((0..=base).step_by(3));
        }
        match ends {
            Some(ends) => self.face_offsets.extend(ends.iter().map(|end| base + end)),
            None => self.face_offsets.extend((3..=corners as u32).step_by(3).map(|end| base + end)),
        }
    }

    fn append_colors(&mut self, colors: Vec<[f32; 4]>, vertices: usize) {
        if colors.is_empty() && self.colors.is_empty() {
            return;
        }
        self.colors.resize(self.positions.len(), NO_COLOR);
        self.colors.extend(colors);
        self.colors.resize(self.positions.len() + vertices, NO_COLOR);
    }

    fn face_count(&self) -> usize {
        match self.face_offsets.len() {
            0 => self.corners.len() / 3,
            offsets => offsets - 1,
        }
    }

    fn check_vertices(&self, text: &[u8], counts: Counts) -> Result<(), Fault> {
        let highest = self.corners.iter().chain(&self.points).chain(self.lines.iter().flatten()).max();
        if highest.is_none_or(|&vertex| (vertex as usize) < counts.vertices) {
            return Ok(());
        }
        Err(match bad_references(text, counts, Target::Vertex, 1).pop() {
            Some(bad) => bad.into_fault(counts),
            None => too_many("vertices", counts.vertices),
        })
    }

    /// References to texture coordinates and normals that do not exist, and to texture coordinates that are not
    /// finite, become absent. Normals that are not finite stay: to find and replace them is this program's job.
    fn forget_bad_attributes(&mut self, text: &[u8], counts: Counts) {
        for (index, count, target, remark) in [
            (&mut self.corner_uvs, counts.uvs, Target::Uv, Remark::UvOutOfRange),
            (&mut self.corner_normals, counts.normals, Target::Normal, Remark::NormalOutOfRange),
        ] {
            let mut bad = 0;
            for slot in index.iter_mut().filter(|slot| **slot != NONE && **slot as usize >= count) {
                *slot = NONE;
                bad += 1;
            }
            if bad > 0 {
                let places = bad_references(text, counts, target, 1 + Note::MOST_PLACES);
                self.remarks.add_all(remark, bad, places.iter().map(|bad| bad.offset));
            }
        }
        if self.uvs.iter().any(|uv| !uv.is_finite()) {
            let bad: Vec<bool> = self.uvs.iter().map(|uv| !uv.is_finite()).collect();
            for slot in self.corner_uvs.iter_mut().filter(|slot| **slot != NONE && bad[**slot as usize]) {
                *slot = NONE;
            }
            for uv in self.uvs.iter_mut().filter(|uv| !uv.is_finite()) {
                *uv = DVec2::ZERO;
            }
            let lines = statements(text).filter(|statement| statement.keyword == Keyword::TextureCoordinate);
            let places = lines.zip(&bad).filter(|(_, bad)| **bad).map(|(line, _)| line.arguments);
            self.remarks.add_all(Remark::UvNotFinite, bad.iter().filter(|bad| **bad).count() as u64, places);
        }
    }

    /// Checks what only the whole file can tell and makes the mesh.
    pub fn finish(mut self, text: &[u8], non_finite: NonFinite) -> Result<Merged, Fault> {
        let counts =
            Counts { vertices: self.positions.len(), uvs: self.uvs.len(), normals: self.normals.len() };
        self.check_vertices(text, counts)?;
        self.forget_bad_attributes(text, counts);
        let mut notes = Vec::new();
        let corner_count = self.corners.len();
        let labels = Labels { text, faces: self.face_count(), all: std::mem::take(&mut self.labels) };
        let columns = Columns {
            normals: column(self.normals, self.corner_normals, corner_count),
            uvs: column(self.uvs, self.corner_uvs, corner_count),
            colors: finish_colors(self.colors, &mut notes),
            smoothing: labels.smoothing(&mut self.remarks),
            materials: labels.names(LabelKind::Material),
            objects: labels.objects(),
            points: self.points,
            lines: self.lines,
            ..Columns::default()
        };
        let faces = match self.face_offsets.is_empty() {
            true => Faces::triangles(self.corners),
            false => Faces::polygons(self.corners, self.face_offsets),
        };
        notes.extend(non_finite_note(&self.positions, non_finite));
        let storage = restore_singles(&mut [&mut self.positions]);
        let builder = MeshBuilder { positions: self.positions, storage, faces, columns };
        let built = match non_finite {
            NonFinite::Refuse => builder.build().map(|mesh| (mesh, Vec::new())),
            NonFinite::DropFaces => builder.build_dropping_non_finite(),
        };
        let (mesh, non_finite_faces) = built.map_err(|error| mesh_fault(text, &error))?;
        let libraries = labels.all.into_iter().filter(|label| label.kind == LabelKind::Library);
        let libraries = libraries.map(|label| label.name).collect();
        Ok(Merged { mesh, non_finite_faces, remarks: self.remarks, notes, libraries })
    }
}

fn append<T>(all: &mut Vec<T>, mut more: Vec<T>) {
    if all.capacity() == 0 {
        *all = more;
    } else {
        all.append(&mut more);
    }
}

/// Appends an index that may be shorter than its corners, or missing, to one that starts at corner 0.
fn append_aligned(all: &mut Vec<u32>, more: Indices, corners_before: usize) {
    if !more.values.is_empty() {
        if corners_before > all.len() {
            all.resize(corners_before, NONE);
        }
        append(all, more.values);
    }
}

fn column<T>(values: Vec<T>, mut index: Vec<u32>, corners: usize) -> Option<Column<T>> {
    if index.iter().all(|&slot| slot == NONE) {
        return None;
    }
    index.resize(corners, NONE);
    Some(Column::per_corner(values, index))
}

/// Vertices without a colour get white, the neutral one; colours of 0 to 255 are brought to 0 to 1; what is not finite is 0.
fn finish_colors(mut colors: Vec<[f32; 4]>, notes: &mut Vec<Note>) -> Option<Vec<[f32; 4]>> {
    if colors.is_empty() {
        return None;
    }
    let missing = colors.iter().filter(|color| color.iter().all(|value| value.is_nan())).count();
    if missing > 0 {
        let text = format!("vertices without a colour get white: {missing} of {}", colors.len());
        notes.push(Note::remark(text));
    }
    let has_color = |color: &&mut [f32; 4]| color.iter().any(|value| !value.is_nan());
    let components = colors.iter_mut().filter(has_color).flatten();
    let not_finite = components.filter(|value| !value.is_finite()).map(|value| *value = 0.0).count();
    if not_finite > 0 {
        let text = format!("components of vertex colours that are not finite were read as 0: {not_finite}");
        notes.push(Note::warning(Place::File, text));
    }
    let is_bytes = colors.iter().flatten().any(|&value| value > 1.0);
    if is_bytes {
        notes.push(Note::remark("vertex colours go beyond 1 and are taken as 0 to 255"));
    }
    for color in &mut colors {
        for value in &mut *color {
            if value.is_nan() {
                *value = 1.0;
                continue;
            }
            *value = (if is_bytes { *value / 255.0 } else { *value }).clamp(0.0, 1.0);
        }
    }
    Some(colors)
}

/// Two numbers are set aside: for absence, and for what cannot be.
fn check_count(what: &str, count: usize) -> Result<(), Fault> {
    if count < NOWHERE as usize { Ok(()) } else { Err(too_many(what, count)) }
}

fn too_many(what: &str, count: usize) -> Fault {
    Fault {
        offset: 0,
        problem: Problem::Limit,
        found: format!("{count} {what}, more than 32-bit indices can count"),
        advice: "split the file",
    }
}

fn mesh_fault(text: &[u8], error: &MeshError) -> Fault {
    let MeshError::NonFinite { vertex, .. } = *error else {
        return Fault {
            offset: 0,
            problem: Problem::Limit,
            found: error.to_string(),
            advice: "split the file",
        };
    };
    let offset = arguments_of(text, Keyword::Vertex, vertex).unwrap_or(0);
    let mut cursor = Cursor::new(text, offset);
    let (mut spelled, mut overflows) = (Vec::new(), true);
    for _ in 0..3 {
        cursor.skip_blanks();
        let token = cursor.token();
        // Digits that are not finite are so only for a double.
        let is_word = token.iter().any(|byte| matches!(byte, b'n' | b'N' | b'#'));
        overflows &= !is_word || number::float(token).is_some_and(f64::is_finite);
        spelled.push(shown(token));
    }
    let what = if overflows { "beyond the range of doubles (1.8e308)" } else { "not finite" };
    Fault {
        offset,
        problem: Problem::NonFinite,
        found: format!("vertex {} is at ({}), which is {what}", vertex + 1, spelled.join(", ")),
        advice: "correct it, or drop the faces at such vertices with `crease normals --force` (`crease render --force` draws the others)",
    }
}
