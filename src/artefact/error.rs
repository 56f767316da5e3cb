//! Why an experiment gives nothing.

use super::Knob;
use crate::mesh::MeshError;
use crate::metric::MetricError;
use crate::raster::RenderError;
use crate::surface::SurfaceError;
use crate::text::given;
use std::ops::RangeInclusive;

/// Why there is no outcome.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum ArtefactError {
    /// There is no such experiment.
    #[error("there is no experiment `{found}`; `crease artefact list` names them all{}",
        .nearest.map(|id| format!(" (did you mean `{id}`?)")).unwrap_or_default())]
    Unknown {
        /// What was asked for.
        found: String,
        /// The id that is most like it.
        nearest: Option<&'static str>,
    },
    /// A parameter that the experiment does not have.
    #[error("the experiment `{experiment}` has no {}; it takes {takes}", .knob.name())]
    NotTaken {
        /// The experiment.
        experiment: &'static str,
        /// What was given.
        knob: Knob,
        /// What could be.
        takes: String,
    },
    /// A parameter out of its range.
    #[error("--{} is {}; {expected}", .knob.name(), given(*.found))]
    Range {
        /// Which.
        knob: Knob,
        /// What was given.
        found: f64,
        /// What would do.
        expected: &'static str,
    },
    /// Segments too few or too many for an experiment to make sense.
    #[error("--segments is {found}; the experiment `{experiment}` takes {} to {}", .range.start(), .range.end())]
    Segments {
        /// The experiment.
        experiment: &'static str,
        /// What was given.
        found: u32,
        /// What would do.
        range: RangeInclusive<u32>,
    },
    /// A mesh that does not suit the experiment.
    #[error("{found}; {advice}")]
    Mesh {
        /// What it is like.
        found: String,
        /// What to do.
        advice: &'static str,
    },
    /// Nothing that moves.
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
