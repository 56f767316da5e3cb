//! Sums over chosen corners, for rules by which every corner selects its own faces.

use crate::mesh::FacesRef;
use crate::normals::faces::positions::Source;
use crate::normals::recipe::Slivers;
use crate::normals::sums::corner_mean::{Term, mean};
use crate::normals::sums::corner_terms::CornerTerms;
use crate::normals::sums::request::{SlotState, SumRequest};
use glam::DVec3;
use rayon::prelude::*;

/// What every corner of a mesh adds to a sum, computed once.
pub(crate) struct TermTable<'a> {
    faces: FacesRef<'a>,
    corners: Vec<CornerTerm>,
    slivers: Slivers,
}

struct CornerTerm {
    term: Term,
    /// Whether it coincides with the corner before it in its face.
    coincides: bool,
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
            let mut terms = Vec::new();
            for face in first..(first + TASK).min(faces.len()) {
                let vertices = faces.face(face);
                let before = |corner: usize| vertices[(corner + vertices.len() - 1) % vertices.len()];
                scalar
                    .fill(faces, &source, request.weight, face, |corner| vertices[corner] == before(corner));
                // A triangle with two corners in one position has no area and adds nothing.
                let coincides = |corner: usize| {
                    vertices.len() > 3 && source.point(vertices[corner]).0 == source.point(before(corner)).0
                };
                let CornerTerms { vector, state, ref weights, .. } = scalar;
                terms.extend(weights.iter().enumerate().map(|(corner, &weight)| CornerTerm {
                    term: Term { vector, weight, face: face as u32, state },
                    coincides: coincides(corner),
                }));
            }
            terms
        };
        Self { faces, corners: starts.par_iter().flat_map_iter(terms_of).collect(), slivers: request.slivers }
    }

    /// The mean over a set of corners of one vertex or of welded ones, given ascending, by the rules of all sums. A corner adds
    /// nothing of its own if the corner before it has the same position and is in the set as well.
    pub(crate) fn mean(&self, corners: &[u32], terms: &mut Vec<Term>) -> (DVec3, SlotState) {
        terms.clear();
        terms.extend(corners.iter().filter_map(|&corner| {
            let CornerTerm { term, coincides } = &self.corners[corner as usize];
            let face = self.faces.range(term.face as usize);
            let before =
                if corner as usize == face.start { face.end as u32 - 1 } else { corner.wrapping_sub(1) };
            (!coincides || corners.binary_search(&before).is_err()).then_some(*term)
        }));
        mean(terms, self.slivers)
    }
}
