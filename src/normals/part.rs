//! The work of one part: its share of slots, from accumulating to unit vectors.

use super::block::{BlockTerms, Corners, LANES, block_terms};
use super::corner_terms::CornerTerms;
use super::emit::Emit;
use super::face_shape::FaceState;
use super::partition::{BLOCK_FACES, CHUNK, Numbering, Partition};
use super::positions::Source;
use super::sums::{CANCELLING, OddFace, SlotState, SumRequest};
use super::term::{Term, adds, classify, mean};
use super::weight::CornerWeight;
use crate::num::{self, Kernel, Product};
use glam::DVec3;
use std::marker::PhantomData;

/// A running sum: Σ w n̂ and Σ w.
type Sum = [f64; 4];

/// What takes the place of Σ w of a slot that has to be looked at again.
mod mark {
    /// Its faces all point the same way: is it only one?
    pub(super) const PERHAPS_ONE_FACE: f64 = -1.0;
    /// One face so far; its number takes the place of x.
    pub(super) const ONE_FACE: f64 = -2.0;
    /// More than one.
    pub(super) const FACES: f64 = -3.0;
    /// Nothing was added.
    pub(super) const NOTHING: f64 = -4.0;

    /// Takes note of a face that adds to a slot of perhaps one face.
    pub(super) fn one_more_face(sum: &mut super::Sum, face: usize) {
        if sum[3] == PERHAPS_ONE_FACE {
            (sum[0], sum[3]) = (face as f64, ONE_FACE);
        } else if sum[0] != face as f64 {
            sum[3] = FACES;
        }
    }
}

/// A sum shorter than its weights by less than this comes from faces that point the same way to the last bits.
const SAME_WAY: f64 = 1.0 + 64.0 * f64::EPSILON;

/// Memory of one part.
#[derive(Default)]
pub(crate) struct Part {
    /// Where its slots begin, chunk by chunk.
    pub(crate) starts: Vec<u32>,
    /// Faces not simply counted, in blocks that count as this part's.
    pub(crate) odd_at_home: Vec<OddFace>,
    /// The same in all blocks that it walks.
    odd: Vec<OddFace>,
    sums: Vec<Sum>,
    /// Lowest and highest slot of each block walked.
    bounds: Vec<(u32, u32)>,
    /// Slots to look at again, ascending, by their number in the mesh.
    again: Vec<u32>,
}

/// A part's work on a request.
pub(crate) struct Task<'a, S, O> {
    pub(crate) request: &'a SumRequest<'a>,
    pub(crate) source: S,
    pub(crate) partition: &'a Partition,
    pub(crate) number: usize,
    /// How many slots are its own.
    pub(crate) slots: usize,
    pub(crate) part: &'a mut Part,
    /// Where to write, chunk by chunk in ascending order.
    pub(crate) outputs: Vec<Output<'a, O>>,
}

/// Where the results of some slots in a row go.
pub(crate) struct Output<'a, O> {
    /// The first of them.
    pub(crate) first: u32,
    /// Their unit vectors.
    pub(crate) unit: &'a mut [O],
    /// What those are worth.
    pub(crate) state: &'a mut [SlotState],
}

impl<'a, S, O> Task<'a, S, O> {
    pub(crate) fn with<W, N>(self, numbering: N) -> Run<'a, S, O, W, N> {
        Run { task: self, numbering, weight: PhantomData }
    }
}

/// The same with everything known that a kernel is compiled for.
pub(crate) struct Run<'a, S, O, W, N> {
    task: Task<'a, S, O>,
    numbering: N,
    weight: PhantomData<W>,
}

impl<S: Source, O: Emit, W: CornerWeight, N: Numbering> Kernel for Run<'_, S, O, W, N> {
    type Output = ();

    #[inline(always)]
    fn run<P: Product>(mut self) {
        self.accumulate::<P>();
        self.finish();
        if !self.task.part.again.is_empty() {
            self.look_again::<P>();
        }
    }
}

