//! A buffer view as a table: its rows are a stride long, and accessors use some of its rows and columns.

use crate::io::gltf::glb::padded;
use std::ops::Range;

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
