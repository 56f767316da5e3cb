//! The plan of a scene file: views, search and verification.

use super::apply::{FileModels, name_storage};
use super::axes::{Axis, LightModel, ObjectModel};
use super::bounds::{Ball, ModelBounds};
use super::compare::{Difference, Metric};
use super::decisions::{Described, Plan};
use super::document::Document;
use super::evidence::Evidence;
use super::lights::replacements;
use super::models::models_of;
use super::options::{End, PlanOptions, Progress};
use super::search::trials::{Counts, Limits, Trials};
use super::search::{Outcome, Search};
use super::stage::{PlanError, Stage};
use super::views::{Place, Turn, View, around};
use crate::num::Degrees;
use crate::raster::{Camera, LoadOptions, Samples, SceneFile, Shading, default_lights};
use glam::DVec3;
use std::path::Path;
use std::time::{Duration, Instant};

/// Most models of all objects together: 64 bytes each.
const MOST_MODELS: usize = 1 << 23;

/// Most pixels of the reference in all views: some 60 bytes each.
const MOST_PIXELS: u64 = 1 << 26;

/// Finds the cheapest model of a scene within a tolerance. `base` is the folder of the scene file.
///
/// # Errors
/// An unreadable scene, one that cannot be drawn, or options that make no sense for it.
pub fn plan(
    text: &str,
    base: &Path,
    load: &LoadOptions,
    options: &PlanOptions,
    progress: &dyn Fn(Progress),
) -> Result<Plan, PlanError> {
    Ok(find((text, base, load), options, progress, false)?.0)
}

/// As [`plan`], with the pictures for a page.
///
/// # Errors
/// As [`plan`].
pub fn plan_with_evidence(
    text: &str,
    base: &Path,
    load: &LoadOptions,
    options: &PlanOptions,
    progress: &dyn Fn(Progress),
) -> Result<(Plan, Evidence), PlanError> {
    let (plan, evidence) = find((text, base, load), options, progress, true)?;
    let missing = || PlanError::Invalid("no plan was found".to_owned());
    Ok((plan, evidence.ok_or_else(missing)?))
}

/// A plan, and its evidence if it is wanted.
fn find(
    (text, base, load): (&str, &Path, &LoadOptions),
    options: &PlanOptions,
    progress: &dyn Fn(Progress),
    wants_evidence: bool,
) -> Result<(Plan, Option<Evidence>), PlanError> {
    options.check()?;
    // Errors of the text have lines if the reader of scenes finds them.
    let whole = SceneFile::from_toml(text, base, load)?;
    if whole.settings.shading == Shading::Traced {
        // Models are compared object by object, and shadows and mirrors are not of one object.
        let found =
            "a traced picture has no cheaper model; give `shading = \"phong\"` to plan its local light";
        return Err(PlanError::Invalid(found.into()));
    }
    let document =
        Document::parse(text).map_err(|error| PlanError::Invalid(error.to_string()))?.with_tables();
    let stage = Stage::new(&document, &whole, base, load)?;
    let (low, high) = whole.scene().bounds().unwrap_or_default();
    let (middle, radius) = (low.midpoint(high), 0.5 * low.distance(high));
    let files = options.for_files.then(|| FileModels::new(&document, base, load)).transpose()?;
    let is_open = |axis: Axis| {
        !options.keep.contains(&axis) && files.as_ref().is_none_or(|files| files.may_change(axis))
    };
    let models: Vec<Vec<ObjectModel>> = (0..stage.units.len())
        .map(|unit| match &files {
            Some(files) => files.models_of(&stage, unit, &is_open),
            None => models_of(&stage, unit, &is_open),
        })
        .collect();
    if models.iter().map(Vec::len).sum::<usize>() > MOST_MODELS {
        let found = format!(
            "{} objects have too many models together; allow fewer axes with --only or --keep",
            models.len()
        );
        return Err(PlanError::Invalid(found));
    }
    let lights = light_models(&whole, middle, is_open(Axis::Lights));
    let (mut views, mut waiting) = views_of(&stage, &whole, options, middle)?;
    let declared = stage.settings.samples;
    let fewer =
        [Samples::Four, Samples::One].into_iter().filter(|samples| samples.count() < declared.count());
    let fewer = fewer.filter(|_| options.allow_antialiasing);
    let stages: Vec<Stage> = [declared].into_iter().chain(fewer).map(|it| stage.with_samples(it)).collect();
    let counts = Counts::default();
    let deadline = options.seconds.map(|seconds| Instant::now() + Duration::from_secs_f64(seconds));
    let mut repairs = 0;
    loop {
        let limits = limits_of(options, counts.drawn.get(), deadline, !waiting.is_empty());
        let trials = |stage| {
            // No bound covers outlines, which move with other samples, or ꟻLIP.
            let cone = options.light_cone.into();
            let bounds = ModelBounds::new(stage, &views, &lights, Ball { middle, radius }, cone);
            let holds = stage.settings.samples == declared && options.metric == Metric::Steps;
            let bounds = bounds.filter(|_| holds);
            Trials::new(stage, &views, &lights, limits, bounds, &counts, progress)
        };
        let search = |stage| Search::new(trials(stage), &models, options.minimise);
        let searches: Vec<Search> = stages.iter().map(search).collect();
        let (best, outcome) = cheapest(&searches)?;
        let (worst, failing) = verify(&searches[best].trials, &waiting, &outcome)?;
        if let Some(number) = failing {
            repairs += 1;
            drop(searches);
            views.push(waiting.swap_remove(number));
            continue;
        }
        let described = Described {
            stage: &stage,
            document: &document,
            lights: &lights,
            whole: &whole,
            declared: &searches[0],
        };
        let mut plan = described.describe(&searches[best], &outcome)?;
        (plan.held_out, plan.held_out_place) = worst.unzip();
        plan.repairs = repairs;
        if files.is_some() {
            name_storage(&mut plan.decisions, &stage.units);
        }
        let found = outcome.found.as_ref().filter(|_| wants_evidence);
        let share = |planned: u64, declared: u64| planned as f64 / declared.max(1) as f64;
        let cost = share(plan.planned.of(options.minimise), plan.declared.of(options.minimise));
        progress(Progress { share: 1.0, best: cost });
        let evidence = found.map(|found| described.evidence(&searches[best], found, &plan)).transpose()?;
        return Ok((plan, evidence));
    }
}

