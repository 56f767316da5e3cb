//! Regions of a surface whose normals were made in another way than those of the rest.

use crate::num::parallel;
use crate::quality::estimate::recipe::REPRODUCED;
use crate::quality::estimate::rotation::{are_spread, robust_rotation};
use crate::quality::findings::prelude::*;
use glam::DVec3;

/// The share of a component's normals from which it follows the recipe of the mesh, and the others are faults.
const FOLLOWED: f64 = 1.0 / 3.0;

/// How many times more corners other components need to have than components with negated normals, for these to be so by chance:
/// one leaf in some hundred is lit from right behind.
const BY_CHANCE: usize = 20;

/// The fewest faces of a region: single faults that happen to be side by side are fewer.
const FEWEST: usize = 16;

/// The deviations at both ends of most edges differ by less than this share of themselves: two directions at random differ by more
/// in five of six cases, sides of facets always.
const ALIKE: f64 = 0.5;

/// The faces that the recipe says nothing about: components, as leaves that are lit like a ball next to the trunk of a tree, and
/// regions of them, as a face that an artist smoothed.
#[derive(Default)]
pub(crate) struct Regions {
    /// A mark for each face; empty if there are none.
    faces: Vec<bool>,
    pub(crate) corners: usize,
}

/// How the normals of some faces relate to the recipe of the mesh.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Relation {
    /// Enough of them follow it.
    Follow,
    /// They are the opposite of what it gives.
    Negated,
    /// They follow it once all are rotated.
    Rotated,
    /// None of these.
    Other,
}

impl Regions {
    pub(crate) fn new(facts: &Facts<'_>) -> Self {
        let mut found = Self::default();
        if let Some(estimate) = facts.estimate.filter(|estimate| estimate.is_departed_from()) {
            // If what follows the recipe does so closely, what is only near it does not follow.
            let near = if estimate.is_clear_cut() { SAME } else { REPRODUCED };
            let several = facts.winding.components.components().len() > 1;
            let known = if several { found.add_components(facts, near) } else { Vec::new() };
            if estimate.reproduced < 1.0 {
                found.add_gradual_edits(facts, near, &known);
            }
        }
        found
    }

    /// Adds components that follow no recipe. Returns a mark for each face of a component that does not follow that of the mesh,
    /// for whatever reason; nothing if all do.
    fn add_components(&mut self, facts: &Facts<'_>, near: f64) -> Vec<bool> {
        let mut others = parallel::map_each(&facts.winding.components.components(), |&faces| {
            let (relation, corners) = relation(facts, faces, near);
            let is_rotated = relation == Relation::Other && is_rotated(facts, faces);
            (if is_rotated { Relation::Rotated } else { relation }, corners, faces)
        });
        others.retain(|(relation, ..)| *relation != Relation::Follow);
        let corners = |relation| others.iter().filter(|it| it.0 == relation).map(|it| it.1).sum::<usize>();
        let are_by_chance = corners(Relation::Other) >= BY_CHANCE * corners(Relation::Negated);
        let mut known = Vec::new();
        for (relation, corners, faces) in others {
            known.resize(facts.mesh.face_count(), false);
            faces.iter().for_each(|&face| known[face as usize] = true);
            if relation == Relation::Other || (relation == Relation::Negated && are_by_chance) {
                self.add(facts, faces, corners);
            }
        }
        known
    }

    /// Adds regions that were edited gradually, with the faces around them, where the edits begin.
    fn add_gradual_edits(&mut self, facts: &Facts<'_>, near: f64, known: &[bool]) {
        let vertices = |face: u32| facts.mesh.faces().face(face as usize);
        let mut is_at = vec![];
        let mut all = 0;
        for region in gradual_edits(facts, near, known) {
            if let (Relation::Other, corners) = relation(facts, &region, near) {
                is_at.resize(facts.mesh.vertex_count(), false);
                let corners_of = region.iter().flat_map(|&face| vertices(face));
                corners_of.for_each(|&vertex| is_at[vertex as usize] = true);
                all += corners;
            }
        }
        if !is_at.is_empty() {
            let is_around = |&face: &u32| vertices(face).iter().any(|&vertex| is_at[vertex as usize]);
            let faces: Vec<u32> = (0..facts.mesh.face_count() as u32).filter(is_around).collect();
            self.add(facts, &faces, all);
        }
    }

    fn add(&mut self, facts: &Facts<'_>, faces: &[u32], corners: usize) {
        self.faces.resize(facts.mesh.face_count(), false);
        faces.iter().for_each(|&face| self.faces[face as usize] = true);
        self.corners += corners;
    }

    pub(crate) fn has(&self, face: usize) -> bool {
        self.faces.get(face).is_some_and(|&is| is)
    }
}

