//! One stretch of the file, parsed on its own.
//!
//! A stretch starts and ends at statements. What it cannot know (how many vertices come before it, which group
//! and material it starts in) is put in by [`merge`](super::merge) when all stretches are there.

use super::arguments::{Fault, checked_end, not_a_corner, number, refers_to_normals};
use super::arguments::{three_numbers, too_few, vertex_list, zero_index};
use super::indices::Indices;
use super::lexer::{Cursor, Keyword};
use super::remarks::{Remark, Remarks};
use glam::{DVec2, DVec3};
use std::ops::Range;

/// What a label statement sets for the faces after it.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum LabelKind {
    Smoothing,
    Object,
    Group,
    Material,
    /// No label: the name of a material library, kept in the same list.
    Library,
}

/// A label statement.
#[derive(Clone, Debug)]
pub(super) struct Label {
    pub kind: LabelKind,
    /// Faces of this stretch before it.
    pub face: u32,
    /// Where its name is in the file.
    pub name: Range<usize>,
}

/// Everything that a stretch of the file says.
#[derive(Debug, Default)]
pub(super) struct Stretch {
    pub positions: Vec<DVec3>,
    /// One a vertex from the first that has one, [`NO_COLOR`] for a vertex without.
    pub colors: Vec<[f32; 4]>,
    pub uvs: Vec<DVec2>,
    pub normals: Vec<DVec3>,
    pub corners: Indices,
    /// Where each face ends in `corners`; `None` while all are triangles.
    pub face_ends: Option<Vec<u32>>,
    /// Texture coordinates and normals of corners, filled up to the last corner that has one.
    pub corner_uvs: Indices,
    pub corner_normals: Indices,
    pub points: Indices,
    pub lines: Indices,
    pub line_ends: Vec<u32>,
    pub labels: Vec<Label>,
    /// Where the first face statement starts.
    pub first_face: Option<usize>,
    /// Where the line of the last normal before the first face ends, and how many there are.
    pub leading_normals: Option<(usize, usize)>,
    /// Whether a free-form surface refers to normals by number.
    pub surface_normals: bool,
    pub statements: u64,
    pub remarks: Remarks,
}

/// The colour of a vertex without one.
pub(super) const NO_COLOR: [f32; 4] = [f32::NAN; 4];

/// Parses the statements of `text` that start in `range`, which must begin and end at line starts.
pub(super) fn parse(text: &[u8], range: Range<usize>) -> Result<Stretch, Fault> {
    let mut stretch = Stretch::default();
    let mut cursor = Cursor::new(&text[..range.end], range.start);
    while !cursor.is_done() {
        let start = cursor.at;
        let keyword = cursor.keyword();
        stretch.statement(&mut cursor, keyword, start)?;
        cursor.skip_statement();
        if keyword == Keyword::Normal && stretch.first_face.is_none() {
            stretch.leading_normals = Some((cursor.at, stretch.normals.len()));
        }
    }
    Ok(stretch)
}

impl Stretch {
    #[inline]
    fn statement(&mut self, cursor: &mut Cursor<'_>, keyword: Keyword, start: usize) -> Result<(), Fault> {
        match keyword {
            Keyword::Vertex => return self.vertex(cursor),
            Keyword::Face => {
                self.first_face.get_or_insert(start);
                return self.face(cursor, start);
            }
            Keyword::Normal => {
                let normal = three_numbers(cursor, "a normal")?;
                self.normals.push(normal);
            }
            Keyword::TextureCoordinate => return self.uv(cursor),
            Keyword::Line => return self.line(cursor, start),
            Keyword::Point => return self.points(cursor, start),
            Keyword::Smoothing => self.label(LabelKind::Smoothing, cursor),
            Keyword::Object => self.label(LabelKind::Object, cursor),
            Keyword::Group => self.label(LabelKind::Group, cursor),
            Keyword::Material => self.label(LabelKind::Material, cursor),
            Keyword::Library => self.label(LabelKind::Library, cursor),
            Keyword::Surface => {
                self.remarks.add(Remark::FreeForm, start);
                self.surface_normals |= refers_to_normals(cursor);
            }
            Keyword::FreeForm => self.remarks.add(Remark::FreeForm, start),
            Keyword::Display => {}
            Keyword::Unknown => {
                self.remarks.add(Remark::Unknown, start);
                return Ok(());
            }
            Keyword::Blank => return Ok(()),
        }
        self.statements += 1;
        Ok(())
    }

