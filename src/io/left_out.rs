//! What a format cannot hold.

use super::{Note, Part, Place};
use crate::mesh::Columns;

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
    fn name(self) -> &'static str {
        match self {
            Feature::Uvs => "texture coordinates",
            Feature::Colors => "colours",
            Feature::Materials => "materials",
            Feature::Objects => "objects and groups",
            Feature::Smoothing => "smoothing groups",
            Feature::HardEdges => "marks of hard edges",
            Feature::MorphTargets => "morph targets",
            Feature::Points => "points",
            Feature::Lines => "lines",
        }
    }

    fn is_in(self, columns: &Columns) -> bool {
        match self {
            Feature::Uvs => columns.uvs.is_some(),
            Feature::Colors => columns.colors.is_some(),
            Feature::Materials => columns.materials.is_some(),
            Feature::Objects => columns.objects.is_some(),
            Feature::Smoothing => columns.smoothing.is_some(),
            Feature::HardEdges => !columns.hard_edges.is_empty(),
            Feature::MorphTargets => !columns.morph_targets.is_empty(),
            Feature::Points => !columns.points.is_empty(),
            Feature::Lines => !columns.lines.is_empty(),
        }
    }
}

/// A warning for each of the features that the format does not have and a part does.
pub(super) fn left_out(format: &str, features: &[Feature], parts: &[Part]) -> Vec<Note> {
    let is_lost = |feature: &&Feature| parts.iter().any(|part| feature.is_in(part.mesh.columns()));
    let warning = |feature: &Feature| {
        Note::warning(Place::File, format!("{format} has no {}: they were left out", feature.name()))
    };
    features.iter().filter(is_lost).map(warning).collect()
}
