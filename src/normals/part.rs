//! The work of one part: adding up its share of slots.

use super::block::{ALL, GroupTerms, are_inner, group_terms};
use super::corner_terms::CornerTerms;
use super::face_shape::FaceState;
use super::finish::Doubts;
use super::partition::{Numbering, bounds};
use super::positions::Source;
use super::sums::SumRequest;
use super::term::adds;
use super::weight::CornerWeight;
use crate::mesh::NONE;
use crate::num::{Kernel, LANES, Lanes};
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
    /// Whether every vertex exists.
    type Output = bool;

    #[inline(always)]
    fn run<A: Lanes>(mut self, arch: A) -> bool {
        let mut work = Work::new();
        match self.walk {
            Walk::Share(faces) if self.request.faces.is_triangles() => {
                let triangles = &self.request.faces.corners().as_chunks::<3>().0[faces.clone()];
                let slots = &self.request.target.as_chunks::<3>().0[faces.clone()];
                for (first, (triangles, slots)) in
                    faces.clone().step_by(BLOCK).zip(triangles.chunks(BLOCK).zip(slots.chunks(BLOCK)))
                {
                    if !self.block(arch, triangles, slots, &mut work, |at| first + at) {
                        return false;
                    }
                }
            }
            Walk::Listed(faces) if self.request.faces.is_triangles() => {
                let triangles = self.request.faces.corners().as_chunks::<3>().0;
                let slots = self.request.target.as_chunks::<3>().0;
                let (mut some_triangles, mut some_slots) = ([[0; 3]; BLOCK], [[0; 3]; BLOCK]);
                for faces in faces.chunks(BLOCK) {
                    for (at, &face) in faces.iter().enumerate() {
                        some_triangles[at] = triangles[face as usize];
                        some_slots[at] = slots[face as usize];
                    }
                    let count = faces.len();
                    let face = |at: usize| faces[at] as usize;
                    if !self.block(arch, &some_triangles[..count], &some_slots[..count], &mut work, face) {
                        return false;
                    }
                }
            }
            Walk::Share(faces) => self.polygons(faces.clone()),
            Walk::Listed(faces) => self.polygons(faces.iter().map(|&face| face as usize)),
        }
        true
    }
}

/// Triangles that are computed before they are added: enough to fill the pipeline, few enough to stay at hand.
const BLOCK: usize = 8 * LANES;

/// Memory for blocks of triangles.
struct Work {
    terms: [GroupTerms; BLOCK / LANES],
    scalar: CornerTerms,
}

impl Work {
    fn new() -> Self {
        Self { terms: [GroupTerms::ZERO; BLOCK / LANES], scalar: CornerTerms::default() }
    }
}

