//! Smooth groups in whose neighbourhood the surface is no height function.

use crate::normals::fits::rings::{RingScratch, Rings};
use crate::num::{Radians, angle_between, parallel};
use glam::DVec3;
use rustc_hash::FxHashMap;
use std::f64::consts::{FRAC_PI_2, SQRT_2};

/// Two distances whose sum is below this are below √2, whatever rounding did to them.
const NEAR: f64 = SQRT_2 - 1e-6;

/// Finds neighbourhoods with normals more than 90° from that of their centre, as at the tip of a cone.
pub(super) struct Folds<'a> {
    rings: &'a Rings<'a>,
    means: &'a [DVec3],
    /// The largest distance between the normal of each group and one of its ring, as unit vectors.
    reaches: Vec<f32>,
    /// For each crowded group the largest angle to a normal of its ring: each neighbour would visit the whole ring.
    spreads: FxHashMap<u32, f64>,
}

impl<'a> Folds<'a> {
    /// `means` has a normal for each group, or zero.
    pub(super) fn new(rings: &'a Rings<'a>, means: &'a [DVec3]) -> Self {
        let spread = |group: u32| {
            let angles = rings.groups(group).iter().map(|&next| angle(means, group, next));
            (group, angles.fold(0.0, f64::max))
        };
        let reaches = parallel::map(means.len(), |group| {
            let around = rings.groups(group as u32).iter();
            let squares = around.map(|&next| means[group].distance_squared(means[next as usize]));
            squares.fold(0.0, f64::max).sqrt() as f32
        });
        Self { rings, means, reaches, spreads: rings.crowded().map(spread).collect() }
    }

    /// Whether there is one among the groups of the last search, that for the neighbours of this group.
    pub(super) fn is_folded(&self, group: u32, search: &RingScratch) -> bool {
        let own = self.means[group as usize];
        // Almost all: unit vectors at a distance of less than √2 are less than 90° apart.
        let is_near = |&next: &u32| {
            own.distance(self.means[next as usize]) + f64::from(self.reaches[next as usize]) < NEAR
        };
        let is_opposite = |&other: &u32| own.dot(self.means[other as usize]) < 0.0;
        let reaches_opposite = |&next: &u32| match self.spreads.get(&next) {
            Some(spread) => angle(self.means, group, next) + spread > FRAC_PI_2,
            None => self.rings.groups(next).iter().any(is_opposite),
        };
        let [inner, outer] = search.groups();
        inner.iter().any(is_opposite)
            || outer.iter().any(|next| !is_near(next) && (is_opposite(next) || reaches_opposite(next)))
    }
}

/// The angle between the normals of two groups; 0 if one has none.
fn angle(means: &[DVec3], a: u32, b: u32) -> f64 {
    let Radians(angle) = angle_between(means[a as usize], means[b as usize]);
    angle
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::mesh::Mesh;
    use crate::normals::fits::jet::JET;
    use crate::normals::fits::quadric::QUADRIC;
    use crate::normals::fits::test_surfaces::{build, errors, normals_of};
    use std::f64::consts::TAU;

    /// The side of a cone of radius 1 and a height: a tip and rings of vertices around it, with the exact normals of the rings.
    fn cone(around: u32, height: f64) -> (Mesh, Vec<DVec3>) {
        const RINGS: u32 = 12;
        let spoke = |i: u32| {
            let t = TAU * f64::from(i) / f64::from(around);
            DVec3::new(libm::cos(t), libm::sin(t), 0.0)
        };
        let all = || (0..RINGS).flat_map(|ring| (0..around).map(move |i| (ring, i)));
        let at = |(ring, i): (u32, u32)| {
            let share = f64::from(ring + 1) / f64::from(RINGS);
            share * spoke(i) + (1.0 - share) * height * DVec3::Z
        };
        let positions = std::iter::once(height * DVec3::Z).chain(all().map(at)).collect();
        let exact = all().map(|(_, i)| (height * spoke(i) + DVec3::Z).normalize());
        let vertex = |ring: u32, i: u32| 1 + ring * around + i % around;
        let triangles = all().flat_map(|(ring, i)| match ring.checked_sub(1) {
            None => vec![0, vertex(0, i), vertex(0, i + 1)],
            Some(above) => {
                let [a, b] = [vertex(above, i), vertex(above, i + 1)];
                vec![a, vertex(ring, i), vertex(ring, i + 1), a, vertex(ring, i + 1), b]
            }
        });
        (build(positions, triangles.collect()), exact.collect())
    }

    /// Without the test, fits across the tip were wrong by 39° to 67°. A tip of 200 faces is crowded.
    #[test]
    fn fits_do_not_reach_across_the_tip_of_a_cone() {
        for around in [24, 48, 200] {
            let (mesh, exact) = cone(around, 2.0);
            let (jets, [degree_3, _]) = normals_of(&mesh, mesh.faces().corners(), JET);
            let (quadrics, [degree_2]) = normals_of(&mesh, mesh.faces().corners(), [QUADRIC]);
            let largest = [jets, quadrics].map(|normals| errors(&normals[1..], &exact).1);
            assert!(largest.iter().all(|&error| error < 2.0), "{around}: {largest:?}");
            assert_eq!([degree_3.folded, degree_2.folded], [around as usize; 2], "the ring around the tip");
        }
    }

    /// Normals on the sides of a flat cone differ by less than 90°.
    #[test]
    fn flat_cones_are_fitted() {
        for around in [24, 200] {
            let (mesh, _) = cone(around, 0.5);
            let (_, [failures, _]) = normals_of(&mesh, mesh.faces().corners(), JET);
            assert_eq!(failures.folded, 0);
        }
    }
}
