//! Which of the jet, the quadric and the angle mean has the smallest estimated error on a mesh.

use crate::normals::fits::differences::FitDifferences;
use crate::normals::fits::fitted_normals::fitted_normals;
use crate::normals::fits::jet::JET;
use crate::normals::fits::quadric::QUADRIC;
use crate::normals::fits::rings::Rings;
use crate::normals::recipe::Weight;
use crate::num::{CompensatedSum, Degrees, Radians, angle_between};
use glam::DVec3;

/// Smooth groups that estimates are from, at most.
const SAMPLE: usize = 1024;

/// The share of groups whose jets are noisiest, which do not count: tips and folds say nothing about the rest.
const OUTLIERS: f64 = 0.1;

/// Jets whose estimated error over all groups is more than so many times that of quadrics are not chosen: on noisy surfaces most of
/// the error may be at a tenth of the groups. The limit was measured on 443 surfaces of all patterns with noise of 0 to 0.05.
const VETO: f64 = 1.5;

/// Angles below this are rounding, in radians.
const ROUNDING: f64 = 1.0 / (1_u64 << 40) as f64;

/// The estimated errors of the weights that [`Weight::Best`] chooses from.
#[derive(Clone, Copy, Debug, PartialEq, serde::Serialize)]
pub struct Choice {
    /// [`Weight::Jet`], [`Weight::Quadric`] or [`Weight::Angle`].
    pub weight: Weight,
    /// Smooth groups with a normal of their own that were sampled.
    pub sampled: usize,
    /// Of these, groups that have both fits, and both to one more ring.
    pub fitted: usize,
    /// The part of the jets' error that is due to noise, in degrees.
    pub noise: f64,
    /// The estimated rms error of jets, in degrees.
    pub jet: f64,
    /// That of quadrics.
    pub quadric: f64,
    /// That of angle means.
    pub angle: f64,
}

/// The squares of the angles between fits, and between these and the mean, at one smooth group.
#[derive(Clone, Copy)]
struct Squares {
    jet_to_wider: f64,
    quadric_to_wider: f64,
    jet_to_quadric: f64,
    jet_to_mean: f64,
    quadric_to_mean: f64,
}

/// Chooses by the smallest estimated error.
///
/// Fits to each of a sample of smooth groups, and fits to one more ring of neighbours, give the errors of jet and quadric (see
/// [`FitDifferences`]). The error of the angle mean is its difference from the better of the two. Averages are over the groups but the
/// tenth with the largest |j − q|² + |j − j'|², or over all groups if these give jets more than 1.5 times the error of quadrics. So the
/// angle mean is chosen where it differs from the better fit by less than the error of that. It is also chosen if fewer than half of
/// the groups have all four fits.
pub(crate) fn choose(rings: &Rings<'_>, means: &[DVec3], more_rings: usize) -> Choice {
    let groups: Vec<u32> = (0..means.len() as u32)
        .filter(|&group| means[group as usize] != DVec3::ZERO && !rings.groups(group).is_empty())
        .collect();
    let count = groups.len().min(SAMPLE);
    let sample: Vec<u32> = (0..count).map(|i| groups[i * groups.len() / count]).collect();
    let [jets, wider_jets] =
        [0, 1].map(|more| fitted_normals(rings, JET, more_rings + more, means, &sample, &|_| ()).0);
    let [quadrics, wider_quadrics] =
        [0, 1].map(|more| fitted_normals(rings, [QUADRIC], more_rings + more, means, &sample, &|_| ()).0);
    let square = |a: DVec3, b: DVec3| {
        let Radians(angle) = angle_between(a, b);
        angle * angle
    };
    let squares = |i: usize| {
        let (jet, quadric, mean) = (jets[i], quadrics[i], means[sample[i] as usize]);
        let all = [jet, quadric, wider_jets[i], wider_quadrics[i]];
        all.iter().all(|&fit| fit != DVec3::ZERO).then(|| Squares {
            jet_to_wider: square(jet, wider_jets[i]),
            quadric_to_wider: square(quadric, wider_quadrics[i]),
            jet_to_quadric: square(jet, quadric),
            jet_to_mean: square(jet, mean),
            quadric_to_mean: square(quadric, mean),
        })
    };
    let mut squares: Vec<Squares> = (0..count).filter_map(squares).collect();
    let fitted = squares.len();
    let size = |it: &Squares| it.jet_to_quadric + it.jet_to_wider;
    squares.sort_by(|a, b| size(a).total_cmp(&size(b)));
    let overall = differences(&squares);
    let trimmed = &squares[..fitted - (OUTLIERS * fitted as f64) as usize];
    let (differences, squares) = match overall.jet_error() > VETO * overall.quadric_error() {
        true => (overall, &squares[..]),
        false => (differences(trimmed), trimmed),
    };
    let (jet, quadric) = (differences.jet_error(), differences.quadric_error());
    let is_jet_better = jet <= quadric;
    let rms = |of| rms(squares, of);
    let angle = if is_jet_better { rms(|it| it.jet_to_mean) } else { rms(|it| it.quadric_to_mean) };
    let weight = match is_jet_better {
        _ if 2 * fitted < count || angle <= jet.min(quadric) => Weight::Angle,
        true => Weight::Jet,
        false => Weight::Quadric,
    };
    Choice { weight, sampled: count, fitted, noise: differences.noise(), jet, quadric, angle }
}

