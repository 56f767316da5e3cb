//! Which faces of a file are reversed, by each part alone and by the parts around it.

use super::edited_part::applied;
use super::task::Task;
use crate::io::Loaded;
use crate::mesh::{FaceEdit, Mesh, Orient, Orientation, Orientations, Placed, Topology, cavities, orient};
use rayon::prelude::*;
use std::borrow::Cow;

/// What a task finds in each part; `None` if it asks for nothing. Faces are numbered without those that have no
/// finite positions.
pub(super) fn find(loaded: &Loaded, task: &Task) -> Vec<Option<Orientation>> {
    if task.orient == Orient::Keep {
        return vec![None; loaded.parts.len()];
    }
    let weld = task.recipe.weld;
    let without = |dropped: &Vec<u32>| FaceEdit { dropped: dropped.clone(), reversed: Vec::new() };
    let present: Vec<Cow<'_, Mesh>> =
        loaded.parts.iter().map(|part| applied(&part.mesh, &without(&part.non_finite_faces))).collect();
    let alone =
        |mesh: &Cow<'_, Mesh>| orient(mesh, &Topology::build(mesh, weld), task.orient, task.confidence);
    let mut found: Vec<Orientation> = present.par_iter().map(alone).collect();
    if found.iter().any(|found| found.inside_out + found.rooms > 0) {
        let parts = present.iter().zip(loaded.places());
        let parts: Vec<Placed<'_>> = parts.map(|(mesh, places)| Placed { mesh, places }).collect();
        for ((found, mesh), cavities) in found.iter_mut().zip(&present).zip(cavities(&parts, weld)) {
            if !cavities.is_empty() {
                let orientations = Orientations::new(mesh, &Topology::build(mesh, weld));
                *found = orientations.outward(mesh, task.confidence, &cavities);
            }
        }
    }
    found.into_iter().map(Some).collect()
}
