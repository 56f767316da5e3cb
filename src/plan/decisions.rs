//! The decisions of a plan, what each of them saves and costs in accuracy, and the planned text.

use super::axes::{Axis, LightModel, ObjectModel};
use super::bounds::{ModelBounds, outline_bound};
use super::compare::{Difference, Metric};
use super::cost::{Cost, Minimise};
use super::document::Document;
use super::options::End;
use super::search::trials::Limits;
use super::search::{Found, Outcome, Search};
use super::stage::{PlanError, Stage};
use super::unit::Unit;
use super::views::Place;
use crate::num::three_digits;
use crate::raster::SceneFile;

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
    /// The difference that it makes alone, in steps; by ꟻLIP if pictures are compared by it.
    pub measured: f64,
    /// How far it moves outlines alone; `None` for changes that keep them.
    pub outline: Option<OutlineShift>,
    /// The angle in degrees by which normals or the direction to the light are off at most; `None` for other changes.
    pub angle: Option<f64>,
    /// The distance of a light with a position from the middle of the scene, in radii of the scene.
    pub radii: Option<f64>,
}

/// Distances of outlines.
#[derive(Clone, Copy, Debug, PartialEq, serde::Serialize)]
pub struct OutlineShift {
    /// The largest distance in the pictures, in pixels.
    pub measured: f64,
    /// A proven bound on the distance before pixels sample it, in pixels; `None` where there is none.
    pub bound: Option<f64>,
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
    /// Its camera and lights.
    pub worst_place: Place,
    /// The largest distance of outlines, in pixels.
    pub outline: f64,
    /// The number of views that the plan was found with.
    pub views: usize,
    /// The largest difference over views that the plan was not found with; `None` for the scene's own camera.
    pub held_out: Option<Difference>,
    /// The camera and the lights of that view.
    pub held_out_place: Option<Place>,
    /// Views that were added because the plan was beyond the tolerance in them.
    pub repairs: usize,
    /// Why the search ended.
    pub end: End,
    /// No plan costs less than this.
    pub proven: u64,
    /// Whether the plan is proven to be the cheapest.
    pub is_cheapest: bool,
    /// The largest share of the planned cost that a cheaper plan may save; 0 if the plan is the cheapest.
    pub gap: f64,
    /// Combinations of models; the largest finite number if there are more.
    pub combinations: f64,
    /// Models that were drawn and refused.
    pub refused: u64,
    /// Pixels drawn.
    pub drawn: u64,
}

/// A planned scene.
pub struct Described<'a> {
    pub stage: &'a Stage<'a>,
    pub document: &'a Document,
    pub lights: &'a [Vec<LightModel>],
    pub whole: &'a SceneFile,
    /// The search with the samples of the reference.
    pub declared: &'a Search<'a>,
}

