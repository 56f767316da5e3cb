//! Choices of lights in the order of their costs, by branch and bound.
//!
//! Each branch decides the first few lights. No plan of it costs less than the cheapest models under the cheapest replacements of the other
//! lights, so the branches are taken in the order of these costs. A branch ends early if each model of some unit is refused at a witness
//! under all of its choices. In the same way a replacement is removed for good that no choice of the other lights makes possible.

use super::Search;
use super::light_tree::{LightTree, Next};
use crate::plan::lights::LightChoice;
use crate::plan::stage::PlanError;
use std::cmp::Reverse;
use std::collections::BinaryHeap;

/// Pixels that an open branch counts as in the budget, which so bounds memory too.
const BRANCH: u64 = 4096;

impl Search<'_> {
    /// All choices of a search, whose plans have `changed` without those of lights.
    ///
    /// # Errors
    /// What makes the changed scene unreadable.
    pub(super) fn light_tree(&self, changed: u32) -> Result<LightTree, PlanError> {
        let possible: Vec<Vec<usize>> =
            self.trials.lights.iter().map(|models| (0..models.len()).collect()).collect();
        let mut tree = LightTree { open: BinaryHeap::new(), possible, witnesses: 0 };
        let least = self.least_of_branch(&tree, &Vec::new())?;
        tree.open.push(Reverse((least, changed, Vec::new())));
        Ok(tree)
    }

    /// The next choice whose cost and changes are below `most`.
    ///
    /// # Errors
    /// What makes a picture impossible.
    pub(super) fn next_choice(&self, tree: &mut LightTree, most: (u64, u32)) -> Result<Next, PlanError> {
        while let Some(Reverse((least, changes, choice))) = tree.open.pop() {
            if (least, changes) >= most {
                return Ok(Next::Nothing);
            }
            if self.trials.is_spent() {
                return Ok(Next::Spent(least));
            }
            self.note(least, most.0);
            self.remove_impossible(tree)?;
            let now = self.least_of_branch(tree, &choice)?;
            if now > least {
                tree.open.push(Reverse((now, changes, choice)));
                continue;
            }
            if self.is_refuted(&tree.allowed(&choice))? {
                continue;
            }
            let Some(numbers) = tree.possible.get(choice.len()) else {
                return Ok(Next::Choice(changes, choice));
            };
            for &number in numbers {
                let longer: LightChoice = choice.iter().copied().chain([number]).collect();
                let least = self.least_of_branch(tree, &longer)?;
                self.trials.count(BRANCH);
                tree.open.push(Reverse((least, changes + u32::from(number > 0), longer)));
            }
        }
        Ok(Next::Nothing)
    }

    /// No plan of a branch costs less than this.
    fn least_of_branch(&self, tree: &LightTree, choice: &LightChoice) -> Result<u64, PlanError> {
        let cheapest = tree.possible[choice.len()..].iter().filter_map(|numbers| numbers.last().copied());
        self.least(&choice.iter().copied().chain(cheapest).collect())
    }

    /// Removes replacements that are refused with all others, if there are new witnesses.
    fn remove_impossible(&self, tree: &mut LightTree) -> Result<(), PlanError> {
        let count = self.trials.witnesses.count();
        if count == tree.witnesses {
            return Ok(());
        }
        tree.witnesses = count;
        for light in 0..tree.possible.len() {
            // The declared light is possible with all others as declared.
            for number in tree.possible[light].clone().into_iter().filter(|&number| number > 0) {
                let mut allowed = tree.possible.clone();
                allowed[light] = vec![number];
                if self.is_refuted(&allowed)? {
                    tree.possible[light].retain(|&other| other != number);
                }
            }
        }
        Ok(())
    }
}
