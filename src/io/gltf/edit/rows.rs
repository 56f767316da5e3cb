//! The values that vertices can have, each as a row of bytes: a normal with the normal deltas of each morph target, and a tangent
//! with those of each.

use super::member::Member;
use crate::io::gltf::accessor::{Source, float};
use crate::io::gltf::data::{LENGTH_TOLERANCE, normal_format, push_floats, push_normal, push_tangent};
use crate::io::gltf::records::{Component, Format, VertexAccessors};
use crate::io::{NormalFormat, ReadError};
use crate::mesh::{Column, NONE, VertexSplit};
use glam::{DVec3, Vec3};
use rustc_hash::FxHashMap;
use std::borrow::Cow;

/// Rows of equal size: each an element of the base, then the displacements of some morph targets, as floats.
pub struct Rows {
    pub bytes: Vec<u8>,
    pub size: usize,
    /// Bytes of an element of the base.
    base: usize,
}

const DELTA: usize = 12;

impl Rows {
    /// Elements of so many bytes with displacements, which are zeros where a target has none.
    pub fn new(elements: Cow<'_, [u8]>, base: usize, deltas: &[Option<Vec<[f32; 3]>>]) -> Self {
        let size = base + DELTA * deltas.len();
        if deltas.is_empty() {
            return Self { bytes: elements.into_owned(), size, base };
        }
        let mut bytes = Vec::with_capacity(elements.len() / base * size);
        for (vertex, element) in elements.chunks_exact(base).enumerate() {
            bytes.extend_from_slice(element);
            for deltas in deltas {
                let delta = deltas.as_ref().map_or([0.0; 3], |deltas| deltas[vertex]);
                bytes.extend_from_slice(bytemuck::bytes_of(&delta));
            }
        }
        Self { bytes, size, base }
    }

    pub fn get(&self, number: usize) -> &[u8] {
        &self.bytes[number * self.size..(number + 1) * self.size]
    }

    /// Others of the same size.
    pub fn with(&self, bytes: Vec<u8>) -> Self {
        Self { bytes, ..*self }
    }

    /// The elements of the base, which are taken out if there is nothing else.
    pub fn take_base(&mut self) -> Vec<u8> {
        match self.base == self.size {
            true => std::mem::take(&mut self.bytes),
            false => self.column(0, self.base),
        }
    }

    /// The displacements of one of the targets.
    pub fn deltas(&self, target: usize) -> Vec<u8> {
        self.column(self.delta_at(target), DELTA)
    }

    /// Where the displacement of a target begins in a row.
    pub fn delta_at(&self, target: usize) -> usize {
        self.base + DELTA * target
    }

    fn column(&self, start: usize, size: usize) -> Vec<u8> {
        let mut column = Vec::with_capacity(self.bytes.len() / self.size * size);
        let rows = self.bytes.chunks_exact(self.size);
        rows.for_each(|row| column.extend_from_slice(&row[start..start + size]));
        column
    }

    /// The rows of the vertices of a split, of which corners have these numbers: as stored where no corner uses the vertex.
    pub fn gather(&self, of_corner: &[u32], stored: &Self, split: &VertexSplit) -> Self {
        let mut bytes = Vec::with_capacity(split.sample.len() * self.size);
        for (&sample, &source) in split.sample.iter().zip(&split.source) {
            bytes.extend_from_slice(match sample {
                NONE => stored.get(source as usize),
                corner => self.get(of_corner[corner as usize] as usize),
            });
        }
        self.with(bytes)
    }
}

/// What a set of vertices has stored so far, in the form in which it will be stored.
pub struct Stored {
    pub format: Format,
    /// How many morph targets have normal deltas.
    pub targets: usize,
    /// The row of each vertex: +Z where there are no normals, and zeros where a target has none.
    rows: Rows,
    had_normals: bool,
    /// Whether the normals are stored in this format already.
    is_same: bool,
}

impl Stored {
    /// `morph`: whether the morph targets get new normals.
    pub fn new(
        source: &Source<'_>,
        vertices: &VertexAccessors,
        wanted: NormalFormat,
        morph: bool,
    ) -> Result<Self, ReadError> {
        let elements = |set| vertices.of_set(set, "NORMAL").map(|number| source.elements(number)).transpose();
        let base = elements(0)?;
        let format = normal_format(base.map(|base| base.format), wanted);
        let is_same = base.is_some_and(|base| base.format == format);
        let count = source.records.accessors[vertices.position()].count as usize;
        let normals = match base {
            Some(base) if is_same => base.raw(),
            base => {
                let mut bytes = Vec::with_capacity(count * format.size());
                let mut floats = base.map(|base| base.floats(0.0));
                for _ in 0..count {
                    let stored = floats.as_mut().and_then(Iterator::next);
                    let normal = stored.map_or(DVec3::Z, |float| Vec3::from_array(float).as_dvec3());
                    push_normal(normal, format, &mut bytes);
                }
                Cow::Owned(bytes)
            }
        };
        let sets = vertices.target_sets().filter(|_| morph);
        let deltas = sets.map(|set| Ok(elements(set)?.map(|deltas| deltas.floats(0.0).collect())));
        let deltas: Vec<Option<Vec<[f32; 3]>>> = deltas.collect::<Result<_, ReadError>>()?;
        let rows = Rows::new(normals, format.size(), &deltas);
        Ok(Self { format, targets: deltas.len(), rows, had_normals: base.is_some(), is_same })
    }

