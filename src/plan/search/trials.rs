//! Pictures of models, compared with the reference.

use super::witnesses::Witnesses;
use crate::mesh::NONE;
use crate::plan::axes::{Cells, LightModel, ObjectModel};
use crate::plan::bounds::ModelBounds;
use crate::plan::compare::{Difference, Metric, outline_distance};
use crate::plan::lights::LightChoice;
use crate::plan::options::{End, Progress};
use crate::plan::stage::{PlanError, Stage};
use crate::plan::views::View;
use crate::raster::Image;
use crate::shade::Light;
use std::cell::{Cell, Ref, RefCell};
use std::collections::HashMap;
use std::rc::Rc;
use std::time::Instant;

/// What a plan has to keep to.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Limits {
    /// How pictures are compared.
    pub metric: Metric,
    /// Largest difference by this metric.
    pub tolerance: f64,
    /// Share of the covered pixels of a view that may be beyond it.
    pub share: f64,
    /// Largest distance of outlines, in pixels.
    pub outline: f64,
    /// Most pixels to draw for a plan.
    pub budget: u64,
    /// Pixels drawn at which the search ends.
    pub end: u64,
    /// When the search ends.
    pub deadline: Option<Instant>,
    /// Most seconds for a plan.
    pub seconds: f64,
}

impl Limits {
    /// Whether a difference and a distance of outlines in a view are within the limits.
    pub fn accept(&self, view: &View, difference: &Difference, outline: f64) -> bool {
        match self.metric {
            Metric::Steps => difference.beyond <= self.most_beyond(view) && outline <= self.outline,
            Metric::Flip => difference.by(Metric::Flip) <= self.tolerance,
        }
    }

    /// Pixels that may be beyond the tolerance.
    fn most_beyond(&self, view: &View) -> u64 {
        (self.share * view.covered as f64) as u64
    }
}

/// What all searches of a plan have drawn.
#[derive(Debug, Default)]
pub struct Counts {
    /// Pixels.
    pub drawn: Cell<u64>,
    /// Models that were refused.
    refused: Cell<u64>,
    /// The share of the cost of the best plan that is proven.
    proven: Cell<f64>,
    /// The cost of the best plan as a share of the declared one.
    best: Cell<Option<f64>>,
}

/// Pictures that one compared by ꟻLIP counts as in the budget: its filters take some sixty times as long as drawing it.
const FLIP: u64 = 64;

/// Models that were drawn and compared.
#[derive(Clone, Debug)]
pub struct Trial {
    /// The objects that have them.
    pub models: Vec<(usize, ObjectModel)>,
    /// The lights.
    pub lights: LightChoice,
    /// The largest difference that was found.
    pub error: f64,
    /// Whether it is within the limits.
    pub is_within: bool,
}

/// A view, a unit and its cells.
type Covering = (usize, usize, Cells);

/// Draws models and remembers which keep to the limits.
pub struct Trials<'a> {
    /// The scene.
    pub stage: &'a Stage<'a>,
    /// The views.
    pub views: &'a [View],
    /// What may replace each light.
    pub lights: &'a [Vec<LightModel>],
    /// What a plan keeps to.
    pub limits: Limits,
    /// Bounds on the difference of models, where they hold.
    pub bounds: Option<ModelBounds<'a>>,
    /// The cells that each unit may have.
    pub cells: Vec<Vec<Cells>>,
    /// The pixels of a view that show a unit with these cells in every plan.
    pub(super) lasting: RefCell<HashMap<Covering, Rc<[bool]>>>,
    /// Called after each picture.
    progress: &'a dyn Fn(Progress),
    counts: &'a Counts,
    known: RefCell<HashMap<(usize, usize, LightChoice), bool>>,
    log: RefCell<Vec<Trial>>,
    /// Pixels at which models were refused.
    pub(in crate::plan) witnesses: Witnesses,
}

/// The largest difference of a plan with the number of its view, and the largest distance of outlines.
pub type Worst = ((Difference, usize), f64);

impl<'a> Trials<'a> {
    /// Of the models of a scene.
    pub fn new(
        stage: &'a Stage<'a>,
        views: &'a [View],
        lights: &'a [Vec<LightModel>],
        limits: Limits,
        bounds: Option<ModelBounds<'a>>,
        counts: &'a Counts,
        progress: &'a dyn Fn(Progress),
    ) -> Self {
        let cells = stage.units.iter().map(|unit| vec![unit.reference.segments]).collect();
        let (lasting, known, log, witnesses) = Default::default();
        Self { stage, views, lights, limits, bounds, cells, lasting, progress, counts, known, log, witnesses }
    }

    /// Pixels drawn.
    pub fn drawn(&self) -> u64 {
        self.counts.drawn.get()
    }

    /// Models refused.
    pub fn refused(&self) -> u64 {
        self.counts.refused.get()
    }

