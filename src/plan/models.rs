//! The models that an object may have.

use super::axes::{Axis, Cells, Normals, ObjectModel, Source, Terms};
use super::stage::Stage;
use super::unit::Unit;
use crate::normals::{Precision, Weight};
use crate::raster::{Interpolation, Shading, StoredFormat};
use crate::shade::Reflection;
use std::collections::HashSet;

/// The models that a unit may have: the reference first, then all combinations of cheaper values.
pub fn models_of(stage: &Stage, unit: usize, is_open: &dyn Fn(Axis) -> bool) -> Vec<ObjectModel> {
    let it = &stage.units[unit];
    let reference = it.reference;
    if it.is_kept || reference.shading == Shading::Wireframe {
        return vec![reference];
    }
    let mut models = vec![reference];
    // Each axis multiplies the models so far.
    let mut extend = |axis: Axis, values: &dyn Fn(&ObjectModel) -> Vec<ObjectModel>| {
        if is_open(axis) {
            let more: Vec<ObjectModel> = models.iter().flat_map(values).collect();
            models.extend(more);
        }
    };
    if it.is_cast {
        extend(Axis::Reflection, &|model| {
            terms(it).into_iter().map(|terms| ObjectModel { terms, ..*model }).collect()
        });
        return models;
    }
    extend(Axis::Tessellation, &|model| {
        let mut list = Vec::new();
        let mut segments = reference.segments;
        while let Some([u, v]) =
            segments.map(|[u, v]| [u * 3 / 4, v * 3 / 4]).filter(|[u, v]| *u >= 4 && *v >= 3)
        {
            segments = Some([u, v]);
            list.push(ObjectModel { segments, ..*model });
        }
        list
    });
    extend(Axis::Reflection, &|model| {
        terms(it).into_iter().map(|terms| ObjectModel { terms, ..*model }).collect()
    });
    extend(Axis::TwoSided, &|model| {
        if model.two_sided { vec![ObjectModel { two_sided: false, ..*model }] } else { Vec::new() }
    });
    extend(Axis::Interpolation, &|model| {
        let is_open = model.interpolation == Interpolation::Perspective && model.normals.is_some();
        is_open
            .then_some(ObjectModel { interpolation: Interpolation::Affine, ..*model })
            .into_iter()
            .collect()
    });
    let with = |model: &ObjectModel, change: &dyn Fn(Normals) -> Option<Normals>| {
        model.normals.and_then(change).map(|normals| ObjectModel { normals: Some(normals), ..*model })
    };
    extend(Axis::Weight, &|model| {
        let weights = model.normals.map_or(&[][..], |normals| cheaper_weights(normals.source));
        let computed =
            |&weight| with(model, &|normals| Some(Normals { source: Source::Computed(weight), ..normals }));
        weights.iter().filter_map(computed).collect()
    });
    extend(Axis::Creases, &|model| {
        let is_split = it.has_splits
            && model.normals.is_some_and(|normals| matches!(normals.source, Source::Computed(_)));
        let none = |normals| is_split.then_some(Normals { creases: false, ..normals });
        with(model, &none).into_iter().collect()
    });
    extend(Axis::Precision, &|model| {
        let fast = |normals: Normals| {
            let is_open = normals.precision == Precision::Faithful
                && matches!(normals.source, Source::Computed(weight) if !weight.is_fit());
            is_open.then_some(Normals { precision: Precision::Fast, ..normals })
        };
        with(model, &fast).into_iter().collect()
    });
    extend(Axis::Storage, &|model| {
        let formats = StoredFormat::ALL.iter().filter(|&&format| {
            let bytes = |format: StoredFormat| format.encoding().bytes();
            let old = model.normals.and_then(|normals| normals.format).map_or(12, bytes);
            bytes(format) < old
        });
        formats
            .filter_map(|&format| with(model, &|normals| Some(Normals { format: Some(format), ..normals })))
            .collect()
    });
    extend(Axis::Merging, &|model| {
        let is_open = it.can_merge && !model.merged;
        is_open.then_some(ObjectModel { merged: true, ..*model }).into_iter().collect()
    });
    extend(Axis::Shading, &|model| {
        let flat = ObjectModel {
            shading: Shading::Flat,
            normals: None,
            interpolation: reference.interpolation,
            ..*model
        };
        match model.shading {
            Shading::Phong => vec![ObjectModel { shading: Shading::Gouraud, ..*model }, flat],
            Shading::Gouraud => vec![flat],
            _ => Vec::new(),
        }
    });
    // Flat shading has no normals, so many combinations are the same.
    let mut seen = HashSet::new();
    models.retain(|model| seen.insert(*model));
    models
}

/// The cells that each unit may have.
pub fn cells_of(models: &[Vec<ObjectModel>]) -> Vec<Vec<Cells>> {
    let cells = |models: &Vec<ObjectModel>| {
        let mut list: Vec<Cells> = models.iter().map(|model| model.segments).collect();
        list.sort_unstable();
        list.dedup();
        list
    };
    models.iter().map(cells).collect()
}

/// The weights that cost less.
fn cheaper_weights(source: Source) -> &'static [Weight] {
    match source {
        Source::Given | Source::Computed(Weight::Uniform | Weight::Area) => &[],
        Source::Computed(weight) if weight.is_fit() => {
            &[Weight::Angle, Weight::Max, Weight::Edge, Weight::AngleArea, Weight::Uniform, Weight::Area]
        }
        Source::Computed(_) => &[Weight::Uniform, Weight::Area],
    }
}

/// The reductions of a unit's material.
fn terms(unit: &Unit) -> Vec<Terms> {
    let Some(material) = unit.material else { return Vec::new() };
    let has_highlight = material.specular.merged().largest() > 0.0;
    let mut terms = Vec::new();
    if has_highlight && material.reflection == Reflection::Phong {
        terms.push(Terms::Blinn);
    }
    if has_highlight {
        terms.push(Terms::Diffuse);
    }
    if material.diffuse.merged().largest() > 0.0 || has_highlight {
        terms.push(Terms::Ambient);
    }
    terms
}
