//! The work of one part: adding up faces.

use crate::normals::faces::positions::Source;
use crate::normals::faces::shape::FaceState;
use crate::normals::sums::block::{Settled, block_terms};
use crate::normals::sums::corner_mean::adds;
use crate::normals::sums::corner_terms::CornerTerms;
use crate::normals::sums::finish::UncertainSlots;
use crate::normals::sums::partition::{BLOCK, Touched};
use crate::normals::sums::request::{Sum, SumRequest};
use crate::normals::sums::scatter::{BlockTerms, Scatter, SumNumber};
use crate::num::{self, Real};
use std::ops::Range;

/// A face that is not simply counted.
pub(crate) type UnusualFace = (u32, FaceState);

/// Memory of one part, whose sums are of double or of single precision.
#[derive(Default)]
pub(crate) struct Part<T> {
    pub(crate) sums: SumArray<T>,
    /// The slots that its share touches.
    pub(crate) touched: Touched,
    /// Faces of its share that are not simply counted.
    pub(crate) unusual: Vec<UnusualFace>,
    pub(crate) uncertain: UncertainSlots,
}

impl<T: Real + bytemuck::Pod> Part<T> {
    /// Discards what a share has added to the slots below `own`, and returns the faces that added it, ascending: they are to
    /// be added to the sums of those slots' owners.
    pub(crate) fn hand_over(&mut self, request: &SumRequest, share: Range<usize>, own: usize) -> Vec<u32> {
        let SumRequest { faces, target, slots, .. } = *request;
        let outside_range = self.touched.outside_range(share, own, faces, target);
        let sums = &mut self.sums.get(slots)[..own];
        for &face in &outside_range {
            for &slot in &target[faces.range(face as usize)] {
                if let Some(sum) = sums.get_mut(slot as usize) {
                    *sum = bytemuck::Zeroable::zeroed();
                }
            }
        }
        outside_range
    }
}

/// A sum for every slot, all zero between calls. Pages that no face touches are never given memory.
#[derive(Default)]
pub(crate) struct SumArray<T>(Vec<T>);

impl<T: Real + bytemuck::Pod> SumArray<T> {
    /// Numbers in a cache line, within which sums are aligned: none lies across two.
    const LINE: usize = 64 / size_of::<T>();

    /// Makes room for so many.
    pub(crate) fn reserve(&mut self, slots: usize) {
        let numbers = 4 * slots + Self::LINE;
        if self.0.len() < numbers {
            self.0 = bytemuck::zeroed_vec(numbers);
        }
    }

    pub(crate) fn get(&mut self, slots: usize) -> &mut [[T; 4]] {
        let start = self.0.as_ptr().align_offset(64);
        &mut self.0[start..].as_chunks_mut().0[..slots]
    }
}

