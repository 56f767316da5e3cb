//! The open branches of choices of lights.

use crate::plan::lights::LightChoice;
use std::cmp::Reverse;
use std::collections::BinaryHeap;

/// The branches of a search.
pub struct LightTree {
    /// By least cost, then by changes, then in the order of the replacements.
    pub open: BinaryHeap<Reverse<(u64, u32, LightChoice)>>,
    /// The replacements of each light that are not removed, from expensive to cheap. The declared light stays.
    pub possible: Vec<Vec<usize>>,
    /// The witnesses that they are known to pass.
    pub witnesses: usize,
}

/// The next choice of lights.
pub enum Next {
    /// With the changes that it makes.
    Choice(u32, LightChoice),
    /// There is none that could be better.
    Nothing,
    /// The budget is used up; no choice that is left costs less than this.
    Spent(u64),
}

impl LightTree {
    /// The replacements of each light in a branch.
    pub fn allowed(&self, choice: &LightChoice) -> Vec<Vec<usize>> {
        let decided = choice.iter().map(|&number| vec![number]);
        decided.chain(self.possible[choice.len()..].iter().cloned()).collect()
    }
}
