//! Sums over chosen corners, for rules by which every corner selects its own faces.

use crate::mesh::FacesRef;
use crate::normals::faces::positions::Source;
use crate::normals::faces::shape::FaceState;
use crate::normals::recipe::Slivers;
use crate::normals::sums::corner_mean::{Term, mean};
use crate::normals::sums::corner_terms::CornerTerms;
use crate::normals::sums::request::{SlotState, SumRequest};
use glam::DVec3;
use rayon::prelude::*;

/// What every corner of a mesh adds to a sum, computed once.
pub(crate) struct TermTable<'a> {
    faces: FacesRef<'a>,
    /// The vector of each face with its length, and its unit normal.
    vectors: Vec<([f64; 4], DVec3)>,
    states: Vec<FaceState>,
    weights: Vec<f64>,
    /// The face of each corner.
    owners: Vec<u32>,
    /// Which corners coincide with the corner before them in their face.
    coincident: Vec<bool>,
    slivers: Slivers,
}

/// Faces that one task computes.
const TASK: usize = 1024;

impl<'a> TermTable<'a> {
    /// Computes the terms of all corners; the same numbers that
    /// [`weighted_sums`](crate::normals::sums::weighted_sums::weighted_sums) adds.
    pub(crate) fn new(request: &SumRequest<'a>) -> Self {
        let (faces, source) = (request.faces, Source::new(request.positions));
        let starts: Vec<usize> = (0..faces.len()).step_by(TASK).collect();
        let terms_of = |&first: &usize| {
            let mut scalar = CornerTerms::default();
            let (mut vectors, mut states) = (Vec::new(), Vec::new());
            let (mut weights, mut owners, mut coincident) = (Vec::new(), Vec::new(), Vec::new());
            for face in first..(first + TASK).min(faces.len()) {
                let vertices = faces.face(face);
                let before = |corner: usize| vertices[(corner + vertices.len() - 1) % vertices.len()];
                scalar
                    .fill(faces, &source, request.weight, face, |corner| vertices[corner] == before(corner));
                vectors.push((scalar.vector, scalar.unit));
                states.push(scalar.state);
                weights.extend_from_slice(&scalar.weights);
                owners.extend(vertices.iter().map(|_| face as u32));
                // A triangle with two corners in one position has no area and adds nothing.
                let coincides = |corner: usize| {
                    vertices.len() > 3 && source.point(vertices[corner]).0 == source.point(before(corner)).0
                };
                coincident.extend((0..vertices.len()).map(coincides));
            }
            (vectors, states, (weights, owners, coincident))
        };
        let tasks: Vec<_> = starts.par_iter().map(terms_of).collect();
        let mut table = Self {
            faces,
            vectors: Vec::with_capacity(faces.len()),
            states: Vec::with_capacity(faces.len()),
            weights: Vec::with_capacity(faces.corners().len()),
            owners: Vec::with_capacity(faces.corners().len()),
            coincident: Vec::with_capacity(faces.corners().len()),
            slivers: request.slivers,
        };
        for (vectors, states, (weights, owners, coincident)) in tasks {
            table.vectors.extend(vectors);
            table.states.extend(states);
            table.weights.extend(weights);
            table.owners.extend(owners);
            table.coincident.extend(coincident);
        }
        table
    }

    /// The mean over a set of corners of one vertex or of welded ones, given ascending, by the rules of all sums. A corner adds
    /// nothing of its own if the corner before it has the same position and is in the set as well.
    pub(crate) fn mean(&self, corners: &[u32], terms: &mut Vec<Term>) -> (DVec3, SlotState) {
        terms.clear();
        let is_first = |corner: &&u32| {
            !self.coincident[**corner as usize] || corners.binary_search(&self.before(**corner)).is_err()
        };
        terms.extend(corners.iter().filter(is_first).map(|&corner| {
            let face = self.owners[corner as usize];
            let ((vector, unit), state) = (self.vectors[face as usize], self.states[face as usize]);
            Term { vector, unit, weight: self.weights[corner as usize], face, state }
        }));
        mean(terms, self.slivers)
    }

    /// The corner before a corner in its face.
    fn before(&self, corner: u32) -> u32 {
        let face = self.faces.range(self.owners[corner as usize] as usize);
        if corner as usize == face.start { face.end as u32 - 1 } else { corner - 1 }
    }
}
