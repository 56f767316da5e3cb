//! A GLB without the accessors, buffer views and bytes that nothing uses. All else stays: data move to the front of the BIN chunk.

use super::group::unreadable;
use super::refs::pinned;
use crate::io::WriteError;
use crate::io::gltf::glb::{Glb, padded, unpadded};
use crate::io::gltf::json::{Json, Value};
use crate::io::gltf::records::{Records, Reference, View};
use crate::io::gltf::splice::Splices;
use std::ops::Range;

/// Compacts a GLB. `None` if an extension may refer to accessors or buffer views, or if the data are not in its BIN chunk.
///
/// # Errors
/// What makes the file unreadable.
pub fn compact(bytes: &[u8]) -> Result<Option<Vec<u8>>, WriteError> {
    let Some((glb, records, bin)) = opened(bytes)? else { return Ok(None) };
    if !pinned(&records.json).is_empty() || records.views.iter().any(|view| view.extended) {
        return Ok(None);
    }
    let mut compaction = Compaction::new(&records, bin);
    if !compaction.move_views() {
        return Ok(None);
    }
    let (json, bin) = compaction.finish();
    Ok(Some(glb.rewrite(bytes, unpadded(&json), Some([&bin, &[], &[]]))?.0))
}

/// A GLB, its records and its BIN chunk.
type Opened<'a> = (Glb, Records, &'a [u8]);

/// Opens a GLB; `None` if its first buffer is not its BIN chunk.
pub fn opened(bytes: &[u8]) -> Result<Option<Opened<'_>>, WriteError> {
    let mut notes = Vec::new();
    let glb = Glb::parse(bytes, &mut notes).map_err(unreadable)?;
    let text = String::from_utf8_lossy(&bytes[glb.json()]).into_owned();
    let records = Records::new(Json::of_edited(text)?, &mut notes).map_err(unreadable)?;
    let first = records.buffers.first();
    let is_bin = first.is_some_and(|&buffer| records.json.member(buffer, "uri").is_none());
    let bin = glb.bin().filter(|_| is_bin);
    Ok(bin.map(|bin| (glb, records, &bytes[bin])))
}

struct Compaction<'a> {
    records: &'a Records,
    old: &'a [u8],
    bin: Vec<u8>,
    splices: Splices<'a>,
    references: Vec<Reference>,
    is_used: Vec<bool>,
    /// Images, and the views that they are in.
    images: Vec<(Value, usize)>,
}

impl<'a> Compaction<'a> {
    fn new(records: &'a Records, old: &'a [u8]) -> Self {
        let references = records.references();
        let mut is_used = vec![false; records.accessors.len()];
        references.iter().for_each(|&(.., accessor)| is_used[accessor] = true);
        let (splices, images) = (Splices::new(&records.json), records.images().collect());
        Self { records, old, bin: Vec::new(), splices, references, is_used, images }
    }

