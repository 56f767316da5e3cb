//! Faces over samples of a surface: the result of each pattern, from which meshes are made; and their dual.

use crate::mesh::{Faces, Topology};
use crate::num::parallel;
use crate::surface::error::{Result, SurfaceError};
use crate::surface::shapes::chart::{Parametric, Sample};
use glam::DVec2;

#[derive(Default)]
pub(crate) struct Net {
    pub(crate) samples: Vec<Sample>,
    pub(crate) faces: Faces,
    /// The parameters of each corner, contiguous within a face also where a chart wraps; empty if the surface was not
    /// sampled by parameters.
    pub(crate) corner_parameters: Vec<DVec2>,
    pub(crate) first_faces: Vec<usize>,
}

impl Net {
    /// Samples and faces whose corners have no parameters.
    pub(crate) fn without_parameters(samples: Vec<Sample>, faces: Faces) -> Self {
        Self { samples, faces, ..Self::default() }
    }

    pub(crate) fn push(&mut self, vertices: &[u32], parameters: impl Iterator<Item = DVec2>) {
        self.faces.push(vertices);
        self.corner_parameters.extend(parameters);
    }

    pub(crate) fn chart_of(&self, face: usize) -> usize {
        self.first_faces.partition_point(|&first| first <= face) - 1
    }

    pub(crate) fn middle(&self, face: usize) -> DVec2 {
        let corners = &self.corner_parameters[self.faces.range(face)];
        corners.iter().sum::<DVec2>() / corners.len() as f64
    }

    /// Mean length of an edge, those that two faces share counted twice.
    pub(crate) fn mean_edge(&self) -> f64 {
        let place = |vertex: u32| self.samples[vertex as usize].position;
        let round = |face: &[u32]| -> f64 {
            let next = face.iter().cycle().skip(1);
            face.iter().zip(next).map(|(&a, &b)| place(a).distance(place(b))).sum()
        };
        self.faces.iter().map(round).sum::<f64>() / self.faces.corner_count() as f64
    }
}

pub(crate) fn sample(chart: &dyn Parametric, at: DVec2) -> Result<Sample> {
    sample_at(at, chart.at(at.x, at.y))
}

/// The sample at these parameters, or an error if the surface has no normal there.
pub(crate) fn sample_at(at: DVec2, sample: Option<Sample>) -> Result<Sample> {
    sample.ok_or_else(|| {
        SurfaceError::Invalid(format!("the surface has no normal at u = {}, v = {}", at.x, at.y))
    })
}

/// The dual of a net of triangles: a polygon around each vertex that is not on an open side, with corners above their middles.
pub(crate) fn dual(triangles: &Net, sample: impl Fn(usize, DVec2) -> Result<Sample> + Sync) -> Result<Net> {
    let topology = Topology::by_index(&triangles.faces, triangles.samples.len());
    let mut faces = Faces::with_capacity(triangles.faces.corner_count());
    let mut ring = Vec::new();
    // Triangles that are corners of a polygon, numbered in the order of their first use.
    let (mut number, mut used) = (vec![u32::MAX; triangles.faces.len()], Vec::new());
    for vertex in 0..triangles.samples.len() as u32 {
        if !fan(&topology, vertex, &mut ring) {
            continue;
        }
        for face in &mut ring {
            let number = &mut number[*face as usize];
            if *number == u32::MAX {
                *number = used.len() as u32;
                used.push(*face as usize);
            }
            *face = *number;
        }
        faces.push(&ring);
    }
    let samples = parallel::map_each(&used, |&face| sample(face, triangles.middle(face)));
    let samples = samples.into_iter().collect::<Result<Vec<Sample>>>()?;
    let parameters = faces.corners().iter().map(|&corner| triangles.middle(used[corner as usize])).collect();
    Ok(Net { samples, faces, corner_parameters: parameters, first_faces: Vec::new() })
}

/// Collects the faces around a vertex, counter-clockwise; returns whether they close.
fn fan(topology: &Topology, vertex: u32, ring: &mut Vec<u32>) -> bool {
    ring.clear();
    let Some(&first) = topology.corners_at(vertex).first() else { return false };
    let mut corner = first;
    loop {
        ring.push(topology.face_of(corner));
        match topology.across(topology.previous(corner)) {
            None => return false,
            Some(next) if next == first => return true,
            Some(next) => corner = next,
        }
    }
}
