//! One piece of the file, parsed on its own.
//!
//! A piece starts and ends at statements. What it cannot know (how many vertices come before it, which group
//! and material it starts in) is added by [`merge`](super::merge) when all pieces are parsed.

use super::cursor::{
    Cursor, checked_end, next_corner, number, refers_to_normals, three_numbers, too_few, too_many,
};
use super::notes;
use super::statements::Keyword;
use crate::io::ReadError;
use crate::io::error::RepeatedNotes;

use crate::mesh::NONE;
use glam::{DVec2, DVec3};
use std::ops::Range;

/// A statement that sets the smoothing group, object, group or material of the faces after it, or names a material library.
#[derive(Clone, Debug)]
pub(super) struct Label {
    pub keyword: Keyword,
    pub face: u32,
    pub name: Range<usize>,
}

/// The content of a piece, or of all pieces so far.
#[derive(Debug, Default)]
pub(super) struct Content {
    pub positions: Vec<DVec3>,
    /// One a vertex from the first that has one, [`NO_COLOR`] for a vertex without.
    pub colors: Vec<[f32; 4]>,
    pub uvs: Vec<DVec2>,
    pub normals: Vec<DVec3>,
    pub corners: Indices,
    /// Where each face starts in `corners`, and where the last one ends; empty while all are triangles.
    pub face_offsets: Vec<u32>,
    /// Texture coordinates and normals of corners, up to the last corner that has one.
    pub corner_uvs: Indices,
    pub corner_normals: Indices,
    pub points: Indices,
    /// The lines that [`append`](Self::append) has not moved to `polylines`.
    lines: Indices,
    line_ends: Vec<u32>,
    pub polylines: Vec<Vec<u32>>,
    pub labels: Vec<Label>,
    first_face: Option<usize>,
    /// Where the line of the last normal before the first face ends, and how many there are.
    leading_normals: Option<(usize, usize)>,
    /// Whether a free-form surface refers to normals by number.
    pub surface_normals: bool,
    pub has_statements: bool,
    pub notes: RepeatedNotes,
}

pub(super) const NO_COLOR: [f32; 4] = [f32::NAN; 4];

/// Parses the statements of `text` that start in `range`, which must begin and end at line starts.
pub(super) fn parse(text: &[u8], range: Range<usize>) -> Result<Content, ReadError> {
    let mut content = Content::default();
    let mut cursor = Cursor::new(&text[..range.end], range.start);
    while !cursor.is_done() {
        let start = cursor.at;
        let keyword = Keyword::read(&mut cursor);
        content.statement(&mut cursor, keyword, start)?;
        cursor.skip_statement();
        if keyword == Keyword::Normal && content.first_face.is_none() {
            content.leading_normals = Some((cursor.at, content.normals.len()));
        }
    }
    Ok(content)
}

impl Content {
    #[inline]
    fn statement(
        &mut self,
        cursor: &mut Cursor<'_>,
        keyword: Keyword,
        start: usize,
    ) -> Result<(), ReadError> {
        match keyword {
            Keyword::Vertex => self.vertex(cursor)?,
            Keyword::Face => {
                self.first_face.get_or_insert(start);
                self.face(cursor, start)?;
            }
            Keyword::Normal => self.normals.push(three_numbers(cursor, "a normal")?),
            Keyword::TextureCoordinate => self.uv(cursor)?,
            Keyword::Line => self.line(cursor, start)?,
            Keyword::Point => {
                vertex_list(cursor, &mut self.points, self.positions.len())?;
                checked_end(self.points.values.len(), start)?;
            }
            Keyword::Smoothing | Keyword::Object | Keyword::Group | Keyword::Material | Keyword::Library => {
                self.label(keyword, cursor)
            }
            Keyword::Surface => {
                self.notes.add(notes::FREE_FORM, start);
                self.surface_normals |= refers_to_normals(cursor);
            }
            Keyword::FreeForm => self.notes.add(notes::FREE_FORM, start),
            Keyword::Unknown => self.notes.add(notes::UNKNOWN, start),
            Keyword::Display | Keyword::Blank => {}
        }
        self.has_statements |= !matches!(keyword, Keyword::Unknown | Keyword::Blank);
        Ok(())
    }

    #[inline]
    fn vertex(&mut self, cursor: &mut Cursor<'_>) -> Result<(), ReadError> {
        let start = cursor.at;
        let position = three_numbers(cursor, "a vertex")?;
        self.positions.push(position);
        if cursor.peek() == b'\n' {
            if !self.colors.is_empty() {
                self.colors.push(NO_COLOR);
            }
            return Ok(());
        }
        self.rest_of_vertex(cursor, start)
    }

