//! The cheapest plan: an exact search over all combinations of models.
//!
//! Light is local: what an object shows at a pixel depends on its own model and on the lights alone. So for each combination of lights the
//! cheapest model of each object that stays within the tolerance can be found by itself, on the pixels that show only this object; no
//! combination with a model that fails there can succeed. The picture of the whole plan is always drawn. Where it fails, because
//! of pixels that several objects share, the next combinations follow in the order of their costs.

// A first plan, found step by step.
mod descent;
// Choices of lights in the order of their costs.
mod light_branches;
mod light_tree;
// Pictures of models, compared with the reference.
pub mod trials;
// The light of each lamp at pixels at which models were refused.
mod colours_at_witnesses;
mod visibility;
mod witnesses;

use super::axes::{Cells, Normals, ObjectModel};
use super::compare::Difference;
use super::cost::{Cost, Minimise, Sizes, light_class, object_cost};
use super::lights::LightChoice;
use super::models::cells_of;
use super::options::End;
use super::stage::PlanError;
use crate::raster::Projection;
use crate::shade::Light;
use light_tree::Next;
use std::cell::{Cell, RefCell};
use std::cmp::Reverse;
use std::collections::{BinaryHeap, HashMap, HashSet};
use trials::Trials;

/// A plan within the limits.
#[derive(Clone, Debug, PartialEq)]
pub struct Found {
    /// The model of each unit.
    pub models: Vec<ObjectModel>,
    /// Which replacement each light has.
    pub lights: LightChoice,
    /// Its cost.
    pub cost: Cost,
    /// The largest difference, and the number of the view.
    pub worst: (Difference, usize),
    /// The largest distance of outlines, in pixels.
    pub outline: f64,
    /// The number of changes.
    pub changes: u32,
}

/// What a search has found.
#[derive(Clone, Debug, PartialEq)]
pub struct Outcome {
    /// Why it ended.
    pub end: End,
    /// The cheapest plan; `None` if none is cheaper than the best one before.
    pub found: Option<Found>,
    /// No plan costs less than this; the cost of the best plan if it is proven cheapest.
    pub proven: u64,
    /// Pixels drawn.
    pub drawn: u64,
    /// Combinations of models in all; the largest finite number if there are more.
    pub combinations: f64,
    /// Models that were drawn and refused.
    pub refused: u64,
}

/// A search over the models of objects and lights.
pub struct Search<'a> {
    /// Pictures of models.
    pub trials: Trials<'a>,
    /// The models that each unit may have.
    pub models: &'a [Vec<ObjectModel>],
    /// What it makes small.
    pub minimise: Minimise,
    /// The sizes of each unit, by what of a model they depend on.
    sizes: RefCell<HashMap<Shape, Sizes>>,
    /// The least cost under lights of these classes.
    least: RefCell<HashMap<Vec<(u64, bool)>, u64>>,
    /// The model of each unit that passed all witnesses last.
    survivors: RefCell<Vec<usize>>,
    /// The declared cost.
    declared: Cell<u64>,
}

/// What the sizes of a model depend on: the unit, its cells, whether its normals are split, and for merged vertices all normals before they are
/// stored.
type Shape = (usize, Cells, bool, Option<Option<Normals>>);

/// A model of a unit with its cost and the number of changes.
type Ranked = (u64, u32, usize, Cost);

impl<'a> Search<'a> {
    /// A search over everything that is listed.
    pub fn new(mut trials: Trials<'a>, models: &'a [Vec<ObjectModel>], minimise: Minimise) -> Self {
        trials.cells = cells_of(models);
        let survivors = RefCell::new(vec![0; models.len()]);
        let (sizes, least, declared) = Default::default();
        Self { trials, models, minimise, sizes, least, survivors, declared }
    }

    /// Searches for a plan that is cheaper than the `best` one so far. Without one, that is the reference itself.
    ///
    /// # Errors
    /// What makes a picture impossible.
    pub fn run(&self, best: Option<&Found>) -> Result<Outcome, PlanError> {
        self.declared.set(self.reference()?.cost.of(self.minimise));
        let key = |found: &Found| (found.cost.of(self.minimise), found.changes);
        let start = match best {
            None => Some(self.reference()?),
            Some(best) => self.verified(best.models.clone(), best.lights.clone())?,
        };
        let mut found = start.map(|start| self.descend(start)).transpose()?;
        // Of plans with the same cost and as many changes the search decides, so that they do not depend on the descent.
        let mut most = found.as_ref().map_or((u64::MAX, u32::MAX), |found| (key(found).0, key(found).1 + 1));
        if let Some(best) = best {
            most = most.min(key(best));
            found = found.filter(|found| key(found) < key(best));
        }
        let mut tree = self.light_tree(self.has_fewer_samples().into())?;
        let mut open = u64::MAX;
        loop {
            let (changes, choice) = match self.next_choice(&mut tree, most)? {
                Next::Choice(changes, choice) => (changes, choice),
                Next::Nothing => break,
                Next::Spent(least) => {
                    open = least;
                    break;
                }
            };
            match self.cheapest(&choice, &self.ranked(&choice)?, changes, most)? {
                Step::Found(better) => {
                    most = key(&better);
                    found = Some(*better);
                }
                Step::Nothing => {}
                Step::Spent(least) => {
                    open = least;
                    break;
                }
            }
        }
        let numbers = self.models.iter().map(Vec::len).chain(self.trials.lights.iter().map(Vec::len));
        let combinations = numbers.map(|count| count as f64).product::<f64>().min(f64::MAX);
        let (drawn, refused) = (self.trials.drawn(), self.trials.refused());
        let end = if open == u64::MAX { End::Proven } else { self.trials.spent().unwrap_or(End::Proven) };
        Ok(Outcome { end, proven: open.min(most.0), found, drawn, combinations, refused })
    }