    pub fn is_stored(&self, rows: &Rows) -> bool {
        self.is_same && self.rows.bytes == rows.bytes
    }

    /// The rows of vertices, in order, if all corners at each have one normal: as stored where no corner uses the vertex. Also returns
    /// the number of the normal of each vertex, or [`NONE`].
    pub fn of_vertices(&self, members: &[Member<'_>]) -> Option<(Rows, Vec<u32>)> {
        let first = members.first()?;
        if members.iter().any(|member| member.part != first.part) {
            return None;
        }
        let normals = first.edit.normals.as_ref()?;
        let mut slots = vec![NONE; first.block.count as usize];
        for member in members {
            for corner in member.corners() {
                let slot = member.slot(normals, corner)?;
                let known = &mut slots[member.vertex(corner) as usize];
                if *known != NONE && *known != slot {
                    return None;
                }
                *known = slot;
            }
        }
        let mut bytes = Vec::with_capacity(self.rows.bytes.len());
        for (vertex, &slot) in slots.iter().enumerate() {
            match slot {
                NONE => bytes.extend_from_slice(self.rows.get(vertex)),
                slot => self.push_given(first, normals, slot, &mut bytes),
            }
        }
        Some((self.rows.with(bytes), slots))
    }

    /// The row of a normal that an edit gives to a vertex. One of the file's own keeps its bits, and its deltas.
    fn push_given(&self, member: &Member<'_>, normals: &Column<DVec3>, slot: u32, out: &mut Vec<u8>) {
        if let Some(element) = member.stored_element(slot) {
            return out.extend_from_slice(self.rows.get(element));
        }
        let start = out.len();
        push_normal(normals.values[slot as usize], self.format, out);
        let written = self.decode(&out[start..]).as_dvec3();
        for moved in &member.edit.morph_normals[..self.targets] {
            push_floats(moved[slot as usize] - written, out);
        }
    }

    /// Repairs the normals of vertices that no corner uses, which `of_vertex` marks by [`NONE`].
    pub fn repair_unused(&self, rows: &mut Rows, of_vertex: &[u32]) {
        let rows = rows.bytes.chunks_exact_mut(rows.size).zip(of_vertex);
        rows.filter(|(_, number)| **number == NONE).for_each(|(row, _)| self.repair(row));
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

    fn decode(&self, row: &[u8]) -> Vec3 {
        let component = self.format.component;
        let number = |axis: usize| float(&row[component.size() * axis..], component, true);
        Vec3::new(number(0), number(1), number(2)).max(Vec3::NEG_ONE)
    }
}

/// The row of each normal, by part. All are [`NONE`] between groups.
pub type Tables = FxHashMap<usize, Vec<u32>>;

/// The rows that the corners of a group of primitives ask for.
pub struct CornerRows<'a> {
    stored: &'a Stored,
    rows: Rows,
    /// The row of each corner, over all members; corners of a vertex with equal rows have the first of them.
    pub of_corner: Vec<u32>,
    /// Corners without a normal of their own, among others that have one.
    pub missing: usize,
}

impl<'a> CornerRows<'a> {
    pub fn new(stored: &'a Stored, members: &[Member<'_>], tables: &mut Tables) -> CornerRows<'a> {
        let corners = members.iter().map(Member::corner_count).sum();
        let vertices = members.first().map_or(0, |member| member.block.count as usize);
        let mut of_corner = Vec::with_capacity(corners);
        let mut bytes = Vec::with_capacity(vertices * stored.rows.size);
        // Whether a vertex has several rows, which may be equal.
        let (mut of_vertex, mut has_several) = (vec![NONE; vertices], false);
        let (mut count, mut missing) = (0, 0);
        for member in members {
            let Some(normals) = &member.edit.normals else { continue };
            let table = tables.entry(member.part).or_insert_with(|| vec![NONE; normals.values.len()]);
            let mut seen = Vec::new();
            for corner in member.corners() {
                let slot = member.slot(normals, corner);
                let known = slot.map(|slot| table[slot as usize]).filter(|&row| row != NONE);
                let row = known.unwrap_or(count);
                of_corner.push(row);
                let first = &mut of_vertex[member.vertex(corner) as usize];
                has_several |= *first != NONE && *first != row;
                *first = row;
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
                        bytes.extend_from_slice(stored.rows.get(member.vertex(corner) as usize));
                        stored.repair(&mut bytes[start..]);
                        missing += 1;
                    }
                }
                count += 1;
            }
            seen.iter().for_each(|&slot| table[slot as usize] = NONE);
        }
        drop(of_vertex);
        if has_several {
            let mut first: FxHashMap<&[u8], u32> = FxHashMap::default();
            let numbered = bytes.chunks_exact(stored.rows.size).zip(0..);
            let first: Vec<u32> = numbered.map(|(row, number)| *first.entry(row).or_insert(number)).collect();
            of_corner.iter_mut().for_each(|row| *row = first[*row as usize]);
        }
        CornerRows { stored, rows: stored.rows.with(bytes), of_corner, missing }
    }

    fn row(&self, corner: usize) -> &[u8] {
        self.rows.get(self.of_corner[corner] as usize)
    }

    /// The normal of a corner, or that of a morph target's shape.
    pub fn normal(&self, corner: usize, target: Option<usize>) -> Vec3 {
        let row = self.row(corner);
        let normal = self.stored.decode(row);
        let Some(target) = target.filter(|&target| target < self.stored.targets) else { return normal };
        let delta = row[self.rows.delta_at(target)..].chunks_exact(4);
        let mut moved = normal.to_array();
        delta.zip(&mut moved).for_each(|(delta, x)| *x += float(delta, Component::F32, false));
        Vec3::from_array(moved).normalize_or(normal)
    }

    /// The normal that a vertex had.
    pub fn stored_normal(&self, vertex: usize) -> Vec3 {
        self.stored.decode(self.stored.rows.get(vertex))
    }

    /// Whether a corner's row is the one that its vertex had.
    pub fn is_as_stored(&self, corner: usize, vertex: usize) -> bool {
        self.stored.had_normals && self.row(corner) == self.stored.rows.get(vertex)
    }

    /// The rows of the vertices of a split: as stored where no corner uses the vertex.
    pub fn gather(&self, split: &VertexSplit) -> Rows {
        self.rows.gather(&self.of_corner, &self.stored.rows, split)
    }
}

