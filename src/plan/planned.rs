//! The plan of a scene file: views, search, verification, and the planned text.

use super::axes::{Axis, LightModel, ObjectModel};
use super::bounds;
use super::compare::Difference;
use super::cost::{Cost, Minimise};
use super::document::Document;
use super::lights::{bound_combinations, replacements};
use super::models::models_of;
use super::search::{Found, Outcome, Search};
use super::stage::{PlanError, Stage, Unit};
use super::trials::{Limits, Trials, View};
use super::views::around;
use crate::num::{Radians, three_digits};
use crate::raster::{Camera, LoadOptions, SceneFile, default_lights};
use glam::DVec3;
use std::path::Path;

/// What a plan keeps to, and how it is found.
#[derive(Clone, Debug, PartialEq)]
pub struct PlanOptions {
    /// Largest difference over all pixels and channels in steps of 1/255, before values are rounded.
    pub tolerance: f64,
    /// Share of the covered pixels that may be beyond it.
    pub share: f64,
    /// Largest distance of outlines, in pixels.
    pub outline: f64,
    /// What is made as small as possible.
    pub minimise: Minimise,
    /// The number of views around the scene; `None` for its camera.
    pub views: Option<u32>,
    /// Axes that stay as declared.
    pub keep: Vec<Axis>,
    /// Most pixels to draw.
    pub budget: u64,
}

impl Default for PlanOptions {
    /// Two steps, half a pixel, and 10¹⁰ pixels.
    fn default() -> Self {
        Self {
            tolerance: 2.0,
            share: 0.0,
            outline: 0.5,
            minimise: Minimise::Work,
            views: None,
            keep: Vec::new(),
            budget: 10_000_000_000,
        }
    }
}

impl PlanOptions {
    fn check(&self) -> Result<(), PlanError> {
        let limits = [
            ("tolerance", self.tolerance, f64::MAX),
            ("share of pixels", self.share, 1.0),
            ("distance of outlines", self.outline, f64::MAX),
        ];
        match limits.into_iter().find(|(_, value, most)| !(0.0..=*most).contains(value)) {
            None => Ok(()),
            Some((name, value, most)) => {
                let range = if most == 1.0 { "a number from 0 to 1" } else { "a finite number, 0 or more" };
                Err(PlanError::Invalid(format!("the {name} is {value}; {range} was expected")))
            }
        }
    }
}

/// A change of an object or a light.
#[derive(Clone, Debug, PartialEq, serde::Serialize)]
pub struct Decision {
    /// The object or light, by name.
    pub what: String,
    /// The number of the object, or of the light if the axis is `lights`.
    pub number: usize,
    /// What is changed.
    pub axis: Axis,
    /// As declared.
    pub from: String,
    /// As planned.
    pub to: String,
    /// What it saves of the cost that is minimised, with all other changes made.
    pub saved: i64,
    /// A proven bound on the difference that it makes alone, in steps; `None` where there is none.
    pub bound: Option<f64>,
    /// The difference that it makes alone, in steps.
    pub measured: f64,
}

/// The result.
#[derive(Clone, Debug, PartialEq, serde::Serialize)]
pub struct Plan {
    /// The planned scene file.
    #[serde(skip)]
    pub text: String,
    /// The changes, objects first.
    pub decisions: Vec<Decision>,
    /// The cost as declared.
    pub declared: Cost,
    /// The cost as planned.
    pub planned: Cost,
    /// The largest difference, in the view of this number.
    pub worst: Difference,
    /// The view of the largest difference.
    pub worst_view: usize,
    /// The largest distance of outlines, in pixels.
    pub outline: f64,
    /// The number of views that the plan was found with.
    pub views: usize,
    /// The largest difference over views that the plan was not found with; `None` for the scene's own camera.
    pub held_out: Option<Difference>,
    /// Views that were added because the plan was beyond the tolerance in them.
    pub repairs: usize,
    /// No plan costs less than this; 0 if the scene has so many lights that not all of their replacements were tried.
    pub proven: u64,
    /// Whether the plan is proven to be the cheapest.
    pub is_cheapest: bool,
    /// Combinations of models.
    pub combinations: f64,
    /// Models that were drawn and refused.
    pub refused: u64,
    /// Pixels drawn.
    pub drawn: u64,
}

