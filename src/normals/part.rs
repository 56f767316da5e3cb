//! The work of one part: adding up its share of slots.

use super::block::{BlockTerms, Corners, LANES, block_terms};
use super::corner_terms::CornerTerms;
use super::face_shape::FaceState;
use super::finish::Doubts;
use super::partition::Numbering;
use super::positions::{Scalar, Source};
use super::sums::SumRequest;
use super::term::adds;
use super::weight::CornerWeight;
use crate::mesh::NONE;
use crate::num::{Kernel, Product};
use std::marker::PhantomData;
use std::ops::Range;

/// A face that is not simply counted.
pub(crate) type OddFace = (u32, FaceState);

/// A running sum: Σ w n̂ and Σ w. Aligned, so that none lies across two cache lines.
#[derive(Clone, Copy, Default)]
#[repr(align(32))]
pub(crate) struct Sum(pub(crate) [f64; 4]);

/// Memory of one part.
#[derive(Default)]
pub(crate) struct Part {
    /// The sums of its slots.
    pub(crate) sums: Vec<Sum>,
    /// Where those begin, chunk by chunk.
    pub(crate) starts: Vec<u32>,
    /// Faces of its share that are not simply counted.
    pub(crate) odd: Vec<OddFace>,
    /// Faces of its share with a corner in another part's slot.
    pub(crate) abroad: Vec<u32>,
    pub(crate) doubts: Doubts,
}

/// Which faces to add.
#[derive(Clone, Copy)]
pub(crate) enum Walk<'a> {
    /// Some in a row.
    Share(&'a Range<usize>),
    /// Those that other parts have written down, ascending.
    Listed(&'a [u32]),
}

/// Adds faces to the sums of a part.
pub(crate) struct Accumulate<'a, S, W> {
    pub(crate) request: &'a SumRequest<'a>,
    pub(crate) source: S,
    pub(crate) walk: Walk<'a>,
    pub(crate) numbering: Numbering<'a>,
    pub(crate) sums: &'a mut [Sum],
    /// Takes the faces that are not simply counted.
    pub(crate) odd: &'a mut Vec<OddFace>,
    /// Takes the faces with a corner in another part's slot.
    pub(crate) abroad: &'a mut Vec<u32>,
    pub(crate) weight: PhantomData<W>,
}

impl<S: Source, W: CornerWeight> Kernel for Accumulate<'_, S, W> {
    type Output = ();

    #[inline(always)]
    fn run<P: Product>(mut self) {
        match self.walk {
            Walk::Share(faces) if self.request.faces.is_triangles() => {
                let triangles = &self.request.faces.corners().as_chunks::<3>().0[faces.clone()];
                let slots = &self.request.target.as_chunks::<3>().0[faces.clone()];
                let mut work = Work::new();
                for (first, (triangles, slots)) in
                    faces.clone().step_by(LANES).zip(triangles.chunks(LANES).zip(slots.chunks(LANES)))
                {
                    self.block::<P>(triangles, slots, &mut work, |lane| first + lane);
                }
            }
            Walk::Listed(faces) if self.request.faces.is_triangles() => {
                let triangles = self.request.faces.corners().as_chunks::<3>().0;
                let slots = self.request.target.as_chunks::<3>().0;
                let mut work = Work::new();
                let (mut some_triangles, mut some_slots) = ([[0; 3]; LANES], [[0; 3]; LANES]);
                for faces in faces.chunks(LANES) {
                    for (lane, &face) in faces.iter().enumerate() {
                        some_triangles[lane] = triangles[face as usize];
                        some_slots[lane] = slots[face as usize];
                    }
                    let count = faces.len();
                    let face = |lane: usize| faces[lane] as usize;
                    self.block::<P>(&some_triangles[..count], &some_slots[..count], &mut work, face);
                }
            }
            Walk::Share(faces) => self.polygons(faces.clone()),
            Walk::Listed(faces) => self.polygons(faces.iter().map(|&face| face as usize)),
        }
    }
}

/// Memory for blocks of triangles.
struct Work<T> {
    corners: Corners<T>,
    terms: BlockTerms,
    scalar: CornerTerms,
}

impl<T: Scalar> Work<T> {
    fn new() -> Self {
        Self { corners: Corners::new(), terms: BlockTerms::new(), scalar: CornerTerms::default() }
    }
}

