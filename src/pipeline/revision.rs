//! The change of a file.

use super::edited_part::{EditedPart, applied};
use super::outcome::{FaultCounts, PartOutcome, replaced};
use super::task::{Degenerate, Task};
use crate::io::{Emit, Format, Loaded, Part, PartEdit};
use crate::mesh::{
    FaceEdit, Mesh, Orient, Orientation, Orientations, Placed, Topology, Weld, cavities, orient,
};
use crate::normals::{Extras, FaultReason, Weight, When, compute_observed, select};
use crate::num::parallel;
use glam::DVec3;
use std::borrow::Cow;
use std::sync::atomic::{AtomicUsize, Ordering};

/// What changes in a file, and what was found on the way.
#[derive(Clone, Debug, Default)]
pub struct Revision {
    /// The change of each part, in the order of [`Loaded::parts`].
    pub edits: Vec<PartEdit>,
    /// What was found in each part.
    pub parts: Vec<PartOutcome>,
}

/// Computes what a task changes in a file that will be written as `target`; `None` if it will not be written.
///
/// `done` is called with numbers of finished faces, from any thread: all of a part, or some at a time if its normals are fits. Parts
/// without faces do not change. The result is the same for any number of threads.
pub fn revise(
    loaded: &Loaded,
    task: &Task,
    target: Option<Format>,
    done: &(dyn Fn(usize) + Sync),
) -> Revision {
    let parts = loaded.parts.iter().zip(find_orientations(loaded, task)).collect();
    let revised = parallel::map_owned(parts, |(part, orientation): (&Part, _)| {
        let wants_facets = task.emit == Emit::Face || target == Some(Format::Stl);
        let faces = FaceCount { all: part.mesh.face_count(), reported: AtomicUsize::new(0), done };
        let (mut edit, outcome, facets) = revise_part(part, orientation, task, wants_facets, &faces);
        let same_facets = target == Some(Format::Stl) && loaded.format == Format::Stl && edit.is_empty();
        edit.face_normals = facets.filter(|_| wants_facets && !same_facets);
        if task.emit == Emit::Face {
            edit = PartEdit { normals: None, kept: 0, morph_normals: Vec::new(), ..edit };
        }
        faces.share(1, 1);
        (edit, outcome)
    });
    let (edits, parts) = revised.into_iter().unzip();
    Revision { edits, parts }
}

/// The faces of a part, of which some are reported as done.
struct FaceCount<'a> {
    all: usize,
    reported: AtomicUsize,
    done: &'a (dyn Fn(usize) + Sync),
}

impl FaceCount<'_> {
    /// Reports a share of the faces, as far as it is more than was reported before.
    fn share(&self, part: usize, whole: usize) {
        let now = self.all * part / whole.max(1);
        let before = self.reported.fetch_max(now, Ordering::Relaxed);
        if now > before {
            (self.done)(now - before);
        }
    }
}

/// Frees what neither [`revise`] nor the writer reads: the stored normals that a task replaces, and the source of a file that will be
/// written in another format. Changes nothing for an OBJ, PLY or STL that will be written in its own format.
pub fn forget_unused(loaded: &mut Loaded, task: &Task, target: Option<Format>) {
    match target.is_some_and(|target| target.edits(loaded.format)) {
        // An edited glTF has its normals in the document.
        true if loaded.format.is_gltf() => {}
        true => return,
        false => loaded.forget_source(),
    }
    // Orientation finds rooms by stored normals, and a part without faces keeps its own.
    if task.when == When::Always && task.orient == Orient::Keep {
        for part in loaded.parts.iter_mut().filter(|part| part.mesh.face_count() > 0) {
            part.mesh = std::mem::take(&mut part.mesh).with_normals(None);
        }
    }
}

