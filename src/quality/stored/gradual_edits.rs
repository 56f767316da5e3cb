//! Where normals were bent by hand within a surface, more and more from one place to the next.

use crate::num::{Degrees, angle_between};
use crate::quality::estimate::recipe::SAME;
use crate::quality::facts::{Facts, Significance};
use glam::DVec3;
use rayon::prelude::*;

/// The fewest faces of a region: single faults that happen to lie side by side are fewer.
const FEWEST: usize = 16;

/// What normals next to each other are off by may differ by this share of itself, mostly: two directions at random differ by
/// more in five of six cases, sides of facets always.
const ALIKE: f64 = 0.5;

/// Connected faces none of whose normals are within so many degrees of what the rule of the mesh gives, each region ascending: those
/// on which normals go on smoothly from what they are off by at one place to the next. One normal that all of a region has is what
/// a program fills in, not bent. Some faces may be left out.
pub(in crate::quality) fn regions(facts: &Facts<'_>, near: f64, left_out: &[bool]) -> Vec<Vec<u32>> {
    let is_off = |(stored, right): (DVec3, DVec3)| Degrees::from(angle_between(stored, right)).0 > near;
    let departs = |face: usize| {
        let mut corners = facts.mesh.faces().range(face);
        facts.worth[face] == Significance::Sound
            && !left_out.get(face).is_some_and(|&is| is)
            && corners
                .all(|corner| facts.is_judged(corner) && facts.stored_and_right(corner).is_some_and(is_off))
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
        let mut head = 0;
        while let Some(&face) = region.get(head) {
            head += 1;
            for half_edge in facts.mesh.faces().range(face as usize) {
                if let Some(across) = facts.topology.across(half_edge as u32) {
                    reach(facts.topology.face_of(across) as usize, &mut region);
                }
            }
        }
        if region.len() >= FEWEST && is_smooth(facts, &region) && !is_constant(facts, &region) {
            region.sort_unstable();
            regions.push(region);
        }
    }
    regions
}

/// Whether what normals are off by is mostly alike at the two ends of an edge.
fn is_smooth(facts: &Facts<'_>, region: &[u32]) -> bool {
    let off =
        |corner: usize| facts.stored_and_right(corner).map_or(DVec3::ZERO, |(stored, right)| stored - right);
    let (mut alike, mut all) = (0, 0);
    for &face in region {
        for corner in facts.mesh.faces().range(face as usize) {
            let [a, b] = [off(corner), off(facts.topology.next(corner as u32) as usize)];
            alike += usize::from(a.distance(b) < ALIKE * a.length().max(b.length()));
            all += 1;
        }
    }
    2 * alike > all
}

fn is_constant(facts: &Facts<'_>, region: &[u32]) -> bool {
    let corners = region.iter().flat_map(|&face| facts.mesh.faces().range(face as usize));
    let mut normals = corners.filter_map(|corner| facts.stored_unit(corner));
    let first = normals.next();
    first.is_none_or(|first| normals.all(|normal| Degrees::from(angle_between(first, normal)).0 <= SAME))
}
