//! A first plan, found step by step: a search that ends early has it, and one that does not is shortened by its cost.

use super::{Found, Search};
use crate::plan::axes::{Axis, ObjectModel};
use crate::plan::stage::PlanError;
use crate::raster::Shading;
use std::collections::HashSet;

/// A cheaper value on one axis of an object, or of a light.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
enum Step {
    /// The unit, the number of its model, and the declared model with the new value.
    Object(usize, usize, ObjectModel),
    /// The light and its replacement.
    Light(usize, usize),
}

impl Search<'_> {
    /// Takes one step after the other from a plan that is within the limits, the one that saves most first, and keeps those whose whole
    /// picture is within the limits. It ends when half of the pixels that are left are drawn.
    ///
    /// # Errors
    /// What makes a picture impossible.
    pub(in crate::plan) fn descend(&self, mut found: Found) -> Result<Found, PlanError> {
        let start = self.trials.drawn();
        let limit = start + self.trials.limits.end.saturating_sub(start) / 2;
        let mut refused = HashSet::new();
        let units = found.models.len();
        let mut steps: Vec<Vec<(u64, Step)>> =
            (0..units).map(|unit| self.object_steps(unit, &found)).collect::<Result<_, _>>()?;
        steps.push(self.light_steps(&found)?);
        while self.trials.drawn() < limit && !self.trials.is_spent() {
            let mut next: Option<(u64, Step)> = None;
            for &(saved, step) in steps.iter().flatten() {
                if next.is_none_or(|(most, _)| saved > most) && !refused.contains(&key(step)) {
                    next = Some((saved, step));
                }
            }
            let Some((_, step)) = next else { break };
            let Some(better) = self.take(&found, step)? else {
                refused.insert(key(step));
                continue;
            };
            found = better;
            self.note(0, found.cost.of(self.minimise));
            match step {
                Step::Object(unit, ..) => steps[unit] = self.object_steps(unit, &found)?,
                Step::Light(..) => {
                    for (unit, steps) in steps.iter_mut().take(units).enumerate() {
                        *steps = self.object_steps(unit, &found)?;
                    }
                }
            }
            steps[units] = self.light_steps(&found)?;
        }
        Ok(found)
    }

    /// The plan after a step, if it is within the limits.
    fn take(&self, found: &Found, step: Step) -> Result<Option<Found>, PlanError> {
        let (mut models, mut lights) = (found.models.clone(), found.lights.clone());
        match step {
            Step::Object(unit, number, _) => {
                models[unit] = self.models[unit][number];
                if !self.trials.is_within((unit, number), &models[unit], &lights)? {
                    return Ok(None);
                }
            }
            Step::Light(light, number) => lights[light] = number,
        }
        self.verified(models, lights)
    }

    /// A plan with its largest difference, if it is within the limits.
    ///
    /// # Errors
    /// What makes a picture impossible.
    pub(in crate::plan) fn verified(
        &self,
        models: Vec<ObjectModel>,
        lights: Vec<usize>,
    ) -> Result<Option<Found>, PlanError> {
        let Some((worst, outline)) = self.trials.check(&models, &lights)? else { return Ok(None) };
        let units = self.trials.stage.units.iter();
        let of_objects = models.iter().zip(units).map(|(model, unit)| model.differs(&unit.reference).len());
        let of_lights = lights.iter().filter(|&&number| number > 0).count();
        let changes = (of_objects.sum::<usize>() + of_lights) as u32 + u32::from(self.has_fewer_samples());
        let cost = self.cost(&models, &lights)?;
        Ok(Some(Found { models, lights, cost, worst, outline, changes }))
    }

    /// The cheaper values on each axis of a unit, with what they save.
    fn object_steps(&self, unit: usize, found: &Found) -> Result<Vec<(u64, Step)>, PlanError> {
        let lights = self.trials.lights_of(&self.trials.views[0], &found.lights);
        let model = &found.models[unit];
        let reference = &self.trials.stage.units[unit].reference;
        let cost = self.unit_cost(unit, model, &lights)?.of(self.minimise);
        let mut steps = Vec::new();
        for (number, other) in self.models[unit].iter().enumerate() {
            let axes = other.differs(model);
            // Flat shading interpolates nothing.
            let becomes_flat = other.shading == Shading::Flat && axes == [Axis::Shading, Axis::Interpolation];
            if axes.len() != 1 && !becomes_flat {
                continue;
            }
            let saved = cost.saturating_sub(self.unit_cost(unit, other, &lights)?.of(self.minimise));
            if saved > 0 {
                steps.push((saved, Step::Object(unit, number, reference.with(axes[0], other))));
            }
        }
        Ok(steps)
    }

    /// The cheaper replacements of each light, with what they save.
    fn light_steps(&self, found: &Found) -> Result<Vec<(u64, Step)>, PlanError> {
        let cost = found.cost.of(self.minimise);
        let mut steps = Vec::new();
        for (light, models) in self.trials.lights.iter().enumerate() {
            for number in 0..models.len() {
                let mut lights = found.lights.clone();
                lights[light] = number;
                let saved = cost.saturating_sub(self.cost(&found.models, &lights)?.of(self.minimise));
                if saved > 0 {
                    steps.push((saved, Step::Light(light, number)));
                }
            }
        }
        Ok(steps)
    }
}

/// What is not tried again once it is refused: a value, whatever the other axes have become.
fn key(step: Step) -> Step {
    match step {
        Step::Object(unit, _, value) => Step::Object(unit, 0, value),
        light @ Step::Light(..) => light,
    }
}
