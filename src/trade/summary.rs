//! The whole measurement.

use super::approximations::{ApproximationRow, approximation_rows};
use super::cases::Tiling;
use super::cost::Costs;
use super::effort::{Effort, Observer};
use super::encodings::{EncodingRow, encoding_rows};
use super::frontier::MeshClass;
use super::precision::{PrecisionRow, precision_rows};
use super::shading::{ShadingRow, shading_rows};
use super::solids::{BoxRow, box_rows};
use super::vertex::{VertexCase, vertex_cases};
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
    /// Error against cost on each class of meshes.
    pub classes: Vec<MeshClass>,
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
        let vertex = vertex_cases(effort, observe);
        let costs = Costs::measure(effort, observe);
        let classes = Tiling::ALL.into_iter().filter_map(|tiling| MeshClass::of(&vertex, &costs, tiling));
        Ok(Self {
            effort,
            classes: classes.collect(),
            vertex,
            boxes: box_rows(),
            costs,
            precision: precision_rows(),
            encodings: encoding_rows(effort, observe),
            shading: shading_rows(effort, observe)?,
            approximations: approximation_rows(),
        })
    }
}