/// The change of a part, what was found in it, and one normal a face.
fn revise_part(
    part: &Part,
    orientation: Option<Orientation>,
    task: &Task,
    wants_facets: bool,
    faces: &FaceCount<'_>,
) -> (PartEdit, PartOutcome, Option<Vec<DVec3>>) {
    let mut outcome = PartOutcome::new(part);
    if part.mesh.face_count() == 0 {
        return (PartEdit::default(), outcome, None);
    }
    let mut edited = EditedPart::new(part, orientation, task);
    // Otherwise the vertices of the file matter.
    if (task.when, task.emit, task.recipe.weld) == (When::Always, Emit::Corner, Weld::Exact) {
        edited.share_vertices();
    }
    // Stored normals are compared with those of their faces.
    let face_normals = wants_facets || task.when != When::Always;
    let edge_counts = task.edge_counts || task.recipe.can_split(&edited.mesh);
    let extras = Extras { face_normals, edge_counts };
    let compute = |mesh: &Mesh| compute_observed(mesh, &task.recipe, extras, &|a, b| faces.share(a, b));
    let mut field = compute(&edited.mesh);
    outcome.orientation = edited.orientation.take();
    outcome.faults = FaultCounts::of(&field.faults);
    outcome.fault_places = edited.fault_places(&field.faults);
    if task.degenerate == Degenerate::Drop {
        let zero_area = field.faults.faces.iter().filter(|fault| fault.reason == FaultReason::ZeroArea);
        let dropped: Vec<u32> = zero_area.map(|fault| fault.index).collect();
        if !dropped.is_empty() {
            edited.drop_faces(dropped);
            field = compute(&edited.mesh);
        }
    }
    outcome.entries = field.normals.values.len();
    let summary = field.summary;
    let weight = summary.choice.map_or(task.recipe.weight, |choice| choice.weight);
    let mut selection = select(&edited.mesh, field, task.when);
    outcome.replaced_corners = replaced(&selection);
    if task.when != When::Always {
        let replaced: usize = outcome.replaced_corners.values().sum();
        outcome.kept_corners = edited.mesh.faces().corner_count() - replaced;
    }
    outcome.broken_places = edited.broken_places(&selection.broken);
    let facets = edited.faces_as_read(std::mem::take(&mut selection.face_normals));
    let has_shared_vertices = edited.has_shared_vertices;
    let edit = edited.edit(selection, task);
    outcome.reversed_faces = edit.faces.reversed.len();
    outcome.dropped_faces = edit.faces.dropped.len() - part.non_finite_faces.len();
    let outcome = PartOutcome {
        referenced_vertices: summary.referenced_vertices,
        splits: summary.splits,
        crease_degrees: summary.crease_degrees,
        near_crease: summary.near_crease,
        near_cancellation: summary.near_cancellation,
        crease_chains: summary.crease_chains,
        edges: if has_shared_vertices { summary.edges.all_welded() } else { summary.edges },
        quadric_fallbacks: summary.quadric_fallbacks,
        jet_fallbacks: (weight == Weight::Jet).then_some(summary.jet_fallbacks),
        best: summary.choice,
        cone_declined: summary.cone_declined,
        wide_clusters: summary.wide_clusters,
        faces_before_groups: summary.faces_before_groups,
        fast_declined: summary.fast_declined,
        ..outcome
    };
    (edit, outcome, face_normals.then_some(facets))
}

/// What a task finds in each part; `None` if it asks for nothing. Faces are numbered without those that have no
/// finite positions.
fn find_orientations(loaded: &Loaded, task: &Task) -> Vec<Option<Orientation>> {
    if task.orient == Orient::Keep {
        return vec![None; loaded.parts.len()];
    }
    let weld = task.recipe.weld;
    let without = |dropped: &Vec<u32>| FaceEdit { dropped: dropped.clone(), reversed: Vec::new() };
    let present: Vec<Cow<'_, Mesh>> =
        loaded.parts.iter().map(|part| applied(&part.mesh, &without(&part.non_finite_faces))).collect();
    let alone =
        |mesh: &Cow<'_, Mesh>| orient(mesh, &Topology::build(mesh, weld), task.orient, task.confidence);
    let mut found = parallel::map_each(&present, alone);
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