    /// All that was drawn and compared, in order.
    pub fn log(&self) -> Ref<'_, Vec<Trial>> {
        self.log.borrow()
    }

    /// Whether the budget or the time is used up.
    pub fn is_spent(&self) -> bool {
        self.spent().is_some()
    }

    /// What is used up. If it is the time, the plan depends on the machine, with or without the budget.
    pub fn spent(&self) -> Option<End> {
        let Limits { budget, end, deadline, seconds, .. } = self.limits;
        if deadline.is_some_and(|deadline| Instant::now() > deadline) {
            return Some(End::Time { seconds });
        }
        (self.counts.drawn.get() > end).then_some(End::Budget { pixels: budget })
    }

    /// The lights of a view with a choice: all declared ones where no light has replacements.
    pub fn lights_of(&self, view: &View, choice: &LightChoice) -> Vec<Light> {
        if self.lights.is_empty() {
            return view.lights.clone();
        }
        let chosen = self.lights.iter().zip(choice).filter_map(|(models, &number)| models[number].0);
        chosen.map(|light| view.turn.of(&light)).collect()
    }

    /// Whether a model of a unit, known by its number, keeps to the limits on the pixels that show nothing else. ꟻLIP depends on the whole
    /// picture, so it refuses nothing here.
    ///
    /// # Errors
    /// What makes a picture impossible.
    pub fn is_within(
        &self,
        (unit, number): (usize, usize),
        model: &ObjectModel,
        choice: &LightChoice,
    ) -> Result<bool, PlanError> {
        if self.limits.metric == Metric::Flip {
            return Ok(true);
        }
        let key = (unit, number, choice.clone());
        if let Some(&known) = self.known.borrow().get(&key) {
            return Ok(known);
        }
        let bound = self.bounds.as_ref().and_then(|bounds| bounds.model(unit, model, choice));
        let is_bounded = bound.is_some_and(|bound| bound <= self.limits.tolerance);
        let mut is_within = true;
        if !is_bounded {
            let mut error = self.error_at_witness((unit, number), model, choice)?;
            is_within = error <= self.limits.tolerance;
            for view in 0..self.views.len() {
                if is_within {
                    let (found, is_within_view) = self.is_within_view(view, unit, model, choice)?;
                    (error, is_within) = (error.max(found), is_within_view);
                }
            }
            let (models, lights) = (vec![(unit, *model)], choice.clone());
            self.log.borrow_mut().push(Trial { models, lights, error, is_within });
        }
        self.counts.refused.set(self.counts.refused.get() + u64::from(!is_within));
        self.known.borrow_mut().insert(key, is_within);
        Ok(is_within)
    }

    /// The largest difference of a model in a view, and whether it is within the limits.
    fn is_within_view(
        &self,
        number: usize,
        unit: usize,
        model: &ObjectModel,
        choice: &LightChoice,
    ) -> Result<(f64, bool), PlanError> {
        let view = &self.views[number];
        let lights = self.lights_of(view, choice);
        let picture = self.draw(&[(unit, *model)], &lights, view)?;
        let Some(shown) = &picture.objects else { return Ok((0.0, true)) };
        let lasting = self.lasting_pixels(number, unit, model.segments)?;
        let is_compared = |pixel: usize| {
            let lasts = lasting.as_ref().is_none_or(|lasting| lasting[pixel]);
            lasts && self.shows_unit(view, (unit, 0), shown, pixel)
        };
        let most = self.limits.most_beyond(view);
        let difference = view.truth.difference(&picture, self.limits.tolerance, most, is_compared);
        if difference.beyond > most {
            self.add_witness(number, unit, model, difference.pixel)?;
            return Ok((difference.steps, false));
        }
        let has_other_samples = view.truth.samples() != self.stage.settings.samples;
        if model.segments == self.stage.units[unit].reference.segments && !has_other_samples {
            return Ok((difference.steps, true));
        }
        Ok((difference.steps, self.outline(view, unit, &picture)? <= self.limits.outline))
    }

    /// The distance of a unit's outline from that of the reference, both alone.
    fn outline(&self, view: &View, unit: usize, picture: &Image) -> Result<f64, PlanError> {
        let mut alone = view.alone[unit].borrow_mut();
        if alone.is_none() {
            let stage = self.stage.with_samples(view.truth.samples());
            let reference = self.stage.units[unit].reference;
            *alone = Some(stage.draw(&[(unit, reference)], &view.lights, &view.camera)?);
            self.count(self.pixels());
        }
        let Some(truth) = &*alone else { return Ok(0.0) };
        match outline_distance((picture, self.stage.settings.samples), (truth, view.truth.samples())) {
            Ok(distance) => Ok(distance),
            // Nothing is left of it, or nothing was there.
            Err(crate::metric::MetricError::Empty) => Ok(f64::INFINITY),
            Err(error) => Err(error.into()),
        }
    }

    pub(super) fn draw(
        &self,
        models: &[(usize, ObjectModel)],
        lights: &[Light],
        view: &View,
    ) -> Result<Image, PlanError> {
        self.count(self.pixels());
        self.stage.draw(models, lights, &view.camera)
    }

    /// The pixels of a picture, each counted once for each of its samples.
    pub(in crate::plan) fn pixels(&self) -> u64 {
        let [width, height] = self.stage.settings.size.map(u64::from);
        width * height * self.stage.settings.samples.count() as u64
    }

    /// Counts drawn pixels.
    pub(in crate::plan) fn count(&self, pixels: u64) {
        self.counts.drawn.set(self.counts.drawn.get() + pixels);
        let used = self.counts.drawn.get() as f64 / self.limits.budget.max(1) as f64;
        let (proven, best) = (self.counts.proven.get(), self.counts.best.get());
        (self.progress)(Progress { share: used.max(proven).min(1.0), best: best.unwrap_or(1.0) });
    }

    /// Notes the costs that are proven and found, for the progress.
    pub(in crate::plan) fn note(&self, proven: u64, best: u64, declared: u64) {
        let share = |part: u64, whole: u64| (part as f64 / whole.max(1) as f64).min(1.0);
        self.counts.proven.set(share(proven, best));
        self.counts.best.set(Some(share(best, declared)));
        self.count(0);
    }

    /// The largest difference of a whole plan with its view, and the largest distance of outlines; `None` if it is not within the limits.
    pub fn check(&self, models: &[ObjectModel], choice: &LightChoice) -> Result<Option<Worst>, PlanError> {
        let (mut worst, mut outline) = ((Difference::default(), 0), 0.0_f64);
        let metric = self.limits.metric;
        let log = |error, is_within| {
            let models = models.iter().copied().enumerate().collect();
            self.log.borrow_mut().push(Trial { models, lights: choice.clone(), error, is_within });
        };
        for (number, view) in self.views.iter().enumerate() {
            let (difference, distance) = self.measure(view, models, choice)?;
            if !self.limits.accept(view, &difference, distance) {
                log(difference.by(metric), false);
                let [x, y] = difference.pixel;
                let object = view.truth.image.index(x, y).map_or(NONE, |pixel| view.object_of[pixel]);
                if difference.beyond > 0 && object != NONE {
                    let unit = self.stage.unit_of(object);
                    self.add_witness(number, unit, &models[unit], difference.pixel)?;
                }
                return Ok(None);
            }
            if difference.by(metric) > worst.0.by(metric) {
                worst = (difference, number);
            }
            outline = outline.max(distance);
        }
        log(worst.0.by(metric), true);
        Ok(Some((worst, outline)))
    }

    /// The picture of a plan in a view.
    pub fn picture(
        &self,
        view: &View,
        models: &[ObjectModel],
        choice: &LightChoice,
    ) -> Result<Image, PlanError> {
        let all: Vec<_> = models.iter().copied().enumerate().collect();
        self.draw(&all, &self.lights_of(view, choice), view)
    }

    /// The difference of a plan in a view, and the distance of outlines of units.
    pub fn measure(
        &self,
        view: &View,
        models: &[ObjectModel],
        choice: &LightChoice,
    ) -> Result<(Difference, f64), PlanError> {
        let lights = self.lights_of(view, choice);
        let picture = self.picture(view, models, choice)?;
        let shown = picture.objects.as_deref().unwrap_or_default();
        let is_compared = |pixel: usize| self.shows_the_same(view, shown, pixel);
        let mut difference = view.truth.difference(&picture, self.limits.tolerance, u64::MAX, is_compared);
        if self.limits.metric == Metric::Flip {
            self.count((FLIP - 1) * self.pixels());
            difference.flip = Some(view.truth.flip(&picture)?);
            return Ok((difference, 0.0));
        }
        let has_other_samples = view.truth.samples() != self.stage.settings.samples;
        let mut outline = 0.0_f64;
        for (unit, model) in models.iter().enumerate() {
            if has_other_samples || model.segments != self.stage.units[unit].reference.segments {
                let alone = self.draw(&[(unit, *model)], &lights, view)?;
                outline = outline.max(self.outline(view, unit, &alone)?);
            }
        }
        Ok((difference, outline))
    }
    /// Whether a pixel of a picture shows the same objects as in the reference. With another number of samples those pixels count which show
    /// one object.
    fn shows_the_same(&self, view: &View, shown: &[u32], pixel: usize) -> bool {
        let samples = self.stage.settings.samples;
        if view.truth.samples() == samples {
            return view.truth.image.objects.as_ref().is_some_and(|truth| truth[pixel] == shown[pixel]);
        }
        let object = view.object_of[pixel];
        object != NONE && shown[pixel] == Image::number_of(object as usize, samples.count())
    }
}
