//! The work of one part: adding up faces.

use crate::normals::faces::positions::Source;
use crate::normals::faces::shape::FaceState;
use crate::normals::sums::block::{ALL, GroupTerms, are_inner, group_terms};
use crate::normals::sums::corner_mean::adds;
use crate::normals::sums::corner_terms::CornerTerms;
use crate::normals::sums::finish::UncertainSlots;
use crate::normals::sums::partition::{BLOCK, Touched};
use crate::normals::sums::request::{Sum, SumRequest};
use crate::num::{Kernel, LANES, Lanes};
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

impl<T: Number> Part<T> {
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

/// The type of the numbers of a sum.
pub(crate) trait Number: bytemuck::Pod + Send + Sync {}

impl Number for f32 {}
impl Number for f64 {}

/// A sum for every slot, all zero between calls. Pages that no face touches are never given memory.
#[derive(Default)]
pub(crate) struct SumArray<T>(Vec<T>);

impl<T: Number> SumArray<T> {
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

/// Adds faces to sums.
pub(crate) struct Accumulate<'a> {
    pub(crate) request: &'a SumRequest<'a>,
    pub(crate) source: &'a Source<'a>,
    pub(crate) walk: Walk<'a>,
    /// Slots beyond its end are left alone.
    pub(crate) sums: &'a mut [Sum],
    /// Takes the faces that are not simply counted.
    pub(crate) unusual: &'a mut Vec<UnusualFace>,
}

impl Kernel for Accumulate<'_> {
    /// Whether every vertex exists.
    type Output = bool;

    #[inline(always)]
    fn run<A: Lanes>(self, arch: A) -> bool {
        let Self { request, source, walk, sums, unusual } = self;
        let mut terms = Terms::new(request, source, unusual);
        match walk {
            Walk::Share(share, mut touched) => {
                for first in share.clone().step_by(BLOCK) {
                    let faces = first..(first + BLOCK).min(share.end);
                    if let Some(touched) = &mut touched {
                        let corners = request.faces.start(faces.start)..request.faces.start(faces.end);
                        touched.note(&request.target[corners]);
                    }
                    if !request.faces.is_triangles() {
                        terms.polygons(faces, sums, 0);
                        continue;
                    }
                    let triangles = &request.faces.corners().as_chunks::<3>().0[faces.clone()];
                    if !terms.block(arch, triangles, |at| first + at) {
                        return false;
                    }
                    let slots = &request.target.as_chunks::<3>().0[faces];
                    terms.scatter(arch, slots, sums, |slot| slot as usize);
                }
            }
            Walk::Listed(faces, first_slot) if request.faces.is_triangles() => {
                let triangles = request.faces.corners().as_chunks::<3>().0;
                let slots = request.target.as_chunks::<3>().0;
                for faces in faces.chunks(BLOCK) {
                    let (mut some_triangles, mut some_slots) = ([[0; 3]; BLOCK], [[0; 3]; BLOCK]);
                    for (at, &face) in faces.iter().enumerate() {
                        some_triangles[at] = triangles[face as usize];
                        some_slots[at] = slots[face as usize];
                    }
                    let count = faces.len();
                    if !terms.block(arch, &some_triangles[..count], |at| faces[at] as usize) {
                        return false;
                    }
                    let own =
                        |slot: u32| if slot as usize >= first_slot { slot as usize } else { usize::MAX };
                    terms.scatter(arch, &some_slots[..count], sums, own);
                }
            }
            Walk::Listed(faces, first_slot) => {
                terms.polygons(faces.iter().map(|&face| face as usize), sums, first_slot);
            }
        }
        true
    }
}

/// A block of triangles: what each adds to sums.
struct Terms<'a> {
    request: &'a SumRequest<'a>,
    source: &'a Source<'a>,
    unusual: &'a mut Vec<UnusualFace>,
    groups: [GroupTerms; BLOCK / LANES],
    scalar: CornerTerms,
}

impl<'a> Terms<'a> {
    fn new(request: &'a SumRequest<'a>, source: &'a Source<'a>, unusual: &'a mut Vec<UnusualFace>) -> Self {
        let groups = [GroupTerms::ZERO; BLOCK / LANES];
        Self { request, source, unusual, groups, scalar: CornerTerms::default() }
    }

