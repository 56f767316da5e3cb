//! Connected faces whose normals were edited gradually, more and more from one vertex to the next.

use crate::quality::angles::{SAME, degrees_between};
use crate::quality::facts::Facts;
use glam::DVec3;
use rayon::prelude::*;

/// The fewest faces of a region: single faults that happen to be side by side are fewer.
const FEWEST: usize = 16;

/// The deviations at both ends of most edges differ by less than this share of themselves: two directions at random differ by more
/// in five of six cases, sides of facets always.
const ALIKE: f64 = 0.5;

/// Regions of connected faces none of whose normals are within so many degrees of the expected ones, with deviations that change
/// gradually; each ascending. A constant normal was filled in by a program, not edited. Some faces may be excluded.
pub(crate) fn regions(facts: &Facts<'_>, near: f64, excluded: &[bool]) -> Vec<Vec<u32>> {
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
    let mut departing: Vec<bool> = (0..facts.mesh.face_count()).into_par_iter().map(departs).collect();
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
