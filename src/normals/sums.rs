//! Weighted sums of face normals over vertices or smooth groups.

use super::again::LookAgain;
use super::emit::Emit;
use super::finish::{Doubts, Finish, Output};
use super::part::{Accumulate, OddFace, Sum, Task};
use super::partition::{BLOCK_FACES, CHUNK, Numbering, Partition};
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
    parts: Vec<Part>,
}

/// Memory of one part.
#[derive(Default)]
struct Part {
    sums: Vec<Sum>,
    /// Where its slots begin, chunk by chunk.
    starts: Vec<u32>,
    doubts: Doubts,
    /// Faces not simply counted, in all blocks that the part walks.
    odd: Vec<OddFace>,
}

/// What is worth knowing beside the sums themselves.
pub(crate) struct Outcome {
    /// The faces that are not simply counted, ascending.
    pub(crate) odd: Vec<OddFace>,
    /// Whether it is certain that every slot is [`SlotState::Good`].
    pub(crate) all_good: bool,
}

/// Adds up Σ w n̂ for every slot, each sum in ascending face index whatever the number of threads.
///
/// Faces without direction add nothing, nor do slivers with [`Slivers::Exclude`], unless a slot has no other face. If
/// all weights of a slot vanish, its faces count the same. A slot with one face gets that face's normal to the bit.
pub(crate) fn weighted_sums(request: &SumRequest) -> Sums {
    let mut sums =
        Sums { unit: vec![DVec3::ZERO; request.slots], state: vec![SlotState::Empty; request.slots] };
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
        let SumScratch { partition, parts } = scratch;
        partition.fill(request.faces, request.target, request.slots);
        parts.resize_with(partition.parts(), Part::default);
        let partition = &*partition;
        // Every chunk's outputs go to the part that owns its slots.
        let mut outputs: Vec<_> = parts.iter().map(|_| Vec::new()).collect();
        if let [alone] = &mut outputs[..] {
            alone.push(Output { first: 0, unit, state });
        } else {
            for (chunk, (unit, state)) in unit.chunks_mut(CHUNK).zip(state.chunks_mut(CHUNK)).enumerate() {
                outputs[partition.owner(chunk)].push(Output { first: (chunk * CHUNK) as u32, unit, state });
            }
        }
        let work = |(number, (part, mut outputs)): (usize, (&mut Part, Vec<Output<O>>))| {
            let Part { sums, starts, doubts, odd } = part;
            sums.clear();
            sums.resize(partition.number(number, request.slots, starts), Sum::default());
            doubts.clear();
            odd.clear();
            let numbering =
                if partition.parts() == 1 { Numbering::Alone } else { Numbering::Chunked(starts) };
            let task = Task::<S, W> { request, source, partition, number, weight: PhantomData };
            num::dispatch(Accumulate { task, numbering, sums, odd });
            let areas = W::BY_AREA && W::EVEN;
            num::dispatch(Finish { sums, outputs: &mut outputs, doubts, areas });
            if !doubts.perhaps_one_face.is_empty() || !doubts.recount.is_empty() {
                for (slot, unit, state) in (LookAgain { task, doubts, odd }).run() {
                    write(&mut outputs, slot, unit, state);
                }
            }
        };
        if partition.parts() == 1 {
            parts.iter_mut().zip(outputs).enumerate().for_each(work);
        } else {
            parts.par_iter_mut().zip(outputs).enumerate().for_each(work);
        }
        // A block may be walked by several parts, but it is in the share of one; and shares ascend.
        let at_home = |(number, part): (usize, &'_ Part)| {
            let is_home = move |&&(face, _): &&OddFace| partition.home(face as usize / BLOCK_FACES) == number;
            part.odd.iter().filter(is_home).copied().collect::<Vec<_>>()
        };
        Outcome {
            odd: parts.iter().enumerate().flat_map(at_home).collect(),
            all_good: !parts.iter().any(|part| part.doubts.not_all_good),
        }
    }
}

/// Writes the result of a slot.
fn write<O: Emit>(outputs: &mut [Output<O>], slot: u32, unit: DVec3, state: SlotState) {
    let output = &mut outputs[outputs.partition_point(|output| output.first <= slot) - 1];
    let at = (slot - output.first) as usize;
    output.unit[at] = O::emit(unit);
    output.state[at] = state;
}
