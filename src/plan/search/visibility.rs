//! Pixels that show a unit in every plan that gives it these cells. Coarser surfaces reach less far, or farther where they are hollow, so that
//! another object may come in front of them or vanish from there.

use super::trials::Trials;
use crate::plan::axes::{Cells, ObjectModel};
use crate::plan::stage::PlanError;
use crate::plan::views::View;
use crate::raster::Image;
use std::rc::Rc;

/// Most pixels that are kept, a byte each. Beyond that all are drawn again when they are needed.
const MOST_PIXELS: usize = 1 << 28;

impl Trials<'_> {
    /// Whether a pixel shows the same object of a unit as the reference, in a picture with some objects before those of the unit.
    pub(super) fn shows_unit(
        &self,
        view: &View,
        (unit, before): (usize, usize),
        shown: &[u32],
        pixel: usize,
    ) -> bool {
        let object = view.object_of[pixel] as usize;
        let objects = self.stage.objects_of(unit);
        let samples = self.stage.settings.samples.count();
        objects.contains(&object)
            && shown[pixel] == Image::number_of(before + object - objects.start, samples)
    }

    /// Pixels of a view that show nothing but a unit in every plan that gives it these cells; `None` if these are the pixels of the reference.
    ///
    /// # Errors
    /// What makes a picture impossible.
    pub(super) fn lasting_pixels(
        &self,
        number: usize,
        unit: usize,
        cells: Cells,
    ) -> Result<Option<Rc<[bool]>>, PlanError> {
        let reference = |unit: usize| self.stage.units[unit].reference;
        let others = (0..self.stage.units.len()).filter(|&other| other != unit);
        let (fixed, variable): (Vec<usize>, Vec<usize>) =
            others.partition(|&other| self.cells[other].len() == 1);
        let is_reference = cells == reference(unit).segments;
        if is_reference && variable.is_empty() {
            return Ok(None);
        }
        if let Some(known) = self.lasting.borrow().get(&(number, unit, cells)) {
            return Ok(Some(known.clone()));
        }
        let own = (unit, ObjectModel { segments: cells, ..reference(unit) });
        let mut pictures = Vec::new();
        if !is_reference {
            pictures.push(
                [own].into_iter().chain(fixed.iter().map(|&other| (other, reference(other)))).collect(),
            );
        }
        for &other in &variable {
            let model = |&segments: &Cells| (other, ObjectModel { segments, ..reference(other) });
            let changed = |it: &(usize, ObjectModel)| !is_reference || it.1 != reference(other);
            pictures.extend(self.cells[other].iter().map(model).filter(changed).map(|it| vec![own, it]));
        }
        let view = &self.views[number];
        let mut pixels = vec![true; view.object_of.len()];
        for mut models in pictures {
            models.sort_unstable_by_key(|it: &(usize, ObjectModel)| it.0);
            let earlier = models.iter().take_while(|it| it.0 < unit);
            let before = earlier.map(|it| self.stage.objects_of(it.0).len()).sum();
            let picture = self.draw(&models, &[], view)?;
            let shown = picture.objects.as_deref().unwrap_or_default();
            for (pixel, lasts) in pixels.iter_mut().enumerate() {
                *lasts &= self.shows_unit(view, (unit, before), shown, pixel);
            }
        }
        let pixels: Rc<[bool]> = pixels.into();
        let mut known = self.lasting.borrow_mut();
        if known.len() * pixels.len() >= MOST_PIXELS {
            known.clear();
        }
        known.insert((number, unit, cells), pixels.clone());
        Ok(Some(pixels))
    }
}
