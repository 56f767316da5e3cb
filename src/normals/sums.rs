//! Weighted sums of face normals over vertices or smooth groups.

use super::again::LookAgain;
use super::emit::Emit;
use super::finish::{Doubts, Finish, Output};
use super::part::{Accumulate, OddFace, Part, Sum, Walk};
use super::partition::{BLOCK_FACES, Numbering, Partition};
use super::positions::{Positions, Source, Visitor};
use super::weight::{CornerWeight, WeightVisitor, visit_weight};
use super::{Slivers, Weight};
use crate::mesh::FacesRef;
use crate::num;
use glam::DVec3;
use rayon::prelude::*;
use std::marker::PhantomData;

/// A sum with more than this times its own length in weights has cancelled.
pub(crate) const CANCELLING: f64 = 1e6;

/// What became of a slot's sum.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
#[repr(u8)]
pub(crate) enum SlotState {
    /// It has a direction.
    Good,
    /// Σ|w| / |Σ w n̂| is above 10^6: what is left is rounding.
    Cancelling,
    /// No face with a direction adds to it.
    #[default]
    Empty,
}

/// What to add up, and where. A *slot* is whatever a sum belongs to: a vertex, a smooth group.
#[derive(Clone, Copy)]
pub(crate) struct SumRequest<'a> {
    /// The faces.
    pub(crate) faces: FacesRef<'a>,
    /// The positions of vertices.
    pub(crate) positions: Positions<'a>,
    /// The slot of each corner, [`NONE`](crate::mesh::NONE) to leave it out.
    pub(crate) target: &'a [u32],
    /// How many slots there are.
    pub(crate) slots: usize,
    /// How much each face counts.
    pub(crate) weight: Weight,
    /// What slivers count.
    pub(crate) slivers: Slivers,
}

/// One direction a slot.
#[derive(Clone, Debug, Default, PartialEq)]
pub(crate) struct Sums {
    /// Unit vectors. Of a cancelling slot the direction of what is left, of an empty one zero.
    pub(crate) unit: Vec<DVec3>,
    /// What each is worth.
    pub(crate) state: Vec<SlotState>,
}

/// Memory that can be used again by the next call.
#[derive(Default)]
pub(crate) struct SumScratch {
    partition: Partition,
    /// Their sums are zero between calls.
    parts: Vec<Part>,
}

/// What is worth knowing beside the sums themselves.
#[derive(Default)]
pub(crate) struct Outcome {
    /// The faces that are not simply counted, ascending.
    pub(crate) odd: Vec<OddFace>,
    /// Whether it is certain that every slot is [`SlotState::Good`].
    pub(crate) all_good: bool,
    /// Whether a face has a vertex that does not exist. Then nothing was computed.
    pub(crate) vertex_missing: bool,
}

/// Adds up Σ w n̂ for every slot, each sum in ascending face index whatever the number of threads.
///
/// Faces without direction add nothing, nor do slivers with [`Slivers::Exclude`], unless a slot has no other face. If
/// all weights of a slot vanish, its faces count the same. A slot with one face gets that face's normal to the bit.
pub(crate) fn weighted_sums(request: &SumRequest) -> Sums {
    let mut sums =
        Sums { unit: bytemuck::zeroed_vec(request.slots), state: vec![SlotState::Empty; request.slots] };
    weighted_sums_into(request, &mut SumScratch::default(), &mut sums.unit, &mut sums.state);
    sums
}

/// The same into the caller's slices, one entry a slot.
pub(crate) fn weighted_sums_into<O: Emit>(
    request: &SumRequest,
    scratch: &mut SumScratch,
    unit: &mut [O],
    state: &mut [SlotState],
) -> Outcome {
    request.positions.visit(WithSource { request, scratch, unit, state })
}

struct WithSource<'a, O> {
    request: &'a SumRequest<'a>,
    scratch: &'a mut SumScratch,
    unit: &'a mut [O],
    state: &'a mut [SlotState],
}

impl<O: Emit> Visitor for WithSource<'_, O> {
    type Output = Outcome;

    fn visit<S: Source>(self, source: S) -> Self::Output {
        visit_weight(self.request.weight, WithWeight { all: self, source })
    }
}

struct WithWeight<'a, S, O> {
    all: WithSource<'a, O>,
    source: S,
}

impl<S: Source, O: Emit> WeightVisitor for WithWeight<'_, S, O> {
    type Output = Outcome;

    fn visit<W: CornerWeight>(self) -> Self::Output {
        let Self { all: WithSource { request, scratch, unit, state }, source } = self;
        // Whatever stops the work half way, the next call does not find its sums.
        let SumScratch { mut partition, mut parts } = std::mem::take(scratch);
        partition.fill(request.faces, request.target, request.slots);
        parts.resize_with(partition.parts(), Part::default);
        let alone = partition.parts() == 1;

        let accumulate = |part: &mut Part, walk: Walk| {
            let Part { sums, starts, odd, abroad, .. } = part;
            let numbering = if alone { Numbering::Alone } else { Numbering::Chunked(starts) };
            let weight = PhantomData::<W>;
            num::dispatch(Accumulate { request, source, walk, numbering, sums, odd, abroad, weight })
        };
        let add_share = |(number, part): (usize, &mut Part)| {
            part.odd.clear();
            part.abroad.clear();
            part.sums.resize(partition.number(number, request.slots, &mut part.starts), Sum::default());
            let share = partition.share(number);
            let faces = share.start * BLOCK_FACES..(share.end * BLOCK_FACES).min(request.faces.len());
            accumulate(part, Walk::Share(&faces))
        };
        let finish = |part: &mut Part, outputs: &mut [Output<O>]| {
            let Part { sums, doubts, .. } = part;
            doubts.clear();
            num::dispatch(Finish { sums, outputs, doubts, areas: W::BY_AREA && W::EVEN });
        };
        if let [part] = &mut parts[..] {
            if !add_share((0, part)) {
                return Outcome { vertex_missing: true, ..Outcome::default() };
            }
            finish(part, &mut [Output { first: 0, unit: &mut *unit, state: &mut *state }]);
        } else {
            if !parts.par_iter_mut().enumerate().map(add_share).reduce(|| true, |a, b| a & b) {
                return Outcome { vertex_missing: true, ..Outcome::default() };
            }
            let abroad: Vec<Vec<u32>> =
                parts.iter_mut().map(|part| std::mem::take(&mut part.abroad)).collect();
            let outputs = partition.outputs(unit, state);
            parts.par_iter_mut().zip(outputs).enumerate().for_each(|(number, (part, mut outputs))| {
                let odd = part.odd.len();
                for faces in &abroad[number + 1..] {
                    accumulate(part, Walk::Listed(faces));
                }
                part.odd.truncate(odd);
                finish(part, &mut outputs);
            });
        }

        // Shares ascend, and so do the faces in them; slots need not.
        let odd: Vec<OddFace> = parts.iter().flat_map(|part| part.odd.iter().copied()).collect();
        let mut doubts = Doubts::default();
        parts.iter().for_each(|part| doubts.join(&part.doubts));
        let again = LookAgain::<S, W> { request, source, odd: &odd, weight: PhantomData };
        for (slot, vector, worth) in again.run(&doubts) {
            unit[slot as usize] = O::emit(vector);
            state[slot as usize] = worth;
        }
        *scratch = SumScratch { partition, parts };
        Outcome { odd, all_good: !doubts.not_all_good, vertex_missing: false }
    }
}
