//! The errors of experiments. Their texts are in errors.en.ftl.

use crate::mesh::MeshError;
use crate::metric::MetricError;
use crate::raster::RenderError;
use crate::surface::SurfaceError;
use crate::text::{Catalogue, Language, Value, catalogue};

static TEXTS: Catalogue = catalogue!("errors", en);

pub(super) type Result<T> = std::result::Result<T, ArtefactError>;

/// An error of an experiment.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum ArtefactError {
    /// An experiment that does not exist, or a parameter or mesh that does not suit it: what it is, and what to do.
    #[error("{0}")]
    Request(String),
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

impl ArtefactError {
    pub(super) fn request(key: &str, values: &[(&'static str, Value)]) -> Self {
        Self::Request(TEXTS.with(key, values).get(Language::English).to_owned())
    }
}