impl<S: Source, W: CornerWeight> Accumulate<'_, S, W> {
    /// Up to [`BLOCK`] triangles; false if a vertex does not exist.
    #[inline(always)]
    fn block<A: Lanes>(
        &mut self,
        arch: A,
        triangles: &[[u32; 3]],
        slots: &[[u32; 3]],
        Work { terms, scalar }: &mut Work,
        face: impl Fn(usize) -> usize,
    ) -> bool {
        let all_inner = are_inner(&self.source, triangles);
        let (groups, rest) = triangles.as_chunks::<LANES>();
        for (group, (triangles, terms)) in groups.iter().zip(&mut *terms).enumerate() {
            let inner = all_inner || are_inner(&self.source, triangles);
            let settled =
                if inner { group_terms::<A, S, W>(arch, triangles, &self.source, terms) } else { 0 };
            if settled != ALL && !self.settle(settled, LANES, terms, scalar, |row| face(group * LANES + row))
            {
                return false;
            }
        }
        if !rest.is_empty() {
            let first = groups.len() * LANES;
            if !self.settle(0, rest.len(), &mut terms[groups.len()], scalar, |row| face(first + row)) {
                return false;
            }
        }
        let (numbering, sums) = (self.numbering, &mut self.sums[..]);
        let missed = match numbering {
            Numbering::Alone => {
                scatter::<A, W>(arch, terms, slots, sums, |slot| slot as usize);
                false
            }
            Numbering::Chunked(_) => match numbering.offset(bounds(slots.as_flattened())) {
                Some(offset) => {
                    scatter::<A, W>(arch, terms, slots, sums, |slot| slot.wrapping_sub(offset) as usize)
                }
                None => scatter::<A, W>(arch, terms, slots, sums, |slot| numbering.local(slot)),
            },
        };
        if missed {
            self.write_down(slots, face);
        }
        true
    }

    /// Puts triangles right that could not be computed together with others; false if a vertex does not exist.
    #[inline(never)]
    fn settle(
        &mut self,
        settled: u8,
        count: usize,
        terms: &mut GroupTerms,
        scalar: &mut CornerTerms,
        face: impl Fn(usize) -> usize,
    ) -> bool {
        let Self { request, source, .. } = *self;
        for row in (0..count).filter(|row| settled >> row & 1 == 0) {
            let face = face(row);
            if request.faces.face(face).iter().any(|&vertex| vertex as usize >= source.count()) {
                return false;
            }
            scalar.fill::<S, W>(request.faces, source, face, |_| false);
            if scalar.state != FaceState::Counted {
                self.odd.push((face as u32, scalar.state));
            }
            if adds(scalar.state, request.slivers) {
                terms.set(row, scalar.vector, &scalar.weights);
            } else {
                terms.set(row, [0.0; 4], &[0.0; 3]);
            }
        }
        true
    }

    /// Writes the faces of a block down of which a corner is another part's.
    #[inline(never)]
    fn write_down(&mut self, slots: &[[u32; 3]], face: impl Fn(usize) -> usize) {
        for (at, slots) in slots.iter().enumerate() {
            if slots.iter().any(|&slot| self.is_abroad(slot)) {
                self.abroad.push(face(at) as u32);
            }
        }
    }

    fn is_abroad(&self, slot: u32) -> bool {
        slot != NONE && self.numbering.local(slot) >= self.sums.len()
    }

    /// Faces of any size. Their vertices exist: only slices of triangles come unchecked.
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
                    if let Some(Sum(sum)) = self.sums.get_mut(numbering.local(slot)) {
                        *sum = std::array::from_fn(|i| sum[i] + scalar.vector[i] * weight);
                    }
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
fn scatter<A: Lanes, W: CornerWeight>(
    arch: A,
    terms: &[GroupTerms; BLOCK / LANES],
    slots: &[[u32; 3]],
    sums: &mut [Sum],
    local: impl Fn(u32) -> usize,
) -> bool {
    let mut missed = false;
    let (groups, rest) = slots.as_chunks::<LANES>();
    for (terms, slots) in terms.iter().zip(groups) {
        for row in 0..LANES {
            missed |= add::<A, W>(arch, terms, row, slots[row].map(&local), sums);
        }
    }
    for (row, slots) in rest.iter().enumerate() {
        missed |= add::<A, W>(arch, &terms[groups.len()], row, slots.map(&local), sums);
    }
    missed
}

/// Adds one triangle; tells whether a slot was not there.
#[inline(always)]
fn add<A: Lanes, W: CornerWeight>(
    arch: A,
    terms: &GroupTerms,
    row: usize,
    slots: [usize; 3],
    sums: &mut [Sum],
) -> bool {
    let mut missed = false;
    for corner in 0..3 {
        match sums.get_mut(slots[corner]) {
            Some(Sum(sum)) if W::EVEN => arch.add_row(sum, &terms.vectors.0[row]),
            Some(Sum(sum)) => {
                arch.add_scaled_row(sum, &terms.vectors.0[row], terms.weights.0[row][corner]);
            }
            None => missed = true,
        }
    }
    missed
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
