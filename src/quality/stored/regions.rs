//! Pieces of surface whose normals were made in another way than those of the rest.

use crate::mesh::Orientations;
use crate::num::{Degrees, angle_between};
use crate::quality::estimate::recipe::{REPRODUCED, SAME};
use crate::quality::estimate::rotation::{are_spread, steady_turn};
use crate::quality::facts::{Facts, Significance};
use crate::quality::stored::gradual_edits::regions;
use glam::DVec3;
use rayon::prelude::*;

/// The share of a piece's normals from which on they follow the rule of the mesh, and the others are faults.
const FOLLOWED: f64 = 1.0 / 3.0;

/// By how much more there has to be of pieces that the rule says nothing about than of such as are the very opposite of what it
/// gives for these to be so by chance: of one leaf in some hundred what lights it comes from right behind.
const BY_CHANCE: usize = 20;

/// The pieces of a part that its rule says nothing about: components, as leaves that are lit like a ball beside the trunk of a
/// tree, and regions of them, as a face that an artist smoothed.
#[derive(Default)]
pub(in crate::quality) struct Region {
    /// Of each face whether it is of such a piece; empty if there are none.
    faces: Vec<bool>,
    /// How many corners that would be judged these pieces have.
    pub(in crate::quality) corners: usize,
}

/// What the normals of a piece are to the rule of the mesh.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Making {
    /// Enough of them are what it gives.
    Rule,
    /// They are the opposite of that.
    Opposite,
    /// One turn of all of them makes them so.
    Turned,
    /// None of these.
    Other,
}

impl Region {
    pub(in crate::quality) fn new(facts: &Facts<'_>, orientations: &Orientations) -> Self {
        let mut apart = Self::default();
        if let Some(estimate) = facts.estimate.filter(|estimate| estimate.is_departed_from()) {
            // Where what follows the rule does so closely, what is only near it does not.
            let near = if estimate.reproduced - estimate.closely <= 0.01 { SAME } else { REPRODUCED };
            // One component has no other to be apart from.
            let several = orientations.components().len() > 1;
            let known = if several { apart.add_components(facts, orientations, near) } else { Vec::new() };
            if estimate.reproduced < 1.0 {
                apart.add_regions(facts, near, &known);
            }
        }
        apart
    }

    /// Gives of each face whether its component does not follow the rule, for whatever reason; nothing if all do.
    fn add_components(&mut self, facts: &Facts<'_>, orientations: &Orientations, near: f64) -> Vec<bool> {
        let looked_at = orientations.components().map(|faces| {
            let (making, corners) = match made(facts, faces, near) {
                (Making::Other, corners) if is_turned(facts, faces) => (Making::Turned, corners),
                made => made,
            };
            (making, corners, faces)
        });
        let pieces: Vec<(Making, usize, &[u32])> = looked_at.filter(|it| it.0 != Making::Rule).collect();
        let corners = |making| pieces.iter().filter(|it| it.0 == making).map(|it| it.1).sum::<usize>();
        let are_by_chance = corners(Making::Other) >= BY_CHANCE * corners(Making::Opposite);
        let mut known = Vec::new();
        for (making, corners, faces) in pieces {
            known.resize(facts.mesh.face_count(), false);
            faces.iter().for_each(|&face| known[face as usize] = true);
            if making == Making::Other || (making == Making::Opposite && are_by_chance) {
                self.add(facts, faces, corners);
            }
        }
        known
    }

    /// With the faces round regions, where these begin.
    fn add_regions(&mut self, facts: &Facts<'_>, near: f64, known: &[bool]) {
        let vertices = |face: u32| facts.mesh.faces().face(face as usize);
        let mut is_at: Vec<bool> = Vec::new();
        let mut all = 0;
        for region in regions(facts, near, known) {
            let (making, corners) = made(facts, &region, near);
            if making == Making::Other {
                is_at.resize(facts.mesh.vertex_count(), false);
                for &vertex in region.iter().flat_map(|&face| vertices(face)) {
                    is_at[vertex as usize] = true;
                }
                all += corners;
            }
        }
        if !is_at.is_empty() {
            let is_round = |&face: &u32| vertices(face).iter().any(|&vertex| is_at[vertex as usize]);
            let faces: Vec<u32> = (0..facts.mesh.face_count() as u32).filter(is_round).collect();
            self.add(facts, &faces, all);
        }
    }

    fn add(&mut self, facts: &Facts<'_>, faces: &[u32], corners: usize) {
        self.faces.resize(facts.mesh.face_count(), false);
        faces.iter().for_each(|&face| self.faces[face as usize] = true);
        self.corners += corners;
    }

    /// Whether a face is of such a piece.
    pub(in crate::quality) fn has(&self, face: usize) -> bool {
        self.faces.get(face).is_some_and(|&is| is)
    }
}

/// How the normals of some faces were made, if those count as the same that are near by so many degrees, and of how many corners
/// they are.
fn made(facts: &Facts<'_>, faces: &[u32], near: f64) -> (Making, usize) {
    let is_right = |(stored, right): (DVec3, DVec3)| are_near(stored, right, near);
    // Most components have enough of all their corners long before their end, and need not be counted.
    let all: usize = faces.iter().map(|&face| facts.mesh.faces().range(face as usize).len()).sum();
    if are_enough(pairs(facts, faces).map(is_right), all) {
        return (Making::Rule, all);
    }
    let count = pairs(facts, faces).count();
    let are_opposite = || pairs(facts, faces).map(|(stored, right)| are_near(-stored, right, near));
    if are_enough(pairs(facts, faces).map(is_right), count) {
        (Making::Rule, count)
    } else if are_enough(are_opposite(), count) {
        (Making::Opposite, count)
    } else {
        (Making::Other, count)
    }
}

/// Whether one turn of all normals of a component makes enough of them what the rule gives: that is a fault.
fn is_turned(facts: &Facts<'_>, faces: &[u32]) -> bool {
    let pairs: Vec<(DVec3, DVec3)> = pairs(facts, faces).collect();
    are_spread(pairs.iter().map(|pair| pair.1))
        && steady_turn(&pairs).is_some_and(|turn| {
            let is_right = |&(stored, right): &(DVec3, DVec3)| are_near(stored, turn * right, REPRODUCED);
            are_enough(pairs.iter().map(is_right), pairs.len())
        })
}

/// The stored normals of some faces that can be judged, and what the rule gives there.
fn pairs(facts: &Facts<'_>, faces: &[u32]) -> impl Iterator<Item = (DVec3, DVec3)> {
    let sound =
        faces.iter().map(|&face| face as usize).filter(|&face| facts.worth[face] == Significance::Sound);
    let corners = sound.flat_map(|face| facts.mesh.faces().range(face));
    corners.filter(|&corner| facts.is_judged(corner)).filter_map(|corner| facts.stored_and_right(corner))
}

fn are_near(a: DVec3, b: DVec3, near: f64) -> bool {
    Degrees::from(angle_between(a, b)).0 <= near
}

/// Whether enough of so many are true; looks no further than it has to.
fn are_enough(are: impl Iterator<Item = bool>, of: usize) -> bool {
    let enough = (FOLLOWED * of as f64).ceil() as usize;
    are.filter(|&is| is).take(enough).count() == enough
}
