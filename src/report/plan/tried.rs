//! Error against cost of all that was tried.

use super::decisions::{TEXTS, cost, name_of, text};
use crate::plan::{Evidence, Metric, Minimise, Plan, Tried};
use crate::report::plot::{Axis, Mark, Plot, Series};
use crate::text::Language;
use std::collections::HashSet;

/// Cells along each axis: of the points in one only one is drawn.
const CELLS: f64 = 60.0;

/// The plot, with the plan, the declared scene and the Pareto frontier of what is within the limits.
pub(super) fn tried_plot(
    plan: &Plan,
    evidence: &Evidence,
    (minimise, metric): (Minimise, Metric),
    tolerance: f64,
    language: Language,
) -> Plot {
    let name = |key: &str| text(key, &[], language);
    // Exact models are at the lower end of a logarithmic axis.
    let least =
        evidence.tried.iter().map(|it| it.error).filter(|&error| error > 0.0).fold(tolerance, f64::min);
    let floor = (0.5 * least).max(f64::MIN_POSITIVE);
    let place = |it: &Tried| [it.cost as f64, it.error.max(floor)];
    let planned = [plan.planned.of(minimise) as f64, plan.worst.by(metric).max(floor)];
    let declared = [plan.declared.of(minimise) as f64, floor];
    let of = |is_within: bool| -> Vec<[f64; 2]> {
        evidence.tried.iter().filter(|it| it.is_within == is_within).map(place).collect()
    };
    let mut costs: Vec<f64> = evidence.tried.iter().map(|it| it.cost as f64).collect();
    costs.extend([planned[0], declared[0]]);
    let [low, high] =
        [costs.iter().copied().fold(f64::INFINITY, f64::min), costs.iter().copied().fold(0.0, f64::max)];
    let (within, refused) = (of(true), of(false));
    let mut frontier = frontier(within.iter().chain([&planned, &declared]).copied().collect());
    frontier.dedup();
    let series = vec![
        Series::new(&name("plot-frontier"), frontier, Mark::Frontier),
        Series::new(&name("plot-tolerance"), vec![[low, tolerance], [high, tolerance]], Mark::Guide),
        Series { colour: Some(1), ..Series::new(&name("plot-refused"), thinned(refused), Mark::Hollow) },
        Series { colour: Some(0), ..Series::new(&name("plot-within"), thinned(within), Mark::Hollow) },
        Series { colour: Some(4), ..Series::new(&name("plot-declared"), vec![declared], Mark::Points) },
        Series { colour: Some(2), ..Series::new(&name("plot-planned"), vec![planned], Mark::Points) },
    ];
    let values = [
        ("tried", (evidence.tried.len() as u64).into()),
        ("cost", cost(plan.planned.of(minimise), minimise).into()),
        ("declared", cost(plan.declared.of(minimise), minimise).into()),
    ];
    Plot {
        title: name("plot-title"),
        description: TEXTS.with("plot-description", &values).get(language).to_owned(),
        x: Axis::log(&name(name_of(minimise))),
        y: Axis::log(&name(match metric {
            Metric::Steps => "plot-steps",
            Metric::Flip => "plot-flip",
        })),
        series,
        language,
    }
}

/// Points that no other one is cheaper and more accurate than, by ascending cost.
fn frontier(mut points: Vec<[f64; 2]>) -> Vec<[f64; 2]> {
    points.sort_by(|a, b| a[0].total_cmp(&b[0]).then(a[1].total_cmp(&b[1])));
    let mut least = f64::INFINITY;
    points.retain(|point| {
        let is_better = point[1] < least;
        least = least.min(point[1]);
        is_better
    });
    points
}

/// One point of each cell of a logarithmic grid.
fn thinned(mut points: Vec<[f64; 2]>) -> Vec<[f64; 2]> {
    let range = |axis: usize| {
        let values = points.iter().map(move |point| libm::log2(point[axis]));
        let low = values.clone().fold(f64::INFINITY, f64::min);
        (low, (values.fold(f64::NEG_INFINITY, f64::max) - low).max(f64::MIN_POSITIVE))
    };
    let ranges = [range(0), range(1)];
    let mut seen = HashSet::new();
    points.retain(|point| {
        let cell = [0, 1].map(|axis| {
            let (low, span) = ranges[axis];
            (CELLS * (libm::log2(point[axis]) - low) / span) as u32
        });
        seen.insert(cell)
    });
    points
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_frontier_has_no_dominated_point() {
        let points = vec![[3.0, 1.0], [1.0, 5.0], [2.0, 6.0], [2.0, 2.0], [4.0, 1.0]];
        assert_eq!(frontier(points), [[1.0, 5.0], [2.0, 2.0], [3.0, 1.0]]);
    }

    #[test]
    fn a_cell_keeps_one_point() {
        let points: Vec<[f64; 2]> = (0..10_000).map(|i| [1.0 + f64::from(i), 1.0]).collect();
        let thin = thinned(points.clone());
        assert!(thin.len() <= 61 && thin.contains(&points[0]) && thin.len() > 20, "{}", thin.len());
    }
}