/// Most models of all objects together: 64 bytes each.
const MOST_MODELS: usize = 1 << 23;

/// Finds the cheapest model of a scene within a tolerance. `base` is the folder of the scene file.
///
/// # Errors
/// An unreadable scene, one that cannot be drawn, or options that make no sense for it.
pub fn plan(
    text: &str,
    base: &Path,
    load: &LoadOptions,
    options: &PlanOptions,
    progress: &dyn Fn(f64),
) -> Result<Plan, PlanError> {
    options.check()?;
    // Errors of the text have lines if the reader of scenes finds them.
    let whole = SceneFile::from_toml(text, base, load)?;
    let document =
        Document::parse(text).map_err(|error| PlanError::Invalid(error.to_string()))?.with_tables();
    let stage = Stage::new(&document, base, load)?;
    let camera = whole.scene().camera;
    let (low, high) = whole.scene().bounds().unwrap_or_default();
    let (middle, radius) = (low.midpoint(high), 0.5 * low.distance(high));
    let is_open = |axis: Axis| !options.keep.contains(&axis);
    let models: Vec<Vec<ObjectModel>> =
        (0..stage.units.len()).map(|unit| models_of(&stage, unit, &is_open)).collect();
    if models.iter().map(Vec::len).sum::<usize>() > MOST_MODELS {
        let found = format!("{} objects have too many models together; open fewer axes", models.len());
        return Err(PlanError::Invalid(found));
    }
    let declared_lights = whole.lights.clone().unwrap_or_default();
    let mut lights: Vec<Vec<LightModel>> = declared_lights
        .iter()
        .enumerate()
        .map(|(number, light)| match is_open(Axis::Lights) && !whole.kept_lights.contains(&number) {
            true => replacements(light, middle),
            false => vec![LightModel(Some(*light))],
        })
        .collect();
    let is_bounded = bound_combinations(&mut lights);
    let lights_at = |camera: &Camera| whole.lights.clone().unwrap_or_else(|| default_lights(camera).to_vec());
    let cameras = options.views.map_or_else(|| vec![camera], |count| around(&camera, count.max(1), 0.0));
    let held_out = options.views.map_or_else(Vec::new, |count| around(&camera, count.max(1), 0.5));
    let view = |camera: &Camera| View::new(&stage, *camera, lights_at(camera));
    let mut views = cameras.iter().map(view).collect::<Result<Vec<_>, _>>()?;
    if views.iter().all(|view| view.truth.image.statistics.covered_pixels == 0) {
        return Err(PlanError::Invalid("no view shows any object".to_owned()));
    }
    let limits = Limits {
        tolerance: options.tolerance,
        share: options.share,
        outline: options.outline,
        budget: options.budget,
    };
    let held_out_views = held_out.iter().map(view).collect::<Result<Vec<_>, _>>()?;
    let mut waiting: Vec<View> = held_out_views;
    let mut repairs = 0;
    loop {
        let trials = Trials::new(&stage, &views, &lights, limits, progress);
        let search = Search::new(trials, &models, options.minimise);
        let outcome = search.run()?;
        let mut worst: Option<(Difference, usize)> = None;
        for (number, view) in waiting.iter().enumerate() {
            let (difference, distance) =
                search.trials.measure(view, &outcome.found.models, &outcome.found.lights)?;
            let distance_steps = if distance > limits.outline { f64::INFINITY } else { difference.steps };
            let difference = Difference { steps: distance_steps, ..difference };
            if worst.is_none_or(|(other, _)| difference.steps > other.steps) {
                worst = Some((difference, number));
            }
        }
        if let Some((difference, number)) = worst
            && difference.steps > limits.tolerance
        {
            let view = waiting.swap_remove(number);
            repairs += 1;
            drop(search);
            views.push(view);
            continue;
        }
        let whole = &whole;
        let scene = Described { stage: &stage, document: &document, lights: &lights, whole, middle, radius };
        let mut plan = scene.describe(&search, &outcome, options)?;
        plan.held_out = worst.map(|(difference, _)| difference);
        plan.repairs = repairs;
        if is_bounded {
            (plan.proven, plan.is_cheapest) = (0, false);
        }
        return Ok(plan);
    }
}

