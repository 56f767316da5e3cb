//! Normals of polynomials fitted to the neighbours of every smooth group.

use crate::normals::fits::polynomial::{Neighbourhoods, Polynomial};
use crate::normals::fits::rings::{RingScratch, Rings};
use crate::num::LANES;
use glam::DVec3;
use rayon::prelude::*;
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
        self.few_neighbours + self.ill_conditioned + self.unconfirmed
    }
}

impl AddAssign for FitFailures {
    fn add_assign(&mut self, other: Self) {
        self.few_neighbours += other.few_neighbours;
        self.ill_conditioned += other.ill_conditioned;
        self.unconfirmed += other.unconfirmed;
    }
}

/// Replaces the unit normal of each smooth group by that of the first of some polynomials that can be fitted to its neighbours;
/// see [`Rings::neighbours`]. The frame is the given normal, which should be the angle-weighted mean. Groups without a normal
/// (zero) stay without. Returns how often each polynomial failed; where the last one does, the given normal stays.
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
    normals: &mut [DVec3],
) -> [FitFailures; N] {
    let means = normals.to_vec();
    let fewest = polynomials.iter().filter(|it| it.adds_rings).map(|it| it.fewest).fold(0, usize::max);
    let sum = |a: [FitFailures; N], b: [FitFailures; N]| {
        let mut sum = a;
        sum.iter_mut().zip(b).for_each(|(a, b)| *a += b);
        sum
    };
    normals
        .par_chunks_mut(CHUNK)
        .enumerate()
        .map_init(
            || Scratch::new(rings),
            |scratch, (chunk, normals)| {
                let first = chunk * CHUNK;
                scratch.find(rings, fewest, first, normals);
                let mut failures = [FitFailures::default(); N];
                for (polynomial, failures) in polynomials.into_iter().zip(&mut failures) {
                    scratch.fit(rings, polynomial, &means, first, normals, failures);
                }
                failures
            },
        )
        .reduce(|| [FitFailures::default(); N], sum)
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

    /// Finds the neighbours of the groups of a chunk that have a normal.
    fn find(&mut self, rings: &Rings<'_>, fewest: usize, first: usize, normals: &[DVec3]) {
        self.neighbours.clear();
        self.open.clear();
        for (place, normal) in normals.iter().enumerate() {
            let group = (first + place) as u32;
            if *normal != DVec3::ZERO && !rings.groups(group).is_empty() {
                let start = self.neighbours.len() as u32;
                rings.neighbours(group, fewest, &mut self.rings, &mut self.neighbours);
                self.open.push((place as u32, start, self.neighbours.len() as u32));
            }
        }
    }

    /// Fits a polynomial to the open groups. Those that it cannot be fitted to stay open.
    fn fit(
        &mut self,
        rings: &Rings<'_>,
        polynomial: Polynomial,
        means: &[DVec3],
        first: usize,
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
                let group = first + place as usize;
                let neighbours = &self.neighbours[start as usize..end as usize];
                self.neighbourhoods.push(rings.centre(group as u32), means[group], neighbours);
            }
            for (it, fitted) in eight.iter().zip(self.neighbourhoods.normals(polynomial)) {
                let group = first + it.0 as usize;
                let around = rings.groups(group as u32).iter().map(|&group| means[group as usize]);
                match fitted {
                    Some(fitted) if is_borne_out(fitted, means[group], around) => {
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