impl Described<'_> {
    /// The plan that a search has found.
    ///
    /// # Errors
    /// What makes a picture impossible.
    pub fn describe(&self, search: &Search, outcome: &Outcome) -> Result<Plan, PlanError> {
        let Some(found) = &outcome.found else {
            return Err(PlanError::Invalid("no plan was found".to_owned()));
        };
        let declared: Vec<ObjectModel> = self.stage.units.iter().map(|unit| unit.reference).collect();
        let declared_lights = vec![0; found.lights.len()];
        let cost = |models: &[ObjectModel], lights: &Vec<usize>| search.cost(models, lights);
        let before = self.declared.cost(&declared, &declared_lights)?;
        let after = cost(&found.models, &found.lights)?;
        let mut decisions = Vec::new();
        for (unit, model) in found.models.iter().enumerate() {
            let reference = declared[unit];
            for axis in model.differs(&reference) {
                let alone = reference.with(axis, model);
                let without = model.with(axis, &reference);
                let mut models = found.models.clone();
                models[unit] = without;
                let saved = difference_of(&cost(&models, &found.lights)?, &after, search.minimise);
                let mut only = declared.clone();
                only[unit] = alone;
                let (measured, shift) = self.worst(self.declared, &only, &declared_lights)?;
                let is_tessellation =
                    axis == Axis::Tessellation && search.trials.limits.metric == Metric::Steps;
                let outline = is_tessellation.then(|| {
                    let bound = |cells| outline_bound(self.stage, unit, cells, self.declared.trials.views);
                    OutlineShift { measured: shift, bound: model.segments.and_then(bound) }
                });
                decisions.push(Decision {
                    what: self.stage.units[unit].name.clone(),
                    number: unit,
                    axis,
                    from: reference.value(axis),
                    to: model.value(axis),
                    saved,
                    bound: self.bound(unit, &alone, &declared_lights),
                    measured,
                    outline,
                    angle: self.angle(unit, axis, &alone),
                    radii: None,
                });
            }
        }
        for (light, &number) in found.lights.iter().enumerate().filter(|(_, number)| **number > 0) {
            let mut without = found.lights.clone();
            without[light] = 0;
            let mut only = declared_lights.clone();
            only[light] = number;
            let (old, new) = (&self.lights[light][0], &self.lights[light][number]);
            let lamp = self.bounds().and_then(|bounds| bounds.lamp(old.0.as_ref()?, new.0.as_ref()?));
            decisions.push(Decision {
                what: format!("light {light}"),
                number: light,
                axis: Axis::Lights,
                from: old.to_string(),
                to: new.to_string(),
                saved: difference_of(&cost(&found.models, &without)?, &after, search.minimise),
                bound: self.bound_of_lights(&only),
                measured: self.worst(self.declared, &declared, &only)?.0,
                outline: None,
                angle: lamp.map(|(_, angle)| angle.to_degrees()),
                radii: lamp.map(|(radii, _)| radii),
            });
        }
        let (old, new) = (self.stage.settings.samples, search.trials.stage.settings.samples);
        if old != new {
            let without = self.declared.cost(&found.models, &found.lights)?;
            let (measured, shift) = self.worst(search, &declared, &declared_lights)?;
            let is_compared = search.trials.limits.metric == Metric::Steps;
            decisions.push(Decision {
                what: "picture".to_owned(),
                number: 0,
                axis: Axis::Antialiasing,
                from: old.count().to_string(),
                to: new.count().to_string(),
                saved: difference_of(&without, &after, search.minimise),
                bound: None,
                measured,
                outline: is_compared.then_some(OutlineShift { measured: shift, bound: None }),
                angle: None,
                radii: None,
            });
        }
        let cost_found = found.cost.of(search.minimise);
        let is_cheapest = outcome.proven >= cost_found;
        let (worst, worst_view) = found.worst;
        Ok(Plan {
            text: self.text(found, &decisions, worst, search),
            decisions,
            declared: before,
            planned: after,
            worst,
            worst_view,
            worst_place: search.trials.views[worst_view].place(),
            outline: found.outline,
            views: search.trials.views.len(),
            held_out: None,
            held_out_place: None,
            repairs: 0,
            end: outcome.end,
            proven: outcome.proven,
            gap: 1.0 - outcome.proven.min(cost_found) as f64 / cost_found.max(1) as f64,
            is_cheapest,
            combinations: outcome.combinations,
            refused: outcome.refused,
            drawn: outcome.drawn,
        })
    }

    /// The largest difference and the largest distance of outlines of models over all views.
    fn worst(
        &self,
        search: &Search,
        models: &[ObjectModel],
        lights: &Vec<usize>,
    ) -> Result<(f64, f64), PlanError> {
        let mut worst = (0.0_f64, 0.0_f64);
        for view in search.trials.views {
            let (difference, outline) = search.trials.measure(view, models, lights)?;
            worst = (worst.0.max(difference.by(search.trials.limits.metric)), worst.1.max(outline));
        }
        Ok(worst)
    }

    /// The bound on the difference of the reference with one model and a choice of lights.
    fn bound(&self, unit: usize, model: &ObjectModel, choice: &Vec<usize>) -> Option<f64> {
        self.bounds()?.model(unit, model, choice)
    }

    /// The angle in degrees by which the normals of a model are off.
    fn angle(&self, unit: usize, axis: Axis, model: &ObjectModel) -> Option<f64> {
        let of_normals = matches!(axis, Axis::Weight | Axis::Creases | Axis::Precision | Axis::Storage);
        self.bounds().filter(|_| of_normals)?.normals_off(unit, model).map(f64::to_degrees)
    }

    fn bounds(&self) -> Option<&ModelBounds<'_>> {
        self.declared.trials.bounds.as_ref()
    }

    /// The bound on the difference of the reference under a choice of lights.
    fn bound_of_lights(&self, choice: &Vec<usize>) -> Option<f64> {
        let units = self.stage.units.iter().enumerate();
        let bounds = units.map(|(number, unit)| self.bound(number, &unit.reference, choice));
        bounds.collect::<Option<Vec<f64>>>().map(|bounds| bounds.into_iter().fold(0.0, f64::max))
    }

    fn is_omitted(&self, found: &Found, light: usize) -> bool {
        self.lights[light][found.lights[light]].0.is_none()
    }

    /// The planned scene file, with the reason for each change.
    fn text(&self, found: &Found, decisions: &[Decision], worst: Difference, search: &Search) -> String {
        let Limits { metric, tolerance, .. } = search.trials.limits;
        let mut document = self.document.clone();
        let comment = |decision: &Decision| {
            let bound =
                decision.bound.map_or(String::new(), |bound| format!(", bound {}", three_digits(bound)));
            format!(
                "plan: {} to {}, {} alone{bound}",
                decision.from,
                decision.to,
                metric.text(decision.measured)
            )
        };
        for (unit, model) in found.models.iter().enumerate() {
            let reason = |axis: Axis| {
                let decision = decisions.iter().find(|it| it.number == unit && it.axis == axis);
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
        if self.whole.camera.is_none() && found.models.iter().zip(self.stage.units.iter()).any(is_coarser) {
            // Fewer cells are smaller, and would be framed closer.
            document.set_camera(&self.whole.scene().camera);
        }
        if let Some(decision) = decisions.iter().find(|decision| decision.axis == Axis::Antialiasing) {
            let samples = search.trials.stage.settings.samples.count() as i64;
            document.set_setting("samples", samples, &comment(decision));
        }
        let worst = metric.text(worst.by(metric)).replace("steps", "steps of 255");
        let mut head = format!("Planned by crease: within {worst} (tolerance {}).", limit(tolerance));
        // An omitted light has no table that a comment could stand at.
        let is_omitted = |it: &&Decision| it.axis == Axis::Lights && self.is_omitted(found, it.number);
        for decision in decisions.iter().filter(is_omitted) {
            head += &format!("\n{}: {}", decision.what, comment(decision));
        }
        document.set_head(&head);
        document.to_string()
    }
}

/// A limit as it was given, but with an exponent where it would be long.
pub fn limit(value: f64) -> String {
    if value == 0.0 || (1e-4..1e7).contains(&value) { value.to_string() } else { format!("{value:e}") }
}

fn difference_of(before: &Cost, after: &Cost, minimise: Minimise) -> i64 {
    before.of(minimise) as i64 - after.of(minimise) as i64
}