    /// Notes the costs that are proven and found, for the progress.
    pub(in crate::plan) fn note(&self, proven: u64, best: u64) {
        self.trials.note(proven, best, self.declared.get());
    }

    /// Whether each model of some unit is refused at a pixel, with all choices of the `allowed` replacements of lights.
    ///
    /// # Errors
    /// What makes a picture impossible.
    pub fn is_refuted(&self, allowed: &[Vec<usize>]) -> Result<bool, PlanError> {
        if !self.trials.adds_lights() {
            return Ok(false);
        }
        for (unit, models) in self.models.iter().enumerate() {
            // The last one that was not refused comes first, since a small change of lights refuses few others.
            let last = self.survivors.borrow()[unit];
            let others = (0..models.len()).filter(|&number| number != last);
            let mut survivor = None;
            for number in std::iter::once(last).chain(others) {
                if self.trials.is_spent() {
                    return Ok(false);
                }
                if self.trials.least_error((unit, number), &models[number], allowed)? == 0.0 {
                    survivor = Some(number);
                    break;
                }
            }
            let Some(survivor) = survivor else { return Ok(true) };
            self.survivors.borrow_mut()[unit] = survivor;
        }
        Ok(false)
    }

    /// Whether pictures have fewer samples than those of the reference.
    pub(in crate::plan) fn has_fewer_samples(&self) -> bool {
        self.trials.stage.settings.samples != self.trials.views[0].truth.samples()
    }

    fn reference(&self) -> Result<Found, PlanError> {
        let models: Vec<ObjectModel> = self.trials.stage.units.iter().map(|unit| unit.reference).collect();
        let lights = vec![0; self.trials.lights.len()];
        let cost = self.cost(&models, &lights)?;
        Ok(Found { models, lights, cost, worst: Default::default(), outline: 0.0, changes: 0 })
    }

    /// The cost of models under a choice of lights.
    ///
    /// # Errors
    /// What makes the changed scene unreadable.
    pub fn cost(&self, models: &[ObjectModel], choice: &LightChoice) -> Result<Cost, PlanError> {
        let lights = self.trials.lights_of(&self.trials.views[0], choice);
        models.iter().enumerate().map(|(unit, model)| self.unit_cost(unit, model, &lights)).sum()
    }

    pub(in crate::plan) fn unit_cost(
        &self,
        unit: usize,
        model: &ObjectModel,
        lights: &[Light],
    ) -> Result<Cost, PlanError> {
        let Trials { stage, views, .. } = self.trials;
        let declared = stage.units[unit].reference.normals.and_then(|normals| normals.format);
        let unstored = model.with_format(declared);
        let is_split = model.normals.is_none_or(|normals| normals.creases);
        let key = (unit, model.segments, is_split, model.merged.then_some(unstored.normals));
        let known = self.sizes.borrow().get(&key).copied();
        let sizes = match known {
            Some(known) => known,
            None => {
                let samples = views.iter().map(|view| view.pixels[unit]).sum::<u64>()
                    * stage.settings.samples.count() as u64;
                let sizes = stage.sizes(unit, &unstored, samples, views.len() as u64)?;
                *self.sizes.borrow_mut().entry(key).or_insert(sizes)
            }
        };
        Ok(object_cost(&sizes, model, stage.units[unit].highlight, lights, self.far()))
    }

    fn far(&self) -> bool {
        self.trials.stage.settings.infinite_viewer
            || matches!(self.trials.views[0].camera.projection, Projection::Orthographic(_))
    }

    /// No plan with these lights costs less than this.
    ///
    /// # Errors
    /// What makes the changed scene unreadable.
    pub fn least(&self, choice: &LightChoice) -> Result<u64, PlanError> {
        let lights = self.trials.lights_of(&self.trials.views[0], choice);
        let mut classes: Vec<(u64, bool)> = lights.iter().map(light_class).collect();
        classes.sort_unstable();
        if let Some(&known) = self.least.borrow().get(&classes) {
            return Ok(known);
        }
        let mut sum = 0;
        for (unit, models) in self.models.iter().enumerate() {
            let mut least = u64::MAX;
            for model in models {
                least = least.min(self.unit_cost(unit, model, &lights)?.of(self.minimise));
            }
            sum += least;
        }
        self.least.borrow_mut().insert(classes, sum);
        Ok(sum)
    }

