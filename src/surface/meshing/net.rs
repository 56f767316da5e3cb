//! Faces over samples of a surface: the result of each pattern, from which meshes are made.

use crate::mesh::Faces;
use crate::surface::error::SurfaceError;
use crate::surface::shapes::chart::{Parametric, Sample};
use glam::DVec2;

/// Faces over samples of a surface.
#[derive(Default)]
pub(in crate::surface) struct Net {
    pub(in crate::surface) samples: Vec<Sample>,
    pub(in crate::surface) faces: Faces,
    /// The parameters of each corner, those of one face close together also where a chart wraps; empty if the surface
    /// was not sampled by parameters.
    pub(in crate::surface) corner_parameters: Vec<DVec2>,
    /// The first face of each chart.
    pub(in crate::surface) first_faces: Vec<usize>,
}

impl Net {
    /// Samples and faces whose corners have no parameters.
    pub(in crate::surface) fn without_parameters(samples: Vec<Sample>, faces: Faces) -> Self {
        Self { samples, faces, ..Self::default() }
    }

    /// Appends a face.
    pub(in crate::surface) fn push(&mut self, vertices: &[u32], parameters: impl Iterator<Item = DVec2>) {
        self.faces.push(vertices);
        self.corner_parameters.extend(parameters);
    }

    /// The chart that a face lies on.
    pub(in crate::surface) fn chart_of(&self, face: usize) -> usize {
        self.first_faces.partition_point(|&first| first <= face) - 1
    }

    /// Mean of the parameters of a face's corners.
    pub(in crate::surface) fn middle(&self, face: usize) -> DVec2 {
        let corners = &self.corner_parameters[self.faces.range(face)];
        corners.iter().sum::<DVec2>() / corners.len() as f64
    }

    /// Mean length of an edge, those that two faces share counted twice.
    pub(in crate::surface) fn mean_edge(&self) -> f64 {
        let place = |vertex: u32| self.samples[vertex as usize].position;
        let round = |face: &[u32]| -> f64 {
            let next = face.iter().cycle().skip(1);
            face.iter().zip(next).map(|(&a, &b)| place(a).distance(place(b))).sum()
        };
        self.faces.iter().map(round).sum::<f64>() / self.faces.corner_count() as f64
    }
}

/// The point of a chart.
pub(in crate::surface) fn sample(chart: &dyn Parametric, at: DVec2) -> Result<Sample, SurfaceError> {
    sample_at(at, chart.at(at.x, at.y))
}

/// The sample at these parameters, or an error if the surface has no normal there.
pub(in crate::surface) fn sample_at(at: DVec2, sample: Option<Sample>) -> Result<Sample, SurfaceError> {
    sample.ok_or(SurfaceError::NoNormal { u: at.x, v: at.y })
}
