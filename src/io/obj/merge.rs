//! The content of a whole file, checked and made into a mesh.

use super::cursor::{Cursor, name_text, too_many};
use super::notes;
use super::notes::{SMOOTHING_NAME, arguments_of, bad_references};
use super::piece::{Content, Label};
use super::statements::{Keyword, statements};
use crate::io::error::RepeatedNotes;
use crate::io::mesh_checks::{DROP_ADVICE, build_mesh, non_finite_note};
use crate::io::text::{at_byte, float, integer_prefix, shown, storage_of_text};
use crate::io::{NonFinite, Note, Problem, ReadError};
use crate::mesh::{
    Column, Columns, FaceLabels, Faces, Mesh, MeshBuilder, MeshError, NONE, Positions, SmoothingGroups,
};
use glam::DVec2;
use rustc_hash::{FxHashMap, FxHashSet};

pub(super) struct Merged {
    pub mesh: Mesh,
    pub non_finite_faces: Vec<u32>,
    pub notes: Vec<Note>,
    pub libraries: Vec<String>,
}

pub(super) fn merge(mut content: Content, text: &[u8], non_finite: NonFinite) -> Result<Merged, ReadError> {
    check_vertices(&content, text)?;
    remove_bad_attributes(&mut content, text);
    let corner_count = content.corners.values.len();
    let labels = Labels { text, faces: content.face_count(), all: std::mem::take(&mut content.labels) };
    let smoothing = labels.smoothing(&mut content.notes);
    let mut file_notes = notes::notes(&content.notes, text);
    let columns = Columns {
        normals: column(content.normals, content.corner_normals.values, corner_count),
        uvs: column(content.uvs, content.corner_uvs.values, corner_count),
        colors: finish_colors(content.colors, &mut file_notes),
        smoothing,
        materials: labels.names(Keyword::Material),
        objects: labels.objects(),
        points: content.points.values,
        lines: content.polylines,
        ..Columns::default()
    };
    let faces = match content.face_offsets.is_empty() {
        true => Faces::triangles(content.corners.values),
        false => Faces::polygons(content.corners.values, content.face_offsets),
    };
    let storage = storage_of_text(&[&content.positions]);
    let positions = Positions::rounded(content.positions, storage);
    file_notes.extend(non_finite_note(positions.view(), non_finite));
    let builder = MeshBuilder { positions, faces, columns };
    let (mesh, non_finite_faces) =
        build_mesh(builder, non_finite).map_err(|error| mesh_error(text, &error))?;
    let libraries = labels.of(Keyword::Library).map(|label| name_text(labels.name(label))).collect();
    Ok(Merged { mesh, non_finite_faces, notes: file_notes, libraries })
}

fn check_vertices(content: &Content, text: &[u8]) -> Result<(), ReadError> {
    let count = content.positions.len();
    let indices = content.corners.values.iter().chain(&content.points.values);
    let highest = indices.chain(content.polylines.iter().flatten()).max();
    if highest.is_none_or(|&vertex| (vertex as usize) < count) {
        return Ok(());
    }
    let first = bad_references(text, count, Keyword::Vertex, 1).pop();
    Err(first.map_or_else(|| too_many("vertices", count, 0), |reference| reference.into_error(count)))
}

/// References to missing attributes and to texture coordinates that are not finite become absent. Such normals stay.
fn remove_bad_attributes(content: &mut Content, text: &[u8]) {
    let (uvs, normals) = (content.uvs.len(), content.normals.len());
    for (index, count, target, kind) in [
        (&mut content.corner_uvs, uvs, Keyword::TextureCoordinate, notes::UV_OUT_OF_RANGE),
        (&mut content.corner_normals, normals, Keyword::Normal, notes::NORMAL_OUT_OF_RANGE),
    ] {
        let bad = remove(&mut index.values, |slot| slot as usize >= count);
        if bad > 0 {
            let places = bad_references(text, count, target, 1 + Note::MOST_PLACES);
            content.notes.add_all(kind, bad, places.iter().map(|bad| bad.offset));
        }
    }
    if content.uvs.iter().any(|uv| !uv.is_finite()) {
        let bad: Vec<bool> = content.uvs.iter().map(|uv| !uv.is_finite()).collect();
        remove(&mut content.corner_uvs.values, |slot| bad[slot as usize]);
        for uv in content.uvs.iter_mut().filter(|uv| !uv.is_finite()) {
            *uv = DVec2::ZERO;
        }
        let lines = statements(text).filter(|statement| statement.keyword == Keyword::TextureCoordinate);
        let places = lines.zip(&bad).filter(|(_, bad)| **bad).map(|(line, _)| line.arguments);
        let count = bad.iter().filter(|bad| **bad).count() as u64;
        content.notes.add_all(notes::UV_NOT_FINITE, count, places);
    }
}

/// Makes bad references absent and counts them.
fn remove(index: &mut [u32], is_bad: impl Fn(u32) -> bool) -> u64 {
    let bad = index.iter_mut().filter(|slot| **slot != NONE && is_bad(**slot));
    bad.map(|slot| *slot = NONE).count() as u64
}

fn column<T>(values: Vec<T>, mut index: Vec<u32>, corners: usize) -> Option<Column<T>> {
    if index.iter().all(|&slot| slot == NONE) {
        return None;
    }
    index.resize(corners, NONE);
    Some(Column::per_corner(values, index))
}