/// Which faces to add, and to which slots.
pub(crate) enum Walk<'a> {
    /// Some in a row, to any slot; takes down which.
    Share(Range<usize>, Option<&'a mut Touched>),
    /// Those that have been written down, ascending, to slots from this one on.
    Listed(&'a [u32], usize),
}

/// Computes what blocks of triangles add to sums.
pub(crate) trait Fill<T> {
    /// Computes up to [`BLOCK`] triangles, the faces of these numbers; false if that cannot be done.
    fn fill(
        &mut self,
        triangles: &[[u32; 3]],
        face: &dyn Fn(usize) -> usize,
        terms: &mut BlockTerms<T>,
    ) -> bool;

    /// The weight that every term in single precision has at least.
    fn least_weight(&self) -> T;
}

/// Adds triangles to the sums of their corners, block by block: all of a block is computed before any is added, so that one
/// does not wait for the other. False if a block cannot be computed. Slots beyond the sums are skipped.
pub(crate) fn add_triangles<T: SumNumber>(
    request: &SumRequest,
    walk: Walk,
    sums: &mut [[T; 4]],
    fill: &mut dyn Fill<T>,
) -> bool {
    let (triangles, slots) = (request.faces.corners().as_chunks::<3>().0, request.target.as_chunks::<3>().0);
    let is_equal = request.weight.is_equal_at_corners();
    let least_weight = fill.least_weight();
    let terms = &mut BlockTerms::zero();
    match walk {
        Walk::Share(share, mut touched) => {
            for first in share.clone().step_by(BLOCK) {
                let faces = first..(first + BLOCK).min(share.end);
                let slots = &slots[faces.clone()];
                if let Some(touched) = &mut touched {
                    touched.note(slots.as_flattened());
                }
                if !fill.fill(&triangles[faces], &|at| first + at, terms) {
                    return false;
                }
                num::dispatch(Scatter { terms, is_equal, slots, sums, first_slot: 0, least_weight });
            }
        }
        Walk::Listed(faces, first_slot) => {
            let sums = &mut sums[first_slot..];
            for faces in faces.chunks(BLOCK) {
                let (mut some_triangles, mut some_slots) = ([[0; 3]; BLOCK], [[0; 3]; BLOCK]);
                for (at, &face) in faces.iter().enumerate() {
                    some_triangles[at] = triangles[face as usize];
                    some_slots[at] = slots[face as usize];
                }
                let count = faces.len();
                let slots = &some_slots[..count];
                if !fill.fill(&some_triangles[..count], &|at| faces[at] as usize, terms) {
                    return false;
                }
                let first_slot = first_slot as u32;
                num::dispatch(Scatter { terms, is_equal, slots, sums, first_slot, least_weight });
            }
        }
    }
    true
}

/// Adds faces to sums in double precision, and writes down those that are not simply counted. Slots beyond the end of the sums
/// are left alone. False if a vertex does not exist.
pub(crate) fn add_faces(
    request: &SumRequest,
    source: &Source,
    walk: Walk,
    sums: &mut [Sum],
    unusual: &mut Vec<UnusualFace>,
) -> bool {
    let mut terms = Terms { request, source, unusual, scalar: CornerTerms::default() };
    if request.faces.is_triangles() {
        return add_triangles(request, walk, sums, &mut terms);
    }
    match walk {
        Walk::Share(share, mut touched) => {
            for first in share.clone().step_by(BLOCK) {
                let faces = first..(first + BLOCK).min(share.end);
                if let Some(touched) = &mut touched {
                    let corners = request.faces.start(faces.start)..request.faces.start(faces.end);
                    touched.note(&request.target[corners]);
                }
                terms.polygons(&mut faces.into_iter(), sums, 0);
            }
        }
        Walk::Listed(faces, first_slot) => {
            terms.polygons(&mut faces.iter().map(|&face| face as usize), sums, first_slot);
        }
    }
    true
}

/// What faces add to sums in double precision.
struct Terms<'a> {
    request: &'a SumRequest<'a>,
    source: &'a Source<'a>,
    unusual: &'a mut Vec<UnusualFace>,
    scalar: CornerTerms,
}

impl Fill<f64> for Terms<'_> {
    /// False if a vertex does not exist.
    fn fill(
        &mut self,
        triangles: &[[u32; 3]],
        face: &dyn Fn(usize) -> usize,
        terms: &mut BlockTerms<f64>,
    ) -> bool {
        let Some(settled) = block_terms(self.source, triangles, self.request.weight, terms) else {
            return false;
        };
        self.settle(settled, triangles.len(), face, terms);
        true
    }

    fn least_weight(&self) -> f64 {
        0.0
    }
}

