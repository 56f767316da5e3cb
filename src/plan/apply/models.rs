//! The models of objects that their mesh files hold.

use super::file_objects::FileObject;
use crate::plan::axes::{Axis, ObjectModel};
use crate::plan::decisions::Decision;
use crate::plan::document::Document;
use crate::plan::models::models_of;
use crate::plan::stage::{PlanError, Stage};
use crate::plan::unit::Unit;
use crate::raster::{LoadOptions, Shading};
use std::path::Path;

/// The axes that mesh files hold. Flat shading is a storage: a glTF file without normals is flat.
pub const AXES_OF_FILES: [Axis; 4] = [Axis::Weight, Axis::Creases, Axis::Precision, Axis::Storage];

/// What may change in the mesh files of a scene.
pub struct FileModels {
    /// Whether an object may be without normals; `None` for objects that are no mesh file, which stay as declared.
    may_omit_normals: Vec<Option<bool>>,
}

impl FileModels {
    /// Reads the files of a scene.
    ///
    /// # Errors
    /// Unreadable files, and files of other formats than glTF.
    pub fn new(document: &Document, base: &Path, load: &LoadOptions) -> Result<Self, PlanError> {
        let may_omit = |number| {
            let object = FileObject::new(document, number, base, load)?;
            Ok(object.map(|object| object.may_omit_normals()))
        };
        let may_omit_normals = (0..document.objects()).map(may_omit).collect::<Result<_, PlanError>>()?;
        Ok(Self { may_omit_normals })
    }

    /// Whether files hold the values of an axis.
    pub fn may_change(&self, axis: Axis) -> bool {
        AXES_OF_FILES.contains(&axis)
    }

    /// The models that a unit may have: those of [`models_of`] whose normals are stored as glTF does, and flat shading without normals.
    pub fn models_of(&self, stage: &Stage, unit: usize, is_open: &dyn Fn(Axis) -> bool) -> Vec<ObjectModel> {
        let reference = stage.units[unit].reference;
        let Some(may_omit) = self.may_omit_normals[unit] else { return vec![reference] };
        let is_open = |axis| match axis {
            Axis::Shading => may_omit && is_open(Axis::Storage),
            axis => is_open(axis),
        };
        let mut models = models_of(stage, unit, &is_open);
        models.retain(|model| {
            let format = model.normals.and_then(|normals| normals.format);
            let is_stored = format.is_none_or(|format| format.in_gltf().is_some());
            is_stored && (model.shading == reference.shading || model.shading == Shading::Flat)
        });
        models
    }
}

/// Reports flat shading as the storage that it is in a file.
pub fn name_storage(decisions: &mut [Decision], units: &[Unit]) {
    for decision in decisions.iter_mut().filter(|decision| decision.axis == Axis::Shading) {
        decision.axis = Axis::Storage;
        decision.from = units[decision.number].reference.value(Axis::Storage);
        decision.to = "none".to_owned();
    }
}
