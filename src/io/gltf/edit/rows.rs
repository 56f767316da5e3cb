//! The values that a vertex can have: a stored normal and the deltas of each morph target, as bytes.

use super::member::Member;
use crate::io::gltf::accessor::{Source, float};
use crate::io::gltf::data::{LENGTH_TOLERANCE, normal_format, push_floats, push_normal};
use crate::io::gltf::records::{Format, VertexAccessors};
use crate::io::{NormalFormat, ReadError};
use crate::mesh::{Column, NONE, VertexSplit};
use glam::{DVec3, Vec3};
use rustc_hash::FxHashMap;
use std::borrow::Cow;

/// What a set of vertices has stored so far, and how it will be stored.
pub struct Stored<'a> {
    pub format: Format,
    /// The stored normals, as bytes of `format`; `None` where there are none, or they were stored otherwise.
    same: Option<Cow<'a, [u8]>>,
    /// The stored normals as numbers, if there are any.
    floats: Option<Vec<[f32; 3]>>,
    /// The stored normal deltas of each morph target that gets new ones.
    pub deltas: Vec<Option<Vec<[f32; 3]>>>,
}

impl<'a> Stored<'a> {
    pub fn new(
        source: &Source<'a>,
        vertices: &VertexAccessors,
        wanted: NormalFormat,
        morph: bool,
    ) -> Result<Self, ReadError> {
        let elements = |set| vertices.of_set(set, "NORMAL").map(|number| source.elements(number)).transpose();
        let base = elements(0)?;
        let format = normal_format(base.map(|base| base.format), wanted);
        let same = base.filter(|base| base.format == format).map(|base| base.raw());
        let targets = vertices.target_sets().filter(|_| morph);
        let deltas = targets.map(|set| Ok(elements(set)?.map(|deltas| deltas.floats(0.0).collect())));
        let deltas = deltas.collect::<Result<_, ReadError>>()?;
        Ok(Self { format, same, floats: base.map(|base| base.floats(0.0).collect()), deltas })
    }

    fn size(&self) -> usize {
        self.format.size() + 12 * self.deltas.len()
    }

    /// The stored row of a vertex; +Z if it has no normal.
    fn push_stored(&self, vertex: usize, out: &mut Vec<u8>) {
        match (self.stored_bytes(vertex), &self.floats) {
            (Some(bytes), _) => out.extend_from_slice(bytes),
            (None, Some(floats)) => {
                push_normal(Vec3::from_array(floats[vertex]).as_dvec3(), self.format, out)
            }
            (None, None) => push_normal(DVec3::Z, self.format, out),
        }
        for delta in &self.deltas {
            push_delta(delta, vertex, out);
        }
    }

    /// The row of a normal that an edit gives to a vertex. One of the file's own keeps its bits.
    fn push_given(&self, member: &Member<'_>, normals: &Column<DVec3>, slot: u32, out: &mut Vec<u8>) {
        let start = out.len();
        let element = member.stored_element(slot);
        match element.and_then(|element| self.stored_bytes(element)) {
            Some(bytes) => out.extend_from_slice(bytes),
            None => push_normal(normals.values[slot as usize], self.format, out),
        }
        let written = self.decode(&out[start..]);
        for (target, delta) in self.deltas.iter().enumerate() {
            match element {
                // A target without normals leaves the base's normal alone, and so a kept one stays alone too.
                Some(element) => push_delta(delta, element, out),
                None => {
                    let moved = member.edit.morph_normals[target][slot as usize];
                    push_floats(moved - written.as_dvec3(), out);
                }
            }
        }
    }

    /// Replaces a stored normal by +Z if readers would not accept it.
    fn repair(&self, row: &mut [u8]) {
        let length = self.decode(row).as_dvec3().length();
        // Not a number is not within the tolerance either.
        let is_unit = (length - 1.0).abs() < LENGTH_TOLERANCE;
        if !is_unit {
            let mut up = Vec::new();
            push_normal(DVec3::Z, self.format, &mut up);
            row[..up.len()].copy_from_slice(&up);
        }
    }

    fn stored_bytes(&self, vertex: usize) -> Option<&[u8]> {
        let size = self.format.size();
        self.same.as_ref().map(|bytes| &bytes[vertex * size..(vertex + 1) * size])
    }

    pub fn decode(&self, row: &[u8]) -> Vec3 {
        let component = self.format.component;
        let number = |axis: usize| float(&row[component.size() * axis..], component, true);
        Vec3::new(number(0), number(1), number(2)).max(Vec3::NEG_ONE)
    }
}

fn push_delta(deltas: &Option<Vec<[f32; 3]>>, vertex: usize, out: &mut Vec<u8>) {
    let delta = deltas.as_ref().map_or([0.0; 3], |deltas| deltas[vertex]);
    out.extend_from_slice(bytemuck::bytes_of(&delta));
}