/// What happens to the tangents of a group.
pub enum Tangents {
    /// They stay as they are stored, or there are none.
    Stay,
    Go,
    New(NewTangents),
}

/// The tangents of corners, and those of the morph targets that have some, as a row of bytes.
pub struct NewTangents {
    pub format: Format,
    /// The sets of the morph targets with tangents.
    pub sets: Vec<usize>,
    /// The row of each corner.
    pub of_corner: Vec<u32>,
    pub rows: Rows,
    /// The row of each vertex as it was stored, or a unit vector.
    pub stored: Rows,
}

impl NewTangents {
    /// The rows of the vertices of a split: as stored where no corner uses the vertex.
    pub fn gather(&self, split: &VertexSplit) -> Rows {
        self.rows.gather(&self.of_corner, &self.stored, split)
    }

    fn decode(&self, row: &[u8]) -> [f32; 4] {
        let Format { component, normalized, .. } = self.format;
        std::array::from_fn(|axis| float(&row[component.size() * axis..], component, normalized))
    }

    /// The tangent of a vertex in a shape, as it was stored. Shape 0 is the base, others are of the `sets`.
    pub fn stored(&self, vertex: usize, shape: usize) -> [f32; 4] {
        let row = self.stored.get(vertex);
        let mut tangent = self.decode(row);
        if let Some(number) = shape.checked_sub(1) {
            let deltas = row[self.stored.delta_at(number)..].chunks_exact(4);
            deltas.zip(&mut tangent).take(3).for_each(|(delta, x)| *x += float(delta, Component::F32, false));
        }
        tangent
    }

    /// Replaces the tangent of a corner in a shape, that of the base first.
    pub fn set(&mut self, corner: usize, shape: usize, [x, y, z, w]: [f32; 4]) {
        let tangent = Vec3::new(x, y, z).as_dvec3();
        let (start, mut bytes) = (corner * self.rows.size, Vec::new());
        let at = match shape.checked_sub(1) {
            None => {
                push_tangent(tangent, w, self.format, &mut bytes);
                start
            }
            Some(number) => {
                // What readers add the displacement to.
                let base = Vec3::from_slice(&self.decode(&self.rows.bytes[start..]));
                push_floats(tangent - base.as_dvec3(), &mut bytes);
                start + self.rows.delta_at(number)
            }
        };
        self.rows.bytes[at..at + bytes.len()].copy_from_slice(&bytes);
    }
}