    /// What may follow x y z: `w`, a weight of rational curves; or `r g b`, or `r g b a`.
    fn rest_of_vertex(&mut self, cursor: &mut Cursor<'_>, start: usize) -> Result<(), ReadError> {
        let (mut rest, mut count) = ([0.0; 4], 0);
        while cursor.next_argument().is_some() {
            let value = number(cursor)?;
            if let Some(slot) = rest.get_mut(count) {
                *slot = value;
            }
            count += 1;
        }
        let [red, green, blue, alpha] = rest.map(|value| value as f32);
        let color = match count {
            3 => [red, green, blue, 1.0],
            4 => [red, green, blue, alpha],
            _ => NO_COLOR,
        };
        let has_color = matches!(count, 3 | 4);
        if has_color || !self.colors.is_empty() {
            self.colors.resize(self.positions.len() - 1, NO_COLOR);
            self.colors.push(color);
        }
        match count {
            0 | 3 | 4 => {}
            1 if rest[0] == 1.0 => {}
            1 => self.notes.add(notes::WEIGHT, start),
            _ => self.notes.add(notes::EXTRA_NUMBERS, start),
        }
        Ok(())
    }

    fn uv(&mut self, cursor: &mut Cursor<'_>) -> Result<(), ReadError> {
        if cursor.next_argument().is_none() {
            return Err(too_few(cursor, "a texture coordinate", 0, "1 to 3 are needed"));
        }
        let u = number(cursor)?;
        let v = if cursor.next_argument().is_some() { number(cursor)? } else { 0.0 };
        self.uvs.push(DVec2::new(u, v));
        Ok(())
    }

    #[inline]
    fn face(&mut self, cursor: &mut Cursor<'_>, start: usize) -> Result<(), ReadError> {
        let first = self.corners.values.len();
        while let Some(corner) = next_corner(cursor)? {
            let place = self.corners.values.len();
            self.corners.push(corner.vertex, self.positions.len());
            if let Some(uv) = corner.uv {
                self.corner_uvs.pad(place);
                self.corner_uvs.push(uv, self.uvs.len());
            }
            if let Some(normal) = corner.normal {
                self.corner_normals.pad(place);
                self.corner_normals.push(normal, self.normals.len());
            }
        }
        let total = self.corners.values.len();
        if total - first == 3 && self.face_offsets.is_empty() {
            return Ok(());
        }
        if total - first < 3 {
            self.corners.truncate(first);
            self.corner_uvs.truncate(first);
            self.corner_normals.truncate(first);
            self.notes.add(notes::SHORT_FACE, start);
            return Ok(());
        }
        let end = checked_end(total, start)?;
        if self.face_offsets.is_empty() {
            self.face_offsets.extend((0..=first as u32).step_by(3));
        }
        self.face_offsets.push(end);
        Ok(())
    }

    fn line(&mut self, cursor: &mut Cursor<'_>, start: usize) -> Result<(), ReadError> {
        let first = self.lines.values.len();
        vertex_list(cursor, &mut self.lines, self.positions.len())?;
        if self.lines.values.len() - first < 2 {
            self.lines.truncate(first);
            self.notes.add(notes::SHORT_LINE, start);
            return Ok(());
        }
        self.line_ends.push(checked_end(self.lines.values.len(), start)?);
        Ok(())
    }

    fn label(&mut self, keyword: Keyword, cursor: &mut Cursor<'_>) {
        cursor.skip_blanks();
        let name = if keyword == Keyword::Smoothing {
            let start = cursor.at;
            cursor.token();
            start..cursor.at
        } else {
            cursor.name()
        };
        self.labels.push(Label { keyword, face: self.face_count() as u32, name });
    }

    pub fn face_count(&self) -> usize {
        self.face_offsets.len().checked_sub(1).unwrap_or(self.corners.values.len() / 3)
    }

    /// Where new normals go, and how many `vn` lines are before that: after the last one before the first face, or before that face.
    pub fn insertion(&self) -> (usize, usize) {
        self.leading_normals.unwrap_or((self.first_face.unwrap_or(0), 0))
    }

    pub fn append(&mut self, mut next: Content) -> Result<(), ReadError> {
        let (vertices, corners) = (self.positions.len(), self.corners.values.len());
        check_count("vertices", vertices + next.positions.len())?;
        check_count("corners", corners + next.corners.values.len())?;
        if self.first_face.is_none() {
            let leading = next.leading_normals.map(|(at, count)| (at, self.normals.len() + count));
            self.leading_normals = leading.or(self.leading_normals);
            self.first_face = next.first_face;
        }
        for indices in [&mut next.corners, &mut next.points, &mut next.lines] {
            indices.resolve(vertices);
        }
        next.corner_uvs.resolve(self.uvs.len());
        next.corner_normals.resolve(self.normals.len());
        let faces = self.face_count() as u32;
        self.labels.extend(next.labels.into_iter().map(|label| Label { face: label.face + faces, ..label }));
        append_face_offsets(&mut self.face_offsets, &next.face_offsets, corners, next.corners.values.len());
        if !(next.colors.is_empty() && self.colors.is_empty()) {
            self.colors.resize(vertices, NO_COLOR);
            self.colors.extend(next.colors);
            self.colors.resize(vertices + next.positions.len(), NO_COLOR);
        }
        for (all, more) in
            [(&mut self.corner_uvs, next.corner_uvs), (&mut self.corner_normals, next.corner_normals)]
        {
            if !more.values.is_empty() {
                all.pad(corners);
                append(&mut all.values, more.values);
            }
        }
        append(&mut self.corners.values, next.corners.values);
        append(&mut self.positions, next.positions);
        append(&mut self.uvs, next.uvs);
        append(&mut self.normals, next.normals);
        append(&mut self.points.values, next.points.values);
        let mut start = 0;
        for end in next.line_ends {
            self.polylines.push(next.lines.values[start..end as usize].to_vec());
            start = end as usize;
        }
        self.notes.append(next.notes);
        self.surface_normals |= next.surface_normals;
        self.has_statements |= next.has_statements;
        Ok(())
    }
}