struct Described<'a> {
    stage: &'a Stage<'a>,
    document: &'a Document,
    lights: &'a [Vec<LightModel>],
    whole: &'a SceneFile,
    middle: DVec3,
    radius: f64,
}

impl Described<'_> {
    fn describe(&self, search: &Search, outcome: &Outcome, options: &PlanOptions) -> Result<Plan, PlanError> {
        let found = &outcome.found;
        let declared: Vec<ObjectModel> = self.stage.units.iter().map(|unit| unit.reference).collect();
        let declared_lights = vec![0; found.lights.len()];
        let cost = |models: &[ObjectModel], lights: &Vec<usize>| search.cost(models, lights);
        let (before, after) = (cost(&declared, &declared_lights)?, cost(&found.models, &found.lights)?);
        let mut decisions = Vec::new();
        for (unit, model) in found.models.iter().enumerate() {
            let reference = declared[unit];
            for axis in model.differs(&reference) {
                let alone = reference.with(axis, model);
                let without = model.with(axis, &reference);
                let mut models = found.models.clone();
                models[unit] = without;
                let saved = difference_of(&cost(&models, &found.lights)?, &after, options.minimise);
                let mut only = declared.clone();
                only[unit] = alone;
                decisions.push(Decision {
                    what: self.stage.units[unit].name.clone(),
                    number: unit,
                    axis,
                    from: reference.value(axis),
                    to: model.value(axis),
                    saved,
                    bound: self.bound(search, unit, axis, model),
                    measured: self.worst(search, &only, &declared_lights)?,
                });
            }
        }
        for (light, &number) in found.lights.iter().enumerate().filter(|(_, number)| **number > 0) {
            let mut without = found.lights.clone();
            without[light] = 0;
            let mut only = declared_lights.clone();
            only[light] = number;
            let (old, new) = (&self.lights[light][0], &self.lights[light][number]);
            decisions.push(Decision {
                what: format!("light {light}"),
                number: light,
                axis: Axis::Lights,
                from: old.to_string(),
                to: new.to_string(),
                saved: difference_of(&cost(&found.models, &without)?, &after, options.minimise),
                bound: self.light_bound(old, new),
                measured: self.worst(search, &declared, &only)?,
            });
        }
        let is_cheapest = outcome.proven >= found.cost.of(options.minimise);
        let (worst, worst_view) = found.worst;
        Ok(Plan {
            text: self.text(found, &decisions, options, worst),
            decisions,
            declared: before,
            planned: after,
            worst,
            worst_view,
            outline: found.outline,
            views: search.trials.views.len(),
            held_out: None,
            repairs: 0,
            proven: outcome.proven,
            is_cheapest,
            combinations: outcome.combinations,
            refused: outcome.refused,
            drawn: outcome.drawn,
        })
    }

    /// The largest difference of models over all views, in steps.
    fn worst(&self, search: &Search, models: &[ObjectModel], lights: &Vec<usize>) -> Result<f64, PlanError> {
        let measure = |view| Ok(search.trials.measure(view, models, lights)?.0.steps);
        let steps: Result<Vec<f64>, PlanError> = search.trials.views.iter().map(measure).collect();
        Ok(steps?.into_iter().fold(0.0, f64::max))
    }

    fn bound(&self, search: &Search, unit: usize, axis: Axis, model: &ObjectModel) -> Option<f64> {
        let material = self.stage.units[unit].material?;
        let lights = search.trials.lights_of(&search.trials.views[0], &vec![0; self.lights.len()]);
        match axis {
            Axis::Storage => {
                let format = model.normals?.format?;
                let angle = Radians::from(format.encoding().worst_angle()).0;
                let linear = bounds::of_normals(&material, &lights, angle, self.middle, self.radius)?;
                bounds::steps(linear, &self.stage.settings)
            }
            _ => None,
        }
    }

    fn light_bound(&self, old: &LightModel, new: &LightModel) -> Option<f64> {
        let materials = self.stage.units.iter().map(|unit| unit.material).collect::<Option<Vec<_>>>()?;
        let linear = materials
            .iter()
            .map(|material| {
                bounds::of_light(material, old.0.as_ref()?, new.0.as_ref(), self.middle, self.radius)
            })
            .collect::<Option<Vec<f64>>>()?
            .into_iter()
            .fold(0.0, f64::max);
        bounds::steps(linear, &self.stage.settings)
    }

    /// The planned scene file, with the reason for each change.
    fn text(
        &self,
        found: &Found,
        decisions: &[Decision],
        options: &PlanOptions,
        worst: Difference,
    ) -> String {
        let mut document = self.document.clone();
        let comment = |decision: &Decision| {
            let bound =
                decision.bound.map_or(String::new(), |bound| format!(", bound {}", three_digits(bound)));
            format!(
                "plan: {} to {}, {} steps alone{bound}",
                decision.from,
                decision.to,
                three_digits(decision.measured)
            )
        };
        for (unit, model) in found.models.iter().enumerate() {
            let reason = |key: &str| {
                let axis = axis_of(key);
                let decision = decisions
                    .iter()
                    .find(|it| it.axis != Axis::Lights && it.number == unit && Some(it.axis) == axis);
                decision.map(&comment).unwrap_or_default()
            };
            let Some(unit_of) = self.stage.units.get(unit) else { continue };
            document.apply(unit, model, &unit_of.reference, unit_of.material.as_ref(), &reason);
        }
        if found.lights.iter().any(|&number| number > 0) {
            let lights = found.lights.iter().enumerate().map(|(light, &number)| {
                let is_it = |it: &&Decision| it.axis == Axis::Lights && it.number == light;
                (self.lights[light][number], decisions.iter().find(is_it).map(&comment).unwrap_or_default())
            });
            document.set_lights(&lights.collect::<Vec<_>>(), &self.whole.kept_lights);
        }
        let is_coarser = |(model, unit): (&ObjectModel, &Unit)| model.segments != unit.reference.segments;
        if self.whole.camera.is_none() && found.models.iter().zip(&self.stage.units).any(is_coarser) {
            // Fewer cells are smaller, and would be framed closer.
            document.set_camera(&self.whole.scene().camera);
        }
        let tolerance = options.tolerance;
        let steps = three_digits(worst.steps);
        document
            .set_head(&format!("Planned by crease: within {steps} steps of 255 (tolerance {tolerance})."));
        document.to_string()
    }
}

/// The axis that a key of an object belongs to.
fn axis_of(key: &str) -> Option<Axis> {
    Some(match key {
        "shading" => Axis::Shading,
        "weight" => Axis::Weight,
        "crease" => Axis::Creases,
        "precision" => Axis::Precision,
        "normal-format" => Axis::Storage,
        "interpolation" => Axis::Interpolation,
        "material" => Axis::Reflection,
        "tessellation" => Axis::Tessellation,
        "two-sided" => Axis::TwoSided,
        _ => return None,
    })
}

fn difference_of(before: &Cost, after: &Cost, minimise: Minimise) -> i64 {
    before.of(minimise) as i64 - after.of(minimise) as i64
}
