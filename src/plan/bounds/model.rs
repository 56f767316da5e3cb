//! Bounds on the error of a model of an object under cheaper lights.

use super::lights::Ball;
use super::shading::{Setting, Shift};
use super::spread::{Spread, angle_between_normals, depth_share};
use crate::num::Radians;
use crate::plan::axes::{LightModel, Normals, ObjectModel, Terms};
use crate::plan::document::with_terms;
use crate::plan::lights::LightChoice;
use crate::plan::stage::Stage;
use crate::plan::views::View;
use crate::raster::{FlatSample, Interpolation, Shading, StoredFormat};
use crate::shade::{Light, Material};
use std::cell::{OnceCell, RefCell};
use std::collections::HashMap;

/// The variation within the faces of a unit, and the share of weights that affine interpolation moves.
type Variation = (Spread, Option<f64>);

/// The bounds of a scene's models in all views.
pub struct ModelBounds<'a> {
    stage: &'a Stage<'a>,
    views: &'a [View],
    lights: &'a [Vec<LightModel>],
    setting: Setting<'a>,
    spreads: Vec<OnceCell<Option<Variation>>>,
    /// Angles between normals of a unit as declared and others, before these are stored.
    angles: RefCell<HashMap<(usize, Normals), Option<f64>>>,
}

impl<'a> ModelBounds<'a> {
    /// `None` if no bound holds for the scene.
    pub fn new(
        stage: &'a Stage<'a>,
        views: &'a [View],
        lights: &'a [Vec<LightModel>],
        ball: Ball,
        cone: Radians,
    ) -> Option<Self> {
        let cameras = views.iter().map(|view| view.camera).collect();
        let setting = Setting::new(&stage.settings, cameras, ball, cone)?;
        let spreads = stage.units.iter().map(|_| OnceCell::new()).collect();
        let is_centroid = stage.settings.flat_sample == FlatSample::Centroid;
        is_centroid.then(|| Self { stage, views, lights, setting, spreads, angles: RefCell::default() })
    }

    /// The bound on the difference of a model under a choice of lights from the reference, in steps; `None` without one below 255.
    pub fn model(&self, unit: usize, model: &ObjectModel, choice: &LightChoice) -> Option<f64> {
        let reference = &self.stage.units[unit].reference;
        if model.terms == reference.terms
            && choice.iter().all(|&number| number == 0)
            && self.has_same_picture(unit, model)
        {
            return Some(0.0);
        }
        let material = self.stage.units[unit].material?;
        let mut most = 0.0_f64;
        // Default lights follow the camera, declared ones are the same in all views.
        let count = if self.lights.is_empty() { self.views.len() } else { 1 };
        for view in &self.views[..count] {
            let declared: Vec<Light> = match self.lights {
                [] => view.lights.clone(),
                lights => lights.iter().filter_map(|models| models[0].0).collect(),
            };
            let lights: Vec<Light> = match self.lights {
                [] => declared.clone(),
                lights => {
                    lights.iter().zip(choice).filter_map(|(models, &number)| models[number].0).collect()
                }
            };
            let mut error = self.setting.without_terms(&material, &declared, model.terms)?;
            let material = match model.terms {
                Terms::Declared => material,
                terms => with_terms(&material, terms),
            };
            for (models, &number) in self.lights.iter().zip(choice).filter(|(_, number)| **number > 0) {
                error += self.setting.replaced(&material, &models[0].0?, models[number].0.as_ref())?;
            }
            error += self.of_geometry(unit, model, &material, &lights)?;
            error += self.setting.rounding(&material, &lights)?;
            most = most.max(error);
        }
        // A bound of all steps is none.
        Some(self.setting.steps(most)).filter(|&steps| steps < 255.0)
    }

