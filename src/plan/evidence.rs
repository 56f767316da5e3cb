//! Evidence for a plan: its pictures, those of the cheaper steps that are refused, and everything that was tried.

use super::axes::{Axis, ObjectModel};
use super::compare::Difference;
use super::decisions::{Described, Plan};
use super::search::{Found, Search};
use super::stage::PlanError;
use super::views::View;
use crate::raster::{Image, Pixels};
use std::ops::Range;

/// The reference next to another picture of the same view.
#[derive(Clone, Debug)]
pub struct Comparison {
    /// The view.
    pub view: usize,
    /// The picture of the reference.
    pub reference: Image,
    /// The other picture.
    pub other: Image,
    /// Their difference in each channel, amplified.
    pub difference: Image,
    /// The factor.
    pub amplification: f64,
    /// The largest difference.
    pub worst: Difference,
    /// The largest distance of outlines, in pixels.
    pub outline: f64,
    /// The pixel to look at: that of the largest difference, or one between two outlines if only these are too far from each other.
    pub pixel: [u32; 2],
}

/// A cheaper step from the plan that is beyond the limits.
#[derive(Clone, Debug)]
pub struct Refusal {
    /// The object or light, by name.
    pub what: String,
    /// What would be changed.
    pub axis: Axis,
    /// As planned.
    pub from: String,
    /// The cheaper value.
    pub to: String,
    /// What it would save of the cost that is minimised.
    pub saved: u64,
    /// The whole plan with this step.
    pub comparison: Comparison,
}

/// Something that was drawn and compared: a model of an object with the rest as planned, or a whole plan.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Tried {
    /// The cost that is minimised.
    pub cost: u64,
    /// The largest difference that was found; for a refused model there may be larger ones.
    pub error: f64,
    /// Whether it is within the limits.
    pub is_within: bool,
}

/// What a page shows of a plan.
#[derive(Clone, Debug)]
pub struct Evidence {
    /// The plan in the view of its largest difference.
    pub planned: Comparison,
    /// The next cheaper value of each axis.
    pub refused: Vec<Refusal>,
    /// All that was tried.
    pub tried: Vec<Tried>,
}

/// Most refusals with pictures.
const MOST_REFUSALS: usize = 24;

impl Described<'_> {
    /// The evidence for a plan.
    ///
    /// # Errors
    /// What makes a picture impossible.
    pub fn evidence(&self, search: &Search, found: &Found, plan: &Plan) -> Result<Evidence, PlanError> {
        let planned = compare(search, &found.models, &found.lights, Some(plan.worst_view))?;
        Ok(Evidence { planned, refused: self.refused(search, found)?, tried: tried(search, found)? })
    }

    /// The next cheaper value of each axis of each object and light, where it is beyond the limits.
    fn refused(&self, search: &Search, found: &Found) -> Result<Vec<Refusal>, PlanError> {
        let cost = |models: &[ObjectModel], lights: &Vec<usize>| -> Result<u64, PlanError> {
            Ok(search.cost(models, lights)?.of(search.minimise))
        };
        let planned = cost(&found.models, &found.lights)?;
        // The most expensive of those that are cheaper than the plan.
        let cheaper = |candidates: &mut dyn Iterator<Item = (Vec<ObjectModel>, Vec<usize>)>| {
            let mut next: Option<(u64, Vec<ObjectModel>, Vec<usize>)> = None;
            for (models, lights) in candidates {
                let cost = cost(&models, &lights)?;
                if cost < planned && next.as_ref().is_none_or(|(most, ..)| cost > *most) {
                    next = Some((cost, models, lights));
                }
            }
            Ok::<_, PlanError>(next)
        };
        let mut steps = Vec::new();
        for (unit, model) in found.models.iter().enumerate() {
            for axis in Axis::ALL {
                let others = search.models[unit].iter().filter(|other| other.differs(model) == [axis]);
                let candidate = |other: &ObjectModel| {
                    let mut models = found.models.clone();
                    models[unit] = *other;
                    (models, found.lights.clone())
                };
                if let Some((cost, models, lights)) = cheaper(&mut others.map(candidate))? {
                    let (from, to) = (model.value(axis), models[unit].value(axis));
                    steps.push((unit, axis, from, to, planned - cost, models, lights));
                }
            }
        }
        for (light, &number) in found.lights.iter().enumerate() {
            let models = &search.trials.lights[light];
            let candidate = |other: usize| {
                let mut lights = found.lights.clone();
                lights[light] = other;
                (found.models.clone(), lights)
            };
            if let Some((cost, of_objects, lights)) = cheaper(&mut (0..models.len()).map(candidate))? {
                let (from, to) = (models[number].to_string(), models[lights[light]].to_string());
                steps.push((light, Axis::Lights, from, to, planned - cost, of_objects, lights));
            }
        }
        let mut refused = Vec::new();
        for (number, axis, from, to, saved, models, lights) in steps.into_iter().take(MOST_REFUSALS) {
            let mut comparison = compare(search, &models, &lights, None)?;
            let view = &search.trials.views[comparison.view];
            // With a spent budget a cheaper step may be within the limits.
            let limits = &search.trials.limits;
            if !limits.accept(view, &comparison.worst, comparison.outline) {
                let is_outline = axis != Axis::Lights && limits.accept(view, &comparison.worst, 0.0);
                if is_outline {
                    comparison.show_outline(view, self.stage.objects_of(number));
                }
                let what = match axis {
                    Axis::Lights => format!("light {number}"),
                    _ => self.stage.units[number].name.clone(),
                };
                refused.push(Refusal { what, axis, from, to, saved, comparison });
            }
        }
        Ok(refused)
    }
}

