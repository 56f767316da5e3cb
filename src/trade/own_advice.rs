//! Which sum of faces to use on a user mesh, and how certain that is.

use super::advice::{digits, sentence};
use super::own::{ALIKE, OwnMesh, OwnMethod};
use super::reference::Reference;
use crate::normals::Weight;
use crate::num::three_digits;
use crate::text::Value;

/// With fewer normals, or a smaller share of them, estimates mean nothing.
const FEWEST: (usize, f64) = (20, 0.05);
/// With a smaller share, estimates are of a part of the mesh, and say nothing about the rest.
const WELL_COVERED: f64 = 0.5;
/// On fewer triangles a run takes microseconds, most of them independent of the weight.
const SMALL: usize = 10_000;
/// The default weight is recommended if its error is within this factor of the smallest.
const NEAR: f64 = 1.05;
/// A recommended weight is at most so many times as inaccurate as the best.
const TOLERANCE: f64 = 1.1;

impl Reference {
    /// How much the square of the reference's error may shift the squares of two errors against each other, in multiples.
    ///
    /// If errors of reference and weights were independent, the square of an estimate would be the sum of both squares, and
    /// 0.21 would do for [`TOLERANCE`]. They are not: both depend on the same vertices. Jets on stretched triangles differ
    /// from wider ones by as little as half of their error.
    fn slack(self) -> f64 {
        match self {
            Reference::Stored => 0.0,
            Reference::Jet => 3.0,
            Reference::Quadric => 1.0,
        }
    }
}

impl OwnMesh {
    /// Chooses the weight to use, with the reasons.
    pub(super) fn recommend(&mut self) {
        let mut reasons = Vec::new();
        let all_alike = self.alike == 1.0;
        if self.alike > 0.05 {
            reasons.push(sentence("alike", &[("share", percent(self.alike))]));
        }
        let (fewest, share) = FEWEST;
        let estimated = self.estimated_from as f64;
        if all_alike {
            self.candidates = vec![Weight::Angle];
            self.recommended = Some(Weight::Angle);
            reasons.push(sentence("safe", &[]));
        } else if self.estimated_from < fewest || estimated < share * self.normals as f64 {
            reasons.extend([sentence("too-few", &self.counts()), sentence("safe", &[])]);
        } else if (self.error_from as f64) < WELL_COVERED * estimated {
            let [estimated, _] = self.counts();
            let known = ("known", self.error_from.to_string().into());
            reasons.extend([sentence("unknown-error", &[estimated, known]), sentence("safe", &[])]);
        } else {
            reasons.push(self.about_reference());
            if estimated < WELL_COVERED * self.normals as f64 {
                let share = [("share", percent(estimated / self.normals as f64))];
                reasons.extend([sentence("partial", &share), sentence("safe", &[])]);
            } else {
                self.choose(&mut reasons);
            }
        }
        if (1..SMALL).contains(&self.timed_triangles) {
            let triangles = self.timed_triangles.into();
            reasons.push(sentence("few-triangles", &[("triangles", triangles)]));
        }
        self.reasons = reasons;
    }

