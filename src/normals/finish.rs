//! From sums to unit vectors.

use super::block::LANES;
use super::corner_terms::CornerTerms;
use super::emit::Emit;
use super::face_shape::FaceState;
use super::part::{Part, Sum, Task, repeats};
use super::partition::{CHUNK, bounds};
use super::positions::Source;
use super::sums::{CANCELLING, SlotState};
use super::term::{Term, adds, classify, mean};
use super::weight::CornerWeight;
use crate::num::{self, Kernel, Product};
use glam::DVec3;

/// Where the results of some slots in a row go.
pub(crate) struct Output<'a, O> {
    /// The first of them.
    pub(crate) first: u32,
    /// Their unit vectors.
    pub(crate) unit: &'a mut [O],
    /// What those are worth.
    pub(crate) state: &'a mut [SlotState],
}

/// What takes the place of Σ w of a slot that has to be looked at again.
mod mark {
    use super::Sum;

    /// Its faces all point the same way: is it only one?
    pub(super) const PERHAPS_ONE_FACE: f64 = -1.0;
    /// One face so far; its number takes the place of x.
    pub(super) const ONE_FACE: f64 = -2.0;
    /// More than one.
    pub(super) const FACES: f64 = -3.0;
    /// Nothing was added, or perhaps it cancelled: its terms have to be gone through one by one.
    pub(super) const RECOUNT: f64 = -4.0;

    /// Takes note of a face that adds to a slot of perhaps one face.
    pub(super) fn one_more_face(Sum(sum): &mut Sum, face: usize) {
        if sum[3] == PERHAPS_ONE_FACE {
            (sum[0], sum[3]) = (face as f64, ONE_FACE);
        } else if sum[0] != face as f64 {
            sum[3] = FACES;
        }
    }
}

/// A sum shorter than its weights by less than this comes from faces that point the same way to the last bits.
const SAME_WAY: f64 = 1.0 + 64.0 * f64::EPSILON;

/// Turns a part's sums into unit vectors, and notes which slots to look at again.
pub(crate) struct Finish<'a, 'b, O> {
    pub(crate) part: &'a mut Part,
    /// Where to write, chunk by chunk in ascending order.
    pub(crate) outputs: &'a mut [Output<'b, O>],
    /// Whether the sums are of plain area vectors. Then a slot of one face comes to that face's bits by itself, but Σ w is
    /// only an upper bound.
    pub(crate) areas: bool,
}

impl<O: Emit> Kernel for Finish<'_, '_, O> {
    type Output = ();

    #[inline(always)]
    fn run<P: Product>(self) {
        let Self { part: Part { sums, again, all_good, .. }, outputs, areas } = self;
        again.clear();
        *all_good = true;
        let mut rest = &mut sums[..];
        for Output { first, unit, state } in outputs {
            let (own, others) = rest.split_at_mut(unit.len());
            rest = others;
            state.fill(SlotState::Good);
            let blocks = own.chunks_mut(LANES).zip(unit.chunks_mut(LANES)).zip(state.chunks_mut(LANES));
            for (block, ((sums, unit), state)) in blocks.enumerate() {
                // No sum is shorter than nothing: where single faces are not looked for, none is found.
                if finish_block(sums, unit, if areas { 0.0 } else { SAME_WAY }) {
                    continue;
                }
                for (lane, ((sum, unit), state)) in sums.iter_mut().zip(unit).zip(state).enumerate() {
                    let (vector, worth) = finish_one(sum, areas);
                    (*unit, *state) = (O::emit(vector), worth);
                    *all_good &= worth == SlotState::Good;
                    if sum.0[3] < 0.0 {
                        again.push(*first + (block * LANES + lane) as u32);
                    }
                }
            }
        }
    }
}

/// A full block of sums at once; false if one of them is out of the ordinary, and then nothing is certain.
#[inline(always)]
fn finish_block<O: Emit>(sums: &[Sum], unit: &mut [O], same_way: f64) -> bool {
    let Ok(sums) = <&[Sum; LANES]>::try_from(sums) else { return false };
    let mut columns = [[0.0; LANES]; 4];
    for lane in 0..LANES {
        let Sum([x, y, z, weights]) = sums[lane];
        columns[0][lane] = x;
        columns[1][lane] = y;
        columns[2][lane] = z;
        columns[3][lane] = weights;
    }
    let mut good = [0_u64; LANES];
    for lane in 0..LANES {
        let vector = DVec3::new(columns[0][lane], columns[1][lane], columns[2][lane]);
        let weights = columns[3][lane];
        let squared = num::squared_length(vector);
        let length = squared.sqrt();
        let direction = vector * (1.0 / length);
        columns[0][lane] = direction.x;
        columns[1][lane] = direction.y;
        columns[2][lane] = direction.z;
        let ordinary =
            num::is_plain(squared) & (weights <= CANCELLING * length) & (weights > same_way * length);
        good[lane] = u64::from(ordinary);
    }
    for (lane, unit) in unit.iter_mut().enumerate().take(LANES) {
        *unit = O::emit(DVec3::new(columns[0][lane], columns[1][lane], columns[2][lane]));
    }
    good.iter().fold(1, |all, one| all & one) == 1
}

