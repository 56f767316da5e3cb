//! Fits of recipes to a sample of stored normals: which edges are smooth, by which weighting, with which error.

use crate::normals::{Crease, Weight};
use crate::num::Degrees;
use crate::num::parallel;
use crate::quality::angles::{SAME, degrees_between};
use crate::quality::estimate::crease_angle::{EdgeSample, exact_separating_angle, separating_angle};
use crate::quality::estimate::means::{Factors, MEANS, PoleCache, Smoothness, Sums, equal_creases, sums};
use crate::quality::estimate::quadrics::Patch;
use crate::quality::estimate::recipe::{EXACT, Estimate, LEFT, NEARLY_ALL, REPRODUCED, SAMPLE};
use crate::quality::estimate::rotation::{are_spread, robust_rotation, rotation_angle};
use crate::quality::input::part::Part;
use glam::{DMat3, DVec3};
use std::sync::Arc;

/// The most corners that quadrics are fitted at.
const FITTED: usize = 2048;

/// Means of no larger average error, in degrees, are good enough: what rounding to four decimals leaves.
const FINE: f64 = 0.01;

/// How many smooth edges above the crease angle a sharp one below it counts for, if those may all be the only sharp edges at
/// their vertices.
const LONE: usize = 16;

/// The sampled corners, and the edges at them.
pub(crate) struct Sample<'a> {
    part: &'a Part<'a>,
    corners: Vec<u32>,
    normals: Vec<DVec3>,
    edges: Vec<EdgeSample>,
    factors: Arc<Factors>,
}

/// The fit of a rule about edges to a sample, with the best weighting for it.
pub(crate) struct Fit {
    pub(crate) estimate: Estimate,
    cost: f64,
    /// The error at each corner in degrees, ascending.
    errors: Vec<f64>,
    /// The rotation of all normals, if that is part of the fit.
    pub(crate) rotation: Option<DMat3>,
}

impl Fit {
    /// Whether a rotation of all normals explains the errors of the normals as stored. What negating single ones explains as well
    /// is no rotation of all: on a box with the normals of some sides negated, half a turn fits. If a recipe reproduces the
    /// normals, many may be rotated by little, so the sum decides; if none quite does, the median.
    fn explains(&self, as_stored: &Fit) -> bool {
        let mut either_way: Vec<f64> =
            as_stored.errors.iter().map(|error| error.min(180.0 - error)).collect();
        either_way.sort_unstable_by(f64::total_cmp);
        self.rotation.is_some_and(|rotation| rotation_angle(rotation) > SAME)
            && self.estimate.fits_most()
            && (self.cost < LEFT * cost(&either_way) || median(&self.errors) < LEFT * median(&either_way))
    }
}

/// Estimates from a fixed sample; `None` if no corner has a usable normal. If no recipe reproduces the normals as stored, all may
/// have been rotated: the second value is the rotation from computed to stored normals.
pub(crate) fn estimate(part: &Part<'_>) -> Option<(Estimate, Option<DMat3>)> {
    let sample = Sample::of(part)?;
    let as_stored = sample.best();
    let is_rule = as_stored.estimate.is_rule();
    let rotated_back = if is_rule { None } else { sample.best_rotated_back(&as_stored) };
    let mut best = rotated_back.unwrap_or(as_stored);
    best.estimate.creases = sample.equal_creases(&best.estimate);
    Some((best.estimate, best.rotation))
}

/// The sum of errors. Corners far off are faults, not evidence: all beyond the bound count alike.
fn cost(errors: &[f64]) -> f64 {
    errors.iter().map(|error| error.min(REPRODUCED)).sum()
}

fn median(ascending: &[f64]) -> f64 {
    ascending[ascending.len() / 2]
}

