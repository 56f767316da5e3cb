//! The errors of experiments.

use super::parameter_name::ParameterName;
use crate::mesh::MeshError;
use crate::metric::MetricError;
use crate::raster::RenderError;
use crate::surface::SurfaceError;
use crate::text::given;
use std::ops::RangeInclusive;

/// An error of an experiment.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum ArtefactError {
    /// There is no such experiment.
    #[error("there is no experiment `{found}`; `crease artefact list` names them all{}",
        .nearest.map(|id| format!(" (did you mean `{id}`?)")).unwrap_or_default())]
    Unknown {
        /// The id that was given.
        found: String,
        /// The most similar id.
        nearest: Option<&'static str>,
    },
    /// A parameter that the experiment does not have.
    #[error("the experiment `{experiment}` has no {}; it takes {takes}", .name.name())]
    NotTaken {
        /// The experiment.
        experiment: &'static str,
        /// The parameter.
        name: ParameterName,
        /// The parameters that it has.
        takes: String,
    },
    /// A parameter out of its range.
    #[error("--{} is {}; {expected}", .name.name(), given(*.found))]
    Range {
        /// The parameter.
        name: ParameterName,
        /// The value that was given.
        found: f64,
        /// The values that are valid.
        expected: &'static str,
    },
    /// A number of segments outside the range of the experiment.
    #[error("--segments is {found}; the experiment `{experiment}` takes {} to {}", .range.start(), .range.end())]
    Segments {
        /// The experiment.
        experiment: &'static str,
        /// The value that was given.
        found: u32,
        /// The values that are valid.
        range: RangeInclusive<u32>,
    },
    /// A mesh that does not suit the experiment.
    #[error("{found}; {advice}")]
    Mesh {
        /// What is wrong with it.
        found: String,
        /// What to do.
        advice: &'static str,
    },
    /// An experiment without an animation.
    #[error("the experiment `{0}` has no animation; these do: {1}")]
    Still(&'static str, String),
    /// A picture cannot be drawn.
    #[error(transparent)]
    Render(#[from] RenderError),
    /// A surface cannot be cut as asked.
    #[error(transparent)]
    Surface(#[from] SurfaceError),
    /// Faces and positions that make no mesh.
    #[error(transparent)]
    Build(#[from] MeshError),
    /// Pictures that cannot be compared.
    #[error(transparent)]
    Metric(#[from] MetricError),
}
