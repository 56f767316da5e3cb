//! What is true of all corners that follow one another round a vertex, worked out once where they are many.

use rustc_hash::FxHashMap;
use std::sync::{Mutex, PoisonError};

/// The most corners on the way from one that are walked anew from each.
pub(in crate::quality) const SHORT: usize = 32;

/// Answers that hold for each corner of a long way round a vertex, so that a pole costs no more than its corners, however many
/// those are.
pub(in crate::quality) struct VertexFans<T> {
    long: Mutex<FxHashMap<u32, T>>,
}

impl<T> Default for VertexFans<T> {
    fn default() -> Self {
        Self { long: Mutex::default() }
    }
}

impl<T: Copy> VertexFans<T> {
    /// The answer for a corner: from a walk no longer than [`SHORT`], or from one over all corners that share the answer. The
    /// latter has to be the same from whichever of them it starts, to the bit: threads may come in any order.
    pub(in crate::quality) fn of(
        &self,
        corner: u32,
        short: impl FnOnce() -> Option<T>,
        whole: impl FnOnce() -> (T, Vec<u32>),
    ) -> T {
        let long = || self.long.lock().unwrap_or_else(PoisonError::into_inner);
        let known = short().or_else(|| long().get(&corner).copied());
        known.unwrap_or_else(|| {
            let (answer, corners) = whole();
            long().extend(corners.into_iter().map(|corner| (corner, answer)));
            answer
        })
    }
}