    fn used_accessors(&self) -> impl Iterator<Item = usize> + '_ {
        (0..self.is_used.len()).filter(|&accessor| self.is_used[accessor])
    }

    /// The views that hold anything else than the plain elements of accessors: images, sparse values.
    fn whole_views(&self) -> Vec<bool> {
        let mut is_whole = vec![false; self.records.views.len()];
        self.images.iter().for_each(|&(_, view)| is_whole[view] = true);
        for sparse in self.used_accessors().filter_map(|accessor| self.records.accessors[accessor].sparse) {
            is_whole[sparse.indices.0] = true;
            is_whole[sparse.values.0] = true;
        }
        is_whole
    }

    /// Copies the views that are in use, and removes the others. Returns whether all of them are within the BIN chunk.
    fn move_views(&mut self) -> bool {
        let is_whole = self.whole_views();
        let mut is_kept = is_whole.clone();
        for view in self.used_accessors().filter_map(|accessor| self.records.accessors[accessor].view) {
            is_kept[view] = true;
        }
        let views = &self.records.views;
        let mut kept: Vec<(usize, View)> = (0..views.len())
            .filter(|&view| is_kept[view] && views[view].buffer == 0)
            .map(|view| (view, views[view]))
            .collect();
        kept.sort_by_key(|(number, view)| (view.offset, view.length, *number));
        let end = |view: &View| view.offset.saturating_add(view.length);
        if kept.is_empty() || kept.iter().any(|(_, view)| end(view) > self.old.len() as u64) {
            return false;
        }
        let mut reach = 0;
        let overlap = |before: &(usize, View), next: &(usize, View)| {
            reach = end(&before.1).max(reach);
            next.1.offset < reach
        };
        let clusters: Vec<Vec<(usize, View)>> = kept.chunk_by(overlap).map(<[_]>::to_vec).collect();
        for cluster in clusters {
            match cluster[..] {
                [(number, view)] if !is_whole[number] => self.move_table(number, &view),
                _ => self.move_whole(&cluster),
            }
        }
        self.renumber(&is_kept);
        true
    }

    /// Copies views with all of their bytes, which they share.
    fn move_whole(&mut self, cluster: &[(usize, View)]) {
        let start = cluster[0].1.offset as usize;
        let end = cluster.iter().map(|(_, view)| (view.offset + view.length) as usize).max().unwrap_or(start);
        let home = self.align(start);
        self.bin.extend_from_slice(&self.old[start..end]);
        for (_, view) in cluster {
            self.set(view.object, "byteOffset", view.offset as usize, home + view.offset as usize - start);
        }
    }

    /// Copies the rows and columns of a view that accessors use.
    fn move_table(&mut self, number: usize, view: &View) {
        let accessors = &self.records.accessors;
        let in_view: Vec<usize> =
            self.used_accessors().filter(|&accessor| accessors[accessor].view == Some(number)).collect();
        let used = in_view.iter().map(|&accessor| {
            let record = &accessors[accessor];
            let size = record.format?.size();
            Some(Used { offset: record.offset as usize, size, count: record.count as usize })
        });
        let stride = view.stride.map(|stride| stride as usize);
        let table = used.collect::<Option<Vec<Used>>>();
        let Some(table) = table.and_then(|used| ViewTable::new(stride, view.length as usize, &used)) else {
            return self.move_whole(&[(number, *view)]);
        };
        let (start, end) = (view.offset as usize, (view.offset + view.length) as usize);
        let home = self.align(start);
        table.copy(&self.old[start..end], &mut self.bin);
        self.set(view.object, "byteOffset", start, home);
        self.set(view.object, "byteLength", end - start, self.bin.len() - home);
        if let Some(stride) = stride {
            self.set(view.object, "byteStride", stride, table.stride());
        }
        for accessor in in_view {
            let record = &accessors[accessor];
            self.set(
                record.object,
                "byteOffset",
                record.offset as usize,
                table.offset(record.offset as usize),
            );
        }
    }

    /// Fills up the new bytes so that what was at this offset keeps its remainder of four. Returns their length.
    fn align(&mut self, old: usize) -> usize {
        let length = padded(self.bin.len()) + old % 4;
        self.bin.resize(length, 0);
        length
    }

    /// Gives accessors and views that are in use new numbers, and removes the others.
    fn renumber(&mut self, is_kept: &[bool]) {
        let (accessors, views) = (numbers(&self.is_used), numbers(is_kept));
        let json = &self.records.json;
        for (object, name, old) in std::mem::take(&mut self.references) {
            self.set(object, &name, old, accessors[old]);
        }
        for (image, old) in std::mem::take(&mut self.images) {
            self.set(image, "bufferView", old, views[old]);
        }
        for accessor in self.used_accessors().collect::<Vec<_>>() {
            let record = &self.records.accessors[accessor];
            if let Some(old) = record.view {
                self.set(record.object, "bufferView", old, views[old]);
            }
            let sparse = record.sparse.zip(json.member(record.object, "sparse"));
            let Some((sparse, object)) = sparse else { continue };
            for (name, old) in [("indices", sparse.indices.0), ("values", sparse.values.0)] {
                let site = json.member(object, name);
                site.into_iter().for_each(|site| self.set(site, "bufferView", old, views[old]));
            }
        }
        for (list, kept) in [("accessors", &self.is_used), ("bufferViews", &is_kept.to_vec())] {
            if kept.contains(&false) {
                self.splices.keep(list, kept.clone());
            }
        }
    }

    fn set(&mut self, object: Value, name: &str, old: usize, new: usize) {
        if old != new {
            self.splices.set(object, name, new);
        }
    }

    fn finish(mut self) -> (String, Vec<u8>) {
        let json = &self.records.json;
        let buffer = self.records.buffers[0];
        let length = json.integer_member(buffer, "byteLength");
        self.set(buffer, "byteLength", length.unwrap_or(0) as usize, self.bin.len());
        (self.splices.apply(), self.bin)
    }
}

/// The number of each element among those that are kept.
fn numbers(is_kept: &[bool]) -> Vec<usize> {
    let mut next = 0;
    let number = |&is_kept: &bool| {
        next += usize::from(is_kept);
        next.saturating_sub(1)
    };
    is_kept.iter().map(number).collect()
}

/// The bytes of a row where a view has no stride: accessors begin anywhere at multiples of their components.
const GRANULE: usize = 4;

/// An accessor in a view.
#[derive(Clone, Copy, Debug)]
pub struct Used {
    pub offset: usize,
    pub size: usize,
    pub count: usize,
}

/// The rows and columns of a view that accessors use.
#[derive(Debug, PartialEq)]
pub struct ViewTable {
    row: usize,
    rows: Vec<Range<usize>>,
    columns: Vec<Range<usize>>,
}