/// Reads the vertices of a line or of points; the document keeps the texture coordinates of lines.
fn vertex_list(cursor: &mut Cursor<'_>, into: &mut Indices, count: usize) -> Result<(), ReadError> {
    while let Some(corner) = next_corner(cursor)? {
        into.push(corner.vertex, count);
    }
    Ok(())
}

/// Appends the face offsets of so many `more` corners to those of so many `corners`.
fn append_face_offsets(all: &mut Vec<u32>, next: &[u32], corners: usize, more: usize) {
    if next.is_empty() && all.is_empty() {
        return;
    }
    let base = corners as u32;
    if all.is_empty() {
        all.extend((0..=base).step_by(3));
    }
    match next {
        [] => all.extend((3..=more as u32).step_by(3).map(|end| base + end)),
        [_, ends @ ..] => all.extend(ends.iter().map(|end| base + end)),
    }
}

fn append<T>(all: &mut Vec<T>, mut more: Vec<T>) {
    if all.capacity() == 0 {
        *all = more;
    } else {
        all.append(&mut more);
    }
}

/// Two indices are reserved: [`NOWHERE`] and the one above it, [`NONE`](crate::mesh::NONE).
fn check_count(what: &str, count: usize) -> Result<(), ReadError> {
    if count < NOWHERE as usize { Ok(()) } else { Err(too_many(what, count, 0)) }
}

/// In a list of indices: a reference to something that cannot exist. No count of a mesh reaches it.
pub(super) const NOWHERE: u32 = NONE - 1;

/// Zero-based indices. Negative ones are kept relative to the start of the piece, as two's complement, in listed ranges.
#[derive(Debug, Default)]
pub(super) struct Indices {
    pub values: Vec<u32>,
    relative: Vec<Range<u32>>,
}

impl Indices {
    /// Appends an index as it is spelled, `count` items of its kind being defined in this piece so far.
    #[inline]
    pub fn push(&mut self, spelled: i64, count: usize) {
        if spelled > 0 {
            self.values.push((spelled - 1).min(i64::from(NOWHERE)) as u32);
        } else {
            self.push_relative(spelled, count);
        }
    }

    fn push_relative(&mut self, spelled: i64, count: usize) {
        let at = self.values.len() as u32;
        match i32::try_from(spelled.saturating_add(count as i64)) {
            Ok(value) if spelled < 0 => {
                self.values.push(value as u32);
                match self.relative.last_mut() {
                    Some(run) if run.end == at => run.end += 1,
                    _ => self.relative.push(at..at + 1),
                }
            }
            _ => self.values.push(NOWHERE),
        }
    }

    #[inline]
    pub fn pad(&mut self, length: usize) {
        if self.values.len() < length {
            self.values.resize(length, NONE);
        }
    }

    pub fn truncate(&mut self, length: usize) {
        self.values.truncate(length);
        let length = length as u32;
        while let Some(run) = self.relative.last_mut() {
            if run.start < length {
                run.end = run.end.min(length);
                return;
            }
            self.relative.pop();
        }
    }

    /// Makes all indices absolute, `base` items of their kind being defined in earlier pieces.
    pub fn resolve(&mut self, base: usize) {
        for run in self.relative.drain(..) {
            for value in &mut self.values[run.start as usize..run.end as usize] {
                let absolute = i64::from(*value as i32) + base as i64;
                *value = u32::try_from(absolute).unwrap_or(NOWHERE).min(NOWHERE);
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn relative_indices_wait_for_the_count_before_them() {
        let mut indices = Indices::default();
        for (spelled, count) in [(3, 0), (-1, 2), (-5, 2), (-9, 2), (0, 2), (i64::MIN, 2), (i64::MAX, 2)] {
            indices.push(spelled, count);
        }
        indices.resolve(4);
        assert_eq!(indices.values, [2, 5, 1, NOWHERE, NOWHERE, NOWHERE, NOWHERE]);
    }

    #[test]
    fn truncation_forgets_relative_places() {
        let mut indices = Indices::default();
        for spelled in [-1, -1, 7, -1, -1] {
            indices.push(spelled, 1);
        }
        indices.truncate(4);
        indices.push(9, 1);
        indices.truncate(1);
        indices.pad(3);
        indices.resolve(10);
        assert_eq!(indices.values, [10, NONE, NONE]);
    }
}
