//! Normals of polynomials fitted to the neighbours of every smooth group.

use crate::normals::fits::folds::Folds;
use crate::normals::fits::polynomial::{Neighbourhoods, Polynomial};
use crate::normals::fits::rings::{Extent, RingScratch, Rings};
use crate::num::LANES;
use crate::num::parallel;
use glam::DVec3;
use std::ops::AddAssign;

/// How much farther a fit may turn the mean than the means of its neighbours turn, in tangents. Where means are
/// one-sided, at the rim of a surface, the truth lies as far outside the mean as the next one lies inside: once. As much
/// again is for jitter.
const FARTHER: f64 = 2.0;

/// What rounding to f64 turns fits to a plane by, with room: 1.3e-15 was the most. In tangents.
const ROUNDING: f64 = 1.0 / (1_u64 << 40) as f64;

/// Groups that are fitted by one task: enough to find eight with about as many neighbours.
const CHUNK: usize = 128;

/// How many smooth groups a polynomial could not be fitted to, by the reason.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, serde::Serialize)]
pub struct FitFailures {
    /// A normal nearby is more than 90° from the mean: the surface is no height function over its plane.
    pub folded: usize,
    /// Too few neighbours for the unknowns.
    pub few_neighbours: usize,
    /// Neighbours on or near a curve of the polynomial's degree: the condition number is too large.
    pub ill_conditioned: usize,
    /// The normals around do not turn as the fit does.
    pub unconfirmed: usize,
}

impl FitFailures {
    /// All of them.
    pub fn total(&self) -> usize {
        self.folded + self.few_neighbours + self.ill_conditioned + self.unconfirmed
    }
}

impl AddAssign for FitFailures {
    fn add_assign(&mut self, other: Self) {
        self.folded += other.folded;
        self.few_neighbours += other.few_neighbours;
        self.ill_conditioned += other.ill_conditioned;
        self.unconfirmed += other.unconfirmed;
    }
}

/// The unit normal, at some smooth groups, of the first of some polynomials that can be fitted to the neighbours; zero where none
/// can be. See [`Rings::neighbours`]. Returns how often each polynomial failed as well. `done` is called with numbers of finished groups, from any
/// thread.
///
/// The frame is that of `means`, one for each smooth group, which should be the angle-weighted means. There is no fit at groups
/// without a mean (zero).
///
/// A fit is a height function over the plane of the mean, so it is no model of a surface that turns by more than 90° within the
/// neighbourhood, as at the tip of a cone.
///
/// A fit must not turn the mean in a direction in which the surface does not turn: by more than twice as much as
/// the means of the neighbours do, each measured in the plane of the mean and the fit. Points on two lines, as on a
/// cylinder of two rings, lie on a conic but for the rounding of their positions; what is fitted to that rounding may
/// lie anywhere, and no threshold on the dependence of columns separates it from a stretched mesh without knowing how
/// the positions were rounded on their way here. The neighbours do.
///
/// The neighbourhood is brought to unit size by a power of two, so scaling by one leaves the bits alone. Numbering shows only in
/// the last bits of the mean.
pub(crate) fn fitted_normals<const N: usize>(
    rings: &Rings<'_>,
    polynomials: [Polynomial; N],
    more_rings: usize,
    means: &[DVec3],
    groups: &[u32],
    done: &(dyn Fn(usize) + Sync),
) -> (Vec<DVec3>, [FitFailures; N]) {
    let fewest = polynomials.iter().filter(|it| it.adds_rings).map(|it| it.fewest).fold(0, usize::max);
    let extent = Extent { fewest, more_rings };
    let sum = |a: [FitFailures; N], b: [FitFailures; N]| {
        let mut sum = a;
        sum.iter_mut().zip(b).for_each(|(a, b)| *a += b);
        sum
    };
    let folds = Folds::new(rings, means);
    let mut normals = vec![DVec3::ZERO; groups.len()];
    let fit = |scratch: &mut Scratch, chunk: usize, normals: &mut [DVec3]| {
        let groups = &groups[chunk * CHUNK..][..normals.len()];
        let folded = scratch.find(rings, extent, means, &folds, groups);
        let mut failures = [FitFailures { folded, ..FitFailures::default() }; N];
        for (polynomial, failures) in polynomials.into_iter().zip(&mut failures) {
            scratch.fit(rings, polynomial, means, groups, normals, failures);
        }
        done(groups.len());
        failures
    };
    let failures = parallel::map_chunks_with(&mut normals, CHUNK, || Scratch::new(rings), fit);
    (normals, failures.into_iter().fold([FitFailures::default(); N], sum))
}

