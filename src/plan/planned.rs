//! The plan of a scene file: views, search and verification.

use super::apply::{FileModels, name_storage};
use super::axes::{Axis, LightModel, ObjectModel};
use super::compare::Difference;
use super::cost::Minimise;
use super::decisions::{Described, Plan};
use super::document::Document;
use super::lights::{bound_combinations, replacements};
use super::models::models_of;
use super::search::Search;
use super::stage::{PlanError, Stage};
use super::trials::{Limits, Trials, View};
use super::views::around;
use crate::raster::{Camera, LoadOptions, SceneFile, default_lights};
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
    /// Change only what the mesh files of objects hold, as [`apply`](super::apply()) writes them: normals and their storage, which the
    /// scene has to [state](super::with_stored_normals).
    pub for_files: bool,
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
            for_files: false,
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
    progress: &dyn Fn(f64),
) -> Result<Plan, PlanError> {
    options.check()?;
    // Errors of the text have lines if the reader of scenes finds them.
    let whole = SceneFile::from_toml(text, base, load)?;
    let document =
        Document::parse(text).map_err(|error| PlanError::Invalid(error.to_string()))?.with_tables();
    let stage = Stage::new(&document, &whole, base, load)?;
    let camera = whole.scene().camera;
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
    let pixels = stage.settings.size.iter().map(|&side| u64::from(side)).product::<u64>();
    if pixels * (cameras.len() + held_out.len()) as u64 > MOST_PIXELS {
        let found =
            format!("{} pictures of {pixels} pixels are too many to keep", cameras.len() + held_out.len());
        return Err(PlanError::Invalid(format!("{found}; use fewer views or a smaller size")));
    }
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
        let mut plan = scene.describe(&search, &outcome)?;
        plan.held_out = worst.map(|(difference, _)| difference);
        plan.repairs = repairs;
        if files.is_some() {
            name_storage(&mut plan.decisions, &stage.units);
        }
        if is_bounded {
            (plan.proven, plan.is_cheapest) = (0, false);
        }
        return Ok(plan);
    }
}