    fn counts(&self) -> [(&'static str, Value); 2] {
        [("estimated", self.estimated_from.to_string().into()), ("all", self.normals.to_string().into())]
    }

    fn about_reference(&self) -> String {
        let [estimated, all] = self.counts();
        let key = match self.reference {
            Reference::Stored => "reference-stored",
            Reference::Jet => "reference-jet",
            Reference::Quadric if self.fits.noise() > self.fits.jet => "reference-noise",
            Reference::Quadric => "reference-quadric",
        };
        let gap = ("gap", digits(self.fits.jet_to_quadric));
        sentence(key, &[estimated, all, ("error", digits(self.reference_error)), gap])
    }

    /// Recommends a sum of faces if the error of the reference leaves it among the best.
    fn choose(&mut self, reasons: &mut Vec<String>) {
        let rms = |weight: Weight| self.method(weight).estimate.rms;
        let closest = |a: &Weight, b: &Weight| rms(*a).total_cmp(&rms(*b));
        let Some(best) = Weight::SUMS.into_iter().min_by(closest) else { return };
        let chosen = if rms(Weight::Angle) <= NEAR * rms(best) { Weight::Angle } else { best };
        let shift = self.reference.slack() * self.reference_error * self.reference_error;
        let may_be_better = |&other: &Weight| {
            let is_same = chosen == Weight::Angle && self.method(other).to_angle < ALIKE;
            let limit = TOLERANCE * rms(other);
            other == chosen || !is_same && rms(chosen) * rms(chosen) + shift > limit * limit
        };
        let candidates: Vec<Weight> = Weight::SUMS.into_iter().filter(may_be_better).collect();
        let named = |weight: Weight| format!("{} ({}°)", weight.name(), three_digits(rms(weight)));
        let is_certain = candidates.len() == 1;
        if is_certain {
            let values = [
                ("best", best.name().into()),
                ("rms", digits(rms(best))),
                ("usual-rms", digits(rms(Weight::Angle))),
            ];
            let key = match (chosen == best, chosen == Weight::Angle) {
                (true, true) => "closest-usual",
                (true, false) => "closest",
                (false, _) => "near-closest",
            };
            reasons.push(sentence(key, &values));
            reasons.push(sentence("cost", &[("ratio", digits(self.method(chosen).ratio))]));
            if rms(chosen) < 0.1 {
                reasons.push(sentence("any-weight", &[]));
            }
        } else {
            let names: Vec<String> = candidates.iter().copied().map(named).collect();
            let values = [("candidates", names.join(", ").into()), ("error", digits(self.reference_error))];
            reasons.push(sentence("undetermined", &values));
            reasons.push(match candidates.contains(&Weight::Angle) {
                true => sentence("safe", &[]),
                false => sentence("default", &[("usual-rms", digits(rms(Weight::Angle)))]),
            });
        }
        reasons.extend(self.about_fit(rms(best)));
        self.recommended = is_certain.then_some(chosen);
        self.candidates = candidates;
    }

    /// The fit that is more accurate than any sum.
    fn about_fit(&self, best_sum: f64) -> Option<String> {
        let (fit, rms): (&OwnMethod, f64) = match self.reference.weight() {
            Some(weight) => (self.method(weight), self.reference_error),
            None => {
                let fits = self.methods.iter().filter(|method| method.weight.is_fit());
                let fit = fits.min_by(|a, b| a.estimate.rms.total_cmp(&b.estimate.rms))?;
                (fit, fit.estimate.rms)
            }
        };
        // The estimate of a sum includes the error of the reference.
        let limit = best_sum * best_sum - self.reference_error * self.reference_error;
        let values = [("fit", fit.weight.name().into()), ("rms", digits(rms)), ("ratio", digits(fit.ratio))];
        (TOLERANCE * rms < limit.max(0.0).sqrt()).then(|| sentence("fit", &values))
    }
}

fn percent(share: f64) -> Value {
    format!("{:.0} %", 100.0 * share).into()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::normals::compute_on;
    use crate::num::AngleErrors;
    use crate::num::parallel;
    use crate::surface::{Plane, Surface};
    use crate::trade::cases::{NamedSurface, SampleMesh, Tiling};
    use crate::trade::cost::Costs;
    use crate::trade::effort::Effort;
    use crate::trade::own::Truth;
    use crate::trade::vertex::recipe;

    /// All weights that advice depends on. `best` would take as long as the others together.
    const COMPARED: [Weight; 8] = {
        let [uniform, area, angle, angle_area, max, edge, quadric, jet, _best] = Weight::ALL;
        [uniform, area, angle, angle_area, max, edge, quadric, jet]
    };

    /// What the advice on a mesh of a surface is, and how many times the best sum's error that of the recommended one is.
    fn outcome(surface: &NamedSurface, tiling: Tiling, level: u32) -> Option<(OwnMesh, f64)> {
        let sample = SampleMesh::new(surface, &tiling.tessellation(&surface.surface, level)).ok()?;
        let own = OwnMesh::of_weights(
            &COMPARED,
            &[&sample.mesh],
            &recipe(Weight::Angle),
            Truth::Estimated,
            &Costs::default(),
            &|_| (),
        );
        let error = |weight| {
            let field = compute_on(&sample.mesh, &sample.topology, &recipe(weight));
            // The rounding of positions is no error.
            AngleErrors::of(&sample.errors(&field)).rms.max(1e-9)
        };
        let best = Weight::SUMS.map(error).into_iter().fold(f64::INFINITY, f64::min);
        let ratio = own.recommended.map_or(1.0, |weight| error(weight) / best);
        Some((own, ratio))
    }

    /// Asserts that on surfaces of all kinds in all tilings the recommended sum is within 10 % of the best, and that none is
    /// recommended on at most so many of a hundred.
    fn assert_advice(level: u32, most_declined: usize) {
        let mut surfaces = NamedSurface::all(Effort::Full);
        surfaces.push(NamedSurface { name: "plane", surface: Surface::from(Plane::default()) });
        let pairs = surfaces.iter().flat_map(|surface| Tiling::ALL.map(|tiling| (surface, tiling)));
        let pairs: Vec<_> = pairs.filter(|(surface, tiling)| tiling.fits(&surface.surface)).collect();
        assert_eq!((surfaces.len(), pairs.len()), (12, 100));
        let found = parallel::map_each(&pairs, |&(surface, tiling)| {
            (surface.name, tiling.name(), outcome(surface, tiling, level).unwrap())
        });
        let wrong = found.iter().filter(|(_, _, (_, ratio))| *ratio > TOLERANCE);
        let wrong: Vec<_> = wrong.map(|(surface, tiling, (_, ratio))| (surface, tiling, ratio)).collect();
        let declined = found.iter().filter(|(_, _, (own, _))| own.recommended.is_none());
        let declined: Vec<_> = declined.map(|(surface, tiling, _)| (surface, tiling)).collect();
        assert!(
            wrong.is_empty() && declined.len() <= most_declined,
            "wrong: {wrong:?}, declined: {declined:?}"
        );
    }

    /// About 17 of 100 get none: teapots, and slivers on which two sums are more accurate than the reference.
    #[test]
    fn advice_is_right_or_none_is_given() {
        assert_advice(2, 20);
    }

    /// On so coarse a mesh hardly any fit has a wider one: the error of the reference is unknown, and not 0.
    #[test]
    fn no_sum_is_recommended_if_the_error_of_the_reference_is_unknown() {
        let surfaces = NamedSurface::all(Effort::Full);
        let ellipsoid = surfaces.iter().find(|surface| surface.name == "ellipsoid").unwrap();
        let (own, _) = outcome(ellipsoid, Tiling::Icosphere, 0).unwrap();
        assert!(2 * own.error_from < own.estimated_from, "{} of {}", own.error_from, own.estimated_from);
        assert_eq!(own.recommended, None);
        assert!(own.reasons.iter().any(|reason| reason.contains("error of the reference is unknown")));
    }
}
