//! Which of the jet, the quadric and the angle mean has the smallest error on a mesh, estimated from residuals.

use crate::normals::fits::jet::JET;
use crate::normals::fits::polynomial::{Heights, Neighbourhoods, Polynomial};
use crate::normals::fits::quadric::QUADRIC;
use crate::normals::fits::rings::{RingScratch, Rings};
use crate::normals::recipe::Weight;
use crate::num::{Column, CompensatedSum, Eight, LANES, ROWS};
use glam::{DVec2, DVec3};
use rayon::prelude::*;

/// Smooth groups that estimates are from, at most.
const SAMPLE: usize = 4096;

/// Draws of noise at each of them.
const DRAWS: usize = 8;

/// The share of groups whose jets are noisiest, which do not count: tips and folds say nothing about the rest.
const OUTLIERS: f64 = 0.1;

/// Slopes below this are rounding.
const ROUNDING: f64 = 1.0 / (1_u64 << 40) as f64;

/// The polynomials that are compared.
const FITS: [Polynomial; 3] = [JET[0], JET[1], QUADRIC];

/// The estimated errors of the weights that [`Weight::Best`] chooses from.
#[derive(Clone, Copy, Debug, PartialEq, serde::Serialize)]
pub struct Choice {
    /// [`Weight::Jet`], [`Weight::Quadric`] or [`Weight::Angle`].
    pub weight: Weight,
    /// Smooth groups with a normal of their own that were sampled.
    pub sampled: usize,
    /// Of these, groups that all polynomials can be fitted to.
    pub fitted: usize,
    /// The rms distance of vertices from a smooth surface, as a share of the edges around them.
    pub noise: f64,
    /// The estimated rms error of jets, in degrees.
    pub jet: f64,
    /// That of quadrics.
    pub quadric: f64,
    /// That of angle means.
    pub angle: f64,
}

/// Estimates at one smooth group; all slopes are over the plane of its angle mean.
struct Estimate {
    /// Variance of the noise in units of the scaled neighbourhood, and over the square of the mean edge.
    variance: f64,
    noise: f64,
    jet: DVec2,
    quadric: DVec2,
    /// Variance of the jet's slopes, of the quadric's, and of their difference for noise of variance 1.
    of_jet: f64,
    of_quadric: f64,
    of_difference: f64,
}

impl Estimate {
    /// The expected square of the jet's error.
    fn jet_error(&self) -> f64 {
        self.variance * self.of_jet
    }

    /// That of the quadric: what noise does to it, and its difference from the jet without what noise adds to that.
    fn quadric_error(&self) -> f64 {
        let bias = self.difference() - self.variance * self.of_difference;
        self.variance * self.of_quadric + bias
    }

    fn difference(&self) -> f64 {
        (self.quadric - self.jet).length_squared()
    }
}

/// Chooses by the smallest estimated error.
///
/// At each of a sample of smooth groups, s₃² = |r|² / R is the variance of vertex positions along the normal that would explain
/// the residuals r of the jet: R is the mean |r|² of fits to noise of variance 1. Let s₂² be the same of the jet of degree 2.
/// Noise gives both the same value. On a smooth surface each degree leaves a part of what the one before leaves, so σ² = s₃² min(1,
/// s₃²/s₂²) counts as noise. Let V(p) be the variance of the slopes of a fit p to noise of variance 1. With slopes j of the jet and
/// q of the quadric over the plane of the angle mean, the expected squared errors are
///
/// - of the jet σ² V(j),
/// - of the quadric σ² V(q) + |q − j|² − σ² V(q − j),
/// - of the angle mean |b|², where b is the better of j and q.
///
/// R and V are means over some draws of noise. Each estimate is averaged over the groups but the tenth with the largest
/// σ² V(j) + |q − j|². So the angle mean is chosen where it differs from the better fit by less than the error of that. It is
/// also chosen if fewer than half of the groups have both fits.
pub(crate) fn choose(rings: &Rings<'_>, means: &[DVec3]) -> Choice {
    let groups: Vec<u32> = (0..means.len() as u32)
        .filter(|&group| means[group as usize] != DVec3::ZERO && !rings.groups(group).is_empty())
        .collect();
    let count = groups.len().min(SAMPLE);
    let sample: Vec<u32> = (0..count).map(|i| groups[i * groups.len() / count]).collect();
    let estimates = sample
        .par_chunks(LANES)
        .map_init(|| Scratch::new(rings), |scratch, eight| scratch.of(rings, means, eight));
    let mut estimates: Vec<Estimate> = estimates.flatten_iter().collect();
    let fitted = estimates.len();
    let size = |it: &Estimate| it.jet_error() + it.difference();
    estimates.sort_by(|a, b| size(a).total_cmp(&size(b)));
    estimates.truncate(fitted - (OUTLIERS * fitted as f64) as usize);
    let mean = |of: &dyn Fn(&Estimate) -> f64| {
        let mut sum = CompensatedSum::default();
        estimates.iter().for_each(|estimate| sum += of(estimate));
        sum.value() / estimates.len().max(1) as f64
    };
    let (jet, quadric) = (mean(&Estimate::jet_error), mean(&Estimate::quadric_error));
    let is_jet_better = jet <= quadric;
    let angle = mean(&|it| if is_jet_better { it.jet } else { it.quadric }.length_squared());
    let [jet, quadric, angle] = [jet, quadric, angle].map(|square| {
        let slope = square.max(0.0).sqrt();
        if slope < ROUNDING { 0.0 } else { slope }
    });
    let weight = match is_jet_better {
        _ if 2 * fitted < count || angle <= jet.min(quadric) => Weight::Angle,
        true => Weight::Jet,
        false => Weight::Quadric,
    };
    let degrees = |slope: f64| libm::atan(slope).to_degrees();
    Choice {
        weight,
        sampled: count,
        fitted,
        noise: mean(&|it| it.noise).sqrt(),
        jet: degrees(jet),
        quadric: degrees(quadric),
        angle: degrees(angle),
    }
}