/// One sum. Where it must be looked at again, a mark takes the place of its weights.
fn finish_one(Sum(sum): &mut Sum, areas: bool) -> (DVec3, SlotState) {
    let [x, y, z, weights] = *sum;
    if weights == 0.0 {
        sum[3] = mark::RECOUNT;
        return (DVec3::ZERO, SlotState::Empty);
    }
    let (vector, worth, length) = classify(DVec3::new(x, y, z), weights);
    if areas && worth == SlotState::Cancelling {
        sum[3] = mark::RECOUNT;
    } else if !areas && weights <= SAME_WAY * length {
        sum[3] = mark::PERHAPS_ONE_FACE;
    }
    (vector, worth)
}

/// Writes the result of a slot, by its number among the part's own.
pub(crate) fn write<O: Emit>(outputs: &mut [Output<O>], slot: u32, unit: DVec3, state: SlotState) {
    let (chunk, at) = match outputs.len() {
        1 => (0, slot as usize),
        _ => (slot as usize / CHUNK, slot as usize % CHUNK),
    };
    outputs[chunk].unit[at] = O::emit(unit);
    outputs[chunk].state[at] = state;
}

/// Gives the results that sums alone do not: of slots of one face, which get its normal to the bit, of those that nothing
/// was added to, and of those that seem to cancel. Slots are numbered as the part's own.
pub(crate) struct LookAgain<'a, S, W> {
    pub(crate) task: Task<'a, S, W>,
    pub(crate) part: &'a mut Part,
}

impl<S: Source, W: CornerWeight> Kernel for LookAgain<'_, S, W> {
    type Output = Vec<(u32, DVec3, SlotState)>;

    fn run<P: Product>(mut self) -> Self::Output {
        let Task { request, source, .. } = self.task;
        let (alone, mut terms) = self.collect::<P>();
        let mut scalar = CornerTerms::default();
        let mut results = Vec::with_capacity(alone.len());
        for slots in alone.chunk_by(|a, b| a.0 == b.0) {
            let unit = scalar.shape::<P, S>(request.faces, source, slots[0].0 as usize).unit;
            results.extend(slots.iter().map(|&(_, slot)| (slot, unit, SlotState::Good)));
        }
        // Stable: the terms of a slot stay in ascending face index.
        terms.sort_by_key(|&(slot, _)| slot);
        let mut of_slot = Vec::new();
        for terms in terms.chunk_by(|a, b| a.0 == b.0) {
            of_slot.clear();
            of_slot.extend(terms.iter().map(|&(_, term)| term));
            let (unit, state) = mean(&of_slot, request.slivers);
            results.push((terms[0].0, unit, state));
        }
        results
    }
}

impl<S: Source, W: CornerWeight> LookAgain<'_, S, W> {
    /// Walks the faces once more: slots of one face, as (face, slot) sorted by face, and the terms of slots without a sum.
    #[expect(clippy::type_complexity, reason = "two lists of pairs, named in the line above")]
    fn collect<P: Product>(&mut self) -> (Vec<(u32, u32)>, Vec<(u32, Term)>) {
        let Task { request, source, partition, number, numbering, .. } = self.task;
        let Part { sums, odd, again, .. } = &mut *self.part;
        let (mut scalar, mut terms) = (CornerTerms::default(), Vec::new());
        for (first, end) in partition.walk(number, request.faces) {
            let (low, high) = bounds(&request.target[request.faces.start(first)..request.faces.start(end)]);
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
                    let slot = numbering.local(slot);
                    let Some(sum) = sums.get_mut(slot).filter(|sum| sum.0[3] < 0.0) else { continue };
                    if sum.0[3] != mark::RECOUNT {
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
            let slot = numbering.local(slot);
            (sums[slot].0[3] == mark::ONE_FACE).then(|| (sums[slot].0[0] as u32, slot as u32))
        });
        let mut alone: Vec<(u32, u32)> = alone.collect();
        alone.sort_unstable();
        (alone, terms)
    }
}