/// A list of rows, as bytes.
pub struct Table {
    bytes: Vec<u8>,
    size: usize,
}

/// The rows that the corners of a group of primitives ask for.
pub struct Rows {
    table: Table,
    /// The row of each corner, over all members; corners with equal rows have the first of them.
    pub of_corner: Vec<u32>,
    /// Corners without a normal of their own, among others that have one.
    pub missing: usize,
}

impl Rows {
    /// `tables` holds the row of each normal by part, [`NONE`] between groups.
    pub fn new(stored: &Stored<'_>, members: &[Member<'_>], tables: &mut FxHashMap<usize, Vec<u32>>) -> Rows {
        let table = Table { bytes: Vec::new(), size: stored.size() };
        let mut rows = Rows { table, of_corner: Vec::new(), missing: 0 };
        let (mut bytes, mut count) = (Vec::new(), 0);
        for member in members {
            let Some(normals) = &member.edit.normals else { continue };
            let table = tables.entry(member.part).or_insert_with(|| vec![NONE; normals.values.len()]);
            let mut seen = Vec::new();
            for &corner in &member.corners {
                let slot = member.slot(normals, corner);
                let known = slot.map(|slot| table[slot as usize]).filter(|&row| row != NONE);
                rows.of_corner.push(known.unwrap_or(count));
                if known.is_some() {
                    continue;
                }
                match slot {
                    Some(slot) => {
                        stored.push_given(member, normals, slot, &mut bytes);
                        table[slot as usize] = count;
                        seen.push(slot);
                    }
                    None => {
                        let start = bytes.len();
                        stored.push_stored(member.vertex(corner) as usize, &mut bytes);
                        stored.repair(&mut bytes[start..]);
                        rows.missing += 1;
                    }
                }
                count += 1;
            }
            seen.iter().for_each(|&slot| table[slot as usize] = NONE);
        }
        let mut first: FxHashMap<&[u8], u32> = FxHashMap::default();
        let numbered = bytes.chunks_exact(rows.table.size).zip(0..);
        let first: Vec<u32> = numbered.map(|(row, number)| *first.entry(row).or_insert(number)).collect();
        rows.of_corner.iter_mut().for_each(|row| *row = first[*row as usize]);
        rows.table.bytes = bytes;
        rows
    }

    /// The row of a corner.
    pub fn of(&self, corner: usize) -> &[u8] {
        let start = self.of_corner[corner] as usize * self.table.size;
        &self.table.bytes[start..start + self.table.size]
    }

    /// The rows of the vertices of a split: as stored where no corner uses the vertex.
    pub fn gather(&self, stored: &Stored<'_>, split: &VertexSplit) -> Table {
        let mut bytes = Vec::new();
        for (&sample, &source) in split.sample.iter().zip(&split.source) {
            match sample {
                NONE => stored.push_stored(source as usize, &mut bytes),
                corner => bytes.extend_from_slice(self.of(corner as usize)),
            }
        }
        Table { bytes, size: self.table.size }
    }
}

impl Table {
    /// Normals, as bytes without gaps.
    pub fn normals(&self, stored: &Stored<'_>) -> Cow<'_, [u8]> {
        self.column(0, stored.format.size())
    }

    /// Normal deltas of a morph target.
    pub fn deltas(&self, stored: &Stored<'_>, target: usize) -> Cow<'_, [u8]> {
        self.column(stored.format.size() + 12 * target, 12)
    }

    /// Whether this is what is stored already.
    pub fn is_stored(&self, stored: &Stored<'_>) -> bool {
        let delta = |(target, delta): (usize, &Option<Vec<[f32; 3]>>)| {
            let new = self.deltas(stored, target);
            match delta {
                Some(old) => bytemuck::cast_slice::<_, u8>(old) == &*new,
                None => new.iter().all(|&byte| byte == 0),
            }
        };
        stored.same.as_ref().is_some_and(|bytes| *bytes == self.normals(stored))
            && stored.deltas.iter().enumerate().all(delta)
    }

    /// Repairs the normals of vertices of a split that no corner uses.
    pub fn repair_unused(&mut self, stored: &Stored<'_>, split: &VertexSplit) {
        let rows = self.bytes.chunks_exact_mut(self.size).zip(&split.sample);
        rows.filter(|(_, sample)| **sample == NONE).for_each(|(row, _)| stored.repair(row));
    }

    fn column(&self, start: usize, size: usize) -> Cow<'_, [u8]> {
        if size == self.size {
            return Cow::Borrowed(&self.bytes);
        }
        let mut column = Vec::with_capacity(self.bytes.len() / self.size * size);
        let rows = self.bytes.chunks_exact(self.size);
        rows.for_each(|row| column.extend_from_slice(&row[start..start + size]));
        Cow::Owned(column)
    }
}
