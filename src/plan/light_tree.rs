//! Choices of lights in the order of their costs, by branch and bound.
//!
//! Each branch decides the first few lights. No plan of it costs less than the cheapest models under the cheapest replacements of the other
//! lights, so the branches are taken in the order of these costs. A branch ends early if each model of some unit is refused at a witness
//! under all of its choices. In the same way a replacement is removed for good that no choice of the other lights makes possible.

use super::lights::LightChoice;
use super::search::Search;
use super::stage::PlanError;
use std::cmp::Reverse;
use std::collections::BinaryHeap;

/// The branches of a search.
pub struct LightTree {
    /// By least cost, then by changes, then in the order of the replacements.
    open: BinaryHeap<Reverse<(u64, u32, LightChoice)>>,
    /// The replacements of each light that are not removed, from expensive to cheap. The declared light stays.
    possible: Vec<Vec<usize>>,
    /// The witnesses that they are known to pass.
    witnesses: usize,
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

/// Pixels that an open branch counts as in the budget, which so bounds memory too.
const BRANCH: u64 = 4096;

impl LightTree {
    /// All choices of a search, whose plans have `changed` without those of lights.
    ///
    /// # Errors
    /// What makes the changed scene unreadable.
    pub fn new(search: &Search, changed: u32) -> Result<Self, PlanError> {
        let possible: Vec<Vec<usize>> =
            search.trials.lights.iter().map(|models| (0..models.len()).collect()).collect();
        let mut tree = Self { open: BinaryHeap::new(), possible, witnesses: 0 };
        let least = tree.least(search, &Vec::new())?;
        tree.open.push(Reverse((least, changed, Vec::new())));
        Ok(tree)
    }

    /// The next choice whose cost and changes are below `most`.
    ///
    /// # Errors
    /// What makes a picture impossible.
    pub fn next(&mut self, search: &Search, most: (u64, u32)) -> Result<Next, PlanError> {
        while let Some(Reverse((least, changes, choice))) = self.open.pop() {
            if (least, changes) >= most {
                return Ok(Next::Nothing);
            }
            if search.trials.is_spent() {
                return Ok(Next::Spent(least));
            }
            search.note(least, most.0);
            self.remove_impossible(search)?;
            let now = self.least(search, &choice)?;
            if now > least {
                self.open.push(Reverse((now, changes, choice)));
                continue;
            }
            if search.is_refuted(&self.allowed(&choice))? {
                continue;
            }
            let Some(numbers) = self.possible.get(choice.len()) else {
                return Ok(Next::Choice(changes, choice));
            };
            for &number in numbers {
                let longer: LightChoice = choice.iter().copied().chain([number]).collect();
                let least = self.least(search, &longer)?;
                search.trials.count(BRANCH);
                self.open.push(Reverse((least, changes + u32::from(number > 0), longer)));
            }
        }
        Ok(Next::Nothing)
    }

    /// The replacements of each light in a branch.
    fn allowed(&self, choice: &LightChoice) -> Vec<Vec<usize>> {
        let decided = choice.iter().map(|&number| vec![number]);
        decided.chain(self.possible[choice.len()..].iter().cloned()).collect()
    }

    /// No plan of a branch costs less than this.
    fn least(&self, search: &Search, choice: &LightChoice) -> Result<u64, PlanError> {
        let cheapest = self.possible[choice.len()..].iter().filter_map(|numbers| numbers.last().copied());
        search.least(&choice.iter().copied().chain(cheapest).collect())
    }

    /// Removes replacements that are refused with all others, if there are new witnesses.
    fn remove_impossible(&mut self, search: &Search) -> Result<(), PlanError> {
        let count = search.trials.witnesses.count();
        if count == self.witnesses {
            return Ok(());
        }
        self.witnesses = count;
        for light in 0..self.possible.len() {
            // The declared light is possible with all others as declared.
            for number in self.possible[light].clone().into_iter().filter(|&number| number > 0) {
                let mut allowed = self.possible.clone();
                allowed[light] = vec![number];
                if search.is_refuted(&allowed)? {
                    self.possible[light].retain(|&other| other != number);
                }
            }
        }
        Ok(())
    }
}
