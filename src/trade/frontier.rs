//! Error against cost of every weight on each class of meshes, and the Pareto frontier.

use super::angles::median;
use super::cases::Tiling;
use super::cost::Costs;
use super::vertex::VertexCase;
use crate::normals::Weight;
use serde::Serialize;

/// The weights on one class of meshes.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct MeshClass {
    /// The class.
    pub tiling: Tiling,
    /// The number of surfaces that medians are over.
    pub surfaces: usize,
    /// One for each of [`Weight::ALL`].
    pub points: Vec<ClassPoint>,
}

/// The error of a weight on a class of meshes, and its cost.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct ClassPoint {
    /// The weight.
    pub weight: Weight,
    /// The median, over surfaces, of the rms error on the quoted mesh without boundary vertices, in degrees. The mean would be
    /// dominated by surfaces with points at which all weights are inaccurate: the folds of the teapot, the tip of the cone.
    pub rms: f64,
    /// The smallest and the largest such median of five seeds; both the median itself where meshes have no random numbers.
    pub spread: [f64; 2],
    /// Times the plain loop, on one thread, through slices except for fits.
    pub ratio: f64,
    /// The most accurate of the weights that are both cheaper and more accurate; `None` on the Pareto frontier.
    pub dominated_by: Option<Weight>,
}

impl MeshClass {
    /// The class of a tiling; `None` if no surface was cut like this.
    pub(super) fn of(cases: &[VertexCase], costs: &Costs, tiling: Tiling) -> Option<Self> {
        let cases: Vec<&VertexCase> =
            cases.iter().filter(|case| case.tiling == tiling && case.quoted < case.meshes.len()).collect();
        let point = |weight: Weight| {
            let methods = || cases.iter().filter_map(|case| Some((case.quoted, case.method(weight)?)));
            let seeds = methods().map(|(_, method)| method.seeds.len()).min()?;
            let rms = median(methods().map(|(quoted, method)| method.errors[quoted].rms).collect())?;
            let others =
                (0..seeds).filter_map(|seed| median(methods().map(|(_, it)| it.seeds[seed]).collect()));
            let widen = |[low, high]: [f64; 2], other: f64| [low.min(other), high.max(other)];
            let spread = others.fold([rms; 2], widen);
            Some(ClassPoint { weight, rms, spread, ratio: costs.cheapest(weight)?, dominated_by: None })
        };
        let mut points: Vec<ClassPoint> = Weight::ALL.into_iter().filter_map(point).collect();
        mark_dominated(&mut points);
        (!points.is_empty()).then_some(Self { tiling, surfaces: cases.len(), points })
    }

    /// The largest difference of a median of another seed, as a share of the median.
    pub fn spread(&self) -> f64 {
        let share = |point: &ClassPoint| {
            let [low, high] = point.spread;
            (high - point.rms).max(point.rms - low) / point.rms
        };
        self.points.iter().filter(|point| point.rms > 0.0).map(share).fold(0.0, f64::max)
    }
}

/// Records for each point which other is cheaper and more accurate.
pub fn mark_dominated(points: &mut [ClassPoint]) {
    let best = frontier(points);
    for point in points {
        let is_on_it = best.iter().any(|other| other.weight == point.weight);
        let better = best.iter().rfind(|other| other.ratio <= point.ratio);
        point.dominated_by = better.filter(|_| !is_on_it).map(|other| other.weight);
    }
}

/// The points that no other beats in both cost and error: the Pareto frontier, by ascending cost.
pub fn frontier(points: &[ClassPoint]) -> Vec<ClassPoint> {
    let mut sorted = points.to_vec();
    sorted.sort_by(|a, b| a.ratio.total_cmp(&b.ratio).then(a.rms.total_cmp(&b.rms)));
    let mut best = f64::INFINITY;
    sorted.retain(|point| {
        let better = point.rms < best;
        best = best.min(point.rms);
        better
    });
    sorted
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn nothing_beats_the_frontier() {
        let point =
            |weight, ratio, rms| ClassPoint { weight, rms, spread: [rms; 2], ratio, dominated_by: None };
        let mut points = [
            point(Weight::Quadric, 300.0, 0.1),
            point(Weight::Uniform, 2.0, 1.6),
            point(Weight::Max, 1.8, 0.5),
            point(Weight::Area, 1.0, 2.0),
            point(Weight::Angle, 3.0, 0.7),
            point(Weight::Jet, 400.0, 0.2),
        ];
        let weights: Vec<Weight> = frontier(&points).into_iter().map(|point| point.weight).collect();
        assert_eq!(weights, [Weight::Area, Weight::Max, Weight::Quadric]);
        mark_dominated(&mut points);
        let by = points.map(|point| point.dominated_by);
        assert_eq!(by, [None, Some(Weight::Max), None, None, Some(Weight::Max), Some(Weight::Quadric)]);
        assert!(frontier(&[]).is_empty());
    }
}