impl<'a> Sample<'a> {
    pub(crate) fn of(part: &'a Part<'a>) -> Option<Self> {
        part.stored?;
        let corners = corners(part);
        let unit = |&corner: &u32| part.stored_unit(corner as usize).expect("the sample has directions");
        let normals = parallel::map_each(&corners, unit);
        let edges = parallel::filter_map(corners.len(), |i| EdgeSample::at(part, corners[i]));
        (!corners.is_empty()).then(|| Self {
            part,
            corners,
            normals,
            edges,
            factors: Arc::new(Factors::of(part, SAMPLE)),
        })
    }

    pub(crate) fn best(&self) -> Fit {
        let by_means = self.best_mean(false);
        self.by_quadrics(&by_means).unwrap_or(by_means)
    }

    /// The lowest crease angle that makes the same normals as an estimate, and the one from which on others result.
    fn equal_creases(&self, estimate: &Estimate) -> [Degrees; 2] {
        let groups = self.part.mesh.columns().smoothing.as_ref().filter(|_| estimate.groups);
        let rule = Smoothness::new(estimate.crease, groups.map(|groups| groups.of_face.as_slice()));
        let poles = PoleCache::default();
        let at_corners =
            parallel::map_each(&self.corners, |&corner| equal_creases(self.part, corner, rule, &poles));
        let narrower = |a: [f64; 2], b: [f64; 2]| [a[0].max(b[0]), a[1].min(b[1])];
        at_corners.into_iter().fold([0.0, 180.0], narrower).map(Degrees)
    }

    /// The best fit to all normals rotated back, if that explains the errors of the normals as stored.
    pub(crate) fn best_rotated_back(&self, as_stored: &Fit) -> Option<Fit> {
        let rotated_back = self.best_mean(true);
        let explains = are_spread(self.normals.iter().copied()) && rotated_back.explains(as_stored);
        explains.then_some(rotated_back)
    }

    /// The rule about edges and the mean that fit best, to the normals as stored or rotated back.
    fn best_mean(&self, rotated_back: bool) -> Fit {
        let sharp_from = |crease| Smoothness::new(crease, None);
        let separating = separating_angle(&self.edges, 1);
        let mut plain = self.by_rule(sharp_from(separating), rotated_back);
        // A sharp edge that is the only one at its vertex splits nothing and looks smooth, so the angle that separates best need
        // not be that of the recipe. Edges that look sharp are sharp.
        if plain.estimate.reproduced < 1.0 {
            let known = [separating];
            // Many single faults at the ends of edges shift the best angle.
            for other in candidates(&self.edges, &known).into_iter().chain(next_to(separating)) {
                let other = self.by_rule(sharp_from(other), rotated_back);
                plain = if other.cost < plain.cost { other } else { plain };
            }
        }
        let groups = self.part.mesh.columns().smoothing.as_ref();
        if let Some(groups) = groups.filter(|_| plain.estimate.exactly < NEARLY_ALL) {
            let left = self.in_one_group();
            let separating = separating_angle(&left, 1);
            let known = [Crease::DEFAULT_ANGLE, plain.estimate.crease, separating, Degrees(180.0)];
            for crease in known.into_iter().chain(candidates(&left, &known)) {
                let other = self.by_rule(Smoothness::new(crease, Some(&groups.of_face)), rotated_back);
                let closeness = |fit: &Fit| [fit.estimate.reproduced, fit.estimate.exactly];
                plain = if closeness(&other) > closeness(&plain) { other } else { plain };
            }
        }
        plain
    }

