//! Pixels at which models were refused: most other models fail there too, and that takes a face to find out, not a picture.
//!
//! Light is a sum over lights. So the colour of such a pixel under any choice of lights follows from its colours under each light
//! alone, and a model fails under all choices at once if the smallest or the largest sum is beyond the tolerance.

use super::trials::Trials;
use super::witnesses::{Colours, Witness};
use crate::plan::axes::ObjectModel;
use crate::plan::compare::Metric;
use crate::plan::lights::LightChoice;
use crate::plan::stage::PlanError;
use std::cell::RefCell;
use std::rc::Rc;

/// Pixels of the tile that is drawn for a witness.
const TILE: u64 = 64 * 64;

/// Most witnesses of a unit with the same cells.
const MOST_WITNESSES: usize = 24;

/// Most models and witnesses whose colours are kept.
const MOST_COLOURS: usize = 1 << 17;

impl Trials<'_> {
    /// Whether there are choices of lights, and pixels refuse them. Colours are sums over lights before the tone rule, with any guards.
    pub fn adds_lights(&self) -> bool {
        self.refuses_by_pixels() && self.lights.iter().any(|models| models.len() > 1)
    }

    /// With a share, one pixel refuses nothing. ꟻLIP depends on all pixels.
    fn refuses_by_pixels(&self) -> bool {
        self.limits.share == 0.0 && self.limits.metric == Metric::Steps
    }

    /// The difference of a model at a pixel where others were beyond the tolerance; 0 if it is within the tolerance at all of them.
    pub(in crate::plan) fn error_at_witness(
        &self,
        (unit, number): (usize, usize),
        model: &ObjectModel,
        choice: &LightChoice,
    ) -> Result<f64, PlanError> {
        if self.adds_lights() {
            let allowed: Vec<Vec<usize>> = choice.iter().map(|&number| vec![number]).collect();
            return self.least_error((unit, number), model, &allowed);
        }
        if !self.refuses_by_pixels() {
            return Ok(0.0);
        }
        self.largest_of_witnesses(unit, model, |witness| {
            let view = &self.views[witness.view];
            let lights = self.lights_of(view, choice);
            let at = (witness.face, witness.pixel);
            let colour = self.stage.colour_of_face((unit, model), &lights, &view.camera, at)?;
            self.count_tile();
            Ok(view.truth.steps_at(witness.pixel, colour))
        })
    }

    /// The smallest difference of a model at a pixel under all choices of the `allowed` replacements of each light, if that is beyond the
    /// tolerance at some pixel; 0 otherwise.
    pub fn least_error(
        &self,
        (unit, number): (usize, usize),
        model: &ObjectModel,
        allowed: &[Vec<usize>],
    ) -> Result<f64, PlanError> {
        self.largest_of_witnesses(unit, model, |witness| {
            let colours = self.colours((unit, number), model, witness)?;
            let dark = colours.dark.map(f64::from);
            let (mut low, mut high, mut size) = (dark, dark, dark.map(f64::abs));
            for (light, numbers) in allowed.iter().enumerate() {
                let mut ends = [[f64::INFINITY; 3], [f64::NEG_INFINITY; 3]];
                for &replacement in numbers {
                    let lit = self.lit(&colours, (unit, model), witness, (light, replacement))?;
                    for (channel, (lit, dark)) in lit.into_iter().zip(dark).enumerate() {
                        let own = f64::from(lit) - dark;
                        ends[0][channel] = ends[0][channel].min(own);
                        ends[1][channel] = ends[1][channel].max(own);
                    }
                }
                for channel in 0..3 {
                    low[channel] += ends[0][channel];
                    high[channel] += ends[1][channel];
                    size[channel] += dark[channel].abs() + ends[0][channel].abs().max(ends[1][channel].abs());
                }
            }
            // Sums in single precision round each of their terms by 2⁻²⁴ at most; those of samples as well.
            let rounding = (allowed.len() + 20) as f64 * f64::from(f32::EPSILON);
            for channel in 0..3 {
                low[channel] -= rounding * size[channel];
                high[channel] += rounding * size[channel];
            }
            self.count(allowed.len() as u64);
            Ok(self.views[witness.view].truth.steps_between(witness.pixel, low, high))
        })
    }

    /// The first difference beyond the tolerance at the witnesses of a model; 0 if there is none.
    fn largest_of_witnesses(
        &self,
        unit: usize,
        model: &ObjectModel,
        error: impl Fn(&Witness) -> Result<f64, PlanError>,
    ) -> Result<f64, PlanError> {
        let key = (unit, model.segments);
        let list = self.witnesses.lists.borrow().get(&key).cloned().unwrap_or_default();
        for (at, witness) in list.iter().enumerate() {
            let steps = error(witness)?;
            if steps > self.limits.tolerance {
                if let Some(list) = self.witnesses.lists.borrow_mut().get_mut(&key) {
                    list[..=at].rotate_right(1);
                }
                return Ok(steps);
            }
        }
        Ok(0.0)
    }

    fn colours(
        &self,
        (unit, number): (usize, usize),
        model: &ObjectModel,
        witness: &Witness,
    ) -> Result<Rc<Colours>, PlanError> {
        let key = (unit, number, witness.number);
        if let Some(known) = self.witnesses.colours.borrow().get(&key) {
            return Ok(known.clone());
        }
        let view = &self.views[witness.view];
        let at = (witness.face, witness.pixel);
        let dark = self.stage.colour_of_face((unit, model), &[], &view.camera, at)?;
        self.count_tile();
        let lit = self.lights.iter().map(|models| vec![None; models.len()]).collect();
        let colours = Rc::new(Colours { dark, lit: RefCell::new(lit) });
        let mut known = self.witnesses.colours.borrow_mut();
        if known.len() >= MOST_COLOURS {
            known.clear();
        }
        known.insert(key, colours.clone());
        Ok(colours)
    }

    /// The colour under one replacement of a light alone.
    fn lit(
        &self,
        colours: &Colours,
        unit: (usize, &ObjectModel),
        witness: &Witness,
        (light, replacement): (usize, usize),
    ) -> Result<[f32; 3], PlanError> {
        let Some(model) = self.lights[light][replacement].0 else { return Ok(colours.dark) };
        if let Some(known) = colours.lit.borrow()[light][replacement] {
            return Ok(known);
        }
        let view = &self.views[witness.view];
        let at = (witness.face, witness.pixel);
        let colour = self.stage.colour_of_face(unit, &[view.turn.of(&model)], &view.camera, at)?;
        self.count_tile();
        colours.lit.borrow_mut()[light][replacement] = Some(colour);
        Ok(colour)
    }

    fn count_tile(&self) {
        self.count(self.pixels().min(TILE * self.stage.settings.samples.count() as u64));
    }

    /// Remembers a pixel at which a model was refused.
    pub(in crate::plan) fn add_witness(
        &self,
        view: usize,
        unit: usize,
        model: &ObjectModel,
        pixel: [u32; 2],
    ) -> Result<(), PlanError> {
        if !self.refuses_by_pixels() {
            return Ok(());
        }
        let at = pixel[1] as usize * self.stage.settings.size[0] as usize + pixel[0] as usize;
        if self.lasting_pixels(view, unit, model.segments)?.is_some_and(|lasting| !lasting[at]) {
            return Ok(());
        }
        let face = self.stage.face_at((unit, model), &self.views[view].camera, pixel)?;
        let mut lists = self.witnesses.lists.borrow_mut();
        let list = lists.entry((unit, model.segments)).or_default();
        let is_new = list.iter().all(|other| (other.view, other.pixel) != (view, pixel));
        if let (Some(face), true) = (face, is_new) {
            let number = self.witnesses.count();
            self.witnesses.count.set(number + 1);
            list.insert(0, Witness { number, view, pixel, face });
            list.truncate(MOST_WITNESSES);
        }
        Ok(())
    }
}