impl Terms<'_> {
    /// Computes those of some triangles that are not settled by the scalar path.
    fn settle(
        &mut self,
        settled: Settled,
        triangles: usize,
        face: &dyn Fn(usize) -> usize,
        terms: &mut BlockTerms<f64>,
    ) {
        for at in settled.rest(triangles) {
            if self.fill_one(face(at), |_| false) {
                terms.vectors[at] = self.scalar.vector;
                terms.weights[at][..3].copy_from_slice(&self.scalar.weights);
            } else {
                (terms.vectors[at], terms.weights[at]) = ([0.0; 4], [0.0; 4]);
            }
        }
    }

    /// Computes one face by the scalar path, and returns whether it adds to sums.
    fn fill_one(&mut self, face: usize, repeats: impl Fn(usize) -> bool) -> bool {
        self.scalar.fill(self.request.faces, self.source, self.request.weight, face, repeats);
        let state = self.scalar.state;
        if state != FaceState::Counted {
            self.unusual.push((face as u32, state));
        }
        adds(state, self.request.slivers)
    }

    /// Adds faces of any size. Their vertices exist: only slices of triangles come unchecked.
    fn polygons(&mut self, faces: &mut dyn Iterator<Item = usize>, sums: &mut [Sum], first_slot: usize) {
        for face in faces {
            let slots = &self.request.target[self.request.faces.range(face)];
            if !self.fill_one(face, |corner| repeats(slots, corner)) {
                continue;
            }
            let CornerTerms { vector, weights, .. } = &self.scalar;
            for (&slot, &weight) in
                slots.iter().zip(weights).filter(|&(&slot, _)| slot as usize >= first_slot)
            {
                if let Some(sum) = sums.get_mut(slot as usize) {
                    *sum = std::array::from_fn(|i| sum[i] + vector[i] * weight);
                }
            }
        }
    }
}

/// Whether a corner has the same slot as the one before it in its face.
pub(crate) fn repeats(slots: &[u32], corner: usize) -> bool {
    slots[corner] == slots[(corner + slots.len() - 1) % slots.len()]
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::mesh::{FacesRef, Positions, Storage};
    use crate::normals::recipe::{Slivers, Weight};
    use crate::normals::sums::partition::Partition;
    use crate::normals::sums::request::SlotState;
    use crate::normals::sums::weighted_sums::{SumScratch, weighted_sums};
    use crate::normals::test_meshes::{bumpy, with_threads};
    use crate::num::test_numbers::Numbers;

    #[test]
    fn any_number_of_threads_gives_the_same_bits() {
        let (faces, points) = bumpy(200, 11);
        let mut numbers = Numbers::new(8);
        // In no order, it is all one part's work; with a few faces far from where they belong, parts touch slots that are
        // others', the first one the very last. Shares begin in order, which distinguishes them from no order.
        let mut shuffled = faces.clone();
        numbers.shuffle(&mut shuffled);
        let mut mixed = faces.clone();
        mixed.swap(3 * BLOCK, faces.len() - 1);
        let begins_no_share = |face: &usize| (110..150).contains(&(face / BLOCK % 156));
        let inside: Vec<usize> = (0..faces.len()).filter(begins_no_share).collect();
        for &face in inside.iter().step_by(97) {
            mixed.swap(face, inside[numbers.below(inside.len())]);
        }
        let parts = |faces: &[[u32; 3]]| {
            let target = faces.as_flattened();
            with_threads(8, || Partition::new(FacesRef::triangles(faces), target).parts())
        };
        assert_eq!([&faces, &mixed, &shuffled].map(|faces| parts(faces)), [8, 8, 1]);
        for faces in [&faces, &mixed, &shuffled] {
            for weight in Weight::ALL {
                for positions in [Storage::F32, Storage::F64].map(|it| Positions::rounded(points.clone(), it))
                {
                    let request = SumRequest {
                        faces: FacesRef::triangles(faces),
                        positions: positions.view(),
                        target: faces.as_flattened(),
                        slots: points.len(),
                        weight,
                        slivers: Slivers::Exclude,
                    };
                    let alone = with_threads(1, || weighted_sums(&request, &mut SumScratch::default()).0);
                    assert!(alone.state.iter().all(|&state| state == SlotState::Good));
                    for threads in [2, 3, 8] {
                        assert_eq!(
                            with_threads(threads, || weighted_sums(&request, &mut SumScratch::default()).0),
                            alone
                        );
                    }
                }
            }
        }
    }
}