impl<S: Source, O: Emit, W: CornerWeight, N: Numbering> Run<'_, S, O, W, N> {
    #[inline(always)]
    fn accumulate<P: Product>(&mut self) {
        let Task { request, source, partition, number, slots, .. } = self.task;
        let Part { sums, odd, odd_at_home, bounds, .. } = &mut *self.task.part;
        sums.clear();
        sums.resize(slots, [0.0; 4]);
        odd.clear();
        odd_at_home.clear();
        bounds.clear();
        let mut scalar = CornerTerms::default();
        let (mut corners, mut terms) = (Corners::new(), BlockTerms::new());
        for (first, end) in partition.walk(number, request.faces) {
            let target = &request.target[request.faces.start(first)..request.faces.start(end)];
            bounds.push(lowest_and_highest(target));
            let odd_before = odd.len();
            if request.faces.is_triangles() {
                let triangles = &request.faces.corners().as_chunks::<3>().0[first..end];
                let blocks = triangles.chunks(LANES).zip(target.as_chunks::<3>().0.chunks(LANES));
                for (block, (triangles, slots)) in blocks.enumerate() {
                    corners.gather(triangles, source);
                    block_terms::<P, S, W>(&corners, source, &mut terms);
                    let faces = first + block * LANES;
                    let settled = terms.settled[..triangles.len()].iter().fold(1, |all, &one| all & one);
                    if settled == 0 {
                        settle::<P, S, W>(
                            request,
                            source,
                            faces,
                            triangles.len(),
                            &mut terms,
                            &mut scalar,
                            odd,
                        );
                    }
                    scatter::<W, N>(&terms, slots, self.numbering, sums);
                }
            } else {
                for face in first..end {
                    let range = request.faces.range(face);
                    let slots = &request.target[range];
                    scalar.fill::<P, S, W>(request.faces, source, face, |corner| repeats(slots, corner));
                    if scalar.state != FaceState::Counted {
                        odd.push((face as u32, scalar.state));
                    }
                    if adds(scalar.state, request.slivers) {
                        for (&slot, &weight) in slots.iter().zip(&scalar.weights) {
                            add(sums, self.numbering.local(slot), scalar.vector, weight);
                        }
                    }
                }
            }
            if partition.home(first / BLOCK_FACES) == number {
                odd_at_home.extend_from_slice(&odd[odd_before..]);
            }
        }
    }

    /// Sums to unit vectors.
    #[inline(always)]
    fn finish(&mut self) {
        let Part { sums, again, .. } = &mut *self.task.part;
        again.clear();
        let mut rest = &mut sums[..];
        for Output { first, unit, state } in &mut self.task.outputs {
            let (own, others) = rest.split_at_mut(unit.len());
            rest = others;
            for (at, ((sum, unit), state)) in own.iter_mut().zip(&mut **unit).zip(&mut **state).enumerate() {
                let [x, y, z, weights] = *sum;
                if weights == 0.0 {
                    sum[3] = mark::NOTHING;
                    again.push(*first + at as u32);
                    (*unit, *state) = (O::emit(DVec3::ZERO), SlotState::Empty);
                    continue;
                }
                let vector = DVec3::new(x, y, z);
                let (direction, length) = num::direction(vector);
                (*unit, *state) = (O::emit(direction), SlotState::Good);
                if weights > CANCELLING * length {
                    let (left, cancelling) = classify(vector, weights);
                    (*unit, *state) = (O::emit(left), cancelling);
                } else if !(W::BY_AREA && W::EVEN) && weights <= SAME_WAY * length {
                    // An area vector comes to its normal's bits by itself.
                    sum[3] = mark::PERHAPS_ONE_FACE;
                    again.push(*first + at as u32);
                }
            }
        }
    }

    /// Slots of one face, which get its normal to the bit, and slots that nothing was added to.
    #[inline(never)]
    fn look_again<P: Product>(mut self) {
        let Task { request, source, .. } = self.task;
        let (alone, mut terms) = self.collect::<P>();
        let mut scalar = CornerTerms::default();
        for faces in alone.chunk_by(|a, b| a.0 == b.0) {
            let unit = scalar.shape::<P, S>(request.faces, source, faces[0].0 as usize).unit;
            faces.iter().for_each(|&(_, slot)| self.write(slot, unit, SlotState::Good));
        }
        // Stable: the terms of a slot stay in ascending face index.
        terms.sort_by_key(|&(slot, _)| slot);
        for slot in terms.chunk_by(|a, b| a.0 == b.0) {
            let of_slot: Vec<Term> = slot.iter().map(|&(_, term)| term).collect();
            let (unit, state) = mean(&of_slot, request.slivers);
            self.write(slot[0].0, unit, state);
        }
    }

    /// Walks the faces once more: slots of one face, sorted by face, and the terms of slots without a sum. Slots are
    /// numbered as the part's own.
    fn collect<P: Product>(&mut self) -> (Vec<(u32, u32)>, Vec<(u32, Term)>) {
        let Task { request, source, partition, number, .. } = self.task;
        let Part { sums, odd, bounds, again, .. } = &mut *self.task.part;
        let (mut scalar, mut terms) = (CornerTerms::default(), Vec::new());
        for ((first, end), &(low, high)) in partition.walk(number, request.faces).zip(&*bounds) {
            let next = again.partition_point(|&slot| slot < low);
            if again.get(next).is_none_or(|&slot| slot > high) {
                continue;
            }
            let mut odd = odd[odd.partition_point(|&(face, _)| (face as usize) < first)..].iter();
            let mut next_odd = odd.next();
            for face in first..end {
                let state = match next_odd {
                    Some(&(odd_face, state)) if odd_face as usize == face => {
                        next_odd = odd.next();
                        state
                    }
                    _ => FaceState::Counted,
                };
                let range = request.faces.range(face);
                let slots = &request.target[range];
                let mut filled = false;
                for (corner, &slot) in slots.iter().enumerate() {
                    let slot = self.numbering.local(slot);
                    let Some(sum) = sums.get_mut(slot).filter(|sum| sum[3] < 0.0) else { continue };
                    if sum[3] != mark::NOTHING {
                        if adds(state, request.slivers) {
                            mark::one_more_face(sum, face);
                        }
                    } else if state.has_direction() {
                        if !filled {
                            scalar.fill::<P, S, W>(request.faces, source, face, |at| repeats(slots, at));
                            filled = true;
                        }
                        let (vector, weight) = (scalar.vector, scalar.weights[corner]);
                        terms.push((slot as u32, Term { vector, weight, face: face as u32, state }));
                    }
                }
            }
        }
        let alone = again.iter().filter_map(|&slot| {
            let slot = self.numbering.local(slot);
            (sums[slot][3] == mark::ONE_FACE).then(|| (sums[slot][0] as u32, slot as u32))
        });
        let mut alone: Vec<(u32, u32)> = alone.collect();
        alone.sort_unstable();
        (alone, terms)
    }

    /// Writes the result of a slot, by its number among the part's own.
    fn write(&mut self, slot: u32, unit: DVec3, state: SlotState) {
        let outputs = &mut self.task.outputs;
        let (chunk, at) = match outputs.len() {
            1 => (0, slot as usize),
            _ => (slot as usize / CHUNK, slot as usize % CHUNK),
        };
        outputs[chunk].unit[at] = O::emit(unit);
        outputs[chunk].state[at] = state;
    }
}

