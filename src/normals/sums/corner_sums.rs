//! Sums over chosen corners, for rules by which every corner picks its own faces.

use crate::mesh::FacesRef;
use crate::normals::faces::positions::{Positions, Source, Visitor};
use crate::normals::faces::shape::FaceState;
use crate::normals::recipe::{Slivers, Weight};
use crate::normals::sums::corner_mean::{Term, mean};
use crate::normals::sums::corner_terms::CornerTerms;
use crate::normals::sums::weight::{CornerWeight, WeightVisitor, visit_weight};
use crate::normals::sums::weighted::SlotState;
use glam::DVec3;
use rayon::prelude::*;
use std::marker::PhantomData;

/// What every corner of a mesh adds to a sum, computed once.
pub(crate) struct TermTable<'a> {
    faces: FacesRef<'a>,
    vectors: Vec<[f64; 4]>,
    states: Vec<FaceState>,
    weights: Vec<f64>,
    /// The face of each corner.
    owners: Vec<u32>,
    /// Which corners lie at the place of the corner before them in their face.
    again: Vec<bool>,
    slivers: Slivers,
}

impl<'a> TermTable<'a> {
    /// Computes the terms of all corners; the same numbers that [`weighted_sums`](crate::normals::sums::weighted::weighted_sums) adds.
    pub(crate) fn new(faces: FacesRef<'a>, positions: Positions, weight: Weight, slivers: Slivers) -> Self {
        let mut table = Self {
            faces,
            vectors: vec![[0.0; 4]; faces.len()],
            states: vec![FaceState::Counted; faces.len()],
            weights: vec![0.0; faces.corners().len()],
            owners: Vec::with_capacity(faces.corners().len()),
            again: vec![false; faces.corners().len()],
            slivers,
        };
        for face in 0..faces.len() {
            table.owners.extend(std::iter::repeat_n(face as u32, faces.range(face).len()));
        }
        positions.visit(Fill { faces, weight, table: &mut table });
        table
    }

    /// The mean over a set of corners of one vertex or of welded ones, given ascending, by the rules of all sums. A corner adds
    /// nothing of its own if the corner before it lies at the same place and is of the set as well.
    pub(crate) fn mean(&self, corners: &[u32], terms: &mut Vec<Term>) -> (DVec3, SlotState) {
        terms.clear();
        let is_first = |corner: &&u32| {
            !self.again[**corner as usize] || corners.binary_search(&self.before(**corner)).is_err()
        };
        terms.extend(corners.iter().filter(is_first).map(|&corner| {
            let face = self.owners[corner as usize];
            let (vector, state) = (self.vectors[face as usize], self.states[face as usize]);
            Term { vector, weight: self.weights[corner as usize], face, state }
        }));
        mean(terms, self.slivers)
    }

    /// The corner before a corner in its face.
    fn before(&self, corner: u32) -> u32 {
        let face = self.faces.range(self.owners[corner as usize] as usize);
        if corner as usize == face.start { face.end as u32 - 1 } else { corner - 1 }
    }
}

/// Faces that one task computes.
const TASK: usize = 1024;

struct Fill<'t, 'a> {
    faces: FacesRef<'a>,
    weight: Weight,
    table: &'t mut TermTable<'a>,
}

impl Visitor for Fill<'_, '_> {
    type Output = ();

    fn visit<S: Source>(self, source: S) {
        visit_weight(self.weight, FillFrom { fill: self, source });
    }
}

struct FillFrom<'t, 'a, S> {
    fill: Fill<'t, 'a>,
    source: S,
}

impl<S: Source> WeightVisitor for FillFrom<'_, '_, S> {
    type Output = ();

    fn visit<W: CornerWeight>(self) {
        let Self { fill: Fill { faces, table, .. }, source } = self;
        let (mut weights, mut again) = (&mut table.weights[..], &mut table.again[..]);
        let tasks: Vec<_> = table
            .vectors
            .chunks_mut(TASK)
            .zip(table.states.chunks_mut(TASK))
            .enumerate()
            .map(|(task, (vectors, states))| {
                let first = task * TASK;
                let corners = faces.start(first + vectors.len()) - faces.start(first);
                let (own, others) = std::mem::take(&mut weights).split_at_mut(corners);
                weights = others;
                let (own_again, others) = std::mem::take(&mut again).split_at_mut(corners);
                again = others;
                FillSome::<S, W> {
                    faces,
                    source,
                    first,
                    vectors,
                    states,
                    weights: own,
                    again: own_again,
                    weight: PhantomData,
                }
            })
            .collect();
        tasks.into_par_iter().for_each(FillSome::run);
    }
}

/// The terms of some faces from `first` on.
struct FillSome<'a, S, W> {
    faces: FacesRef<'a>,
    source: S,
    first: usize,
    vectors: &'a mut [[f64; 4]],
    states: &'a mut [FaceState],
    weights: &'a mut [f64],
    again: &'a mut [bool],
    weight: PhantomData<W>,
}

impl<S: Source, W: CornerWeight> FillSome<'_, S, W> {
    fn run(self) {
        let mut scalar = CornerTerms::default();
        let start = self.faces.start(self.first);
        for (at, (vector, state)) in self.vectors.iter_mut().zip(self.states).enumerate() {
            let (face, range) = (self.first + at, self.faces.range(self.first + at));
            let vertices = self.faces.face(face);
            let before = |corner: usize| vertices[(corner + vertices.len() - 1) % vertices.len()];
            let repeats = |corner: usize| vertices[corner] == before(corner);
            scalar.fill::<S, W>(self.faces, self.source, face, repeats);
            (*vector, *state) = (scalar.vector, scalar.state);
            let own = range.start - start..range.end - start;
            self.weights[own.clone()].copy_from_slice(&scalar.weights);
            // A triangle with two corners in one place has no area and adds nothing.
            if vertices.len() > 3 {
                for (corner, again) in self.again[own].iter_mut().enumerate() {
                    *again = self.source.point(vertices[corner]).0 == self.source.point(before(corner)).0;
                }
            }
        }
    }
}