/// Regions of connected faces none of whose normals are within so many degrees of the expected ones, with deviations that change
/// gradually; each ascending. A constant normal was filled in by a program, not edited. Some faces may be excluded.
fn gradual_edits(facts: &Facts<'_>, near: f64, excluded: &[bool]) -> Vec<Vec<u32>> {
    let deviates = |corner: usize| {
        let pair = facts.stored_and_expected(corner);
        facts.is_judged(corner)
            && pair.is_some_and(|(stored, expected)| degrees_between(stored, expected) > near)
    };
    let departs = |face: usize| {
        facts.is_sound(face)
            && !excluded.get(face).is_some_and(|&is| is)
            && facts.corners_of(face).all(deviates)
    };
    let mut departing = parallel::map(facts.mesh.face_count(), departs);
    let mut regions = Vec::new();
    for seed in 0..departing.len() {
        let mut region = Vec::new();
        let mut reach = |face: usize, region: &mut Vec<u32>| {
            if std::mem::take(&mut departing[face]) {
                region.push(face as u32);
            }
        };
        reach(seed, &mut region);
        let mut next = 0;
        while let Some(&face) = region.get(next) {
            next += 1;
            for half_edge in facts.corners_of(face as usize) {
                if let Some(across) = facts.topology.across(half_edge as u32) {
                    reach(facts.topology.face_of(across) as usize, &mut region);
                }
            }
        }
        if region.len() >= FEWEST && is_gradual(facts, &region) && !is_constant(facts, &region) {
            region.sort_unstable();
            regions.push(region);
        }
    }
    regions
}

/// Whether the deviations at the two ends of most edges are alike.
fn is_gradual(facts: &Facts<'_>, region: &[u32]) -> bool {
    let deviation = |corner: usize| {
        facts.stored_and_expected(corner).map_or(DVec3::ZERO, |(stored, expected)| stored - expected)
    };
    let edges = region.iter().flat_map(|&face| facts.corners_of(face as usize));
    let (mut alike, mut all) = (0, 0);
    for corner in edges {
        let [a, b] = [corner, facts.topology.next(corner as u32) as usize].map(deviation);
        alike += usize::from(a.distance(b) < ALIKE * a.length().max(b.length()));
        all += 1;
    }
    2 * alike > all
}

fn is_constant(facts: &Facts<'_>, region: &[u32]) -> bool {
    let corners = region.iter().flat_map(|&face| facts.corners_of(face as usize));
    let mut normals = corners.filter_map(|corner| facts.stored_unit(corner));
    let first = normals.next();
    first.is_none_or(|first| normals.all(|normal| degrees_between(first, normal) <= SAME))
}

/// How the normals of some faces relate to the recipe, where normals near each other by so many degrees count as the same, and
/// how many corners they have.
fn relation(facts: &Facts<'_>, faces: &[u32], near: f64) -> (Relation, usize) {
    let follow = || pairs(facts, faces).map(|(stored, expected)| degrees_between(stored, expected) <= near);
    let negated = || pairs(facts, faces).map(|(stored, expected)| degrees_between(-stored, expected) <= near);
    // Most components have enough of all their corners long before their end, and need not be counted.
    let all: usize = faces.iter().map(|&face| facts.corners_of(face as usize).len()).sum();
    if are_enough(follow(), all) {
        return (Relation::Follow, all);
    }
    let count = pairs(facts, faces).count();
    match () {
        () if are_enough(follow(), count) => (Relation::Follow, count),
        () if are_enough(negated(), count) => (Relation::Negated, count),
        () => (Relation::Other, count),
    }
}

/// Whether enough normals of a component follow the recipe once all are rotated: that is a fault.
fn is_rotated(facts: &Facts<'_>, faces: &[u32]) -> bool {
    let pairs: Vec<(DVec3, DVec3)> = pairs(facts, faces).collect();
    are_spread(pairs.iter().map(|pair| pair.1))
        && robust_rotation(&pairs).is_some_and(|rotation| {
            let follow =
                pairs.iter().map(|&(stored, it)| degrees_between(stored, rotation * it) <= REPRODUCED);
            are_enough(follow, pairs.len())
        })
}

/// The stored and expected normals of some faces that can be judged.
fn pairs(facts: &Facts<'_>, faces: &[u32]) -> impl Iterator<Item = (DVec3, DVec3)> {
    let sound = faces.iter().map(|&face| face as usize).filter(|&face| facts.is_sound(face));
    let corners = sound.flat_map(|face| facts.corners_of(face)).filter(|&corner| facts.is_judged(corner));
    corners.filter_map(|corner| facts.stored_and_expected(corner))
}

/// Whether enough of so many are true; no more are computed than necessary.
fn are_enough(are: impl Iterator<Item = bool>, of: usize) -> bool {
    let enough = (FOLLOWED * of as f64).ceil() as usize;
    are.filter(|&is| is).take(enough).count() == enough
}