impl Comparison {
    /// Looks at a pixel that shows one of the objects in the reference only, where the pictures differ most.
    fn show_outline(&mut self, view: &View, objects: Range<usize>) {
        let (Some(ours), Some(theirs)) = (&self.reference.objects, &self.other.objects) else { return };
        let Pixels::Eight(differences) = &self.difference.pixels else { return };
        let is_between = |pixel: &usize| {
            ours[*pixel] != theirs[*pixel] && objects.contains(&(view.object_of[*pixel] as usize))
        };
        let largest = (0..ours.len()).filter(is_between).max_by_key(|&pixel| differences[pixel].iter().max());
        let Some(pixel) = largest else { return };
        let width = self.reference.size[0] as usize;
        self.pixel = [pixel % width, pixel / width].map(|at| at as u32);
    }
}

/// The picture of models next to the reference, in a view or in that of the largest difference.
fn compare(
    search: &Search,
    models: &[ObjectModel],
    lights: &Vec<usize>,
    view: Option<usize>,
) -> Result<Comparison, PlanError> {
    let trials = &search.trials;
    let metric = trials.limits.metric;
    let mut found: Option<(usize, Difference, f64)> = None;
    for number in view.map_or(0..trials.views.len(), |view| view..view + 1) {
        let (worst, outline) = trials.measure(&trials.views[number], models, lights)?;
        let is_beyond = outline > trials.limits.outline;
        if found.is_none_or(|(_, other, _)| is_beyond || worst.by(metric) > other.by(metric)) {
            found = Some((number, worst, outline));
        }
    }
    let (view, worst, outline) = found.unwrap_or_default();
    let truth = &trials.views[view].truth;
    let other = trials.picture(&trials.views[view], models, lights)?;
    let (differences, largest) = truth.code_differences(&other);
    let amplification = amplification(largest);
    let code = |steps: f64| (amplification * steps).round().min(255.0) as u8;
    let pixels = differences.into_iter().map(|steps| steps.map(code)).collect();
    let difference = Image { pixels: Pixels::Eight(pixels), ..truth.image.clone() };
    let reference = truth.image.clone();
    let pixel = worst.pixel;
    Ok(Comparison { view, reference, other, difference, amplification, worst, outline, pixel })
}

/// The largest of 1, 2, 5, 10, … up to 1000 by which a difference stays a code.
fn amplification(largest: f64) -> f64 {
    let factors = [1000.0, 500.0, 200.0, 100.0, 50.0, 20.0, 10.0, 5.0, 2.0];
    factors.into_iter().find(|factor| factor * largest <= 255.0).unwrap_or(1.0)
}

/// Everything that was tried, with its cost.
fn tried(search: &Search, found: &Found) -> Result<Vec<Tried>, PlanError> {
    let cost = |trial: &super::search::trials::Trial| {
        let mut models = found.models.clone();
        trial.models.iter().for_each(|(unit, model)| models[*unit] = *model);
        let cost = search.cost(&models, &trial.lights)?.of(search.minimise);
        Ok(Tried { cost, error: trial.error, is_within: trial.is_within })
    };
    search.trials.log().iter().map(cost).collect()
}
