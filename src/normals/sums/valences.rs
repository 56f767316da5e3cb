//! Whether no slot has so many faces that the rounding of their sum shows.

/// Slots are first counted together with others, in a table that fits a cache.
const TABLE: usize = 1 << 16;

/// How many corners some slots have together: those whose numbers differ by multiples of the table's size.
pub(crate) struct Valences(Box<[u32; TABLE]>);

impl Valences {
    pub(crate) fn new() -> Self {
        Self(vec![0; TABLE].try_into().expect("as many as that"))
    }

    pub(crate) fn count(&mut self, slots: &[u32]) {
        slots.iter().for_each(|&slot| self.0[slot as usize % TABLE] += 1);
    }

    /// Adds what others have counted.
    pub(crate) fn join(&mut self, other: &Self) {
        self.0.iter_mut().zip(&*other.0).for_each(|(a, b)| *a += b);
    }

    /// Whether no slot has more corners than `most`. These are the slots of all corners that were counted.
    pub(crate) fn are_at_most(&self, most: u32, target: &[u32], slots: usize) -> bool {
        if self.0.iter().all(|&count| count <= most) {
            return true;
        }
        let mut counts = vec![0_u32; slots];
        target.iter().filter(|&&slot| (slot as usize) < slots).for_each(|&slot| counts[slot as usize] += 1);
        counts.iter().all(|&count| count <= most)
    }
}
