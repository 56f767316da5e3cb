//! Whether no slot has so many faces that the rounding of their sum shows.

/// Slots are first counted together with others, in a table that fits a cache.
const TABLE: usize = 1 << 16;

/// How many corners some slots have together: those whose numbers differ by multiples of the table's size.
pub(crate) struct Valences(Box<[u32; TABLE]>);

impl Default for Valences {
    fn default() -> Self {
        Self(vec![0; TABLE].try_into().expect("as many as that"))
    }
}

impl Valences {
    pub(crate) fn count(&mut self, slots: &[u32]) {
        slots.iter().for_each(|&slot| self.0[slot as usize % TABLE] += 1);
    }

    /// Whether no slot has more corners than `most`. These are the slots of all corners that the tables have counted. Sets the
    /// tables to zero.
    pub(crate) fn are_at_most(tables: &mut [Self], most: u32, target: &[u32], slots: usize) -> bool {
        let Some((all, others)) = tables.split_first_mut() else { return true };
        for other in others {
            all.0.iter_mut().zip(&mut *other.0).for_each(|(a, b)| *a += std::mem::take(b));
        }
        let few = all.0.iter().all(|&count| count <= most);
        all.0.fill(0);
        if few {
            return true;
        }
        let mut counts = vec![0_u32; slots];
        target.iter().filter(|&&slot| (slot as usize) < slots).for_each(|&slot| counts[slot as usize] += 1);
        counts.iter().all(|&count| count <= most)
    }
}