    /// Computes up to [`BLOCK`] triangles; false if a vertex does not exist.
    #[inline(always)]
    fn block<A: Lanes>(&mut self, arch: A, triangles: &[[u32; 3]], face: impl Fn(usize) -> usize) -> bool {
        // Copies, which stay in registers.
        let (source, weight) = (*self.source, self.request.weight);
        let all_inner = are_inner(&source, triangles);
        let (groups, rest) = triangles.as_chunks::<LANES>();
        for (group, triangles) in groups.iter().enumerate() {
            let inner = all_inner || are_inner(&source, triangles);
            let terms = &mut self.groups[group];
            let settled = if inner { group_terms(arch, triangles, &source, weight, terms) } else { 0 };
            if settled != ALL && !self.settle(group, LANES, settled, &face) {
                return false;
            }
        }
        rest.is_empty() || self.settle(groups.len(), rest.len(), 0, &face)
    }

    /// Computes the triangles of a group whose bit is not set, by the scalar path; false if a vertex does not exist.
    #[inline(never)]
    fn settle(&mut self, group: usize, count: usize, settled: u8, face: impl Fn(usize) -> usize) -> bool {
        let Self { request, source, .. } = *self;
        for row in (0..count).filter(|row| settled >> row & 1 == 0) {
            let face = face(group * LANES + row);
            if request.faces.face(face).iter().any(|&vertex| vertex as usize >= source.count()) {
                return false;
            }
            if self.fill(face, |_| false) {
                self.groups[group].set(row, self.scalar.vector, &self.scalar.weights);
            } else {
                self.groups[group].set(row, [0.0; 4], &[0.0; 3]);
            }
        }
        true
    }

    /// Computes one face by the scalar path, and returns whether it adds to sums.
    fn fill(&mut self, face: usize, repeats: impl Fn(usize) -> bool) -> bool {
        self.scalar.fill(self.request.faces, self.source, self.request.weight, face, repeats);
        let state = self.scalar.state;
        if state != FaceState::Counted {
            self.unusual.push((face as u32, state));
        }
        adds(state, self.request.slivers)
    }

    /// Adds the triangles of the block to the sums of their corners. Slots beyond the sums are skipped.
    #[inline(always)]
    fn scatter<A: Lanes>(&self, arch: A, slots: &[[u32; 3]], sums: &mut [Sum], place: impl Fn(u32) -> usize) {
        let is_equal = self.request.weight.is_equal_at_corners();
        for (terms, slots) in self.groups.iter().zip(slots.chunks(LANES)) {
            for (row, slots) in slots.iter().enumerate() {
                let (vector, weights) = (&terms.vectors.0[row], &terms.weights.0[row]);
                for (&slot, &weight) in slots.iter().zip(weights) {
                    match sums.get_mut(place(slot)) {
                        Some(sum) if is_equal => arch.add_row(sum, vector),
                        Some(sum) => arch.add_scaled_row(sum, vector, weight),
                        None => {}
                    }
                }
            }
        }
    }

    /// Adds faces of any size. Their vertices exist: only slices of triangles come unchecked.
    fn polygons(&mut self, faces: impl Iterator<Item = usize>, sums: &mut [Sum], first_slot: usize) {
        for face in faces {
            let slots = &self.request.target[self.request.faces.range(face)];
            if !self.fill(face, |corner| repeats(slots, corner)) {
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

/// Looks states up for faces that come in ascending order.
pub(crate) struct UnusualFaces<'a>(&'a [UnusualFace]);

impl<'a> UnusualFaces<'a> {
    pub(crate) fn new(unusual: &'a [UnusualFace], first: usize) -> Self {
        Self(&unusual[unusual.partition_point(|&(face, _)| (face as usize) < first)..])
    }

    pub(crate) fn state(&mut self, face: usize) -> FaceState {
        match self.0.split_first() {
            Some((&(unusual, state), rest)) if unusual as usize == face => {
                self.0 = rest;
                state
            }
            _ => FaceState::Counted,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::mesh::{FacesRef, Storage};
    use crate::normals::faces::positions::Positions;
    use crate::normals::recipe::{Slivers, Weight};
    use crate::normals::sums::partition::Partition;
    use crate::normals::sums::request::SlotState;
    use crate::normals::sums::weighted_sums::weighted_sums;
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
                for storage in [Storage::F32, Storage::F64] {
                    let request = SumRequest {
                        faces: FacesRef::triangles(faces),
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