impl ViewTable {
    /// `None` where the view is no table: if elements exceed it or its rows, or do not begin at multiples of four bytes.
    pub fn new(stride: Option<usize>, length: usize, used: &[Used]) -> Option<Self> {
        let row = stride.unwrap_or(GRANULE);
        let (mut rows, mut columns) = (Vec::new(), Vec::new());
        for &Used { offset, size, count } in used {
            let step = stride.unwrap_or(size);
            let end = count.checked_sub(1)?.checked_mul(step)?.checked_add(size)?.checked_add(offset)?;
            if end > length {
                return None;
            }
            let (first, column) = (offset / row, offset % row);
            if stride.is_some() {
                let columns_end = column + padded(size);
                let are_multiples = row.is_multiple_of(GRANULE) && column.is_multiple_of(GRANULE);
                if !are_multiples || columns_end > row {
                    return None;
                }
                rows.push(first..first + count);
                columns.push(column..columns_end);
            } else {
                rows.push(first..end.div_ceil(row));
            }
        }
        if stride.is_none() {
            columns.push(0..row);
        }
        Some(Self { row, rows: joined(rows), columns: joined(columns) })
    }

    /// Bytes of a row without columns that nothing uses.
    pub fn stride(&self) -> usize {
        self.columns.iter().map(Range::len).sum()
    }

    /// The new offset of an accessor.
    pub fn offset(&self, old: usize) -> usize {
        position(&self.rows, old / self.row) * self.stride() + position(&self.columns, old % self.row)
    }

    /// Appends the rows and columns that are used.
    pub fn copy(&self, view: &[u8], out: &mut Vec<u8>) {
        for row in self.rows.iter().cloned().flatten() {
            for column in &self.columns {
                let end = out.len() + column.len();
                // The last row may be shorter.
                let start = (row * self.row + column.start).min(view.len());
                out.extend_from_slice(&view[start..(row * self.row + column.end).min(view.len())]);
                out.resize(end, 0);
            }
        }
    }
}

/// Ranges in ascending order, those that meet joined.
fn joined(mut ranges: Vec<Range<usize>>) -> Vec<Range<usize>> {
    ranges.sort_by_key(|range| (range.start, range.end));
    let mut joined: Vec<Range<usize>> = Vec::new();
    for range in ranges {
        match joined.last_mut().filter(|last| range.start <= last.end) {
            Some(last) => last.end = last.end.max(range.end),
            None => joined.push(range),
        }
    }
    joined
}

/// The position of a number among those in ranges.
fn position(ranges: &[Range<usize>], number: usize) -> usize {
    let before = ranges.iter().take_while(|range| range.end <= number);
    let skipped: usize = before.map(Range::len).sum();
    let within = ranges.iter().find(|range| range.contains(&number));
    skipped + within.map_or(0, |range| number - range.start)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The elements of an accessor, byte by byte.
    fn elements(view: &[u8], stride: usize, used: Used) -> Vec<Vec<u8>> {
        (0..used.count).map(|at| view[used.offset + at * stride..][..used.size].to_vec()).collect()
    }

    fn check(stride: Option<usize>, length: usize, used: &[Used], expected: usize) {
        let view: Vec<u8> = (0..length).map(|byte| (byte * 7 % 251) as u8).collect();
        let table = ViewTable::new(stride, length, used).unwrap();
        let mut out = Vec::new();
        table.copy(&view, &mut out);
        assert_eq!(out.len(), expected, "{table:?}");
        for &it in used {
            let moved = Used { offset: table.offset(it.offset), ..it };
            let step = |of: usize| stride.map_or(it.size, |_| of);
            let (old, new) =
                (elements(&view, step(stride.unwrap_or(0)), it), elements(&out, step(table.stride()), moved));
            assert_eq!(old, new, "{it:?} in {table:?}");
        }
    }

    #[test]
    fn elements_stay_whatever_is_removed() {
        let used = |offset, size, count| Used { offset, size, count };
        // Position, normal and texture coordinates in rows of 32 bytes, without the normal; the last row is cut off.
        check(Some(32), 32 * 9 + 32, &[used(0, 12, 10), used(24, 8, 10)], 200);
        // The rows of two primitives, with a gap of rows between them, and three bytes of colour.
        check(Some(16), 16 * 20, &[used(0, 12, 4), used(16 * 10 + 12, 3, 5)], 16 * 9);
        check(Some(16), 16 * 20, &[used(4, 8, 4)], 32);
        // Accessors one after the other, the one in the middle unused; indices of two bytes.
        check(None, 120, &[used(0, 12, 3), used(84, 2, 9)], 36 + 20);
        check(None, 22, &[used(6, 2, 8)], 20);
        check(None, 30, &[used(0, 12, 2), used(12, 12, 1)], 24);
    }

    #[test]
    fn what_is_no_table_is_refused() {
        let refused = |stride, offset, size, count| {
            ViewTable::new(stride, 64, &[Used { offset, size, count }]).is_none()
        };
        assert!(refused(Some(16), 8, 12, 2), "an element exceeds its row");
        assert!(refused(Some(16), 2, 4, 2), "not a multiple of four");
        assert!(refused(Some(18), 0, 12, 2));
        assert!(refused(None, 0, 12, 6) && refused(None, 0, 12, 0) && refused(None, 0, 12, usize::MAX));
        assert!(!refused(None, 4, 12, 5));
    }
}