    /// The bound on the light of other normals and another shading.
    fn of_geometry(
        &self,
        unit: usize,
        model: &ObjectModel,
        material: &Material,
        lights: &[Light],
    ) -> Option<f64> {
        let reference = &self.stage.units[unit].reference;
        if self.has_same_picture(unit, model) {
            return Some(0.0);
        }
        if self.has_other_sides(unit, model) || model.segments != reference.segments {
            return None;
        }
        let shifted = |normal, position| self.setting.shifted(material, lights, Shift { normal, position });
        let (spread, share) = self.spread(unit)?;
        let share = match (reference.interpolation, model.interpolation) {
            (old, new) if old == new => 0.0,
            (Interpolation::Perspective, Interpolation::Affine) => share?,
            _ => return None,
        };
        match (reference.shading, model.shading) {
            (Shading::Phong | Shading::Gouraud, Shading::Flat) => shifted(spread.from_face, spread.extent),
            (Shading::Phong, Shading::Gouraud) => {
                shifted(spread.corners + self.normals_off(unit, model)?, spread.extent)
            }
            (Shading::Gouraud, Shading::Gouraud) => {
                let of_weights =
                    if share > 0.0 { share * shifted(spread.corners, spread.extent)? } else { 0.0 };
                Some(shifted(self.normals_off(unit, model)?, 0.0)? + of_weights)
            }
            (Shading::Phong, Shading::Phong) => {
                // Means of normals that are this far from the right ones have directions that are off by at most the arc sine.
                let chord = |angle: f64| 2.0 * libm::sin(0.5 * angle);
                let off = chord(self.normals_off(unit, model)?) + share * chord(spread.corners);
                let angle = (off < spread.shortest).then(|| libm::asin(off / spread.shortest))?;
                shifted(angle, share * spread.extent)
            }
            _ => None,
        }
    }

    /// Whether a model has the normals and the shading of the reference, to the bit, wherever it is seen. Merged vertices keep the values of
    /// all corners.
    fn has_same_picture(&self, unit: usize, model: &ObjectModel) -> bool {
        let geometry =
            |model: &ObjectModel| (model.shading, model.normals, model.interpolation, model.segments);
        geometry(model) == geometry(&self.stage.units[unit].reference) && !self.has_other_sides(unit, model)
    }

    /// Whether rear faces are seen, and lit on another side.
    fn has_other_sides(&self, unit: usize, model: &ObjectModel) -> bool {
        model.two_sided != self.stage.units[unit].reference.two_sided
            && self.views.iter().any(|view| view.shows_rear[unit])
    }

    fn spread(&self, unit: usize) -> Option<Variation> {
        *self.spreads[unit].get_or_init(|| {
            let declared = &self.stage.units[unit].declared;
            let cameras: Vec<_> = self.views.iter().map(|view| view.camera).collect();
            Some((Spread::of(declared)?, depth_share(declared, &cameras)))
        })
    }

    /// The distance of a light in radii of the scene, and the largest angle by which a directional light in its place is off.
    pub fn lamp(&self, old: &Light, new: &Light) -> Option<(f64, f64)> {
        matches!(new, Light::Directional { .. }).then(|| self.setting.lamp(old))?
    }

    /// The largest angle between stored normals of a model and those of the reference; `None` if a model has none, or other corners.
    pub fn normals_off(&self, unit: usize, model: &ObjectModel) -> Option<f64> {
        let reference = self.stage.units[unit].reference;
        if model.segments != reference.segments || model.normals == reference.normals {
            return (model.segments == reference.segments).then_some(0.0);
        }
        let declared = reference.normals?;
        let normals = model.normals?;
        let unrounded = Normals { format: declared.format, ..normals };
        let known = self.angles.borrow().get(&(unit, unrounded)).copied();
        let between = match known {
            Some(known) => known,
            None => {
                let model = ObjectModel { normals: Some(unrounded), ..self.stage.units[unit].reference };
                let file = self.stage.geometry(unit, &model).ok()?;
                let angle = angle_between_normals(&self.stage.units[unit].declared, &file);
                *self.angles.borrow_mut().entry((unit, unrounded)).or_insert(angle)
            }
        };
        let worst = |format: StoredFormat| format.worst_angle().0;
        let stored = match normals.format == declared.format {
            true => 0.0,
            false => [normals.format, declared.format].into_iter().flatten().map(worst).sum(),
        };
        Some(between? + stored)
    }
}