struct Scratch {
    rings: RingScratch,
    neighbours: Vec<DVec3>,
    neighbourhoods: Box<Neighbourhoods>,
    heights: Box<Column>,
}

impl Scratch {
    fn new(rings: &Rings<'_>) -> Self {
        Self {
            rings: rings.scratch(),
            neighbours: Vec::new(),
            neighbourhoods: Neighbourhoods::new(),
            heights: Box::new([Eight::ZERO; ROWS]),
        }
    }

    /// The estimates at eight groups, without those that a polynomial cannot be fitted to.
    fn of(&mut self, rings: &Rings<'_>, means: &[DVec3], eight: &[u32]) -> Vec<Estimate> {
        self.neighbourhoods.clear();
        let (mut counts, mut edges) = ([0; LANES], [0.0; LANES]);
        for (lane, &group) in eight.iter().enumerate() {
            let centre = rings.centre(group);
            self.neighbours.clear();
            rings.neighbours(group, JET[0].fewest, &mut self.rings, &mut self.neighbours);
            self.neighbourhoods.push(centre, means[group as usize], &self.neighbours);
            counts[lane] = self.neighbours.len();
            let ring = &self.neighbours[..rings.ring_size(group).min(counts[lane])];
            let scale = self.neighbourhoods.scale(lane);
            edges[lane] =
                ring.iter().map(|&at| ((at - centre) * scale).length()).sum::<f64>() / ring.len() as f64;
        }
        let [jet, lower, quadric] = FITS.map(|it| self.neighbourhoods.fit(it, Heights::Positions));
        let solved = jet.solved & lower.solved & quadric.solved;
        // Of noise: variances of slopes, of the jet, the quadric and their difference; residuals of degree 3 and 2.
        let mut spread = [[0.0; 5]; LANES];
        for draw in 0..DRAWS {
            for (lane, &group) in eight.iter().enumerate() {
                let mut signs = signs(u64::from(group) << 8 | draw as u64);
                let centre = signs.next().expect("there is no end");
                self.heights.iter_mut().zip(signs).for_each(|(height, sign)| height.0[lane] = sign - centre);
            }
            let [jet, lower, quadric] =
                FITS.map(|it| self.neighbourhoods.fit(it, Heights::Given(&self.heights)));
            for (lane, spread) in spread.iter_mut().enumerate() {
                let residuals = [jet.residual.0[lane], lower.residual.0[lane]];
                let (jet, quadric) = (jet.slopes(lane), quadric.slopes(lane));
                let [a, b, c] = [jet, quadric, quadric - jet].map(|it| it.length_squared());
                spread
                    .iter_mut()
                    .zip([a, b, c, residuals[0], residuals[1]])
                    .for_each(|(sum, it)| *sum += it / DRAWS as f64);
            }
        }
        let is_usable =
            |&lane: &usize| counts[lane] >= JET[0].fewest && solved >> lane & 1 == 1 && spread[lane][3] > 0.0;
        let estimate = |lane: usize| {
            let [of_jet, of_quadric, of_difference, third, second] = spread[lane];
            let (third, second) = (jet.residual.0[lane] / third, lower.residual.0[lane] / second);
            let variance = if third < second { third * (third / second) } else { third };
            Estimate {
                variance,
                noise: variance / (edges[lane] * edges[lane]),
                jet: jet.slopes(lane),
                quadric: quadric.slopes(lane),
                of_jet,
                of_quadric,
                of_difference,
            }
        };
        (0..eight.len()).filter(is_usable).map(estimate).collect()
    }
}

