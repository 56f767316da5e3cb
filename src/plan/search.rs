//! The cheapest plan: an exact search over all combinations of models.
//!
//! Light is local: what an object shows at a pixel depends on its own model and on the lights alone. So for each combination of lights the
//! cheapest model of each object that stays within the tolerance can be found by itself, on the pixels that show only this object; no
//! combination with a model that fails there can succeed. The picture of the whole plan is always drawn. Where it fails, because
//! of pixels that several objects share, the next combinations follow in the order of their costs.

use super::axes::{LightModel, ObjectModel};
use super::compare::{Difference, Truth, outline_distance};
use super::cost::{Cost, Minimise, object_cost};
use super::stage::{PlanError, Stage};
use crate::mesh::NONE;
use crate::raster::{Camera, Image, Projection};
use crate::shade::Light;
use std::cell::{Cell, RefCell};
use std::cmp::Reverse;
use std::collections::{BinaryHeap, HashMap, HashSet};

/// What a plan has to keep to.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Limits {
    /// Largest difference of a pixel, in steps of 1/255.
    pub tolerance: f64,
    /// Share of the covered pixels of a view that may be beyond it.
    pub share: f64,
    /// Largest distance of outlines, in pixels.
    pub outline: f64,
    /// Most pixels to draw.
    pub budget: u64,
}

/// A view of the reference.
pub struct View {
    /// The camera.
    pub camera: Camera,
    /// The lights as declared.
    pub lights: Vec<Light>,
    /// The picture of the reference.
    pub truth: Truth,
    /// Pixels that something covers.
    covered: u64,
    /// The number of the object that all samples of a pixel show; [`NONE`] for others.
    object_of: Vec<u32>,
    /// Samples of pixels that show only a unit.
    samples: Vec<u64>,
    /// The picture of each unit alone, for its outline; drawn where it is needed.
    alone: Vec<RefCell<Option<Image>>>,
}

impl View {
    /// Draws the reference from a camera.
    ///
    /// # Errors
    /// What makes the picture impossible.
    pub fn new(stage: &Stage, camera: Camera, lights: Vec<Light>) -> Result<Self, PlanError> {
        let models: Vec<_> = stage.units.iter().map(|unit| unit.reference).enumerate().collect();
        let image = stage.draw(&models, &lights, &camera)?;
        let covered = image.statistics.covered_pixels;
        let samples_of_pixel = stage.settings.samples.count();
        let objects: HashMap<u32, u32> = (0..stage.objects() as u32)
            .map(|object| (Image::number_of(object as usize, samples_of_pixel), object))
            .collect();
        let numbers = image.objects.iter().flatten();
        let object_of: Vec<u32> =
            numbers.map(|number| objects.get(number).copied().unwrap_or(NONE)).collect();
        let mut samples = vec![0; stage.units.len()];
        for &object in object_of.iter().filter(|&&object| object != NONE) {
            samples[stage.unit_of(object)] += samples_of_pixel as u64;
        }
        let alone = stage.units.iter().map(|_| RefCell::default()).collect();
        Ok(Self {
            camera,
            lights,
            truth: Truth::new(image, &stage.settings),
            covered,
            object_of,
            samples,
            alone,
        })
    }
}

/// The lights of a plan: one of the replacements of each declared light, by number.
pub type LightChoice = Vec<usize>;

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
}

/// How a search ended.
#[derive(Clone, Debug, PartialEq)]
pub struct Outcome {
    /// The cheapest plan found.
    pub found: Found,
    /// No plan costs less than this; the cost of the plan if it is proven cheapest.
    pub proven: u64,
    /// Pixels drawn.
    pub drawn: u64,
    /// Combinations of models in all.
    pub combinations: f64,
    /// Models that were drawn and refused.
    pub refused: u64,
}

