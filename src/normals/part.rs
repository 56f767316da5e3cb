//! The work of one part: adding up its share of slots.

use super::block::{BlockTerms, Corners, LANES, block_terms};
use super::corner_terms::CornerTerms;
use super::face_shape::FaceState;
use super::partition::{Numbering, Partition};
use super::positions::Source;
use super::sums::SumRequest;
use super::term::adds;
use super::weight::CornerWeight;
use crate::num::{Kernel, Product};
use std::marker::PhantomData;
use std::ops::Range;

/// A face that is not simply counted.
pub(crate) type OddFace = (u32, FaceState);

/// A running sum: Σ w n̂ and Σ w. Aligned, so that none lies across two cache lines.
#[derive(Clone, Copy, Default)]
#[repr(align(32))]
pub(crate) struct Sum(pub(crate) [f64; 4]);

/// What a part does, for kernels to be compiled with.
pub(crate) struct Task<'a, S, W> {
    pub(crate) request: &'a SumRequest<'a>,
    pub(crate) source: S,
    pub(crate) partition: &'a Partition,
    /// Which part it is.
    pub(crate) number: usize,
    pub(crate) weight: PhantomData<W>,
}

impl<S: Copy, W> Clone for Task<'_, S, W> {
    fn clone(&self) -> Self {
        *self
    }
}

impl<S: Copy, W> Copy for Task<'_, S, W> {}

/// Adds up every face that touches the part.
pub(crate) struct Accumulate<'a, S, W> {
    pub(crate) task: Task<'a, S, W>,
    pub(crate) numbering: Numbering<'a>,
    pub(crate) sums: &'a mut [Sum],
    /// Takes the faces that are not simply counted, ascending.
    pub(crate) odd: &'a mut Vec<OddFace>,
}

impl<S: Source, W: CornerWeight> Kernel for Accumulate<'_, S, W> {
    type Output = ();

    #[inline(always)]
    fn run<P: Product>(self) {
        let Self { task, numbering, sums, odd } = self;
        let Task { request, source, partition, number, .. } = task;
        let mut scalar = CornerTerms::default();
        let (mut corners, mut terms) = (Corners::new(), BlockTerms::new());
        for block in partition.walk(number) {
            let faces = partition.faces(block);
            let target = &request.target[request.faces.start(faces.start)..request.faces.start(faces.end)];
            if request.faces.is_triangles() {
                let triangles = &request.faces.corners().as_chunks::<3>().0[faces.clone()];
                let groups = triangles.chunks(LANES).zip(target.as_chunks::<3>().0.chunks(LANES));
                for (first, (triangles, slots)) in faces.step_by(LANES).zip(groups) {
                    corners.gather(triangles, source);
                    if !block_terms::<P, S, W>(&corners, triangles.len(), source, &mut terms) {
                        let faces = first..first + triangles.len();
                        settle::<S, W>(request, source, faces, &mut terms, &mut scalar, odd);
                    }
                    match numbering {
                        Numbering::Alone => scatter::<W>(&terms, slots, sums, |slot| slot as usize),
                        Numbering::Chunked(_) => {
                            scatter::<W>(&terms, slots, sums, |slot| numbering.local(slot))
                        }
                    }
                }
            } else {
                for face in faces {
                    let slots = &request.target[request.faces.range(face)];
                    scalar.fill::<S, W>(request.faces, source, face, |corner| repeats(slots, corner));
                    if scalar.state != FaceState::Counted {
                        odd.push((face as u32, scalar.state));
                    }
                    if adds(scalar.state, request.slivers) {
                        for (&slot, &weight) in slots.iter().zip(&scalar.weights) {
                            add(sums, numbering.local(slot), scalar.vector, weight);
                        }
                    }
                }
            }
        }
    }
}

/// Puts right the triangles of a block that could not be computed together.
#[inline(never)]
fn settle<S: Source, W: CornerWeight>(
    request: &SumRequest,
    source: S,
    faces: Range<usize>,
    terms: &mut BlockTerms,
    scalar: &mut CornerTerms,
    odd: &mut Vec<OddFace>,
) {
    for (lane, face) in faces.enumerate() {
        if terms.settled[lane] != 0 {
            continue;
        }
        scalar.fill::<S, W>(request.faces, source, face, |_| false);
        if scalar.state != FaceState::Counted {
            odd.push((face as u32, scalar.state));
        }
        if adds(scalar.state, request.slivers) {
            terms.set(lane, scalar.vector, &scalar.weights);
        } else {
            terms.set(lane, [0.0; 4], &[0.0; 3]);
        }
    }
}

/// Adds the triangles of a block to the slots of their corners.
#[inline(always)]
fn scatter<W: CornerWeight>(
    terms: &BlockTerms,
    slots: &[[u32; 3]],
    sums: &mut [Sum],
    local: impl Fn(u32) -> usize,
) {
    let BlockTerms { vectors, weights: [weight0, weight1, weight2], .. } = terms;
    for (lane, &[a, b, c]) in slots.iter().enumerate().take(LANES) {
        let vector = vectors[lane];
        let (u, v, w) = match W::EVEN {
            true => (1.0, 1.0, 1.0),
            false => (weight0[lane], weight1[lane], weight2[lane]),
        };
        add(sums, local(a), vector, u);
        add(sums, local(b), vector, v);
        add(sums, local(c), vector, w);
    }
}

/// Adds to a slot, unless it is another part's.
#[inline(always)]
fn add(sums: &mut [Sum], slot: usize, vector: [f64; 4], weight: f64) {
    if let Some(Sum(sum)) = sums.get_mut(slot) {
        // Written out, so that it becomes one vector addition.
        *sum = [
            sum[0] + vector[0] * weight,
            sum[1] + vector[1] * weight,
            sum[2] + vector[2] * weight,
            sum[3] + vector[3] * weight,
        ];
    }
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