    #[inline]
    fn vertex(&mut self, cursor: &mut Cursor<'_>) -> Result<(), Fault> {
        let start = cursor.at;
        let position = three_numbers(cursor, "a vertex")?;
        self.positions.push(position);
        self.statements += 1;
        if cursor.peek() == b'\n' {
            if !self.colors.is_empty() {
                self.colors.push(NO_COLOR);
            }
            return Ok(());
        }
        self.rest_of_vertex(cursor, start)
    }

    /// What may follow x y z: `w`, a weight of rational curves; or `r g b`, or `r g b a`.
    fn rest_of_vertex(&mut self, cursor: &mut Cursor<'_>, start: usize) -> Result<(), Fault> {
        let (mut rest, mut count) = ([0.0; 4], 0);
        loop {
            cursor.skip_blanks();
            if cursor.at_statement_end() {
                break;
            }
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
        if matches!(count, 3 | 4) && self.colors.is_empty() {
            self.colors.resize(self.positions.len() - 1, NO_COLOR);
        }
        if matches!(count, 3 | 4) || !self.colors.is_empty() {
            self.colors.push(color);
        }
        match count {
            0 | 3 | 4 => {}
            1 if rest[0] == 1.0 => {}
            1 => self.remarks.add(Remark::Weight, start),
            _ => self.remarks.add(Remark::ExtraNumbers, start),
        }
        Ok(())
    }

    fn uv(&mut self, cursor: &mut Cursor<'_>) -> Result<(), Fault> {
        cursor.skip_blanks();
        if cursor.at_statement_end() {
            return Err(too_few(cursor, "a texture coordinate", 0, "1 to 3 are needed"));
        }
        let u = number(cursor)?;
        cursor.skip_blanks();
        let v = if cursor.at_statement_end() { 0.0 } else { number(cursor)? };
        self.uvs.push(DVec2::new(u, v));
        self.statements += 1;
        Ok(())
    }

    #[inline]
    fn face(&mut self, cursor: &mut Cursor<'_>, start: usize) -> Result<(), Fault> {
        let first = self.corners.values.len();
        loop {
            cursor.skip_blanks();
            if cursor.at_statement_end() {
                break;
            }
            let at = cursor.at;
            let Some(corner) = cursor.corner() else { return Err(not_a_corner(cursor, at)) };
            if corner.vertex == 0 {
                return Err(zero_index(at));
            }
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
        self.end_face(first, start)
    }

    #[inline]
    fn end_face(&mut self, first: usize, start: usize) -> Result<(), Fault> {
        let total = self.corners.values.len();
        self.statements += 1;
        if total - first == 3 && self.face_ends.is_none() {
            return Ok(());
        }
        if total - first < 3 {
            self.corners.truncate(first);
            self.corner_uvs.truncate(first);
            self.corner_normals.truncate(first);
            self.remarks.add(Remark::ShortFace, start);
            return Ok(());
        }
        let end = checked_end(total, start)?;
        let ends =
            self.face_ends.get_or_insert_with(|| (1..=first as u32 / 3).map(|face| 3 * face).collect());
        ends.push(end);
        Ok(())
    }

    fn face_count(&self) -> u32 {
        self.face_ends.as_ref().map_or(self.corners.values.len() / 3, Vec::len) as u32
    }

    fn line(&mut self, cursor: &mut Cursor<'_>, start: usize) -> Result<(), Fault> {
        let first = self.lines.values.len();
        vertex_list(cursor, &mut self.lines, self.positions.len())?;
        self.statements += 1;
        if self.lines.values.len() - first < 2 {
            self.lines.truncate(first);
            self.remarks.add(Remark::ShortLine, start);
            return Ok(());
        }
        self.line_ends.push(checked_end(self.lines.values.len(), start)?);
        Ok(())
    }

    fn points(&mut self, cursor: &mut Cursor<'_>, start: usize) -> Result<(), Fault> {
        vertex_list(cursor, &mut self.points, self.positions.len())?;
        self.statements += 1;
        checked_end(self.points.values.len(), start).map(|_| ())
    }

    fn label(&mut self, kind: LabelKind, cursor: &mut Cursor<'_>) {
        cursor.skip_blanks();
        let name = match kind {
            LabelKind::Smoothing => {
                let start = cursor.at;
                cursor.token();
                start..cursor.at
            }
            _ => cursor.name(),
        };
        self.labels.push(Label { kind, face: self.face_count(), name });
    }
}
