//! Sums over chosen corners, for rules by which every corner picks its own faces.

use super::corner_terms::CornerTerms;
use super::face_shape::FaceState;
use super::positions::{Positions, Source, Visitor};
use super::sums::SlotState;
use super::term::{Term, mean};
use super::weight::{CornerWeight, WeightVisitor, visit_weight};
use super::{Slivers, Weight};
use crate::mesh::FacesRef;
use glam::DVec3;
use rayon::prelude::*;
use std::marker::PhantomData;

/// What every corner of a mesh adds to a sum, computed once.
pub(crate) struct TermTable {
    vectors: Vec<[f64; 4]>,
    states: Vec<FaceState>,
    weights: Vec<f64>,
    /// The face of each corner.
    owners: Vec<u32>,
    slivers: Slivers,
}

impl TermTable {
    /// Computes the terms of all corners; the same numbers that [`weighted_sums`](super::sums::weighted_sums) adds.
    pub(crate) fn new(faces: FacesRef, positions: Positions, weight: Weight, slivers: Slivers) -> Self {
        let mut table = Self {
            vectors: vec![[0.0; 4]; faces.len()],
            states: vec![FaceState::Counted; faces.len()],
            weights: vec![0.0; faces.corners().len()],
            owners: Vec::with_capacity(faces.corners().len()),
            slivers,
        };
        for face in 0..faces.len() {
            table.owners.extend(std::iter::repeat_n(face as u32, faces.range(face).len()));
        }
        positions.visit(Fill { faces, weight, table: &mut table });
        table
    }

    /// The mean over a set of corners of one vertex, given ascending, by the rules of all sums.
    pub(crate) fn mean(&self, corners: &[u32], terms: &mut Vec<Term>) -> (DVec3, SlotState) {
        terms.clear();
        terms.extend(corners.iter().map(|&corner| {
            let face = self.owners[corner as usize];
            let (vector, state) = (self.vectors[face as usize], self.states[face as usize]);
            Term { vector, weight: self.weights[corner as usize], face, state }
        }));
        mean(terms, self.slivers)
    }
}

/// Faces that one task computes.
const TASK: usize = 1024;

struct Fill<'a> {
    faces: FacesRef<'a>,
    weight: Weight,
    table: &'a mut TermTable,
}

impl Visitor for Fill<'_> {
    type Output = ();

    fn visit<S: Source>(self, source: S) {
        visit_weight(self.weight, FillFrom { fill: self, source });
    }
}

struct FillFrom<'a, S> {
    fill: Fill<'a>,
    source: S,
}

impl<S: Source> WeightVisitor for FillFrom<'_, S> {
    type Output = ();

    fn visit<W: CornerWeight>(self) {
        let Self { fill: Fill { faces, table, .. }, source } = self;
        let mut weights = &mut table.weights[..];
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
                FillSome::<S, W> { faces, source, first, vectors, states, weights: own, weight: PhantomData }
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
    weight: PhantomData<W>,
}

impl<S: Source, W: CornerWeight> FillSome<'_, S, W> {
    fn run(self) {
        let mut scalar = CornerTerms::default();
        let start = self.faces.start(self.first);
        for (at, (vector, state)) in self.vectors.iter_mut().zip(self.states).enumerate() {
            let (face, range) = (self.first + at, self.faces.range(self.first + at));
            let vertices = self.faces.face(face);
            let repeats =
                |corner: usize| vertices[corner] == vertices[(corner + vertices.len() - 1) % vertices.len()];
            scalar.fill::<S, W>(self.faces, self.source, face, repeats);
            (*vector, *state) = (scalar.vector, scalar.state);
            self.weights[range.start - start..range.end - start].copy_from_slice(&scalar.weights);
        }
    }
}
