//! Warnings about what a format cannot store: features of meshes, and the precision of positions.

use super::{Note, Part, Place};
use crate::mesh::{Columns, Mesh, Storage};
use glam::DVec3;
use rayon::prelude::*;

/// Something that a mesh may have and a format may not.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Feature {
    Uvs,
    Colors,
    Materials,
    Objects,
    Smoothing,
    HardEdges,
    MorphTargets,
    Points,
    Lines,
}

impl Feature {
    /// Its name, and whether a mesh with these columns has it.
    fn inspect(self, columns: &Columns) -> (&'static str, bool) {
        match self {
            Feature::Uvs => ("texture coordinates", columns.uvs.is_some()),
            Feature::Colors => ("colours", columns.colors.is_some()),
            Feature::Materials => ("materials", columns.materials.is_some()),
            Feature::Objects => ("objects and groups", columns.objects.is_some()),
            Feature::Smoothing => ("smoothing groups", columns.smoothing.is_some()),
            Feature::HardEdges => ("marks of hard edges", !columns.hard_edges.is_empty()),
            Feature::MorphTargets => ("morph targets", !columns.morph_targets.is_empty()),
            Feature::Points => ("points", !columns.points.is_empty()),
            Feature::Lines => ("lines", !columns.lines.is_empty()),
        }
    }
}

/// A warning for each of the features that the format does not have and a part does.
pub(super) fn unsupported_notes(format: &str, features: &[Feature], parts: &[Part]) -> Vec<Note> {
    let warning = |feature: &Feature| {
        let mut inspected = parts.iter().map(|part| feature.inspect(part.mesh.columns()));
        let (name, _) = inspected.find(|&(_, is_present)| is_present)?;
        Some(Note::warning(Place::File, format!("{format} has no {name}: they were left out")))
    };
    features.iter().filter_map(warning).collect()
}

/// Whether any position of a mesh is not an `f32`.
pub(super) fn needs_f64(mesh: &Mesh) -> bool {
    let is_rounded = |p: &DVec3| p.as_vec3().as_dvec3() != *p;
    mesh.storage() == Storage::F64 && mesh.positions().iter().any(is_rounded)
}

/// A warning if rounding to `f32` moves vertices far compared with the size of the model. Around the origin it moves them by at
/// most 2⁻²⁵ of the size; far from the origin, or near the smallest numbers, it can destroy the shape.
pub(super) fn displacement_note(mesh: &Mesh) -> Option<Note> {
    if mesh.storage() != Storage::F64 {
        return None;
    }
    let moved = mesh.positions().par_iter().map(|p| p.distance(p.as_vec3().as_dvec3()));
    let largest = moved.reduce(|| 0.0, f64::max);
    let size = mesh.bounds().map_or(0.0, |(low, high)| low.distance(high));
    (size > 0.0 && largest > size / f64::from(1 << 20)).then(|| {
        let text = format!(
            "rounding positions to 32-bit floats moves vertices by up to {largest:.3e}, {:.1e} of the model's size; \
             move it nearer to the origin, or write PLY or OBJ",
            largest / size
        );
        Note::warning(Place::File, text)
    })
}