/// Puts right the triangles of a block that could not be computed together.
#[inline(never)]
fn settle<P: Product, S: Source, W: CornerWeight>(
    request: &SumRequest,
    source: S,
    first: usize,
    count: usize,
    terms: &mut BlockTerms,
    scalar: &mut CornerTerms,
    odd: &mut Vec<OddFace>,
) {
    for lane in (0..count).filter(|&lane| terms.settled[lane] == 0).collect::<Vec<_>>() {
        scalar.fill::<P, S, W>(request.faces, source, first + lane, |_| false);
        if scalar.state != FaceState::Counted {
            odd.push(((first + lane) as u32, scalar.state));
        }
        if adds(scalar.state, request.slivers) {
            terms.vectors[lane] = scalar.vector;
            terms.weights[lane][..3].copy_from_slice(&scalar.weights);
        } else {
            terms.vectors[lane] = [0.0; 4];
            terms.weights[lane] = [0.0; 4];
        }
    }
}

/// Adds the triangles of a block to the slots of their corners.
#[inline(always)]
fn scatter<W: CornerWeight, N: Numbering>(
    terms: &BlockTerms,
    slots: &[[u32; 3]],
    numbering: N,
    sums: &mut [Sum],
) {
    for (lane, slots) in slots.iter().enumerate().take(LANES) {
        for (corner, &slot) in slots.iter().enumerate() {
            let weight = if W::EVEN { 1.0 } else { terms.weights[lane][corner] };
            add(sums, numbering.local(slot), terms.vectors[lane], weight);
        }
    }
}

/// Adds to a slot, unless it is another part's.
#[inline(always)]
fn add(sums: &mut [Sum], slot: usize, vector: [f64; 4], weight: f64) {
    if let Some(sum) = sums.get_mut(slot) {
        for (sum, x) in sum.iter_mut().zip(vector) {
            *sum += x * weight;
        }
    }
}

/// Whether a corner has the same slot as the one before it in its face.
fn repeats(slots: &[u32], corner: usize) -> bool {
    slots[corner] == slots[(corner + slots.len() - 1) % slots.len()]
}

#[inline(always)]
fn lowest_and_highest(slots: &[u32]) -> (u32, u32) {
    slots.iter().fold((u32::MAX, 0), |(low, high), &slot| (low.min(slot), high.max(slot)))
}

#[cfg(test)]
mod tests {
    use super::super::positions::Positions;
    use super::super::sums::weighted_sums;
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
