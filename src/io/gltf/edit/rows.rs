//! The values that a vertex can have: a stored normal and the deltas of each morph target, as bytes.

use super::member::Member;
use crate::io::gltf::accessor::{Source, float};
use crate::io::gltf::data::{LENGTH_TOLERANCE, normal_format, push_floats, push_normal};
use crate::io::gltf::records::{Format, VertexAccessors};
use crate::io::{NormalFormat, ReadError};
use crate::mesh::{Column, NONE};
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
            push_raw(delta.as_ref().map_or([0.0; 3], |delta| delta[vertex]), out);
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
                Some(element) => push_raw(delta.as_ref().map_or([0.0; 3], |delta| delta[element]), out),
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

fn push_raw(vector: [f32; 3], out: &mut Vec<u8>) {
    out.extend_from_slice(bytemuck::bytes_of(&vector));
}

/// The rows that the corners of a group of primitives ask for, equal ones once.
pub struct Rows {
    bytes: Vec<u8>,
    size: usize,
    /// The row of each corner, over all members.
    pub of_corner: Vec<u32>,
    /// Corners without a normal of their own, among others that have one.
    pub missing: usize,
}

impl Rows {
    pub fn new(stored: &Stored<'_>, members: &[Member<'_>], tables: &mut FxHashMap<usize, Vec<u32>>) -> Rows {
        let mut rows = Rows { bytes: Vec::new(), size: stored.size(), of_corner: Vec::new(), missing: 0 };
        let mut count = 0;
        for member in members {
            let Some(normals) = &member.edit.normals else { continue };
            // From normal numbers to rows; kept empty between groups.
            let table = tables.entry(member.part).or_insert_with(|| vec![NONE; normals.values.len()]);
            let mut seen = Vec::new();
            for &corner in &member.corners {
                let slot = member.slot(normals, corner);
                let known = slot.map(|slot| table[slot as usize]).filter(|&row| row != NONE);
                if let Some(row) = known {
                    rows.of_corner.push(row);
                    continue;
                }
                match slot {
                    Some(slot) => {
                        stored.push_given(member, normals, slot, &mut rows.bytes);
                        table[slot as usize] = count;
                        seen.push(slot);
                    }
                    None => {
                        let start = rows.bytes.len();
                        stored.push_stored(member.vertex(corner) as usize, &mut rows.bytes);
                        stored.repair(&mut rows.bytes[start..]);
                        rows.missing += 1;
                    }
                }
                rows.of_corner.push(count);
                count += 1;
            }
            seen.iter().for_each(|&slot| table[slot as usize] = NONE);
        }
        rows.merge_equal();
        rows
    }

    /// Lets corners with equal rows refer to the first of them.
    fn merge_equal(&mut self) {
        let mut first: FxHashMap<&[u8], u32> = FxHashMap::default();
        let rows = self.bytes.chunks_exact(self.size).zip(0..);
        let canonical: Vec<u32> = rows.map(|(row, number)| *first.entry(row).or_insert(number)).collect();
        self.of_corner.iter_mut().for_each(|row| *row = canonical[*row as usize]);
    }

    pub fn row(&self, number: u32) -> &[u8] {
        let start = number as usize * self.size;
        &self.bytes[start..start + self.size]
    }

    /// The rows of vertices, one after the other: that of the given number, or as stored where it is [`NONE`].
    pub fn gather(&self, stored: &Stored<'_>, vertices: impl Iterator<Item = (u32, u32)>) -> Table {
        let mut bytes = Vec::new();
        for (row, old_vertex) in vertices {
            if row == NONE {
                stored.push_stored(old_vertex as usize, &mut bytes);
            } else {
                bytes.extend_from_slice(self.row(row));
            }
        }
        Table { bytes, size: self.size }
    }
}

/// One row a vertex.
pub struct Table {
    bytes: Vec<u8>,
    size: usize,
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
        let same = stored.same.as_ref().is_some_and(|bytes| *bytes == self.normals(stored));
        let delta = |(target, delta): (usize, &Option<Vec<[f32; 3]>>)| {
            let new = self.deltas(stored, target);
            match delta {
                Some(old) => bytemuck::cast_slice::<_, u8>(old) == &*new,
                None => new.iter().all(|&byte| byte == 0),
            }
        };
        same && stored.deltas.iter().enumerate().all(delta)
    }

    /// Repairs the normals of vertices that no corner uses, given the row that each vertex comes from.
    pub fn repair_unused(&mut self, stored: &Stored<'_>, vertices: impl Iterator<Item = (u32, u32)>) {
        let rows = self.bytes.chunks_exact_mut(self.size).zip(vertices);
        rows.filter(|(_, (row, _))| *row == NONE).for_each(|(row, _)| stored.repair(row));
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