/// +1 and −1 as a hash has it (splitmix64).
fn signs(seed: u64) -> impl Iterator<Item = f64> {
    (1_u64..).map(move |i| {
        let mut z = (seed << 8 | i).wrapping_mul(0x9e37_79b9_7f4a_7c15);
        z = (z ^ (z >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        if (z ^ z >> 31) & 1 == 0 { 1.0 } else { -1.0 }
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::mesh::Mesh;
    use crate::normals::compute::compute;
    use crate::normals::fits::test_surfaces::{
        build, errors, hash, means_of, normals_of, patch, torus, with_rings,
    };
    use crate::normals::recipe::{Crease, NormalRecipe};

    fn choice(mesh: &Mesh) -> Choice {
        let corners = mesh.faces().corners();
        with_rings(mesh, corners, |rings| choose(&rings, &means_of(mesh, corners)))
    }

    /// The rms errors of jets, quadrics and angle means.
    fn true_errors(mesh: &Mesh, exact: &[DVec3]) -> [f64; 3] {
        let corners = mesh.faces().corners();
        let [jet, quadric] = [normals_of(mesh, corners, JET).0, normals_of(mesh, corners, [QUADRIC]).0];
        [jet, quadric, means_of(mesh, corners)].map(|normals| errors(&normals, exact).0)
    }

    /// The torus with vertices off the surface by up to so much either way.
    fn noisy_torus(m: u32, noise: f64) -> (Mesh, Vec<DVec3>) {
        let (mesh, exact) = torus(m, m / 2);
        let off = |v: usize| noise * (2.0 * hash(v as u32, 7, 11) - 1.0);
        let moved = mesh.positions().iter().zip(&exact).enumerate().map(|(v, (p, &n))| p + off(v) * n);
        (build(moved.collect(), mesh.faces().corners().to_vec()), exact)
    }

    /// From clean to noisy surfaces the choice has an error of at most 1.3 times the smallest, and changes from jets to quadrics.
    #[test]
    fn the_choice_is_close_to_the_best() {
        let mut chosen = Vec::new();
        for noise in [0.0, 1e-5, 1e-4, 3e-4, 1e-3, 3e-3, 1e-2] {
            let (mesh, exact) = noisy_torus(96, noise);
            let found = choice(&mesh);
            let errors = true_errors(&mesh, &exact);
            let of_choice = match found.weight {
                Weight::Jet => errors[0],
                Weight::Quadric => errors[1],
                _ => errors[2],
            };
            let smallest = errors.into_iter().fold(f64::INFINITY, f64::min);
            assert!(of_choice <= 1.3 * smallest, "{noise}: {errors:?} {found:?}");
            chosen.push(found.weight);
        }
        assert_eq!((chosen[0], chosen[1]), (Weight::Jet, Weight::Jet));
        assert_eq!(chosen[6], Weight::Quadric);
    }

    /// Noise of ±0.003, uniform: a standard deviation of 0.003/√3, on edges of about 0.06.
    #[test]
    fn estimates_are_close_to_the_errors_of_noise() {
        let (mesh, exact) = noisy_torus(96, 3e-3);
        let found = choice(&mesh);
        let [jet, quadric, _] = true_errors(&mesh, &exact);
        assert!((found.jet / jet - 1.0).abs() < 0.25, "{jet} {found:?}");
        assert!((found.quadric / quadric - 1.0).abs() < 0.4, "{quadric} {found:?}");
        let edges = mesh.faces().iter().map(|face| {
            let [a, b] = [face[0], face[1]].map(|v| mesh.positions().at(v));
            (a - b).length()
        });
        let edge = edges.sum::<f64>() / mesh.face_count() as f64;
        let noise = 3e-3 / 3.0_f64.sqrt() / edge;
        assert!((found.noise / noise - 1.0).abs() < 0.25, "{noise} {found:?}");
    }

    #[test]
    fn flat_and_tiny_meshes_have_the_angle_mean() {
        let plane = patch(12, |x, y| (0.3 * x - 0.7 * y, 0.3, -0.7)).0;
        let found = choice(&plane);
        assert_eq!((found.weight, found.jet, found.angle), (Weight::Angle, 0.0, 0.0), "{found:?}");
        assert_eq!(found.fitted, found.sampled);
        let square = patch(1, |_, _| (0.0, 0.0, 0.0)).0;
        let found = choice(&square);
        assert_eq!((found.weight, found.sampled, found.fitted), (Weight::Angle, 4, 0));
        assert_eq!(choice(&build(Vec::new(), Vec::new())).weight, Weight::Angle);
    }

    #[test]
    fn computing_normals_uses_the_choice() {
        for (noise, expected) in [(0.0, Weight::Jet), (1e-2, Weight::Quadric)] {
            let (mesh, _) = noisy_torus(48, noise);
            let normals = |weight| {
                let recipe = NormalRecipe { weight, crease: Crease::OFF, ..NormalRecipe::default() };
                compute(&mesh, &recipe)
            };
            let best = normals(Weight::Best);
            assert_eq!(best.summary.choice.unwrap().weight, expected);
            assert_eq!(best.normals, normals(expected).normals);
            assert_eq!(normals(expected).summary.choice, None);
        }
    }
}
