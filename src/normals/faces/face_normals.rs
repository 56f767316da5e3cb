//! Normals of faces.

use crate::mesh::{FacesRef, PositionsRef};
use crate::normals::faces::component::Component;
use crate::normals::faces::positions::Source;
use crate::normals::faces::shape::FaceState;
use crate::normals::recipe::Weight;
use crate::normals::sums::block::block_terms;
use crate::normals::sums::corner_terms::CornerTerms;
use crate::normals::sums::partition::BLOCK;
use crate::normals::sums::scatter::BlockTerms;
use crate::num::{self, Kernel, Lanes};
use glam::DVec3;
use rayon::prelude::*;

/// Normals of all faces of a mesh.
#[derive(Clone, Debug, Default, PartialEq)]
pub(crate) struct FaceNormals {
    /// Unit normal of each face; the zero vector where there is no direction.
    pub(crate) unit: Vec<DVec3>,
    /// One for each face.
    pub(crate) state: Vec<FaceState>,
}

/// Computes the normal of every face.
pub(crate) fn face_normals(faces: FacesRef, positions: PositionsRef) -> FaceNormals {
    let mut normals =
        FaceNormals { unit: bytemuck::zeroed_vec(faces.len()), state: vec![FaceState::Counted; faces.len()] };
    normals.fill(faces, positions);
    normals
}

impl FaceNormals {
    pub(crate) fn clear(&mut self) {
        self.unit.clear();
        self.state.clear();
    }

    /// As [`face_normals`], in memory that has served before.
    pub(crate) fn fill(&mut self, faces: FacesRef, positions: PositionsRef) {
        self.unit.resize(faces.len(), DVec3::ZERO);
        self.state.resize(faces.len(), FaceState::Counted);
        let unit: &mut [[f64; 3]] = bytemuck::cast_slice_mut(&mut self.unit);
        face_normals_into(faces, positions, unit, &mut self.state);
    }
}

/// The same into the caller's slices, one entry a face; zero vectors where there is no direction.
pub(crate) fn face_normals_into<O: Component>(
    faces: FacesRef,
    positions: PositionsRef,
    unit: &mut [[O; 3]],
    state: &mut [FaceState],
) {
    let source = &Source::new(positions);
    let task = |(task, (unit, state)): (usize, (&mut [[O; 3]], &mut [FaceState]))| {
        SomeFaces { faces, source, first: task * TASK, unit, state }.run();
    };
    if rayon::current_num_threads() <= 1 {
        unit.chunks_mut(TASK).zip(state.chunks_mut(TASK)).enumerate().for_each(task);
    } else {
        unit.par_chunks_mut(TASK).zip(state.par_chunks_mut(TASK)).enumerate().for_each(task);
    }
}

/// Faces that one task computes.
const TASK: usize = 1024;

/// The faces from `first` on, as many as there is room for.
struct SomeFaces<'a, O> {
    faces: FacesRef<'a>,
    source: &'a Source<'a>,
    first: usize,
    unit: &'a mut [[O; 3]],
    state: &'a mut [FaceState],
}

impl<O: Component> SomeFaces<'_, O> {
    fn run(mut self) {
        let mut scalar = CornerTerms::default();
        let triangles = if self.faces.is_triangles() {
            let triangles = self.faces.corners().as_chunks::<3>().0;
            &triangles[self.first..self.first + self.unit.len()]
        } else {
            &[]
        };
        let (source, weight) = (self.source, Weight::Uniform);
        let mut terms = BlockTerms::zero();
        for (first, block) in (0..).step_by(BLOCK).zip(triangles.chunks(BLOCK)) {
            let settled = block_terms(source, block, weight, &mut terms).unwrap_or_default();
            let faces = first..first + block.len();
            num::dispatch(Emit { rows: &terms.vectors, unit: &mut self.unit[faces.clone()] });
            self.state[faces].fill(FaceState::Counted);
            settled.rest(block.len()).for_each(|at| self.face(first + at, &mut scalar));
        }
        for at in triangles.len()..self.unit.len() {
            self.face(at, &mut scalar);
        }
    }

    fn face(&mut self, at: usize, scalar: &mut CornerTerms) {
        let shape = scalar.shape(self.faces, self.source, self.first + at);
        self.unit[at] = O::emit(shape.unit);
        self.state[at] = shape.state;
    }
}

/// Rounds unit vectors to the type in which they are wanted.
struct Emit<'a, O> {
    rows: &'a [[f64; 4]],
    unit: &'a mut [[O; 3]],
}

impl<O: Component> Kernel for Emit<'_, O> {
    type Output = ();

    #[inline(always)]
    fn run<A: Lanes>(self, arch: A) {
        for (unit, row) in self.unit.iter_mut().zip(self.rows) {
            *unit = O::emit_row(arch, row, 1.0);
        }
    }
}