/// A search over the models of objects and lights.
pub struct Search<'a> {
    /// The scene.
    pub stage: &'a Stage<'a>,
    /// The views.
    pub views: &'a [View],
    /// The models that each unit may have.
    pub models: Vec<Vec<ObjectModel>>,
    /// What may replace each light.
    pub lights: Vec<Vec<LightModel>>,
    /// What the plan keeps to.
    pub limits: Limits,
    /// What it makes small.
    pub minimise: Minimise,
    /// Called with the share of the budget that is used up.
    pub progress: &'a (dyn Fn(f64) + 'a),
    drawn: Cell<u64>,
    refused: Cell<u64>,
    known: RefCell<HashMap<(usize, usize, LightChoice), bool>>,
    /// Pixels at which models of a unit with these cells were refused: most others fail there too. The latest comes first.
    witnesses: RefCell<HashMap<(usize, Option<[u32; 2]>), Vec<Witness>>>,
}

/// A pixel of a view of which all samples show one face.
#[derive(Clone, Copy, Debug)]
struct Witness {
    view: usize,
    pixel: [u32; 2],
    face: (usize, u32),
}

/// Most witnesses of a unit.
const WITNESSES: usize = 12;

/// A model of a unit with its cost and the number of changes.
type Ranked = (u64, u32, usize, Cost);

