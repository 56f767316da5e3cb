//! The numbers of normals in an OBJ that is edited or new.

use crate::io::PartEdit;
use crate::io::text::push_row;
use crate::mesh::{Column, Mesh, Storage};
use glam::DVec3;
use rustc_hash::FxHashMap;
use std::ops::Range;

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
        let mut dropped = edit.faces.dropped.iter().peekable();
        for (face, range) in self.mesh.faces().ranges().enumerate() {
            if dropped.next_if(|&&next| next as usize == face).is_none() {
                for slot in range.filter_map(|corner| self.slot(corner)) {
                    is_used[slot] = true;
                }
            }
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

    pub fn new_lines(&self) -> u64 {
        self.new.len() as u64
    }

    pub fn push_lines(&self, line_end: &[u8], out: &mut Vec<u8>) {
        for &slot in &self.new {
            push_row(out, "vn", self.storage, &self.normals.values[slot as usize].to_array());
            out.extend_from_slice(line_end);
        }
    }
}
