//! Pieces of surface whose normals were made in another way than those of the rest.

use super::estimate::{REPRODUCED, SAME};
use super::facts::{Facts, Worth};
use super::rotation::{are_spread, steady_turn};
use crate::num::{Degrees, angle_between};
use glam::DVec3;
use rayon::prelude::*;

/// The share of a piece's normals from which on they follow the rule of the mesh, and the others are faults.
const FOLLOWED: f64 = 1.0 / 3.0;

/// By how much more there has to be of pieces that the rule says nothing about than of such as are the very opposite of what it
/// gives for these to be so by chance: of one leaf in some hundred what lights it comes from right behind.
const BY_CHANCE: usize = 20;

/// The pieces of a part that its rule says nothing about, as leaves that are lit like a ball beside the trunk of a tree.
#[derive(Default)]
pub(super) struct Apart {
    /// Of each face whether it is of such a piece; empty if there are none.
    faces: Vec<bool>,
    /// How many corners that would be judged these pieces have.
    pub(super) corners: usize,
}

/// What the normals of a piece are to the rule of the mesh.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Making {
    /// Enough of them are what it gives, or what one turn of all of it does.
    Rule,
    /// They are the opposite of that.
    Opposite,
    /// Neither.
    Other,
}

impl Apart {
    /// Of the components of a part, by their faces.
    pub(super) fn new<'a>(facts: &Facts<'_>, components: impl ParallelIterator<Item = &'a [u32]>) -> Self {
        let Some(estimate) = facts.estimate.filter(|estimate| estimate.is_departed_from()) else {
            return Self::default();
        };
        // Where what follows the rule does so closely, what is only near it does not.
        let near = if estimate.reproduced - estimate.closely <= 0.01 { SAME } else { REPRODUCED };
        let looked_at = components.map(|faces| {
            let (making, corners) = made(facts, faces, near);
            (making, corners, faces)
        });
        let pieces: Vec<(Making, usize, &[u32])> = looked_at.filter(|it| it.0 != Making::Rule).collect();
        let corners = |making| pieces.iter().filter(|it| it.0 == making).map(|it| it.1).sum::<usize>();
        let are_by_chance = corners(Making::Other) >= BY_CHANCE * corners(Making::Opposite);
        let mut apart = Self::default();
        for &(_, corners, faces) in pieces.iter().filter(|it| it.0 == Making::Other || are_by_chance) {
            apart.faces.resize(facts.mesh.face_count(), false);
            faces.iter().for_each(|&face| apart.faces[face as usize] = true);
            apart.corners += corners;
        }
        apart
    }

    /// Whether a face is of such a piece.
    pub(super) fn has(&self, face: usize) -> bool {
        self.faces.get(face).is_some_and(|&is| is)
    }
}

/// How the normals of a component were made, if those count as the same that are near by so many degrees, and of how many corners
/// they are. What happened to all of it is a fault if one turn tells what.
fn made(facts: &Facts<'_>, faces: &[u32], near: f64) -> (Making, usize) {
    let turn = facts.turn.unwrap_or_default();
    let sound = faces.iter().map(|&face| face as usize).filter(|&face| facts.worth[face] == Worth::Sound);
    let corners = sound.flat_map(|face| facts.mesh.faces().range(face));
    let pair = |corner| Some((facts.stored_unit(corner)?, turn * facts.expected(corner)));
    let pairs = || corners.clone().filter(|&corner| facts.is_judged(corner)).filter_map(pair);
    let are_near = |a: DVec3, b: DVec3, near| Degrees::from(angle_between(a, b)).0 <= near;
    let has_enough = |of: usize, is: &dyn Fn(&(DVec3, DVec3)) -> bool| {
        let enough = (FOLLOWED * of as f64).ceil() as usize;
        pairs().filter(is).take(enough).count() == enough
    };
    let is_right = |&(stored, right): &(DVec3, DVec3)| are_near(stored, right, near);
    // Most components have enough of all their corners long before their end, and need not be counted.
    let all: usize = faces.iter().map(|&face| facts.mesh.faces().range(face as usize).len()).sum();
    if has_enough(all, &is_right) {
        return (Making::Rule, all);
    }
    let count = pairs().count();
    if has_enough(count, &is_right) {
        return (Making::Rule, count);
    }
    if has_enough(count, &|&(stored, right)| are_near(-stored, right, near)) {
        return (Making::Opposite, count);
    }
    let is_turned = are_spread(pairs().map(|(_, right)| right))
        && steady_turn(&pairs().collect::<Vec<_>>()).is_some_and(|turn| {
            has_enough(count, &|&(stored, right)| are_near(stored, turn * right, REPRODUCED))
        });
    (if is_turned { Making::Rule } else { Making::Other }, count)
}
