//! The whole measurement, and its summary for each class of meshes.

use super::angles::median;
use super::approximations::{ApproximationRow, approximation_rows};
use super::cases::Tiling;
use super::cost::Costs;
use super::effort::{Effort, Observer};
use super::encodings::{EncodingRow, encoding_rows};
use super::precision::{PrecisionRow, precision_rows};
use super::shading::{ShadingRow, shading_rows};
use super::solids::{BoxRow, box_rows};
use super::vertex::{VertexCase, vertex_cases};
use crate::normals::Weight;
use crate::raster::RenderError;
use serde::Serialize;

/// A whole measurement. Errors are the same bits in every run and at any number of threads; nanoseconds, milliseconds and
/// ratios are not.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Trade {
    /// How much was measured.
    pub effort: Effort,
    /// Vertex normals against the truth.
    pub vertex: Vec<VertexCase>,
    /// Boxes, cut in every way.
    pub boxes: Vec<BoxRow>,
    /// The cost of vertex normals.
    pub costs: Costs,
    /// Single precision compared with faithful.
    pub precision: Vec<PrecisionRow>,
    /// Ways to store normals.
    pub encodings: Vec<EncodingRow>,
    /// Ways to shade.
    pub shading: Vec<ShadingRow>,
    /// The crate's own approximations.
    pub approximations: Vec<ApproximationRow>,
}

impl Trade {
    /// Measures everything. Vertex normals and encodings use all threads of the current pool, times are taken on one.
    ///
    /// # Errors
    /// Those of drawing, which scenes of this module do not have.
    pub fn measure(effort: Effort, observe: Observer) -> Result<Self, RenderError> {
        Ok(Self {
            effort,
            vertex: vertex_cases(effort, observe),
            boxes: box_rows(),
            costs: Costs::measure(effort, observe),
            precision: precision_rows(),
            encodings: encoding_rows(effort, observe),
            shading: shading_rows(effort, observe)?,
            approximations: approximation_rows(),
        })
    }

    /// The error and cost of each weight on a class of meshes: the median, over surfaces, of the rms error on the quoted mesh,
    /// and the cost as a multiple of the plain loop. In the order of [`Weight::ALL`].
    ///
    /// The median, because the mean is dominated by the one or two surfaces with points at which all weights are inaccurate:
    /// the folds of the teapot, the tip of the cone.
    pub fn of_class(&self, tiling: Tiling) -> Vec<ClassPoint> {
        let cases = || self.vertex.iter().filter(|case| case.tiling == tiling);
        let point = |weight: Weight| {
            let rms = cases().filter_map(|case| Some(case.quoted_errors(weight)?.rms)).collect();
            Some(ClassPoint { weight, rms: median(rms)?, ratio: self.costs.cheapest(weight)? })
        };
        Weight::ALL.into_iter().filter_map(point).collect()
    }
}

/// The error of a weight on a class of meshes, and its cost.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ClassPoint {
    /// The weight.
    pub weight: Weight,
    /// Degrees.
    pub rms: f64,
    /// Times the plain loop, on one thread, through slices except for fits.
    pub ratio: f64,
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
    fn the_frontier_is_what_nothing_beats() {
        let point = |weight, ratio, rms| ClassPoint { weight, rms, ratio };
        let points = [
            point(Weight::Quadric, 300.0, 0.1),
            point(Weight::Uniform, 2.0, 1.6),
            point(Weight::Max, 1.8, 0.5),
            point(Weight::Area, 1.0, 2.0),
            point(Weight::Angle, 3.0, 0.7),
        ];
        let weights: Vec<Weight> = frontier(&points).into_iter().map(|point| point.weight).collect();
        assert_eq!(weights, [Weight::Area, Weight::Max, Weight::Quadric]);
        assert!(frontier(&[]).is_empty());
    }
}