    fn by_rule(&self, rule: Smoothness<'_>, rotated_back: bool) -> Fit {
        let poles = PoleCache::default();
        let sums = |&corner: &u32| sums((self.part, &self.factors), corner, rule, &poles);
        let sums: Vec<Sums> = parallel::map_each(&self.corners, sums);
        let rotation = |weight| if rotated_back { robust_rotation(&self.pairs(&sums, weight)) } else { None };
        // Weightings differ by little and in all directions: any of them gives the rotation.
        let about = rotation(0);
        let by_weight: [Vec<f64>; MEANS.len()] =
            std::array::from_fn(|weight| self.errors(&sums, weight, about));
        let costs = by_weight.each_ref().map(|errors| cost(errors));
        // If all are as good, as on flat shapes, the first.
        let best = (1..MEANS.len())
            .fold(0, |best, i| if costs[i] < costs[best] * (1.0 - 1e-3) - 1e-9 { i } else { best });
        let rotation = rotation(best);
        let errors = self.errors(&sums, best, rotation);
        let mut fit = self.fit(MEANS[best], rule, errors, rotation);
        let bound = fit.cost.max(costs[best]) * (1.0 + 1e-3) + FINE * self.corners.len() as f64;
        let (tolerance, share) = fit.estimate.tolerance();
        fit.estimate.ties = std::array::from_fn(|i| {
            let within = by_weight[i].iter().filter(|&&error| error <= tolerance).count() as f64;
            let fits = within >= NEARLY_ALL * share * self.corners.len() as f64;
            fits && (tolerance > EXACT || costs[i] <= bound)
        });
        fit
    }

    fn fit(
        &self,
        weight: Weight,
        rule: Smoothness<'_>,
        mut errors: Vec<f64>,
        rotation: Option<DMat3>,
    ) -> Fit {
        let crease = rule.crease;
        let cost = cost(&errors);
        errors.sort_unstable_by(f64::total_cmp);
        let count = errors.len() as f64;
        let within = |most: f64| errors.partition_point(|&error| error <= most) as f64 / count;
        let separated = self.edges.iter().filter(|edge| (edge.degrees < crease.0) == edge.smooth).count();
        let reproduced = within(REPRODUCED);
        let estimate = Estimate {
            weight,
            crease,
            groups: rule.groups.is_some(),
            turned: rotation.is_some(),
            sample: errors.len(),
            reproduced,
            closely: within(SAME),
            exactly: within(EXACT),
            separated: match (rule.groups, self.edges.len()) {
                (None, 1..) => separated as f64 / self.edges.len() as f64,
                (None, 0) => 1.0,
                // Groups decide which edges are sharp, not the angle.
                (Some(_), _) => reproduced,
            },
            median: Degrees(median(&errors)),
            creases: [crease; 2],
            ties: [false; MEANS.len()],
        };
        Fit { estimate, cost, errors, rotation }
    }

    /// The best fit by quadrics, if the normals were made by these rather than by means.
    fn by_quadrics(&self, by_means: &Fit) -> Option<Fit> {
        let (means, count) = (&by_means.estimate, self.corners.len());
        if by_means.cost <= FINE * count as f64 {
            return None;
        }
        let few: Vec<usize> = (0..count.min(FITTED)).map(|i| i * count / count.min(FITTED)).collect();
        let corners: Vec<u32> = few.iter().map(|&i| self.corners[i]).collect();
        let patch = Patch::around(self.part, &corners);
        let usable = || patch.indices().map(|index| few[index]);
        let few = Sample {
            part: self.part,
            corners: usable().map(|i| self.corners[i]).collect(),
            normals: usable().map(|i| self.normals[i]).collect(),
            edges: self.edges.clone(),
            factors: self.factors.clone(),
        };
        if few.corners.is_empty() {
            return None;
        }
        let groups = self.part.mesh.columns().smoothing.as_ref().filter(|_| means.groups);
        let rule = |crease| Smoothness::new(crease, groups.map(|groups| groups.of_face.as_slice()));
        let by_quadric = |crease| few.by_quadric(rule(crease), &patch.normals(crease, means.groups));
        let mut best = by_quadric(means.crease);
        // If a fit is far from all means, their crease angle says little about its own.
        for known in [Crease::DEFAULT_ANGLE, Degrees(180.0)] {
            if best.estimate.exactly < 1.0 && known != means.crease {
                let other = by_quadric(known);
                best = if other.cost < best.cost { other } else { best };
            }
        }
        if best.cost >= LEFT * few.by_rule(rule(means.crease), false).cost {
            return None;
        }
        // A single edge next to the angle may show on neither side.
        if best.estimate.exactly < 1.0 {
            let edges = if means.groups { self.in_one_group() } else { self.edges.clone() };
            let known = [means.crease, Crease::DEFAULT_ANGLE, Degrees(180.0)];
            for other in candidates(&edges, &known).into_iter().chain(next_to(means.crease)) {
                let other = by_quadric(other);
                best = if other.cost < best.cost { other } else { best };
            }
        }
        patch.is_fitted(best.estimate.crease, means.groups).then_some(best)
    }

