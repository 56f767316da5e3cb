//! Indices as a piece of the file has them, before the items of earlier pieces are counted.

use crate::mesh::NONE;
use std::ops::Range;

/// In a list of indices: a reference to something that cannot exist. No count of a mesh reaches it.
pub(super) const NOWHERE: u32 = NONE - 1;

/// Zero-based indices. Negative indices of the file are kept relative to the start of the piece, as two's complement, and the
/// ranges of such entries are listed.
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

    /// Fills up with absent entries.
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