/// Vertices without a colour become white; colours of 0 to 255 are scaled to 0 to 1; components that are not finite become 0.
fn finish_colors(mut colors: Vec<[f32; 4]>, notes: &mut Vec<Note>) -> Option<Vec<[f32; 4]>> {
    if colors.is_empty() {
        return None;
    }
    let is_missing = |color: &[f32; 4]| color.iter().all(|value| value.is_nan());
    let missing = colors.iter().filter(|color| is_missing(color)).count();
    if missing > 0 {
        let text = format!("{missing} of {} vertices have no colour and are white", colors.len());
        notes.push(Note::remark(text));
    }
    let components = colors.iter_mut().filter(|color| !is_missing(color)).flatten();
    let not_finite = components.filter(|value| !value.is_finite()).map(|value| *value = 0.0).count();
    let nouns = ["colour component is", "colour components are"];
    notes.extend(Note::counted(not_finite, nouns, "not finite and read as 0"));
    let is_bytes = colors.iter().flatten().any(|&value| value > 1.0);
    if is_bytes {
        notes.push(Note::remark("vertex colours exceed 1 and were read as 0 to 255"));
    }
    for value in colors.iter_mut().flatten() {
        *value = match *value {
            missing if missing.is_nan() => 1.0,
            byte if is_bytes => (byte / 255.0).clamp(0.0, 1.0),
            value => value.clamp(0.0, 1.0),
        };
    }
    Some(colors)
}

fn mesh_error(text: &[u8], error: &MeshError) -> ReadError {
    let MeshError::NonFinite { vertex, .. } = *error else {
        return at_byte(Problem::Limit, 0, error.to_string(), "split the file");
    };
    let offset = arguments_of(text, Keyword::Vertex, vertex).unwrap_or(0);
    let mut cursor = Cursor::new(text, offset);
    let (mut spelled, mut overflows) = (Vec::new(), true);
    for _ in 0..3 {
        cursor.skip_blanks();
        let token = cursor.token();
        // Digits that are not finite are so only for a double.
        let is_word = token.iter().any(|byte| matches!(byte, b'n' | b'N' | b'#'));
        overflows &= !is_word || float(token).is_some_and(f64::is_finite);
        spelled.push(shown(token));
    }
    let what = if overflows { "beyond the range of doubles (1.8e308)" } else { "not finite" };
    let found = format!("vertex {vertex} is at ({}), which is {what}", spelled.join(", "));
    at_byte(Problem::NonFinite, offset, found, DROP_ADVICE)
}

/// All label statements of a file, in order, with the faces of the whole file counted.
pub(super) struct Labels<'a> {
    pub text: &'a [u8],
    pub all: Vec<Label>,
    pub faces: usize,
}

impl<'a> Labels<'a> {
    fn of(&self, keyword: Keyword) -> impl Iterator<Item = &Label> + Clone + '_ {
        self.all.iter().filter(move |label| label.keyword == keyword)
    }

    fn name(&self, label: &Label) -> &'a [u8] {
        &self.text[label.name.clone()]
    }

    /// The label of each face: `number` gives that of a statement, and faces before the first one get `none`.
    fn of_faces(&self, keyword: Keyword, none: u32, mut number: impl FnMut(&Label) -> u32) -> Vec<u32> {
        let (mut of_face, mut current) = (Vec::with_capacity(self.faces), none);
        for label in self.of(keyword) {
            of_face.resize(label.face as usize, current);
            current = number(label);
        }
        of_face.resize(self.faces, current);
        of_face
    }

    /// The materials, objects or groups of faces; `None` if no face has one. An empty name sets none.
    pub fn names(&self, keyword: Keyword) -> Option<FaceLabels> {
        self.of(keyword).find(|label| !label.name.is_empty())?;
        let (mut numbers, mut names) = (FxHashMap::default(), Vec::new());
        let of_face = self.of_faces(keyword, NONE, |label| match self.name(label) {
            [] => NONE,
            name => *numbers.entry(name).or_insert_with(|| {
                names.push(name_text(name));
                names.len() as u32 - 1
            }),
        });
        of_face.iter().any(|&label| label != NONE).then_some(FaceLabels { of_face, names })
    }

    /// The object of each face: that of `o` if the file has any, else that of `g`.
    pub fn objects(&self) -> Option<FaceLabels> {
        self.names(Keyword::Object).or_else(|| self.names(Keyword::Group))
    }

    /// The smoothing groups; `None` if the file has none. Groups are names: `off`, 0 and an empty name mean none, a number that fits
    /// is itself, and any other word (`on`, a fraction, 2³² or more) is a group of its own, numbered from the top down.
    pub fn smoothing(&self, notes: &mut RepeatedNotes) -> Option<SmoothingGroups> {
        let statements = self.of(Keyword::Smoothing);
        let before_first = statements.clone().next()?.face as usize;
        let numbers: FxHashSet<u32> = statements.filter_map(|label| group_number(self.name(label))).collect();
        let mut free = (0..NONE).rev().filter(|id| !numbers.contains(id));
        let mut names: FxHashMap<&[u8], u32> = FxHashMap::default();
        let of_face = self.of_faces(Keyword::Smoothing, 0, |label| {
            let token = self.name(label);
            group_number(token).unwrap_or_else(|| {
                notes.add(SMOOTHING_NAME, label.name.start);
                match token {
                    [] => 0,
                    // A file cannot name more groups than there are numbers.
                    name => *names.entry(name).or_insert_with(|| free.next().unwrap_or(0)),
                }
            })
        });
        Some(SmoothingGroups { of_face, before_first })
    }
}

fn group_number(token: &[u8]) -> Option<u32> {
    if token.eq_ignore_ascii_case(b"off") {
        return Some(0);
    }
    match integer_prefix(token)? {
        (value, length) if length == token.len() && token[0].is_ascii_digit() => {
            u32::try_from(value).ok().filter(|&id| id != NONE)
        }
        _ => None,
    }
}