/// What the next search keeps to. If views may refuse its plan, it has half of the pixels and of the time that are left, so that there
/// is another search.
fn limits_of(options: &PlanOptions, drawn: u64, deadline: Option<Instant>, may_be_refused: bool) -> Limits {
    let left = options.budget.saturating_sub(drawn);
    let parts = if may_be_refused { 2 } else { 1 };
    let now = Instant::now();
    Limits {
        metric: options.metric,
        tolerance: options.tolerance,
        share: options.share,
        outline: options.outline,
        budget: options.budget,
        end: drawn.saturating_add(left / parts),
        deadline: deadline.map(|end| now + end.saturating_duration_since(now) / parts as u32),
        seconds: options.seconds.unwrap_or(f64::INFINITY),
    }
}

/// What may replace each declared light.
fn light_models(whole: &SceneFile, middle: DVec3, is_open: bool) -> Vec<Vec<LightModel>> {
    let models = |(number, light)| match is_open && !whole.kept_lights.contains(&number) {
        true => replacements(light, middle),
        false => vec![LightModel(Some(*light))],
    };
    whole.lights.iter().flatten().enumerate().map(models).collect()
}

/// The views that a plan is found with, and those that verify it.
fn views_of(
    stage: &Stage,
    whole: &SceneFile,
    options: &PlanOptions,
    middle: DVec3,
) -> Result<(Vec<View>, Vec<View>), PlanError> {
    let camera = whole.scene().camera;
    let cone: Degrees = options.light_cone;
    let turns = Turn::sampled(cone, middle);
    let others = if cone.0 > 0.0 { Turn::held_out(cone, middle) } else { turns.clone() };
    let (cameras, between) = match options.views {
        Some(count) => (around(&camera, count.max(1), 0.0), around(&camera, count.max(1), 0.5)),
        None if cone.0 > 0.0 => (vec![camera], vec![camera]),
        None => (vec![camera], Vec::new()),
    };
    let count = cameras.len() * turns.len() + between.len() * others.len();
    let pixels = stage.settings.size.iter().map(|&side| u64::from(side)).product::<u64>();
    if pixels * count as u64 > MOST_PIXELS {
        let found = format!("{count} pictures of {pixels} pixels are too many to keep");
        return Err(PlanError::Invalid(format!("{found}; use fewer views or a smaller size")));
    }
    let views = |cameras: &[Camera], turns: &[Turn]| {
        let pairs = cameras.iter().flat_map(|camera| turns.iter().map(move |turn| (*camera, *turn)));
        pairs
            .map(|(camera, turn)| {
                let lights = whole.lights.clone().unwrap_or_else(|| default_lights(&camera).to_vec());
                View::new(stage, camera, &lights, turn)
            })
            .collect::<Result<Vec<View>, PlanError>>()
    };
    let found_with = views(&cameras, &turns)?;
    if found_with.iter().all(|view| view.truth.image.statistics.covered_pixels == 0) {
        return Err(PlanError::Invalid("no view shows any object; move the camera, or omit it".to_owned()));
    }
    Ok((found_with, views(&between, &others)?))
}

/// The cheapest plan of several searches, with the number of its search. The first one has the reference.
fn cheapest(searches: &[Search]) -> Result<(usize, Outcome), PlanError> {
    let (mut best, mut outcome) = (0, searches[0].run(None)?);
    for (number, search) in searches.iter().enumerate().skip(1) {
        let next = search.run(outcome.found.as_ref())?;
        if next.found.is_some() {
            (best, outcome.found) = (number, next.found);
        }
        outcome.proven = outcome.proven.min(next.proven);
        outcome.combinations = (outcome.combinations + next.combinations).min(f64::MAX);
        if outcome.end == End::Proven {
            outcome.end = next.end;
        }
        (outcome.refused, outcome.drawn) = (next.refused, next.drawn);
    }
    Ok((best, outcome))
}

/// The difference in a view that a plan was not found with, and the view.
type Held = (Difference, Place);

/// The largest difference of a plan in views that it was not found with, and the number of the worst view that is beyond the limits.
fn verify(
    trials: &Trials,
    views: &[View],
    outcome: &Outcome,
) -> Result<(Option<Held>, Option<usize>), PlanError> {
    let metric = trials.limits.metric;
    let mut largest: Option<Held> = None;
    let mut failing: Option<(f64, usize)> = None;
    for (number, view) in views.iter().enumerate() {
        let Some(found) = &outcome.found else { continue };
        let (difference, outline) = trials.measure(view, &found.models, &found.lights)?;
        let size = difference.by(metric);
        if largest.is_none_or(|(other, _)| size > other.by(metric)) {
            largest = Some((difference, view.place()));
        }
        if !trials.limits.accept(view, &difference, outline) && failing.is_none_or(|(other, _)| size > other)
        {
            failing = Some((size, number));
        }
    }
    Ok((largest, failing.map(|(_, number)| number)))
}