impl<S: Source, W: CornerWeight> Accumulate<'_, S, W> {
    /// Up to [`LANES`] triangles.
    #[inline(always)]
    fn block<P: Product>(
        &mut self,
        triangles: &[[u32; 3]],
        slots: &[[u32; 3]],
        work: &mut Work<S::Scalar>,
        face: impl Fn(usize) -> usize,
    ) {
        let Work { corners, terms, scalar } = work;
        corners.gather(triangles, self.source);
        if !block_terms::<P, S, W>(corners, triangles.len(), self.source, terms) {
            for lane in 0..triangles.len() {
                if terms.settled[lane] == 0 {
                    self.settle(lane, face(lane), terms, scalar);
                }
            }
        }
        match self.numbering {
            Numbering::Alone => {
                scatter::<W>(terms, slots, self.sums, |slot| slot as usize);
            }
            Numbering::Chunked(_) => {
                let numbering = self.numbering;
                let missed = scatter::<W>(terms, slots, self.sums, |slot| numbering.local(slot));
                if missed {
                    self.write_down(slots, face);
                }
            }
        }
    }

    /// Puts a triangle right that could not be computed together with others.
    #[inline(never)]
    fn settle(&mut self, lane: usize, face: usize, terms: &mut BlockTerms, scalar: &mut CornerTerms) {
        scalar.fill::<S, W>(self.request.faces, self.source, face, |_| false);
        if scalar.state != FaceState::Counted {
            self.odd.push((face as u32, scalar.state));
        }
        if adds(scalar.state, self.request.slivers) {
            terms.set(lane, scalar.vector, &scalar.weights);
        } else {
            terms.set(lane, [0.0; 4], &[0.0; 3]);
        }
    }

    /// Writes the faces of a block down of which a corner is another part's.
    #[inline(never)]
    fn write_down(&mut self, slots: &[[u32; 3]], face: impl Fn(usize) -> usize) {
        for (lane, slots) in slots.iter().enumerate() {
            if slots.iter().any(|&slot| self.is_abroad(slot)) {
                self.abroad.push(face(lane) as u32);
            }
        }
    }

    fn is_abroad(&self, slot: u32) -> bool {
        slot != NONE && self.numbering.local(slot) >= self.sums.len()
    }

    fn polygons(&mut self, faces: impl Iterator<Item = usize>) {
        let Self { request, source, numbering, .. } = *self;
        let mut scalar = CornerTerms::default();
        for face in faces {
            let slots = &request.target[request.faces.range(face)];
            scalar.fill::<S, W>(request.faces, source, face, |corner| repeats(slots, corner));
            if scalar.state != FaceState::Counted {
                self.odd.push((face as u32, scalar.state));
            }
            if adds(scalar.state, request.slivers) {
                for (&slot, &weight) in slots.iter().zip(&scalar.weights) {
                    add(self.sums, numbering.local(slot), scalar.vector, weight);
                }
            }
            if slots.iter().any(|&slot| self.is_abroad(slot)) {
                self.abroad.push(face as u32);
            }
        }
    }
}

/// Adds the triangles of a block to the slots of their corners; tells whether a slot was not there.
#[inline(always)]
fn scatter<W: CornerWeight>(
    terms: &BlockTerms,
    slots: &[[u32; 3]],
    sums: &mut [Sum],
    local: impl Fn(u32) -> usize,
) -> bool {
    let mut missed = false;
    let BlockTerms { vectors, weights: [weight0, weight1, weight2], .. } = terms;
    for (lane, &[a, b, c]) in slots.iter().enumerate().take(LANES) {
        let vector = vectors[lane];
        let (u, v, w) = match W::EVEN {
            true => (1.0, 1.0, 1.0),
            false => (weight0[lane], weight1[lane], weight2[lane]),
        };
        missed |= !add(sums, local(a), vector, u);
        missed |= !add(sums, local(b), vector, v);
        missed |= !add(sums, local(c), vector, w);
    }
    missed
}

/// Adds to a slot, unless it is not there.
#[inline(always)]
fn add(sums: &mut [Sum], slot: usize, vector: [f64; 4], weight: f64) -> bool {
    let Some(Sum(sum)) = sums.get_mut(slot) else { return false };
    // Written out, so that it becomes one vector addition.
    *sum = [
        sum[0] + vector[0] * weight,
        sum[1] + vector[1] * weight,
        sum[2] + vector[2] * weight,
        sum[3] + vector[3] * weight,
    ];
    true
}

/// Whether a corner has the same slot as the one before it in its face.
pub(crate) fn repeats(slots: &[u32], corner: usize) -> bool {
    slots[corner] == slots[(corner + slots.len() - 1) % slots.len()]
}

/// Looks states up for faces that come in ascending order.
pub(crate) struct OddFaces<'a>(&'a [OddFace]);

impl<'a> OddFaces<'a> {
    pub(crate) fn new(odd: &'a [OddFace], first: usize) -> Self {
        Self(&odd[odd.partition_point(|&(face, _)| (face as usize) < first)..])
    }

    pub(crate) fn state(&mut self, face: usize) -> FaceState {
        match self.0.split_first() {
            Some((&(odd, state), rest)) if odd as usize == face => {
                self.0 = rest;
                state
            }
            _ => FaceState::Counted,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::super::positions::Positions;
    use super::super::sums::{SlotState, weighted_sums};
    use super::super::test_meshes::{bumpy, with_threads};
    use super::super::{Slivers, Weight};
    use super::*;
    use crate::mesh::Storage;

    #[test]
    fn any_number_of_threads_gives_the_same_bits() {
        let (faces, points) = bumpy(200, 11);
        let mut shuffled = faces.clone();
        crate::num::test_numbers::Numbers::new(8).shuffle(&mut shuffled);
        for faces in [&faces, &shuffled] {
            for weight in Weight::ALL {
                for storage in [Storage::F32, Storage::F64] {
                    let request = SumRequest {
                        faces: crate::mesh::FacesRef::triangles(faces),
                        positions: Positions::F64(&points, storage),
                        target: faces.as_flattened(),
                        slots: points.len(),
                        weight,
                        slivers: Slivers::Exclude,
                    };
                    let alone = with_threads(1, || weighted_sums(&request));
                    assert!(alone.state.iter().all(|&state| state == SlotState::Good));
                    for threads in [2, 3, 8] {
                        assert_eq!(with_threads(threads, || weighted_sums(&request)), alone);
                    }
                }
            }
        }
    }
}