/// Memory reused from task to task.
struct Scratch {
    rings: RingScratch,
    neighbours: Vec<DVec3>,
    /// Groups to fit, as places in the chunk, with their range of neighbours.
    open: Vec<(u32, u32, u32)>,
    failed: Vec<(u32, u32, u32)>,
    neighbourhoods: Box<Neighbourhoods>,
}

impl Scratch {
    fn new(rings: &Rings<'_>) -> Self {
        Self {
            rings: rings.scratch(),
            neighbours: Vec::new(),
            open: Vec::new(),
            failed: Vec::new(),
            neighbourhoods: Neighbourhoods::new(),
        }
    }

    /// Finds the neighbours of the groups that have a mean. Returns how many are folded.
    fn find(
        &mut self,
        rings: &Rings<'_>,
        extent: Extent,
        means: &[DVec3],
        folds: &Folds<'_>,
        groups: &[u32],
    ) -> usize {
        self.neighbours.clear();
        self.open.clear();
        let mut folded = 0;
        for (place, &group) in groups.iter().enumerate() {
            if means[group as usize] == DVec3::ZERO || rings.groups(group).is_empty() {
                continue;
            }
            let start = self.neighbours.len();
            rings.neighbours(group, extent, &mut self.rings, &mut self.neighbours);
            if folds.is_folded(group, &self.rings) {
                folded += 1;
                self.neighbours.truncate(start);
                continue;
            }
            self.open.push((place as u32, start as u32, self.neighbours.len() as u32));
        }
        folded
    }

    /// Fits a polynomial to the open groups. Those that it cannot be fitted to stay open.
    fn fit(
        &mut self,
        rings: &Rings<'_>,
        polynomial: Polynomial,
        means: &[DVec3],
        groups: &[u32],
        normals: &mut [DVec3],
        failures: &mut FitFailures,
    ) {
        let count = |&(_, start, end): &(u32, u32, u32)| (end - start) as usize;
        self.failed.clear();
        // Lanes of as many rows as each other waste none.
        self.open.sort_by_key(count);
        let few = self.open.partition_point(|it| count(it) < polynomial.fewest);
        failures.few_neighbours += few;
        self.failed.extend_from_slice(&self.open[..few]);
        for eight in self.open[few..].chunks(LANES) {
            self.neighbourhoods.clear();
            for &(place, start, end) in eight {
                let group = groups[place as usize];
                let neighbours = &self.neighbours[start as usize..end as usize];
                self.neighbourhoods.push(rings.centre(group), means[group as usize], neighbours);
            }
            for (it, fitted) in eight.iter().zip(self.neighbourhoods.normals(polynomial)) {
                let group = groups[it.0 as usize];
                let around = rings.groups(group).iter().map(|&group| means[group as usize]);
                match fitted {
                    Some(fitted) if is_borne_out(fitted, means[group as usize], around) => {
                        normals[it.0 as usize] = fitted;
                        continue;
                    }
                    Some(_) => failures.unconfirmed += 1,
                    None => failures.ill_conditioned += 1,
                }
                self.failed.push(*it);
            }
        }
        std::mem::swap(&mut self.open, &mut self.failed);
    }
}

/// Whether the means around a vertex turn in the direction in which a fit turns its own mean.
fn is_borne_out(fit: DVec3, mean: DVec3, around: impl Iterator<Item = DVec3>) -> bool {
    let turn = fit / fit.dot(mean) - mean;
    let along = turn.normalize_or_zero();
    let lean = |other: DVec3| {
        let upright = other.dot(mean);
        if upright > 0.0 { other.dot(along).abs() / upright } else { f64::INFINITY }
    };
    let most = around.filter(|&other| other != DVec3::ZERO).map(lean).fold(0.0, f64::max);
    turn.length() <= FARTHER * most + ROUNDING
}