    fn by_quadric(&self, rule: Smoothness<'_>, quadrics: &[DVec3]) -> Fit {
        let error = |(&stored, &fitted): (&DVec3, &DVec3)| degrees_between(stored, fitted);
        let errors = self.normals.iter().zip(quadrics).map(error).collect();
        self.fit(Weight::Quadric, rule, errors, None)
    }

    /// The edges that smoothing groups leave to the angle.
    fn in_one_group(&self) -> Vec<EdgeSample> {
        self.edges.iter().copied().filter(|edge| edge.in_one_group).collect()
    }

    /// Stored normals and the means by a weighting, as unit vectors.
    fn pairs(&self, sums: &[Sums], weight: usize) -> Vec<(DVec3, DVec3)> {
        parallel::map(sums.len(), |i| (self.normals[i], sums[i][weight].normalize_or_zero()))
    }

    /// The angle in degrees between each stored normal and the mean by a weighting, rotated.
    fn errors(&self, sums: &[Sums], weight: usize, rotation: Option<DMat3>) -> Vec<f64> {
        let mean = |sums: &Sums| rotation.map_or(sums[weight], |rotation| rotation * sums[weight]);
        // A sum that cancels has no direction, and reproduces nothing.
        parallel::map(sums.len(), |i| match mean(&sums[i]) {
            DVec3::ZERO => 180.0,
            mean => degrees_between(self.normals[i], mean),
        })
    }
}

/// Crease angles to try in addition to that of [`separating_angle`], without those that are known already.
fn candidates(edges: &[EdgeSample], known: &[Degrees]) -> Vec<Degrees> {
    let exact = exact_separating_angle(edges, LONE);
    // People type whole numbers.
    let all = [Crease::DEFAULT_ANGLE, separating_angle(edges, LONE), Degrees(exact.0.round()), exact];
    let is_new = |&at: &usize| !known.contains(&all[at]) && !all[..at].contains(&all[at]);
    (0..all.len()).filter(is_new).map(|at| all[at]).collect()
}

/// The crease angles one degree less and more.
fn next_to(crease: Degrees) -> [Degrees; 2] {
    [-1.0, 1.0].map(|by| Degrees((crease.0 + by).clamp(0.0, 180.0)))
}

/// Corners with a direction on sound faces; if there are too many, a fixed choice of them.
fn corners(part: &Part<'_>) -> Vec<u32> {
    let count = part.mesh.faces().corner_count();
    let is_usable = |&corner: &u32| {
        part.is_sound(part.face_of(corner as usize)) && part.stored_unit(corner as usize).is_some()
    };
    if count <= SAMPLE {
        return (0..count as u32).filter(is_usable).collect();
    }
    // One corner of each stretch of equal length, so that all of the mesh counts.
    let pick = |stretch: usize| {
        let (from, to) = (stretch * count / SAMPLE, (stretch + 1) * count / SAMPLE);
        (from + (mixed(stretch as u64) % (to - from) as u64) as usize) as u32
    };
    parallel::filter_map(SAMPLE, |stretch| Some(pick(stretch)).filter(is_usable))
}

fn mixed(seed: u64) -> u64 {
    let z = seed.wrapping_add(1).wrapping_mul(0x9e37_79b9_7f4a_7c15);
    let z = (z ^ (z >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
    let z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
    z ^ (z >> 31)
}