/// The root of the mean of these squares, in degrees.
fn rms(squares: &[Squares], of: fn(&Squares) -> f64) -> f64 {
    let mut sum = CompensatedSum::default();
    squares.iter().for_each(|squares| sum += of(squares));
    let rms = (sum.value() / squares.len().max(1) as f64).sqrt();
    Degrees::from(Radians(if rms < ROUNDING { 0.0 } else { rms })).0
}

/// The rms differences between the fits.
fn differences(squares: &[Squares]) -> FitDifferences {
    FitDifferences {
        jet: rms(squares, |it| it.jet_to_wider),
        quadric: rms(squares, |it| it.quadric_to_wider),
        jet_to_quadric: rms(squares, |it| it.jet_to_quadric),
    }
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
        with_rings(mesh, corners, |rings| choose(&rings, &means_of(mesh, corners), 0))
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

    /// From clean to noisy surfaces the choice changes from jets to quadrics, with an error of at most 1.3 times the smallest. Where it
    /// changes, between noise of 3e-4 and 1e-3, both fits are about as accurate as each other, and 1.52 times was measured.
    #[test]
    fn the_choice_is_close_to_the_best() {
        let mut chosen = Vec::new();
        for noise in [0.0, 1e-5, 1e-4, 3e-4, 4.5e-4, 6e-4, 1e-3, 3e-3, 1e-2] {
            let (mesh, exact) = noisy_torus(96, noise);
            let found = choice(&mesh);
            let errors = true_errors(&mesh, &exact);
            let of_choice = match found.weight {
                Weight::Jet => errors[0],
                Weight::Quadric => errors[1],
                _ => errors[2],
            };
            let smallest = errors.into_iter().fold(f64::INFINITY, f64::min);
            let most = if matches!(noise, 4.5e-4 | 6e-4) { 1.6 } else { 1.3 };
            assert!(of_choice <= most * smallest, "{noise}: {errors:?} {found:?}");
            chosen.push(found.weight);
        }
        assert_eq!((chosen[0], chosen[1]), (Weight::Jet, Weight::Jet));
        assert_eq!(chosen[5..], [Weight::Quadric; 4]);
    }

    /// Noise of ±0.003, uniform, on edges of about 0.06.
    #[test]
    fn estimates_are_close_to_the_errors_of_noise() {
        let (mesh, exact) = noisy_torus(96, 3e-3);
        let found = choice(&mesh);
        let [jet, quadric, _] = true_errors(&mesh, &exact);
        assert!((found.jet / jet - 1.0).abs() < 0.25, "{jet} {found:?}");
        assert!((found.quadric / quadric - 1.0).abs() < 0.4, "{quadric} {found:?}");
    }

    #[test]
    fn flat_and_tiny_meshes_have_the_angle_mean() {
        let plane = patch(12, |x, y| (0.3 * x - 0.7 * y, 0.3, -0.7)).0;
        let found = choice(&plane);
        assert_eq!((found.weight, found.jet, found.angle), (Weight::Angle, 0.0, 0.0), "{found:?}");
        // A corner has too few neighbours for a quadric.
        assert_eq!(found.fitted + 1, found.sampled);
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
