//! Values that all corners of a run around a vertex share, computed once where the run is long.

use rustc_hash::FxHashMap;
use std::sync::{Mutex, PoisonError};

/// The longest run that is walked from each of its corners.
pub(crate) const SHORT: usize = 32;

/// The values of long runs by corner, so that the cost of a pole is linear in its corners.
pub(crate) struct PoleCache<T> {
    long: Mutex<FxHashMap<u32, T>>,
}

impl<T> Default for PoleCache<T> {
    fn default() -> Self {
        Self { long: Mutex::default() }
    }
}

impl<T: Copy> PoleCache<T> {
    /// The value for a corner: from a walk of no more than [`SHORT`] corners, or from one over all corners that share the value.
    /// The second has to give the same bits from whichever corner it starts: threads may come in any order.
    pub(crate) fn of(
        &self,
        corner: u32,
        short: impl FnOnce() -> Option<T>,
        whole: impl FnOnce() -> (T, Vec<u32>),
    ) -> T {
        let long = || self.long.lock().unwrap_or_else(PoisonError::into_inner);
        let known = short().or_else(|| long().get(&corner).copied());
        known.unwrap_or_else(|| {
            let (value, corners) = whole();
            long().extend(corners.into_iter().map(|corner| (corner, value)));
            value
        })
    }
}