impl<'a> Search<'a> {
    /// A search over everything that is listed.
    pub fn new(
        stage: &'a Stage<'a>,
        views: &'a [View],
        (models, lights): (Vec<Vec<ObjectModel>>, Vec<Vec<LightModel>>),
        (limits, minimise): (Limits, Minimise),
        progress: &'a (dyn Fn(f64) + 'a),
    ) -> Self {
        let (drawn, refused, known, witnesses) = Default::default();
        Self { stage, views, models, lights, limits, minimise, progress, drawn, refused, known, witnesses }
    }

    /// The lights of a view with a choice: all declared ones where no light has replacements.
    pub fn lights_of(&self, view: &View, choice: &LightChoice) -> Vec<Light> {
        if self.lights.is_empty() {
            return view.lights.clone();
        }
        self.lights.iter().zip(choice).filter_map(|(models, &number)| models[number].0).collect()
    }

    /// Searches. The reference itself is always a plan.
    ///
    /// # Errors
    /// What makes a picture impossible.
    pub fn run(&self) -> Result<Outcome, PlanError> {
        let choices = self.light_choices();
        let mut ranked: Vec<(u64, u32, LightChoice, Vec<Vec<Ranked>>)> = Vec::with_capacity(choices.len());
        for choice in choices {
            let lists = self.ranked(&choice)?;
            let least = lists.iter().map(|list| list[0].0).sum();
            let changes = choice.iter().filter(|&&number| number > 0).count() as u32;
            ranked.push((least, changes, choice, lists));
        }
        ranked.sort_by(|a, b| (a.0, a.1, &a.2).cmp(&(b.0, b.1, &b.2)));
        let combinations =
            ranked.len() as f64 * self.models.iter().map(|list| list.len() as f64).product::<f64>();
        let reference = self.reference(&ranked)?;
        let mut best: (u64, u32, Found) = (reference.cost.of(self.minimise), 0, reference);
        let mut open = u64::MAX;
        for (least, changes, choice, lists) in &ranked {
            if *least > best.0 {
                break;
            }
            if self.is_spent() {
                open = *least;
                break;
            }
            match self.cheapest(choice, lists, *changes, (best.0, best.1))? {
                Step::Found(cost, changes, found) => best = (cost, changes, *found),
                Step::Nothing => {}
                Step::Spent(least) => {
                    open = least;
                    break;
                }
            }
        }
        Ok(Outcome {
            proven: open.min(best.0),
            found: best.2,
            drawn: self.drawn.get(),
            combinations,
            refused: self.refused.get(),
        })
    }

    fn is_spent(&self) -> bool {
        self.drawn.get() > self.limits.budget
    }

    fn reference(&self, ranked: &[(u64, u32, LightChoice, Vec<Vec<Ranked>>)]) -> Result<Found, PlanError> {
        let declared = vec![0; self.lights.len()];
        let lists = ranked.iter().find(|it| it.2 == declared).map(|it| &it.3);
        let of_unit =
            |list: &Vec<Ranked>| list.iter().find(|it| it.2 == 0).map_or(Cost::default(), |it| it.3);
        Ok(Found {
            models: self.stage.units.iter().map(|unit| unit.reference).collect(),
            cost: lists.into_iter().flatten().map(of_unit).sum(),
            lights: declared,
            worst: Default::default(),
            outline: 0.0,
        })
    }

    /// The cost of models under a choice of lights.
    ///
    /// # Errors
    /// What makes the changed scene unreadable.
    pub fn cost(&self, models: &[ObjectModel], choice: &LightChoice) -> Result<Cost, PlanError> {
        models.iter().enumerate().map(|(unit, model)| self.unit_cost(unit, model, choice)).sum()
    }

    fn unit_cost(&self, unit: usize, model: &ObjectModel, choice: &LightChoice) -> Result<Cost, PlanError> {
        let samples = self.views.iter().map(|view| view.samples[unit]).sum();
        let sizes = self.stage.sizes(unit, model, samples, self.views.len() as u64)?;
        Ok(object_cost(
            &sizes,
            model,
            self.stage.units[unit].highlight,
            &self.lights_of(&self.views[0], choice),
            self.far(),
        ))
    }

    fn far(&self) -> bool {
        self.stage.settings.infinite_viewer
            || matches!(self.views[0].camera.projection, Projection::Orthographic(_))
    }

    /// All combinations of replacements of lights.
    fn light_choices(&self) -> Vec<LightChoice> {
        let mut choices = vec![Vec::new()];
        for models in &self.lights {
            choices = choices
                .into_iter()
                .flat_map(|choice| {
                    (0..models.len()).map(move |number| choice.iter().copied().chain([number]).collect())
                })
                .collect();
        }
        choices
    }

    /// The models of each unit by ascending cost under lights, then by fewer changes, then in the order of the axes.
    fn ranked(&self, choice: &LightChoice) -> Result<Vec<Vec<Ranked>>, PlanError> {
        let lights = self.lights_of(&self.views[0], choice);
        let pictures = self.views.len() as u64;
        self.models
            .iter()
            .enumerate()
            .map(|(unit, models)| {
                let samples = self.views.iter().map(|view| view.samples[unit]).sum();
                let mut sizes = HashMap::new();
                let mut list: Vec<Ranked> = Vec::with_capacity(models.len());
                for (number, model) in models.iter().enumerate() {
                    let creases = model.normals.is_none_or(|normals| normals.creases);
                    let key = (model.segments, creases);
                    let sizes = match sizes.get(&key) {
                        Some(known) => *known,
                        None => {
                            let known = self.stage.sizes(unit, model, samples, pictures)?;
                            *sizes.entry(key).or_insert(known)
                        }
                    };
                    let highlight = self.stage.units[unit].highlight;
                    let cost = object_cost(&sizes, model, highlight, &lights, self.far());
                    let changes = model.differs(&self.stage.units[unit].reference).len() as u32;
                    list.push((cost.of(self.minimise), changes, number, cost));
                }
                list.sort_by_key(|&(cost, changes, number, _)| (cost, changes, number));
                Ok(list)
            })
            .collect()
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
                if self.is_within_alone(unit, lists[unit][at].2, choice)? {
                    good[unit].push(at);
                }
                if self.is_spent() {
                    break;
                }
            }
            Ok(good[unit].len() >= count)
        };
        let least = |units: std::ops::Range<usize>| units.map(|unit| lists[unit][0].0).sum::<u64>();
        let mut so_far = 0;
        for unit in 0..lists.len() {
            let is_found = extend(unit, 1, &mut good)?;
            if self.is_spent() {
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
            if let Some((worst, outline)) = self.check(&models, choice)? {
                let cost = entries.iter().map(|entry| entry.3).sum();
                let found = Found { models, lights: choice.clone(), cost, worst, outline };
                return Ok(Step::Found(rank.0, rank.1, Box::new(found)));
            }
            if self.is_spent() {
                return Ok(Step::Spent(rank.0));
            }
            for unit in 0..ranks.len() {
                let mut after = ranks.clone();
                after[unit] += 1;
                if extend(unit, after[unit] + 1, &mut good)? && seen.insert(after.clone()) {
                    queue.push(Reverse((key(&after, &good), after)));
                }
            }
        }
        Ok(Step::Nothing)
    }

    /// Whether a model of a unit keeps to the limits on the pixels that show nothing else.
    fn is_within_alone(&self, unit: usize, number: usize, choice: &LightChoice) -> Result<bool, PlanError> {
        let model = self.models[unit][number];
        if number == 0 && choice.iter().all(|&light| light == 0) {
            return Ok(true);
        }
        let key = (unit, number, choice.clone());
        if let Some(&known) = self.known.borrow().get(&key) {
            return Ok(known);
        }
        let mut is_within = !self.fails_at_witness(unit, &model, choice)?;
        for view in 0..self.views.len() {
            if !is_within {
                break;
            }
            is_within = self.is_within_view(view, unit, &model, choice)?;
        }
        self.refused.set(self.refused.get() + u64::from(!is_within));
        self.known.borrow_mut().insert(key, is_within);
        Ok(is_within)
    }

    /// Whether a model is beyond the tolerance at a pixel where others were: that takes a face, not a picture.
    fn fails_at_witness(
        &self,
        unit: usize,
        model: &ObjectModel,
        choice: &LightChoice,
    ) -> Result<bool, PlanError> {
        // With a share, one pixel refuses nothing.
        if self.limits.share > 0.0 {
            return Ok(false);
        }
        let key = (unit, model.segments);
        let list = self.witnesses.borrow().get(&key).cloned().unwrap_or_default();
        for (number, witness) in list.iter().enumerate() {
            let view = &self.views[witness.view];
            let lights = self.lights_of(view, choice);
            let at = (witness.face, witness.pixel);
            let colour = self.stage.colour_of_face((unit, model), &lights, &view.camera, at)?;
            self.count(1 << 12);
            if view.truth.steps_at(witness.pixel, colour) > self.limits.tolerance {
                if let Some(list) = self.witnesses.borrow_mut().get_mut(&key) {
                    list[..=number].rotate_right(1);
                }
                return Ok(true);
            }
        }
        Ok(false)
    }

    /// Remembers a pixel at which a model was refused.
    fn add_witness(
        &self,
        view: usize,
        unit: usize,
        model: &ObjectModel,
        pixel: [u32; 2],
    ) -> Result<(), PlanError> {
        let camera = &self.views[view].camera;
        let face = self.stage.face_at((unit, model), camera, pixel)?;
        if let Some(face) = face {
            let mut witnesses = self.witnesses.borrow_mut();
            let list = witnesses.entry((unit, model.segments)).or_default();
            list.insert(0, Witness { view, pixel, face });
            list.truncate(WITNESSES);
        }
        Ok(())
    }

    fn is_within_view(
        &self,
        number: usize,
        unit: usize,
        model: &ObjectModel,
        choice: &LightChoice,
    ) -> Result<bool, PlanError> {
        let view = &self.views[number];
        let lights = self.lights_of(view, choice);
        let picture = self.draw(&[(unit, *model)], &lights, view)?;
        let Some(shown) = &picture.objects else { return Ok(true) };
        let objects = self.stage.objects_of(unit);
        let samples = self.stage.settings.samples.count();
        let is_compared = |pixel: usize| {
            let object = view.object_of[pixel] as usize;
            objects.contains(&object) && shown[pixel] == Image::number_of(object - objects.start, samples)
        };
        let most = self.most_beyond(view);
        let difference = view.truth.difference(&picture, self.limits.tolerance, most, is_compared);
        if difference.beyond > most {
            self.add_witness(number, unit, model, difference.pixel)?;
            return Ok(false);
        }
        if model.segments == self.stage.units[unit].reference.segments {
            return Ok(true);
        }
        Ok(self.outline(view, unit, &picture)? <= self.limits.outline)
    }

    /// The distance of a unit's outline from that of the reference, both alone.
    fn outline(&self, view: &View, unit: usize, picture: &Image) -> Result<f64, PlanError> {
        let mut alone = view.alone[unit].borrow_mut();
        if alone.is_none() {
            *alone = Some(self.draw(&[(unit, self.stage.units[unit].reference)], &view.lights, view)?);
        }
        let Some(truth) = &*alone else { return Ok(0.0) };
        match outline_distance(picture, truth, &self.stage.settings) {
            Ok(distance) => Ok(distance),
            // Nothing is left of it, or nothing was there.
            Err(crate::metric::MetricError::Empty) => Ok(f64::INFINITY),
            Err(error) => Err(error.into()),
        }
    }

    fn most_beyond(&self, view: &View) -> u64 {
        (self.limits.share * view.covered as f64) as u64
    }

    fn draw(
        &self,
        models: &[(usize, ObjectModel)],
        lights: &[Light],
        view: &View,
    ) -> Result<Image, PlanError> {
        let [width, height] = self.stage.settings.size.map(u64::from);
        self.count(width * height);
        self.stage.draw(models, lights, &view.camera)
    }

    /// Counts drawn pixels.
    fn count(&self, pixels: u64) {
        self.drawn.set(self.drawn.get() + pixels);
        (self.progress)((self.drawn.get() as f64 / self.limits.budget.max(1) as f64).min(1.0));
    }

    /// The largest difference of a whole plan with its view, and the largest distance of outlines; `None` if it is not within the limits.
    pub fn check(
        &self,
        models: &[ObjectModel],
        choice: &LightChoice,
    ) -> Result<Option<((Difference, usize), f64)>, PlanError> {
        let (mut worst, mut outline) = ((Difference::default(), 0), 0.0_f64);
        for (number, view) in self.views.iter().enumerate() {
            let (difference, distance) = self.measure(view, models, choice)?;
            if difference.beyond > self.most_beyond(view) || distance > self.limits.outline {
                return Ok(None);
            }
            if difference.steps > worst.0.steps {
                worst = (difference, number);
            }
            outline = outline.max(distance);
        }
        Ok(Some((worst, outline)))
    }

    /// The difference of a plan in a view, and the distance of outlines of units.
    pub fn measure(
        &self,
        view: &View,
        models: &[ObjectModel],
        choice: &LightChoice,
    ) -> Result<(Difference, f64), PlanError> {
        let lights = self.lights_of(view, choice);
        let all: Vec<_> = models.iter().copied().enumerate().collect();
        let picture = self.draw(&all, &lights, view)?;
        let (Some(truth), Some(shown)) = (&view.truth.image.objects, &picture.objects) else {
            return Ok(Default::default());
        };
        let is_compared = |pixel: usize| truth[pixel] == shown[pixel];
        let difference = view.truth.difference(&picture, self.limits.tolerance, u64::MAX, is_compared);
        let mut outline = 0.0_f64;
        for (unit, model) in models.iter().enumerate() {
            if model.segments != self.stage.units[unit].reference.segments {
                let alone = self.draw(&[(unit, *model)], &lights, view)?;
                outline = outline.max(self.outline(view, unit, &alone)?);
            }
        }
        Ok((difference, outline))
    }
}

enum Step {
    Found(u64, u32, Box<Found>),
    Nothing,
    /// The budget is used up; no plan under these lights costs less than this.
    Spent(u64),
}