    /// The models of each unit by ascending cost under lights, then by fewer changes, then in the order of the axes.
    fn ranked(&self, choice: &LightChoice) -> Result<Vec<Vec<Ranked>>, PlanError> {
        let lights = self.trials.lights_of(&self.trials.views[0], choice);
        let of_unit = |(unit, models): (usize, &Vec<ObjectModel>)| {
            let reference = &self.trials.stage.units[unit].reference;
            let rank = |(number, model): (usize, &ObjectModel)| {
                let cost = self.unit_cost(unit, model, &lights)?;
                Ok((cost.of(self.minimise), model.differs(reference).len() as u32, number, cost))
            };
            let mut list = models.iter().enumerate().map(rank).collect::<Result<Vec<Ranked>, PlanError>>()?;
            list.sort_by_key(|&(cost, changes, number, _)| (cost, changes, number));
            Ok(list)
        };
        self.models.iter().enumerate().map(of_unit).collect()
    }

    /// The cheapest plan under a choice of lights that costs less than `most`, or the same with fewer changes.
    fn cheapest(
        &self,
        choice: &LightChoice,
        lists: &[Vec<Ranked>],
        changed: u32,
        most: (u64, u32),
    ) -> Result<Step, PlanError> {
        // The positions in the lists of models that keep to the limits by themselves, found as they are needed.
        let mut good: Vec<Vec<usize>> = vec![Vec::new(); lists.len()];
        let mut next = vec![0; lists.len()];
        let mut extend = |unit: usize, count: usize, good: &mut Vec<Vec<usize>>| -> Result<bool, PlanError> {
            while good[unit].len() < count && next[unit] < lists[unit].len() {
                let at = next[unit];
                next[unit] += 1;
                let number = lists[unit][at].2;
                let is_reference =
                    number == 0 && choice.iter().all(|&light| light == 0) && !self.has_fewer_samples();
                if is_reference
                    || self.trials.is_within((unit, number), &self.models[unit][number], choice)?
                {
                    good[unit].push(at);
                }
                if self.trials.is_spent() {
                    break;
                }
            }
            Ok(good[unit].len() >= count)
        };
        let least = |units: std::ops::Range<usize>| units.map(|unit| lists[unit][0].0).sum::<u64>();
        let mut so_far = 0;
        for unit in 0..lists.len() {
            let is_found = extend(unit, 1, &mut good)?;
            if self.trials.is_spent() {
                return Ok(Step::Spent(least(0..lists.len())));
            }
            if !is_found {
                return Ok(Step::Nothing);
            }
            so_far += lists[unit][good[unit][0]].0;
            if so_far + least(unit + 1..lists.len()) > most.0 {
                return Ok(Step::Nothing);
            }
        }
        let key = |ranks: &Vec<usize>, good: &Vec<Vec<usize>>| {
            let entries = ranks.iter().enumerate().map(|(unit, &rank)| lists[unit][good[unit][rank]]);
            entries.fold((0, changed), |(cost, changes), entry| (cost + entry.0, changes + entry.1))
        };
        let first = vec![0; lists.len()];
        let mut queue = BinaryHeap::from([Reverse((key(&first, &good), first.clone()))]);
        let mut seen = HashSet::from([first]);
        while let Some(Reverse((rank, ranks))) = queue.pop() {
            if rank >= most {
                return Ok(Step::Nothing);
            }
            let entries: Vec<&Ranked> =
                ranks.iter().enumerate().map(|(unit, &rank)| &lists[unit][good[unit][rank]]).collect();
            let models: Vec<ObjectModel> =
                entries.iter().enumerate().map(|(unit, entry)| self.models[unit][entry.2]).collect();
            if let Some((worst, outline)) = self.trials.check(&models, choice)? {
                let cost = entries.iter().map(|entry| entry.3).sum();
                let found = Found { models, lights: choice.clone(), cost, worst, outline, changes: rank.1 };
                return Ok(Step::Found(Box::new(found)));
            }
            if self.trials.is_spent() {
                return Ok(Step::Spent(rank.0));
            }
            for unit in 0..ranks.len() {
                let mut after = ranks.clone();
                after[unit] += 1;
                if extend(unit, after[unit] + 1, &mut good)? && seen.insert(after.clone()) {
                    queue.push(Reverse((key(&after, &good), after)));
                }
                // A successor may be missing, which costs no less than this one.
                if self.trials.is_spent() {
                    return Ok(Step::Spent(rank.0));
                }
            }
        }
        Ok(Step::Nothing)
    }
}

enum Step {
    Found(Box<Found>),
    Nothing,
    /// The budget is used up; no plan under these lights costs less than this.
    Spent(u64),
}
